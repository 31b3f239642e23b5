"""Films of tilting pads with their temperatures: one pass of equilibrium, energy, walls, bending and growth."""

from __future__ import annotations

import math
from copy import deepcopy
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds._structs import CLEARANCE, Axial, Grid
from babbitt.reynolds.heat._heat_cells import Cells, new_cells
from babbitt.reynolds.heat._heat_flows import Columns, Flows, new_flows
from babbitt.reynolds.heat.heat_model import HeatGrid, JournalHeat
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.lands.profiles import common_profiles
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads._pad_flows import NARROWEST, PAD_TOTALS, PadRing
from babbitt.reynolds.tilting_pads._pad_heat import STATES, Oil, Temperatures, WallState, heat_pads, prepare_films
from babbitt.reynolds.tilting_pads._pad_steps import step_heated_pads
from babbitt.reynolds.tilting_pads._pads import CLOSED, CONVERGED, LIMIT, STUCK
from babbitt.reynolds.tilting_pads._place import new_places, pads_at
from babbitt.reynolds.tilting_pads._structs import PadPlaces, Pads
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales, kernel_pads
from babbitt.reynolds.tilting_pads.load_path import journal_among_pads
from babbitt.reynolds.tilting_pads.model import TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_bending import bending_matrices
from babbitt.reynolds.tilting_pads.pad_conduction import SURROUNDINGS, PadConduction, pad_conduction
from babbitt.reynolds.tilting_pads.pad_heat import PadHeat
from babbitt.reynolds.tilting_pads.solve import no_total

__all__ = ["PadFilms", "Placement"]

Array = NDArray[np.float64]

GUESSED_RISE = 10.0
"""K above the supply, where temperatures start."""
WALL_EXCHANGE = 6.0
"""Conductance at which pads and films meet, over k/c_p of the oil. Only the number of passes depends on it."""
USUAL_LAYERS = 8
"""Number of layers that the compiler knows."""
OPENED = 1.5
"""Times the widening of a pad on a centred pivot that its journal must be behind the middle for the pad to be
taken as unloaded unseen. A pad that widens evenly by g carries down to e = -g."""
DEFORMATION_STEP, LARGEST_STEP = 0.8, 0.1
"""Share of a new deformation that a pass takes, and its largest step over the smallest gap."""


@dataclass(frozen=True, eq=False)
class Placement:
    """Where the kernels of equilibrium left journal and pads.

    ``status`` is that of ``find_pads``, ``residual`` the force left over in the units of the kernels.
    """

    at: Array
    status: int
    steps: int
    indifferent: bool
    residual: float
    grid: Grid


