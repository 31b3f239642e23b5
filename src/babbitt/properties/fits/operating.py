"""What temperature makes of a clearance."""

from __future__ import annotations

REFERENCE_TEMPERATURE = 293.15
"""Temperature in K at which sizes and clearances are stated (ISO 1: 20 °C)."""


def operating_relative_clearance(
    relative_clearance: float,
    expansion_bearing: float,
    expansion_journal: float,
    temperature: float,
    journal_temperature: float | None = None,
) -> float:
    r"""Effective relative clearance when bearing and journal are warm.

    .. math:: \psi_{eff} = \psi + \alpha_B (T_B - 293.15\,\mathrm{K}) - \alpha_J (T_J - 293.15\,\mathrm{K})

    Bearing and journal expand freely. With one temperature for both this is the effective relative clearance of
    ISO 7902-1.

    Parameters
    ----------
    relative_clearance : float
        psi at 20 °C, dimensionless.
    expansion_bearing, expansion_journal : float
        Coefficients of linear thermal expansion in 1/K.
    temperature : float
        Of the bearing in K; in ISO 7902 the effective temperature.
    journal_temperature : float, optional
        Of the journal in K; that of the bearing if not given.

    Returns
    -------
    float
        Dimensionless; zero or negative when the clearance has closed.

    Examples
    --------
    >>> round(operating_relative_clearance(1.12e-3, 23e-6, 11e-6, 353.15), 8)
    0.00184
    """
    together = (expansion_bearing - expansion_journal) * (temperature - REFERENCE_TEMPERATURE)
    apart = 0.0 if journal_temperature is None else expansion_journal * (journal_temperature - temperature)
    return relative_clearance + together - apart
