"""Warnings: where the result leaves the ground on which the standard stands."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from babbitt.core.limited_flow import limited
from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.oil import usable_viscosity
from babbitt.design.own_limits import asked_for_margins, missed_but_for_own
from babbitt.design.screening import STANDARD_GRAVITY
from babbitt.design.span import TABULATED_SPANS
from babbitt.design.warnings import (
    RIGID_FILM_UP_TO,
    warnings_about_film,
    warnings_about_hole,
    warnings_about_pressure,
    warnings_about_running,
    warnings_about_supply,
)
from babbitt.kinds.journal.feed_pressure import SHARE_OF_LOAD, throttling
from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import DEVIATIONS, LARGEST_ATTITUDE_DEVIATION
from babbitt.kinds.journal.iso7902.film import SuppliedFilm
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase
from babbitt.kinds.journal.iso7902.screening import Transition
from babbitt.kinds.journal.iso7902.supply import (
    FIT_RANGE,
    LOGARITHM_UP_TO,
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
    fitted_width,
)
from babbitt.kinds.journal.one_temperature import (
    checks_of_metal,
    warnings_about_heat_left_out,
    warnings_about_margins,
    warnings_about_unknown_metal,
)
from babbitt.numerics.scalar_or_array import functions_for, larger

STANDARD_WIDTH_RATIOS = (0.125, 1.0)
"""Range of B/D in the tables of the standard."""

CURVES_FROM = 0.01
"""Eccentricity ratio at which the computed characteristics begin."""


SURELY_SCREENED = 0.1
"""Margin of Orlov's screening from which a rotor of the mass that the bearing carries does not whirl.

Assumption: of 400 random bearings that kept it (``benchmarks/whirl_screening.py``) no film of one temperature
whirls under its load as a mass; one of another 194 does, which kept it by 0.3 % (docs/theory/screening.md)."""

HEAVIER = 1.1
"""Weight of the rotor over the load above which the screening says nothing (an assumption).

It was tried with masses that the bearing carries as its load, and knows no mass; a tenth is rounding."""

PRESSURE_OF_LOAD = 0.5
"""Supply pressure over specific load from which W192 warns (assumption).

ISO 7902-1 presupposes a feed pressure that is negligible beside those of the film. Films with a pocket of 20 deg
opposite the load are 5 % thinner at half the specific load."""

OVERRIDING_PRESSURE, OVERRIDING_FORCE = 6.0, 0.5
"""The same two shares from which the supply leaves no verdict (W198; assumptions).

