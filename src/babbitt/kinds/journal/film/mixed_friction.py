"""The journal between film and asperities: positions, friction and the speed at which surfaces begin to touch.

At each speed the journal stands where film and asperities carry the load together,
``F_film(x) + F_asperities(x) + W = 0``, both components of it. The film has the viscosity, clearance and supply
pressures of the operating point.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.result import Outcome
from babbitt.design.asperity_contact import AsperityContact
from babbitt.kinds.journal.film.field import between, centred_gap, inside, supply_patches
from babbitt.numerics.damped_newton import damped_newton
from babbitt.numerics.roots import find_root
from babbitt.numerics.scalar_or_array import Array

if TYPE_CHECKING:
    from babbitt.reynolds.model import JournalFilm, Resolution
    from babbitt.reynolds.solution import FilmSolution

__all__ = ["AsperityForce", "Asperities", "MixedPoint", "StribeckCurve", "mixed_point", "stribeck_curve"]

AROUND, ACROSS = 2880, 32
"""Places of the integral over the bore: equally spaced around, of Gauss and Legendre across."""

BALANCE = 1e-6
"""Residual force over load at which the journal is in equilibrium."""
MOST_STEPS = 40
"""Of one equilibrium; from a neighbour it takes three to six."""
KEPT_GAP = 0.4
"""Share of the least gap that a step leaves."""

STEP = 1.2
"""Ratio of neighbouring speeds of the curve."""
FASTEST, SLOWEST = 2.0, 1e-5
"""Ends of the curve over the operating speed; a journal that touches at twice its speed is followed further up."""
SEPARATED = 1e-4
"""Share of the load on asperities from which faster films are followed."""
FOLLOWED_UP_TO = 30.0
"""Times the operating speed, up to which separated surfaces are sought."""
BOUNDARY = 0.98
"""Share of the load on asperities at which the curve ends: boundary friction."""
THINNEST = 0.05
"""Least gap over σ at which the curve ends: asperities of rigid bodies do not carry the load."""
TRANSITION_SHARE = 0.01
"""Of the load, carried by asperities where mixed friction begins."""
SPEED_TOLERANCE = 1e-5
"""Relative, of the speed of transition."""


@dataclass(frozen=True, eq=False)
class AsperityForce:
    """What asperities do to the journal: force in N, ``-dF/dx`` in N/m, contact pressure times area in N."""

    force: Array
    stiffness: Array
    normal_load: float
    least_gap: float


class Asperities:
    """Asperities of a bore and its journal; grooves, pockets and holes have none."""

    def __init__(self, film: JournalFilm, contact: AsperityContact) -> None:
        self.contact = contact
        self._theta = np.linspace(0.0, 2.0 * math.pi, AROUND, endpoint=False)
        nodes, weights = np.polynomial.legendre.leggauss(ACROSS)
        z = 0.5 * film.width * nodes
        self._gap = centred_gap(film, self._theta, z)
        self._area = np.broadcast_to(weights, self._gap.shape) * (
            0.5 * film.width * math.pi * film.diameter / AROUND
        )
        for patch in supply_patches(film):
            self._gap[np.ix_(inside(self._theta, patch.theta), between(z, patch.z))] = math.inf
        self._normal = np.stack((np.cos(self._theta), np.sin(self._theta)))

    def gap(self, position: Array) -> Array:
        """Gap in m with the journal centre at a position in m, infinite over what feeds the film."""
        return np.asarray(self._gap - (position @ self._normal)[:, None])

    def least_gap(self, position: Array) -> float:
        """Least gap in m."""
        return float(self.gap(position).min())

    def at(self, position: Array) -> AsperityForce:
        """Integrate over the bore."""
        gap = self.gap(position)
        line = (self.contact.pressure(gap) * self._area).sum(axis=1)
        slope = (self.contact.stiffness(gap) * self._area).sum(axis=1)
        return AsperityForce(
            -self._normal @ line,
            np.asarray((self._normal * slope) @ self._normal.T),
            float(line.sum()),
            float(gap.min()),
        )


@dataclass(frozen=True, eq=False)
class MixedPoint:
    """The journal at one speed.

    Attributes
    ----------
    speed : float
        rad/s, its size.
    outcome : Outcome
        Read this first.
    film : FilmSolution
    asperities : AsperityForce
    load : float
        N.
    boundary_friction : float
        Coefficient where asperities touch.
    film_factor : float
        On the friction of the film.
    """

    speed: float
    outcome: Outcome
    film: FilmSolution
    asperities: AsperityForce
    load: float
    boundary_friction: float
    film_factor: float = 1.0

    @property
    def share(self) -> float:
        """Of the load, carried by asperities: the size of their force over the load."""
        return math.hypot(*self.asperities.force) / self.load

    @property
    def film_friction(self) -> float:
        """Friction coefficient by shear of the film alone."""
        return self.film_factor * self.film.friction_torque / (0.5 * self.film.film.diameter * self.load)

    @property
    def friction_coefficient(self) -> float:
        """Torque of film and asperities over radius and load."""
        return self.film_friction + self.boundary_friction * self.asperities.normal_load / self.load


class _Balance:
    """Load, film and asperities, as `damped_newton` asks for it."""

    no_room = Outcome.OVERLOADED
    too_many_steps = Outcome.NOT_CONVERGED

    def __init__(self, film: JournalFilm, load: Array, asperities: Asperities, grid: Resolution) -> None:
        self._film, self._load, self._asperities, self._grid = film, load, asperities, grid
        self.solution: FilmSolution | None = None
        self.contact: AsperityForce | None = None
        self._residual = load

    def room(self, at: Array) -> float:
        """Least gap over the clearance."""
        return self._asperities.least_gap(at) / self._film.clearance

    def kept_room(self, at: Array, room: float) -> float:
        """Part of the gap that is there."""
        return KEPT_GAP * room

    def look(self, at: Array, step: int) -> Outcome | None:
        """Solve the film there and add what asperities carry."""
        from babbitt.reynolds.equilibrium.position import film_at_position

        self.solution = film_at_position(self._film, (float(at[0]), float(at[1])), resolution=self._grid)
        self.contact = self._asperities.at(at)
        if not self.solution.outcome.solved:
            return self.solution.outcome
        self._residual = self.solution.force + self.contact.force + self._load
        balanced = math.hypot(*self._residual) <= BALANCE * math.hypot(*self._load)
        return Outcome.CONVERGED if balanced else None

    def move(self, at: Array, room: float) -> Array | None:
        """Step of Newton by the stiffness of both."""
        assert self.solution is not None
        assert self.contact is not None
        stiffness = self.solution.stiffness + self.contact.stiffness
        if not np.isfinite(stiffness).all() or abs(np.linalg.det(stiffness)) == 0.0:
            return None
        return np.asarray(np.linalg.solve(stiffness, self._residual), dtype=np.float64)


def mixed_point(
    film: JournalFilm, load: tuple[float, float], asperities: Asperities, start: Array, grid: Resolution
) -> MixedPoint:
    """Equilibrium of the journal between film and asperities.

    Parameters
    ----------
    film : JournalFilm
        At its speed.
    load : tuple of float
        Components in N.
    asperities : Asperities
    start : ndarray, shape (2,)
        Position in m from which the search begins.
    grid : Resolution
    """
    balance = _Balance(film, np.array(load), asperities, grid)
    end = damped_newton(balance, np.asarray(start, dtype=np.float64), MOST_STEPS)
    if balance.solution is None or balance.contact is None:
        balance.look(end.at, 0)
    assert balance.solution is not None
    assert balance.contact is not None
    friction = asperities.contact.friction
    size = math.hypot(*load)
    return MixedPoint(abs(film.angular_speed), end.status, balance.solution, balance.contact, size, friction)


@dataclass(frozen=True, eq=False)
class StribeckCurve:
    """Friction over speed with its mixed branch, the slowest first.

    Attributes
    ----------
    points : tuple of MixedPoint
        Converged ones only.
    operating : MixedPoint
        At the speed of the operating point; it may not have converged.
    transition_speed : float or None
        rad/s, at which asperities carry 1 % of the load; None where the curve does not reach it.
    ended : Outcome or None
        Why the curve ends before boundary friction: as the search for a slower journal ended, or OVERLOADED where
        the least gap is below `THINNEST` σ. None: it reaches boundary friction or the slowest speed.
    """

    points: tuple[MixedPoint, ...]
    operating: MixedPoint
    transition_speed: float | None
    ended: Outcome | None

    @property
    def least(self) -> MixedPoint:
        """The point of least friction."""
        return min(self.points, key=lambda one: one.friction_coefficient)


def stribeck_curve(
    solution: FilmSolution, contact: AsperityContact, grid: Resolution, film_factor: float = 1.0
) -> StribeckCurve:
    """Follow a journal from its film at the operating point to faster and slower speeds.

    Parameters
    ----------
    solution : FilmSolution
        Of the operating point, without asperities; the load is what it carries.
    contact : AsperityContact
    grid : Resolution
    film_factor : float
        On the friction of the film.
    """
    film = solution.film
    load = (-float(solution.force[0]), -float(solution.force[1]))
    asperities = Asperities(film, contact)
    here = abs(film.angular_speed)

    def at(speed: float, start: Array) -> MixedPoint:
        turning = replace(film, angular_speed=math.copysign(speed, film.angular_speed))
        return replace(mixed_point(turning, load, asperities, start, grid), film_factor=film_factor)

    operating = at(here, solution.position)
    if not operating.outcome.solved:
        return StribeckCurve((), operating, None, operating.outcome)
    faster: list[MixedPoint] = []
    last, speed = operating, here
    while speed < FASTEST * here or (last.share > SEPARATED and speed < FOLLOWED_UP_TO * here):
        speed *= STEP
        last = at(speed, last.film.position)
        if not last.outcome.solved:
            break
        faster.append(last)
    slower: list[MixedPoint] = []
    ended = None
    last, speed = operating, here
    while last.share < BOUNDARY and speed > SLOWEST * here:
        speed /= STEP
        found = at(speed, last.film.position)
        if not found.outcome.solved:
            ended = found.outcome
            break
        if found.asperities.least_gap < THINNEST * contact.roughness:
            ended = Outcome.OVERLOADED
            break
        slower.append(found)
        last = found
    points = (*reversed(slower), operating, *faster)
    return StribeckCurve(points, operating, _transition(points, at), ended)


def _transition(points: tuple[MixedPoint, ...], at: Callable[[float, Array], MixedPoint]) -> float | None:
    """Speed at which asperities carry `TRANSITION_SHARE` of the load, between two points of the curve."""
    around = (pair for pair in pairwise(points) if pair[0].share >= TRANSITION_SHARE > pair[1].share)
    slow, fast = next(around, (None, None))
    if slow is None or fast is None:
        return None

    def surplus(log_speed: float) -> float:
        found = at(math.exp(log_speed), slow.film.position)
        return math.log(max(found.share, 1e-12) / TRANSITION_SHARE) if found.outcome.solved else math.nan

    root = find_root(surplus, math.log(slow.speed), math.log(fast.speed), absolute=SPEED_TOLERANCE)
    return math.exp(root.value) if root.converged else None
