"""A film on its lines with the temperature in it: one pass of Reynolds equation, energy equation and walls."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.film._heat_cells import Cells, fill_cells, new_cells, sweep_energy
from babbitt.film._heat_flows import Columns, Flows, gather_flows, new_flows, spread_viscosity
from babbitt.film._heat_walls import MOST_RISE, Walls, answer_walls, close_energy, wall_fluxes
from babbitt.film._surface_forces import carry_streamers
from babbitt.film.general import Sample
from babbitt.film.heat import FilmHeat
from babbitt.film.model import JournalFilm
from babbitt.film.ring import TURN, Ring
from babbitt.film.ring_solution import drain_sides

__all__ = ["WarmRing", "columns_of"]

Array = NDArray[np.float64]
FILM_CONDUCTANCE, UNIFORM_SHARE = 2.5, 1.5
"""Guess of what a film gives less to a place of the wall that is 1 K warmer: k/h times the first, and the second
times what it gives less to a bush warmer all around. Only the number of passes depends on it."""
RELAX, CALM, LEAST_RELAX = 0.65, 12, 0.05
"""Share of a new viscosity field that a pass takes, passes after which a swinging film takes less, the least."""
TURBULENT_PRANDTL = 0.9
"""Eddy viscosity over eddy diffusivity of heat; textbook value of turbulent boundary layers."""
FLICKER = 30
"""Passes after which a few nodes that still change sides are let be, as ``_equilibrium.CYCLING``."""
ANSWER_SWEEPS = 12
"""Of the energy equation that gives the film's answer to a warmer wall, at most."""
ALIKE = 0.5
"""Change of the film's conductance, over its largest, up to which the inverse of the bush is kept."""
MOST_HARMONICS = 32
"""Of the temperature around the bore; a ring of steel damps the last a hundred times as much as the first."""


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
    stirred : float
        Prandtl number of the oil over that of turbulence; zero where the film is laminar.
    dissipation, friction : float
        Of the last pass, in units of mu omega^2 R^3 B / c.
    viscosity : ndarray, shape (lines, columns, layers), or None
        Of the last pass over the reference.
    relaxation : float
        Share (of the logarithm) of a new viscosity field that a pass takes: load, position and heat answer each
        other with a swing.
    passes : int
        So far.
    last_rise : ndarray or None
        Change of the temperature in the last one, K.
    """

    sample: Sample
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
    dissipation: float = 0.0
    friction: float = 0.0
    viscosity: Array | None = None
    relaxation: float = RELAX
    passes: int = 0
    last_rise: Array | None = None

    @classmethod
    def of(cls, sample: Sample, heat: FilmHeat, film: JournalFilm, speed: float) -> WarmRing:
        """Film at the supply temperature, sheared at ``speed`` (rad/s)."""
        columns = columns_of(sample.ring, heat)
        lines, count, layers = *columns.supply.shape, columns.layer.size
        rise = film.viscosity * speed * (0.5 * film.diameter / film.clearance) ** 2 / heat.volumetric_heat_capacity
        cold = heat.supply_temperature
        return cls(
            sample, heat, columns, new_flows(lines, sample.ring.surface.step.size, count, layers),
            new_cells(lines, count, layers),
            np.full((lines, count, layers), cold), np.full(int(columns.supply.max()) + 1, cold),
            walls_of(sample.ring, heat, film, speed, lines), film.viscosity, rise, stirring_of(film, heat),
        )  # fmt: skip

    def relative_viscosity(self) -> Array:
        """Viscosity of every layer over the reference."""
        return np.asarray(self.heat.viscosity(self.temperature)) / self.reference_viscosity

    def advance(self, at: Array, sweeps: int, rounds: int = 1) -> tuple[int, float]:
        """One pass at a journal position: number of nodes that changed sides, largest change of temperature, K."""
        surface = self.sample.ring.surface
        fresh = self.relative_viscosity()
        if self.viscosity is not None:
            fresh = self.viscosity * (fresh / self.viscosity) ** self.relaxation
        self.viscosity = viscosity = fresh
        spread_viscosity(surface, self.columns, viscosity, self.flows)
        wet = self.sample.work.wet
        for _ in range(rounds):
            known = wet.copy()
            changed = self.sample.evaluate(at)
            if changed == 0:
                break
        if self.passes > FLICKER and changed <= 0.01 * wet.size:
            wet[:], changed = known, 0
        self.gather(at)
        before = self.temperature.copy()
        self.fill(viscosity)
        self.sweep(sweeps, 1e-9)
        rise = self.temperature - before
        change = float(np.abs(rise).max())
        if change > MOST_RISE:
            self.temperature[:] = before + rise * (MOST_RISE / change)
        change = max(change, self.correct_walls(min(1.0, self.relaxation / RELAX)))
        self.passes += 1
        if self.passes > CALM and self.last_rise is not None:
            swings = float((rise * self.last_rise).sum()) < 0.0
            self.relaxation = (
                max(0.7 * self.relaxation, LEAST_RELAX) if swings else min(1.1 * self.relaxation, RELAX)
            )
        self.last_rise = rise
        return changed, change

    def gather(self, at: Array) -> None:
        """Flows and heat of the Reynolds solution."""
        sample = self.sample
        if not sample.ring.surface.conserving:
            carry_streamers(sample.ring.surface, sample.film, sample.work)
        drain_sides(sample.ring, sample.film, sample.work)
        self.dissipation, self.friction = gather_flows(
            sample.ring.surface, sample.film, sample.work, at, self.columns, self.flows
        )
        self.flows.heat[:] *= self.rise

    def fill(self, viscosity: Array) -> None:
        """Cells of the energy equation for the flows as they stand."""
        fill_cells(self.sample.ring.surface, self.columns, self.flows, self.walls.conduction, self.stirred,
        self.walls.insulated,
                   self.walls.fresh, viscosity, self.cells)  # fmt: skip

    def sweep(self, most: int, tolerance: float) -> float:
        """Solve the energy equation; change of the last sweep, K."""
        surface = self.sample.ring.surface
        return float(
            sweep_energy(surface, self.columns, self.flows, self.cells, 1.0, self.walls, self.temperature,
                         self.groove, most, tolerance)
        )  # fmt: skip

    def correct_walls(self, share: float) -> float:
        """Share of the way to new wall temperatures from the heat that they take; their largest change, K."""
        if self.walls.insulated:
            return 0.0
        self.prepare_bush()
        return float(answer_walls(self.columns, self.flows, self.walls, self.temperature, share))

    def prepare_bush(self) -> None:
        """Derivatives of the balance of the walls; kept while the film is nearly the same.

        What the film gives less to a warmer wall is exact for the journal and the first harmonics of the bush: the
        energy equation is linear, and solved once for each with that wall at 1 K and all else at zero. The
        others get a guess on the safe side; the answer does not depend on it.
        """
        walls, flows, columns = self.walls, self.flows, self.columns
        per = np.where(columns.supply < 0, flows.fill * columns.size / np.maximum(flows.gap, 1e-12), 0.0)
        film = walls.conduction * walls.flow_heat / walls.area * per.sum(axis=1)
        if not np.abs(film - walls.conductance).max() > ALIKE * film.max():
            return
        walls.conductance[:] = film
        modes, half = walls.analysis.shape[0], walls.analysis.shape[0] // 2
        exact = [m for m in (0, 1, half + 1, modes) if m <= modes]
        answers = {m: self.answer_to(m) for m in exact}
        local = FILM_CONDUCTANCE * film + UNIFORM_SHARE * np.abs(answers[0][0])
        matrix = np.zeros((modes + 1, modes + 1))
        matrix[:modes, :modes] = np.diag(walls.admittance) + (walls.analysis * local) @ walls.synthesis
        for m, (flux, journal) in answers.items():
            matrix[:modes, m] = -walls.analysis @ flux
            matrix[modes, m] = -journal
            if m < modes:
                matrix[m, m] += walls.admittance[m]
        matrix[modes, modes] += walls.journal[2]
        if walls.journal_given:
            matrix[modes], matrix[:, modes] = 0.0, 0.0
            matrix[modes, modes] = 1.0
        walls.inverse[:] = np.linalg.inv(matrix)

    def answer_to(self, mode: int) -> tuple[Array, float]:
        """Heat flux into the bush (W/m2) and heat into the journal (W), one wall at 1 K and all else at zero."""
        walls, columns = self.walls, self.columns
        modes = walls.analysis.shape[0]
        bush = walls.synthesis[:, mode].copy() if mode < modes else np.zeros(walls.bush.size)
        journal = np.zeros(4)
        journal[0] = 0.0 if mode < modes else 1.0
        held = walls._replace(bush=bush, journal=journal)
        temperature = np.zeros_like(self.temperature)
        surface = self.sample.ring.surface
        sweep_energy(surface, columns, self.flows, self.cells, 0.0, held, temperature, np.zeros_like(self.groove),
                     ANSWER_SWEEPS, 1e-3)  # fmt: skip
        flux = np.zeros(bush.size)
        return flux, float(wall_fluxes(columns, self.flows, held, temperature, flux))

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
        bush = coarse.walls.bush
        self.walls.bush[:] = (1.0 - flat) * bush[rows[after - 1]] + flat * bush[rows[after]]
        self.walls.journal[:] = coarse.walls.journal
        self.walls.harmonics[:] = self.walls.analysis @ (self.walls.bush - self.walls.ambient)
        self.walls.bush[:] = self.walls.ambient + self.walls.synthesis @ self.walls.harmonics

    def close(self, most: int, tolerance: float) -> float:
        """Solve energy and walls beside the film as it stands; largest change of the last round, K."""
        self.fill(self.relative_viscosity() if self.viscosity is None else self.viscosity)
        surface = self.sample.ring.surface
        if not self.walls.insulated:
            self.walls.conductance[:] = 0.0  # made anew: the closing rounds see this film only
            self.prepare_bush()
        return float(
            close_energy(surface, self.columns, self.flows, self.cells, self.walls, self.temperature, self.groove,
                         most, tolerance)
        )  # fmt: skip

    def unit_friction(self) -> float:
        """Friction power of the same film by shear alone at the reference viscosity."""
        per = np.where(self.columns.supply < 0, self.flows.fill * self.columns.size, 0.0)
        return float((self.walls.width[:, None] * per / np.maximum(self.flows.gap, 1e-12)).sum())

    def bush_heat(self) -> float:
        """Heat that the bush takes, W."""
        return float((self.walls.bush_flux * self.walls.width).sum() * self.walls.area)


def columns_of(ring: Ring, heat: FilmHeat) -> Columns:
    """Columns of a ring: all nodes together, or each its own where asked for or where supplies are narrower.

    A node on a side goes with the one beside it: alone it would hold hardly any oil, and any temperature.
    """
    supply, sides = ring.supply, list(ring.mesh.side_nodes)
    inner = np.setdiff1d(np.arange(supply.shape[1]), sides)
    whole = (supply[:, inner] == supply[:, inner[:1]]).all(axis=1)
    resolved = heat.grid.resolved or not bool(whole.all())
    node_share = np.bincount(ring.surface.node, ring.surface.share, minlength=supply.shape[1]).astype(float)
    side = np.zeros(supply.shape[1], dtype=np.int64)
    side[sides] = 1
    if not resolved:
        return Columns(np.zeros(supply.shape[1], dtype=np.int64), supply[:, inner[:1]].copy(), side,
                       heat.grid.thicknesses(), np.array([node_share.sum()]))  # fmt: skip
    column = np.searchsorted(inner, np.arange(supply.shape[1])).clip(0, inner.size - 1)
    size = np.bincount(column, node_share).astype(float)
    return Columns(column, supply[:, inner].copy(), side, heat.grid.thicknesses(), size)


def walls_of(ring: Ring, heat: FilmHeat, film: JournalFilm, speed: float, lines: int) -> Walls:
    """Walls at the supply temperature, and the harmonics of the bush."""
    cold, given = heat.supply_temperature, heat.walls
    radius, width = 0.5 * film.diameter, line_widths(ring, lines)
    order = np.arange(0 if given is None else min(lines // 4, MOST_HARMONICS) + 1)
    phase = np.outer(ring.theta[:lines], order)
    synthesis = np.concatenate((np.cos(phase), np.sin(phase[:, 1:])), axis=1)
    weight = np.full(synthesis.shape[1], 1.0 / math.pi)
    weight[:1] = 1.0 / TURN
    journal = np.array([cold, 0.0, 0.0, cold])
    if given is not None:
        shaft = given.journal
        start = cold if shaft.temperature is None else shaft.temperature
        journal = np.array([start, 0.0, shaft.shaft_conductance, shaft.ambient_temperature])
    admittance, harmonics = np.zeros(weight.size), np.zeros(weight.size)
    if given is not None:
        own = 1.0 / given.bush.impedances(order[-1])
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
        analysis=weight[:, None] * synthesis.T * width, synthesis=synthesis,
        admittance=admittance, harmonics=harmonics, inverse=np.zeros((weight.size + 1, weight.size + 1)),
        conductance=np.zeros(lines), fresh=cold, carry_over=heat.carry_over,
    )  # fmt: skip


def stirring_of(film: JournalFilm, heat: FilmHeat) -> float:
    """Prandtl number of the oil over ``TURBULENT_PRANDTL``; zero for a laminar film."""
    if film.turbulence is None:
        return 0.0
    capacity = heat.volumetric_heat_capacity / film.turbulence.density
    return film.viscosity * capacity / heat.conductivity / TURBULENT_PRANDTL


def line_widths(ring: Ring, lines: int) -> Array:
    """Half of the intervals beside every line, rad."""
    step = np.diff(ring.theta)
    width = np.zeros(lines)
    width[: step.size] += 0.5 * step
    np.add.at(width, (np.arange(step.size) + 1) % lines, 0.5 * step)
    return width
