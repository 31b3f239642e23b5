"""Verdicts on an operating point in the order of the standard, with the screening rule for whirl."""

from __future__ import annotations

from collections.abc import Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design import checks as design_checks
from babbitt.design.checks import clearance_check, limit_checks
from babbitt.kinds.journal.iso7902.model import DesignCase

__all__ = ["checks_not_made", "checks_of"]


def checks_of(case: DesignCase, values: Mapping[str, float]) -> tuple[Check, ...]:
    """Every check that the data of the case allow, in the order of the standard.

    Parameters
    ----------
    case : DesignCase
    values : Mapping[str, float]
        Named results in SI, with the limits among them.
    """
    return (*limit_checks(case, values), _whirl_screening(values), clearance_check(case, values))


def checks_not_made(case: DesignCase, values: Mapping[str, float]) -> tuple[Notice, ...]:
    """The checks that lack data, and that of the rotor's mass, for which the standard has no coefficients."""
    missing = design_checks.checks_not_made(case, values)
    if case.rotor_mass is None:
        return missing
    return (
        *missing,
        Notice("C115", "ISO 7902 has neither stiffness nor damping; `method: film` compares rotor_mass"),
    )


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
