"""What a pad with its own temperatures carries over the thickness of its film."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.design.pad_heat import Temperatures
from babbitt.kinds.thrust.failures import NoPadFilmError, ThermalRunawayError
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.pad_attitude import PARALLEL, PadTilt
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.tabulated import TabulatedFilms
from babbitt.kinds.thrust.thermal import InitialState, PadOil, thermal_pad

__all__ = ["ThermalLoadCurve", "own_temperatures", "thermal_load_curve"]

Array = NDArray[np.float64]

THIN, THICK, COUNT = 0.25, 8.0, 15
"""Films at which pads are tabulated, over the film of the mean load, and how many."""
SAME = 1e-12
"""Of a height or load that is that of the middle pad."""


@dataclass(frozen=True, eq=False)
class ThermalLoadCurve:
    """Films with their own temperatures: not similar, and at one speed in one oil.

    Attributes
    ----------
    middle : InitialState
        The pad under the mean load. Others are tabulated about it when they are asked for.
    """

    middle: InitialState

    @property
    def pad(self) -> ThrustPad:
        """The pad."""
        return self.middle.state.pad

    @property
    def oil(self) -> PadOil:
        """Its oil."""
        return self.middle.oil

    @property
    def viscosity(self) -> float:
        """Effective one of the middle pad, Pa s."""
        return self.middle.state.viscosity

    @property
    def angular_speed(self) -> float:
        """Of the runner, rad/s."""
        return self.middle.state.angular_speed

    @cached_property
    def starts(self) -> tuple[InitialState, ...]:
        """Solved pads, thin films first."""
        height = self.middle.state.height
        around = height * np.geomspace(THIN, THICK, COUNT)
        thick = _outward(self.middle, around[around > height])
        thin = _outward(self.middle, around[around < height][::-1])
        return (*thin[::-1], self.middle, *thick)

    @cached_property
    def table(self) -> TabulatedFilms:
        """Loads over the film."""
        states = [start.state for start in self.starts]
        if len(states) < 4:
            raise ThermalRunawayError
        return TabulatedFilms.of(states, self.viscosity, self.angular_speed)

    def load(self, height: Array) -> Array:
        """W by the table."""
        return self.table.load(height)

    def slope(self, height: Array) -> Array:
        """dW/dh."""
        return self.table.slope(height)

    def height_for(self, load: float) -> float:
        """Height at a load: exact, or by the table continued where no such film exists."""
        if abs(load / self.middle.state.load - 1.0) < SAME:
            return self.middle.state.height
        near = min(self.starts, key=lambda start: abs(np.log(start.state.load / load)))
        begin = float(near.state.height * (near.state.load / load) ** 0.6)
        try:
            return thermal_pad(self.pad, self.oil, self.angular_speed, begin, load, near).state.height
        except (InputError, NoPadFilmError):
            return begin

    def state(self, height: float, lean: PadTilt = PARALLEL, near: PadState | None = None) -> PadState:
        """The film at a height, solved."""
        if abs(height / self.middle.state.height - 1.0) < SAME and not any(lean):
            return self.middle.state
        start = min(self.starts, key=lambda start: abs(np.log(start.state.height / height)))
        return thermal_pad(self.pad, self.oil, self.angular_speed, height, None, start, lean=lean).state

    def at(self, viscosity: float, angular_speed: float) -> ThermalLoadCurve:
        """The same films at another speed; viscosity is their own."""
        return thermal_load_curve(self.pad, self.oil, angular_speed, self.middle.state.height)


def thermal_load_curve(
    pad: ThrustPad, oil: PadOil, angular_speed: float, height: float, load: float | None = None
) -> ThermalLoadCurve:
    """Films of a pad around one of them; heat capacity and conductivity at its mean temperature.

    Parameters
    ----------
    pad : ThrustPad
    oil : PadOil
    angular_speed : float
        rad/s.
    height : float
        Film of a pad that carries the mean load, m; with ``load`` where its search begins.
    load : float, optional
        Mean load of a pad, N.

    Raises
    ------
    InputError
        E202 if no tilt balances the pad.
    ThermalRunawayError
    """
    first = thermal_pad(pad, oil, angular_speed, height, load)
    heat = first.state.heat
    assert heat is not None
    oil = replace(oil, property_temperature=0.5 * (heat.inlet + heat.trailing))
    return ThermalLoadCurve(thermal_pad(pad, oil, angular_speed, first.state.height, load, first))


def _outward(start: InitialState, heights: Iterable[float]) -> list[InitialState]:
    """Films each begun from the one before, as far as there are any that carry more when thinner."""
    found: list[InitialState] = []
    near = start
    for height in heights:
        oil, pad = near.oil, near.state.pad
        try:
            new = thermal_pad(pad, oil, near.state.angular_speed, float(height), None, near)
        except (InputError, NoPadFilmError):
            break
        if not (new.state.load - near.state.load) * (near.state.height - height) > 0.0:
            break
        found.append(new)
        near = new
    return found


def own_temperatures(oil: PadOil, states: tuple[PadState, ...], sense: float = 0.0) -> Temperatures:
    """Temperatures of pads with their own ones, K: means weighted with the flow, and the fresh oil in m3/s.

    Parameters
    ----------
    oil : PadOil
        Of the bearing.
    states : tuple of PadState
    sense : float
        1 or -1 where each pad takes in what the pad before, or behind, sends off; 0: what its like sends off.
    """
    heats = [state.heat for state in states if state.heat is not None]
    assert len(heats) == len(states)
    entering = np.array([state.leading_flow for state in states])
    leaving = np.array([state.trailing_flow for state in states])
    aside = np.array([state.side_flow for state in states])
    kept = np.minimum(oil.carry_over * leaving, np.roll(entering, -int(sense)))
    fresh = float(entering.sum() - kept.sum())
    side, sent = (np.array([getattr(heat, name) for heat in heats]) for name in ("side", "sent"))
    cold = oil.supply_temperature
    capacity = oil.heat().volumetric_heat_capacity
    drained = float((aside * (side - cold) + (leaving - kept) * (sent - cold)).sum())
    power = sum(heat.heat.dissipation for heat in heats)
    inlet, trailing = (
        float(np.average([getattr(heat, name) for heat in heats], weights=flow))
        for name, flow in (("inlet", entering), ("trailing", leaving))
    )
    powers = np.array([state.friction_power for state in states])
    viscosity = float(powers.sum() / (powers / np.array([state.viscosity for state in states])).sum())
    return Temperatures(
        cold,
        inlet,
        trailing,
        _temperature_at(oil, viscosity, inlet, max(heat.maximum for heat in heats)),
        cold + drained / fresh,
        fresh,
        capacity * drained / power - 1.0,
    )


def _temperature_at(oil: PadOil, viscosity: float, low: float, high: float) -> float:
    """Temperature at which the oil has a viscosity, between two, K."""
    from babbitt.numerics.roots import bracketed_root

    def excess(temperature: float) -> float:
        return float(np.log(oil.lubricant.dynamic_viscosity(temperature) / viscosity))

    if not excess(low) > 0.0 > excess(high):
        return low if abs(excess(low)) < abs(excess(high)) else high
    return bracketed_root(excess, low, high, absolute=1e-6)
