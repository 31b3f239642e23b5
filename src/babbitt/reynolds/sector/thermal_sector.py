"""Film of a thrust pad with its own temperatures: the energy kernels of the journal film in the sector's metric.

The pad lies between two grooves that are one: the oil that it sends over its trailing edge is what a pad like
itself sends to its leading edge, carried over in part and mixed with fresh oil. Pad and runner are insulated.
Every pass is one of Reynolds and energy equation (``thermal_film_state``); what moves the runner meanwhile is the
caller's.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.heat._heat_cells import groove_balance, new_cells
from babbitt.reynolds.heat._heat_flows import new_flows
from babbitt.reynolds.heat._heat_walls import Walls
from babbitt.reynolds.heat.heat_model import FilmHeat, mean_over_layers
from babbitt.reynolds.heat.thermal_film_state import ThermalFilmState, columns_of, drains_of, line_widths
from babbitt.reynolds.heat.thermal_solution import HeatSplit, side_oil
from babbitt.reynolds.model import Cavitation
from babbitt.reynolds.sector._sector_surface import sector_mesh, sector_surface
from babbitt.reynolds.sector.sector import SectorFilm, SectorPad, motion_lengths, sector_answer
from babbitt.reynolds.surface.surface_equilibrium import Effort, SurfaceState
from babbitt.reynolds.surface.unwrapped_mesh import UnwrappedMesh

__all__ = ["SectorHeat", "ThermalSectorState"]

Array = NDArray[np.float64]

SWEEPS = 3
"""Of the energy equation in a pass."""
CLOSING, CLOSED = 400, 1e-9
"""Rounds that close the heat balance at most, and the change of temperature in K at which they end."""
EDGE = 0.25
"""First and last interval over the others: the heat of their outer halves goes to the grooves at once."""
GROOVE = 0


@dataclass(frozen=True, eq=False)
class SectorHeat:
    """Temperatures of a pad's film.

    Attributes
    ----------
    layers : ndarray, shape (layers,)
        Middle of the layers, 0 on the pad and 1 on the runner.
    radius : ndarray, shape (columns,)
        m; one column stands for the mean over the width.
    temperature : ndarray, shape (lines, columns, layers)
        K, of the film: at the trailing edge what arrives there.
    supply, inlet, trailing, side : float
        Of fresh oil, of the mixture that the pad takes in, and the means of what leaves it, K.
    sent : float
        Of what goes into the groove, with the heat of the film at its very edges, K.
    heat : HeatSplit
    effective_viscosity : float
        Uniform viscosity with the same friction by shear in the same gap, Pa s.
    """

    layers: Array
    radius: Array
    temperature: Array
    supply: float
    inlet: float
    trailing: float
    side: float
    sent: float
    heat: HeatSplit
    effective_viscosity: float

    @property
    def maximum(self) -> float:
        """Highest temperature in the film, K."""
        return float(self.temperature.max())

    @property
    def mean_temperature(self) -> Array:
        """Mean over the gap, K, shape (lines, columns)."""
        return mean_over_layers(self.temperature, self.layers)


@dataclass(eq=False)
class ThermalSectorState:
    """A pad between grooves, and its temperatures on their way.

    Attributes
    ----------
    pad : SectorPad
        ``viscosity`` is the unit of the calculation; that of the fresh oil.
    height : float
        Unit of the gap, m.
    unit : float
        Of the pressure, Pa.
    thermal : ThermalFilmState
    """

    pad: SectorPad
    height: float
    unit: float
    thermal: ThermalFilmState

    @classmethod
    def of(
        cls, pad: SectorPad, heat: FilmHeat, height: float, intervals: int = 64, degree: int = 8
    ) -> ThermalSectorState:
        """A pad whose film is at the supply temperature still.

        Parameters
        ----------
        pad : SectorPad
        heat : FilmHeat
            Without walls.
        height : float
            Of the order of the film, m.
        intervals, degree : int
            As `sector_film`.

        Raises
        ------
        InputError
            E101 for walls, turbulence, or oil under pressure at the leading edge.
        """
        for wrong, said in (
            (heat.walls is not None, "walls: the pad and the runner of a thermal pad film are insulated"),
            (pad.turbulence is not None, "turbulence: a thermal pad film is laminar"),
            (pad.leading_pressure > 0.0, "leading_pressure: the grooves beside a thermal pad film are open"),
        ):
            if wrong:
                raise InputError("E101", f"{said}.")
        pad = replace(pad, cavitation=Cavitation.MASS_CONSERVING)
        theta, mesh = _lines(pad, intervals), sector_mesh(pad, degree)
        unit = pad.viscosity * pad.angular_speed * (pad.outer_radius / height) ** 2
        surface = sector_surface(pad, theta, mesh, height, unit)
        last = theta.size - 1
        supply = np.full(surface.held.shape, -1, dtype=np.int64)
        supply[[0, last]] = GROOVE
        supply[:, list(mesh.side_nodes)] = -2
        ring = UnwrappedMesh(surface, theta, mesh, supply, ((0, 0), (last, last)))
        sample = SurfaceState.of(ring, Effort(np.inf))
        columns = columns_of(ring, heat)
        lines, count, layers = *columns.supply.shape, columns.layer.size
        cold, capacity = heat.supply_temperature, heat.volumetric_heat_capacity
        speed, radius = pad.angular_speed, pad.outer_radius
        thermal = ThermalFilmState(
            sample, heat, columns, new_flows(lines, theta.size - 1, count, layers),
            new_cells(lines, count, layers), np.full((lines, count, layers), cold), np.full(1, cold),
            _insulated(ring, heat, speed, height, capacity * speed * radius**2 * height), pad.viscosity,
            pad.viscosity * speed * (radius / height) ** 2 / capacity, 0.0, drains_of(ring),
            np.ones((lines, count, layers)), np.zeros((lines, count, layers)),
        )  # fmt: skip
        return cls(pad, height, unit, thermal)

    def start_from(self, before: ThermalSectorState) -> None:
        """Take over the temperatures of a film on the same lines."""
        self.thermal.temperature[:] = before.thermal.temperature
        self.thermal.groove[:] = before.thermal.groove

    def place(self, motion: Array) -> Array:
        """Position of the kernels, in which the gap closes, for (height, slope_x, slope_y) in m and 1."""
        return np.asarray(-(motion - np.array([self.height, 0.0, 0.0])) / motion_lengths(self.pad, self.height))

    def least_gap(self, motion: Array) -> float:
        """Least gap, m."""
        return self.thermal.sample.gap(self.place(motion)) * self.height

    def advance(self, motion: Array) -> float:
        """One pass of film and temperature; largest change of temperature, K (infinite while the film breaks
        up anew).
        """
        changed, change = self.thermal.advance(self.place(motion), SWEEPS, 8)
        return float(change) if changed == 0 else np.inf

    def carry(self, motion: Array) -> None:
        """Pressure alone, temperatures as they are."""
        self.thermal.sample.evaluate(self.place(motion))

    @property
    def forces(self) -> Array:
        """As `SectorFilm.forces`, of the last pass."""
        return np.asarray(-self.thermal.sample.force * self._levers * self._force)

    @property
    def stiffness(self) -> Array:
        """As `SectorFilm.stiffness`, temperatures frozen."""
        lengths = motion_lengths(self.pad, self.height)
        return np.asarray(self.thermal.sample.stiffness * np.outer(self._levers, 1.0 / lengths) * self._force)

    @property
    def _levers(self) -> Array:
        return np.array([1.0, self.pad.outer_radius, self.pad.outer_radius])

    @property
    def _force(self) -> float:
        return self.unit * self.pad.outer_radius**2

    def finish(self, motion: Array) -> tuple[SectorFilm, SectorHeat, float]:
        """Close the heat balance of a film at rest.

        Returns
        -------
        SectorFilm
            Coefficients at frozen temperatures.
        SectorHeat
        float
            Change of temperature in the last round, K.
        """
        thermal, pad = self.thermal, self.pad
        at = self.place(motion)
        thermal.sample.evaluate(at, smooth=True)
        thermal.gather(at)
        change = thermal.close(CLOSING, CLOSED)
        ring, sample = thermal.sample.ring, thermal.sample
        flow = pad.angular_speed * pad.outer_radius**2 * self.height
        power = self.unit * flow
        answers = (sample.force, sample.stiffness, sample.damping)
        scales = (ring.theta, ring.mesh, self.height, self.unit)
        torque = thermal.friction * power / pad.angular_speed
        lowest = sample.gap(at)
        film = sector_answer(pad, ring.surface, sample.work, answers, scales, lowest, torque, bool(change < 1e-4))
        return film, self._heat_of(), change

    def refed(self, supply: float) -> SectorHeat:
        """Temperatures of the film as it flows, fed with oil of another temperature, K; a small change."""
        thermal = self.thermal
        thermal.heat = replace(thermal.heat, supply_temperature=supply)
        thermal.walls = thermal.walls._replace(fresh=supply)
        thermal.close(CLOSING, CLOSED)
        return self._heat_of()

    def _heat_of(self) -> SectorHeat:
        thermal, pad = self.thermal, self.pad
        surface, columns = thermal.sample.ring.surface, thermal.columns
        leaving, own = side_oil(thermal)
        temperatures, sent, enthalpy = thermal.temperature[..., None], np.empty(1), np.empty(1)
        groove_balance(surface, columns, thermal.flows, 1.0, temperatures, GROOVE, sent)
        brought, taken = groove_balance(surface, columns, thermal.flows, 0.0, temperatures, GROOVE, enthalpy)
        out = float(leaving.sum())
        cold, carried = thermal.heat.supply_temperature, thermal.heat.carry_over
        drained = (1.0 - carried) * (sent[0] - brought * cold)
        drained += max(carried * brought - taken, 0.0) * (float(thermal.groove[GROOVE]) - cold)
        carried_off = (float((leaving * (own - cold)).sum()) + drained) * thermal.walls.flow_heat
        temperature = thermal.temperature.copy()
        temperature[-1] = temperature[-2]
        nodes = thermal.sample.ring.mesh.nodes[thermal.sample.ring.mesh.between_sides] * pad.outer_radius
        edges = np.concatenate(([0.0], np.cumsum(columns.layer)))
        return SectorHeat(
            layers=0.5 * (edges[1:] + edges[:-1]),
            radius=nodes if columns.size.size > 1 else np.array([0.5 * (pad.inner_radius + pad.outer_radius)]),
            temperature=temperature,
            supply=cold,
            inlet=float(thermal.groove[GROOVE]),
            trailing=float(enthalpy[0]) / brought if brought > 0.0 else cold,
            side=float((leaving * own).sum()) / out if out > 0.0 else cold,
            sent=float(sent[0]) / brought if brought > 0.0 else cold,
            heat=HeatSplit(thermal.dissipation * thermal.rise * thermal.walls.flow_heat, carried_off, 0.0, 0.0),
            effective_viscosity=pad.viscosity * thermal.effective_viscosity,
        )


def _lines(pad: SectorPad, intervals: int) -> Array:
    """Lines along the pad, even but for a short interval at either end."""
    step = np.ones(intervals)
    if not pad.form:  # the edges of a face lie on even lines
        step[[0, -1]] = EDGE
    theta = np.concatenate(([0.0], np.cumsum(step)))
    return np.asarray(theta / theta[-1] * pad.extent)


def _insulated(ring: UnwrappedMesh, heat: FilmHeat, speed: float, height: float, flow_heat: float) -> Walls:
    """No walls: heat goes with the oil."""
    lines, cold = ring.surface.held.shape[0], heat.supply_temperature
    one = np.ones(1)
    return Walls(
        insulated=True, conduction=heat.conductivity / (heat.volumetric_heat_capacity * speed * height**2),
        flow_heat=flow_heat, area=1.0, bush=np.full(lines, cold), bush_flux=np.zeros(lines), ambient=cold,
        journal=np.array([cold, 0.0, 0.0, cold]), journal_given=False, width=line_widths(ring, lines),
        analysis=np.zeros((1, lines)), synthesis=np.zeros((lines, 1)), admittance=0.0 * one, harmonics=0.0 * one,
        inverse=np.zeros((2, 2)), conductance=np.zeros(lines), fresh=cold, carry_over=heat.carry_over,
    )  # fmt: skip
