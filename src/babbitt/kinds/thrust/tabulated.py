"""Films of a pad with a face, a crown or turbulence over their thickness: none is similar to another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.equilibrium import UnbalancedPadError, leaning_state, pad_state
from babbitt.kinds.thrust.failures import ConcavePadError
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.pad_attitude import PARALLEL, PadTilt
from babbitt.kinds.thrust.state import PadState

__all__ = ["TabulatedFilms", "require_load", "tabulated"]

Array = NDArray[np.float64]

SAME = 1e-9
NARROW = 1e-5
"""Of the film: how well that on which a concave pad carries most is known."""
MOST_STEPS, EXACT = 40, 1e-10
"""Of the search for a height, and the change of the load, over it, that ends it."""
LEAST_TABLE = 4
"""Films that make a table."""
TABLE = (2e-6, 1e-3, 28)
"""Films at which pads are tabulated: thinnest and thickest over the outer radius, and how many."""


@dataclass(frozen=True, eq=False)
class TabulatedFilms:
    """Films of a pad with a face, a crown or turbulence: solved at many heights, a spline of ln W over ln h."""

    pad: ThrustPad
    heights: Array
    loads: Array
    slopes: tuple[tuple[float, float], ...]
    viscosity: float
    angular_speed: float

    @classmethod
    def of(cls, states: Sequence[PadState], viscosity: float, angular_speed: float) -> TabulatedFilms:
        """Table of solved films of one pad, thin ones first."""
        return cls(
            states[0].pad,
            np.array([state.height for state in states]),
            np.array([state.load for state in states]),
            tuple((state.slope_x, state.slope_y) for state in states),
            viscosity,
            angular_speed,
        )

    @cached_property
    def spline(self) -> Any:
        """ln W over ln h; beyond its ends straight."""
        from scipy.interpolate import CubicSpline

        return CubicSpline(np.log(self.heights), np.log(self.loads), bc_type="natural")

    def load(self, height: Array) -> Array:
        """W by the spline, continued with its end slopes."""
        return np.exp(self._logarithm(np.log(height))[0])

    def slope(self, height: Array) -> Array:
        """dW/dh."""
        value, slope = self._logarithm(np.log(height))
        return np.exp(value) * slope / height

    def _logarithm(self, at: Array) -> tuple[Array, Array]:
        inside = np.clip(at, np.log(self.heights[0]), np.log(self.heights[-1]))
        slope = self.spline(inside, 1)
        return self.spline(inside) + slope * (at - inside), slope

    def height_for(self, load: float) -> float:
        """Height at a load, exact: Newton on films, from the table."""
        height = self.nearest(load)
        for _ in range(MOST_STEPS):
            following = self.improved(height, self.state(height).load, load)
            if following is None:
                break
            height = following
        return height

    def nearest(self, load: float) -> float:
        """Height at a load between those of the table, in logarithms."""
        return float(np.exp(np.interp(-np.log(load), -np.log(self.loads), np.log(self.heights))))

    def improved(self, height: float, found: float, load: float) -> float | None:
        """Newton step in logarithms, where a film carries ``found``; None where that is the load, or nothing."""
        change = np.log(found / load) if found > 0.0 else 0.0
        if abs(change) < EXACT:
            return None
        at = np.array(height)
        power = height * float(self.slope(at)) / float(self.load(at))
        return height * float(np.exp(np.clip(-change / power, -0.5, 0.5)))

    def state(self, height: float, lean: PadTilt = PARALLEL, near: PadState | None = None) -> PadState:
        """The film at a height, solved."""
        place = int(np.argmin(np.abs(np.log(self.heights / height))))
        slopes = self.slopes[place]
        share = height / self.heights[place]
        if any(lean):
            along = slopes[1] * share if near is None else near.slope_y
            return leaning_state(self.pad, height, self.viscosity, self.angular_speed, along, lean)
        guess = (slopes[0] * share, slopes[1] * share)
        concave = self.pad.crown < 0.0 and self.pad.free_tilts
        if concave and height < self.heights[1] * (1.0 - SAME) and height < self.thinnest[0] * (1.0 - NARROW):
            raise ConcavePadError(self.pad.crown, self.thinnest[1])
        try:
            return pad_state(self.pad, height, self.viscosity, self.angular_speed, guess)
        except UnbalancedPadError:
            return pad_state(self.pad, height, self.viscosity, self.angular_speed)

    @cached_property
    def thinnest(self) -> tuple[float, float]:
        """Film on which a concave pad carries most, m, and its load, N; on thinner ones less, or none balances."""
        from scipy.optimize import minimize_scalar

        slopes, at = self.slopes[0], self.heights[0]

        def less(height: float) -> float:
            guess = (slopes[0] * height / at, slopes[1] * height / at)
            try:
                return -pad_state(self.pad, height, self.viscosity, self.angular_speed, guess).load
            except InputError:
                return 0.0

        bounds = (at * at / self.heights[1], self.heights[1])
        found = minimize_scalar(less, bounds=bounds, method="bounded", options={"xatol": NARROW * at})
        return float(found.x), float(-found.fun)

    def at(self, viscosity: float, angular_speed: float) -> TabulatedFilms:
        """Loads grow with viscosity and speed; a turbulent film is tabulated anew."""
        if self.pad.turbulence is not None:
            return tabulated(self.pad, viscosity, angular_speed)
        factor = viscosity * angular_speed / (self.viscosity * self.angular_speed)
        return TabulatedFilms(self.pad, self.heights, self.loads * factor, self.slopes, viscosity, angular_speed)


def tabulated(pad: ThrustPad, viscosity: float, angular_speed: float) -> TabulatedFilms:
    """Films from thick to thin, each from the tilt of the one before, as far as the pad balances.

    Parameters
    ----------
    pad : ThrustPad
    viscosity, angular_speed : float
        Pa s and rad/s, positive.

    Raises
    ------
    InputError
        E202 if no tilt balances the pad, or it carries nothing.
    """
    thinnest, thickest, count = TABLE
    states: list[PadState] = []
    guess: tuple[float, float] | None = None
    for height in np.geomspace(thickest, thinnest, count) * pad.outer_radius:
        state: PadState | None
        try:
            state = pad_state(pad, float(height), viscosity, angular_speed, guess)
        except InputError:
            state = None
        if state is None or not state.load > 0.0 or (states and state.load <= states[-1].load):
            if len(states) >= LEAST_TABLE:
                break
            # films far thicker than a crown hardly carry, and balance by accident only
            states.clear()
            guess = None
            continue
        states.append(state)
        share = (thinnest / thickest) ** (1.0 / (count - 1))
        guess = (state.slope_x * share, state.slope_y * share)
    if len(states) < LEAST_TABLE:
        pad_state(pad, 1e-4 * pad.outer_radius, viscosity, angular_speed)  # says why it does not balance
        require_load(pad, 0.0, 1e-4 * pad.outer_radius)
    return TabulatedFilms.of(states[::-1], viscosity, angular_speed)


def require_load(pad: ThrustPad, load: float, height: float) -> None:
    """Refuse a pad that carries nothing (load in N) at a height (m).

    Raises
    ------
    UnbalancedPadError
        E202.
    """
    if not load > 0.0:
        raise UnbalancedPadError(
            "E202",
            f"the pad carries nothing at a film of {height * 1e6:.0f} µm: a plane pad that cannot tilt, or "
            "stands on a pivot at its middle, has no converging film; give it a taper, a step, or a pivot "
            "farther back.",
        )
