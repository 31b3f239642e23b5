"""A film on its lines with the temperature in it: one pass of Reynolds equation, energy equation and walls."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.film._energy import Columns, Flows, Walls, gather_flows, new_flows, spread_viscosity, sweep_energy
from babbitt.film.general import Sample
from babbitt.film.heat import ConductingWalls, FilmHeat
from babbitt.film.ring import TURN, Ring

__all__ = ["WallState", "WarmRing", "columns_of"]

Array = NDArray[np.float64]
FILM_CONDUCTANCE = 2.5
"""Conductance from the mean of a film to a wall over k/h, with which walls are corrected between passes; the
answer does not depend on it (parallel plates: 2 for a linear, 3 for a parabolic profile)."""
RELAX = 0.65
"""Share of a new viscosity field that a pass takes: load, position and heat answer each other with a swing."""
ALIKE = 0.2
"""Change of the film's conductance, over its largest, up to which the inverse of the bush is kept."""
MOST_HARMONICS = 32
"""Of the temperature around the bore; a ring of steel damps the last a hundred times as much as the first."""


@dataclass(eq=False)
class WallState:
    """Temperatures of the walls, K, and the harmonics of the bush.

    The bush is described by ``admittance`` (heat flux into the bore over its temperature, W/(m2 K)) of every
    cosine and sine; ``analysis`` (modes, lines) takes a flux at the lines apart, ``synthesis`` (lines, modes) builds it.
    """

    bush: Array
    journal: float
    bush_flux: Array
    analysis: Array = field(default_factory=lambda: np.zeros((0, 0)))
    synthesis: Array = field(default_factory=lambda: np.zeros((0, 0)))
    admittance: Array = field(default_factory=lambda: np.zeros(0))
    journal_heat: float = 0.0
    conductance: Array = field(default_factory=lambda: np.zeros(0))
    inverse: Array | None = None


