"""Pad forces over the frequency of an excitation, with films and tilts at that frequency, and their peaks.

The equations are those of `babbitt.kinds.shaft_line.impedance`, solved for many frequencies at once.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.pads import DynamicPads

__all__ = ["AMPLIFIED", "THRUST", "ResponsePeak", "pad_forces", "response_peaks", "static_force"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

THRUST = 0.0
"""Stands for the thrust ripple where the lobes of a runout are asked for."""
AMPLIFIED = 2.0
"""Pad force over its static value from which a maximum of the response counts as a resonance."""
RATIO = 1.01
"""Of neighbouring frequencies at which peaks are sought."""
FINER, ROUNDS = 21, 3
"""Points between the neighbours of a maximum at which it is sought again, and how often."""
AT_REST = 1e-4
"""Frequency of the static force over the lowest one asked for."""
HARDLY = 1e-2
"""Static force over that of a collar that is held, at least: lobes that all pads pass at once move a free collar
and load no pad."""
CHUNK = 256
"""Frequencies solved at once, for the sake of memory."""


@dataclass(frozen=True)
class ResponsePeak:
    """A maximum of the largest pad force over frequency.

    Attributes
    ----------
    frequency : float
        rad/s.
    amplification : float
        Largest pad force over its static value.
    lobes : float
        Of the runout that excites it; `THRUST` for the thrust ripple.
    """

    frequency: float
    amplification: float
    lobes: float


def pad_forces(line: ShaftLine, pads: DynamicPads, lobes: float, frequencies: Array) -> ComplexArray:
    """Forces N_i of the pads for a thrust of 1 N at the propeller, or a runout of 1 m under pad 1.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    lobes : float
        Of the runout; `THRUST` for the thrust.
    frequencies : ndarray, shape (n,)
        rad/s, positive; not of a rod between fixed ends.

    Returns
    -------
    ndarray, shape (n, z)
        N or N/m.
    """
    at = np.asarray(frequencies, dtype=np.float64)
    parts = [_forces(line, pads, lobes, at[k : k + CHUNK]) for k in range(0, at.size, CHUNK)]
    return np.concatenate(parts) if parts else np.zeros((0, pads.phases.size), dtype=complex)


def _forces(line: ShaftLine, pads: DynamicPads, lobes: float, nu: Array) -> ComplexArray:
    films = pads.films(nu)
    n, z = films.shape
    joints, rigid = len(line.masses), math.isinf(pads.ring_stiffness)
    size = joints + (0 if rigid else z) + (0 if line.seating is None else 1)
    matrix = np.zeros((n, size, size), dtype=complex)
    for place, mass in enumerate(line.masses):
        matrix[:, place, place] -= nu**2 * mass
    matrix[:, 0, 0] += 1j * nu * line.propeller_damping
    for place, rod in enumerate(line.rods):
        angle = nu * rod.transit_time
        own, cross = rod.stiffness * angle / np.tan(angle), -rod.stiffness * angle / np.sin(angle)
        for row, column, entry in ((0, 0, own), (1, 1, own), (0, 1, cross), (1, 0, cross)):
            matrix[:, place + row, place + column] += entry
    collar = joints - 1
    matrix[:, collar, collar] += films.sum(axis=1)
    runout = np.zeros((n, z), dtype=complex)
    if lobes != THRUST:
        runout = np.exp(-1j * lobes * pads.phases) * (1.0 + (pads.wobbles(nu) if lobes == 1.0 else 0.0 * films))
    right = np.zeros((n, size), dtype=complex)
    right[:, 0] += 1.0 if lobes == THRUST else 0.0
    right[:, collar] -= (films * runout).sum(axis=1)
    if not rigid:
        c, rows = pads.ring_stiffness, np.arange(joints, joints + z)
        matrix[:, collar, rows] = matrix[:, rows, collar] = -films
        matrix[:, rows, rows] = c - (nu**2 * pads.pad_mass)[:, None] + films
        right[:, rows] = films * runout
        if line.seating is not None:
            seat = line.seating
            matrix[:, rows, -1] = matrix[:, -1, rows] = -c
            matrix[:, -1, -1] = seat.stiffness + 1j * nu * seat.damping - nu**2 * seat.housing_mass + z * c
    moved = np.linalg.solve(matrix, right[..., None])[..., 0]
    displaced = 0.0 if rigid else moved[:, joints : joints + z]
    return np.asarray(-films * (displaced - runout - moved[:, collar, None]), dtype=np.complex128)


def static_force(line: ShaftLine, pads: DynamicPads, lobes: float, lowest: float) -> float:
    """Largest pad force of a unit excitation that hardly changes with time, N or N/m.

    Parameters
    ----------
    line, pads, lobes
        As of `pad_forces`.
    lowest : float
        The lowest frequency of interest, rad/s, far below which it is taken.
    """
    slow = float(np.abs(pad_forces(line, pads, lobes, np.array([AT_REST * lowest]))).max())
    if lobes == THRUST:
        return slow
    k, c = pads.static_stiffness, pads.ring_stiffness
    held = float((k if math.isinf(c) else k * c / (k + c)).max())
    return max(slow, HARDLY * held)


def response_peaks(
    line: ShaftLine,
    pads: DynamicPads,
    lobes: float,
    lowest: float,
    highest: float,
    modes: Sequence[tuple[float, float]] = (),
    ratio: float = RATIO,
) -> tuple[ResponsePeak, ...]:
    """Maxima between two frequencies at which the largest pad force exceeds twice its static value.

    Parameters
    ----------
    line, pads, lobes
        As of `pad_forces`.
    lowest, highest : float
        rad/s.
    modes : sequence of (float, float)
        Damped frequencies, rad/s, and damping ratios, about which narrow peaks are sought.
    ratio : float
        Of neighbouring frequencies elsewhere.
    """
    count = max(3, 1 + math.ceil(math.log(highest / lowest) / math.log(ratio)))
    grid = [np.geomspace(lowest, highest, count)]
    grid += [frequency * (1.0 + np.linspace(-3.0, 3.0, 13) * damped) for frequency, damped in modes]
    at = np.unique(np.concatenate(grid))
    at = at[(at >= lowest) & (at <= highest)]
    rest = static_force(line, pads, lobes, lowest)
    if not rest > 0.0:
        return ()
    forces = _largest(line, pads, lobes, at)
    tops = np.flatnonzero((forces[1:-1] >= forces[:-2]) & (forces[1:-1] > forces[2:])) + 1
    found = []
    for top in tops:
        left, right = at[top - 1], at[top + 1]
        for _ in range(ROUNDS):
            fine = np.linspace(left, right, FINER)
            heights = _largest(line, pads, lobes, fine)
            place = int(np.clip(heights.argmax(), 1, FINER - 2))
            left, right, frequency, force = fine[place - 1], fine[place + 1], fine[place], heights[place]
        if force > AMPLIFIED * rest:
            found.append(ResponsePeak(float(frequency), float(force / rest), lobes))
    return tuple(found)


def _largest(line: ShaftLine, pads: DynamicPads, lobes: float, frequencies: Array) -> Array:
    return np.asarray(np.abs(pad_forces(line, pads, lobes, frequencies)).max(axis=1))
