"""The same bearing by every method and option that applies, side by side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from babbitt.bearings.model import FilmCase
from babbitt.cases import Case
from babbitt.cases.build import bearings_of, design_cases_of, film_cases, iso7902_cases, unknown_to_iso7902
from babbitt.cases.journal import JournalBearing
from babbitt.cases.one_dimension import METHODS
from babbitt.film.model import Cavitation, FilmStart
from babbitt.longfilm.model import LongFilmCase
from babbitt.notices import InputError
from babbitt.results import Result
from babbitt.segments.model import SegmentCase
from babbitt.solving import solve_design
from babbitt.standards.iso7902 import DesignCase, check
from babbitt.standards.iso7902.model import Curves, Friction
from babbitt.studies.one_dimension import long_film_variants, segment_variants


@dataclass(frozen=True)
class Variant:
    """One way to compute a bearing, and what it assumes or neglects."""

    label: str
    remark: str
    result: Result


@dataclass(frozen=True)
class Comparison:
    """All ways to compute one bearing; the first is the one the case asks for, `left_out` says which do not apply
    and why."""

    name: str
    variants: tuple[Variant, ...]
    left_out: str = ""


FRICTION_LABELS = {
    Friction.FULL: ("film all around", "neglects that the film ruptures outside the loaded arc"),
    Friction.ARC: ("film on the arc", "neglects friction of the oil outside the loaded arc"),
    Friction.CURVE360: ("360° friction curve", "neglects the influence of the span on friction"),
}


CAVITATION_LABELS = {
    Cavitation.MASS_CONSERVING: (
        "film",
        "sees the feeding; conserves the oil; assumes one temperature for the whole film",
    ),
    Cavitation.REYNOLDS: (
        "film, Reynolds",
        "as film, but reforms the film without asking where the oil comes from",
    ),
}

HALF_SOMMERFELD = ("film, half-Sommerfeld", "counts suctions of the full film as nothing; knows no flow")

ISO_LABEL = "ISO 7902"


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
    bearings = bearings_of(case)
    if not bearings:
        raise InputError(
            "E004", f"{case.name}: a case of kind {case.kind!r} has no film; there is nothing to compare"
        )
    return tuple(found for bearing in bearings for found in _compared(bearing, case))


def _compared(bearing: JournalBearing, case: Case) -> Iterator[Comparison]:
    if bearing.method in METHODS:
        for design in design_cases_of(bearing, case):
            if isinstance(design, LongFilmCase):
                labelled = long_film_variants(design)
            elif isinstance(design, SegmentCase):
                labelled = segment_variants(design)
            yield Comparison(design.name, tuple(Variant(*one) for one in labelled))
        return
    standard, films = iso7902_cases(bearing, case), film_cases(bearing, case)
    for index, film in enumerate(films):
        by_standard = _variants(standard[index]) if standard else ()
        by_film = _film_variants(film)
        ordered = (*by_film, *by_standard) if bearing.method == "film" else (*by_standard, *by_film)
        reason = unknown_to_iso7902(bearing)
        yield Comparison(film.name, ordered, f"{ISO_LABEL} is left out: {reason}" if reason else "")


def _film_variants(film: FilmCase) -> tuple[Variant, ...]:
    found = []
    for cavitation in dict.fromkeys((film.cavitation, *CAVITATION_LABELS)):
        unfed = film.bearing.film_start is not FilmStart.GROOVE and not film.bearing.hollows
        if unfed and cavitation is Cavitation.MASS_CONSERVING:
            continue
        label, remark = CAVITATION_LABELS.get(cavitation, HALF_SOMMERFELD)
        found.append(Variant(label, remark, solve_design(replace(film, cavitation=cavitation))))
    return tuple(found)


def _variants(design: DesignCase) -> tuple[Variant, ...]:
    common = "assumes one temperature for the whole film; rupture as on a centred arc; rigid parallel surfaces"
    found = [Variant(ISO_LABEL, common, check(design))]
    if design.bearing.span < 360:  # all friction models agree on a full bearing
        for model, (label, remark) in FRICTION_LABELS.items():
            plain = replace(design, friction=model, friction_factor=1.0)
            if plain != design:
                found.append(Variant(label, remark, check(plain)))
    elif design.curves is Curves.COMPUTED:
        closed = replace(design, curves=Curves.CLOSED_FORM)
        found.append(Variant("closed forms", "deviates by up to 7 % in So (DIN 31652 fits)", check(closed)))
    return tuple(found)
