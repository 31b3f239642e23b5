"""The same bearing by every method and option that applies, side by side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from babbitt.case import Case
from babbitt.case.build import (
    bearings_of,
    design_cases_of,
    iso7902_cases,
    long_films_of,
    unknown_to_iso7902,
    unknown_to_long_film,
)
from babbitt.case.designs import AnyDesign
from babbitt.case.every_kind import HydrostaticBearing
from babbitt.core.notices import InputError
from babbitt.core.result import Result
from babbitt.kinds.footstep.case.footstep import ScrewHeelCase
from babbitt.kinds.footstep.study.comparison import compare_heels
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.one_dimension import METHODS
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.check import long_film_check
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902 import DesignCase, check
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import DEVIATIONS
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import WIDTH_RATIOS as CLOSED_FORM_WIDTH_RATIOS
from babbitt.kinds.journal.iso7902.model import Curves, Friction
from babbitt.kinds.journal.study.grooved_films import (
    groove_direction,
    grooved_films,
    unknown_to_grooved_films,
    with_groove_angles,
)
from babbitt.kinds.journal.study.one_dimension import long_film_variants, segment_variants
from babbitt.kinds.journal.study.thermal_variants import (
    GLOBAL,
    OWN,
    ThermalVariant,
    left_out_of_thermal_variants,
    said_of_factor,
    thermal_variants,
)
from babbitt.reynolds.model import Cavitation, FilmStart
from babbitt.solving import solve_design


@dataclass(frozen=True)
class Variant:
    """One way to compute a bearing, and what it assumes or neglects.

    Attributes
    ----------
    label, remark : str
    result : Result
    design : DesignCase or FilmCase or None
        What the result was computed from.
    is_method : bool
        False: differs from a method in one choice only, and is shown apart.
    detail : int
        Methods are shown in this order, from those that see least to those that see most.
    """

    label: str
    remark: str
    result: Result
    design: AnyDesign | None = None
    is_method: bool = True
    detail: int = 0


@dataclass(frozen=True)
class Comparison:
    """All ways to compute one bearing; the first is the one the case asks for, `left_out` says which do not apply
    and why, a line for each."""

    name: str
    variants: tuple[Variant, ...]
    left_out: str = ""

    @property
    def asked(self) -> Variant:
        """The method that the case asks for."""
        return self.variants[0]

    @property
    def methods(self) -> list[Variant]:
        """Methods of their own, from that which sees least to that which sees most."""
        return sorted((one for one in self.variants if one.is_method), key=lambda one: one.detail)

    @property
    def choices(self) -> list[Variant]:
        """What differs from a method in one choice only."""
        return [one for one in self.variants if not one.is_method]


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


def compare_methods(case: Case) -> tuple[Comparison, ...]:
    """Solve every bearing of a case by every method and variant that applies to it.

    Parameters
    ----------
    case : Case

    Returns
    -------
    tuple of Comparison
        The method that the case names stands first in each; the standard is left out where it does not know the
        bearing.

    Raises
    ------
    InputError
        E004 when the case has no bearing with a film.
    """
    if isinstance(case, ScrewHeelCase):
        heels = (Variant(heel.label, heel.remark, heel.result) for heel in compare_heels(case))
        return (Comparison(case.name, tuple(heels)),)
    if isinstance(case, HydrostaticBearing):
        return (_hydrostatic(case),)
    bearings = bearings_of(case)
    if not bearings:
        raise InputError("E004", f"{case.name}: {ONE_METHOD.get(case.kind, OTHER_KINDS).format(kind=case.kind)}")
    return tuple(found for bearing in bearings for found in _compared(bearing, case))


ONE_METHOD = {
    "thrust": "thrust pads have one film method, there is nothing to compare; to see what its options do, solve "
    "copies of the case with another thermal or turbulence, or vary a field with babbitt sweep",
    "thrust_line": "a shaft line has one method, there is nothing to compare; its report sets runout, ripple, "
    "tilt and rings side by side (babbitt solve --report), and babbitt sweep varies a field",
}
OTHER_KINDS = "a case of kind {kind!r} has one method; there is nothing to compare"

HYDROSTATIC_REMARKS = {
    "film": "sees corners, interaction and rupture; assumes one viscosity for the whole film",
    "quick": "closed forms and lumped lands; neglects corners of unequal lands and squeeze between recesses",
}
JACKING_REMARKS = {
    "film": "sees how far the pressure spreads around the bore, where the gap hardly opens beside the pocket",
    "quick": "counts pressure on the pocket and half of its axial lands and none around the bore: a smaller area, "
    "so that the same load seems to need more pressure, flow and power",
}


def _hydrostatic(case: HydrostaticBearing) -> Comparison:
    design = case.design()
    remarks = JACKING_REMARKS if isinstance(design, JackingCase) else HYDROSTATIC_REMARKS
    found, left_out = [Variant(design.method, remarks[design.method], solve_design(design))], ""
    for other in remarks.keys() - {design.method}:
        try:
            found.append(Variant(other, remarks[other], solve_design(replace(design, method=other))))
        except InputError as error:  # closed forms do not reach every shape
            left_out = f"{other} is left out: {error.message}"
    return Comparison(design.name, tuple(found), left_out)


def _compared(bearing: JournalBearing, case: Case) -> Iterator[Comparison]:
    if bearing.method in METHODS:
        yield from _compared_in_one_dimension(bearing, case)
        return
    standard, long_films = iso7902_cases(bearing, case), long_films_of(bearing, case)
    for index, films in enumerate(thermal_variants(bearing, case)):
        by_standard = _variants(standard[index]) if standard else ()
        if long_films:
            label, remark = LONG_FILM
            remark += said_of_factor(bearing)
            by_standard = (*by_standard, Variant(label, remark, long_film_check(long_films[index]), detail=1))
        by_film = tuple(_film_variant(one) for one in films)
        ordered = (*by_film, *by_standard) if bearing.method == "film" else (*by_standard, *by_film)
        plain = next((one.case for one in films if one.label == GLOBAL), films[0].case)
        among = (*ordered, *_cavitation_variants(plain))
        methods = (one for one in among if one.is_method)
        ranked = (*methods, *(one for one in among if not one.is_method))
        yield Comparison(films[0].case.name, ranked, "\n".join(_left_out(bearing, case)))


def _compared_in_one_dimension(bearing: JournalBearing, case: Case) -> Iterator[Comparison]:
    """The models of one dimension; a grooved bearing is answered in two dimensions, too."""
    for index, design in enumerate(design_cases_of(bearing, case)):
        if isinstance(design, LongFilmCase):
            yield Comparison(design.name, tuple(Variant(*one) for one in long_film_variants(design)))
        elif isinstance(design, SegmentCase):
            found = [Variant(*one) for one in segment_variants(design)]
            reason = unknown_to_grooved_films(bearing, design, case)
            if not reason:
                place = groove_direction(design, found[0].result)
                for label, remark, film, groove in grooved_films(bearing, case, index, design, place):
                    result = with_groove_angles(solve_design(film), film, groove)
                    found.append(Variant(label, remark, result, film, detail=1))
            left_out = f"the film in two dimensions is left out: {reason}" if reason else ""
            yield Comparison(design.name, tuple(found), left_out)


def _left_out(bearing: JournalBearing, case: Case) -> Iterator[str]:
    """Which methods do not apply to a bearing, and why."""
    reasons = {
        f"{ISO_LABEL} is": unknown_to_iso7902(bearing, case),
        f"{' and '.join(OWN.values())} are": left_out_of_thermal_variants(bearing, case),
        f"{LONG_FILM[0]} is": unknown_to_long_film(bearing, case),
        f"{CLOSED_FORMS} are": next(_beyond_closed_forms(bearing, case), ""),
    }
    yield from (f"{which} left out: {reason}" for which, reason in reasons.items() if reason)


def _beyond_closed_forms(bearing: JournalBearing, case: Case) -> Iterator[str]:
    full = (design for design in iso7902_cases(bearing, case) if design.bearing.span == 360)
    yield from filter(None, map(unknown_to_closed_forms, full))


def _film_variant(one: ThermalVariant) -> Variant:
    label, remark = one.label, one.remark
    if one.case.cavitation is not Cavitation.MASS_CONSERVING:
        rupture, said = CAVITATION_LABELS.get(one.case.cavitation, HALF_SOMMERFELD)
        remark = said if label == GLOBAL else f"{remark}; {said}"
        label += rupture.removeprefix("film")
    return Variant(label, remark, solve_design(one.case), one.case, detail=2 + one.detail)


def _cavitation_variants(film: FilmCase) -> tuple[Variant, ...]:
    """The same film with the conditions of rupture that the case does not ask for."""
    found = []
    for cavitation, (label, remark) in CAVITATION_LABELS.items():
        unfed = film.bearing.film_start is not FilmStart.GROOVE and not film.bearing.hollows
        if cavitation is film.cavitation or (unfed and cavitation is Cavitation.MASS_CONSERVING):
            continue
        other = replace(film, cavitation=cavitation)
        found.append(Variant(label, remark, solve_design(other), other, is_method=False))
    return tuple(found)


def unknown_to_closed_forms(design: DesignCase) -> str:
    """Why the closed forms do not reach a full bearing, in words; empty where they do."""
    (least, most), ratio = CLOSED_FORM_WIDTH_RATIOS, design.bearing.part_width_ratio
    return "" if least <= ratio <= most else f"they hold for B/D {least:g} to {most:g}, and it is {ratio:.3g}"


def _variants(design: DesignCase) -> tuple[Variant, ...]:
    common = "assumes one temperature for the whole film; rupture as on a centred arc; rigid parallel surfaces"
    found = [Variant(ISO_LABEL, common, check(design), design)]
    if design.bearing.span < 360:  # all friction models agree on a full bearing
        for model, (label, remark) in FRICTION_LABELS.items():
            other = replace(design, friction=model)
            if other != design:
                found.append(Variant(label, remark, check(other), other, is_method=False))
    elif design.curves is Curves.COMPUTED and not unknown_to_closed_forms(design):
        closed = replace(design, curves=Curves.CLOSED_FORM)
        deviates = f"deviates by up to {100.0 * DEVIATIONS['sommerfeld_number']:.0f} % in So (DIN 31652 fits)"
        found.append(Variant(CLOSED_FORMS, deviates, check(closed), closed, is_method=False))
    return tuple(found)
