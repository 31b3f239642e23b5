"""From a case with journal bearings, as the engineer wrote it, to problems: numbers in SI, all choices made."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import TypeVar

from babbitt.case.case_file import CaseFile
from babbitt.core.result_name import ResultName
from babbitt.core.solution import Calculation
from babbitt.kinds.journal.case import one_dimension
from babbitt.kinds.journal.case.film_cases import film_case
from babbitt.kinds.journal.case.iso7902_cases import iso7902_case
from babbitt.kinds.journal.case.joined_inputs import Inputs, Point, every_clearance, inputs
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.machine import SeveralBearings, SingleBearing
from babbitt.kinds.journal.case.one_dimension_cases import long_film_case, segment_case
from babbitt.kinds.journal.case.operating_point import OperatingPoint
from babbitt.kinds.journal.case.standard_rules import (
    film_alone_knows,
    half_bearings_are_in_the_tables,
    width_is_in_the_closed_forms,
    width_is_in_the_tables,
)
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.methods import METHODS
from babbitt.kinds.journal.problems import JournalDesign

DesignT = TypeVar("DesignT")

Maker = Callable[[Inputs, Point], DesignT]


def calculations(case: CaseFile) -> tuple[Calculation, ...]:
    """Expand a case into one problem per bearing, operating point and clearance, each with its bearing's method.

    Parameters
    ----------
    case : CaseFile
        With one journal bearing, or with those of a machine.

    Returns
    -------
    tuple of Calculation
        In the order of the file. Names are ``Bearing``, ``Bearing [point]``, ``Bearing (minimum clearance)``,
        ``Bearing [point] (minimum clearance)``.
    """
    return tuple(
        Calculation(problem, METHODS[bearing.method])
        for bearing in bearings_of(case)
        for problem in design_cases_of(bearing, case)
    )


def design_cases_of(bearing: JournalBearing, case: CaseFile) -> tuple[JournalDesign, ...]:
    """Design cases of one bearing of a case, by the method that it names."""
    match bearing.method:
        case "film":
            return film_cases(bearing, case)
        case "long_film":
            return tuple(_expanded(bearing, case, long_film_case))
        case "segments":
            return tuple(_expanded(bearing, case, segment_case))
        case _:
            return iso7902_cases(bearing, case)


def bearings_of(case: CaseFile) -> tuple[JournalBearing, ...]:
    """Journal bearings of a case; empty for any other kind."""
    match case:
        case SeveralBearings():
            return case.bearings
        case SingleBearing():
            return (case,)
        case _:
            return ()


def iso7902_cases(bearing: JournalBearing, case: CaseFile) -> tuple[DesignCase, ...]:
    """Design cases of ISO 7902 of one bearing of a case, whatever method it names; empty if the standard knows
    it not.

    Empty where `unknown_to_iso7902` says why.
    """
    if unknown_to_iso7902(bearing, case):
        return ()
    return tuple(_expanded(bearing, case, _beside_film))


def _beside_film(inputs: Inputs, at: Point) -> DesignCase:
    """Design case of ISO 7902, with the film of the bearing that has temperatures of its own."""
    return replace(iso7902_case(inputs, at), fuller_film=film_case(inputs, at).with_own_temperatures())


def unknown_to_iso7902(bearing: JournalBearing, case: CaseFile) -> str:
    """Why the standard does not know a bearing, in words; empty where it does.

    It knows what ``method: iso7902`` is not refused for, the choices of the film method apart.
    """
    unfit = (
        next(film_alone_knows(bearing, "it"), None)
        or next(width_is_in_the_tables(bearing), None)
        or next(half_bearings_are_in_the_tables(bearing), None)
        or next(width_is_in_the_closed_forms(bearing), None)
    )
    if unfit is not None:
        return unfit.says
    if any(bearing.span_at(point) is None for point in bearing.operating_points or (None,)):
        return "it needs the angular span of the loaded arc; give span, such as 'span: 180 deg'"
    supply = inputs(bearing, case).supply if isinstance(case, SingleBearing | SeveralBearings) else None
    for point in bearing.operating_points or (None,):
        own = point is not None and (point.supply_pressure is not None or point.supply_flow is not None)
        fed = point.supply_pressure if own and point is not None else None if supply is None else supply.pressure
        if supply is not None and fed is None:
            return "it takes a supply pressure, not a flow, nor grooves with pressures of their own alone"
    return ""


def film_cases(bearing: JournalBearing, case: CaseFile, thermal: str | None = None) -> tuple[FilmCase, ...]:
    """Film cases of one bearing of a case, whatever method it names.

    Parameters
    ----------
    bearing : JournalBearing
    case : CaseFile
    thermal : str, optional
        ``global``, ``adiabatic`` or ``full`` in place of what the bearing says.
    """
    seen = bearing.model_copy(update={"method": "film"})
    return tuple(_expanded(seen, case, partial(film_case, thermal=thermal)))


def long_films_of(bearing: JournalBearing, case: CaseFile) -> tuple[LongFilmCase, ...]:
    """The bearing as an infinitely long film, whatever method it names.

    Empty where `unknown_to_long_film` says why.
    """
    if unknown_to_long_film(bearing, case):
        return ()
    seen = bearing.without_friction_factor().model_copy(update={"method": "long_film"})
    return tuple(_expanded(seen, case, long_film_case))


def unknown_to_long_film(bearing: JournalBearing, case: CaseFile) -> str:
    """Why the infinitely long film does not know a bearing, in words; empty where it does."""
    unfit = next(one_dimension.unknown(bearing, "it"), None)
    if unfit is not None:
        return unfit.says
    supply = inputs(bearing, case).supply if isinstance(case, SingleBearing | SeveralBearings) else None
    return "" if supply is not None and supply.temperature is not None else "it needs the temperature of fresh oil"


def _expanded(bearing: JournalBearing, case: CaseFile, make: Maker[DesignT]) -> Iterator[DesignT]:
    if not isinstance(case, SingleBearing | SeveralBearings):
        return
    joined = inputs(bearing, case)
    relative = bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter)
    tolerance = (relative.minimum, relative.maximum) if relative.minimum < relative.maximum else None
    every = every_clearance(bearing, case)
    for point in bearing.operating_points or (None,):
        of_point = _turned(joined, point)
        for clearance_case in ("minimum", "mean", "maximum") if every else ("mean",):
            name = ResultName(bearing.name, "" if point is None else point.name, clearance_case if every else "")
            at = Point(name, point, clearance_case, getattr(relative, clearance_case), tolerance, relative.mean)
            yield make(of_point, at)


def _turned(joined: Inputs, point: OperatingPoint | None) -> Inputs:
    """The bearing with the direction of the load of an operating point that has one of its own."""
    if point is None or point.load_angle is None:
        return joined
    return replace(joined, bearing=joined.bearing.model_copy(update={"load_angle": point.load_angle}))
