"""Design check of a shaft line: losses, films, frequencies, causes, and what would help."""

from __future__ import annotations

import math
from collections.abc import Iterator
from time import perf_counter

from babbitt.core.notices import Notice
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.kinds.shaft_line.admissible_amplitude import limits_of
from babbitt.kinds.shaft_line.answer import line_answer
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.inverse import AdmissibleAmplitude
from babbitt.kinds.shaft_line.resonance import NEAR
from babbitt.kinds.shaft_line.values import bearables, line_arrays, line_values
from babbitt.kinds.shaft_line.warnings import line_warnings
from babbitt.kinds.thrust.assumed import oil_assumptions
from babbitt.kinds.thrust.failures import NoPadFilmError
from babbitt.kinds.thrust.margins import warnings_about_margins
from babbitt.kinds.thrust.pressure_limits import pressures_not_checked
from babbitt.kinds.thrust.warnings import sharing_warnings
from babbitt.kinds.thrust.work import MOST_WORK, WorkBoundError, bounded_work

__all__ = ["line_solution"]

METHOD = "frequency domain"
SEPARATION_SOURCE = "usual practice for shaft vibration: 20 % from any excitation"


def line_solution(design: LineDesign) -> Solution:
    """Check a shaft line, with a bound on the work (`babbitt.kinds.thrust.work`).

    Parameters
    ----------
    design : LineDesign

    Returns
    -------
    Solution
        Its result has a status in every case; its state is the answer of the line, None where pads find no film.
    """
    start = perf_counter()
    try:
        with bounded_work(MOST_WORK):
            answer = line_answer(design)
    except (NoPadFilmError, WorkBoundError) as error:
        failed = Result(
            design.name,
            design.kind,
            METHOD,
            Outcome.of(error.failure),
            {},
            failure=error.failure,
            warnings=design.thrust.warnings,
            assumptions=(
                *design.thrust.oil.assumed_of_lubricant,
                *design.thrust.assumptions,
                *_assumptions(design),
            ),
        )
        return Solution(design, failed)
    values = line_values(design, answer)
    values["wall_time"] = perf_counter() - start
    thrust, checks = design.thrust, tuple(_checks(design, values))
    result = Result(
        design.name,
        design.kind,
        METHOD,
        Outcome.CONVERGED,
        values,
        checks,
        (
            *thrust.warnings,
            *sharing_warnings(thrust, answer.static),
            *line_warnings(design, answer),
            *warnings_about_margins(thrust.oil, checks, values),
        ),
        (
            *_not_checked(design),
            *thrust.temperatures.not_checked(values),
            *pressures_not_checked(thrust.temperatures.given_metal),
        ),
        (
            *design.thrust.oil.assumed_of_lubricant,
            *thrust.assumptions,
            *_assumptions(design),
            *thrust.temperatures.assumptions(),
        ),
        settings={
            "lubricant": design.lubricant.name,
            "pivot": thrust.bearing.pad.pivot.value,
            "rods": str(len(design.line.rods)),
            **{f"{name}_ends": _end(name, one) for name, one in bearables(answer).items()},
        },
        arrays=line_arrays(design, answer),
    )
    return Solution(design, result, answer)


def _end(name: str, bearable: AdmissibleAmplitude) -> str:
    """What an admissible amplitude ends with: a code, "no film", or "no limit below" where it was sought."""
    if math.isfinite(bearable.largest):
        return bearable.code or "no film"
    quantity = QUANTITIES[name]
    return f"no limit below {quantity.format(bearable.sought)} {quantity.display.label}"


def _checks(design: LineDesign, values: dict[str, float]) -> Iterator[Check]:
    yield from limits_of(design, values)
    if "frequency_separation" in values:
        yield Check(
            "C204",
            "frequency_separation",
            values["frequency_separation"],
            NEAR,
            Bound.AT_LEAST,
            SEPARATION_SOURCE,
            advisory=True,
        )


def _not_checked(design: LineDesign) -> Iterator[Notice]:
    if not (design.thrusts or design.runouts):
        yield Notice("C201")
    if design.axial_limit is None:
        yield Notice("C205")


def _assumptions(design: LineDesign) -> Iterator[str]:
    yield "Linear films about the static share, tilts of the pads free and with their inertia; axial motion only."
    yield from oil_assumptions(design.thrust.oil)
    if design.thrust.oil.supply_temperature is not None:
        yield "Each pad takes in what a pad under its own load sends off, mixed with fresh oil."
    if design.line.seating is None:
        yield "The seating is rigid: a flexible one lowers the first frequency, typically by a fifth at 2 GN/m."
    if design.speeds:
        yield "Over speed, thrust and ripple grow with its square; runout and tilt stay."
