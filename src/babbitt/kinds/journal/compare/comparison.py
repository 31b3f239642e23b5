"""A journal bearing by every method and option that applies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.kinds.journal.case.build import (
    bearings_of,
    design_cases_of,
    iso7902_cases,
    long_films_of,
    unknown_to_iso7902,
    unknown_to_long_film,
)
from babbitt.kinds.journal.case.fed_machine import refuse_oil_system
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.one_dimension import METHODS as ONE_DIMENSIONAL
from babbitt.kinds.journal.compare.grooved_films import (
    groove_direction,
    grooved_films,
    unknown_to_grooved_films,
    with_groove_angles,
)
from babbitt.kinds.journal.compare.one_dimension import long_film_variants, segment_variants
from babbitt.kinds.journal.compare.temperature_cost import cost_of_one_temperature
from babbitt.kinds.journal.compare.thermal_variants import (
    GLOBAL,
    OWN,
    ThermalVariant,
    describe_factor,
    left_out_of_thermal_variants,
    thermal_variants,
)
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import DEVIATIONS
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import WIDTH_RATIOS as CLOSED_FORM_WIDTH_RATIOS
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase, Friction
from babbitt.kinds.journal.methods import METHODS
from babbitt.reynolds.model import Cavitation, FilmStart
from babbitt.study.comparison import Comparison, Variant

__all__ = ["compare", "unknown_to_closed_forms"]

FRICTION_LABELS = {
    Friction.FULL: ("film all around", "neglects that the film ruptures outside the loaded arc"),
    Friction.ARC: ("film on the arc", "neglects friction of the oil outside the loaded arc"),
    Friction.CURVE360: ("360° friction curve", "neglects the influence of the span on friction"),
}


CAVITATION_LABELS = {
    Cavitation.MASS_CONSERVING: (
        "film",
        "as the film of one temperature, but lets it begin again only where oil reaches it",
    ),
    Cavitation.REYNOLDS: (
        "film, Reynolds",
        "as the film of one temperature, but reforms it without asking where the oil comes from",
    ),
}

HALF_SOMMERFELD = ("film, half-Sommerfeld", "counts suctions of the full film as nothing; knows no flow")

ISO_LABEL = "ISO 7902"
CLOSED_FORMS = "closed forms"

LONG_FILM = (
    "long film",
    "finds the temperature along the film and of the journal; neglects that oil leaves at the sides, and so "
    "carries far too much",
)


COMPARED = (
    "sommerfeld_number",
    "eccentricity_ratio",
    "attitude_angle",
    "groove_angle_from_load",
    "groove_angle_from_gap",
    "groove_pressure",
    "minimum_film_thickness",
    "effective_temperature",
    "outlet_temperature",
    "starved_outlet_temperature",
    "starved_minimum_film_thickness",
    "maximum_temperature",
    "maximum_bush_temperature",
    "maximum_wall_temperature",
    "journal_temperature",
    "bearing_temperature",
    "friction_power",
    "starved_friction_power",
    "film_dissipation",
    "heat_to_oil",
    "heat_film_to_bush",
    "heat_film_to_journal",
    "heat_to_surroundings",
    "side_flow",
    "supply_flow",
    "total_flow",
    "film_flow",
    "flow_inconsistency",
    "maximum_pressure",
    "film_reynolds_number",
    "critical_mass",
    "whirl_frequency_ratio",
    "threshold_speed",
)
"""What is put side by side."""

FLOWS = (
    "Q₃ and Q_p of the standard and of the film are not alike: the standard adds what the film pumps and what the "
    "supply pressure presses through the bearing, the film tells what of its oil would flow without that pressure "
    "and what more flows with it. Only their sum Q compares."
)
"""What one must know of the flows of standard and film."""

AROUND = (
    "Where one finds temperatures around the bore, those in the middle of the width, hottest across the gap, "
    "stand below beside the single ones; beside a groove the film may be hotter."
)
"""Of the figure."""

COST = "What one temperature costs"
"""Heading of what films of one temperature miss."""


def compare(case: CaseFile) -> tuple[Comparison, ...]:
    """Solve every journal bearing of a case by every method and variant that applies to it."""
    refuse_oil_system(case)
    return tuple(found for bearing in bearings_of(case) for found in _compared(bearing, case))


def _comparison(name: str, variants: Iterable[Variant], left_out: str) -> Comparison:
    found = Comparison(
        name, tuple(variants), COMPARED, left_out, heading=COST, draw=comparison_drawing, caption=AROUND
    )
    flows = FLOWS if {ISO_LABEL, GLOBAL} <= {one.label for one in found.methods} else ""
    return replace(found, sentences=tuple(cost_of_one_temperature(found)), note=flows)


def comparison_drawing(comparison: Comparison) -> Any:
    """Draw the figure of a comparison; None where no method has found a film with a temperature."""
    from babbitt.kinds.journal.compare.figure import comparison_figure
    from babbitt.report.comparison_figure import is_shown

    return comparison_figure(comparison) if any(map(is_shown, comparison.variants)) else None


def _compared(bearing: JournalBearing, case: CaseFile) -> Iterator[Comparison]:
    if bearing.method in ONE_DIMENSIONAL:
        yield from _compared_in_one_dimension(bearing, case)
        return
    standard, long_films = iso7902_cases(bearing, case), long_films_of(bearing, case)
    for index, films in enumerate(thermal_variants(bearing, case)):
        by_standard = _variants(standard[index]) if standard else ()
        if long_films:
            label, remark = LONG_FILM
            remark += describe_factor(bearing)
            by_standard = (
                *by_standard,
                Variant(label, remark, METHODS["long_film"].solve_one(long_films[index]), detail=1),
            )
        by_film = tuple(_film_variant(one) for one in films)
        ordered = (*by_film, *by_standard) if bearing.method == "film" else (*by_standard, *by_film)
        plain = next((one.case for one in films if one.label == GLOBAL), films[0].case)
        among = (*ordered, *_cavitation_variants(plain))
        methods = (one for one in among if one.is_method)
        ranked = (*methods, *(one for one in among if not one.is_method))
        yield _comparison(films[0].case.name, ranked, "\n".join(_left_out(bearing, case)))


def _compared_in_one_dimension(bearing: JournalBearing, case: CaseFile) -> Iterator[Comparison]:
    """The models of one dimension; a grooved bearing is answered in two dimensions, too."""
    for index, design in enumerate(design_cases_of(bearing, case)):
        if isinstance(design, LongFilmCase):
            yield _comparison(design.name, [Variant(*one) for one in long_film_variants(design)], "")
        elif isinstance(design, SegmentCase):
            found = [Variant(*one) for one in segment_variants(design)]
            reason = unknown_to_grooved_films(bearing, design, case)
            if not reason:
                place = groove_direction(design, found[0].result)
                for label, remark, film, groove in grooved_films(bearing, case, index, design, place):
                    solution = METHODS["film"].solve_one(film)
                    seen = replace(solution, result=with_groove_angles(solution.result, film, groove))
                    found.append(Variant(label, remark, seen, detail=1))
            left_out = f"the film in two dimensions is left out: {reason}" if reason else ""
            yield _comparison(design.name, found, left_out)


def _left_out(bearing: JournalBearing, case: CaseFile) -> Iterator[str]:
    """Which methods do not apply to a bearing, and why."""
    reasons = {
        f"{ISO_LABEL} is": unknown_to_iso7902(bearing, case),
        f"{' and '.join(OWN.values())} are": left_out_of_thermal_variants(bearing, case),
        f"{LONG_FILM[0]} is": unknown_to_long_film(bearing, case),
        f"{CLOSED_FORMS} are": next(_beyond_closed_forms(bearing, case), ""),
    }
    yield from (f"{which} left out: {reason}" for which, reason in reasons.items() if reason)


def _beyond_closed_forms(bearing: JournalBearing, case: CaseFile) -> Iterator[str]:
    full = (design for design in iso7902_cases(bearing, case) if design.bearing.span == 360)
    yield from filter(None, map(unknown_to_closed_forms, full))


def _film_variant(one: ThermalVariant) -> Variant:
    label, remark = one.label, one.remark
    if one.case.cavitation is not Cavitation.MASS_CONSERVING:
        rupture, said = CAVITATION_LABELS.get(one.case.cavitation, HALF_SOMMERFELD)
        remark = said if label == GLOBAL else f"{remark}; {said}"
        label += rupture.removeprefix("film")
    return Variant(label, remark, METHODS["film"].solve_one(one.case), detail=2 + one.detail)


def _cavitation_variants(film: FilmCase) -> tuple[Variant, ...]:
    """The same film with the conditions of rupture that the case does not ask for."""
    found = []
    for cavitation, (label, remark) in CAVITATION_LABELS.items():
        unfed = film.bearing.film_start is not FilmStart.GROOVE and not film.bearing.feeds
        if cavitation is film.cavitation or (unfed and cavitation is Cavitation.MASS_CONSERVING):
            continue
        other = replace(film, cavitation=cavitation)
        found.append(Variant(label, remark, METHODS["film"].solve_one(other), is_method=False))
    return tuple(found)


def unknown_to_closed_forms(design: DesignCase) -> str:
    """Why the closed forms do not reach a full bearing, in words; empty where they do."""
    (least, most), ratio = CLOSED_FORM_WIDTH_RATIOS, design.bearing.part_width_ratio
    return "" if least <= ratio <= most else f"they hold for B/D {least:g} to {most:g}, and it is {ratio:.3g}"


def _variants(design: DesignCase) -> tuple[Variant, ...]:
    common = "assumes one temperature for the whole film; rupture as on a centred arc; rigid parallel surfaces"
    found = [Variant(ISO_LABEL, common, METHODS["iso7902"].solve_one(design))]
    if design.bearing.span < 360:  # all friction models agree on a full bearing
        for model, (label, remark) in FRICTION_LABELS.items():
            other = replace(design, friction=model)
            if other != design:
                found.append(Variant(label, remark, METHODS["iso7902"].solve_one(other), is_method=False))
    elif design.curves is Curves.COMPUTED and not unknown_to_closed_forms(design):
        closed = replace(design, curves=Curves.CLOSED_FORM)
        deviates = f"deviates by up to {100.0 * DEVIATIONS['sommerfeld_number']:.0f} % in So (DIN 31652 fits)"
        found.append(Variant(CLOSED_FORMS, deviates, METHODS["iso7902"].solve_one(closed), is_method=False))
    return tuple(found)
