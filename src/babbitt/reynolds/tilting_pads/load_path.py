"""Journal and pads on flexures along a path of equilibria, where the tilts of pads jump.

At one place of the journal a pad on a flexure may have several tilts. The search for the journal (``_pads``) takes
a stable one; where that ends as the journal moves on, the pad jumps to another and its force with it, and the load
may lie between both. Under a load that grows from what the films carry to the whole of it, journal, tilts and
pivots move together and nothing jumps: a pad may then stand where it would tip over around a journal that is held,
and the bearing is stable all the same, as the journal gives way. The path is followed by its length, which it
passes turning points by. Method: E. Riks, Int. J. Solids Struct. 15 (1979) 529.

Unknowns are x, y of the journal, then eta and e of every pad. Equations: the forces on the journal, the moments of
the pads about their pivots, and e + u(W) = e with a rigid pivot.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigvals

from babbitt.reynolds._structs import Axial, Grid
from babbitt.reynolds.tilting_pads._pads import CONVERGED, STUCK, TOO_MANY_STEPS, TOUCH, WORK, find_pads
from babbitt.reynolds.tilting_pads._pivot_curve import pivot_curve
from babbitt.reynolds.tilting_pads._place import hold_pads, new_places, pads_at
from babbitt.reynolds.tilting_pads._structs import PadPlaces, Pads
from babbitt.reynolds.tilting_pads._tilt import EDGE_WIDTH, LOADED

__all__ = ["Found", "journal_among_pads"]

Array = NDArray[np.float64]

SEARCHED_AGAIN = (STUCK, TOO_MANY_STEPS, WORK, TOUCH)
"""Ends of the search for the journal behind which a path may still lead to the load."""
SHARES = (1.0, 0.9, 0.6, 0.3)
"""Of the way to where that search ended: journals around which tilts begin paths of their own."""
FIRST_LENGTH, LONGEST, SHORTEST = 0.02, 0.2, 1e-6
"""Of a step along the path, the share of the load counted like a clearance."""
MOST_LENGTHS, CORRECTIONS, EASY = 120, 8, 3
"""Steps of a path, Newton steps behind each, and as many of them as let the next be longer."""
ASTRAY = 5.0
"""Times the step: a correction that is no correction any more."""
ON_PATH, AT_END = 1e-6, 1e-9
"""Forces and moments left over along the path and at its end, over the load."""
NEAR_EDGE = 2.0 * EDGE_WIDTH
"""Of the clearance: tilt to contact of an edge at the end of a path that steps cannot follow any closer."""
GROWING = 1e-9
"""Growth over the largest rate, below which a motion is one of round-off."""
INFINITE = 1e8
"""Rate over the speed: a motion that nothing damps."""


@dataclass(frozen=True, eq=False)
class Found:
    """Where a search left journal and pads: what ``find_pads`` returns."""

    at: Array
    status: int
    steps: int
    indifferent: bool
    grid: Grid


def journal_among_pads(
    axial: Axial, pads: Pads, intervals: int, load: Array, start: Array, tolerance: float, most: int,
    places: PadPlaces, total: Array,
) -> Found:  # fmt: skip
    """`find_pads`, and along paths of equilibria where that finds none of pads on flexures.

    ``places`` and ``total`` are those of the equilibrium, or of the search where no path leads to one. Where all
    paths end at an edge that touches the journal, so does the search.
    """
    x, y, status, steps, indifferent, grid = find_pads(
        axial, pads, intervals, load[0], load[1], start[0], start[1], tolerance, most, places, total
    )
    found = Found(np.array([x, y]), int(status), int(steps), bool(indifferent), grid)
    if found.status not in SEARCHED_AGAIN or not (pads.rotational > 0.0).all():
        return found
    touches, films = [], 0
    for at, begun in beginnings(axial, pads, intervals, found, places):
        path = LoadPath(axial, pads, grid, load, begun)
        end = path.followed(at)
        films += int(begun.films[0])
        if end is not None:
            place, tilts, ratios = np.split(end, (2, 2 + places.along.size))
            hold_pads(axial, pads, grid, *place, ratios, tilts, places, total)
            places.films[0] += films
            return Found(place, CONVERGED, found.steps + path.steps, False, grid)
        touches.append(path.touches)
    places.films[0] += films
    return replace(found, status=TOUCH) if touches and all(touches) else found


def beginnings(
    axial: Axial, pads: Pads, intervals: int, found: Found, places: PadPlaces
) -> Iterator[tuple[Array, PadPlaces]]:
    """Journals and pads that balance around them: as a search left them, and as found anew on the way there."""
    if (places.status == LOADED).all():
        copied = deepcopy(places)
        copied.films[0] = 0
        yield found.at, copied
    for share in SHARES:
        at, fresh = share * found.at, new_places(pads)
        is_open, is_found, _ = pads_at(axial, pads, intervals, *at, fresh, np.zeros(6))
        if is_open and is_found and (fresh.status == LOADED).all():
            yield at, fresh


@dataclass(eq=False)
class LoadPath:
    """Equilibria of journal and pads under the part of a load that grows from what films carry to all of it.

    ``places`` are those of pads that balance, where the path begins. ``room`` is the least way of an edge to
    contact at the last place tried, ``touches`` whether the path has come to one.
    """

    axial: Axial
    pads: Pads
    grid: Grid
    load: Array
    places: PadPlaces
    steps: int = 0
    room: float = math.inf
    touches: bool = False
    total: Array = field(default_factory=lambda: np.zeros(6))

    def followed(self, at: Array) -> Array | None:
        """Unknowns at the first equilibrium under the whole load if that is stable; ``at`` is where it begins."""
        z = np.concatenate([at, self.places.along, self.places.radial, [0.0]])
        equations = self.equations(z[:-1])
        self.touches = 0.0 < self.room < NEAR_EDGE
        if equations is None:
            return None
        offset, jacobian = equations  # what the films do not carry yet
        ahead = np.append(np.zeros(z.size - 1), 1.0)
        length, size = FIRST_LENGTH, math.hypot(*self.load)
        while self.steps < MOST_LENGTHS and length > SHORTEST:
            self.steps += 1
            tangent = solved(bordered(jacobian, offset, ahead), ahead_by_one(z.size))
            if tangent is None:
                return None
            tangent /= np.linalg.norm(tangent)
            last = tangent[-1] > 0.0 and z[-1] + length * tangent[-1] >= 1.0
            corrected = self.corrected(z, tangent, length, last, offset, size)
            if corrected is None:
                length *= 0.5
                continue
            z, jacobian, taken = corrected
            self.touches = self.room < NEAR_EDGE
            if last:
                return z[:-1] if self.is_stable(jacobian) else None
            ahead = tangent
            length = min(1.6 * length, LONGEST) if taken <= EASY else length
        return None

    def corrected(
        self, z: Array, tangent: Array, length: float, last: bool, offset: Array, size: float
    ) -> tuple[Array, Array, int] | None:
        """The equilibrium a step further, or that under the whole load, its Jacobian, and Newton steps taken."""
        if last:
            length = (1.0 - z[-1]) / tangent[-1]
        target, row = z + length * tangent, ahead_by_one(z.size) if last else tangent
        now, close = target.copy(), (AT_END if last else ON_PATH) * size + 1e-13
        for taken in range(CORRECTIONS):
            equations = self.equations(now[:-1])
            if equations is None:
                return None
            residual, jacobian = equations[0] - (1.0 - now[-1]) * offset, equations[1]
            if np.abs(residual).max() <= close:
                return now, jacobian, taken
            step = solved(bordered(jacobian, offset, row), -np.append(residual, row @ (now - target)))
            if step is None or np.linalg.norm(step) > ASTRAY * max(length, FIRST_LENGTH):
                return None
            now += step
        return None

    def equations(self, q: Array) -> tuple[Array, Array] | None:
        """What is left over of every equation, and how that changes with the unknowns; None without a film."""
        pads, count = self.pads, self.pads.kappa.size
        (x, y), eta, e = q[:2], q[2 : 2 + count], q[2 + count :]
        self.room = float(hold_pads(self.axial, pads, self.grid, x, y, e, eta, self.places, self.total))
        if not self.room > EDGE_WIDTH:
            return None
        answers, spring, c, s = self.places.answers, pads.rotational, pads.cosine, pads.sine
        pivots = self.pivots()
        back = spring * (eta - (y * c - x * s + pads.neutral))
        left = np.concatenate(
            [
                self.load + np.array([answers[:, 0] @ c - back @ s, answers[:, 0] @ s + back @ c]),
                answers[:, 1] - back,
                e + pivots[0] - self.places.rigid,
            ]
        )
        changes = self.film_changes(answers[:, 2:6], pivots[1])
        turned = np.stack([s, -c], axis=1)  # d(eta of the flexure's moment)/d(x, y)
        across = np.stack([-s, c], axis=1)
        tilts, ratios = slice(2, 2 + count), slice(2 + count, None)
        changes[:2, :2] += across.T @ (spring[:, None] * turned)
        changes[:2, tilts] += across.T * spring
        changes[tilts, :2] -= spring[:, None] * turned
        changes[tilts, tilts] -= np.diag(spring)
        changes[ratios, :2] -= np.stack([c, s], axis=1)
        changes[ratios, ratios] += np.eye(count)
        return left, changes

    def pivots(self) -> Array:
        """Displacement of every pivot and its slope, shape (2, pads)."""
        pads, loads = self.pads, -self.places.answers[:, 0]
        return np.array([
            pivot_curve(*curve, load) for *curve, load in zip(
                pads.curves, pads.loads, pads.displacements, loads, strict=True
            )
        ]).T  # fmt: skip

    def film_changes(self, answers: Array, flexible: Array) -> Array:
        """How forces of the films change the equations with e and eta, by stiffness, or with their rates, by
        damping, both of shape (pads, 4)."""
        count = flexible.size
        changes = np.zeros((2 + 2 * count, 2 + 2 * count))
        normal = np.stack([self.pads.cosine, self.pads.sine])
        tilts, ratios = slice(2, 2 + count), slice(2 + count, None)
        changes[:2, tilts], changes[:2, ratios] = -normal * answers[:, 1], -normal * answers[:, 0]
        changes[tilts, tilts], changes[tilts, ratios] = -np.diag(answers[:, 3]), -np.diag(answers[:, 2])
        changes[ratios, tilts] = np.diag(flexible * answers[:, 1])
        changes[ratios, ratios] = np.diag(flexible * answers[:, 0])
        return changes

    def is_stable(self, jacobian: Array) -> bool:
        """Whether slow motions of journal and pads, without inertia, all decay."""
        damping = self.film_changes(self.places.answers[:, 6:], self.pivots()[1])
        rates = eigvals(jacobian, -damping)
        rates = rates[np.isfinite(rates)]
        rates = rates[np.abs(rates) < INFINITE]
        return bool(np.all(rates.real <= GROWING * np.abs(rates).max(initial=1.0)))


def ahead_by_one(size: int) -> Array:
    """Unit vector of the share of the load, the last of the unknowns."""
    return np.append(np.zeros(size - 1), 1.0)


def bordered(jacobian: Array, offset: Array, row: Array) -> Array:
    """Jacobian with the column of the share of the load and a row of its own."""
    return np.vstack([np.column_stack([jacobian, offset]), row])


def solved(matrix: Array, right: Array) -> Array | None:
    """Solution of linear equations, or None of singular ones."""
    try:
        return np.asarray(np.linalg.solve(matrix, right))
    except np.linalg.LinAlgError:
        return None
