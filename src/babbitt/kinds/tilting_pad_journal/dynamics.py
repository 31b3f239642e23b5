"""Coefficients over the whirl ratio, and free motions of a rotor among its pads, on its shaft and pedestal."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.reynolds.tilting_pads.dynamics import (
    CondensedCoefficients,
    KCMFit,
    PadCoefficients,
    condensed_at,
    condensed_over,
    fit_virtual_mass,
    full_coefficients,
)
from babbitt.reynolds.tilting_pads.pedestal import on_pedestal
from babbitt.reynolds.tilting_pads.rotor import Mode, Threshold, rotor_modes, threshold_mass
from babbitt.reynolds.tilting_pads.solution import TiltingPadSolution

__all__ = [
    "LARGEST_FIT_ERROR",
    "PadDynamics",
    "RotorMotions",
    "bounded_decrement",
    "chain_of",
    "decisive",
    "dynamics_of",
    "motions_of_the_rotor",
    "on_shaft",
    "swinging",
    "with_pedestal",
]

LARGEST_FIT_ERROR = 0.05
"""Relative misfit above which stiffness, damping and mass do not stand for the range of frequencies."""

FEWEST_RATIOS = 3
"""Whirl ratios that a fit of stiffness, damping and mass needs at least."""

HEAVIER, LIGHTER = 1e3, 1e-2
"""Masses over that of the rotor within which its threshold is sought."""

NO_SWING = 100.0
"""Log decrement that stands for infinity: of a motion that grows or dies without swinging."""

LINE = 9
"""Decimals of the whirl of a motion: on a line it is round-off, and the slower motion stands first."""

STILL = 1e-2
"""Frequency over growth below which a motion counts as one that does not swing: equal ones are told apart by
round-off, and others die in a hundredth of a cycle."""


@dataclass(frozen=True, eq=False)
class RotorMotions:
    """Free motions of the rotor of the case, on its shaft where that gives way.

    Attributes
    ----------
    modes : tuple of Mode
        The one that lasts longest first.
    threshold : Threshold
        Of the mass of the rotor.
    """

    modes: tuple[Mode, ...]
    threshold: Threshold

    @property
    def of_the_rotor(self) -> tuple[Mode, ...]:
        """The two motions that swing in which the rotor has the largest shares, the more forward one first."""
        return motions_of_the_rotor(self.modes)

    @property
    def decisive(self) -> Mode:
        """The motion that decides: one that grows, of rotor or pads, else that of the rotor that lasts longer."""
        return decisive(self.modes)

    @property
    def log_decrement(self) -> float:
        """Of the motion that decides."""
        return bounded_decrement(self.decisive)

    @property
    def pad_decrement(self) -> float:
        """The least of all motions but the two of the rotor; infinite where no other swings."""
        others = (mode for mode in swinging(self.modes) if mode not in self.of_the_rotor)
        return min((bounded_decrement(mode) for mode in others), default=math.inf)


@dataclass(frozen=True, eq=False)
class PadDynamics:
    """What a rotor sees of the pads.

    Attributes
    ----------
    bearing : CondensedCoefficients
        Synchronous, of the bearing in a housing at rest.
    full : PadCoefficients
        Of journal and pads, and of the housing on its pedestal. All that follows comes from them.
    static, synchronous : CondensedCoefficients
        At rest, and at the frequency of the rotation.
    over_whirl : tuple of CondensedCoefficients
        At the whirl ratios of the case.
    fit : KCMFit or None
        Over these; None where they are too few.
    motions : RotorMotions or None
        None without the mass of a rotor.
    """

    bearing: CondensedCoefficients
    full: PadCoefficients
    static: CondensedCoefficients
    synchronous: CondensedCoefficients
    over_whirl: tuple[CondensedCoefficients, ...]
    fit: KCMFit | None
    motions: RotorMotions | None


def dynamics_of(case: PadCase, solution: TiltingPadSolution) -> PadDynamics:
    """Dynamics of the pads at a solved place."""
    pads = full_coefficients(solution)
    full = with_pedestal(case, pads, solution)
    positive = [ratio for ratio in case.whirl_ratios if ratio > 0.0]
    fit = fit_virtual_mass(full, positive) if len(positive) >= FEWEST_RATIOS else None
    motions = None
    if case.rotor_mass is not None:
        mass = case.rotor_mass
        chain = chain_of(case, full)
        modes = rotor_modes(chain, mass)
        motions = RotorMotions(modes, threshold_mass(chain, LIGHTER * mass, HEAVIER * mass))
    synchronous = condensed_at(full, 1.0)
    return PadDynamics(
        synchronous if full is pads else condensed_at(pads, 1.0),
        full,
        condensed_at(full, 0.0),
        synchronous,
        condensed_over(full, case.whirl_ratios),
        fit,
        motions,
    )


def with_pedestal(case: PadCase, pads: PadCoefficients, solution: TiltingPadSolution) -> PadCoefficients:
    """Journal and pads, in a housing that moves where the case has a pedestal."""
    return pads if case.pedestal is None else on_pedestal(pads, solution.bearing, case.pedestal)


def chain_of(case: PadCase, coefficients: PadCoefficients) -> PadCoefficients:
    """What carries the mass of the rotor: the bearing, behind the shaft where that gives way."""
    return coefficients if case.shaft_stiffness is None else on_shaft(coefficients, case.shaft_stiffness)


def on_shaft(pads: PadCoefficients, stiffness: float) -> PadCoefficients:
    """Pads behind a shaft of a stiffness in N/m: x and y are the far end of the shaft, where the rotor sits."""
    grown = {name: np.pad(getattr(pads, name), ((2, 0), (2, 0))) for name in ("mass", "damping", "stiffness")}
    for rotor, journal in ((0, 2), (1, 3)):
        ends = np.ix_((rotor, journal), (rotor, journal))
        grown["stiffness"][ends] += stiffness * np.array([[1.0, -1.0], [-1.0, 1.0]])
    return replace(
        pads,
        labels=("x", "y", "journal x", "journal y", *pads.labels[2:]),
        levers=np.concatenate(((1.0, 1.0), pads.levers)),
        **grown,  # type: ignore[arg-type]
    )


def bounded_decrement(mode: Mode) -> float:
    """Log decrement of a motion; one that does not swing has `NO_SWING`, with the sign of its decay."""
    found = mode.log_decrement
    return math.copysign(NO_SWING, found) if math.isinf(found) else found


def swinging(modes: Iterable[Mode]) -> tuple[Mode, ...]:
    """The motions that swing."""
    return tuple(mode for mode in modes if mode.frequency > STILL * abs(mode.growth))


def motions_of_the_rotor(modes: Iterable[Mode]) -> tuple[Mode, ...]:
    """The two motions that swing in which the rotor has the largest shares, the more forward one first."""
    own = sorted(swinging(modes), key=lambda mode: -mode.share)[:2]
    return tuple(sorted(own, key=lambda mode: (-round(mode.whirl, LINE), mode.frequency)))


def decisive(modes: tuple[Mode, ...]) -> Mode:
    """The motion that decides: one that grows, of rotor or pads, else that of the rotor that lasts longer."""
    growing = [mode for mode in modes if not mode.stable]
    return min(growing or motions_of_the_rotor(modes) or modes, key=bounded_decrement)
