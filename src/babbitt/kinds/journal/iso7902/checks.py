"""Verdicts on an operating point in the order of the standard, with the screening rule for whirl."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design.checks import checks_not_made, clearance_check, limit_checks, pressure_check
from babbitt.kinds.journal.iso7902.model import DesignCase

__all__ = ["checks_not_made", "checks_of", "whirl_not_checked"]


def checks_of(case: DesignCase, values: Mapping[str, float]) -> tuple[Check, ...]:
    """Every check that the data of the case allow, in the order of the standard.

    Parameters
    ----------
    case : DesignCase
    values : Mapping[str, float]
        Named results in SI, with the limits among them.
    """
    limits = *limit_checks(case, values), *pressure_check(case, values)
    return (*limits, _whirl_screening(values), clearance_check(case, values))


def whirl_not_checked(case: DesignCase) -> Iterator[Notice]:
    """Say why the mass of a rotor is not compared with a critical one."""
    if case.rotor_mass is not None:
        yield Notice("C115", "iso7902")


def _whirl_screening(values: Mapping[str, float]) -> Check:
    """An indicator: stability is decided by the stiffness and damping of a film solution."""
    return Check(
        "C112",
        "operating_relative_clearance",
        values["operating_relative_clearance"],
        values["stability_relative_clearance"],
        Bound.AT_LEAST,
        "Orlov's screening rule; a film solution decides",
        advisory=True,
    )
