"""The line in finite elements with every tilt of its pads: for damping ratios and for marching in time."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.pads import DynamicPads, FilmPads

__all__ = ["ElementLine", "ShaftElements", "element_line", "joint_places", "shaft_elements"]

Array = NDArray[np.float64]

ELEMENTS = 12
"""Two-node rods over the whole line at least, shared out by transit time."""


@dataclass(frozen=True, eq=False)
class ElementLine:
    """M u'' + C u' + K u = B_Q Q + sum over the pads of (K_xi xi_i + C_xi xi_i').

    Attributes
    ----------
    mass, damping, stiffness : ndarray, shape (n, n)
    collar : int
        Place of the collar; the propeller is at 0.
    runout_stiffness, runout_damping : ndarray, shape (n, z)
        What the runout under each pad does.
    gaps : ndarray, shape (z, n)
        Rows that give h_i + xi_i = x_i - U2.
    forces_stiffness, forces_damping : ndarray, shape (z, n)
        Rows that give N_i = -(forces_stiffness u + forces_damping u') + own_stiffness xi_i + own_damping xi_i'.
    own_stiffness, own_damping : ndarray, shape (z,)
        K_11 and C_11 of the pads.
    tilts : tuple of int
        Places of the tilts of the pads.
    """

    mass: Array
    damping: Array
    stiffness: Array
    collar: int
    runout_stiffness: Array
    runout_damping: Array
    gaps: Array
    forces_stiffness: Array
    forces_damping: Array
    own_stiffness: Array
    own_damping: Array
    tilts: tuple[int, ...]


def element_line(line: ShaftLine, pads: DynamicPads, elements: int = ELEMENTS) -> ElementLine:
    """Assemble the line.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
        Of `FilmPads` the full coefficients and the tilts, of others k and d at frequency zero.
    elements : int
        Over the whole line, consistent masses.
    """
    shaft = shaft_elements(line, elements)
    joints = shaft.mass.shape[0]
    z, rigid = pads.phases.size, math.isinf(pads.ring_stiffness)
    blocks = _pad_blocks(pads)
    tilts = [block[0].shape[0] - 1 for block in blocks]
    first = joints
    places, tilt_places = [], []
    for count in tilts:
        places.append(-1 if rigid else first)
        first += 0 if rigid else 1
        tilt_places.append(list(range(first, first + count)))
        first += count
    housing = first if line.seating is not None else -1
    size = first + (1 if line.seating is not None else 0)
    mass, damping, stiffness = (np.zeros((size, size)) for _ in range(3))
    of_shaft = slice(0, joints)
    mass[of_shaft, of_shaft], stiffness[of_shaft, of_shaft] = shaft.mass, shaft.stiffness
    damping[of_shaft, of_shaft] = shaft.damping
    collar = joints - 1
    gaps = np.zeros((z, size))
    fs, fd = np.zeros((z, size)), np.zeros((z, size))
    rs, rd = np.zeros((size, z)), np.zeros((size, z))
    for i, (k, d, inertia) in enumerate(blocks):
        rows = np.zeros((k.shape[0], size))
        rows[0, collar] = -1.0
        if not rigid:
            rows[0, places[i]] = 1.0
        for row, place in enumerate(tilt_places[i], start=1):
            rows[row, place] = 1.0
            mass[place, place] += inertia[row - 1]
        stiffness += rows.T @ k @ rows
        damping += rows.T @ d @ rows
        gaps[i], fs[i], fd[i] = rows[0], k[0] @ rows, d[0] @ rows
        rs[:, i], rd[:, i] = rows.T @ k[:, 0], rows.T @ d[:, 0]
        if not rigid:
            x = places[i]
            mass[x, x] += pads.pad_mass
            stiffness[x, x] += pads.ring_stiffness
            if housing >= 0:
                stiffness[x, housing] -= pads.ring_stiffness
                stiffness[housing, x] -= pads.ring_stiffness
                stiffness[housing, housing] += pads.ring_stiffness
    if line.seating is not None:
        mass[housing, housing] += line.seating.housing_mass
        stiffness[housing, housing] += line.seating.stiffness
        damping[housing, housing] += line.seating.damping
    own = np.array([block[0][0, 0] for block in blocks]), np.array([block[1][0, 0] for block in blocks])
    return ElementLine(mass, damping, stiffness, collar, rs, rd, gaps, fs, fd, *own, tuple(chain(*tilt_places)))


@dataclass(frozen=True, eq=False)
class ShaftElements:
    """Mass, damping and stiffness of the shaft alone; the propeller first, the collar last."""

    mass: Array
    damping: Array
    stiffness: Array


def shaft_elements(line: ShaftLine, elements: int) -> ShaftElements:
    """Two-node rods with consistent masses, and the point masses of the line."""
    shares = _shared_out(line, elements)
    joints = 1 + sum(shares)
    mass, damping, stiffness = (np.zeros((joints, joints)) for _ in range(3))
    at = 0
    for rod, count in zip(line.rods, shares, strict=True):
        k, m = rod.stiffness * count, rod.mass / count / 6.0
        for _ in range(count):
            pair = np.ix_((at, at + 1), (at, at + 1))
            stiffness[pair] += k * np.array([[1.0, -1.0], [-1.0, 1.0]])
            mass[pair] += m * np.array([[2.0, 1.0], [1.0, 2.0]])
            at += 1
    ends = np.cumsum((0, *shares)) if line.rods else np.array([0])
    mass[ends, ends] += np.array(line.masses)
    damping[0, 0] = line.propeller_damping
    return ShaftElements(mass, damping, stiffness)


def joint_places(line: ShaftLine, elements: int) -> Array:
    """Distances of the joints from the propeller, m."""
    shares = _shared_out(line, elements)
    steps = [rod.length / count for rod, count in zip(line.rods, shares, strict=True) for _ in range(count)]
    return np.concatenate([[0.0], np.cumsum(steps)])


def _shared_out(line: ShaftLine, elements: int) -> list[int]:
    total = sum(rod.transit_time for rod in line.rods)
    return [max(1, math.ceil(elements * rod.transit_time / total)) for rod in line.rods]


def _pad_blocks(pads: DynamicPads) -> list[tuple[Array, Array, list[float]]]:
    """Stiffness and damping of (gap, free tilts) and the inertias of the tilts, for each pad."""
    if not isinstance(pads, FilmPads):
        k, d = pads.static_stiffness, pads.film(1.0).imag
        return [(np.array([[a]]), np.array([[b]]), []) for a, b in zip(k, d, strict=True)]
    both = pads.bearing.inertia
    inertias = {1: both.radial, 2: both.along}
    blocks = []
    for state in pads.share.states:
        kept = [0, *state.pad.free_tilts]
        pick = np.ix_(kept, kept)
        blocks.append((state.stiffness[pick], state.damping[pick], [inertias[tilt] for tilt in kept[1:]]))
    return blocks
