"""Numbers of a film that do not depend on the method."""

from __future__ import annotations

from babbitt.numerics.scalar_or_array import functions_for


def minimum_film_thickness(eccentricity_ratio: float, relative_clearance: float, diameter: float) -> float:
    """``h_min = ψ D (1 - ε)/2`` of a round bore, in m."""
    return relative_clearance * diameter * (1.0 - eccentricity_ratio) / 2.0


def film_reynolds_number(
    density: float, surface_speed: float, relative_clearance: float, diameter: float, viscosity: float
) -> float:
    """``Re = ρ U c/η`` with the radial clearance ``c = ψ D/2``."""
    return density * surface_speed * relative_clearance * diameter / 2.0 / viscosity


def critical_reynolds_number(relative_clearance: float) -> float:
    """Reynolds number up to which the film is laminar: ``41.3 sqrt(D/C)`` (Taylor, as in ISO 7902).

    >>> round(critical_reynolds_number(1.4705e-3))
    1077
    """
    root: float = functions_for(relative_clearance).sqrt(relative_clearance)
    return 41.3 / root
