"""A film on its lines with the temperature in it: one pass of Reynolds equation, energy equation and walls."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.heat._heat_cells import Cells, new_cells
from babbitt.reynolds.heat._heat_flows import Columns, Flows, new_flows, spread_viscosity
from babbitt.reynolds.heat._heat_pass import Answers, Drains, Pace, Warmth, gather_heat, warm_pass
from babbitt.reynolds.heat._heat_walls import (
    Walls,
    close_energy,
    fill_film,
    update_wall_temperatures,
    wall_response_matrix,
)
from babbitt.reynolds.heat.heat_model import FilmHeat
from babbitt.reynolds.model import JournalFilm
from babbitt.reynolds.surface.mesh_lines import Density
from babbitt.reynolds.surface.surface_equilibrium import SurfaceState
from babbitt.reynolds.surface.surface_solution import drained_edges, fed_lines
from babbitt.reynolds.surface.unwrapped_mesh import TURN, UnwrappedMesh

__all__ = ["ThermalFilmState", "columns_of"]

Array = NDArray[np.float64]
GUESSED_SHARE = 0.8
"""Of the rise that all heat of a film gives to the oil that leaves it, where its temperatures start. Only the
number of passes depends on it."""
MOST_GUESSED = 200.0
"""Rise in K up to which a first temperature is guessed."""
RELAX, CALM, LEAST_RELAX = 0.65, 12, 0.05
"""Share of a new viscosity field that a pass takes, passes after which a swinging film takes less, the least."""
TURBULENT_PRANDTL = 0.9
"""Eddy viscosity over eddy diffusivity of heat; textbook value of turbulent boundary layers."""
FLICKER = 30
"""Passes after which a few nodes that still change sides are let be, as ``_equilibrium.CYCLING``."""
ANSWER_SWEEPS, ANSWERED = 30, 0.01
"""Of the energy equation that gives the film's answer to a warmer wall, at most, and the root mean square of their
last change that ends them, over that of the wall."""
FEW_ROUNDS = 40
"""That close the heat balance with the derivatives of the walls as they are, before they are made anew."""
MOST_HARMONICS = 16
"""Of the temperature around the bore: twice as many change the hottest place of our reference by 0.02 K in the
film and 0.05 K in the bush, and both by 0.06 K under four times the load."""
LINES_PER_WAVE = 6
"""Of the shortest harmonic, at least."""
USUAL_LAYERS = 8
"""Number of layers that the compiler knows."""


@dataclass(eq=False)
class ThermalFilmState:
    """Film and temperature on one ring.

    Attributes
    ----------
    sample : SurfaceState
    heat : FilmHeat
    columns : Columns
    flows : Flows
    cells : Cells
    temperature : ndarray, shape (lines, columns, layers)
        K.
    groove : ndarray, shape (supplies,)
        Mixing temperature of every supply, K.
    walls : Walls
    reference_viscosity : float
        Pa s; that of the fresh oil.
    rise : float
        mu omega R^2 / (rho c c^2): temperature per unit of dissipation over flow, K.
    stirred : float
        Prandtl number of oil of unit viscosity over that of turbulence; zero where the film is laminar.
    dissipation, friction : float
        Of the last pass, in units of mu omega^2 R^3 B / c.
    effective_viscosity : float
        One viscosity with the same friction by shear in the same gap, with the turbulence that the film has at
        every place, over the reference.
    drains : Drains
    viscosity : ndarray, shape (lines, columns, layers)
        Of the last pass over the reference.
    last_rise : ndarray, shape (lines, columns, layers)
        Change of the temperature in the last pass, K.
    relaxation : float
        Share of (the logarithm of) a new viscosity field that a pass takes: load, position and heat answer each
        other with a swing.
    passes : int
        So far.
    density : callable or None
        That of the lines; None where they stand evenly.
    """

    sample: SurfaceState
    heat: FilmHeat
    columns: Columns
    flows: Flows
    cells: Cells
    temperature: Array
    groove: Array
    walls: Walls
    reference_viscosity: float
    rise: float
    stirred: float
    drains: Drains
    viscosity: Array
    last_rise: Array
    dissipation: float = 0.0
    friction: float = 0.0
    effective_viscosity: float = 1.0
    relaxation: float = RELAX
    passes: int = 0
    density: Density | None = None

    @classmethod
    def of(cls, sample: SurfaceState, heat: FilmHeat, film: JournalFilm, speed: float) -> ThermalFilmState:
        """Film at the supply temperature, sheared at ``speed`` (rad/s)."""
        columns = columns_of(sample.ring, heat)
        lines, count, layers = *columns.supply.shape, columns.layer.size
        rise = film.viscosity * speed * (0.5 * film.diameter / film.clearance) ** 2 / heat.volumetric_heat_capacity
        cold, supplies = heat.supply_temperature, len(sample.ring.groove_lines) + len(film.pockets)
        return cls(
            sample, heat, columns, new_flows(lines, sample.ring.surface.step.size, count, layers),
            new_cells(lines, count, layers),
            np.full((lines, count, layers), cold), np.full(supplies, cold),
            walls_of(sample.ring, heat, film, speed, lines), film.viscosity, rise, stirring_of(film, heat),
            drains_of(sample.ring), np.ones((lines, count, layers)), np.zeros((lines, count, layers)),
        )  # fmt: skip

    def relative_viscosity(self) -> Array:
        """Viscosity of every layer over the reference."""
        return np.asarray(self.heat.viscosity(self.temperature)) / self.reference_viscosity

    def advance(self, at: Array, sweeps: int, rounds: int = 1) -> tuple[int, float]:
        """One pass at a journal position: number of nodes that changed sides, largest change of temperature, K.

        The change is that of a pass as long as passes usually are: one that takes less of the new viscosity and
        of the steps of the walls changes less without being nearer.
        """
        sample, walls = self.sample, self.walls
        fresh = self.relative_viscosity()
        if self.passes == 0:
            self.viscosity[:] = fresh
        part = min(1.0, self.relaxation / RELAX)
        pace = Pace(rounds, self.passes > FLICKER, sweeps, self.relaxation, self.rise, self.stirred, part)
        changed, change, along, powers, stale = warm_pass(
            sample.ring.surface, sample.film, sample.work, self.columns, self.flows, self.cells, walls,
            self.drains, pace, fresh, Warmth(self.viscosity, self.temperature, self.groove, self.last_rise), at,
            Answers(sample.force, sample.stiffness, sample.damping),
        )  # fmt: skip
        self.dissipation, self.friction, self.effective_viscosity = powers
        if stale:
            self.prepare_walls()
            change = update_wall_temperatures(sample.ring.surface, self.columns, self.flows, self.cells, walls,
                               self.temperature, self.groove, part, change)  # fmt: skip
        self.passes += 1
        change *= max(1.0, RELAX / self.relaxation)
        if self.passes > CALM:
            self.relaxation = (
                max(0.7 * self.relaxation, LEAST_RELAX) if along < 0.0 else min(1.1 * self.relaxation, RELAX)
            )
        return int(changed), float(change)

    def guess(self, at: Array) -> float:
        """Let oil and walls start at one temperature; viscosity there over the reference.

        It is that at which the film solved at a place would carry its own heat off, which goes with its viscosity.
        """
        spread_viscosity(self.sample.ring.surface, self.columns, self.viscosity, self.flows)
        self.gather(at)
        leaving = max(float(np.maximum(self.flows.leak, 0.0).sum()), 1e-300)
        rises, cold = np.linspace(0.0, MOST_GUESSED, 101), self.heat.supply_temperature
        relative = np.asarray(self.heat.viscosity(cold + rises)) / self.reference_viscosity
        heated = GUESSED_SHARE * self.dissipation * self.rise / leaving * relative
        rise = float(np.interp(0.0, rises - heated, rises))
        self.temperature[:] = self.groove[:] = cold + rise
        self.walls.bush[:] = cold + rise
        self.walls.harmonics[:1] += rise
        if not self.walls.journal_given:
            self.walls.journal[0] = cold + rise
        return float(np.interp(rise, rises, relative))

    def gather(self, at: Array) -> None:
        """Flows and heat of the Reynolds solution."""
        sample = self.sample
        self.dissipation, self.friction, self.effective_viscosity = gather_heat(
            sample.ring.surface, sample.film, sample.work, self.columns, self.flows, self.drains, at, self.rise
        )

    def fill(self, viscosity: Array) -> bool:
        """Cells of the energy equation for the flows as they stand; whether the walls are stale by now."""
        surface = self.sample.ring.surface
        return bool(fill_film(surface, self.columns, self.flows, self.stirred, viscosity, self.cells, self.walls))

    def prepare_walls(self) -> None:
        """Derivatives of the balance of the walls, for the film as it is."""
        walls, modes = self.walls, self.walls.admittance.size
        fluxes, heats = np.empty((walls.bush.size, modes + 1)), np.empty(modes + 1)
        wall_response_matrix(self.sample.ring.surface, self.columns, self.flows, self.cells, walls, fluxes, heats,
                        ANSWER_SWEEPS, ANSWERED)  # fmt: skip
        matrix = np.concatenate((-walls.analysis @ fluxes, -heats[None]))
        matrix.ravel()[:: modes + 2] += np.append(walls.admittance, walls.journal[2])
        if walls.journal_given:
            matrix[modes], matrix[:, modes] = 0.0, 0.0
            matrix[modes, modes] = 1.0
        walls.inverse[:] = np.linalg.inv(matrix)

    def start_from(self, coarse: ThermalFilmState) -> None:
        """Take over the temperatures of a coarser ring, linear between its lines."""
        old, new = coarse.sample.ring.theta, self.sample.ring.theta
        lines = self.temperature.shape[0]
        rows = np.append(np.arange(coarse.temperature.shape[0]), 0)[: old.size]
        after = np.clip(np.searchsorted(old, new[:lines] - 1e-12), 1, old.size - 1)
        share = ((new[:lines] - old[after - 1]) / (old[after] - old[after - 1]))[:, None, None]
        first, second = coarse.temperature[rows[after - 1]], coarse.temperature[rows[after]]
        self.temperature[:] = (1.0 - share) * first + share * second
        self.groove[:] = coarse.groove
        flat = share[:, 0, 0]
        bush = coarse.walls.bush
        self.walls.bush[:] = (1.0 - flat) * bush[rows[after - 1]] + flat * bush[rows[after]]
        self.walls.journal[:] = coarse.walls.journal
        if self.walls.inverse.shape == coarse.walls.inverse.shape:
            self.walls.inverse[:] = coarse.walls.inverse
            known = coarse.walls.conductance
            self.walls.conductance[:] = (1.0 - flat) * known[rows[after - 1]] + flat * known[rows[after]]
        if self.walls.harmonics.shape == coarse.walls.harmonics.shape:
            self.walls.harmonics[:] = coarse.walls.harmonics
        else:  # on uneven lines the one is not quite the inverse of the other
            self.walls.harmonics[:] = self.walls.analysis @ (self.walls.bush - self.walls.ambient)
        self.walls.bush[:] = self.walls.ambient + self.walls.synthesis @ self.walls.harmonics

    def close(self, most: int, tolerance: float) -> float:
        """Solve energy and walls beside the film as it stands; largest change of the last round, K."""
        stale = self.fill(self.viscosity if self.passes else self.relative_viscosity())
        conducting, change = not self.walls.insulated, math.inf
        if stale:
            self.prepare_walls()
        for rounds in (min(FEW_ROUNDS, most), most):
            change = close_energy(self.sample.ring.surface, self.columns, self.flows, self.cells, self.walls,
                                  self.temperature, self.groove, rounds, tolerance)  # fmt: skip
            if change < tolerance:
                break
            if conducting:
                self.prepare_walls()
        return float(change)

    def wall_temperatures(self) -> tuple[Array, float]:
        """Of the bush, shape (lines,), and of the journal, K; insulated ones are as warm as oil beside them."""
        walls = self.walls
        if not walls.insulated:
            return walls.bush.copy(), float(walls.journal[0])
        touching = self.temperature[:, :, [0, -1]].mean(axis=1)
        return touching[:, 0].copy(), float(touching[:, 1] @ walls.width / walls.width.sum())

    def bush_heat(self) -> float:
        """Heat that the bush takes, W."""
        return float((self.walls.bush_flux * self.walls.width).sum() * self.walls.area)


def columns_of(ring: UnwrappedMesh, heat: FilmHeat) -> Columns:
    """Columns of a ring: all nodes together, or each its own where asked for or where supplies are narrower.

    A node on a side goes with the one beside it: alone it would hold hardly any oil, and any temperature.
    """
    mesh, surface, layers = ring.mesh, ring.surface, heat.grid.layers
    supply, nodes = ring.supply[:, mesh.between_sides], mesh.nodes.size
    side = np.zeros(nodes, dtype=np.int64)
    side[list(mesh.side_nodes)] = 1
    counted = (0,) * layers if layers == USUAL_LAYERS else np.zeros(layers, dtype=np.int64)
    if heat.grid.resolved or bool((supply != supply[:, :1]).any()):
        first, last = mesh.between_sides.start, nodes - 2
        column = np.clip(np.arange(nodes), first, last) - first
        size = np.bincount(column[surface.node], surface.share).astype(float)
    else:
        supply, column, size = supply[:, :1], np.zeros(nodes, dtype=np.int64), surface.share.sum(keepdims=True)
    return Columns(column, supply.copy(), side, counted, heat.grid.thicknesses(), size)


def drains_of(ring: UnwrappedMesh) -> Drains:
    """Sides that may run partly filled."""
    return Drains(np.array(drained_edges(ring), dtype=np.int64), fed_lines(ring))


def walls_of(ring: UnwrappedMesh, heat: FilmHeat, film: JournalFilm, speed: float, lines: int) -> Walls:
    """Walls at the supply temperature, and the harmonics of the bush."""
    cold, given = heat.supply_temperature, heat.walls
    radius, width = 0.5 * film.diameter, line_widths(ring, lines)
    synthesis = np.zeros((lines, 0)) if given is None else harmonics_of(ring.theta[:lines])
    weight = np.full(synthesis.shape[1], 1.0 / math.pi)
    weight[:1] = 1.0 / TURN
    journal = np.array([cold, 0.0, 0.0, cold])
    if given is not None:
        shaft = given.journal
        start = cold if shaft.temperature is None else shaft.temperature
        journal = np.array([start, 0.0, shaft.shaft_conductance, shaft.ambient_temperature])
    admittance, harmonics = np.zeros(weight.size), np.zeros(weight.size)
    if given is not None:
        own = 1.0 / given.bush.impedances(weight.size // 2)
        admittance = np.concatenate((own, own[1:]))
        harmonics[0] = cold - given.bush.ambient_temperature
    return Walls(
        insulated=given is None,
        conduction=heat.conductivity / (heat.volumetric_heat_capacity * speed * film.clearance**2),
        flow_heat=heat.volumetric_heat_capacity * speed * radius * film.clearance * film.width,
        area=radius * film.width,
        bush=np.full(lines, cold), bush_flux=np.zeros(lines),
        ambient=cold if given is None else given.bush.ambient_temperature,
        journal=journal, journal_given=given is not None and given.journal.temperature is not None, width=width,
        # in rows, as that of a pad: for other arrays the compiler would make all kernels of warm films again
        analysis=np.ascontiguousarray(weight[:, None] * synthesis.T * width), synthesis=synthesis,
        admittance=admittance, harmonics=harmonics, inverse=np.zeros((weight.size + 1, weight.size + 1)),
        conductance=np.zeros(lines), fresh=cold, carry_over=heat.carry_over,
    )  # fmt: skip


def harmonics_of(theta: Array) -> Array:
    """1, cos(m theta) and sin(m theta), m = 1 .. n, shape (lines, 2 n + 1), quickly: powers of exp(i theta)."""
    number = min(theta.size // LINES_PER_WAVE, MOST_HARMONICS)
    powers = np.multiply.accumulate(np.repeat(np.exp(1j * theta[:, None]), number, axis=1), axis=1)
    return np.concatenate((np.ones((theta.size, 1)), powers.real, powers.imag), axis=1)


def stirring_of(film: JournalFilm, heat: FilmHeat) -> float:
    """Prandtl number of oil of unit viscosity over ``TURBULENT_PRANDTL``; zero for a laminar film."""
    if film.turbulence is None:
        return 0.0
    capacity = heat.volumetric_heat_capacity / film.turbulence.density
    return film.viscosity * capacity / heat.conductivity / TURBULENT_PRANDTL


def line_widths(ring: UnwrappedMesh, lines: int) -> Array:
    """Half of the intervals beside every line, rad."""
    step = ring.theta[1:] - ring.theta[:-1]
    width = np.zeros(lines)
    width[: step.size] += 0.5 * step
    width[1:] += 0.5 * step[: lines - 1]
    width[0] += 0.5 * step[lines - 1 :].sum()  # of a closed ring the last interval leads to the first line
    return width
