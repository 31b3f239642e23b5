"""Sommerfeld's substitution, which turns integrals over the gap into elementary ones."""

from __future__ import annotations

from babbitt.numerics.scalar_or_array import Array, Value, functions_for


def sommerfeld_angle(angle: Value, eccentricity_ratio: float | Array) -> Value:
    """Sommerfeld angle gamma of a position phi in the gap, for 0 <= phi <= 2 pi.

    From cos gamma = (eps + cos phi)/(1 + eps cos phi) (Sommerfeld 1904), written with half angles so that no
    accuracy is lost near the narrowest gap. d phi/(1 + eps cos phi) = d gamma/sqrt(1 - eps^2).

    Parameters
    ----------
    angle : float or ndarray
        phi from the widest gap [rad].
    eccentricity_ratio : float or ndarray
        eps, 0 <= eps < 1; an array only where `angle` is one.

    Returns
    -------
    float or ndarray
        gamma [rad]; equal to phi at 0, pi and 2 pi.

    Examples
    --------
    >>> round(sommerfeld_angle(1.5707963267948966, 0.5), 6)  # cos gamma = eps
    1.047198
    """
    f = functions_for(angle)
    sine = f.sqrt(1.0 - eccentricity_ratio) * f.sin(0.5 * angle)
    cosine = f.sqrt(1.0 + eccentricity_ratio) * f.cos(0.5 * angle)
    gamma: Value = 2.0 * f.atan2(sine, cosine)
    return gamma