@dataclass(eq=False)
class PadFilms:
    """Films of all pads in the units of the kernels; changed in place from pass to pass.

    ``conduction`` and ``bending`` are those of every pad, empty where none is asked for. ``profiles`` and
    ``clearances`` are those of the bearing without bending and growth, ``bent`` (pads, n + 1) what bending adds
    to the one, ``grown`` (pads,) what growth takes from the other, over the unit of length. ``unloaded`` is the e
    below which pads that ``can_unload`` unseen do so; pads of the numbers ``without`` never carry.
    ``share`` is the part of the growth that is taken,
    ``solved`` the number of solutions of the film of a pad.
    """

    bearing: TiltingPadBearing
    heat: PadHeat
    resolution: Resolution
    scales: PadScales
    axial: Axial
    pads: Pads
    places: PadPlaces
    ring: PadRing
    columns: Columns
    flows: Flows
    cells: Cells
    oil: Oil
    walls: WallState
    films: Temperatures
    conduction: tuple[PadConduction, ...]
    bending: tuple[tuple[Array, Array], ...]
    profiles: Array
    clearances: Array
    bent: Array
    grown: Array
    total: Array = field(default_factory=no_total)
    totals: Array = field(default_factory=lambda: np.zeros((0, PAD_TOTALS)))
    can_unload: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, dtype=bool))
    unloaded: float | Array = -math.inf
    without: tuple[int, ...] = ()
    share: float = 1.0
    passes: int = 0
    solved: int = 0

    @classmethod
    def of(
        cls, bearing: TiltingPadBearing, heat: PadHeat, resolution: Resolution, without: tuple[int, ...] = ()
    ) -> PadFilms:
        """Films at a temperature somewhat above that of the supply, with numbers of pads that never carry."""
        if bearing.turbulence is not None:
            raise InputError("E101", "turbulence is given; films with their own temperatures are laminar. Leave "
                             "it out, or take films of one temperature.")  # fmt: skip
        if heat.materials and len(heat.materials) != len(bearing.pads):
            raise InputError("E101", f"materials has {len(heat.materials)} entries for {len(bearing.pads)} pads; "
                             "give one for each, or none.")  # fmt: skip
        if any(pad.bends for pad in bearing.pads):
            raise InputError("E101", "bending_stiffness of a pad is given; films with their own temperatures bend "
                             "pads by bending. Leave it out.")  # fmt: skip
        if any(pad.viscosity is not None for pad in bearing.pads):
            raise InputError("E101", "viscosity of a pad is given; films with their own temperatures have that of "
                             "the oil. Leave it out.")  # fmt: skip
        count, n = len(bearing.pads), resolution.intervals
        rows, layers = count * (n + 1), heat.layers
        scales = PadScales(bearing)
        columns = columns_of(count, n, layers)
        flows = new_flows(rows, rows, 1, layers)
        start = heat.supply_temperature + GUESSED_RISE
        films = Temperatures(
            np.ones((rows, 1, layers)), np.full((rows, 1, layers), start), np.full((rows, 1, layers), start),
            np.zeros((rows, layers, STATES)), np.full(count, heat.supply_temperature), np.zeros(count, dtype=bool),
        )  # fmt: skip
        oil = oil_of(bearing, heat, scales)
        conduction = conduction_of(bearing, heat, n)
        pads = kernel_pads(bearing, scales)
        straight, profiles, centred = heat.bending is None, pads.bearing.profiles, pads.centred
        if not straight:
            profiles = common_profiles([*profiles, np.zeros(n + 1)])[:-1]
        pads = pads._replace(
            bearing=pads.bearing._replace(profiles=profiles), fluidity=np.ones((count, n)),
            drag=np.ones((count, n)), centred=centred & straight, plain=pads.plain & straight,
        )  # fmt: skip
        return cls(
            bearing, heat, resolution, scales, kernel_operator(resolution.axial_unknowns), pads, new_places(pads),
            ring_of(bearing, n), columns, flows, new_cells(rows, 1, layers), oil,
            walls_of(bearing, heat, conduction, oil, rows, start), films, conduction, bending_of(bearing, heat, n),
            profiles.copy(), pads.bearing.lands[:, CLEARANCE].copy(), np.zeros((count, n + 1)), np.zeros(count),
            totals=np.zeros((count, PAD_TOTALS)), can_unload=centred, without=without,
        )  # fmt: skip

    def prepare(self, part: float) -> float:
        """Coefficients of the films at their temperatures; ``part`` of a new viscosity is taken, by logarithms.

        Returns the largest share by which viscosities still differ from those of the temperatures.
        """
        part = 1.0 if self.passes == 0 else part
        self.forget()
        return float(
            prepare_films(self.pads, self.ring, self.columns, self.flows, self.films, self.fresh_viscosity(), part)
        )

    def fresh_viscosity(self) -> Array:
        """Viscosity at the temperatures, over its unit."""
        return np.asarray(self.heat.viscosity(self.films.on_lines)) / self.bearing.viscosity

    def forget(self) -> None:
        """What the last pass knew of the limits of pads does not hold at other viscosities."""
        self.places.unloaded_below[:] = self.unloaded
        self.places.unloaded_below[list(self.without)] = math.inf
        self.places.fold[:] = np.nan
        self.places.films[0] = 0

    def carry(self, load: Array, start: Array, tolerance: float, most: int) -> Placement:
        """Equilibrium of journal and pads at the viscosity as it is."""
        found = journal_among_pads(
            self.axial, self.pads, self.resolution.intervals, load, start, tolerance, most, self.places, self.total
        )
        self.solved += int(self.places.films[0])
        residual = math.hypot(self.total[0] + load[0], self.total[1] + load[1])
        return Placement(found.at, found.status, found.steps, found.indifferent, residual, found.grid)

    def follow(
        self, load: Array, last: Placement, tolerance: float, most: int, part: float
    ) -> tuple[float, Placement, float]:
        """A pass behind one that changed little: what `prepare`, `carry` and `heat_up` return, in short steps if
        these do."""
        self.forget()
        behind, x, y, steps, found, change = step_heated_pads(
            self.axial, self.pads, last.grid, load[0], load[1], last.at[0], last.at[1], tolerance, self.places,
            self.total, self.ring, self.columns, self.flows, self.cells, self.oil, self.walls, self.films,
            self.totals, self.fresh_viscosity(), part,
        )  # fmt: skip
        if not found:
            placement = self.carry(load, last.at, tolerance, most)
            return float(behind), placement, self.heat_up(placement)
        self.passes += 1
        self.solved += int(self.places.films[0])
        residual = math.hypot(self.total[0] + load[0], self.total[1] + load[1])
        placed = Placement(np.array([x, y]), CONVERGED, int(steps), last.indifferent, residual, last.grid)
        return float(behind), placed, float(change)

    def place(self, at: Array) -> Placement:
        """Pads around a journal at a place, at the viscosity as it is."""
        is_open, is_found, grid = pads_at(
            self.axial, self.pads, self.resolution.intervals, at[0], at[1], self.places, self.total
        )
        self.solved += int(self.places.films[0])
        status = CONVERGED if is_found else STUCK
        if is_found and AT_LIMIT in self.places.status:
            status = LIMIT
        return Placement(at, status if is_open else CLOSED, 0, False, 0.0, grid)

    def heat_up(self, placement: Placement) -> float:
        """Energy of films that stand, of grooves, journal and pads; the largest change of temperature, K, infinite
        where a pad has no film."""
        if placement.status == CLOSED:
            return math.inf
        self.passes += 1
        return float(
            heat_pads(
                self.axial, self.pads, placement.grid, self.places, self.ring, self.columns, self.flows,
                self.cells, self.oil, self.walls, self.films, self.totals,
            )
        )  # fmt: skip

    def gap(self) -> float:
        """Smallest gap of the last pass."""
        return float(self.totals[:, NARROWEST].min())

    def copied(self) -> PadFilms:
        """Films that may change without these."""
        fixed = (self.bearing, self.heat, self.axial, self.conduction, self.bending, self.walls.answer, self.oil)
        return deepcopy(self, {id(part): part for part in fixed})

    def freed(self) -> PadFilms:
        """A copy in which every pad carries what it can."""
        free = self.copied()
        free.without = ()
        free.forget()
        return free

    def drives(self) -> Array:
        """What drives the temperatures of every pad (`PadConduction`), shape (pads, n + 1 + 3)."""
        count = self.films.inlet.size
        trailing = np.empty(count)
        trailing[self.oil.previous] = self.films.inlet
        around = np.stack([self.films.inlet, trailing, np.full(count, self.walls.back)], axis=1)
        return np.concatenate([self.walls.flux.reshape(count, -1), around], axis=1)

    def deform(self, grid: Grid) -> float:
        """Take a share of the bending and growth that belong to temperatures and pressures; the change still to
        come, over the smallest gap."""
        if not self.bending and self.heat.growth is None:
            return 0.0
        drives, smallest = self.drives(), max(self.gap(), 1e-6)
        rise = self.growths(drives) - self.grown
        bend = np.zeros_like(self.bent)
        if self.bending:
            bend = self.deflections(grid, drives) - self.bent
        change = max(float(np.abs(rise).max()), float(np.abs(bend).max()))
        part = min(DEFORMATION_STEP, LARGEST_STEP * smallest / max(change, 1e-300))
        self.grown += part * rise
        self.bent += part * bend
        self.pads.bearing.lands[:, CLEARANCE] = self.clearances - self.grown
        if self.bending:
            self.unloaded = np.where(self.can_unload, -OPENED * self.opening(), -np.inf)
            self.pads.bearing.profiles[:] = self.profiles + on_samples(self.bent, self.profiles.shape[1])
        return change / smallest

    def opening(self) -> Array:
        """Radius g by which the bore of every pad widens at most, w <= g (1 - cos phi), shape (pads,)."""
        widest = np.empty(len(self.bearing.pads))
        for k, pad in enumerate(self.bearing.pads):
            phi = pad.extent * (np.linspace(0.0, 1.0, self.bent.shape[1]) - pad.pivot_fraction)
            edge = np.abs(phi) > 0.1 * pad.extent
            widest[k] = float((self.bent[k, edge] / (1.0 - np.cos(phi[edge]))).max())
        return np.maximum(widest, 0.0)

    def growths(self, drives: Array) -> Array:
        """How much narrower the gap of every pad is by growth (`PadHeat.narrowing`)."""
        grown = np.zeros(len(self.bearing.pads))
        if self.heat.growth is None:
            return grown
        journal = float(self.walls.journal[0])
        for k, conduction in enumerate(self.conduction):
            grown[k] = self.heat.narrowing(self.bearing, k, journal, float(conduction.pivot @ drives[k]))
        return self.share * grown / self.scales.length

    def deflections(self, grid: Grid, drives: Array) -> Array:
        """Bending of every pad under the pressure and the temperature that it has, shape (pads, n + 1)."""
        means = (np.where(grid.wet, grid.value, 0.0) @ self.axial.root_weights) * self.scales.pressure
        bent = np.empty_like(self.bent)
        for k, ((by_pressure, by_heat), conduction) in enumerate(zip(self.bending, self.conduction, strict=True)):
            bent[k] = by_pressure @ means[k] + by_heat @ (conduction.difference @ drives[k])
        return bent / self.scales.length


