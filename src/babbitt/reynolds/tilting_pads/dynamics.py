"""Stiffness, damping and mass of journal and pads together, and what a rotor sees of them at a frequency.

The motions are q = (x, y | of every pad its tilt as a length s, the way u of its pivot, v along tau where that
gives way, and its bending where it bends). A film feels r = (xi, eta) = B q, with bending as a third part, and by
virtual work acts with B^T F; so

    K = sum B^T K_f B + pivots,    C = sum B^T C_f B + damping of pivots,    M: pads,

and a rotor that moves with exp(j w t) sees Z = K + j w C - w^2 M with the pads eliminated. Source: the method of
J. W. Lund, Trans. ASLE 7 (1964) 342, and of P. E. Allaire, J. K. Parsell, L. E. Barrett, Wear 72 (1981) 29,
written for several motions of a pad.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.tilting_pads.bending_mode import BendingMode
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.solution import PadState, PadStatus, TiltingPadSolution

__all__ = [
    "CondensedCoefficients",
    "KCMFit",
    "PadCoefficients",
    "condensed_at",
    "condensed_over",
    "fit_virtual_mass",
    "full_coefficients",
    "impedance",
    "reduced_coefficients",
]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

JOURNAL = ("x", "y")


@dataclass(frozen=True, eq=False)
class PadCoefficients:
    """Matrices of journal and pads, M q'' + C q' + K q = forces, in SI.

    Attributes
    ----------
    labels : tuple of str
        x and y of the journal, then of every pad with a film ``pad N tilt`` (s, the tilt times the lever of its
        pivot, m), ``pad N pivot`` (u) and ``pad N tangential`` (v) where the pivot gives way along n and along
        tau, and ``pad N bending`` (q). Numbers from 1.
    mass, stiffness, damping : ndarray, shape (n, n)
        kg, N/m, N s/m. The journal has no mass here.
    levers : ndarray, shape (n,)
        What makes a length of the tilt in rad, m: the lever of the pivot; 1 for all other motions.
    speed : float
        Angular speed of the journal, rad/s, without its sign.
    sense : float
        1 for a journal that turns counter-clockwise, -1 for a clockwise one.
    """

    labels: tuple[str, ...]
    mass: Array
    stiffness: Array
    damping: Array
    levers: Array
    speed: float
    sense: float = 1.0


@dataclass(frozen=True, eq=False)
class CondensedCoefficients:
    """What a rotor sees at one frequency, pads eliminated.

    Attributes
    ----------
    whirl_ratio : float
        Frequency over speed.
    stiffness, damping : ndarray, shape (2, 2)
        N/m and N s/m.
    """

    whirl_ratio: float
    stiffness: Array
    damping: Array


@dataclass(frozen=True, eq=False)
class KCMFit:
    """Stiffness, damping and virtual mass that stand for a range of frequencies.

    Attributes
    ----------
    stiffness, damping, mass : ndarray, shape (2, 2)
        N/m, N s/m, kg: Z = K - w^2 M + j w C.
    errors : ndarray, shape (2, 2)
        Root of the mean square misfit of every element of Z over the root of its mean square.
    whirl_ratios : ndarray, shape (n,)
    """

    stiffness: Array
    damping: Array
    mass: Array
    errors: Array
    whirl_ratios: Array

    @property
    def error(self) -> float:
        """The larger misfit of both elements on the diagonal."""
        return float(np.diag(self.errors).max())


def full_coefficients(solution: TiltingPadSolution) -> PadCoefficients:
    """Matrices of journal and pads, linearised at a solution.

    Pads without load have no film that answers, and do not occur.

    Raises
    ------
    InputError
        E101 for a bearing that was not solved.
    """
    if not solution.outcome.solved:
        raise InputError("E101", "the bearing was not solved; coefficients need a position that is an answer.")
    bearing = solution.bearing
    chosen = [
        (number, pad, state, own_motions(pad, state))
        for number, (pad, state) in enumerate(zip(bearing.pads, solution.pads, strict=True), 1)
        if state.status is PadStatus.LOADED
    ]
    size = 2 + sum(len(own) for *_, own in chosen)
    mass, damping, stiffness = (np.zeros((size, size)) for _ in range(3))
    parts = 3 * len(chosen)
    felt, springs, dampers = np.zeros((parts, size)), np.zeros((parts, parts)), np.zeros((parts, parts))
    labels, levers = list(JOURNAL), [1.0] * size
    for row, (number, pad, state, own) in zip(range(0, len(felt), 3), chosen, strict=True):
        first = len(labels)
        block = slice(first, first + len(own))
        fill_film_motions(felt[row : row + 3], pad, own, first)
        answer, end = (state, row + 2) if state.bend is None else (state.bend, row + 3)
        springs[row:end, row:end], dampers[row:end, row:end] = answer.stiffness, answer.damping
        fill_pad(bearing, pad, state, own, mass[block, block], damping[block, block], stiffness[block, block])
        levers[first] = bearing.lever(pad)
        labels += [f"pad {number} {name}" for name in own]
    stiffness += felt.T @ springs @ felt
    damping += felt.T @ dampers @ felt
    return PadCoefficients(
        tuple(labels), mass, stiffness, damping, np.array(levers), abs(bearing.angular_speed), bearing.sense
    )


def own_motions(pad: TiltingPad, state: PadState) -> tuple[str, ...]:
    """Names of the motions of a pad."""
    names = ["tilt"]
    if math.isfinite(state.pivot_stiffness):
        names.append("pivot")
    if math.isfinite(pad.tangential_stiffness):
        names.append("tangential")
    if state.bend is not None:
        names.append("bending")
    return tuple(names)


def fill_film_motions(rows: Array, pad: TiltingPad, own: Sequence[str], first: int) -> None:
    """Matrix B of a pad, shape (3, size): xi = n q - u, eta = tau q - v + s, and its bending where it bends."""
    cosine, sine = math.cos(pad.pivot_angle), math.sin(pad.pivot_angle)
    rows[0, 0] = rows[1, 1] = cosine
    rows[0, 1], rows[1, 0] = sine, -sine
    for column, name in enumerate(own, first):
        row, sign = FELT[name]
        rows[row, column] = sign


FELT = {"tilt": (1, 1.0), "pivot": (0, -1.0), "tangential": (1, -1.0), "bending": (2, 1.0)}
"""In which part of (xi, eta, bending) a film feels a motion of its pad, and with which sign."""


def fill_pad(
    bearing: TiltingPadBearing, pad: TiltingPad, state: PadState, own: Sequence[str], mass: Array, damping: Array,
    stiffness: Array,
) -> None:  # fmt: skip
    """Fill mass, damping and stiffness of a pad and its pivot in its own motions, those of the film left out.

    With b_g and a_g the distances of the centre of gravity from the pivot along tau and towards the centre of the
    bearing, a tilt moves it outward by -b_g delta and along tau by -a_g delta:
    M = (J, -m b_g, -m a_g; -m b_g, m, 0; -m a_g, 0, m) in (delta, u, v). Bending moves m times the mean of psi^2,
    which is not coupled with the others.
    """
    lever = bearing.lever(pad)
    mass[0, 0] = pad.inertia / lever**2
    damping[0, 0] = pad.rotational_damping / lever**2
    stiffness[0, 0] = pad.rotational_stiffness / lever**2
    for place, name in enumerate(own[1:], 1):
        if name == "bending":
            mass[place, place] = pad.mass * BendingMode.of(pad).mean_square
            stiffness[place, place] = pad.bending_stiffness
            continue
        mass[place, place] = pad.mass
        if name == "pivot":
            mass[0, place] = mass[place, 0] = -bearing.sense * pad.mass * pad.mass_offset / lever
            damping[place, place], stiffness[place, place] = pad.pivot_damping, state.pivot_stiffness
        else:
            mass[0, place] = mass[place, 0] = -pad.mass * pad.mass_inset / lever
            damping[place, place], stiffness[place, place] = pad.tangential_damping, pad.tangential_stiffness


def impedance(coefficients: PadCoefficients, frequency: float | Array) -> Complex:
    """Complex stiffness Z = K + j w C - w^2 M that the journal sees at w in rad/s, shape (2, 2).

    Of frequencies of shape (n, 1, 1) it is of shape (n, 2, 2).
    """
    k, c, m = coefficients.stiffness, coefficients.damping, coefficients.mass
    z: Complex = k - frequency**2 * m + 1j * frequency * c
    if len(k) == 2:
        return z
    return z[..., :2, :2] - z[..., :2, 2:] @ np.linalg.solve(z[..., 2:, 2:], z[..., 2:, :2])


def condensed_over(
    coefficients: PadCoefficients, whirl_ratios: Sequence[float]
) -> tuple[CondensedCoefficients, ...]:
    """`condensed_at` for each of several whirl ratios."""
    moving = [ratio for ratio in whirl_ratios if ratio > 0.0]
    seen = iter(impedance(coefficients, np.array(moving)[:, None, None] * coefficients.speed))
    return tuple(
        in_motion(coefficients, ratio, next(seen)) if ratio > 0.0 else condensed_at(coefficients, ratio)
        for ratio in whirl_ratios
    )


def in_motion(coefficients: PadCoefficients, whirl_ratio: float, z: Complex) -> CondensedCoefficients:
    """Stiffness and damping of the impedance at a whirl ratio above zero."""
    return CondensedCoefficients(whirl_ratio, z.real, z.imag / (whirl_ratio * coefficients.speed))


def condensed_at(coefficients: PadCoefficients, whirl_ratio: float) -> CondensedCoefficients:
    """Stiffness and damping at a whirl ratio, 1: synchronous, 0: static (with the damping of slow motion).

    Raises
    ------
    InputError
        E101 for a negative whirl ratio.
    """
    if not whirl_ratio >= 0.0:
        raise InputError("E101", f"whirl_ratio is {whirl_ratio}; it must be zero or more.")
    if whirl_ratio > 0.0:
        return in_motion(coefficients, whirl_ratio, impedance(coefficients, whirl_ratio * coefficients.speed))
    k, c, pads = coefficients.stiffness, coefficients.damping, slice(2, None)
    if k.shape[0] == 2:
        return CondensedCoefficients(0.0, k, c)
    # d Z/d(j w) at rest: the pads follow by -K_PP^-1 K_PJ, their forces return by -K_JP K_PP^-1
    follow = -np.linalg.solve(k[pads, pads], k[pads, :2])
    back = -np.linalg.solve(k[pads, pads].T, k[:2, pads].T).T
    stiffness = k[:2, :2] + k[:2, pads] @ follow
    damping = c[:2, :2] + c[:2, pads] @ follow + back @ c[pads, :2] + back @ c[pads, pads] @ follow
    return CondensedCoefficients(0.0, stiffness, damping)


def reduced_coefficients(coefficients: PadCoefficients, whirl_ratio: float) -> PadCoefficients:
    """The journal alone, with the stiffness and damping of one whirl ratio at every frequency.

    What these say about stability is an approximation: `rotor` says why.
    """
    condensed = condensed_at(coefficients, whirl_ratio)
    return replace(
        coefficients,
        labels=JOURNAL,
        mass=np.zeros((2, 2)),
        stiffness=condensed.stiffness,
        damping=condensed.damping,
        levers=np.ones(2),
    )


def fit_virtual_mass(coefficients: PadCoefficients, whirl_ratios: ArrayLike) -> KCMFit:
    """Least squares fit of Re Z by K - w^2 M and of Im Z by w C over whirl ratios, element by element.

    Raises
    ------
    InputError
        E101 for fewer than three ratios, or one that is not positive.
    """
    ratios = np.asarray(whirl_ratios, dtype=np.float64)
    if ratios.size < 3 or not np.all(ratios > 0.0):
        raise InputError(
            "E101", "a fit of stiffness, damping and mass needs three whirl ratios or more, above zero."
        )
    w = ratios * coefficients.speed
    z = impedance(coefficients, w[:, None, None])
    basis = np.stack([np.ones_like(ratios), -(ratios**2)], axis=1)
    (k, m), *_ = np.linalg.lstsq(basis, z.real.reshape(ratios.size, 4), rcond=None)
    c = (w[:, None] * z.imag.reshape(-1, 4)).sum(axis=0) / (w**2).sum()
    fitted = basis @ np.stack([k, m]) + 1j * w[:, None] * c
    misfit = np.sqrt((np.abs(fitted - z.reshape(-1, 4)) ** 2).sum(axis=0))
    size = np.sqrt((np.abs(z.reshape(-1, 4)) ** 2).sum(axis=0))
    errors = np.divide(misfit, size, out=np.zeros(4), where=size > 0.0)
    return KCMFit(
        k.reshape(2, 2), c.reshape(2, 2), m.reshape(2, 2) / coefficients.speed**2, errors.reshape(2, 2), ratios
    )
