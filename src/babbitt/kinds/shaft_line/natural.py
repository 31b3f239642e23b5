"""Undamped natural frequencies by a count of roots that misses none (Wittrick and Williams).

W. H. Wittrick, F. W. Williams, A general algorithm for computing natural frequencies of elastic structures,
Quarterly Journal of Mechanics and Applied Mathematics 24 (1971) 263-284: below a frequency lie as many natural
frequencies as the dynamic stiffness has negative eigenvalues there, and as the rods have between fixed ends.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.impedance import POLE, dynamic_stiffness
from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.pads import DynamicPads

__all__ = ["Mode", "along", "modes", "root_count", "undamped_frequencies"]

Array = NDArray[np.float64]

BISECTIONS = 60
RELATIVE = 1e-12
PLACES = 41
"""Points of a rod at which a mode shape is given."""


@dataclass(frozen=True, eq=False)
class Mode:
    """A natural frequency and its shape.

    Attributes
    ----------
    frequency : float
        rad/s.
    places : ndarray
        Distance from the propeller, m.
    shape : ndarray
        Axial displacement there over the largest of all.
    pads : ndarray
        The same of the pads.
    housing : float
    """

    frequency: float
    places: Array
    shape: Array
    pads: Array
    housing: float


def root_count(line: ShaftLine, pads: DynamicPads, frequency: float) -> int:
    """Natural frequencies below a frequency (rad/s)."""
    between = sum(math.floor(frequency * rod.transit_time / math.pi) for rod in line.rods)
    matrix = dynamic_stiffness(line, pads, _off_poles(line, frequency), pads.static_stiffness)
    return between + int((np.linalg.eigvalsh(matrix) < 0.0).sum())


def _off_poles(line: ShaftLine, frequency: float) -> float:
    while any(abs(math.sin(frequency * rod.transit_time)) < 10.0 * POLE for rod in line.rods):
        frequency *= 1.0 + 1e-10
    return frequency


def undamped_frequencies(
    line: ShaftLine, pads: DynamicPads, number: int | None = None, highest: float = math.inf
) -> tuple[float, ...]:
    """The lowest natural frequencies, rad/s, with the static stiffness of the films (2 W/h).

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    number : int, optional
        How many at most.
    highest : float
        Up to which frequency, rad/s.
    """
    if number is None and math.isinf(highest):
        raise ValueError("give number or highest")
    top = highest
    if math.isinf(top):
        top = 100.0
        while root_count(line, pads, top) < (number or 0) and top < 1e8:
            top *= 2.0
    wanted = min(root_count(line, pads, top), number if number is not None else 10**9)
    found: list[float] = []
    low = 1e-6 * top
    for order in range(1, wanted + 1):
        below, above = low, top
        for _ in range(BISECTIONS):
            middle = 0.5 * (below + above)
            if root_count(line, pads, middle) >= order:
                above = middle
            else:
                below = middle
            if above - below <= RELATIVE * above:
                break
        found.append(0.5 * (below + above))
        low = below
    return tuple(found)


def modes(line: ShaftLine, pads: DynamicPads, number: int) -> tuple[Mode, ...]:
    """The lowest modes with their shapes."""
    made = []
    for frequency in undamped_frequencies(line, pads, number):
        matrix = dynamic_stiffness(line, pads, _off_poles(line, frequency), pads.static_stiffness)
        values, vectors = np.linalg.eigh(matrix)
        vector = vectors[:, int(np.abs(values).argmin())]
        joints, z = len(line.masses), pads.phases.size
        moved = np.zeros(z) if math.isinf(pads.ring_stiffness) else vector[joints : joints + z]
        places, shape = along(line, vector[:joints], frequency)
        housing = float(vector[-1]) if line.seating is not None else 0.0
        largest = max(np.abs(shape).max(), np.abs(moved).max(), abs(housing))
        sign = 1.0 if shape[int(np.abs(shape).argmax())] > 0.0 else -1.0
        scale = sign / largest
        made.append(Mode(frequency, places, shape * scale, moved * scale, housing * scale))
    return tuple(made)


def along(line: ShaftLine, joints: Array, frequency: float) -> tuple[Array, Array]:
    """Displacement along the rods: the wave through the motion of both ends."""
    if not line.rods:
        return np.array([0.0]), joints
    places, shapes, start = [], [], 0.0
    for place, rod in enumerate(line.rods):
        share = np.linspace(0.0, 1.0, PLACES)
        angle = frequency * rod.transit_time
        ends = joints[place], joints[place + 1]
        shapes.append(
            (ends[0] * np.sin(angle * (1.0 - share)) + ends[1] * np.sin(angle * share)) / math.sin(angle)
        )
        places.append(start + share * rod.length)
        start += rod.length
    return np.concatenate(places), np.concatenate(shapes)
