"""Rules beside the standard: whirl screening, transition to mixed friction."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.kinds.journal.iso7902.characteristics import BearingCurves
from babbitt.numerics.scalar_or_array import functions_for, smaller


def orlov_relative_clearance(
    viscosity: float, hydrodynamic_speed: float, specific_load: float, width_ratio: float
) -> float:
    """Least relative clearance against whirl after Orlov.

    ``ψ_min = 3.5e-3 sqrt(λ B/D)`` with the regime number ``λ = 1e6 η ω/(2π p)``, the viscosity in Pa s, p in Pa.
    This reading of a damaged print reproduces the values of a published gearbox study (2023); it is equivalent
    to So >= 1.95 B/D.

    >>> round(1e3 * orlov_relative_clearance(0.0211, 360.0, 1.24e6, 0.604), 2)
    2.69
    """
    regime_number = 1e6 * viscosity * hydrodynamic_speed / (2.0 * math.pi * specific_load)
    root: float = functions_for(regime_number).sqrt(regime_number * width_ratio)
    return 3.5e-3 * root


@dataclass(frozen=True)
class Transition:
    """Where mixed friction begins: eccentricity, and hydrodynamic speed in rad/s at the temperature of the case.

    `beyond_tables` marks a film limit so small that the largest tabulated eccentricity stands in for it; the
    speed is then an upper bound.
    """

    eccentricity_ratio: float
    speed: float
    beyond_tables: bool


def transition(
    film_thickness: float,
    diameter: float,
    relative_clearance: float,
    viscosity: float,
    specific_load: float,
    curves: BearingCurves,
) -> Transition | None:
    """Speed at which the film thins to `film_thickness` (ISO 7902, transition to mixed friction).

    ``ε_tr = 1 - 2 h_tr/(ψ D)``, ``ω_tr = p ψ²/(η So(ε_tr))``, with viscosity and clearance of the operating point.

    Returns
    -------
    Transition or None
        None when the film limit exceeds the radial clearance: no speed gives such a film.
    """
    eccentricity = 1.0 - 2.0 * film_thickness / (relative_clearance * diameter)
    if eccentricity <= 0.0:
        return None
    reachable = smaller(eccentricity, curves.largest_eccentricity_ratio)
    load_number = curves.sommerfeld_number(reachable)
    speed = specific_load * relative_clearance**2 / (viscosity * load_number)
    return Transition(eccentricity, speed, eccentricity > reachable)
