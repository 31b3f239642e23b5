"""How much destabilising cross-coupling a rotor on two such bearings bears, against what is anticipated.

Level I of API 617: seals and wheels drive the whirl of a rotor forward by a cross-coupled stiffness Q. Its log
decrement falls with Q and vanishes at Q_0; both are asked of the motions of rotor and pads together and, as is
common, of synchronously reduced coefficients.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from babbitt.kinds.tilting_pad_journal.dynamics import bounded_decrement, chain_of, decisive, with_pedestal
from babbitt.kinds.tilting_pad_journal.film import operating_films
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.reynolds.tilting_pads.dynamics import PadCoefficients, full_coefficients, reduced_coefficients
from babbitt.reynolds.tilting_pads.rotor import rotor_modes, threshold_cross_coupling, with_cross_coupling

__all__ = [
    "BEARINGS",
    "CrossCoupling",
    "CrossCouplingMargin",
    "cross_coupling_of",
    "decrements_over",
    "decrements_over_speed",
    "with_decrements_over_speed",
]

BEARINGS = 2
"""That share the cross-coupling of the rotor."""

SOUGHT = 1e-3, 1e3
"""Of the anticipated cross-coupling, between which that without decrement is sought."""

BEYOND = 1.25
"""Times what is asked and what is borne: where the curve of the decrement ends."""

POINTS = 24
"""Of that curve."""

SPEEDS = (0.5, 0.625, 0.75, 0.875, 1.0, 1.125, 1.25)
"""Speeds over that of the case at which the decrement is told, too."""


@dataclass(frozen=True)
class CrossCouplingMargin:
    """Margin by one kind of coefficients.

    Attributes
    ----------
    critical : float
        Cross-coupling of the rotor at which a motion begins to grow, N/m; infinite beyond `SOUGHT`, 0 where one
        grows with none at all.
    frequency : float
        Of that motion, rad/s.
    log_decrement, anticipated_decrement : float
        Without cross-coupling and with that anticipated.
    """

    critical: float
    frequency: float
    log_decrement: float
    anticipated_decrement: float


@dataclass(frozen=True)
class CrossCoupling:
    """Both kinds of coefficients.

    Attributes
    ----------
    anticipated : float
        Of the rotor, N/m.
    full : CrossCouplingMargin
        Of rotor and pads together.
    synchronous : CrossCouplingMargin
        By synchronously reduced coefficients.
    curve : tuple
        Cross-coupling, N/m, and log decrement by both kinds, point after point.
    over_speed : tuple
        Speed, rad/s, and what `decrements_over_speed` tells there, point after point; empty where it is not asked.
    """

    anticipated: float
    full: CrossCouplingMargin
    synchronous: CrossCouplingMargin
    curve: tuple[tuple[float, float, float], ...]
    over_speed: tuple[tuple[float, float, float, float, float], ...] = ()


def cross_coupling_of(case: PadCase, full: PadCoefficients) -> CrossCoupling | None:
    """Cross-coupling of the rotor of a case; None where the case anticipates none.

    Parameters
    ----------
    case : PadCase
    full : PadCoefficients
        Of journal and pads, and of the pedestal.
    """
    anticipated, mass = case.anticipated_cross_coupling, case.rotor_mass
    if anticipated is None or mass is None:
        return None
    chain = chain_of(case, full)
    reduced = chain_of(case, reduced_coefficients(full, 1.0))
    full_margin, synchronous = (margin_of(one, mass, anticipated) for one in (chain, reduced))
    known = [one.critical for one in (full_margin, synchronous) if math.isfinite(one.critical)]
    crosses = np.linspace(0.0, BEYOND * max((2.0 * anticipated, *known)), POINTS).tolist()
    curves = (decrements_over(one, mass, crosses) for one in (chain, reduced))
    return CrossCoupling(anticipated, full_margin, synchronous, tuple(zip(crosses, *curves, strict=True)))


def with_decrements_over_speed(case: PadCase, found: CrossCoupling) -> CrossCoupling:
    """The same with log decrements at speeds about that of the case, each at its own equilibrium."""
    speeds = [share * abs(case.journal_speed) for share in SPEEDS]
    rows = zip(speeds, decrements_over_speed(case, speeds), strict=True)
    return replace(found, over_speed=tuple((speed, *row) for speed, row in rows))


def margin_of(chain: PadCoefficients, mass: float, anticipated: float) -> CrossCouplingMargin:
    """Margin by coefficients of a rotor of ``mass`` in kg per bearing."""
    each = anticipated / BEARINGS
    found = threshold_cross_coupling(chain, mass, SOUGHT[0] * each, SOUGHT[1] * each)
    without, driven = decrements_over(chain, mass, (0.0, anticipated))
    return CrossCouplingMargin(BEARINGS * found.value, found.frequency, without, driven)


def decrements_over(chain: PadCoefficients, mass: float, crosses: Sequence[float]) -> list[float]:
    """Log decrement of the motion that decides at every cross-coupling of the rotor, N/m."""
    return [
        bounded_decrement(decisive(rotor_modes(with_cross_coupling(chain, cross / BEARINGS), mass)))
        for cross in crosses
    ]


def decrements_over_speed(case: PadCase, speeds: Sequence[float]) -> list[tuple[float, float, float, float]]:
    """Log decrements at several speeds in rad/s, each at the equilibrium of its films.

    Without cross-coupling and with that anticipated by rotor and pads together, then both by synchronously reduced
    coefficients; nan at speeds without equilibrium.
    """
    assert case.rotor_mass is not None
    assert case.anticipated_cross_coupling is not None
    rows = []
    for speed in speeds:
        found = operating_films(replace(case, journal_speed=case.sense * speed))
        if found.film is None or not found.outcome.solved:
            rows.append((math.nan,) * 4)
            continue
        solution = found.film.solution
        full = with_pedestal(case, full_coefficients(solution), solution)
        crosses = 0.0, case.anticipated_cross_coupling
        chains = chain_of(case, full), chain_of(case, reduced_coefficients(full, 1.0))
        (a, b), (c, d) = (decrements_over(one, case.rotor_mass, crosses) for one in chains)
        rows.append((a, b, c, d))
    return rows
