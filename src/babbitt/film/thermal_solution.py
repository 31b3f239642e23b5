"""What the thermal film answers, in SI."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.film._heat_cells import groove_balance
from babbitt.film.scales import Scales
from babbitt.film.solution import FilmSolution
from babbitt.film.warm_ring import WarmRing

__all__ = ["HeatSplit", "ThermalFilm", "sides_and_supplies", "thermal_film"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class HeatSplit:
    """Where the heat of a film goes, W.

    Attributes
    ----------
    dissipation : float
        Born in the film: friction power on the journal and what the supply pumps in.
    oil : float
        Carried off by the oil, over the sides and back into supplies.
    bush, journal : float
        Taken by the walls.
    """

    dissipation: float
    oil: float
    bush: float
    journal: float

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
        Of fresh oil, and the mean of what leaves over the sides, K.
    groove_temperatures : ndarray, shape (supplies,)
        Mixed, K.
    bush_temperature : ndarray, shape (lines,)
        On the bore, K.
    bush_flux : ndarray, shape (lines,)
        Into the bush, W/m2.
    journal_temperature : float
        K.
    heat : HeatSplit
    effective_viscosity : float
        Uniform viscosity with the same friction power in the same gap by shear, Pa s.
    """

    film: FilmSolution
    axial_positions: Array
    layers: Array
    temperature: Array
    supply_temperature: float
    side_temperature: float
    groove_temperatures: Array
    bush_temperature: Array
    bush_flux: Array
    journal_temperature: float
    heat: HeatSplit
    effective_viscosity: float

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
        edges = np.concatenate(([0.0], 0.5 * (self.layers[1:] + self.layers[:-1]), [1.0]))
        return np.asarray(self.temperature @ np.diff(edges))


def thermal_film(film: FilmSolution, scales: Scales, warm: WarmRing, order: Sequence[int]) -> ThermalFilm:
    """Temperatures and heat of a ring beside its film; ``order`` of its supplies in the bearing as given."""
    columns, unit = warm.columns, warm.walls.flow_heat
    cold = warm.heat.supply_temperature
    leaving, own, carried_off = sides_and_supplies(warm)
    bush, journal = warm.bush_heat(), float(warm.walls.journal[1])
    dissipation = warm.dissipation * warm.rise * unit
    out = float(leaving.sum())
    edges = np.concatenate(([0.0], np.cumsum(columns.layer)))
    half = 0.5 * film.film.width
    mesh = warm.sample.ring.mesh
    inner = np.delete(mesh.nodes, list(mesh.side_nodes)) * half
    resolved = columns.size.size > 1
    wall, shaft = warm.walls.bush.copy(), float(warm.walls.journal[0])
    if warm.walls.insulated:  # walls are as warm as the oil that touches them
        touching = warm.temperature[:, :, [0, -1]].mean(axis=1)
        wall, shaft = touching[:, 0].copy(), float(touching[:, 1] @ warm.walls.width / warm.walls.width.sum())
    return ThermalFilm(
        film=replace(film, friction_torque=warm.friction * scales.torque),
        axial_positions=inner if resolved else np.zeros(1),
        layers=0.5 * (edges[1:] + edges[:-1]),
        temperature=warm.temperature.copy(),
        supply_temperature=cold,
        side_temperature=float((leaving * own).sum() / out) if out > 0.0 else cold,
        groove_temperatures=warm.groove[list(order)],
        bush_temperature=wall,
        bush_flux=warm.walls.bush_flux.copy(),
        journal_temperature=shaft,
        heat=HeatSplit(dissipation, carried_off, bush, journal),
        effective_viscosity=warm.reference_viscosity * warm.friction / max(warm.unit_friction(), 1e-300),
    )


def sides_and_supplies(warm: WarmRing) -> tuple[Array, Array, float]:
    """What leaves over the sides, (lines, columns), how warm it is, K, and the heat that the oil carries off, W.

    Over the sides and back into supplies.
    """
    flows, columns, unit = warm.flows, warm.columns, warm.walls.flow_heat
    cold = warm.heat.supply_temperature
    profile = flows.pressure_profile[np.arange(flows.leak.shape[0]) % flows.pressure_profile.shape[0]]
    own = (profile * warm.temperature).sum(axis=2)
    leaving = np.maximum(flows.leak, 0.0)
    over_sides = float((leaving * (own - cold)).sum()) * unit
    back = 0.0
    for s in range(warm.groove.size):
        brought, enthalpy, taken = groove_balance(
            warm.sample.ring.surface, columns, flows, 1.0, warm.temperature, s
        )
        carried = warm.heat.carry_over
        back += (1.0 - carried) * (enthalpy - brought * cold) * unit
        back += max(carried * brought - taken, 0.0) * (warm.groove[s] - cold) * unit
    return leaving, own, over_sides + back
