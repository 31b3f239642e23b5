r"""Pressure, flow and friction of one segment of the film, in closed form over cumulative integrals.

With ``H = h/δ`` and ``P = p δ²/(μ v r)``, μ that of the segment:

.. math:: \frac{dP}{dθ} = \frac{6}{H^2} + \frac{C}{H^3}, \qquad
          Q = -\frac{v δ L C}{12}, \qquad
          A = \frac{μ v^2 r L}{δ} \left(4 \int \frac{dθ}{H} + \frac{C}{2} \int \frac{dθ}{H^2}\right)

The constant C follows from the pressures at both ends, or from free rupture (pressure and gradient vanish).
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.grooved_long_bearing.model import SegmentFilm

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Grid:
    """Nodes around the film, with the edges of the groove among them; `before` and `behind` are their places."""

    angles: Array
    cosine: Array
    sine: Array
    weights: Array
    before: int
    behind: int

    @classmethod
    def of(cls, film: SegmentFilm) -> Grid:
        """Equal intervals over a turn, from the start of the film on, and the exact edges."""
        edges = film.groove_edges() if film.groove is not None else ()
        exact = np.array([film.start, *edges])
        nodes = _with_exact(_even_nodes(film.cells), np.stack((exact, np.cos(exact), np.sin(exact))))
        steps = nodes[0, 1:] - nodes[0, :-1]
        if not steps.all():  # an edge upon a node, or a groove without width
            nodes = nodes[:, np.concatenate(([True], steps > 0.0))]
            steps = nodes[0, 1:] - nodes[0, :-1]
        angles, cosine, sine = nodes
        weights = np.zeros(angles.size)
        weights[:-1] += 0.5 * steps
        weights[1:] += 0.5 * steps
        before = behind = angles.size - 1
        if film.groove is not None:
            before, behind = (int(angles.searchsorted(edge)) for edge in edges)
        return cls(angles, cosine, sine, weights, before, behind)


@lru_cache(maxsize=8)
def _even_nodes(cells: int) -> Array:
    """Angles over a turn at equal intervals, their cosines and sines, as rows."""
    angles = np.linspace(0.0, 2.0 * math.pi, cells + 1)
    return np.stack((angles, np.cos(angles), np.sin(angles)))


def _with_exact(even: Array, exact: Array) -> Array:
    """Columns of exact nodes, in order of their angles, among those of the even ones behind the first of them."""
    places = even[0].searchsorted(exact[0], "right").tolist()
    parts = []
    for at, (first, last) in enumerate(itertools.pairwise((*places, even.shape[1]))):
        parts += [exact[:, at : at + 1], even[:, first:last]]
    return np.concatenate(parts, axis=1)


@dataclass(frozen=True, eq=False)
class Gap:
    """Film thickness over clearance at the nodes, and the integrals of its inverse powers from the start on."""

    thickness: Array
    once: Array
    twice: Array
    thrice: Array

    @classmethod
    def of(cls, grid: Grid, thickness: Array) -> Gap:
        """Trapezoidal integrals of 1/H, 1/H² and 1/H³."""
        inverse, half = 1.0 / thickness, 0.5 * np.diff(grid.angles)
        squared = inverse * inverse
        return cls(thickness, *(_cumulative(half, power) for power in (inverse, squared, squared * inverse)))


def _cumulative(half_steps: Array, values: Array) -> Array:
    found = np.zeros(values.size)
    np.cumsum(half_steps * (values[1:] + values[:-1]), out=found[1:])
    return found


@dataclass(frozen=True, eq=False)
class Segment:
    """Flow in one segment, without dimension.

    Attributes
    ----------
    first, last : int
        Places of its nodes, both included.
    pressure : ndarray
        P at these nodes.
    constant : float
        C, negative where oil flows with the journal.
    end : float
        Angle of its end: of the groove, or of rupture.
    friction : float
        ``4 ∫ dθ/H + C/2 ∫ dθ/H²``.
    ruptures : bool
        Whether it ends in a free rupture.
    """

    first: int
    last: int
    pressure: Array
    constant: float
    end: float
    friction: float
    ruptures: bool

    @property
    def flow(self) -> float:
        """Over v δ L."""
        return -self.constant / 12.0


def between(gap: Gap, grid: Grid, first: int, last: int, at_end: float) -> Segment | None:
    """Segment with pressure 0 at its first and `at_end` at its last node; None where that asks for suction."""
    one, two, three = (
        integral[first : last + 1] - integral[first] for integral in (gap.once, gap.twice, gap.thrice)
    )
    constant = float((at_end - 6.0 * two[-1]) / three[-1])
    pressure = 6.0 * two + constant * three
    if pressure.min() < -1e-9 * max(1.0, float(pressure.max())):
        return None
    friction = 4.0 * float(one[-1]) + 0.5 * constant * float(two[-1])
    return Segment(first, last, pressure, constant, float(grid.angles[last]), friction, False)


def to_rupture(gap: Gap, grid: Grid, first: int, last: int, at_start: float) -> Segment | None:
    """Segment with pressure `at_start` at its first node and a free rupture behind; None where there is none.

    A film that diverges from its first node on, with nothing pushing it, carries nothing and ends at once.
    """
    thickness = gap.thickness[first : last + 1]
    one, two, three = (
        integral[first : last + 1] - integral[first] for integral in (gap.once, gap.twice, gap.thrice)
    )
    excess = at_start + 6.0 * (two - thickness * three)
    carries = excess >= 0.0
    found = np.flatnonzero(carries[:-1] & (excess[1:] < 0.0) & (thickness[1:] > thickness[:-1]))
    if found.size == 0:
        return None
    at = int(found[-1])
    share = float(excess[at] / (excess[at] - excess[at + 1]))
    if at == 0 and at_start == 0.0:
        constant = -6.0 * float(thickness[0])
        pressure = np.zeros(thickness.size)
        return Segment(first, last, pressure, constant, float(grid.angles[first]), 0.0, True)

    def inside(values: Array) -> float:
        return float(values[at] + share * (values[at + 1] - values[at]))

    constant = -6.0 * inside(thickness)
    pressure = at_start + 6.0 * two + constant * three
    pressure[at + 1 :] = 0.0
    friction = 4.0 * inside(one) + 0.5 * constant * inside(two)
    end = inside(grid.angles[first : last + 1])
    return Segment(first, last, np.maximum(pressure, 0.0), constant, end, friction, True)
