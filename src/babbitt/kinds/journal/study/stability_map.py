"""Where a rotor runs stable: the criterion of Routh and Hurwitz over load and speed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.whirl import mass_of_rotor
from babbitt.kinds.journal.study.film_points import FilmPoints, ProgressCallback, film_points, no_progress
from babbitt.kinds.journal.study.locus import spread
from babbitt.reynolds.stability.rotor import RIGID, growth_rates

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.isothermal import FilmState

__all__ = ["StabilityMap", "mass_number", "stability_map"]

Array = NDArray[np.float64]

LOADS, SPEEDS = 25, 33
"""Points of a map; odd, so that the operating point is one of them."""

EXPENSIVE_LOADS, EXPENSIVE_SPEEDS = 11, 17
"""The same for films that differ across the width."""

LOAD_SPAN, SPEED_SPAN = (0.2, 5.0), (0.2, 10.0)
"""Ends over the operating point, where none are given."""


@dataclass(frozen=True, eq=False)
class StabilityMap:
    """Stability of one rotor over load and speed.

    Attributes
    ----------
    loads, speeds : ndarray, shapes (n,) and (m,)
        N and rad/s, ascending.
    masses : ndarray, shape (n,)
        Of the rotor on the bearing, kg: that of the case, or under each load the one whose weight it is.
    shaft_stiffness : float
        N/m, infinite for a rigid rotor.
    growth : ndarray, shape (n, m)
        Rate of the least damped motion, 1/s: negative where the rotor runs stable, no number where there is no
        film.
    least_mass, critical_mass : ndarray, shape (n, m)
        Least and greatest mass of a rotor on this shaft that is stable, kg; zero and infinite where none whirls.
    points : FilmPoints
        The films, n m of them, the speeds of the first load first.
    """

    loads: Array
    speeds: Array
    masses: Array
    shaft_stiffness: float
    growth: Array
    least_mass: Array
    critical_mass: Array
    points: FilmPoints

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where the rotor is within the bounds of the stable masses, shape (n, m); false where there is no film.

        Every motion dies away there. `growth` says the same, but for a shaft that bends on a saddle with damping
        that feeds (det K < 0, det C < 0): the motion that grows is that of the journal, which has no mass there.
        """
        return np.asarray(self.reserve > 1.0)

    @property
    def reserve(self) -> Array:
        """How many times the mass of the rotor is within the nearer bound of the stable ones, shape (n, m)."""
        masses = np.broadcast_to(self.masses[:, None], self.critical_mass.shape)
        above = np.divide(masses, self.least_mass, out=np.full(masses.shape, np.inf), where=self.least_mass != 0.0)
        return np.asarray(np.minimum(self.critical_mass / masses, above))

    def thresholds(self) -> Array:
        """Lowest speed in the map above which the rotor whirls under each load, rad/s, shape (n,).

        Between the points the logarithm of the reserve is taken as linear in that of the speed; beside a speed at
        which no rotor whirls, or every one, the growth over the speed instead. No number where it does not begin
        to whirl within the map.
        """
        found = np.full(self.loads.shape, np.nan)
        steps = np.log(self.speeds)
        with np.errstate(divide="ignore"):
            short = -np.log(self.reserve)
        for row, rate in enumerate(self.growth / self.speeds):
            (begins,) = np.nonzero((rate[:-1] < 0.0) & (rate[1:] >= 0.0))
            if begins.size:
                ends = slice(begins[0], begins[0] + 2)
                low, high = short[row, ends]
                if not -np.inf < low < 0.0 <= high < np.inf:
                    low, high = rate[ends]
                found[row] = np.exp(steps[ends] @ [high, -low] / (high - low))
        return found


def stability_map(
    case: FilmCase,
    state: FilmState,
    loads: Iterable[float] | None = None,
    speeds: Iterable[float] | None = None,
    watch: ProgressCallback = no_progress,
) -> StabilityMap:
    """Find where a rotor in this film runs stable.

    Parameters
    ----------
    case : FilmCase
        Says the mass of the rotor (`rotor_mass`; without it the load is its weight) and the stiffness of the
        shaft.
    state : FilmState
        Its film at the operating point, whose clearance, viscosity and supply pressures are kept.
    loads, speeds : iterable of float, optional
        N and rad/s. From a fifth to five times the load and to ten times the speed of the operating point where
        none are given.
    watch : ProgressCallback
        Follows films that are solved one by one.

    Returns
    -------
    StabilityMap

    Notes
    -----
    The equation of motion, linear about the equilibrium, has a characteristic polynomial of fourth order (sixth on
    an elastic shaft). Its roots are found as eigenvalues; that all lie on the left is what the determinants of
    Routh and Hurwitz say. Source: Lund J.W., Thomsen K.K. (1978), A calculation method and data for the dynamic
    coefficients of oil-lubricated journal bearings, ASME.
    """
    film, dear = state.solution.film, state.solution.film.is_surface
    x = _ascending(loads, state.load, LOAD_SPAN, EXPENSIVE_LOADS if dear else LOADS)
    y = _ascending(speeds, abs(film.angular_speed), SPEED_SPAN, EXPENSIVE_SPEEDS if dear else SPEEDS)
    points = film_points(case, state, np.repeat(x, y.size), np.tile(y, x.size), watch)
    shape, shaft = (x.size, y.size), case.shaft_stiffness if case.shaft_stiffness is not None else RIGID
    masses = np.array([mass_of_rotor(case, float(load)) for load in x])
    growth = growth_rates(np.repeat(masses, y.size), points.stiffness, points.damping, shaft)
    least, greatest = (bound.reshape(shape) for bound in points.stable_masses(shaft))
    return StabilityMap(x, y, masses, shaft, growth.reshape(shape), least, greatest, points)


def mass_number(mass: float | Array, points: FilmPoints) -> Array:
    """Mass without dimension, m c ω²/F, of rotors in the films of some points, shape (n,)."""
    return np.asarray(mass * points.film.clearance * points.speeds**2 / points.loads)


def _ascending(given: Iterable[float] | None, here: float, span: tuple[float, float], count: int) -> Array:
    return spread(here, span, count) if given is None else np.array(sorted(set(given)), dtype=float)
