"""Damped modes of the line: complex eigenvalues of its finite elements with every tilt of its pads.

The films of a mode are those at its own frequency. A damped mode belongs to the undamped one with which it
overlaps most along the shaft (modal assurance), and as far as the line moves and not the tilts of pads::

    |phi^T M v|^2 / ((phi^T M phi) (v* M v)) * (1 - fraction of the tilts).

Others are given where so little damps them that they resonate.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.elements import ElementLine, element_line, joint_places
from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.natural import Mode
from babbitt.kinds.shaft_line.pads import DynamicPads, FilmPads

__all__ = ["DampedMode", "damped_modes"]

Array = NDArray[np.float64]

FINEST = 1e9
"""Eigenvalues beyond this (rad/s) belong to unknowns without mass."""
SWINGS = 0.3
"""Frequency over ``|eigenvalue|`` of a mode that swings; pads that creep back to their tilt do not."""
ELEMENTS = 24
BELONGS = 0.5
"""Overlap from which a damped mode belongs to an undamped one."""
TILTS = 1e-3
"""Mass that tilts count for, times the width of a pad squared, over that of the line; of their own inertia they
would hardly count, and those of massless pads not at all."""


LIGHTLY = 0.25
"""Damping ratio below which a single mode is amplified more than twice, 1/(2 zeta): it resonates."""
ELEMENT_ANGLE = 0.25
"""Phase of a wave along one element at the highest frequency, rad: a frequency is then 0.3 % too high."""
MOST_ELEMENTS = 120
"""Elements over the whole line at most, for the sake of time."""


@dataclass(frozen=True)
class DampedMode:
    """A mode that decays.

    Attributes
    ----------
    order : int
        Number of the undamped mode that it belongs to, from 1; 0 for none.
    frequency : float
        Of its swing, rad/s.
    damping_ratio : float
        ``-Re(lambda)/|lambda|``.
    """

    order: int
    frequency: float
    damping_ratio: float

    @property
    def resonates(self) -> bool:
        """Whether an excitation at its frequency is amplified more than twice."""
        return self.damping_ratio < LIGHTLY


def damped_modes(
    line: ShaftLine, pads: DynamicPads, undamped: Sequence[Mode] = (), highest: float = 0.0
) -> tuple[DampedMode, ...]:
    """Damped modes that belong to undamped ones, and all others up to a frequency that resonate; low ones first.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    undamped : sequence of Mode
        The lowest of `babbitt.kinds.shaft_line.natural.modes`.
    highest : float
        rad/s.
    """
    transit = sum(rod.transit_time for rod in line.rods)
    elements = min(max(ELEMENTS, math.ceil(highest * transit / ELEMENT_ANGLE)), MOST_ELEMENTS)
    model = element_line(line, pads, elements)
    values, vectors = _swinging(model)
    orders = np.zeros(values.size, dtype=int)
    if undamped and values.size:
        overlaps = _overlaps(line, pads, model, vectors, undamped, elements)
        for order, row in enumerate(overlaps, start=1):
            if row.max() > BELONGS:
                orders[int(row.argmax())] = order
    found = [
        DampedMode(int(order), float(value.imag), float(-value.real / abs(value)))
        for order, value in zip(orders, values, strict=True)
    ]
    kept = (mode for mode in found if mode.order or (mode.resonates and mode.frequency <= highest))
    return tuple(sorted(kept, key=lambda mode: mode.frequency))


def _swinging(model: ElementLine) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues, rad/s, of motions that swing and are not of unknowns without mass, and their vectors."""
    from scipy.linalg import eig

    n = model.mass.shape[0]
    one, none = np.eye(n), np.zeros((n, n))
    # time in units of 1/rate makes both halves of the pencil of one size
    rate = 1e3
    left = np.block([[none, one], [-model.stiffness, -model.damping * rate]])
    right = np.block([[one, none], [none, model.mass * rate**2]])
    scale = 1.0 / np.maximum(np.abs(left[n:]).max(axis=1), 1e-300)
    left[n:] *= scale[:, None]
    right[n:] *= scale[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        values, vectors = eig(left, right)
        values = values * rate
        swings = np.isfinite(values) & (values.imag > SWINGS * np.abs(values)) & (np.abs(values) < FINEST)
    return values[swings], vectors[:n, swings]


def _overlaps(
    line: ShaftLine,
    pads: DynamicPads,
    model: ElementLine,
    vectors: NDArray[np.complex128],
    undamped: Sequence[Mode],
    elements: int,
) -> Array:
    """Overlap of every undamped mode (rows) with every damped one."""
    joints = model.collar + 1
    mass, along = model.mass[:joints, :joints], joint_places(line, elements)
    shapes = np.array([np.interp(along, mode.places, mode.shape) for mode in undamped])
    moving = vectors[:joints]
    of_line = np.einsum("jk,jl,lk->k", moving.conj(), mass, moving).real
    of_shapes = np.einsum("ij,jl,il->i", shapes, mass, shapes)
    both = np.abs(shapes @ mass @ moving) ** 2 / np.maximum(np.outer(of_shapes, of_line), 1e-300)
    tilting = np.zeros(vectors.shape[1])
    if isinstance(pads, FilmPads) and model.tilts:
        width = pads.bearing.pad.outer_radius - pads.bearing.pad.inner_radius
        weight = TILTS * float(mass.sum()) * width**2
        tilting = weight * (np.abs(vectors[list(model.tilts)]) ** 2).sum(axis=0)
    whole = np.einsum("jk,jl,lk->k", vectors.conj(), model.mass, vectors).real + tilting
    return np.asarray(both * (1.0 - tilting / np.maximum(whole, 1e-300)))
