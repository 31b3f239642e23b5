"""Tilting pads by every thermal model, and how far the numbers move with what is assumed of their heat."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from babbitt.case.parts.walls import ConductingJournalInput
from babbitt.core.notices import InputError
from babbitt.core.quantities import AXES, QUANTITIES
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase
from babbitt.kinds.tilting_pad_journal.case.build import pad_cases
from babbitt.kinds.tilting_pad_journal.case.heat import PadJournalWalls
from babbitt.kinds.tilting_pad_journal.methods import PAD_FILM
from babbitt.kinds.tilting_pad_journal.model import PadCase, Thermal
from babbitt.kinds.tilting_pad_journal.sensitivity import MOVED, Assumption, assumptions
from babbitt.study.comparison import Comparison, Variant

__all__ = ["compare"]

GIVEN_TEMPERATURE = "takes the given temperature for all films, whatever heat they make"
REMARKS = {
    Thermal.ISOTHERMAL: "takes the temperature of the fresh oil for all films: neglects that they heat themselves",
    Thermal.GLOBAL: "one temperature for all films, from friction and fresh oil; neglects that pads differ",
    Thermal.ADIABATIC: "finds the temperature at every place of the films and of the oil between the pads; "
    "neglects the heat that journal and pads take, and that the journal carries from hot pads to cold ones",
    Thermal.FULL: "as adiabatic films, with a journal of one temperature",
}
"""What each model sees and neglects, from the simplest to the fullest."""
LABELS = {
    Thermal.GLOBAL: "one temperature",
    Thermal.ADIABATIC: "adiabatic films",
    Thermal.FULL: "full thermal films",
}

COMPARED = (
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "maximum_pressure",
    "effective_temperature",
    "outlet_temperature",
    "maximum_temperature",
    "probe_temperature",
    "journal_temperature",
    "friction_power",
    "heat_to_oil",
    "heat_to_pads",
    "total_flow",
    "running_clearance",
    *(f"{name}_{axes}" for name in ("stiffness", "damping") for axes in AXES),
    "log_decrement",
    "threshold_mass",
)
"""What is put side by side."""

SPREAD = "What assumptions move"
"""Heading of these sentences."""


def compare(case: TiltingPadJournalCase) -> tuple[Comparison, ...]:
    """Solve every operating point by every thermal model; that of the case stands first.

    Parameters
    ----------
    case : TiltingPadJournalCase
        Its walls and deformation count for full thermal films alone.
    """
    plain = case.model_copy(update={"assumption_sensitivity": False})  # here it is columns
    return tuple(compared(plain, index, problem) for index, problem in enumerate(pad_cases(plain)))


def compared(case: TiltingPadJournalCase, index: int, problem: PadCase) -> Comparison:
    """One operating point by every thermal model, and with other numbers in place of those assumed."""
    asked = by_model(problem)
    found, left_out = [asked], []
    for thermal in Thermal:
        if thermal is problem.thermal:
            continue
        if problem.oil_supply is None:
            left_out.append(f"{thermal.value} is left out: the temperature of the fresh oil is not given")
            continue
        if thermal.is_resolved and problem.turbulence is not None:
            left_out.append(f"{thermal.value} is left out: films with their own temperatures are laminar")
            continue
        try:
            found.append(by_model(pad_cases(with_thermal(case, thermal))[index]))
        except InputError as error:  # the films of one model may need more oil than is supplied
            left_out.append(f"{thermal.value} is left out: {error.message}")
    sentences: list[str] = []
    for assumption in assumptions(problem):
        ends: list[Variant | None] = []
        for end in (assumption.low, assumption.high):
            try:
                ends.append(None if math.isnan(end) else at_one_end(assumption, end))
            except InputError as error:
                ends.append(None)
                left_out.append(f"one end of {assumption.label} is left out: {error.message}")
        found += [one for one in ends if one is not None]
        sentences += spread(assumption, ends[0], asked, ends[1])
    return Comparison(
        problem.name, tuple(found), COMPARED, "\n".join(left_out), tuple(sentences), heading=SPREAD, draw=drawing
    )


def drawing(comparison: Comparison) -> Any:
    """Draw the figure of a comparison; None where no method has found films with a temperature."""
    from babbitt.report.comparison_figure import methods_figure

    return methods_figure(comparison)


def with_thermal(case: TiltingPadJournalCase, thermal: Thermal) -> TiltingPadJournalCase:
    """The same case by another thermal model, without what its films do not read."""
    changes: dict[str, object] = {"thermal": thermal.value}
    if thermal is not Thermal.FULL:
        journal = ConductingJournalInput(temperature=case.walls.journal.temperature)
        changes |= {"walls": PadJournalWalls(housing=case.walls.housing, journal=journal)}
    if thermal.is_resolved or case.thermal_model == "full":  # films of one temperature bend pads by their own
        changes |= {"deformation": ()}
    return case.model_copy(update=changes)


def by_model(problem: PadCase) -> Variant:
    """One bearing by its thermal model."""
    thermal, remark = problem.thermal, REMARKS[problem.thermal]
    label, heat, supply = LABELS.get(thermal, ""), problem.heat, problem.oil_supply
    if thermal is Thermal.ISOTHERMAL:
        assert problem.effective_temperature is not None
        label = f"films at {problem.effective_temperature - ZERO_CELSIUS:.4g} °C"
        if supply is None or supply.temperature != problem.effective_temperature:
            remark = GIVEN_TEMPERATURE
    if thermal is Thermal.FULL:
        counted = (("pads that conduct", heat.walls), ("bend", heat.bending), ("grow", heat.growth))
        words = [name for name, given in counted if given is not None]
        remark += f"; with {', '.join(words)}" if words else "; neglects the heat that pads take"
    return Variant(label, remark, PAD_FILM.solve_one(problem), detail=list(Thermal).index(thermal))


def at_one_end(assumption: Assumption, end: float) -> Variant:
    """The bearing with less or more of what is assumed."""
    remark = f"as the case, with {assumption.written(end, assumption.base, between=' in place of ')}"
    return Variant(
        f"{assumption.label} {assumption.written(end)}",
        remark,
        PAD_FILM.solve_one(assumption.at(end)),
        is_method=False,
    )


def spread(assumption: Assumption, low: Variant | None, asked: Variant, high: Variant | None) -> Iterator[str]:
    """Low, base and high of what an assumption moves, in a sentence; nothing where only the base has a film."""
    columns = [
        (value, one.result.values if one.result.outcome.solved else {})
        for value, one in zip((assumption.low, assumption.base, assumption.high), (low, asked, high), strict=True)
        if one is not None
    ]
    if sum(bool(values) for _, values in columns) < 2:
        return
    said = []
    for name in MOVED:
        known = [values.get(name) for _, values in columns]
        if not any(known):  # films of one temperature have no highest
            continue
        quantity = QUANTITIES[name].suited(*(one for one in known if one is not None))
        unit = quantity.display.label
        between = f" {unit}, " if None in known else ", "  # a number alone, next to a dash, has its unit
        cells = between.join("–" if one is None else quantity.format(one) for one in known)
        said.append(f"{quantity.symbol} {cells} {unit}")
    yield f"{assumption.label} {assumption.written(*(value for value, _ in columns))}: {'; '.join(said)}."