def columns_of(count: int, n: int, layers: int) -> Columns:
    """One column for the width; the first line of every pad is its groove."""
    supply = np.full((count, n + 1), -1, dtype=np.int64)
    supply[:, 0] = np.arange(count)
    counted = (0,) * layers if layers == USUAL_LAYERS else np.zeros(layers, dtype=np.int64)
    return Columns(
        np.zeros(1, dtype=np.int64), supply.reshape(-1, 1), np.zeros(1, dtype=np.int64), counted,
        HeatGrid(layers).thicknesses(), np.ones(1),
    )  # fmt: skip


def ring_of(bearing: TiltingPadBearing, n: int) -> PadRing:
    """Intervals of all pads in a row."""
    extents = np.array([pad.extent for pad in bearing.pads])
    step = np.repeat(extents[:, None] / n, n + 1, axis=1)
    step[:, 0] *= 2.0
    step[:, n] = 0.0
    size = step.size
    return PadRing(
        step.ravel(), 1.0, False, 1, np.zeros(1, dtype=np.int64), np.ones((size, 1)), np.ones((size, 1))
    )


def oil_of(bearing: TiltingPadBearing, heat: PadHeat, scales: PadScales) -> Oil:
    """Scales of heat."""
    count, turn = len(bearing.pads), 2.0 * math.pi
    capacity, length = heat.volumetric_heat_capacity, scales.length
    order = np.argsort([(bearing.sense * pad.pivot_angle) % turn for pad in bearing.pads])
    previous = np.empty(count, dtype=np.int64)
    previous[order] = np.roll(order, 1)
    share = np.array([1.0 if pad.width is None else pad.width / bearing.width for pad in bearing.pads])
    return Oil(
        conduction=heat.conductivity / (capacity * scales.rate * length**2),
        flow_heat=capacity * scales.flow,
        wall_heat=capacity * scales.rate * length,
        rise=bearing.viscosity * scales.rate * (bearing.radius / length) ** 2 / capacity,
        fresh=heat.supply_temperature,
        carry_over=heat.carry_over,
        share=share,
        previous=previous,
    )


