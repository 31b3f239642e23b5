"""Equilibrium of films that differ across the width: pockets, holes, tilt, viscosity, closed rings.

Their nodes and gaps are those of ``unwrapped_mesh``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.damped_newton import damped_newton
from babbitt.reynolds.lands._equilibrium import (
    CONTACT,
    CONVERGED,
    CYCLING,
    MODERATE_LOAD,
    NO_FILM,
    PATIENCE,
    PATIENT_STEPS,
    THINNEST,
    TOO_MANY_STEPS,
    damped_step,
)
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.surface._surface_film import (
    SurfaceFilm,
    SurfaceWork,
    new_surface_film,
    new_surface_work,
    smallest_surface_gap,
)
from babbitt.reynolds.surface._surface_forces import evaluate_surface
from babbitt.reynolds.surface.mesh_lines import Density
from babbitt.reynolds.surface.unwrapped_mesh import (
    UnwrappedMesh,
    axial_gain,
    build_ring,
    gap_over_lands,
    ring_shape,
)

__all__ = [
    "OUT_OF_WORK",
    "PseudoTime",
    "SurfaceEquilibrium",
    "coarse_ring",
    "find_surface_equilibrium",
    "find_surface_equilibrium_near",
    "ring_at",
    "ring_from",
]

Array = NDArray[np.float64]
ZERO = np.zeros(4)
"""Rest in as many motions as any surface has."""


OUT_OF_WORK = 3
"""Status of a search that has used up its bound on work (beside those of ``_equilibrium``)."""

FLICKERING = 4
"""Status of a search whose film, by nodes that change sides for ever, misses its load by more than `CALM`."""

SMALLEST_BOUND, FINE_SOLUTIONS = 2.0e8, 400
"""Bound on the work of a search: multiplications that every grid may spend, or so many solutions on the finest
ring, whichever is more. An assumption: ordinary films take fewer than a hundred solutions."""


def work_of(lines: int, nodes: int) -> float:
    """Multiplications of one solution: elimination of the lines and assembly of their blocks."""
    return float(lines * nodes**2 * (nodes + 10))


@dataclass
class Effort:
    """What a search may still spend, in multiplications: a bound that is the same on every machine.

    It grows with the grid ``asked`` for, which is looked at where the smallest bound does not do.
    """

    left: float
    asked: tuple[JournalFilm, Resolution] | None = None

    @classmethod
    def for_ring(cls, film: JournalFilm, resolution: Resolution) -> Effort:
        """Bound for the grid of a film."""
        return cls(SMALLEST_BOUND, (film, resolution))

    @property
    def spent(self) -> bool:
        """Whether nothing is left."""
        if self.left < 0.0 and self.asked is not None:
            (film, grid), self.asked = self.asked, None
            bound = FINE_SOLUTIONS * work_of(*ring_shape(film, grid.ring_intervals, grid.axial_unknowns))
            self.left += max(bound - SMALLEST_BOUND, 0.0)
        return self.left < 0.0


@dataclass(eq=False)
class SurfaceState:
    """A ring with its workspace and the last result."""

    ring: UnwrappedMesh
    film: SurfaceFilm
    work: SurfaceWork
    force: Array
    stiffness: Array
    damping: Array
    effort: Effort

    @classmethod
    def of(cls, ring: UnwrappedMesh, effort: Effort) -> SurfaceState:
        """Workspace with all nodes wet."""
        motions = ring.surface.lever.shape[0]
        square = np.zeros((motions, motions))
        return cls(
            ring,
            new_surface_film(ring.surface),
            new_surface_work(ring.surface),
            np.zeros(motions),
            square,
            square.copy(),
            effort,
        )

    def evaluate(self, at: Array, rate: Array = ZERO, smooth: bool = False) -> int:
        """Force, stiffness and damping at a position; number of nodes that changed sides."""
        lines, nodes = self.work.wet.shape
        self.effort.left -= work_of(lines, nodes)
        return int(
            evaluate_surface(
                self.ring.surface, self.film, self.work, at, rate, smooth, self.force, self.stiffness, self.damping
            )
        )

    def gap(self, at: Array) -> float:
        """Smallest gap."""
        return float(smallest_surface_gap(self.ring.surface, at))

    def start_from(self, coarse: SurfaceState) -> None:
        """Take over the active set of a sample on the same axial mesh; on others: full if a line beside it is."""
        lines = self.work.wet.shape[0]
        old = coarse.ring.theta
        if np.array_equal(old, self.ring.theta):
            self.work.wet[:] = coarse.work.wet
            return
        rows = coarse.work.wet.shape[0]
        behind = np.clip(np.searchsorted(old, self.ring.theta[:lines] - 1e-12), 1, old.size - 1)
        self.work.wet[:] = coarse.work.wet[(behind - 1) % rows] | coarse.work.wet[behind % rows]


@dataclass(frozen=True, eq=False)
class SurfaceEquilibrium:
    """What an equilibrium search on rings returns."""

    film: JournalFilm
    sample: SurfaceState
    position: Array
    status: int
    steps: int
    gap: float


def line_density(film: JournalFilm, at: Array, gap: float) -> Density:
    """Density of lines h^-a around the film, h the least over the width and a rising with depth."""
    sides = np.array([-0.5, 0.0, 0.5]) * film.width
    exponent = -0.8 * min(max(1.0 - gap, 0.0), 1.0) ** 4
    lowest = max(gap, 1e-6)

    def density(angle: Array) -> Array:
        thickness = gap_over_lands(film, angle) - at[0] * np.cos(angle) - at[1] * np.sin(angle)
        if not film.is_straight:
            thickness += axial_gain(film, angle, sides).min(axis=1) / film.clearance
        return np.asarray(np.maximum(thickness, lowest) ** exponent)

    return density


def position_under(
    sample: SurfaceState, load: Array, at: Array, tolerance: float, max_steps: int, patient: bool
) -> tuple[Array, int, int, float]:
    """Move the journal until the film on this ring carries the load.

    The steps are those of ``_equilibrium.settle``, which has its own loop: a kernel takes no objects.
    """
    found = damped_newton(_Carrying(sample, load, tolerance, patient), at, max_steps, CONTACT)
    return found.at, found.status, found.steps, found.room


def carried(
    sample: SurfaceState, load: Array, at: Array, tolerance: float, max_steps: int, patient: bool
) -> tuple[Array, int, int, float]:
    """As `position_under`, with smooth coefficients and the load held against the film in its final state."""
    at, status, steps, gap = position_under(sample, load, at, tolerance, max_steps, patient)
    if status == CONVERGED:
        sample.evaluate(at, smooth=True)
        if math.hypot(*(sample.force + load)) > CALM * math.hypot(*load) + LEAST_FORCE:
            status = FLICKERING
    return at, status, steps, gap


@dataclass(eq=False)
class PseudoTime:
    """Steps of an overdamped journal (``_equilibrium.damped_step``) under a load of a size."""

    load: float
    step_time: float = 0.0
    last_size: float = 0.0

    def move(self, sample: SurfaceState, residual: Array, gap: float) -> Array:
        """Step under a residual force, with the coefficients of the last result."""
        flat = np.concatenate((sample.force, sample.stiffness.ravel(), sample.damping.ravel()))
        size = math.hypot(*residual)
        dx, dy, self.step_time = damped_step(
            flat, residual[0], residual[1], size, self.last_size, self.load, gap, self.step_time
        )
        self.last_size = size
        return np.array([dx, dy])


@dataclass(eq=False)
class _Carrying:
    """A film that is to carry a load; see `babbitt.numerics.damped_newton.NewtonProblem`."""

    sample: SurfaceState
    load: Array
    tolerance: float
    patient: bool
    calm: int = 0
    no_room: ClassVar[int] = NO_FILM
    too_many_steps: ClassVar[int] = TOO_MANY_STEPS

    def __post_init__(self) -> None:
        self.size_of_load = math.hypot(*self.load)
        self.rule, self.residual = PseudoTime(self.size_of_load), self.load

    def room(self, at: Array) -> float:
        """Smallest gap."""
        return self.sample.gap(at)

    def kept_room(self, at: Array, room: float) -> float:
        """A share of the gap."""
        return (0.6 if self.patient else 0.25) * room

    def look(self, at: Array, step: int) -> int | None:
        """Rounds of the active set, and the force that is left."""
        sample = self.sample
        if self.patient:
            sample.work.wet[:] = True
        waits = sample.work.wet.shape[0] if self.calm > 0 and not sample.ring.surface.conserving else 1
        for _ in range(PATIENCE if self.patient else waits):
            changed = sample.evaluate(at)
            if changed == 0 or sample.effort.spent:
                break
        self.residual = sample.force + self.load
        size = math.hypot(*self.residual)
        if not math.isfinite(size):  # a closed ring that ran dry says nothing about its load
            return TOO_MANY_STEPS
        if sample.effort.spent:
            return OUT_OF_WORK
        floor = self.tolerance * self.size_of_load + LEAST_FORCE
        if size <= floor or (step > CYCLING and size <= CALM * self.size_of_load):
            self.calm += 1
            if changed == 0 or self.calm > 4:
                return CONVERGED
        return None

    def move(self, at: Array, room: float) -> Array:
        """Step of the journal."""
        return self.rule.move(self.sample, self.residual, room)


def find_surface_equilibrium(
    film: JournalFilm, unit: float, load: Array, resolution: Resolution, max_steps: int
) -> SurfaceEquilibrium:
    """Equilibrium under a dimensionless load: a fast and a patient attempt, then both from a finer ring."""
    effort = Effort.for_ring(film, resolution)
    for refinement, patient in ((4, False), (4, True), (2, False), (2, True)):
        settled = attempt(film, unit, load, resolution, max_steps, effort, refinement, patient)
        if settled.status == CONVERGED or effort.spent:
            break
    return thick_enough(settled)


def thick_enough(settled: SurfaceEquilibrium) -> SurfaceEquilibrium:
    """The same, but as overloaded where what is left of the film counts as none."""
    thin = settled.gap < THINNEST and settled.status != OUT_OF_WORK
    return replace(settled, status=NO_FILM) if thin else settled


def find_surface_equilibrium_near(
    film: JournalFilm, unit: float, load: Array, resolution: Resolution, max_steps: int, at: Array
) -> SurfaceEquilibrium:
    """Equilibrium under a dimensionless load from a position close to it, on lines drawn for that position."""
    near = ring_at(film, unit, at, ZERO[:2], resolution)
    if near.status != CONVERGED:
        return near
    effort = Effort.for_ring(film, resolution)
    sample = replace(near.sample, effort=effort)
    at, status, steps, gap = carried(sample, load, at, resolution.tolerance, max_steps, False)
    return thick_enough(SurfaceEquilibrium(film, sample, at, status, near.steps + steps, gap))


def attempt(
    film: JournalFilm,
    unit: float,
    load: Array,
    resolution: Resolution,
    max_steps: int,
    effort: Effort,
    refinement: int,
    patient: bool,
) -> SurfaceEquilibrium:
    """Coarse rings first, heavier loads step by step, then the fine ring, with ``refinement`` times the lines.

    On a ring on which nodes flicker no state of theirs may satisfy all rows: `FINER` rings decide then.
    """
    per_turn = resolution.ring_intervals
    size = math.hypot(*load)
    share = min(1.0, MODERATE_LOAD / max(size, 1e-300))
    at, density, total, last_gap = beginning(film, load), None, 0, math.inf
    coarse: SurfaceState | None = None
    steps_per_grid = PATIENT_STEPS if patient else max_steps
    for _ in range(60):
        sample = SurfaceState.of(
            build_ring(film, unit, per_turn // refinement, resolution.axial_unknowns, density), effort
        )
        if coarse is not None:
            sample.start_from(coarse)
        coarse = sample
        at, status, steps, gap = position_under(sample, share * load, at, 1e-2, steps_per_grid, patient)
        total += steps
        settled = status == CONVERGED
        if max(gap, last_gap) < THINNEST and not effort.spent:  # no way back from there is known
            status = NO_FILM
        if status == NO_FILM or effort.spent or not (settled or patient):
            return SurfaceEquilibrium(film, sample, at, status, total, gap)
        density = line_density(film, at, gap)
        if settled and share == 1.0 and (gap > 0.2 or abs(gap - last_gap) < 0.1 * gap):
            break
        last_gap = gap
        if settled:
            share = min(1.0, 4.0 * share)
    for finer in FINER:
        ring = build_ring(film, unit, finer * per_turn, resolution.axial_unknowns, density)
        fine = SurfaceState.of(ring, effort)
        fine.start_from(sample)
        at, status, steps, gap = carried(fine, load, at, resolution.tolerance, max_steps, patient and finer == 1)
        sample, total = fine, total + steps
        if status != FLICKERING and not (finer > 1 and status == TOO_MANY_STEPS):
            break
    return SurfaceEquilibrium(film, fine, at, status, total, gap)


STARVED_START = 0.5
"""Clearances from the middle, towards the load, at which the search for a starved film begins."""


def beginning(film: JournalFilm, load: Array) -> Array:
    """Where the search begins: in the middle, but for starved films.

    Around a centred journal no gap narrows: a film that is not full stays so, and how much oil circles beside the
    supplies is then undetermined.
    """
    size = math.hypot(*load)
    if size == 0.0 or not film.is_starved:
        return np.zeros(2)
    return np.asarray(STARVED_START / size * load)


APPROACH = (0.6, 0.8, 0.9, 0.96, 0.99, 1.0)
"""Shares of a position over which the journal goes there where the active set does not converge at once."""
WET_ROUNDS = 60
"""Rounds of the active set at one place."""
CALM = 1e-4
"""Change of the force over the last half of the rounds, relative, up to which nodes that change sides for ever are
let be: what an equilibrium with such nodes may miss of its load (`position_under`)."""
LEAST_FORCE = 1e-13
"""Force that is round-off, in the units of the kernels."""
FINER = (1, 2, 4)
"""Times the lines of a grid that a ring has: the next where the nodes of one do not settle."""


def coarse_ring(film: JournalFilm, unit: float, resolution: Resolution, motions: int = 2) -> UnwrappedMesh:
    """The ring on which the film of any position begins, its lines spread evenly."""
    return build_ring(film, unit, resolution.ring_intervals // 4, resolution.axial_unknowns, None, motions)


def ring_at(film: JournalFilm, unit: float, at: Array, rate: Array, resolution: Resolution) -> SurfaceEquilibrium:
    """Film at a position and velocity, (2,), or with the tilts of ``build_ring``, (4,)."""
    return ring_from(coarse_ring(film, unit, resolution, at.size), film, unit, at, rate, resolution)


def ring_from(
    first: UnwrappedMesh, film: JournalFilm, unit: float, at: Array, rate: Array, resolution: Resolution
) -> SurfaceEquilibrium:
    """As `ring_at`, from a ring of `coarse_ring`, which stays as it is."""
    total, coarse, density, effort = 0, None, None, Effort(math.inf)
    for finer in (0, *FINER):
        ring = first
        if finer:
            per_turn = finer * resolution.ring_intervals
            ring = build_ring(film, unit, per_turn, resolution.axial_unknowns, density, motions=at.size)
        sample = SurfaceState.of(ring, effort)
        gap = sample.gap(at)
        if not gap > 0.0:
            return SurfaceEquilibrium(film, sample, at, NO_FILM, total, gap)
        if coarse is not None:
            sample.start_from(coarse)
        density = line_density(film, at, gap)
        settled, rounds = _wet_set(sample, at, rate)
        total += rounds
        if not settled and finer < 2:
            sample.work.wet[:] = True
            for share in APPROACH:
                settled, rounds = _wet_set(sample, share * at, rate)
                total += rounds
        coarse = sample
        if settled and finer:
            break
    if not settled:
        return SurfaceEquilibrium(film, sample, at, TOO_MANY_STEPS, total, gap)
    sample.evaluate(at, rate, smooth=True)
    return SurfaceEquilibrium(film, sample, at, CONVERGED, total, gap)


def _wet_set(sample: SurfaceState, at: Array, rate: Array) -> tuple[bool, int]:
    """Rounds of the active set at one place: whether it hardly changes the force any more, and how many."""
    forces = []
    for number in range(1, WET_ROUNDS + 1):
        if sample.evaluate(at, rate) == 0:
            return True, number
        forces.append(sample.force.copy())
    change = np.ptp(np.array(forces[WET_ROUNDS // 2 :]), axis=0)
    return bool(np.linalg.norm(change) <= CALM * np.linalg.norm(sample.force)), WET_ROUNDS
