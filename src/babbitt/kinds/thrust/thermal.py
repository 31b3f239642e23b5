"""Pads whose films have their own temperatures: tilt, height and heat in equilibrium.

Every pass is one of Reynolds and energy equation and one Newton step of the pad on its stiffness at frozen
temperatures (`babbitt.reynolds.sector.thermal_sector`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.design.heat_balance import NoFilmError
from babbitt.design.oil import bounded_viscosity, highest_usable
from babbitt.kinds.thrust.equilibrium import (
    MOMENT_TOLERANCE,
    UnbalancedPadError,
    first_motion,
    first_slopes,
    pad_state,
    sector_of,
    state_of_film,
)
from babbitt.kinds.thrust.failures import ThermalRunawayError, UnsettledPadError
from babbitt.kinds.thrust.pad import DEGREE, ThrustPad
from babbitt.kinds.thrust.pad_attitude import PARALLEL, PadTilt
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.work import spend
from babbitt.numerics.damped_newton import damped_newton
from babbitt.properties.lubricants import Lubricant

if TYPE_CHECKING:
    from babbitt.reynolds.heat.heat_model import FilmHeat
    from babbitt.reynolds.sector.thermal_sector import ThermalSectorState

__all__ = ["PadOil", "InitialState", "thermal_pad"]

Array = NDArray[np.float64]

MOST_PASSES = 300
SETTLED = 1e-4
"""Change of temperature in a pass, K, at which film, pad and temperature have converged."""
BALANCED = 1e-6
"""Of forces and moments over the load, with it."""
MOVED = 0.4
"""Largest change of the logarithm of the height in a step."""
POLISH = 12
MAX_STALLED_PASSES, NEARLY_SETTLED, NEARLY_BALANCED = 120, 5e-2, 2e-4
"""Passes after which a film whose rupture goes to and fro between two lines is let be, at which change of
temperature, K, and which miss of forces over the load."""
KEPT, HALVINGS = 0.3, 39
"""Least gap after a step over that before it, and how often a step is halved for it."""
FARTHEST = 1e3
"""Height over that of the start from which a pad has flown away."""
ITSELF = 5.0
"""Passes whose time the mesh of a film and the closing of its heat take."""
CALM, LEAST_SHARE = 40, 0.05
"""Passes after which steps that go to and fro are shortened, and their least share."""


@dataclass(frozen=True)
class PadOil:
    """Oil of a film with its own temperatures.

    Attributes
    ----------
    lubricant : Lubricant
    supply_temperature : float
        Of fresh oil, K.
    carry_over : float
        Share of the hot oil of a pad that enters the next one.
    resolved : bool
        Whether temperatures vary across the pad; else they are means over its width.
    property_temperature : float or None
        At which heat capacity and conductivity are taken, K; None: at the supply.
    """

    lubricant: Lubricant
    supply_temperature: float
    carry_over: float
    resolved: bool = False
    property_temperature: float | None = None

    @property
    def fresh_viscosity(self) -> float:
        """Pa s at the supply."""
        return float(self.lubricant.dynamic_viscosity(self.supply_temperature))

    def heat(self) -> FilmHeat:
        """Heat model of the film engine."""
        from babbitt.reynolds.heat.heat_model import FilmHeat, HeatGrid

        at = self.supply_temperature if self.property_temperature is None else self.property_temperature
        return FilmHeat(
            bounded_viscosity(self.lubricant),
            float(self.lubricant.volumetric_heat_capacity(at)),
            float(self.lubricant.conductivity(at)),
            self.supply_temperature,
            None,
            HeatGrid(resolved=self.resolved),
            self.carry_over,
        )


@dataclass(frozen=True, eq=False)
class InitialState:
    """A pad in equilibrium, from which another one is begun."""

    oil: PadOil
    state: PadState
    sector: ThermalSectorState


def thermal_pad(
    pad: ThrustPad,
    oil: PadOil,
    angular_speed: float,
    height: float,
    load: float | None = None,
    start: InitialState | None = None,
    intervals: int | None = None,
    degree: int = DEGREE,
    lean: PadTilt = PARALLEL,
) -> InitialState:
    """Film of a pad with its own temperatures, at a height of its pivot or under a load.

    Parameters
    ----------
    pad : ThrustPad
    oil : PadOil
    angular_speed : float
        rad/s, positive.
    height : float
        Film at the pivot, m; with a load where its search begins.
    load : float, optional
        N.
    start : InitialState, optional
        A pad nearby, with the same mesh.
    intervals, degree, lean
        As `babbitt.kinds.thrust.equilibrium.pad_state`.

    Raises
    ------
    InputError
        E201 if the height is not positive, E202 if the pad leans into the runner.
    ThermalRunawayError
        If the film has no temperature below the highest for which the oil has data, at most 300 °C.
    UnsettledPadError
        If no tilt balances the pad, or its film does not converge.
    """
    if not (np.isfinite(height) and height > 0.0):
        raise InputError("E201", f"film at the pivot is {height:g} m; it must be positive.")
    from babbitt.reynolds.sector.thermal_sector import ThermalSectorState

    spend(ITSELF * _cost_of_pass(oil.resolved))
    fresh = sector_of(pad, oil.fresh_viscosity, angular_speed)
    sector = ThermalSectorState.of(fresh, oil.heat(), height, intervals or pad.intervals, degree)
    if start is not None:
        sector.start_from(start.sector)
        share = height / start.state.height
        slopes = (start.state.slope_x * share, start.state.slope_y * share)
    else:
        slopes = _cold_slopes(pad, oil, angular_speed, height, lean)
    first = first_motion(pad, height, slopes, lean)
    try:
        hottest = highest_usable(oil.lubricant)
        motion = _at_rest(pad, sector, first, load)
    except UnsettledPadError:
        if not sector.thermal.temperature.max() < hottest:
            raise ThermalRunawayError from None
        raise
    except NoFilmError:
        raise ThermalRunawayError from None
    film, heat, change = sector.finish(pad.from_pivot() @ motion)
    if not heat.maximum < hottest:
        raise ThermalRunawayError
    if not change < SETTLED:
        raise UnsettledPadError
    state = state_of_film(pad, film, motion, heat.effective_viscosity, angular_speed)
    return InitialState(oil, replace(state, heat=heat), sector)


def _cold_slopes(
    pad: ThrustPad, oil: PadOil, angular_speed: float, height: float, lean: PadTilt
) -> tuple[float, float]:
    """Slopes of the pad in fresh oil, from which a search begins."""
    try:
        cold = pad_state(pad, height, oil.fresh_viscosity, angular_speed, lean=lean)
    except UnbalancedPadError:
        return first_slopes(pad, height)
    return cold.slope_x, cold.slope_y


def _at_rest(pad: ThrustPad, sector: ThermalSectorState, motion: Array, load: float | None) -> Array:
    """Passes until film, temperatures and pad converge; then the pad alone, exactly, at frozen temperatures."""
    ended = damped_newton(_PadEquilibrium(pad, sector, load), motion, MOST_PASSES, most_halvings=HALVINGS)
    if not ended.status:
        raise UnsettledPadError
    return ended.at


@dataclass(eq=False)
class _PadEquilibrium:
    """Equilibrium of a pad in a film that heats itself; see `babbitt.numerics.damped_newton.NewtonProblem`."""

    pad: ThrustPad
    sector: ThermalSectorState
    load: float | None
    polishing: int = 0
    share: float = 1.0
    passes: int = 0
    no_room: ClassVar[bool] = False
    too_many_steps: ClassVar[bool] = False

    def __post_init__(self) -> None:
        self.free = list(self.pad.free_tilts) if self.load is None else [0, *self.pad.free_tilts]
        self.to_film, self.cost = self.pad.from_pivot(), _cost_of_pass(self.sector.thermal.heat.grid.resolved)
        self.left, self.last = np.zeros(3), np.zeros(3)

    def room(self, at: Array) -> float:
        """Least gap, m; none where the pad has flown away."""
        return self.sector.least_gap(self.to_film @ at) if at[0] < FARTHEST * self.sector.height else 0.0

    def kept_room(self, at: Array, room: float) -> float:
        """A share of the gap."""
        return KEPT * room

    def look(self, at: Array, step: int) -> bool | None:
        """One pass, or the pressure alone, and the forces that are left."""
        spend(self.cost)
        change, self.passes = 0.0, step - 1
        if self.polishing:
            self.sector.carry(self.to_film @ at)
        else:
            change = self.sector.advance(self.to_film @ at)
        forces, width = self.to_film.T @ self.sector.forces, self.pad.outer_radius - self.pad.inner_radius
        sought, scale = np.array([self.load or 0.0, 0.0, 0.0]), np.array([1.0, width, width])
        self.left = forces - sought
        miss = float((np.abs(self.left[self.free]) / scale[self.free]).max(initial=0.0))
        miss /= max(abs(forces[0]), sought[0], 1e-300)
        if not np.isfinite(miss) or np.isnan(change):
            return False
        if self.passes > MAX_STALLED_PASSES and change < NEARLY_SETTLED and miss < NEARLY_BALANCED:
            return True
        if self.polishing or (change < SETTLED and miss < BALANCED):
            self.polishing += 1
            if miss < MOMENT_TOLERANCE or not self.free:
                return True
            if self.polishing > POLISH:
                return False
        return None

    def move(self, at: Array, room: float) -> Array | None:
        """Newton's step at frozen temperatures, shortened where steps go to and fro or change the height much."""
        stiffness, step = self.to_film.T @ self.sector.stiffness @ self.to_film, np.zeros(3)
        try:
            step[self.free] = np.linalg.solve(stiffness[np.ix_(self.free, self.free)], self.left[self.free])
        except np.linalg.LinAlgError:
            return None
        calming = self.polishing == 0 and self.passes > CALM
        self.share = _calmer(self.share, step, self.last) if calming else 1.0
        self.last, step = step, self.share * step
        growth = float(np.clip(step[0] / at[0], -0.9, None))
        if abs(np.log1p(growth)) > MOVED:
            step = step * (np.expm1(np.copysign(MOVED, growth)) / growth)
        return step


def _cost_of_pass(resolved: bool) -> float:
    """Units of work; temperatures that vary across the pad take three times that of means over its width."""
    return 3.0 if resolved else 1.0


def _calmer(share: float, step: Array, last: Array) -> float:
    """Share of a step that is taken: less where steps go to and fro."""
    return max(0.6 * share, LEAST_SHARE) if float(step @ last) < 0.0 else min(1.3 * share, 1.0)
