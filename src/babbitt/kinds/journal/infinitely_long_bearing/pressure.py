r"""Pressure around the long film: two discretisations of Reynolds' equation, both without iteration.

Angles run from the widest gap with the rotation; the film starts where the oil enters. Written without
dimension, ``H = h/c`` and ``P = p c²/(u R)`` with the viscosity kept in Pa s:

.. math:: \frac{d}{dθ}\left(\frac{H^3}{μ} \frac{dP}{dθ}\right) = 6 \frac{dH}{dθ}

Rupture where pressure and its gradient vanish (Reynolds, Swift, Stieber).

The discrete complementarity problem, pressure nowhere negative, has a closed solution in one dimension. Every
pressure difference is a known one plus the first of them times a positive weight; the film that ends at node m
has the first difference that makes the pressure there vanish, and the film of Reynolds is the one among them
whose first difference is the largest. That is what a Thomas sweep with a cut at zero gives, here in cumulative
sums.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Gap:
    """The gap of one eccentricity ratio on n equal sectors: nodes (n + 1) and sectors (n), without dimension.

    `start` is the angle of the first node, rad from the widest gap.
    """

    eccentricity_ratio: float
    step: float
    nodes: Array
    sectors: Array
    slope: Array
    start: float = 0.0

    @classmethod
    def of(cls, eccentricity_ratio: float, cells: int, start: float = 0.0) -> Gap:
        """``H = 1 + ε cos θ``; `slope` is dH/dθ at the nodes."""
        _, cosine, sine = circle(cells, start)
        nodes = 1.0 + eccentricity_ratio * cosine
        sectors = 0.5 * (nodes[1:] + nodes[:-1])
        return cls(eccentricity_ratio, 2.0 * math.pi / cells, nodes, sectors, -eccentricity_ratio * sine, start)


@dataclass(frozen=True, eq=False)
class Pressure:
    """Pressure of one film, without dimension.

    Attributes
    ----------
    nodes : ndarray
        P, shape (n + 1,).
    flow : ndarray
        Local flow ``H/2 - H³/(12 μ) dP/dθ`` of every sector, over c u L; shape (n,).
    rupture_angle : float
        θ_r in rad from the widest gap, to a fraction of a sector.
    full : ndarray
        How much of every sector is full film, 0 to 1; shape (n,).
    start : float
        Angle of the first node, rad from the widest gap.
    """

    nodes: Array
    flow: Array
    rupture_angle: float
    full: Array
    start: float = 0.0

    def load(self, step: float) -> tuple[float, float]:
        """Load along the eccentricity and normal to it, ``-∫ P cos θ dθ`` and ``∫ P sin θ dθ``."""
        return load_of(self.nodes, step, self.start)


def load_of(pressure: Array, step: float, start: float) -> tuple[float, float]:
    """Load along the eccentricity and normal to it of a pressure at the nodes, without dimension."""
    _, cosine, sine = circle(pressure.size - 1, start)
    return -step * float(pressure @ cosine), step * float(pressure @ sine)


@lru_cache(maxsize=8)
def circle(cells: int, start: float = 0.0) -> tuple[Array, Array, Array]:
    """Angles of the nodes, their cosine and their sine; shape (cells + 1,), read-only."""
    angles = start + np.linspace(0.0, 2.0 * math.pi, cells + 1)
    found = angles, np.cos(angles), np.sin(angles)
    for one in found:
        one.setflags(write=False)
    return found


def divergence_form(gap: Gap, viscosity: Array) -> Pressure:
    """Conservative form: the same flow passes every section of the full film.

    Parameters
    ----------
    gap : Gap
    viscosity : ndarray
        At the nodes, Pa s.
    """
    nodes, weight, last, at_rupture = _until_rupture(gap, viscosity)
    angle, full = _rupture((gap.sectors - at_rupture) * weight, last, gap.step)
    return Pressure(nodes, np.full(gap.sectors.size, 0.5 * at_rupture), gap.start + angle, full, gap.start)


def load_of_divergence_form(gap: Gap, viscosity: Array) -> tuple[float, float]:
    """Load of `divergence_form` along the eccentricity and normal to it, without dimension."""
    return load_of(_until_rupture(gap, viscosity)[0], gap.step, gap.start)


def _until_rupture(gap: Gap, viscosity: Array) -> tuple[Array, Array, int, float]:
    """Pressure at the nodes, μ/H³ of the sectors, that at whose end the film breaks, and H there."""
    h = gap.sectors
    weight = 0.5 * (viscosity[1:] + viscosity[:-1]) / (h * h * h)
    couette, poiseuille = (h * weight).cumsum(), weight.cumsum()
    ends = couette / poiseuille
    last = int(ends.argmin())
    at_rupture = float(ends[last])
    nodes = np.zeros(gap.nodes.size)
    nodes[1 : last + 1] = 6.0 * gap.step * (couette[:last] - at_rupture * poiseuille[:last])
    return nodes, weight, last, at_rupture


def published_form(gap: Gap, viscosity: Array) -> Pressure:
    """The form without the derivative of viscosity, ``H³ P'' + 3 H² H' P' = 6 μ H'``, by central differences.

    Only to repeat a published table: with varying viscosity the local flow is not the same in every section.
    Parameters as of `divergence_form`.
    """
    inner, slope, step = gap.nodes[1:-1], gap.slope[1:-1], gap.step
    skew = 1.5 * step * slope / inner
    weight = np.empty(gap.sectors.size)  # integrating factor of the differences
    weight[0] = 1.0
    np.cumprod((1.0 + skew) / (1.0 - skew), out=weight[1:])
    source = np.zeros(gap.sectors.size)
    np.cumsum(weight[1:] * 6.0 * step**2 * viscosity[1:-1] * slope / (inner**3 * (1.0 + skew)), out=source[1:])
    known, unit = np.cumsum(source / weight), np.cumsum(1.0 / weight)
    firsts = -known / unit
    last = int(firsts.argmax())
    nodes = np.zeros(gap.nodes.size)
    nodes[1 : last + 1] = known[:last] + firsts[last] * unit[:last]
    sector = 0.5 * (viscosity[1:] + viscosity[:-1])
    flow = 0.5 * gap.sectors - gap.sectors**3 / (12.0 * sector) * np.diff(nodes) / step
    angle, full = _rupture((source + firsts[last]) / weight, last, step)
    return Pressure(nodes, flow, gap.start + angle, full, gap.start)


def _rupture(slopes: Array, last: int, step: float) -> tuple[float, Array]:
    """Angle from the start at which the slope of the pressure vanishes, between the middles of two sectors; full
    share of all.

    The slopes go on behind the rupture as if the film did. Their zero moves without a jump when the film breaks in
    another sector, so that the iteration between film and temperature has no edge to hang on.
    """
    before, behind = float(slopes[last]), float(slopes[last + 1])
    place = last + 0.5 + (before / (before - behind) if before < 0.0 < behind else 0.0)
    full = np.zeros(slopes.size)
    whole = min(math.floor(place), slopes.size)
    full[:whole] = 1.0
    if whole < slopes.size:
        full[whole] = place - whole
    return place * step, full
