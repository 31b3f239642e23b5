"""Variants of a film of one dimension that `babbitt compare` puts side by side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from babbitt.core.result import Result
from babbitt.kinds.journal.grooved_long_bearing.check import segments_check
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.check import long_film_check
from babbitt.kinds.journal.infinitely_long_bearing.model import Discretisation, LongFilmCase

DISCRETISATIONS = {
    Discretisation.CONSISTENT: ("long film", "assumes that no oil leaves at the sides; conserves the flow"),
    Discretisation.PUBLISHED_MEAN: (
        "published, mean flow",
        "as long film, but neglects the change of viscosity in the pressure equation: does not conserve the flow",
    ),
    Discretisation.PUBLISHED_LITERAL: (
        "published, local flow",
        "as published with mean flow, but carries heat with the local flow, which differs from place to place",
    ),
}

GROOVES = {
    GrooveKind.THROUGH: (
        "through groove",
        "assumes rigid adiabatic walls, and oil that leaves at the groove only",
    ),
    GrooveKind.BLIND: ("blind groove", "as through groove, but closed at its ends: its oil goes on with the film"),
}

UNGROOVED = ("no groove", "one mean temperature for the whole film")
CUT = ("cut in two", "no groove either, but one mean temperature before and one behind its place")

Labelled = tuple[str, str, Result]
"""Name of a variant, what it assumes or neglects, and its answer."""


def long_film_variants(case: LongFilmCase) -> Iterator[Labelled]:
    """The long film in every discretisation, that of the case first."""
    for one in dict.fromkeys((case.discretisation, *DISCRETISATIONS)):
        yield (*DISCRETISATIONS[one], long_film_check(replace(case, discretisation=one)))


def segment_variants(case: SegmentCase) -> Iterator[Labelled]:
    """The film with its groove, with the other kind of groove, cut, and without any."""
    groove = case.groove
    if groove is not None:
        for kind in dict.fromkeys((groove.kind, *GROOVES)):
            pressure = groove.pressure if kind is GrooveKind.THROUGH else 0.0
            other = replace(case, groove=replace(groove, kind=kind, pressure=pressure))
            yield (*GROOVES[kind], segments_check(other))
        cut = replace(groove, kind=GrooveKind.BLIND, width=0.0, pressure=0.0)
        yield (*CUT, segments_check(replace(case, groove=cut)))
    yield (*UNGROOVED, segments_check(replace(case, groove=None)))
