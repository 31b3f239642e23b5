"""What the thermal film answers, in SI."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.heat._heat_cells import supply_balances
from babbitt.reynolds.heat.heat_model import mean_over_layers
from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.stability.load_slope import EquilibriumNodes
from babbitt.reynolds.surface.surface_solution import twins

__all__ = ["ThermalFilm", "thermal_film"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class HeatSplit:
    """Where the heat of a film goes, W.

    Attributes
    ----------
    dissipation : float
        Generated in the film: friction power on the journal and what the supply pumps in.
    oil : float
        Carried off by the oil, over the sides and back into supplies.
    bush, journal : float
        Taken by the walls.
    returned : float
        Of that of the oil, what goes back into supplies.
    """

    dissipation: float
    oil: float
    bush: float
    journal: float
    returned: float = 0.0

    @property
    def balance_error(self) -> float:
        """What is left over, of the dissipation."""
        return abs(self.dissipation - self.oil - self.bush - self.journal) / max(self.dissipation, 1e-300)


@dataclass(frozen=True, eq=False)
class ThermalFilm:
    """A film and its temperatures.

    Attributes
    ----------
    film : FilmSolution
        Its coefficients hold for temperatures that do not follow the motion (frozen).
    axial_positions : ndarray, shape (columns,)
        m; one column in the mid-plane stands for the mean over the width.
    layers : ndarray, shape (layers,)
        Middle of the layers, 0 on the bush and 1 on the journal.
    temperature : ndarray, shape (lines, columns, layers)
        K; lines at ``film.angles``.
    supply_temperature, side_temperature : float
        Of fresh oil, and the mean of all that leaves over the sides, the ends of grooves included, K.
    groove_temperatures : ndarray, shape (supplies,)
        Mixed, K.
    fresh_flow, returned_flow : ndarray, shape (supplies,)
        Fresh oil that a supply gives, and warm oil that goes back into it, m3/s; their difference is the net
        ``film.supply_flow``.
    bush_temperature : ndarray, shape (lines,)
        On the bore, K.
    bush_flux : ndarray, shape (lines,)
        Into the bush, W/m2.
    journal_temperature : float
        K.
    insulated : bool
        No wall takes heat: at every place it is as warm as the oil that touches it; the temperatures of bush and
        journal are means of that.
    heat : HeatSplit
    effective_viscosity : float
        Uniform viscosity of the oil with the same friction power in the same gap by shear, at every place with the
        turbulence that the film has there, Pa s.
    nodes : EquilibriumNodes or None
        The film as it was solved.
    """

    film: FilmSolution
    axial_positions: Array
    layers: Array
    temperature: Array
    supply_temperature: float
    side_temperature: float
    groove_temperatures: Array
    fresh_flow: Array
    returned_flow: Array
    bush_temperature: Array
    bush_flux: Array
    journal_temperature: float
    insulated: bool
    heat: HeatSplit
    effective_viscosity: float
    nodes: EquilibriumNodes | None = None

    @property
    def maximum_temperature(self) -> float:
        """Highest temperature in the film, K."""
        return float(self.temperature.max())

    @property
    def hot_spot(self) -> tuple[float, float]:
        """Angle (rad) and axial position (m) of the highest temperature."""
        line, column, _ = np.unravel_index(int(self.temperature.argmax()), self.temperature.shape)
        return float(self.film.angles[0, line]), float(self.axial_positions[column])

    @property
    def mean_bush_temperature(self) -> float:
        """Mean over the bore, K."""
        angles = self.film.angles.ravel()[: self.bush_temperature.size]
        behind = np.abs(np.diff(angles))
        behind = np.append(behind, 2.0 * np.pi - behind.sum())
        weight = 0.5 * (behind + np.roll(behind, 1))
        return float(self.bush_temperature @ weight / weight.sum())

    @property
    def mean_temperature(self) -> Array:
        """Mean over the gap, K, shape (lines, columns)."""
        return mean_over_layers(self.temperature, self.layers)


def thermal_film(
    film: FilmSolution, scales: Scales, thermal: ThermalFilmState, order: Sequence[int]
) -> ThermalFilm:
    """Temperatures and heat of a ring and its film; ``order`` of its supplies in the bearing as given."""
    columns, unit = thermal.columns, thermal.walls.flow_heat
    cold = thermal.heat.supply_temperature
    leaving, own = side_oil(thermal)
    over_sides = float((leaving * (own - cold)).sum()) * unit
    exchange = supply_exchange(film, scales, thermal, order)
    back, returned = float(exchange.heat.sum()) * unit, float((exchange.heat * exchange.back).sum()) * unit
    sides = float(film.end_flows.sum()) + film.side_inflow
    bush, journal = thermal.bush_heat(), float(thermal.walls.journal[1])
    dissipation = thermal.dissipation * thermal.rise * unit
    edges = np.concatenate(([0.0], np.cumsum(columns.layer)))
    half = 0.5 * film.film.width
    mesh = thermal.sample.ring.mesh
    inner = mesh.nodes[mesh.between_sides] * half
    resolved = columns.size.size > 1
    wall, shaft = thermal.wall_temperatures()
    return ThermalFilm(
        film=film,
        axial_positions=inner if resolved else np.zeros(1),
        layers=0.5 * (edges[1:] + edges[:-1]),
        temperature=thermal.temperature.copy(),
        supply_temperature=cold,
        side_temperature=float(cold + (over_sides + back - returned) * scales.flow / (unit * sides))
        if sides > 0.0
        else cold,
        groove_temperatures=exchange.temperature[list(order)],
        fresh_flow=exchange.fresh[list(order)] * scales.flow,
        returned_flow=exchange.surplus[list(order)] * exchange.back[list(order)] * scales.flow,
        bush_temperature=wall,
        bush_flux=thermal.walls.bush_flux.copy(),
        journal_temperature=shaft,
        insulated=thermal.walls.insulated,
        heat=HeatSplit(dissipation, over_sides + back, bush, journal, returned),
        effective_viscosity=thermal.reference_viscosity * thermal.effective_viscosity,
    )


def side_oil(thermal: ThermalFilmState) -> tuple[Array, Array]:
    """What leaves over the sides, dimensionless, and how warm it is, K, both (lines, columns)."""
    flows = thermal.flows
    profile = flows.pressure_profile[np.arange(flows.leak.shape[0]) % flows.pressure_profile.shape[0]]
    return np.maximum(flows.leak, 0.0), np.asarray((profile * thermal.temperature).sum(axis=2))


@dataclass(frozen=True)
class SupplyExchange:
    """What every supply gives and takes, dimensionless but for its temperature, in the order of the ring.

    Attributes
    ----------
    temperature : ndarray
        Mixed, K.
    fresh : ndarray
        Fresh oil given.
    surplus, heat : ndarray
        Oil that the film brings and does not take again, and its heat above that of fresh oil.
    back : ndarray
        Share of it that goes back into the supply; the rest leaves over the ends of the groove.
    """

    temperature: Array
    fresh: Array
    surplus: Array
    heat: Array
    back: Array


def supply_exchange(
    film: FilmSolution, scales: Scales, thermal: ThermalFilmState, order: Sequence[int]
) -> SupplyExchange:
    """Flows of the supplies of a film, from the balance of the oil that they mix.

    Of what leaves over the ends of a groove, the warm oil that the next film does not take goes first; the rest is
    fresh oil that has not mixed.
    """
    grooves, carried, cold = thermal.groove.size, thermal.heat.carry_over, thermal.heat.supply_temperature
    surface, columns = thermal.sample.ring.surface, thermal.columns
    brought, taken, enthalpy = supply_balances(surface, columns, thermal.flows, thermal.temperature, grooves)
    surplus = np.maximum(carried * brought - taken, 0.0)
    balance = np.array([
        (1.0 - carried) * brought + surplus,
        (1.0 - carried) * (enthalpy - brought * cold) + surplus * (thermal.groove - cold),
        np.maximum(taken - carried * brought, 0.0),
        thermal.groove,
    ])  # fmt: skip
    ring = thermal.sample.ring
    if len(ring.mesh.side_nodes) == 1:  # one of two images in the mid-plane is not seen
        images = twins(film.film, len(ring.groove_lines))
        unseen = np.bincount(columns.supply.ravel() + 1, minlength=grooves + 1)[1:] == 0
        balance[3, unseen] = balance[3, images][unseen]
        balance[:3] = 0.5 * (balance[:3] + balance[:3, images])
    out, heat, added, temperature = balance
    net = np.zeros(grooves)
    net[list(order)] = film.supply_flow / scales.flow
    ends = net - added + out
    over_ends = np.clip(ends, 0.0, out)
    back = 1.0 - np.divide(over_ends, out, out=np.ones(grooves), where=out > 0.0)
    return SupplyExchange(temperature, net + out * back, out, heat, back)