@dataclass(eq=False)
class WarmRing:
    """Film and temperature on one ring.

    Attributes
    ----------
    sample : Sample
    heat : FilmHeat
    columns : Columns
    flows : Flows
    temperature : ndarray, shape (lines, columns, layers)
        K.
    groove : ndarray, shape (supplies,)
        Mixing temperature of every supply, K.
    walls : WallState
    rise : float
        mu omega R^2 / (rho c c^2): temperature per unit of dissipation over flow, K.
    flow_heat : float
        rho c omega R c B: heat per unit of flow and kelvin, W/K.
    """

    sample: Sample
    heat: FilmHeat
    columns: Columns
    flows: Flows
    temperature: Array
    groove: Array
    walls: WallState
    reference_viscosity: float
    rise: float
    flow_heat: float
    area: float
    clearance: float
    dissipation: float = 0.0
    friction: float = 0.0
    viscosity: Array | None = None

    @classmethod
    def of(cls, sample: Sample, heat: FilmHeat, viscosity: float, diameter: float, width: float, clearance: float,
           speed: float) -> WarmRing:  # fmt: skip
        """Film at the supply temperature."""
        columns = columns_of(sample.ring, heat)
        lines, count, layers = *columns.supply.shape, columns.layer.size
        radius, stored = 0.5 * diameter, heat.volumetric_heat_capacity
        cold = heat.supply_temperature
        return cls(
            sample, heat, columns, new_flows(lines, sample.ring.surface.step.size, count, layers),
            np.full((lines, count, layers), cold), np.full(int(columns.supply.max()) + 1, cold),
            walls_of(sample.ring, heat, lines), viscosity,
            viscosity * speed * radius**2 / (stored * clearance**2), stored * speed * radius * clearance * width,
            radius * width, clearance,
        )  # fmt: skip

    @property
    def conduction(self) -> float:
        """k / (rho c omega c^2)."""
        return self.heat.conductivity * self.area / (self.clearance * self.flow_heat)

    def kernel_walls(self) -> Walls:
        """Walls as the kernels take them."""
        adiabatic = self.heat.walls is None
        lines = self.walls.bush.size
        return Walls(
            conduction=self.conduction, bush=self.walls.bush,
            resistance=np.full(lines, -1.0 if adiabatic else 0.0), journal=self.walls.journal, insulated=adiabatic,
            fresh=np.full(self.groove.size, self.heat.supply_temperature), ambient=self.heat.supply_temperature,
        )  # fmt: skip

    def relative_viscosity(self) -> Array:
        """Viscosity of every layer over the reference."""
        return np.asarray(self.heat.viscosity(self.temperature)) / self.reference_viscosity

    def advance(self, at: Array, sweeps: int, rounds: int = 1) -> tuple[int, float]:
        """One pass at a journal position: number of nodes that changed sides, largest change of temperature, K."""
        surface = self.sample.ring.surface
        fresh = self.relative_viscosity()
        viscosity = fresh if self.viscosity is None else self.viscosity + RELAX * (fresh - self.viscosity)
        self.viscosity = viscosity
        spread_viscosity(surface, self.columns, viscosity, self.flows)
        for _ in range(rounds):
            changed = self.sample.evaluate(at)
            if changed == 0:
                break
        self.gather(at)
        change = self.sweep(viscosity, sweeps, 1e-9)
        return changed, max(change, self.correct_walls())

    def gather(self, at: Array) -> None:
        """Flows and heat of the Reynolds solution."""
        sample = self.sample
        self.dissipation, self.friction = gather_flows(
            sample.ring.surface, sample.film, sample.work, at, self.columns, self.flows
        )
        self.flows.heat[:] *= self.rise

    def sweep(self, viscosity: Array, most: int, tolerance: float) -> float:
        """Energy equation with the flows as they stand; change of the last sweep, K."""
        surface = self.sample.ring.surface
        return float(
            sweep_energy(surface, self.columns, self.flows, self.kernel_walls(), viscosity, self.temperature,
                         self.groove, most, tolerance)
        )  # fmt: skip

    def correct_walls(self) -> float:
        """New wall temperatures from the heat that they take; their largest change, K.

        The film answers a warmer wall with less heat, about ``FILM_CONDUCTANCE`` k/h a kelvin: with that the bush
        is solved as a whole, so that only the error of this guess is left to the next pass.
        """
        walls, state = self.heat.walls, self.walls
        if walls is None:
            return 0.0
        film = FILM_CONDUCTANCE * self.conductances()
        self.prepare_bush(film / (self.area * self.widths))
        bush, journal = self.wall_heat()
        old, old_journal = state.bush, state.journal
        state.bush_flux = bush / (self.area * self.widths)
        ambient = walls.bush.ambient_temperature
        answer = times(state.analysis, state.bush_flux + state.conductance * (old - ambient))
        state.bush = ambient + times(state.synthesis, times(state.inverse, answer))
        state.journal_heat = float(journal.sum())
        if walls.journal.temperature is None:
            taken, loss = float(film.sum()), walls.journal.shaft_conductance
            gained = state.journal_heat + taken * old_journal + loss * walls.journal.ambient_temperature
            state.journal = float(gained / (taken + loss))
        return max(float(np.abs(state.bush - old).max()), abs(state.journal - old_journal))

    def prepare_bush(self, conductance: Array) -> None:
        """Inverse of the bush beside the film, in harmonics; kept while the film is nearly the same."""
        state = self.walls
        if state.inverse is None or np.abs(conductance - state.conductance).max() > ALIKE * conductance.max():
            state.conductance = conductance
            beside = (state.analysis * conductance) @ state.synthesis
            state.inverse = np.linalg.inv(np.diag(state.admittance) + beside)

    def start_from(self, coarse: WarmRing) -> None:
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
        self.walls.bush = (1.0 - flat) * coarse.walls.bush[rows[after - 1]] + flat * coarse.walls.bush[rows[after]]
        self.walls.journal = coarse.walls.journal

    def close(self, most: int, tolerance: float) -> float:
        """Solve energy and walls beside the film as it stands; largest change of the last round, K."""
        viscosity = self.relative_viscosity() if self.viscosity is None else self.viscosity
        change = math.inf
        for _ in range(most):
            change = self.sweep(viscosity, 4, tolerance)
            change = max(change, self.correct_walls())
            if change < tolerance:
                break
        return change

    def unit_friction(self) -> float:
        """Friction power of the same film by shear alone at the reference viscosity."""
        surface = self.sample.ring.surface
        n = surface.step.size
        per = np.where(self.columns.supply < 0, self.flows.fill * self.columns.size, 0.0)
        return float((self.widths[:, None] * per / np.maximum(self.flows.gap, 1e-12)).sum()) if n else 0.0

    @cached_property
    def widths(self) -> Array:
        """Angle that belongs to every line, rad."""
        return line_widths(self.sample.ring, self.temperature.shape[0])

    def conductances(self) -> Array:
        """k/h times area of the film of every line, W/K; none over grooves."""
        flows, columns = self.flows, self.columns
        per = np.where(columns.supply < 0, flows.fill * columns.size / np.maximum(flows.gap, 1e-12), 0.0)
        return np.asarray(self.conduction * self.flow_heat * self.widths * per.sum(axis=1))

    def wall_heat(self) -> tuple[Array, Array]:
        """Heat that every line gives to bush and journal, W."""
        flows, columns, layer = self.flows, self.columns, self.columns.layer
        per = np.where(columns.supply < 0, flows.fill * columns.size / np.maximum(flows.gap, 1e-12), 0.0)
        scale = self.conduction * self.flow_heat * self.widths[:, None] * per
        bush = scale * 2.0 / layer[0] * (self.temperature[:, :, 0] - self.walls.bush[:, None])
        journal = scale * 2.0 / layer[-1] * (self.temperature[:, :, -1] - self.walls.journal)
        return bush.sum(axis=1), journal.sum(axis=1)


