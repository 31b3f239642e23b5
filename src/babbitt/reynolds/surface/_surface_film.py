"""Kernels: nodes, gaps and film coefficients of a film that differs across its width (see ``_surface``).

One metric serves the unrolled journal and the sector of a thrust bearing: lines at angle theta, points across at
the radius r (1 for a journal, r/R for a sector), with r d theta the length along and the width across:

    flux along:  q = r g h/2 - h^3/(12 r f) dp/dtheta,    squeeze: r dh/dt,    flux across: r h^3/(12 f') p'

``share`` is r times the quadrature weight, ``along`` the weight over r. f and f' are the effective viscosities
along and across (turbulent films differ), g is twice the share of the surface speed that the mean flow has (1
unless the viscosity varies through the gap).

The gap follows the motions a_d of the runner: h = gap - sum_d a_d shape_d(theta) lever_d(r), for a journal
cos, sin (and zeta cos, zeta sin for tilt).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import bool_, float64, int64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inner
from babbitt.reynolds.lands._grids import FAR, GAUSS, NEAR, growth_to_rupture
from babbitt.reynolds.oil._turbulent_oil import thickened

Array = NDArray[float64]


class Surface(NamedTuple):
    """Nodes of one unrolled film, what is held there, and the gap of the centred runner. a, b: Gauss points."""

    nodes: int  # across the width
    points: int
    motions: int
    step: Array  # (n,)
    shape_a: Array  # shape_d at the Gauss points of every interval, (motions, n)
    shape_b: Array
    lever: Array  # lever_d of the points, (motions, points)
    gap_a: Array  # (n, points)
    gap_b: Array
    opening_a: Array  # rate of that gap by itself, without the motions, (n, points)
    opening_b: Array
    viscosity: Array  # over the reference viscosity, (n, points)
    drag: Array  # g, (n, points)
    turbulence: (
        Array  # Reynolds number at unit gap, onset, end; factors and exponents along, across, of shear; or empty
    )
    radius: Array  # r of the points, (points,)
    share: Array  # w_q r, (points,)
    along: Array  # w_q / r, (points,)
    node: NDArray[int64]  # node on which a point falls, (points,)
    slope: Array  # D, (points, nodes)
    held: NDArray[bool_]  # nodes at given pressure, (lines, nodes); n + 1 lines, or n when cyclic
    held_pressure: Array  # (lines, nodes)
    held_fill: Array  # liquid fraction of what a held node sends off, (lines, nodes)
    piezo: Array  # reduced pressure, pressure and slope between them; of a constant viscosity (3, 0)
    cyclic: bool
    reference: float  # pressure from which forces count: ambient above cavitation
    kappa: float
    speed: float
    conserving: bool


class SurfaceFilm(NamedTuple):
    """Coefficients on a surface and their derivatives with respect to the motions."""

    conductance: Array  # (n, nodes), summed over points with their share
    couette: Array  # (n, nodes)
    cubed: Array  # H_iq, (lines, points)
    conductance_d: Array  # (motions, n, nodes)
    couette_d: Array
    cubed_d: Array  # (motions, lines, points)
    squeeze: Array  # (lines, nodes)
    load: Array  # sum_q w_q int shape_d phi_i, (motions, lines, nodes)
    inlet: Array  # flux into a line that ruptures right behind a held node, (n, nodes)
    inlet_d: Array  # (motions, n, nodes)


class SurfaceWork(NamedTuple):
    """Wet set, solutions (pressure or void, then one adjoint per motion) and the factor of every line."""

    wet: NDArray[bool_]  # (lines, nodes)
    solution: Array  # (1 + motions, lines, nodes)
    swept: Array
    inverse: Array  # (lines, nodes, nodes)
    holds: NDArray[bool_]  # whether the column of a node stands for a pressure, (lines, nodes)
    counts: NDArray[bool_]  # whether the row of a node is a balance of flow, (lines, nodes)
    lower: Array  # (lines, nodes)
    upper: Array
    ending: Array
    pressure: Array  # reduced pressure, zero at dry nodes, (lines, nodes)
    stiffening: Array  # dp / d(reduced pressure), (lines, nodes)
    fill: Array  # liquid fraction, (lines, nodes)
    row: Array  # balance of every node: what flows off less what arrives, (lines, nodes)
    border: Array  # response to the values on line 0, (lines, nodes, nodes); cyclic only


def new_surface_film(surface: Surface) -> SurfaceFilm:
    """Coefficients for a surface, not filled yet: zero, as a gap that closes leaves them."""
    n, lines = surface.step.size, surface.held.shape[0]
    nodes, points, d = surface.nodes, surface.points, surface.motions
    return SurfaceFilm(
        np.zeros((n, nodes)), np.zeros((n, nodes)), np.zeros((lines, points)), np.zeros((d, n, nodes)),
        np.zeros((d, n, nodes)), np.zeros((d, lines, points)), np.zeros((lines, nodes)),
        np.zeros((d, lines, nodes)), np.zeros((n, nodes)), np.zeros((d, n, nodes)),
    )  # fmt: skip


def new_surface_work(surface: Surface) -> SurfaceWork:
    """Workspace for a surface, all nodes wet."""
    lines, nodes = surface.held.shape[0], surface.nodes
    d = 1 + surface.motions
    return SurfaceWork(
        np.ones((lines, nodes), np.bool_), np.zeros((d, lines, nodes)), np.zeros((d, lines, nodes)),
        np.zeros((lines, nodes, nodes)), np.ones((lines, nodes), np.bool_), np.ones((lines, nodes), np.bool_),
        np.zeros((lines, nodes)), np.zeros((lines, nodes)),
        np.zeros((lines, nodes)), np.zeros((lines, nodes)), np.ones((lines, nodes)), np.ones((lines, nodes)),
        np.zeros((lines, nodes)), np.zeros((lines if surface.cyclic else 1, nodes, nodes)),
    )  # fmt: skip


def liquid(fill: Array) -> Array:
    """Liquid fraction from 0 to 1: beside the edge of a streamer the elements of the width may undershoot by some
    per cent at single nodes, where there is next to no oil, and nodes that change sides for ever may overshoot."""
    return np.asarray(np.clip(fill, 0.0, 1.0))


@inner
def gap_at(surface, at, i, q):
    """Gap at the two Gauss points of interval i, at point q of the width."""
    ha, hb = surface.gap_a[i, q], surface.gap_b[i, q]
    for d in range(surface.motions):
        lift = at[d] * surface.lever[d, q]
        ha -= lift * surface.shape_a[d, i]
        hb -= lift * surface.shape_b[d, i]
    return ha, hb


@compiled
def smallest_surface_gap(surface, at):
    """Smallest gap at the Gauss points."""
    smallest = np.inf
    for q in range(surface.points):
        for i in range(surface.step.size):
            ha, hb = gap_at(surface, at, i, q)
            smallest = min(smallest, min(ha, hb))
    return smallest


@inner
def thickening(surface, viscosity, radius, gap, direction):
    """Effective over true viscosity of a turbulent film along (0) or across (1), and its d ln / d ln h, with
    Re = Re_1 r h / mu."""
    law = surface.turbulence
    if law.size == 0:
        return 1.0, 0.0
    return thickened(law, law[0] * radius * gap / viscosity, direction)


@inner
def inlet_reach(surface, i, q, gap, rise):
    """Growth of the gap behind a held node (``_grids.growth_to_rupture``); nothing behind one without pressure."""
    j = surface.node[q]
    if i >= surface.held.shape[0] or not surface.held[i, j]:
        return 0.0, 0.0, 0.0
    pressure, speed = surface.held_pressure[i, j], surface.speed * surface.drag[i, q]
    if not (pressure > 0.0 and speed > 0.0 and rise > 1e-12):
        return 0.0, 0.0, 0.0
    resistance = 3.0 * surface.viscosity[i, q] * surface.radius[q] ** 2 * surface.step[i] * speed
    return growth_to_rupture(gap, rise, resistance / pressure)


@inner
def surface_coefficients(surface, at, rate, film):
    """Fill the coefficients of the film at a position and velocity.

    Points of a line where gap and oil are what they are at the point before, and no supply is, share them.
    """
    n, lines, motions = surface.step.size, surface.held.shape[0], surface.motions
    points = surface.points
    for array in (film.conductance, film.couette, film.cubed, film.squeeze, film.inlet):
        array[:] = 0.0
    for array in (film.conductance_d, film.couette_d, film.cubed_d, film.load, film.inlet_d):
        array[:] = 0.0
    same = np.zeros(points, np.bool_)
    for q in range(1, points):
        same[q] = surface.radius[q] == surface.radius[q - 1]
        for d in range(motions):
            same[q] = same[q] and surface.lever[d, q] == surface.lever[d, q - 1]
    t, mean, near, far, inlet = 0.0, 0.0, 0.0, 0.0, 0.0
    of_motion = np.empty((motions, 7))
    for i in range(n):
        after, half = (i + 1) % lines, 0.5 * surface.step[i]
        fed = False
        for q in range(points):
            j, share, along, radius = surface.node[q], surface.share[q], surface.along[q], surface.radius[q]
            was_fed = fed
            fed = i < lines and surface.held[i, j] and surface.held_pressure[i, j] > 0.0
            mu, drag = surface.viscosity[i, q], surface.drag[i, q]
            if (
                fed or was_fed or not same[q] or surface.gap_a[i, q] != surface.gap_a[i, q - 1]
                or surface.gap_b[i, q] != surface.gap_b[i, q - 1] or mu != surface.viscosity[i, q - 1]
                or drag != surface.drag[i, q - 1]
            ):  # fmt: skip
                ha, hb = gap_at(surface, at, i, q)
                speed = surface.speed * drag
                fa, fa_h = thickening(surface, mu, radius, ha, 0)
                fb, fb_h = thickening(surface, mu, radius, hb, 0)
                ga, ga_h = thickening(surface, mu, radius, ha, 1)
                gb, gb_h = thickening(surface, mu, radius, hb, 1)
                over_a, over_b = 1.0 / ha, 1.0 / hb
                a2, b2 = fa * over_a * over_a, fb * over_b * over_b
                j3 = a2 * over_a + b2 * over_b
                t = 1.0 / (12.0 * half * mu * j3)
                mean = 0.5 * speed * (a2 + b2) / j3
                ha2, hb2 = half * ha * ha / (mu * ga), half * hb * hb / (mu * gb)
                near, far = NEAR * ha2 * ha + FAR * hb2 * hb, FAR * ha2 * ha + NEAR * hb2 * hb
                gap = ha - NEAR_END * (hb - ha)  # at the line where the interval begins
                reach, reach_gap, reach_growth = 0.0, 0.0, 0.0
                if fed:
                    reach, reach_gap, reach_growth = inlet_reach(surface, i, q, gap, (hb - ha) / (2.0 * GAUSS))
                inlet = 0.5 * speed * (gap + reach)
                for d in range(motions):
                    lever = surface.lever[d, q]
                    sa, sb = surface.shape_a[d, i] * lever, surface.shape_b[d, i] * lever
                    a3, b3 = sa * a2 * over_a, sb * b2 * over_b
                    j3_d = ((3.0 - fa_h) * a3 * over_a + (3.0 - fb_h) * b3 * over_b) / j3
                    j2_d = ((2.0 - fa_h) * a3 + (2.0 - fb_h) * b3) / j3
                    ca, cb = (3.0 - ga_h) * ha2 * sa, (3.0 - gb_h) * hb2 * sb
                    start, rise = sa - NEAR_END * (sb - sa), (sb - sa) / (2.0 * GAUSS)
                    start += reach_gap * start + reach_growth * rise
                    of_motion[d, 0], of_motion[d, 1] = -t * j3_d, 0.5 * speed * j2_d - mean * j3_d
                    of_motion[d, 2], of_motion[d, 3] = -NEAR * ca - FAR * cb, -FAR * ca - NEAR * cb
                    of_motion[d, 4] = -0.5 * speed * start
                    of_motion[d, 5], of_motion[d, 6] = half * (NEAR * sa + FAR * sb), half * (FAR * sa + NEAR * sb)
            film.conductance[i, j] += along * t
            film.couette[i, j] += share * mean
            film.cubed[i, q] += near
            film.cubed[after, q] += far
            entering, bounded = inlet, False
            if inlet > mean and not fed:  # while it opens no more than a full line gets (``film_coefficients``)
                opens = half * (NEAR * surface.opening_a[i, q] + FAR * surface.opening_b[i, q])
                for d in range(motions):
                    opens -= rate[d] * of_motion[d, 5]
                bounded = inlet - 2.0 * opens < mean
                entering = mean if bounded else inlet - 2.0 * max(opens, 0.0)
            film.inlet[i, j] += share * entering
            opens_a, opens_b = half * share * surface.opening_a[i, q], half * share * surface.opening_b[i, q]
            film.squeeze[i, j] += NEAR * opens_a + FAR * opens_b
            film.squeeze[after, j] += FAR * opens_a + NEAR * opens_b
            for d in range(motions):
                film.conductance_d[d, i, j] += along * of_motion[d, 0]
                film.couette_d[d, i, j] += share * of_motion[d, 1]
                film.cubed_d[d, i, q] += of_motion[d, 2]
                film.cubed_d[d, after, q] += of_motion[d, 3]
                film.inlet_d[d, i, j] += share * (of_motion[d, 1] if bounded else of_motion[d, 4])
                here, there = share * of_motion[d, 5], share * of_motion[d, 6]
                film.load[d, i, j] += here
                film.load[d, after, j] += there
                film.squeeze[i, j] -= rate[d] * here
                film.squeeze[after, j] -= rate[d] * there


NEAR_END = (0.5 - GAUSS) / (2.0 * GAUSS)  # from Gauss point a back to the line, in distances of the Gauss points


@inner
def true_pressure(surface, reduced):
    """Pressure and dp / d(reduced pressure) where viscosity grows with pressure (``piezoviscosity``).

    Cubic between the points of a table; beyond its last point the pressure goes on as a straight line.
    """
    table = surface.piezo
    if table.shape[1] == 0 or reduced <= 0.0:
        return reduced, 1.0
    last = table.shape[1] - 1
    if reduced >= table[0, last]:
        return table[1, last] + table[2, last] * (reduced - table[0, last]), table[2, last]
    low, high = 0, last
    while high - low > 1:
        middle = (low + high) // 2
        if table[0, middle] <= reduced:
            low = middle
        else:
            high = middle
    width = table[0, high] - table[0, low]
    t = (reduced - table[0, low]) / width
    chord = (table[1, high] - table[1, low]) / width
    bend_low, bend_high = table[2, low] - chord, table[2, high] - chord
    rise = t * (1.0 - t) * (bend_low * (1.0 - t) - bend_high * t)
    slope = bend_low * (1.0 - t) * (1.0 - 3.0 * t) - bend_high * t * (2.0 - 3.0 * t)
    return table[1, low] + width * (t * chord + rise), chord + slope
