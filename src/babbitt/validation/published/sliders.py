"""What the two one-dimensional sliders share: a flat film as a bearing of one land without side flow."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from babbitt.reynolds.model import Cavitation, JournalFilm, Land, Resolution
from babbitt.validation.published.film_bearings import Array

Gap = Callable[[Array], Array]


@dataclass(frozen=True)
class Slider:
    """Film under a gap h(x) between two flooded ends, cavitation at zero absolute pressure; SI."""

    length: float
    smallest_gap: float
    speed: float
    viscosity: float
    ambient: float
    gap: Gap


@dataclass(frozen=True, eq=False)
class SliderFilm:
    """Pressure (absolute, Pa), liquid fraction over x (m), flux per width (m²/s)."""

    x: Array
    pressure: Array
    liquid: Array
    gap: Array
    flux: float

    @property
    def ruptured(self) -> tuple[float, float]:
        """First and last place without pressure."""
        dry = self.x[self.liquid < 1.0]
        return float(dry[0]), float(dry[-1])

    def load(self, ambient: float) -> float:
        """Force above ambient per width, N/m."""
        return float(np.trapezoid(self.pressure - ambient, self.x))


@lru_cache(maxsize=32)
def solve_slider(slider: Slider, intervals: int) -> SliderFilm:
    """Solve it by the engine as a land of 1 rad, ten thousand times as wide as long.

    The flux is taken from the ruptured film, q = U h θ/2.
    """
    from babbitt.reynolds.equilibrium.position import film_at_position

    places = np.linspace(0.0, 1.0, 4001)
    profile = tuple((slider.gap(places * slider.length) - slider.smallest_gap).tolist())
    land = Land(0.0, 1.0, start_pressure=slider.ambient, end_pressure=slider.ambient, profile=profile)
    bearing = JournalFilm(
        2.0 * slider.length,
        1e4 * slider.length,
        slider.smallest_gap,
        slider.viscosity,
        slider.speed / slider.length,
        (land,),
        Cavitation.MASS_CONSERVING,
    )
    found = film_at_position(bearing, (0.0, 0.0), resolution=Resolution(8, intervals, 48, 1e-9))
    if not found.outcome.solved:
        raise ArithmeticError(f"the film of the slider ended with {found.outcome.name}")
    on_land = found.angles[0] < 1.0 + 1e-9
    x, liquid = found.angles[0, on_land] * slider.length, 1.0 - found.void[0, on_land, 0]
    gap = slider.gap(x)
    dry = np.flatnonzero(liquid < 1.0)
    middle = dry[dry.size // 2]
    return SliderFilm(
        x, found.pressure[0, on_land, 0], liquid, gap, float(0.5 * slider.speed * gap[middle] * liquid[middle])
    )
