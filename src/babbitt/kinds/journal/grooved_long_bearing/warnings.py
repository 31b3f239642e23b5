"""Warnings about a film by segments."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.infinite_width import warnings_about_width
from babbitt.design.own_limits import checks_by_experience, missed_but_for_own
from babbitt.design.warnings import warnings_about_film, warnings_about_running
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentCase
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState
from babbitt.kinds.journal.grooved_long_bearing.ungrooved_reference import UngroovedReference
from babbitt.kinds.journal.one_dimension import warnings_about_oil_range, warnings_about_thickness
from babbitt.properties.lubricants import PowerLaw

POWER_LAW_RANGE = (293.15, 393.15)
"""K, 20 to 120 °C: where the source uses the power law of viscosity."""

ROUGHNESS_FACTOR = 3.0
"""Least film over the combined rms roughness σ = sqrt(Rq_B² + Rq_J²) without a warning: above about 3 σ surfaces
are apart (B. J. Hamrock, Fundamentals of Fluid Film Lubrication, 1994)."""

RMS_OVER_MEAN = 1.25
"""Rq/Ra of heights that are distributed normally, sqrt(pi/2) = 1.253."""


def warnings_of_solution(
    case: SegmentCase,
    state: SegmentFilmState,
    plain: UngroovedReference | None,
    values: dict[str, float],
    checks: tuple[Check, ...],
) -> Iterator[Notice]:
    """Everywhere the result leaves the ground on which it stands; `plain` are the ungrooved films beside it."""
    yield from case.warnings
    yield from warnings_about_width(case, values)
    yield from warnings_about_thickness(case)
    if plain is not None:
        yield from _warnings_about_groove(case, state, plain)
    outside = list(_warnings_about_temperature(case, state))
    yield from outside
    if case.bearing.roughness is not None:
        combined = RMS_OVER_MEAN * math.hypot(*case.bearing.roughness)
        if values["minimum_film_thickness"] < ROUGHNESS_FACTOR * combined:
            yield Notice("W155", values={
                "minimum_film_thickness": values["minimum_film_thickness"],
                "factor": ROUGHNESS_FACTOR,
                "roughness": combined,
            })  # fmt: skip
    codes = {notice.code for notice in outside}
    yield from (notice for notice in warnings_about_film(case, values) if notice.code not in codes)
    yield from warnings_about_running(case, values, checks)
    yield from missed_but_for_own(checks, checks_by_experience(case, values))


def _warnings_about_groove(
    case: SegmentCase, state: SegmentFilmState, plain: UngroovedReference
) -> Iterator[Notice]:
    ungrooved = plain.same_load
    if ungrooved is not None and state.outlet_temperature > ungrooved.outlet_temperature:
        yield Notice("W153", values={
            "outlet_temperature": state.outlet_temperature, "without": ungrooved.outlet_temperature,
            "eccentricity_ratio": state.eccentricity_ratio, "instead_of": ungrooved.eccentricity_ratio,
        })  # fmt: skip
    if state.segments[-1].friction_power == 0.0:
        first = state.segments[0]
        yield Notice("W157", values={
            "end": first.segment.end, "outlet_temperature": first.outlet_temperature,
        })  # fmt: skip
    if state.short_of_oil:
        yield Notice("W154")
    elif case.groove is not None and case.groove.kind is GrooveKind.BLIND and plain.same_gap is not None:
        ahead, cut = state.load / plain.same_gap.load, plain.cut_same_gap
        if ahead > 1.0 and cut is not None:
            yield Notice("W156", values={"ahead": ahead, "cut": state.load / cut.load})


def _warnings_about_temperature(case: SegmentCase, state: SegmentFilmState) -> Iterator[Notice]:
    by_power_law = isinstance(case.lubricant.viscosity_law, PowerLaw)
    reached = [t for one in state.segments for t in (one.inlet_temperature, one.outlet_temperature)]
    known = POWER_LAW_RANGE if by_power_law else case.lubricant.temperature_range
    return warnings_about_oil_range(case, min(reached), max(reached), known)
