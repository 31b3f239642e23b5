"""The gap over a pad: where it is sampled, and where it is smallest.

The gap of a plane pad is a linear function of the place: its minimum lies at an inner corner or on the outer arc,
the extreme points of the pad's convex hull. What moves with complex amplitudes, static film less the sum of their
magnitudes, is concave there and smallest at the same places.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.thrust.face import PlaneFace
from babbitt.kinds.thrust.pad import ThrustPad

__all__ = ["gap_along", "gap_samples", "minimum_gap"]

Array = NDArray[np.float64]

ARC_INTERVALS = 128
"""On the outer arc of a plane pad: a minimum between them lies less than 1e-4 of the fall of the film over the pad
lower."""
ROWS = 65
"""Radii at which the gap of a pad with a face or a crown is sampled, in addition to the edge of the face."""


@lru_cache(maxsize=32)
def gap_samples(pad: ThrustPad) -> tuple[Array, Array]:
    """Where the gap is sampled: (1, X, Y) of points, (n, 3), and the departure of the face there, m, (n,).

    Of a plane pad the inner corners and the outer arc; over any other face a grid with the edge of the face and
    the radius of the pivot. Kept for a pad: not to be written to.
    """
    if _is_flat(pad):
        arc = np.linspace(0.0, pad.extent, ARC_INTERVALS + 1)
        angle = np.concatenate(([0.0, pad.extent], arc)) - pad.pivot_angle
        radius = np.concatenate((np.full(2, pad.inner_radius), np.full(arc.size, pad.outer_radius)))
        return _basis(pad, radius, angle), np.zeros(angle.size)
    rows = np.array(pad.form())
    last = rows.shape[0] - 1
    edge, pivot = (round(place * last) for place in (getattr(pad.face, "fraction", 0.0), pad.pivot_fraction))
    along = np.unique([*np.linspace(0, last, ROWS).round().astype(int), edge, min(edge + 1, last), pivot])
    angle = along[:, None] / last * pad.extent - pad.pivot_angle
    across = np.linspace(pad.inner_radius, pad.outer_radius, rows.shape[1])[None, :]
    return _basis(pad, across, angle).reshape(-1, 3), rows[along].ravel()


def minimum_gap(pad: ThrustPad, motions: Array) -> Array:
    """Smallest gap over the edges and the face of a pad, m.

    Parameters
    ----------
    pad : ThrustPad
    motions : ndarray, shape (..., 3)
        Height at the pivot, m, and slopes alpha_x, alpha_y.

    Returns
    -------
    ndarray, shape (...)
    """
    if not _is_flat(pad):
        basis, face = gap_samples(pad)
        return np.asarray((motions @ basis.T + face).min(axis=-1))
    height, slope_x, slope_y = np.moveaxis(np.asarray(motions), -1, 0)
    corners = (motions @ pad.corners().T).min(axis=-1)
    steep = np.hypot(slope_x, slope_y)
    # on the arc the gap is h_p - alpha_x r_p + r_o steep cos(angle - upward), smallest opposite to upward
    lowest = np.arctan2(-slope_y, -slope_x)
    on_the_arc = (lowest >= -pad.pivot_angle) & (lowest <= pad.extent - pad.pivot_angle)
    at_arc = height - slope_x * pad.pivot_radius - pad.outer_radius * steep
    return np.asarray(np.where(on_the_arc, np.minimum(corners, at_arc), corners))


def gap_along(pad: ThrustPad, motion: Array, radius: float, angle: Array) -> Array:
    """Gap at a radius, m, and angles from the leading edge, rad; m.

    Parameters
    ----------
    pad : ThrustPad
    motion : ndarray, shape (3,)
        Height at the pivot, m, and slopes alpha_x, alpha_y.
    radius : float
    angle : ndarray
    """
    basis = _basis(pad, np.full(angle.shape, radius), angle - pad.pivot_angle)
    if _is_flat(pad):
        return np.asarray(basis @ motion)
    rows = np.array(pad.form())
    place = (radius - pad.inner_radius) / (pad.outer_radius - pad.inner_radius) * (rows.shape[1] - 1)
    first = min(int(place), rows.shape[1] - 2)
    column = (first + 1 - place) * rows[:, first] + (place - first) * rows[:, first + 1]
    return np.asarray(basis @ motion + np.interp(angle, np.linspace(0.0, pad.extent, rows.shape[0]), column))


def _is_flat(pad: ThrustPad) -> bool:
    return isinstance(pad.face, PlaneFace) and pad.crown == 0.0


def _basis(pad: ThrustPad, radius: Array, angle: Array) -> Array:
    x, y = radius * np.cos(angle) - pad.pivot_radius, radius * np.sin(angle)
    return np.stack([np.ones(x.shape), x, y], axis=-1)
