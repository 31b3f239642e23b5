"""A film on its lines with the temperature in it: one pass of Reynolds equation, energy equation and walls."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.film._heat_cells import Cells, fill_cells, new_cells, sweep_energy
from babbitt.film._heat_flows import Columns, Flows, new_flows
from babbitt.film._heat_pass import Drains, Pace, gather_heat, warm_pass
from babbitt.film._heat_walls import Walls, answer_walls, close_energy, wall_fluxes
from babbitt.film.general import Sample
from babbitt.film.heat import FilmHeat
from babbitt.film.model import JournalFilm
from babbitt.film.ring import TURN, Ring
from babbitt.film.ring_solution import drained_edges, fed_lines

__all__ = ["WarmRing", "columns_of"]

Array = NDArray[np.float64]
FILM_CONDUCTANCE, UNIFORM_SHARE, PASSED_ON = 1.5, 1.5, 2.5
"""Guess of what a film gives less to a place of the wall that is 1 K warmer: k/h times the first, and the second
times what it gives less to a bush warmer all around; and of what it gives more to the journal: k/h times the
third. Only the number of passes depends on them. Without the third the walls of a slow film, which conducts far
more than its oil carries, are thrown to and fro: the journal goes with the warm place of the bush."""
RELAX, CALM, LEAST_RELAX = 0.65, 12, 0.05
"""Share of a new viscosity field that a pass takes, passes after which a swinging film takes less, the least."""
TURBULENT_PRANDTL = 0.9
"""Eddy viscosity over eddy diffusivity of heat; textbook value of turbulent boundary layers."""
FLICKER = 30
"""Passes after which a few nodes that still change sides are let be, as ``_equilibrium.CYCLING``."""
ANSWER_SWEEPS = 12
"""Of the energy equation that gives the film's answer to a warmer wall, at most."""
MOST_HARMONICS = 16
"""Of the temperature around the bore: twice as many change the hottest place of our reference by 0.02 K."""
USUAL_LAYERS = 8
"""Number of layers that the compiler knows."""


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
    drains: Drains
    viscosity: Array
    last_rise: Array
    dissipation: float = 0.0
    friction: float = 0.0
    relaxation: float = RELAX
    passes: int = 0

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
            drains_of(sample.ring), np.ones((lines, count, layers)), np.zeros((lines, count, layers)),
        )  # fmt: skip

    def relative_viscosity(self) -> Array:
        """Viscosity of every layer over the reference."""
        return np.asarray(self.heat.viscosity(self.temperature)) / self.reference_viscosity

    def advance(self, at: Array, sweeps: int, rounds: int = 1) -> tuple[int, float]:
        """One pass at a journal position: number of nodes that changed sides, largest change of temperature, K."""
        sample, walls = self.sample, self.walls
        fresh = self.relative_viscosity()
        if self.passes == 0:
            self.viscosity[:] = fresh
        part = min(1.0, self.relaxation / RELAX)
        pace = Pace(rounds, self.passes > FLICKER, sweeps, self.relaxation, self.rise, self.stirred, part)
        changed, change, along, self.dissipation, self.friction, stale = warm_pass(
            sample.ring.surface, sample.film, sample.work, self.columns, self.flows, self.cells, walls,
            self.drains, pace, fresh, self.viscosity, self.temperature, self.groove, self.last_rise, at,
            sample.force, sample.stiffness, sample.damping,
        )  # fmt: skip
        if stale:
            self.prepare_bush()
            answered = answer_walls(self.columns, self.flows, walls, self.temperature, part)
            change = max(change, float(answered))
        self.passes += 1
        if self.passes > CALM:
            self.relaxation = (
                max(0.7 * self.relaxation, LEAST_RELAX) if along < 0.0 else min(1.1 * self.relaxation, RELAX)
            )
        return int(changed), float(change)

    def gather(self, at: Array) -> None:
        """Flows and heat of the Reynolds solution."""
        sample = self.sample
        self.dissipation, self.friction = gather_heat(
            sample.ring.surface, sample.film, sample.work, self.columns, self.flows, self.drains, at, self.rise
        )

    def fill(self, viscosity: Array) -> None:
        """Cells of the energy equation for the flows as they stand."""
        fill_cells(self.sample.ring.surface, self.columns, self.flows, self.walls.conduction, self.stirred,
        self.walls.insulated,
                   self.walls.fresh, viscosity, self.cells)  # fmt: skip

    def prepare_bush(self) -> None:
        """Derivatives of the balance of the walls, for the film as it is.

        What the film gives less to a warmer wall is exact for the journal and the first harmonics of the bush: the
        energy equation is linear, and solved once for each with that wall at 1 K and all else at zero. The
        others get a guess on the safe side; the answer does not depend on it.
        """
        walls, flows, columns = self.walls, self.flows, self.columns
        per = np.where(columns.supply < 0, flows.fill * columns.size / np.maximum(flows.gap, 1e-12), 0.0)
        film = walls.conduction * walls.flow_heat / walls.area * per.sum(axis=1)
        walls.conductance[:] = film
        modes, half = walls.analysis.shape[0], walls.analysis.shape[0] // 2
        exact = [m for m in (0, 1, half + 1, modes) if m <= modes]
        answers = {m: self.answer_to(m) for m in exact}
        local = FILM_CONDUCTANCE * film + UNIFORM_SHARE * np.abs(answers[0][0])
        matrix = np.zeros((modes + 1, modes + 1))
        matrix[:modes, :modes] = np.diag(walls.admittance) + (walls.analysis * local) @ walls.synthesis
        weight = film * walls.width / max(float(film @ walls.width), 1e-300)
        matrix[modes, :modes] = -PASSED_ON * answers[0][1] * weight @ walls.synthesis
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
                     ANSWER_SWEEPS, 1e-2)  # fmt: skip
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
        if self.walls.inverse.shape == coarse.walls.inverse.shape:
            self.walls.inverse[:] = coarse.walls.inverse
            known = coarse.walls.conductance
            self.walls.conductance[:] = (1.0 - flat) * known[rows[after - 1]] + flat * known[rows[after]]
        self.walls.harmonics[:] = self.walls.analysis @ (self.walls.bush - self.walls.ambient)
        self.walls.bush[:] = self.walls.ambient + self.walls.synthesis @ self.walls.harmonics

    def close(self, most: int, tolerance: float) -> float:
        """Solve energy and walls beside the film as it stands; largest change of the last round, K."""
        self.fill(self.viscosity if self.passes else self.relative_viscosity())
        surface = self.sample.ring.surface
        if not self.walls.insulated:
            self.prepare_bush()  # made anew: the closing rounds see this film only
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
    inner = np.delete(np.arange(supply.shape[1]), sides)
    whole = (supply[:, inner] == supply[:, inner[:1]]).all(axis=1)
    resolved = heat.grid.resolved or not bool(whole.all())
    node_share = np.bincount(ring.surface.node, ring.surface.share, minlength=supply.shape[1])
    side = np.zeros(supply.shape[1], dtype=np.int64)
    side[sides] = 1
    layers = heat.grid.layers
    counted = (0,) * layers if layers == USUAL_LAYERS else np.zeros(layers, dtype=np.int64)
    if not resolved:
        return Columns(np.zeros(supply.shape[1], dtype=np.int64), supply[:, inner[:1]].copy(), side, counted,
                       heat.grid.thicknesses(), np.array([node_share.sum()]))  # fmt: skip
    column = np.searchsorted(inner, np.arange(supply.shape[1])).clip(0, inner.size - 1)
    size = np.bincount(column, node_share).astype(float)
    return Columns(column, supply[:, inner].copy(), side, counted, heat.grid.thicknesses(), size)


def drains_of(ring: Ring) -> Drains:
    """Sides that may run partly filled."""
    return Drains(np.array(drained_edges(ring), dtype=np.int64), fed_lines(ring))


def walls_of(ring: Ring, heat: FilmHeat, film: JournalFilm, speed: float, lines: int) -> Walls:
    """Walls at the supply temperature, and the harmonics of the bush."""
    cold, given = heat.supply_temperature, heat.walls
    radius, width = 0.5 * film.diameter, line_widths(ring, lines)
    order = np.arange(0 if given is None else min(lines // 3, MOST_HARMONICS) + 1)
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
    width[1:] += 0.5 * step[: lines - 1]
    width[0] += 0.5 * step[lines - 1 :].sum()  # of a closed ring the last interval leads to the first line
    return width
