"""What the heat of a film needs to know: oil, walls, and how finely its temperature is resolved."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.model import Resolution

__all__ = [
    "THERMAL_DRAFT",
    "THERMAL_ENGINEERING",
    "THERMAL_REFERENCE",
    "BushRing",
    "ConductingWalls",
    "FilmHeat",
    "HeatGrid",
    "JournalHeat",
    "mean_over_layers",
]

Array = NDArray[np.float64]

THERMAL_DRAFT = Resolution(4, 32, 16, 1e-3)
THERMAL_ENGINEERING = Resolution(4, 48, 24, 1e-3)
THERMAL_REFERENCE = Resolution(6, 192, 96, 1e-7)
"""Grids of films with their own temperatures: the first two within about 1 % of the film thickness and 1 K (1.1 %
and 0.6 K, 0.5 % and 0.5 K for two lands under a sixth to four times a usual load at 0.3 to 3 times the speed), the
last within a tenth of that."""


@dataclass(frozen=True)
class JournalHeat:
    """One temperature for the journal: prescribed, or from the balance of the film with the shaft.

    Attributes
    ----------
    temperature : float or None
        K; None: found.
    shaft_conductance : float
        From the journal along the shaft to its surroundings, W/K.
    ambient_temperature : float
        Of these surroundings, K.
    """

    temperature: float | None = None
    shaft_conductance: float = 0.0
    ambient_temperature: float = 293.15


@dataclass(frozen=True)
class BushRing:
    """Bush and housing as concentric rings that conduct heat in r and theta.

    Attributes
    ----------
    radii : tuple of float
        From the bore outwards, m: one more than there are rings (liner, backing, housing).
    conductivities : tuple of float
        Of the rings, W/(m K).
    heat_transfer_coefficient : float
        On the outside, W/(m2 K); zero: insulated.
    ambient_temperature : float
        K.
    """

    radii: tuple[float, ...]
    conductivities: tuple[float, ...]
    heat_transfer_coefficient: float
    ambient_temperature: float

    def __post_init__(self) -> None:
        if len(self.radii) != len(self.conductivities) + 1 or not self.conductivities:
            raise InputError("E101", "a bush needs one radius more than conductivities, from the bore outwards.")
        if not all(a < b for a, b in zip(self.radii, self.radii[1:], strict=False)):
            raise InputError("E101", f"radii of the bush are {self.radii} m; they must rise outwards.")
        if min(self.conductivities) <= 0.0 or self.heat_transfer_coefficient < 0.0:
            raise InputError("E101", "conductivities of the bush must be positive, the heat transfer coefficient "
                             "outside zero or more.")  # fmt: skip

    def impedances(self, harmonics: int) -> Array:
        """Bore temperature over heat flux into the bore for cos(m theta), m = 0 .. harmonics, K m2/W.

        From the outside in: with the ratio z = T / q at the outer radius b of a ring of conductivity k, at its
        inner radius a

            m = 0:  z_a = a (z_b / b + ln(b/a) / k)
            m > 0:  z_a = (a/(k m)) (t + v) / (1 + t v),  t = tanh(m ln(b/a)),  v = z_b k m / b

        (q taken outwards, T = A r^m + B r^-m). Infinite for m = 0 with an insulated outside.
        """
        return _impedances(self, harmonics)

    def behind(self, ring: int, harmonics: int) -> tuple[Array, Array]:
        """Temperature at the inner radius of a ring over that of the bore, and over the flux into it (K m2/W).

        For cos(m theta), m = 0 .. harmonics, above ambient. Through each ring further in, from its radius a to b,

            T_b / T_a = 1 / (cosh s + sinh s / v),   s = m ln(b/a),  v = z_b k m / b

        with the impedance z_b of all that follows; m = 0: T_b / T_a = z_b / (z_b + b ln(b/a) / k).

        Parameters
        ----------
        ring : int
            From 0, at the bore.
        harmonics : int

        Returns
        -------
        shares, impedances : ndarray, shape (harmonics + 1,)
        """
        order, shares = np.arange(harmonics + 1, dtype=float), np.ones(harmonics + 1)
        impedance = self._from(ring).impedances(harmonics)
        for inner in reversed(range(ring)):
            (a, b), k = self.radii[inner : inner + 2], self.conductivities[inner]
            stretch = math.log(b / a)
            beyond = self._from(inner + 1).impedances(harmonics)
            step, over = order[1:] * stretch, b / (k * order[1:] * beyond[1:])
            decay = np.exp(-2.0 * step)  # cosh and sinh of a thick ring would overflow
            shares[1:] *= 2.0 * np.exp(-step) / ((1.0 + decay) + (1.0 - decay) * over)
            shares[0] /= 1.0 + b * stretch / (k * beyond[0])
        return shares, impedance

    def _from(self, ring: int) -> BushRing:
        """The rings from one on."""
        if ring == 0:
            return self
        return replace(self, radii=self.radii[ring:], conductivities=self.conductivities[ring:])


@lru_cache(maxsize=64)
def _impedances(bush: BushRing, harmonics: int) -> Array:
    order = np.arange(harmonics + 1, dtype=float)
    with np.errstate(divide="ignore"):
        outside = np.full(order.size, np.divide(1.0, bush.heat_transfer_coefficient))
    rings = list(zip(bush.radii[:-1], bush.radii[1:], bush.conductivities, strict=True))
    for inner, outer, conductivity in reversed(rings):
        stretch, m = math.log(outer / inner), order[1:]
        mean = inner * (outside[0] / outer + stretch / conductivity)
        t, v = np.tanh(m * stretch), outside[1:] * conductivity * m / outer
        with np.errstate(invalid="ignore"):
            share = np.where(np.isinf(v), 1.0 / t, (t + v) / (1.0 + t * v))
        outside = np.concatenate(([mean], inner / (conductivity * m) * share))
    outside.flags.writeable = False
    return outside


@dataclass(frozen=True)
class ConductingWalls:
    """Bush and journal that take heat from the film."""

    bush: BushRing
    journal: JournalHeat = JournalHeat()


@dataclass(frozen=True)
class HeatGrid:
    """Layers across the gap, and whether every node of the width has its own temperature.

    Attributes
    ----------
    layers : int
        Across the gap.
    resolved : bool
        False: one profile per line, mean over the width. Pockets and holes are always resolved.
    """

    layers: int = 8
    resolved: bool = False

    def thicknesses(self) -> Array:
        """Layers, thinner towards the walls (between even ones and those of a half cosine), shape (layers,)."""
        return _thicknesses(self.layers).copy()


@lru_cache(maxsize=16)
def _thicknesses(layers: int) -> Array:
    even = np.linspace(0.0, 1.0, layers + 1)
    return np.diff(0.5 * (0.5 * (1.0 - np.cos(np.pi * even)) + even))


def mean_over_layers(temperature: Array, layers: Array) -> Array:
    """Mean over the gap of temperatures (..., layers) in the middle of layers, from 0 to 1 between the walls."""
    edges = [0.0]
    for middle in layers:
        edges.append(2.0 * float(middle) - edges[-1])
    return np.asarray(temperature @ np.diff(edges))


@dataclass(frozen=True)
class FilmHeat:
    """Heat model of a film.

    Attributes
    ----------
    viscosity : callable
        Pa s at temperatures in K, shape kept.
    volumetric_heat_capacity : float
        rho c of the oil, J/(m3 K).
    conductivity : float
        Of the oil, W/(m K).
    supply_temperature : float
        Of fresh oil, K.
    walls : ConductingWalls or None
        None: no heat leaves through bush and journal.
    grid : HeatGrid
    carry_over : float
        Share, 0 to 1, of the hot oil that the film brings to a groove or pocket and that goes on with the next
        film; the rest is replaced by fresh oil. 1: all of it, as far as the next film takes oil.
    """

    viscosity: Callable[[Array], Array]
    volumetric_heat_capacity: float
    conductivity: float
    supply_temperature: float
    walls: ConductingWalls | None = None
    grid: HeatGrid = HeatGrid()
    carry_over: float = 1.0

    def __post_init__(self) -> None:
        for name in ("volumetric_heat_capacity", "conductivity", "supply_temperature"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units, K).")
        if not 0.0 <= self.carry_over <= 1.0:
            raise InputError("E101", f"carry_over is {self.carry_over}; it is a share, from 0 to 1.")