def conduction_of(bearing: TiltingPadBearing, heat: PadHeat, n: int) -> tuple[PadConduction, ...]:
    """Conduction of every pad, or nothing. Its bore has the radius of the film, so that no heat is lost there."""
    if heat.walls is None:
        return ()
    return tuple(
        pad_conduction(bearing.radius, pad.thickness, pad.extent, pad.pivot_fraction, n, walls)
        for k, pad in enumerate(bearing.pads)
        if (walls := heat.walls_of(k)) is not None
    )


def bending_of(bearing: TiltingPadBearing, heat: PadHeat, n: int) -> tuple[tuple[Array, Array], ...]:
    """Bending of every pad, or nothing."""
    if heat.bending is None:
        return ()
    return tuple(
        bending_matrices(bearing.radius + pad.clearance, pad.thickness, pad.extent, pad.pivot_fraction, n, bending)
        for k, pad in enumerate(bearing.pads)
        if (bending := heat.bending_of(k)) is not None
    )


def walls_of(
    bearing: TiltingPadBearing, heat: PadHeat, conduction: tuple[PadConduction, ...], oil: Oil, rows: int,
    start: float,
) -> WallState:  # fmt: skip
    """Journal and pads at a uniform temperature."""
    count, supply = len(bearing.pads), heat.supply_temperature
    lines = rows // count
    journal = JournalHeat() if heat.journal is None else heat.journal
    exchange = WALL_EXCHANGE * heat.conductivity / min(pad.clearance for pad in bearing.pads)
    answer, given = np.zeros((count, lines, lines)), np.zeros((count, lines, SURROUNDINGS))
    edges = np.zeros((count, 2, lines + SURROUNDINGS))
    for k, one in enumerate(conduction):
        solved = met_at(one, exchange)
        answer[k], given[k] = solved[:, :lines], solved[:, lines:]
        over_edges = one.edges - exchange * one.edges[:, :lines] @ solved  # the flux is q + alpha (T - bore)
        edges[k] = over_edges * (bearing.width * oil.share[k] / oil.flow_heat)
    edges[:, :, 1] += edges[:, :, 0]  # the first cell lies along the half step at the leading edge, too
    share = np.full(lines, 1.0 / (lines - 1))
    share[[0, -1]] *= 0.5
    answer_mean = share @ answer
    answer_mean[:, 1] += answer_mean[:, 0]
    back = supply if heat.walls is None or heat.walls.back_temperature is None else heat.walls.back_temperature
    return WallState(
        journal=np.array([
            start if journal.temperature is None else journal.temperature, 0.0, journal.shaft_conductance,
            journal.ambient_temperature,
        ]),
        journal_open=heat.journal is not None, journal_given=journal.temperature is not None,
        pads_open=bool(conduction), exchange=exchange, answer=answer, given=given, answer_mean=answer_mean,
        given_mean=share @ given, edge_answer=edges[:, :, :lines].copy(),  # slices would be compiled for once more
        edge_given=edges[:, :, lines:].copy(), back=back, bore=np.full(rows, start), flux=np.zeros(rows),
        datum=np.full(rows, start),
    )  # fmt: skip


@lru_cache(maxsize=64)
def met_at(conduction: PadConduction, exchange: float) -> Array:
    """Bore temperature over q + alpha T, and over the surroundings, as `PadConduction.bore`."""
    lines = conduction.bore.shape[0]
    matrix = np.eye(lines) + exchange * conduction.bore[:, :lines]
    return np.asarray(np.linalg.solve(matrix, conduction.bore))


def on_samples(bent: Array, samples: int) -> Array:
    """Bending at the lines on the samples of the bores, straight between lines."""
    if bent.shape[1] == samples:
        return bent
    lines, places = np.linspace(0.0, 1.0, bent.shape[1]), np.linspace(0.0, 1.0, samples)
    return np.array([np.interp(places, lines, row) for row in bent])