What the standard leaves out is there a quarter of the film thickness: in films of one temperature a hole opposite
the load takes 17 to 33 % at 4 to 8 times the specific load, a pocket of 60 deg 26 to 35 % at 0.46 to 0.7 of the
load (docs/theory/supply.md). Margins that other remarks ask for do not cover that as well."""

LOSS_AT_EDGE = 0.25
"""Share of the film thickness that the slope of the shaft may take at an edge without a remark (an assumption)."""

NOTABLE_SHARE = 0.05
"""Share of the film thickness by which a span wider than the arc that is left may flatter it (an assumption)."""


def all_warnings(
    case: DesignCase,
    film: SuppliedFilm,
    values: Mapping[str, float],
    checks: tuple[Check, ...],
    replaced: tuple[Check, ...],
    change: Transition | None,
) -> tuple[Notice, ...]:
    """All warnings that this operating point deserves."""
    return (
        *case.warnings,
        *_of_method(case, values),
        *_of_free_arcs(case, values),
        *_of_supply(case, film),
        *warnings_about_feed_pressure(case, values),
        *missed_but_for_own(checks, replaced),
        *_of_running(case, values, checks, replaced, change),
    )


def warnings_about_validity(case: DesignCase, values: Mapping[str, float]) -> Iterator[Notice]:
    """Those of any film, and the eccentricity ratio where ISO 7902 ends."""
    yield from (warning for warning in warnings_about_film(case, values) if warning.code != "W116")
    eccentricity = values["eccentricity_ratio"]
    if eccentricity > RIGID_FILM_UP_TO:
        yield Notice("W129", "iso7902", {"eccentricity_ratio": eccentricity, "limit": RIGID_FILM_UP_TO})


def _of_method(case: DesignCase, values: Mapping[str, float]) -> Iterator[Notice]:
    yield from warnings_about_validity(case, values)
    yield from warnings_about_pressure(
        larger(values["maximum_pressure"], values.get(limited("maximum_pressure"), 0.0))
    )
    least, most = STANDARD_WIDTH_RATIOS
    if not least <= case.bearing.part_width_ratio <= most:
        part = "half" if case.bearing.parts > 1 else "whole"
        ratio = case.bearing.part_width_ratio
        yield Notice("W102", part, {"width_ratio": ratio, "least": least, "most": most})
    if case.curves is Curves.CLOSED_FORM:
        yield Notice("W113", values={
            "load": DEVIATIONS["sommerfeld_number"],
            "angle": math.radians(DEVIATIONS["attitude_angle_degrees"]),
            "largest_angle": math.radians(LARGEST_ATTITUDE_DEVIATION),
        })  # fmt: skip
    eccentricity = values["eccentricity_ratio"]
    if eccentricity < CURVES_FROM:
        yield Notice("W119", values={"eccentricity_ratio": eccentricity, "first": CURVES_FROM})
    if case.bearing_speed:
        yield Notice("W114")


def warnings_about_feed_pressure(case: DesignCase, values: Mapping[str, float]) -> Iterator[Notice]:
    """Whether the supply pressure is small beside what the film carries, as the standard presupposes."""
    pressure, element = values.get("element_pressure", 0.0), case.bearing.supply_element
    if element is None or pressure <= 0.0:
        return
    against = pressure / values["specific_load"]
    pressed = 0.0
    if isinstance(element, Pockets | HalfCircumferentialGroove):
        pressed = pressure * element.pressed_area(case.bearing.diameter) / values["load"]
    if against <= PRESSURE_OF_LOAD and pressed <= SHARE_OF_LOAD:
        return
    code = "W198" if against > OVERRIDING_PRESSURE or pressed > OVERRIDING_FORCE else "W192"
    pressing: tuple[Notice, ...] = ()
    if pressed > SHARE_OF_LOAD:
        pressing = (Notice(code, "pressing", {"share": pressed}),)
    warming = throttling(code, pressure, values["volumetric_heat_capacity"])
    yield Notice(code, "pressure", {
        "element_pressure": pressure, "share": against, "pressing": pressing, "warming": warming,
    })  # fmt: skip


def warnings_about_slope(
    case: DesignCase, values: Mapping[str, float], checks: tuple[Check, ...]
) -> Iterator[Notice]:
    """What the slope of the shaft takes from the film at an edge, of which that of the standard knows nothing.

    Parameters
    ----------
    case : DesignCase
    values : Mapping[str, float]
        Named results of the film.
    checks : tuple of Check
    """
    loss = case.bearing.edge_loss
    if loss == 0.0:
        return
    film = values.get("starved_minimum_film_thickness", values["minimum_film_thickness"])
    misses = any(one.code == "C101" and one.ok and one.value - loss < one.limit for one in checks)
    slope, share = case.bearing.axis_slope, loss / film
    if loss >= film:
        yield Notice("W173", "touches", {"slope": slope, "loss": loss, "film": film})
    elif misses:
        yield Notice("W173", "misses", {"slope": slope, "loss": loss, "film": film, "share": share})
    elif share > LOSS_AT_EDGE:
        yield Notice("W173", "large", {"slope": slope, "loss": loss, "film": film, "share": share})
    else:
        yield Notice("W159", values={"slope": slope, "loss": loss, "film": film, "share": share})


def _of_free_arcs(case: DesignCase, values: Mapping[str, float]) -> Iterator[Notice]:
    """Whether pockets and grooves leave less arc about the load than the span, and what film that has."""
    for arc in case.free_arcs:
        degrees = functions_for(arc.extent).degrees(arc.extent)
        if case.bearing.span <= degrees + 1e-6:
            continue
        if degrees < TABULATED_SPANS[-1] - 1e-6 and arc.certain:
            yield Notice("W105", "free_arc", {
                "left_by": arc.left_by, "arc": arc.extent, "span": case.bearing.span,
            })  # fmt: skip
            continue
        thin, full = _film_on_arc(case, values, degrees), values["minimum_film_thickness"]
        if thin < (1.0 - NOTABLE_SHARE) * full or degrees < TABULATED_SPANS[-1] - 1e-6:
            wide = larger(degrees, float(TABULATED_SPANS[-1]))
            taken = functions_for(wide).radians(wide)
            where = Notice("W189", "arc", {"left_by": arc.left_by, "arc": arc.extent, "span": case.bearing.span})
            if thin > 0.0:
                yield Notice("W189", "film", {"where": where, "taken": taken, "thin": thin, "full": full})
            else:
                yield Notice("W189", "no_film", {"where": where, "taken": taken})


def _film_on_arc(case: DesignCase, values: Mapping[str, float], degrees: float) -> float:
    """Least film in m under the same load number on an arc, between those of tabulated arcs; 0 without one."""
    wide = min((span for span in TABULATED_SPANS if span >= degrees), default=TABULATED_SPANS[0])
    narrow = max((span for span in TABULATED_SPANS if span <= degrees), default=TABULATED_SPANS[-1])
    clearance = values["operating_relative_clearance"] * case.bearing.diameter / 2.0
    films = []
    for span in (narrow, wide):
        shape, load_number = curves(span, case.bearing.part_width_ratio), values["sommerfeld_number"]
        if load_number > shape.largest_sommerfeld_number:
            return 0.0
        films.append(clearance * (1.0 - shape.eccentricity_ratio(load_number)))
    share = 0.0 if wide <= narrow else (degrees - narrow) / (wide - narrow)
    return films[0] + share * (films[1] - films[0])


def _of_supply(case: DesignCase, film: SuppliedFilm) -> Iterator[Notice]:
    element = case.bearing.supply_element
    if film.feed is not None:
        yield from warnings_about_supply(film.feed.limit, film.side_flow)
    if element is None:
        return
    if isinstance(element, Holes) and case.oil_supply is not None:
        supply, passed = case.oil_supply, film.total_flow
        if film.supply_capacity is not None and film.supply_capacity < film.side_flow:
            passed = film.supply_capacity
        holes = element.number * (2.0 if element.arrangement is Arrangement.BOTH_SIDES else 1.0)
        density = case.lubricant.density(supply.temperature)
        yield from warnings_about_hole(supply, element.diameter, passed / holes, density)
    if isinstance(element, CircumferentialGroove | HalfCircumferentialGroove):
        s = element.relative_width(case.bearing.width)
        if s > FIT_RANGE[1]:
            yield Notice("W103", "groove", {"share": s, "most": FIT_RANGE[1]})
    if isinstance(element, Holes | Pockets):
        s = element.relative_width(case.bearing.width)
        if not FIT_RANGE[0] - 1e-9 <= s <= FIT_RANGE[1] + 1e-9:
            least, most = FIT_RANGE
            lies = Notice("W103", "lies_outside", {
                "share": s, "least": least, "most": most, "taken": fitted_width(s),
            })  # fmt: skip
            if s > LOGARITHM_UP_TO:
                times = math.log(LOGARITHM_UP_TO) / functions_for(s).log(s)
                yield Notice("W103", "logarithm", {"lies": lies, "logarithm": LOGARITHM_UP_TO, "times": times})
            elif s > most:
                yield Notice("W196", values={"lies": lies})
            else:
                yield Notice("W103", "narrow", {"lies": lies})
    if isinstance(element, Holes) and element.axial_extent is not None:
        share = element.axial_extent / case.bearing.width
        if share > LOGARITHM_UP_TO:
            yield Notice("W103", "slot", {"share": share, "most": LOGARITHM_UP_TO})


def _of_running(
    case: DesignCase,
    values: Mapping[str, float],
    checks: tuple[Check, ...],
    replaced: tuple[Check, ...],
    change: Transition | None,
) -> Iterator[Notice]:
    yield from warnings_about_running(case, values, checks)
    viscosity, held = usable_viscosity(case.lubricant), asked_for_margins(checks, replaced)
    yield from warnings_about_slope(case, values, held)
    yield from warnings_about_margins(held, values, checks_of_metal(case.limits), viscosity)
    yield from warnings_about_unknown_metal(case, checks, values)
    yield from warnings_about_heat_left_out(case, values)
    screening = next((check for check in checks if check.code == "C112"), None)
    if case.rotor_mass is not None and screening is not None and screening.ok:
        heavier = case.rotor_mass * STANDARD_GRAVITY / values["load"]
        if heavier > HEAVIER:
            yield Notice(
                "W194", "heavy", {"rotor_mass": case.rotor_mass, "load": values["load"], "times": heavier}
            )
    if case.rotor_mass is not None and screening is not None and screening.margin < SURELY_SCREENED:
        yield Notice("W194", "kept" if screening.ok else "missed", {
            "rotor_mass": case.rotor_mass, "eccentricity_ratio": values["eccentricity_ratio"],
            "margin": screening.margin,
        })  # fmt: skip
    if change is not None and change.beyond_tables:
        yield Notice("W112", "upper_bound")
