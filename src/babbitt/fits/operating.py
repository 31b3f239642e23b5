"""What temperature makes of a clearance."""

from __future__ import annotations

REFERENCE_TEMPERATURE = 293.15
"""Temperature in K at which sizes and clearances are stated (ISO 1: 20 °C)."""


def operating_relative_clearance(
    relative_clearance: float, expansion_bearing: float, expansion_journal: float, temperature: float
) -> float:
    r"""Effective relative clearance when bearing and journal are warm.

    .. math:: \psi_{eff} = \psi + (\alpha_B - \alpha_J)(T - 293.15\,\mathrm{K})

    Bearing and journal have the same temperature and expand freely. ISO 7902-1, effective relative clearance.

    Parameters
    ----------
    relative_clearance : float
        psi at 20 °C, dimensionless.
    expansion_bearing, expansion_journal : float
        Coefficients of linear thermal expansion in 1/K.
    temperature : float
        Effective temperature in K.

    Returns
    -------
    float
        Dimensionless; zero or negative when the clearance has closed.

    Examples
    --------
    >>> round(operating_relative_clearance(1.12e-3, 23e-6, 11e-6, 353.15), 8)
    0.00184
    """
    return relative_clearance + (expansion_bearing - expansion_journal) * (temperature - REFERENCE_TEMPERATURE)
