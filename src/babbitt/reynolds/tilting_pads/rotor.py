"""Free motions of a rigid rotor among tilting pads, and how heavy rotor and pads may become.

Condensed coefficients belong to one frequency and to a motion that neither grows nor decays: they do not tell
whether it does. Here the pads keep their own motions. Pads without inertia have rows of first order and no mass
matrix that could be inverted: the pencil A - lambda E of the doubled motions is solved as it stands (QZ), its
motions scaled to one size.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.tilting_pads.dynamics import PadCoefficients

__all__ = [
    "Mode",
    "Threshold",
    "rotor_modes",
    "threshold_cross_coupling",
    "threshold_inertia",
    "threshold_mass",
    "with_cross_coupling",
    "with_inertia",
]

Array = NDArray[np.float64]

INFINITE = 1e7
"""Times the scale of the pencil: eigenvalues above belong to rows without inertia."""

STEPS_PER_DECADE = 8
"""Values tried in the search of the first that is unstable. Assumption: no stable range is narrower."""

REAL = 1e-9
"""Imaginary part over modulus below which a motion does not oscillate."""

GROWING = 1e-9
"""Real part over modulus up to which a motion is not said to grow: that of an undamped one is round-off."""

STILL = 1e-6
"""Of the speed: eigenvalues below are zero, those of a direction that nothing holds (a double zero splits by the
root of the round-off)."""


@dataclass(frozen=True)
class Mode:
    """A free motion exp(lambda t).

    Attributes
    ----------
    growth, frequency : float
        Real part and positive imaginary part of lambda, 1/s and rad/s.
    whirl : float
        1 where the journal goes round in a circle in the sense of its rotation, -1 against it, 0 on a line.
    share : float
        Of the journal in the square of all amplitudes, 0 to 1; little: a motion of the pads.
    """

    growth: float
    frequency: float
    whirl: float
    share: float

    @property
    def log_decrement(self) -> float:
        """Logarithm of an amplitude over the next one; infinite for a motion that does not oscillate."""
        if self.frequency == 0.0:
            return math.copysign(math.inf, -self.growth)
        return -2.0 * math.pi * self.growth / self.frequency

    @property
    def forward(self) -> bool:
        """Whether the journal whirls in the sense of its rotation."""
        return self.whirl > 0.0

    @property
    def stable(self) -> bool:
        """Whether it does not grow (`GROWING`)."""
        return self.growth <= GROWING * math.hypot(self.growth, self.frequency)


@dataclass(frozen=True)
class Threshold:
    """Where a rotor or its pads begin to whirl.

    Attributes
    ----------
    value : float
        kg, or kg m2 of every pad, or N/m; infinite where none begins up to the highest value tried, 0 where one
        does at the least.
    frequency : float
        Of the motion that begins, rad/s; nan where none does.
    """

    value: float
    frequency: float


def rotor_modes(coefficients: PadCoefficients, mass: float) -> tuple[Mode, ...]:
    """Free motions of a rigid rotor of ``mass`` in kg per bearing, the one that lasts longest first.

    Parameters
    ----------
    coefficients : PadCoefficients
    mass : float
        On the journal; zero: none.

    Returns
    -------
    tuple of Mode
        Conjugate motions once.

    Raises
    ------
    InputError
        E101 for a negative mass.
    """
    if not mass >= 0.0:
        raise InputError("E101", f"mass of the rotor is {mass} kg; it must not be negative.")
    values, vectors = pencil(coefficients, mass)
    modes = []
    for value, vector in zip(values, vectors.T, strict=True):
        if value.imag < -REAL * abs(value):
            continue
        frequency = value.imag if value.imag > REAL * abs(value) else 0.0
        turning = -2.0 * coefficients.sense * float((vector[0].conjugate() * vector[1]).imag)
        of_journal = float((np.abs(vector[:2]) ** 2).sum())
        whirl = turning / of_journal if frequency > 0.0 and of_journal > 0.0 else 0.0
        share = of_journal / float((np.abs(vector) ** 2).sum())
        modes.append(Mode(float(value.real), float(frequency), whirl, share))
    return tuple(sorted(modes, key=lambda mode: -mode.growth))


def pencil(coefficients: PadCoefficients, mass: float) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Finite eigenvalues, 1/s, and their motions in columns, shape (n, values)."""
    from scipy.linalg import eig

    size, speed = len(coefficients.labels), coefficients.speed
    k, c = coefficients.stiffness.copy(), coefficients.damping * speed
    m = coefficients.mass * speed**2
    m[0, 0] += mass * speed**2
    m[1, 1] += mass * speed**2
    stiff = np.abs(np.diag(k)) + np.abs(np.diag(c)) + np.abs(np.diag(m))
    scale = 1.0 / np.sqrt(np.where(stiff > 0.0, stiff, 1.0))
    k, c, m = (scale[:, None] * part * scale for part in (k, c, m))
    one, none = np.eye(size), np.zeros((size, size))
    left = np.block([[none, one], [-k, -c]])
    right = np.block([[one, none], [none, m]])
    (alpha, beta), vectors = eig(left, right, homogeneous_eigvals=True)
    finite = np.abs(alpha) < INFINITE * np.abs(beta)
    values = alpha[finite] / beta[finite]
    values[np.abs(values) < STILL] = 0.0
    return speed * values, scale[:, None] * vectors[:size, finite]


