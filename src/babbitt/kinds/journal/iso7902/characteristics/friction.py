r"""Friction numbers f/psi of a journal bearing, three models of how far the sheared film reaches.

The journal carries the film's shear and the tangential part of its pressure: with the film between phi_1 and
phi_2

.. math:: f/\psi = \frac{I(\phi_1, \phi_2)}{2\,So} + \frac{\varepsilon}{2} \sin\beta, \qquad
          I = \int_{\phi_1}^{\phi_2} \frac{d\phi}{1 + \varepsilon \cos\phi}

(ISO 7902-1, DIN 31652-1 for the film all around). All functions take numbers or arrays of equal shape and are
for So > 0: as the load vanishes the friction number grows beyond bounds while the friction force stays
finite.
"""

from __future__ import annotations

import math

from babbitt.kinds.journal.iso7902.characteristics.curves import BearingCurves
from babbitt.kinds.journal.iso7902.characteristics.sommerfeld_angle import sommerfeld_angle
from babbitt.numerics.scalar_or_array import Value, clipped, functions_for

FULL = 2.0 * math.pi


def film_around(sommerfeld_number: Value, eccentricity_ratio: Value, attitude_angle: Value) -> Value:
    """Friction number with oil sheared all around the journal, whatever the loaded span.

    f/psi = pi/(So sqrt(1 - eps^2)) + (eps/2) sin beta.

    Parameters
    ----------
    sommerfeld_number, eccentricity_ratio, attitude_angle : float or ndarray
        So > 0, eps < 1 and beta [rad] of the span that carries the load.

    Returns
    -------
    float or ndarray
        f/psi.

    Examples
    --------
    >>> round(film_around(0.8910, 0.5, math.radians(56.70)), 2)
    4.28
    """
    number: Value = of_shear(FULL, sommerfeld_number, eccentricity_ratio)
    return number + of_pressure(eccentricity_ratio, attitude_angle)


def film_on_arc(sommerfeld_number: Value, eccentricity_ratio: Value, attitude_angle: Value, span: float) -> Value:
    """Friction number with oil sheared on the loaded arc alone, the rest of the bore cut away.

    The whole arc counts, also where the film has ruptured.

    Parameters
    ----------
    sommerfeld_number, eccentricity_ratio, attitude_angle : float or ndarray
        So > 0, eps < 1 and beta [rad].
    span : float
        Angle of the arc [rad]; 2 pi gives `film_around`.

    Returns
    -------
    float or ndarray
        f/psi.
    """
    number: Value = of_shear(
        sheared_angle(eccentricity_ratio, attitude_angle, span), sommerfeld_number, eccentricity_ratio
    )
    return number + of_pressure(eccentricity_ratio, attitude_angle)


def of_full_bearing(eccentricity_ratio: Value, curves: BearingCurves) -> Value:
    """Friction number of the 360-degree bearing at an eccentricity that another span has reached.

    Together with a friction factor of about 1.26 this is what reproduces the friction power of the published
    study of gearbox bearings with spans of 360 to 90 degrees (2023); there the span acts on load and flow and
    not on friction.

    Parameters
    ----------
    eccentricity_ratio : float or ndarray
        0 < eps.
    curves : BearingCurves
        Characteristics of the full bearing of the same B/D.

    Returns
    -------
    float or ndarray
        f/psi.

    Raises
    ------
    ValueError
        If the curves are not those of a full bearing.
    """
    if curves.span_degrees != 360:
        raise ValueError(f"curves of the full bearing are needed, not of a span of {curves.span_degrees} deg")
    return film_around(
        curves.sommerfeld_number(eccentricity_ratio),
        eccentricity_ratio,
        curves.attitude_angle(eccentricity_ratio),
    )


def sheared_angle(eccentricity_ratio: Value, attitude_angle: Value, span: float) -> Value | float:
    """Sommerfeld angle over which a film on an arc of a span reaches, all in rad."""
    if span >= FULL:
        return FULL
    centre = math.pi - attitude_angle
    start = clipped(centre - 0.5 * span, 0.0, FULL)
    end = clipped(centre + 0.5 * span, 0.0, FULL)
    return sommerfeld_angle(end, eccentricity_ratio) - sommerfeld_angle(start, eccentricity_ratio)


def of_shear(sheared: Value | float, sommerfeld_number: Value, eccentricity_ratio: Value) -> Value:
    """Part of the friction number of a film that reaches over the Sommerfeld angle `sheared` [rad]."""
    root = functions_for(eccentricity_ratio).sqrt(1.0 - eccentricity_ratio * eccentricity_ratio)
    number: Value = sheared / (2.0 * sommerfeld_number * root)
    return number


def of_pressure(eccentricity_ratio: Value, attitude_angle: Value) -> Value:
    """Part of the friction number that the pressure on the journal makes, (eps/2) sin beta [rad]."""
    number: Value = 0.5 * eccentricity_ratio * functions_for(eccentricity_ratio).sin(attitude_angle)
    return number
