"""Passes of Reynolds equation, energy equation and walls, until film, temperature and journal converge."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.damped_newton import damped_newton
from babbitt.reynolds.heat.following_clearance import FollowingClearance
from babbitt.reynolds.heat.heat_model import FilmHeat
from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
from babbitt.reynolds.lands._equilibrium import (
    CONTACT,
    CONVERGED,
    CYCLING,
    NO_FILM,
    THINNEST,
    TOO_MANY_STEPS,
)
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.mesh_lines import Density
from babbitt.reynolds.surface.surface_equilibrium import (
    Effort,
    PseudoTime,
    SurfaceState,
    line_density,
    position_under,
)
from babbitt.reynolds.surface.unwrapped_mesh import build_ring

__all__ = ["ThermalEquilibrium", "attempt", "cold_start", "continued", "fresh_ring", "find_thermal_equilibrium"]

Array = NDArray[np.float64]

SWEEPS = 3
"""Of the energy equation in a pass, before the walls answer; one more follows them."""
COARSE, COARSELY_SETTLED = 1e-2, 2.0
"""Residual force over load, and change of temperature in a pass (K), at which a coarse ring has done its part."""
SETTLED = 5e-2
"""Change of temperature in a pass, K, at which film and temperature have converged."""
CLOSER = 1e-3
"""Change of temperature in a pass, K, at which a film has converged that goes on from the last one or whose
clearance follows it: such films are compared with each other, and this close a pass more is cheap."""
SAME_CLEARANCE = 1e-6
"""Share by which a clearance that follows its film may still change in a pass when the film has converged."""
COLD_LOAD = 2.0
"""Dimensionless load up to which the journal starts where a film of fresh oil carries it: a centred one leaks
nothing and would have no bound to its temperature."""
COLDLY_CARRIED = 0.2
"""Residual force over load of this start: the first heat moves the journal by more."""
MOST_PASSES = 120
NEARER, IN_VAIN = 0.8, 40
"""Share of the least distance from equilibrium that counts as nearer, and passes in a row that bring the film no
nearer, after which it counts as not converging."""
MAX_STALLED_PASSES = 4
"""Passes at rest after which nodes that change sides for ever are let be."""
MAX_CONTACT_PASSES = 12
"""Passes in a row with a gap that counts as none, after which the film is given up."""
ACTIVE_SET_ROUNDS, ROUNDS = 8, 8
"""Pass from which on the active set is let settle at every position, and in how many rounds."""


@dataclass(frozen=True, eq=False)
class ThermalEquilibrium:
    """Where a search ended; ``mixed`` where only passes that remember each other made the film converge."""

    thermal: ThermalFilmState
    position: Array
    status: int
    passes: int
    gap: float
    load: Array | None = None
    mixed: bool = False


def attempt(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution, share: float,
    growth: FollowingClearance | None = None,
) -> ThermalEquilibrium:  # fmt: skip
    """Coarse rings under a growing load, then the fine ring, where the clearance may follow."""
    per_turn, total = 2 * resolution.intervals, 0
    thermal = fresh_ring(film, heat, scales, per_turn // 2, resolution, None)
    at = cold_start(thermal.sample, share * load)
    while True:
        found = find_thermal_equilibrium(thermal, share * load, at, COARSE, COARSELY_SETTLED)
        total += found.passes
        if found.status != CONVERGED:
            return replace(found, passes=total)
        at, density = found.position, line_density(film, found.position, found.gap)
        if share == 1.0:
            break
        share = min(1.0, 3.0 * share)
        thermal = continued(fresh_ring(film, heat, scales, per_turn // 2, resolution, density), thermal)
    thermal = continued(fresh_ring(film, heat, scales, per_turn, resolution, density), thermal)
    found = find_on_fine_ring(thermal, load, at, resolution, growth)
    return replace(found, passes=total + found.passes)


def cold_start(sample: SurfaceState, load: Array) -> Array:
    """Where a film of fresh oil carries the load, or a part of it that leaves the film thick."""
    part = min(1.0, COLD_LOAD / max(math.hypot(*load), 1e-300))
    at, _, _, gap = position_under(sample, part * load, np.zeros(2), COLDLY_CARRIED, 30, False)
    return at if gap > 0.0 else np.zeros(2)


def fresh_ring(
    film: JournalFilm, heat: FilmHeat, scales: Scales, per_turn: int, resolution: Resolution,
    density: Density | None,
) -> ThermalFilmState:  # fmt: skip
    """Ring at the supply temperature."""
    ring = build_ring(film, scales.pressure, per_turn, resolution.axial_unknowns, density)
    thermal = ThermalFilmState.of(SurfaceState.of(ring, Effort(math.inf)), heat, film, scales.rate)
    thermal.density = density
    return thermal


def continued(thermal: ThermalFilmState, before: ThermalFilmState) -> ThermalFilmState:
    """Take over active set and temperatures of a ring with the same columns."""
    thermal.sample.start_from(before.sample)
    thermal.start_from(before)
    return thermal


def find_on_fine_ring(
    thermal: ThermalFilmState, load: Array, at: Array, resolution: Resolution, growth: FollowingClearance | None
) -> ThermalEquilibrium:
    """`find_thermal_equilibrium`, closer where the clearance follows."""
    settled = SETTLED if growth is None else CLOSER
    return find_thermal_equilibrium(thermal, load, at, resolution.tolerance, settled, growth)


def find_thermal_equilibrium(
    thermal: ThermalFilmState,
    load: Array,
    at: Array,
    tolerance: float,
    settled: float,
    growth: FollowingClearance | None = None,
) -> ThermalEquilibrium:
    """Let film, temperature and journal converge on one ring, and the clearance that follows them, if one does."""
    if growth is not None:
        growth.begin()
    carrying = _Carrying(thermal, load, tolerance, settled, growth)
    found = damped_newton(carrying, at, MOST_PASSES, CONTACT)
    known = None if found.status == NO_FILM else carrying.load
    return ThermalEquilibrium(thermal, found.at, found.status, found.steps, found.room, known)


@dataclass(eq=False)
class _Carrying:
    """A film that heats itself and is to carry a load; see `babbitt.numerics.damped_newton.NewtonProblem`."""

    thermal: ThermalFilmState
    load: Array
    tolerance: float
    change_at_rest: float
    growth: FollowingClearance | None = None
    calm: int = 0
    sunk: int = 0
    nearest: float = math.inf
    reached: int = 0
    gap: float = math.inf
    no_room: ClassVar[int] = NO_FILM
    too_many_steps: ClassVar[int] = TOO_MANY_STEPS

    def __post_init__(self) -> None:
        self.size_of_load = math.hypot(*self.load)
        self.rule, self.residual = PseudoTime(self.size_of_load), self.load

    def room(self, at: Array) -> float:
        """Smallest gap; the place asked for last is the one that is looked at next."""
        self.gap = self.thermal.sample.gap(at)
        return self.gap

    def kept_room(self, at: Array, room: float) -> float:
        """A share of the gap."""
        return 0.4 * room

    def look(self, at: Array, step: int) -> int | None:
        """One pass, and the force that is left."""
        self.sunk = self.sunk + 1 if step > 1 and self.gap < THINNEST else 0
        if self.sunk > MAX_CONTACT_PASSES:
            return NO_FILM
        changed, change = self.thermal.advance(at, SWEEPS, 1 if 1 < step < ACTIVE_SET_ROUNDS else ROUNDS)
        if self.growth is not None and change < COARSELY_SETTLED:
            change = max(change, self._follow(self.growth))
        self.residual = self.thermal.sample.force + self.load
        size, floor = math.hypot(*self.residual), self.tolerance * self.size_of_load + 1e-13
        if not (math.isfinite(size) and math.isfinite(change)):
            return NO_FILM
        carried = size <= floor or (step > CYCLING and size <= 1e-4 * self.size_of_load)
        if change < self.change_at_rest and carried:
            self.calm += 1
            if changed == 0 or self.calm > MAX_STALLED_PASSES:
                return CONVERGED
        off = max(change / self.change_at_rest, size / floor)
        if off < NEARER * self.nearest:
            self.nearest, self.reached = off, step
        elif step - self.reached > IN_VAIN:
            return TOO_MANY_STEPS
        return None

    def _follow(self, growth: FollowingClearance) -> float:
        """Let the clearance follow; its change as one of temperature, K. The load goes with its square."""
        wider = growth.follow(self.thermal)
        self.load = self.load * wider**2
        self.size_of_load *= wider**2
        return abs(wider - 1.0) / SAME_CLEARANCE * self.change_at_rest

    def move(self, at: Array, room: float) -> Array:
        """Step of the journal at frozen temperatures."""
        return self.rule.move(self.thermal.sample, self.residual, room)
