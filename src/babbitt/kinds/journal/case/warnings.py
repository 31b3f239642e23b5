"""What of a case may be meant otherwise than it was read, as warnings that ride along to the result."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import is_given, not_read
from babbitt.case.parts.materials import warnings_about_family
from babbitt.core.notices import Notice
from babbitt.kinds.journal.case.film_features import SupplyHoleInput
from babbitt.kinds.journal.case.joined_inputs import Inputs
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.load_direction import DOWNWARD
from babbitt.kinds.journal.case.operating_point import OperatingPoint
from babbitt.kinds.journal.case.supply_element import GrooveElement, UnevenPockets

OF_THE_FILM = (
    "cavitation", "cavitation_pressure", "film_start", "error_estimate", "equilibria", "limiting_speeds",
)  # fmt: skip
OF_THE_ROTOR = ("rotor_mass", "shaft_stiffness")
OF_THE_STANDARD = ("span", "supply_element", "characteristics", "friction.model")
OF_THE_FEED = ("supply.pressure", "supply.tubes", "supply.holes")
NOT_READ = {
    "iso7902": ("shaft_stiffness", *OF_THE_FILM, "accuracy"),
    "film": ("characteristics", "friction.model"),
    "long_film": (*OF_THE_ROTOR, *OF_THE_FILM, *OF_THE_STANDARD, *OF_THE_FEED),
    "segments": (*OF_THE_ROTOR, *OF_THE_FILM, *OF_THE_STANDARD, *OF_THE_FEED, "accuracy"),
}
"""Fields that a method accepts, since a bearing may be compared by several, and does not read."""

LOADED_ZONE = math.radians(75.0)
"""Angle to the load within which a hole has the pressure of the loaded film before it.

Assumption: films with a hole 10 to 30 degrees from the load had a tenth to a half of the film thickness that
ISO 7902 gives, with one 45 degrees from it a third; those at 90 degrees are `place: side`."""


def warnings_about(inputs: Inputs, point: OperatingPoint | None) -> tuple[Notice, ...]:
    """Give every warning about one bearing at one operating point.

    Parameters
    ----------
    inputs : Inputs
    point : OperatingPoint or None
    """
    return (
        *_about_span(inputs.bearing, point),
        *_about_direction(inputs.bearing),
        *inputs.turned_supply,
        *_about_feeds(inputs.bearing),
        *warnings_about_numbers(inputs, point),
    )


def warnings_about_numbers(inputs: Inputs, point: OperatingPoint | None) -> tuple[Notice, ...]:
    """Give the warnings about how one bearing at one operating point is written; what its method does not read."""
    bearing = inputs.bearing.model_copy(update={"operating_points": ()})
    at = () if point is None else ("operating_points", inputs.bearing.operating_points.index(point))
    numbers = about_grouped_digits(bearing), about_grouped_digits(point, *at)
    unused = *_about_fields_not_read(bearing), *_about_supply_not_used(inputs, point)
    metal = inputs.materials.bearing_metal
    other = () if metal is None else tuple(warnings_about_family(metal))
    return (*inputs.shared_warnings, *inputs.of_clearance, *other, *unused, *numbers[0], *numbers[1])


def _about_fields_not_read(bearing: JournalBearing) -> Iterator[Notice]:
    """Report the fields that the method of a bearing does not read."""
    yield from not_read(bearing, bearing.method, *NOT_READ[bearing.method])


def _about_supply_not_used(inputs: Inputs, point: OperatingPoint | None) -> Iterator[Notice]:
    """Tell that the pressure of the supply acts nowhere, where every groove, pocket and hole has its own."""
    bearing, supply = inputs.bearing, inputs.supply
    if supply is None or not bearing.feeds_itself():
        return
    fields = [path for path in OF_THE_FEED if getattr(supply, path.removeprefix("supply.")) not in (None, ())]
    if point is not None and point.supply_pressure is not None:
        fields.append(f"operating_points[{bearing.operating_points.index(point)}].supply_pressure")
    if fields:
        yield Notice("W183", "own_pressures", {"fields": tuple(fields)})


def _about_direction(bearing: JournalBearing) -> Iterator[Notice]:
    """Report that the standard does not know a direction of the load."""
    if is_given(bearing, "load_angle") and bearing.load_angle != DOWNWARD:
        yield Notice("W182", values={"load_angle": bearing.load_angle})


def _about_feeds(bearing: JournalBearing) -> Iterator[Notice]:
    """Report that the standard does not read grooves, pockets and holes at angles in the bore."""
    if given := dict.fromkeys(str(path[0]) for path, _ in bearing.feeds()):
        yield Notice("W183", "supply_element", {"fields": tuple(given)})
    for path, given_feed in bearing.feeds():
        feed = given_feed.feed(bearing.diameter)
        aside = abs(math.remainder(bearing.load_angle - feed.angle, 2.0 * math.pi))
        place = ".".join(map(str, path))
        if aside <= 0.5 * feed.extent:
            yield Notice("W143", "iso7902", {"load_angle": bearing.load_angle, "place": place})
        elif isinstance(given_feed, SupplyHoleInput) and aside < LOADED_ZONE:
            yield Notice("W143", "hole", {"aside": aside, "place": place})


def _about_span(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[Notice]:
    """Warn where a conventional span stands for the arc between uneven pockets."""
    element = bearing.element_at(point)
    if isinstance(element, GrooveElement) and element.kind == "groove_180":
        span = bearing.span_at(point)
        if span is not None and span > 180:
            yield Notice("W188", values={"span": span})
    if not isinstance(element, UnevenPockets):
        return
    conventional, span = element.conventional_span(), bearing.span_at(point)
    yield Notice("W104", values={"exact": conventional.exact, "span": span})
    if conventional.too_short:
        yield Notice("W105", "uneven_pockets", {"exact": conventional.exact, "span": span})
