"""Between which Reynolds numbers turbulence sets in."""

from __future__ import annotations

from babbitt.design.numbers import critical_reynolds_number
from babbitt.reynolds.oil.turbulence import FilmTurbulence, TurbulenceLaw

__all__ = ["ALL_TURBULENT", "film_turbulence"]

ALL_TURBULENT = 2.0
"""Local Reynolds number, in those at which vortices set in, from which the film is fully turbulent.

Assumption: for the common clearances it puts full turbulence at about 2000, as usual for films."""


def film_turbulence(law: TurbulenceLaw, relative_clearance: float, density: float) -> FilmTurbulence:
    """Turbulence of the film of a journal by a law, the density of the oil in kg/m3."""
    onset = critical_reynolds_number(relative_clearance)
    return FilmTurbulence(law, density, onset, ALL_TURBULENT * onset)
