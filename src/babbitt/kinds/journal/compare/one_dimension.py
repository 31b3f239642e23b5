"""Variants of a film of one dimension that `babbitt compare` puts side by side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from babbitt.core.solution import Solution
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import Discretisation, LongFilmCase
from babbitt.kinds.journal.methods import METHODS

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

Labelled = tuple[str, str, Solution]
"""Name of a variant, what it assumes or neglects, and its solution."""


def long_film_variants(case: LongFilmCase) -> Iterator[Labelled]:
    """The long film in every discretisation, that of the case first."""
    for one in dict.fromkeys((case.discretisation, *DISCRETISATIONS)):
        label, remark = DISCRETISATIONS[one]
        yield label, remark, METHODS["long_film"].solve_one(replace(case, discretisation=one))


def segment_variants(case: SegmentCase) -> Iterator[Labelled]:
    """The film with its groove, with the other kind of groove, cut, and without any."""
    groove = case.groove
    if groove is not None:
        for kind in dict.fromkeys((groove.kind, *GROOVES)):
            pressure = groove.pressure if kind is GrooveKind.THROUGH else 0.0
            other = replace(case, groove=replace(groove, kind=kind, pressure=pressure))
            yield (*GROOVES[kind], METHODS["segments"].solve_one(other))
        cut = replace(groove, kind=GrooveKind.BLIND, width=0.0, pressure=0.0)
        yield (*CUT, METHODS["segments"].solve_one(replace(case, groove=cut)))
    yield (*UNGROOVED, METHODS["segments"].solve_one(replace(case, groove=None)))