def with_inertia(coefficients: PadCoefficients, inertia: float) -> PadCoefficients:
    """The same with pads of one inertia about their pivots, kg m2."""
    mass = coefficients.mass.copy()
    for place, label in enumerate(coefficients.labels):
        if label.endswith("tilt"):
            mass[place, place] = inertia / coefficients.levers[place] ** 2
    return replace(coefficients, mass=mass)


def with_cross_coupling(coefficients: PadCoefficients, cross_coupling: float) -> PadCoefficients:
    """The same with a cross-coupled stiffness on the rotor, N/m: positive drives its whirl forward."""
    stiffness = coefficients.stiffness.copy()
    stiffness[0, 1] += coefficients.sense * cross_coupling
    stiffness[1, 0] -= coefficients.sense * cross_coupling
    return replace(coefficients, stiffness=stiffness)


def threshold_mass(coefficients: PadCoefficients, least: float, most: float) -> Threshold:
    """Mass of the rotor in kg from which on a motion grows, sought from ``least`` to ``most`` on."""
    return first_unstable(lambda mass: rotor_modes(coefficients, mass), least, most)


def threshold_inertia(coefficients: PadCoefficients, mass: float, least: float, most: float) -> Threshold:
    """Inertia of every pad in kg m2 from which on a rotor of ``mass`` in kg and its pads flutter."""
    return first_unstable(lambda inertia: rotor_modes(with_inertia(coefficients, inertia), mass), least, most)


def threshold_cross_coupling(coefficients: PadCoefficients, mass: float, least: float, most: float) -> Threshold:
    """Cross-coupled stiffness in N/m from which on a motion grows of a rotor of ``mass`` in kg."""
    return first_unstable(lambda cross: rotor_modes(with_cross_coupling(coefficients, cross), mass), least, most)


def first_unstable(modes_at: Callable[[float], tuple[Mode, ...]], least: float, most: float) -> Threshold:
    """First value between two positive ones at which a motion grows: steps of equal ratio, then bisection."""
    if not 0.0 < least < most:
        raise InputError("E101", f"a threshold is sought between {least} and {most}; give 0 < least < most.")
    worst = growing(modes_at(least))
    if worst is not None:
        return Threshold(0.0, worst.frequency)
    count = max(2, math.ceil(STEPS_PER_DECADE * math.log10(most / least)) + 1)
    low = least
    for high in map(float, np.geomspace(least, most, count)[1:]):
        worst = growing(modes_at(high))
        if worst is not None:
            break
        low = high
    else:
        return Threshold(math.inf, math.nan)
    while high - low > 1e-9 * high:
        middle = 0.5 * (low + high)
        found = growing(modes_at(middle))
        if found is None:
            low = middle
        else:
            high, worst = middle, found
    return Threshold(low, worst.frequency)


def growing(modes: tuple[Mode, ...]) -> Mode | None:
    """The motion that grows most, or None."""
    return next((mode for mode in modes if not mode.stable), None)