def columns_of(ring: Ring, heat: FilmHeat) -> Columns:
    """Columns of a ring: all nodes together, or each its own where asked for or where supplies are narrower."""
    supply, sides = ring.supply, list(ring.mesh.side_nodes)
    inner = np.setdiff1d(np.arange(supply.shape[1]), sides)
    whole = (supply[:, inner] == supply[:, inner[:1]]).all(axis=1)
    resolved = heat.grid.resolved or not bool(whole.all())
    node_share = np.bincount(ring.surface.node, ring.surface.share, minlength=supply.shape[1])
    side = np.zeros(supply.shape[1], dtype=np.int64)
    side[sides] = 1
    if not resolved:
        return Columns(np.zeros(supply.shape[1], dtype=np.int64), supply[:, inner[:1]].copy(), side,
                       heat.grid.thicknesses(), np.array([node_share.sum()]))  # fmt: skip
    cells = supply.copy()
    cells[:, sides] = -1
    grooved = whole & (supply[:, inner[0]] >= 0)
    cells[np.ix_(grooved, sides)] = supply[grooved][:, inner[:1]]
    return Columns(np.arange(supply.shape[1]), cells, side, heat.grid.thicknesses(), node_share)


def walls_of(ring: Ring, heat: FilmHeat, lines: int) -> WallState:
    """Walls at the supply temperature, and the harmonics of the bush."""
    cold, walls = heat.supply_temperature, heat.walls
    none = np.zeros(lines)
    if not isinstance(walls, ConductingWalls):
        return WallState(np.full(lines, cold), cold, none)
    theta = ring.theta[:lines]
    order = np.arange(min(lines // 4, MOST_HARMONICS) + 1)
    phase = np.outer(theta, order)
    synthesis = np.concatenate((np.cos(phase), np.sin(phase[:, 1:])), axis=1)
    weight = np.concatenate(([1.0 / TURN], np.full(synthesis.shape[1] - 1, 1.0 / math.pi)))
    analysis = weight[:, None] * synthesis.T * line_widths(ring, lines)
    admittance = 1.0 / walls.bush.impedances(order.size - 1)
    journal = cold if walls.journal.temperature is None else walls.journal.temperature
    both = np.concatenate((admittance, admittance[1:]))
    return WallState(np.full(lines, cold), journal, none, analysis, synthesis, both)


def times(matrix: Array, vector: Array) -> Array:
    """Their product; einsum, since the threads of a BLAS cost more than products of this size."""
    return np.asarray(np.einsum("ij,j->i", matrix, vector))


def line_widths(ring: Ring, lines: int) -> Array:
    """Half of the intervals beside every line, rad."""
    step = np.diff(ring.theta)
    width = np.zeros(lines)
    width[: step.size] += 0.5 * step
    np.add.at(width, (np.arange(step.size) + 1) % lines, 0.5 * step)
    return width
