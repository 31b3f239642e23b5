"""Values, checks and warnings of the cross-coupling that a rotor bears, and of the pedestal."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Matrix
from babbitt.kinds.tilting_pad_journal.cross_coupling import SOUGHT, CrossCoupling
from babbitt.kinds.tilting_pad_journal.dynamics import PadDynamics
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.values import flat, plain, rows_of

__all__ = [
    "LEAST_RATIO",
    "STABILITY_CHECKS",
    "about_synchronous_verdict",
    "cross_coupling_checks",
    "cross_coupling_not_checked",
    "cross_coupling_rows",
    "cross_coupling_values",
    "pedestal_rows",
    "pedestal_values",
]

STABILITY_CHECKS = ("C401", "C406", "C407")
"""Log decrement, threshold over anticipated cross-coupling, and the decrement with the latter."""

LEAST_RATIO = 2.0
RATIO_SOURCE = "level I of API 617: twice the anticipated cross-coupling"
REGION_COUNTS = 10.0
"""Q_0/Q_A below which level I of API 617 asks for the region of critical speed ratio and gas density, too; below
the least ratio level II follows anyway."""


def cross_coupling_values(found: CrossCoupling | None) -> dict[str, float]:
    """By rotor and pads together, and by synchronously reduced coefficients."""
    if found is None:
        return {}
    named = {
        "anticipated_cross_coupling": found.anticipated,
        "synchronous_log_decrement": found.synchronous.log_decrement,
    }
    for prefix, one in (("", found.full), ("synchronous_", found.synchronous)):
        named[f"{prefix}log_decrement_anticipated"] = one.anticipated_decrement
        if math.isfinite(one.critical):
            named[f"{prefix}critical_cross_coupling"] = one.critical
            named[f"{prefix}cross_coupling_ratio"] = one.critical / found.anticipated
    return named


def cross_coupling_rows(found: CrossCoupling | None) -> dict[str, Matrix]:
    """The curves of the log decrement."""
    if found is None:
        return {}
    curves = {"decrement_over_cross_coupling": found.curve, "decrement_over_speed": found.over_speed}
    return {name: curve for name, curve in curves.items() if curve}


def cross_coupling_checks(
    case: PadCase, values: Mapping[str, float], least: float, source: str
) -> Iterator[Check]:
    """Level I of API 617; ``least`` log decrement and its ``source`` as without cross-coupling."""
    if case.anticipated_cross_coupling is None:
        return
    if "cross_coupling_ratio" in values:
        ratio = values["cross_coupling_ratio"]
        yield Check("C406", "cross_coupling_ratio", ratio, LEAST_RATIO, Bound.AT_LEAST, RATIO_SOURCE)
    decrement = values["log_decrement_anticipated"]
    yield Check("C407", "log_decrement_anticipated", decrement, least, Bound.AT_LEAST, source)


def cross_coupling_not_checked(case: PadCase, values: Mapping[str, float]) -> Iterator[Notice]:
    """What lacks a number."""
    if case.anticipated_cross_coupling is None:
        return
    if "cross_coupling_ratio" not in values:
        yield Notice("C406")
    elif LEAST_RATIO <= values["cross_coupling_ratio"] < REGION_COUNTS:
        yield Notice("C408")


def about_synchronous_verdict(values: Mapping[str, float], least: Iterable[float]) -> Iterator[Notice]:
    """Synchronously reduced coefficients that would come to the other verdict by one of the least decrements."""
    if "log_decrement_anticipated" not in values:
        return
    full, reduced = (
        [
            values.get(f"{prefix}cross_coupling_ratio", math.inf) >= LEAST_RATIO
            and values[f"{prefix}log_decrement_anticipated"] >= one
            for one in least
        ]
        for prefix in ("", "synchronous_")
    )
    if full != reduced:
        yield Notice("W414", values={
            "ratio": values.get("synchronous_cross_coupling_ratio", SOUGHT[1]),
            "decrement": values["synchronous_log_decrement_anticipated"],
        })  # fmt: skip


def pedestal_values(case: PadCase, films: PadFilms) -> dict[str, float]:
    """Way of the housing under the load."""
    if case.pedestal is None:
        return {}
    across, up = case.pedestal.deflection(flat(plain(-films.solution.force)))
    return {"pedestal_x": across, "pedestal_y": up}


def pedestal_rows(case: PadCase, dynamics: PadDynamics) -> dict[str, Matrix]:
    """Coefficients of the bearing in a housing at rest."""
    if case.pedestal is None:
        return {}
    alone = dynamics.bearing
    return {"bearing_stiffness": rows_of(alone.stiffness), "bearing_damping": rows_of(alone.damping)}
