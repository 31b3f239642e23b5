"""Pads each at the effective temperature of its own heat balance.

A pad that the housing leaves far from the collar lets much cold oil pass and makes no heat. What passes it never
enters the film of the pad that carries, so that one temperature for all would cool the tight pad with oil of the
idle ones. Each pad has the balance of `babbitt.kinds.thrust.heat` for itself,

    P = rho c dT (Q_t + Q_s / 2),    T_eff = T_in + dT / 2,

and takes in what the pad before it sends off (`babbitt.kinds.thrust.fed_pads`), or what a pad like itself sends
off:

    Q_in T_in = lambda Q_t (T_in + dT) + (Q_in - lambda Q_t) T_s.

The heat capacity is that at the effective temperature of a pad under the mean load: pads that share evenly have
the balance of all of them together, and what one pad sends off is what the next takes in.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.design.heat_balance import BOLD, NoFilmError, coolest_equilibrium
from babbitt.design.oil import highest_usable
from babbitt.design.pad_heat import HeatBalance, PadTemperatures, Temperatures, pad_temperatures
from babbitt.kinds.thrust.equilibrium import leaning_state, pad_state
from babbitt.kinds.thrust.failures import NoPadFilmError, ThermalRunawayError
from babbitt.kinds.thrust.heat import film_of
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.pad_attitude import PARALLEL, PadTilt
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.tabulated import MOST_STEPS, TabulatedFilms

__all__ = ["BalancedFilms", "temperatures_together"]

Array = NDArray[np.float64]

RANGE, COUNT = (0.01, 300.0), 160
"""Films at which plane pads are tabulated, over that of the mean load, and how many."""
POLICY = replace(BOLD, tolerance=1e-10)
"""How the effective temperature of a pad is sought."""
SAME = 1e-12
"""Of a height or load that is that of the pad under the mean load."""


@dataclass(frozen=True, eq=False)
class BalancedFilms:
    """Films at one speed in one oil, each with the temperature of its own balance.

    Attributes
    ----------
    films : LoadCurve
        At the viscosity of the pad under the mean load.
    balance : HeatBalance
    middle : PadState
        The pad under the mean load, or at the mean film.
    capacity : float
        rho c, J/(m3 K).
    """

    films: LoadCurve
    balance: HeatBalance
    middle: PadState
    capacity: float

    @property
    def pad(self) -> ThrustPad:
        """The pad."""
        return self.films.pad

    @property
    def viscosity(self) -> float:
        """Of the middle pad, Pa s."""
        return self.films.viscosity

    @property
    def angular_speed(self) -> float:
        """Of the runner, rad/s."""
        return self.films.angular_speed

    @cached_property
    def hottest(self) -> float:
        """Up to which a temperature is sought, K."""
        try:
            return highest_usable(self.balance.lubricant)
        except NoFilmError:
            raise ThermalRunawayError from None

    @cached_property
    def table(self) -> TabulatedFilms:
        """Loads over the film of pads fed by their like, as far as thinner films carry more."""
        tabulated = self.films.heights if isinstance(self.films, TabulatedFilms) else None
        around = self.middle.height * np.geomspace(*RANGE, COUNT) if tabulated is None else tabulated
        found: list[PadState] = []
        for height in around[::-1]:
            try:
                state = self.state(float(height))
            except (InputError, NoPadFilmError):
                if found:
                    break
                continue
            if found and not state.load > found[-1].load:
                break
            found.append(state)
        if len(found) < 4:
            raise ThermalRunawayError
        return TabulatedFilms.of(found[::-1], self.viscosity, self.angular_speed)

    def load(self, height: Array) -> Array:
        """W by the table."""
        return self.table.load(height)

    def slope(self, height: Array) -> Array:
        """dW/dh."""
        return self.table.slope(height)

    def height_for(self, load: float) -> float:
        """Height at a load: exact, or by the table continued where no such film exists."""
        if abs(load / self.middle.load - 1.0) < SAME:
            return self.middle.height
        height = self.table.nearest(load)
        with suppress(InputError, NoPadFilmError):
            for _ in range(MOST_STEPS):
                following = self.table.improved(height, self.state(height).load, load)
                if following is None:
                    break
                height = following
        return height

    def state(self, height: float, lean: PadTilt = PARALLEL, near: PadState | None = None) -> PadState:
        """The film at a height of a pad that takes in what its like sends off."""
        if abs(height / self.middle.height - 1.0) < SAME and not any(lean):
            return self.middle
        return self._balanced(height, lean, near, None)

    def fed(self, height: float, inlet: float, lean: PadTilt = PARALLEL, near: PadState | None = None) -> PadState:
        """The film at a height of a pad that takes in oil of a temperature, K.

        Raises
        ------
        ThermalRunawayError
            If friction outruns the oil up to the highest temperature for which it has data, at most 300 °C.
        InputError
            E202 if no tilt balances the pad, or it leans into the runner.
        """
        return self._balanced(height, lean, near, inlet)

    def at(self, viscosity: float, angular_speed: float) -> BalancedFilms:
        """The same films at another speed about the same height; viscosity is their own."""
        moved = replace(self, films=self.films.at(viscosity, angular_speed))
        middle = moved._balanced(self.middle.height, PARALLEL, None, None)
        return replace(moved, films=moved.films.at(middle.viscosity, angular_speed), middle=middle)

    def _balanced(self, height: float, lean: PadTilt, near: PadState | None, inlet: float | None) -> PadState:
        alike = None if self.pad.turbulence is not None else self.films.state(height, lean, near)

        def film(temperature: float) -> PadState:
            viscosity = float(self.balance.lubricant.dynamic_viscosity(temperature))
            if alike is not None:  # a laminar film of one shape, whatever the viscosity
                return alike.similar(height, viscosity, self.angular_speed)
            return self._turbulent(height, viscosity, lean, near)

        def film_at(temperature: float) -> tuple[PadState, PadTemperatures]:
            found = film(temperature)
            flows = found.friction_power, found.trailing_flow, found.side_flow
            return found, pad_temperatures(self.balance, self.capacity, *flows, inlet)

        def surplus(temperature: float, found: tuple[PadState, PadTemperatures]) -> float:
            return found[1].effective - temperature

        coolest = self.balance.supply_temperature if inlet is None else inlet
        state, temperatures = film_of(coolest_equilibrium(film_at, surplus, coolest, POLICY, self.hottest))
        return replace(state, balance=temperatures)

    def _turbulent(self, height: float, viscosity: float, lean: PadTilt, near: PadState | None) -> PadState:
        guess = self.middle if near is None else near
        share = height / guess.height
        if any(lean):
            along = guess.slope_y * share
            return leaning_state(self.pad, height, viscosity, self.angular_speed, along, lean)
        slopes = (guess.slope_x * share, guess.slope_y * share)
        return pad_state(self.pad, height, viscosity, self.angular_speed, slopes)


def temperatures_together(films: BalancedFilms, states: tuple[PadState, ...], sense: float = 0.0) -> Temperatures:
    """Temperatures of pads that differ, K: means weighted with the flow, and the fresh oil in m3/s.

    Parameters
    ----------
    films : BalancedFilms
    states : tuple of PadState
    sense : float
        1 or -1 where each pad takes in what the pad before, or behind, sends off; 0: what its like sends off.
    """
    pads = [state.balance for state in states if state.balance is not None]
    assert len(pads) == len(states)
    inlet, trailing, effective = (
        np.array([getattr(pad, name) for pad in pads]) for name in ("inlet", "trailing", "effective")
    )
    leaving, aside = (
        np.array([getattr(state, f"{name}_flow") for state in states]) for name in ("trailing", "side")
    )
    power = np.array([state.friction_power for state in states])
    entering = leaving + aside
    kept = np.minimum(films.balance.carry_over * leaving, np.roll(entering, -int(sense)))
    fresh = float((entering - kept).sum())
    cold = films.balance.supply_temperature
    drained = float((aside * (effective - cold) + (leaving - kept) * (trailing - cold)).sum())
    return Temperatures(
        cold,
        float(np.average(inlet, weights=entering)),
        float(np.average(trailing, weights=leaving)),
        float(np.average(effective, weights=power)),
        cold + drained / fresh,
        fresh,
        films.capacity * drained / float(power.sum()) - 1.0,
    )
