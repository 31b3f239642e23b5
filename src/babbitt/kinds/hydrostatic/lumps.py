"""Lands of bearings with several recesses, lumped: what flows over them at a position, and how that answers to it.

Outer lands of every recess over its pitch, one land between neighbours (or two to a drain groove). Motions close
the gap by a mean and one wave around the bearing: h = gap - a_0 - a_1 cos(theta) - a_2 sin(theta).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, ThrustRing, pitches_around

__all__ = ["LumpedFlow", "Lumps", "journal_lumps", "ring_lumps"]

Array = NDArray[np.float64]
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def waves(theta: Array) -> Array:
    """One, cosine and sine at angles, shape (3, ...)."""
    return np.array([np.ones_like(theta), np.cos(theta), np.sin(theta)])


@dataclass(frozen=True, eq=False)
class Arcs:
    """Lands as arcs with Gauss points.

    Attributes
    ----------
    motions : ndarray, shape (motions, points)
        What the motions close the gap by at the points of all arcs.
    weights : ndarray, shape (arcs, points)
        Integrals over the angle of what is given at the points.
    """

    motions: Array
    weights: Array

    @classmethod
    def between(cls, starts: Array, ends: Array, harmonics: Array) -> Arcs:
        """Arcs between angles, rad."""
        half = 0.5 * (ends - starts)
        theta = 0.5 * (starts + ends)[:, None] + half[:, None] * NODES
        weights = np.zeros((half.size, half.size, NODES.size))
        weights[np.arange(half.size), np.arange(half.size)] = half[:, None] * WEIGHTS
        return cls(harmonics @ waves(theta.ravel()), weights.reshape(half.size, -1))


@dataclass(frozen=True, eq=False)
class LumpedFlow:
    """Outflow of all recesses at a position, q = G p + q_0, and how it answers to motions.

    Attributes
    ----------
    conductance : ndarray, shape (n, n)
        G, m3/(s Pa).
    dragged : ndarray, shape (n,)
        q_0, by the moving surface, m3/s.
    outer_slope : ndarray, shape (n, motions)
        Of the conductance of the outer lands.
    land_slope, dragged_slope : ndarray, shape (lands, motions)
        Of the conductance of the lands between recesses, and of what is dragged along them.
    joins : ndarray, shape (lands, n)
        1 for the recess before a land, -1 for that behind.
    """

    conductance: Array
    dragged: Array
    outer_slope: Array
    land_slope: Array
    dragged_slope: Array
    joins: Array

    def outflow(self, pressures: Array) -> Array:
        """Of every recess, m3/s."""
        return self.conductance @ pressures + self.dragged

    def opening(self, pressures: Array) -> Array:
        """dq/da, shape (n, motions)."""
        along = (self.joins @ pressures)[:, None] * self.land_slope + self.dragged_slope
        return pressures[:, None] * self.outer_slope + self.joins.T @ along


@dataclass(frozen=True, eq=False)
class Lumps:
    """What the lumped network needs of a bearing.

    Attributes
    ----------
    angles : tuple of float
        Middles of the recesses, rad.
    extent, groove_extent : float
        rad.
    gap : float
        At rest, m.
    outer : float
        Flow over both outer lands per pressure, per integral of h^3 over the angle, times viscosity.
    length, radius : float
        Of the lands between recesses: across the flow, and where they lie, m.
    speed : float
        rad/s.
    viscosity : float
        Pa s.
    harmonics : ndarray, shape (motions, 3)
        a_0, a_1, a_2 of one unit of every motion.
    share : float
        Area on which the pressure of one recess acts, m2.
    squeeze : ndarray, shape (motions, motions)
        Damping of the lands times the cube of the mean gap, N s m2.
    edge : float
        Radius at which a tilt closes the gap most, over ``radius``.
    """

    angles: tuple[float, ...]
    extent: float
    groove_extent: float
    gap: float
    outer: float
    length: float
    radius: float
    speed: float
    viscosity: float
    harmonics: Array
    share: float
    squeeze: Array
    edge: float = 1.0

    def thinnest(self, at: Array) -> float:
        """Smallest gap at a position, m."""
        mean, cosine, sine = at @ self.harmonics
        return float(self.gap - mean - self.edge * math.hypot(cosine, sine))

    def damping(self, at: Array) -> Array:
        """Of the lands at a position, at its mean gap, shape (motions, motions)."""
        return self.squeeze / (self.gap - float(at @ self.harmonics[:, 0])) ** 3

    @cached_property
    def area(self) -> Array:
        """dF/dp, shape (motions, n)."""
        return -self.share * self.harmonics @ waves(np.array(self.angles))

    @cached_property
    def around(self) -> tuple[Array, Array, Array, Array]:
        """Recesses as they follow each other: matrices that pick them and their next; middles; pitches, rad."""
        order = np.argsort([angle % (2.0 * math.pi) for angle in self.angles], kind="stable")
        own = np.eye(order.size)[order]
        following = np.concatenate((own[1:], own[:1]))
        middles = own @ self.angles
        return own, following, middles, np.array(pitches_around(self.angles))

    @cached_property
    def outer_lands(self) -> Arcs:
        """Outer lands, every recess from half the pitch before to half the pitch behind; weights (n, points)."""
        own, following, middles, pitches = self.around
        borders = middles + 0.5 * pitches
        starts, ends = np.concatenate((middles, borders)), np.concatenate((borders, middles + pitches))
        arcs = Arcs.between(starts, ends, self.harmonics)
        return Arcs(arcs.motions, np.concatenate((own, following)).T @ arcs.weights)

    @cached_property
    def between(self) -> tuple[Arcs, Array]:
        """Lands between recesses or to drain grooves; of each 1 for the recess before, -1 for that behind."""
        own, following, middles, pitches = self.around
        starts, ends = middles + 0.5 * self.extent, middles + pitches - 0.5 * self.extent
        if self.groove_extent == 0.0:
            return Arcs.between(starts, ends, self.harmonics), own - following
        borders, half = middles + 0.5 * pitches, 0.5 * self.groove_extent
        starts, ends = np.concatenate((starts, borders + half)), np.concatenate((borders - half, ends))
        return Arcs.between(starts, ends, self.harmonics), np.concatenate((own, -following))

    def flow(self, at: Array) -> LumpedFlow:
        """Outflow at a position and its derivatives there.

        With J_m the integral of h^-m along a land between recesses, its conductance is length/(12 mu radius J_3)
        and the surface drags length speed radius J_2/(2 J_3) along it.
        """
        over = self.outer_lands
        gap = self.gap - at @ over.motions
        square = gap * gap
        axial = self.outer / self.viscosity
        lands, joins = self.between
        inverse = 1.0 / (self.gap - at @ lands.motions)
        inverse_square = inverse * inverse
        closing = inverse_square * inverse * lands.motions
        second, third = lands.weights @ inverse_square, lands.weights @ (inverse_square * inverse)
        conducts = self.length / (12.0 * self.viscosity * self.radius) / third
        drags = 0.5 * self.length * self.speed * self.radius * second / third
        narrows = (lands.weights @ (3.0 * inverse * closing).T) / third[:, None]  # of ln J_3
        return LumpedFlow(
            conductance=np.diag(axial * (over.weights @ (square * gap))) + (joins.T * conducts) @ joins,
            dragged=joins.T @ drags,
            outer_slope=-3.0 * axial * (over.weights @ (square * over.motions).T),
            land_slope=-conducts[:, None] * narrows,
            dragged_slope=drags[:, None] * ((lands.weights @ (2.0 * closing).T) / second[:, None] - narrows),
            joins=joins,
        )


def journal_lumps(bearing: RecessedJournal, viscosity: float, speed: float) -> Lumps:
    """Effective length L - a, effective chord D sin(pi/n)."""
    n, a = bearing.count, bearing.axial_land
    chord = bearing.diameter * (math.sin(math.pi / n) if n > 1 else 1.0)
    return Lumps(
        bearing.recess_angles, bearing.recess_extent, bearing.groove_extent, bearing.clearance,
        bearing.radius / (6.0 * a), bearing.width - a, bearing.radius, speed, viscosity,
        np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), chord * (bearing.width - a), np.zeros((2, 2)),
    )  # fmt: skip


def ring_lumps(ring: ThrustRing, height: float, viscosity: float, speed: float) -> Lumps:
    """Every recess has an equal share of the annular pad; moments act at the mean radius of the recesses."""
    r1, r2, r3, r4 = ring.radii.radii
    lands = lands_of(ring.radii)
    mean = 0.5 * (r2 + r3)
    squeeze = np.zeros((3, 3))
    squeeze[0, 0] = lands.squeeze_damping(1.0, viscosity)
    return Lumps(
        ring.recess_angles, ring.recess_extent, ring.groove_extent, height,
        (1.0 / math.log(r2 / r1) + 1.0 / math.log(r4 / r3)) / 12.0,
        0.5 * (r3 + r4 - r1 - r2), mean, speed, viscosity,
        np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, -mean], [0.0, mean, 0.0]]),
        lands.effective_area / len(ring.recess_angles), squeeze, r4 / mean,
    )  # fmt: skip
