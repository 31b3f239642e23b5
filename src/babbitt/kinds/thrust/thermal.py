"""Pads whose films have their own temperatures: tilt, height and heat at rest beside each other.

Every pass is one of Reynolds and energy equation and one Newton step of the pad on its stiffness at frozen
temperatures (`babbitt.reynolds.sector.thermal_sector`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

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
from babbitt.properties.lubricants import Lubricant

if TYPE_CHECKING:
    from babbitt.reynolds.heat.heat_model import FilmHeat
    from babbitt.reynolds.sector.thermal_sector import ThermalSectorState

__all__ = ["PadOil", "InitialState", "warm_pad"]

Array = NDArray[np.float64]

MOST_PASSES = 300
SETTLED = 1e-4
"""Change of temperature in a pass, K, at which film, pad and temperature rest beside each other."""
BALANCED = 1e-6
"""Of forces and moments over the load, with it."""
MOVED = 0.4
"""Largest change of the logarithm of the height in a step."""
POLISH = 12
MAX_STALLED_PASSES, NEARLY_SETTLED, NEARLY_BALANCED = 120, 5e-2, 2e-4
"""Passes after which a film whose rupture goes to and fro between two lines is let be, at which change of
temperature, K, and which miss of forces over the load."""
KEPT, HALVINGS = 0.3, 40
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
    """A pad that rests, from which another one is begun."""

    oil: PadOil
    state: PadState
    sector: ThermalSectorState


def warm_pad(
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
        If no tilt balances the pad, or its film does not settle.
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
    except NoFilmError:
        raise ThermalRunawayError from None
    except UnsettledPadError:
        if not sector.warm.temperature.max() < hottest:
            raise ThermalRunawayError from None
        raise
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
    """Passes until film, temperatures and pad rest; then the pad alone, exactly, at frozen temperatures."""
    free = list(pad.free_tilts) if load is None else [0, *pad.free_tilts]
    to_film, width = pad.from_pivot(), pad.outer_radius - pad.inner_radius
    scale = np.array([1.0, width, width])
    sought = np.zeros(3) if load is None else np.array([load, 0.0, 0.0])
    polishing, share, last = 0, 1.0, np.zeros(3)
    cost = _cost_of_pass(sector.warm.heat.grid.resolved)
    for passes in range(MOST_PASSES):
        spend(cost)
        change = 0.0
        if polishing:
            sector.carry(to_film @ motion)
        else:
            change = sector.advance(to_film @ motion)
        forces = to_film.T @ sector.forces
        left = forces - sought
        miss = float((np.abs(left[free]) / scale[free]).max(initial=0.0)) / max(
            abs(forces[0]), abs(sought[0]), 1e-300
        )
        if not np.isfinite(miss) or np.isnan(change):
            break
        if passes > MAX_STALLED_PASSES and change < NEARLY_SETTLED and miss < NEARLY_BALANCED:
            return motion
        if polishing or (change < SETTLED and miss < BALANCED):
            polishing += 1
            if miss < MOMENT_TOLERANCE or not free:
                return motion
            if polishing > POLISH:
                break
        stiffness = to_film.T @ sector.stiffness @ to_film
        step = np.zeros(3)
        try:
            step[free] = np.linalg.solve(stiffness[np.ix_(free, free)], left[free])
        except np.linalg.LinAlgError:
            break
        share = _calmer(share, step, last) if polishing == 0 and passes > CALM else 1.0
        moved = _moved(pad, sector, motion, share * step)
        if moved is None:
            break
        motion, last = moved, step
    raise UnsettledPadError


def _cost_of_pass(resolved: bool) -> float:
    """Units of work; temperatures that vary across the pad take three times that of means over its width."""
    return 3.0 if resolved else 1.0


def _calmer(share: float, step: Array, last: Array) -> float:
    """Share of a step that is taken: less where steps go to and fro."""
    return max(0.6 * share, LEAST_SHARE) if float(step @ last) < 0.0 else min(1.3 * share, 1.0)


def _moved(pad: ThrustPad, sector: ThermalSectorState, motion: Array, step: Array) -> Array | None:
    """The pad after a step that neither flies off nor takes most of the least gap; None: nowhere."""
    growth = float(np.clip(step[0] / motion[0], -0.9, None))
    if abs(np.log1p(growth)) > MOVED:
        step = step * (np.expm1(np.copysign(MOVED, growth)) / growth)
    to_film = pad.from_pivot()
    least = KEPT * sector.least_gap(to_film @ motion)
    for _ in range(HALVINGS):
        new = motion + step
        if new[0] < FARTHEST * sector.height and sector.least_gap(to_film @ new) > least > 0.0:
            return np.asarray(new)
        step = 0.5 * step
    return None
