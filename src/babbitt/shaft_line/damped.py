"""Damped modes of the line: complex eigenvalues of its finite elements."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from babbitt.shaft_line.elements import element_line
from babbitt.shaft_line.line import ShaftLine
from babbitt.shaft_line.pads import DynamicPads

__all__ = ["DampedMode", "damped_modes"]

FINEST = 1e9
"""Eigenvalues beyond this (rad/s) belong to unknowns without mass."""
SWINGS = 0.3
"""Frequency over ``|eigenvalue|`` of a mode that swings; pads that creep back to their tilt do not."""
ELEMENTS = 24


@dataclass(frozen=True)
class DampedMode:
    """A mode that decays: frequency of its swing (rad/s) and damping ratio ``-Re(lambda)/|lambda|``."""

    frequency: float
    damping_ratio: float


def damped_modes(
    line: ShaftLine, pads: DynamicPads, number: int, highest: float = math.inf
) -> tuple[DampedMode, ...]:
    """The lowest modes that swing, by frequency.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    number : int
        How many at most.
    highest : float
        Frequency up to which they are wanted, rad/s.
    """
    from scipy.linalg import eigvals

    model = element_line(line, pads, ELEMENTS)
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
        values = eigvals(left, right) * rate
    values = values[np.isfinite(values)]
    swinging = values[(values.imag > SWINGS * np.abs(values)) & (np.abs(values) < FINEST)]
    swinging = swinging[np.argsort(swinging.imag)]
    modes = [DampedMode(float(value.imag), float(-value.real / abs(value))) for value in swinging]
    return tuple(mode for mode in modes if mode.frequency <= highest)[:number]
