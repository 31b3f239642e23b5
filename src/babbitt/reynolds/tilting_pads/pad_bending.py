"""Bending of a pad, a curved beam held at its pivot.

    w'' + w = rho^2 [M/(E I) + alpha dT/t],   w(0) = w'(0) = 0,   rho = R_p + t/2,   I = L t^3/12,
    M(phi) = int from phi to the free end of p R_p rho sin|phi' - phi| L dphi',
    w(phi) = int_0^phi sin(phi - s) g(s) ds,   g the right-hand side.

A uniform g gives w = g (1 - cos phi): the radius of the pad grows by g. Source: S. Timoshenko, Strength of
Materials II (1956), thin curved bars.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.tilting_pads.pad_heat import PadBending

__all__ = ["bending_matrices", "deflection_matrix", "moments_ahead", "moments_behind"]

Array = NDArray[np.float64]

GAUSS = np.array([-1.0, 1.0]) / math.sqrt(3.0)


def hat_functions(angles: Array, at: Array) -> Array:
    """Values of the hat functions of equally spaced angles at others, shape (at, angles)."""
    place = np.clip((at - angles[0]) / (angles[1] - angles[0]), 0.0, angles.size - 1)
    first = np.minimum(place.astype(int), angles.size - 2)
    rows, share = np.arange(at.size), place - first
    hats = np.zeros((at.size, angles.size))
    hats[rows, first], hats[rows, first + 1] = 1.0 - share, share
    return hats


def sine_integral(angles: Array, start: Array, end: Array, centre: Array) -> Array:
    """int from ``start`` to ``end`` of sin|s - centre| f(s) ds over the values of f at ``angles``, row by row.

    f is linear between the angles; Gauss points between them and both limits.
    """
    rows = np.zeros((centre.size, angles.size))
    for row, (low, high, middle) in enumerate(zip(start, end, centre, strict=True)):
        inside = angles[(angles > low) & (angles < high)]
        ends = np.concatenate(([low], inside, [high]))
        half, mid = 0.5 * np.diff(ends), 0.5 * (ends[1:] + ends[:-1])
        points = (mid[:, None] + half[:, None] * GAUSS).ravel()
        weights = np.repeat(half, 2) * np.sin(np.abs(points - middle))
        rows[row] = weights @ hat_functions(angles, points)
    return rows


def deflection_matrix(angles: Array) -> Array:
    """Deflection w over g, both at angles from the pivot, shape (n + 1, n + 1)."""
    zero = np.zeros_like(angles)
    return sine_integral(angles, np.minimum(zero, angles), np.maximum(zero, angles), angles)


def moments_ahead(angles: Array) -> Array:
    """int from phi to the trailing edge of p sin(phi' - phi) dphi', over p at angles from the pivot."""
    return sine_integral(angles, angles, np.full_like(angles, angles[-1]), angles)


def moments_behind(angles: Array) -> Array:
    """int from the leading edge to phi of p sin(phi - phi') dphi', over p at angles from the pivot."""
    return sine_integral(angles, np.full_like(angles, angles[0]), angles, angles)


@lru_cache(maxsize=64)
def bending_matrices(
    radius: float, thickness: float, extent: float, fraction: float, intervals: int, bending: PadBending
) -> tuple[Array, Array]:
    """Deflection of a pad (m, outward) over the pressure on its bore (Pa, mean over the width), and over the
    temperature difference across it (K), at the lines of its film."""
    angles = np.linspace(-fraction * extent, (1.0 - fraction) * extent, intervals + 1)
    modulus = bending.plate_modulus
    neutral = radius + 0.5 * thickness
    shape = deflection_matrix(angles)
    per_moment = neutral**2 * 12.0 / (modulus * thickness**3)
    # the moment jumps at the pivot: each side goes on with its own to the line behind it
    sides = np.where(angles[:, None] < 0.0, shape @ moments_behind(angles), shape @ moments_ahead(angles))
    by_pressure = per_moment * radius * neutral * sides
    by_heat = neutral**2 * bending.thermal_expansion / thickness * shape
    return by_pressure, by_heat
