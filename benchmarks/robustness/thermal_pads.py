"""Random tilting-pad bearings with their own temperatures, for the tests and `benchmarks/thermal_tilting_pads.py`.

Journals of 30 to 250 mm radius at 3 to 90 m/s, 0.1 to 4 MPa in any direction, machined clearance 1 to 3 permille
of the radius, 3 to 6 pads, pivots at 50 to 60 %, preload 0 to 0.6, L/D 0.3 to 1.2, pads 0.2 to 0.5 radii thick,
oils ISO VG 32 to 68 at 35 to 50 degC, carry-over 0.5 to 1; laminar at 60 degC.
"""

import math
from typing import NamedTuple

import numpy as np

from babbitt.reynolds.heat.heat_model import JournalHeat
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_heat import PadBending, PadGrowth, PadHeat, PadWalls

GRADES = {32: (0.0277, 0.0341), 46: (0.0392, 0.0360), 68: (0.0570, 0.0376)}
"""Viscosity at 40 degC, Pa s, and its fall per kelvin."""
DENSITY, HEAT_CAPACITY, CONDUCTIVITY, LAMINAR = 860.0, 1950.0, 0.14, 1000.0


class RandomPads(NamedTuple):
    """A bearing, its load in N, and its heat."""

    bearing: TiltingPadBearing
    load: tuple[float, float]
    heat: PadHeat


class Oil(NamedTuple):
    """Viscosity that falls exponentially."""

    at_40: float
    fall: float

    def __call__(self, temperature: np.ndarray) -> np.ndarray:
        return np.asarray(self.at_40 * np.exp(-self.fall * (np.asarray(temperature) - 313.15)))


def spread(rng: np.random.Generator, low: float, high: float) -> float:
    """A number whose logarithm is uniform."""
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def random_pads(rng: np.random.Generator, model: str) -> RandomPads:
    """A bearing of model A (all walls insulated), B (journal of one temperature) or E (conducting pads that bend,
    and all grow)."""
    while True:
        oil = Oil(*GRADES[int(rng.choice(list(GRADES)))])
        radius, speed = spread(rng, 0.03, 0.25), spread(rng, 3.0, 90.0)
        clearance, supply = radius * rng.uniform(1e-3, 3e-3), rng.uniform(308.15, 323.15)
        if DENSITY * speed * clearance / oil(np.array(333.15)) < LAMINAR:
            break
    count = int(rng.integers(3, 7))
    fraction = float(rng.choice([0.5, rng.uniform(0.5, 0.6)]))
    preload, width = rng.uniform(0.0, 0.6), 2.0 * radius * rng.uniform(0.3, 1.2)
    extent = min(rng.uniform(0.6, 0.92) * 2.0 * math.pi / count, math.radians(100.0))
    first, direction = rng.uniform(0.0, 2.0 * math.pi, 2)
    thickness = radius * rng.uniform(0.2, 0.5)
    load = spread(rng, 0.1e6, 4e6) * 2.0 * radius * width
    pads = tuple(
        TiltingPad(
            first + 2.0 * math.pi * k / count, extent, clearance, clearance * (1.0 - preload), thickness, fraction
        )
        for k in range(count)
    )
    bearing = TiltingPadBearing(2.0 * radius, width, float(oil(np.array(supply))), speed / radius, pads)
    heat = PadHeat(
        oil, DENSITY * HEAT_CAPACITY, CONDUCTIVITY, supply,
        journal=None if model == "A" else JournalHeat(),
        walls=PadWalls() if model == "E" else None,
        bending=PadBending() if model == "E" else None,
        growth=PadGrowth(supply) if model == "E" else None,
        carry_over=rng.uniform(0.5, 1.0),
    )  # fmt: skip
    return RandomPads(bearing, (load * math.cos(direction), load * math.sin(direction)), heat)
