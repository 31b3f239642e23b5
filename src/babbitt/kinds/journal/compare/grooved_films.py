"""The bearing of the heat balance by segments as a film in two dimensions, with its groove at the same place."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from babbitt.case import CaseFile
from babbitt.core.result import Result
from babbitt.core.units import written
from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.case.build import film_cases
from babbitt.kinds.journal.case.film_heat import unknown_to_own_temperatures
from babbitt.kinds.journal.case.joined_inputs import inputs
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.machine import SeveralBearings, SingleBearing
from babbitt.kinds.journal.film.model import FeedSize, FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import Groove, GrooveKind, SegmentCase

__all__ = ["groove_direction", "grooved_films", "unknown_to_grooved_films", "with_groove_angles"]

TURN = 2.0 * math.pi

FULL = "a film of finite width with temperatures of its own, bush and journal that conduct heat; rigid surfaces"

LABELS = {
    GrooveKind.THROUGH: (
        "film, through groove",
        f"{FULL}; the groove has its pressure and oil enough; hot oil goes on across it as far as the film behind "
        "takes it",
    ),
    GrooveKind.BLIND: (
        "film, blind groove",
        f"{FULL}; lands close the groove at its ends, its pressure follows from continuity",
    ),
    None: ("film, no groove", FULL),
}
"""Names of the films, and what they assume."""


def unknown_to_grooved_films(bearing: JournalBearing, design: SegmentCase, case: CaseFile) -> str:
    """Why the film in two dimensions does not know a bearing given for the heat balance by segments, in words;
    empty where it does."""
    if design.profile:
        return "it finds the film thickness itself, and one is given"
    if design.compliance:
        return "walls that yield by segments.compliance belong to the infinitely long film"
    if not isinstance(design.duty, PrescribedLoad):
        return "bearings are compared under the same load, and an eccentricity ratio is given"
    if isinstance(case, SingleBearing | SeveralBearings):
        joined = inputs(bearing, case)
        if joined.materials.bearing is None or joined.materials.journal is None:
            return "it needs the materials of bearing and journal, such as {bearing: C10, journal: C45}"
        if joined.supply is not None and joined.supply.flow is not None:
            return "a film with its own temperatures is fed by pressure, not by a given flow"
    return unknown_to_own_temperatures(bearing)


def groove_direction(design: SegmentCase, solved: Result) -> float | None:
    """Direction of the groove in the bush, rad from +x; None without a groove, or where its place is not known.

    Parameters
    ----------
    design : SegmentCase
    solved : Result
        Its answer, which tells the place of a groove that is given from the widest gap.
    """
    groove = design.groove
    if groove is None:
        return None
    from_load = groove.angle
    if not groove.at_place_in_bush:
        if "groove_angle_from_load" not in solved.values:
            return None
        from_load = solved.groove_angle_from_load
    return design.load_angle + math.copysign(1.0, design.journal_speed) * from_load


def grooved_films(
    bearing: JournalBearing, case: CaseFile, index: int, design: SegmentCase, place: float | None
) -> Iterator[tuple[str, str, FilmCase, float | None]]:
    """Films of a bearing in two dimensions: with its groove, with the other kind of groove, and without any.

    Parameters
    ----------
    bearing : JournalBearing
    case : CaseFile
        The file that the bearing belongs to.
    index : int
        Of the operating point and clearance among those of the bearing.
    design : SegmentCase
        The same point for the heat balance by segments.
    place : float or None
        Direction of the groove, rad from +x, of `groove_direction`.

    Yields
    ------
    tuple of (str, str, FilmCase, float or None)
        Label, what the film assumes, the film, and the direction of its groove.
    """
    plain = film_cases(_fed_at_a_pressure(bearing, case), case, "full")[index]
    if place is not None and design.groove is not None:
        for kind in dict.fromkeys((design.groove.kind, *GrooveKind)):
            feed, assumed = _feed_of(replace(design.groove, kind=kind), place, design)
            feeds = (*plain.bearing.feeds, feed)
            film = replace(
                plain,
                bearing=replace(plain.bearing, feeds=feeds),
                assumptions=(*plain.assumptions, *assumed),
            )
            yield (*LABELS[kind], film, place)
    yield (*LABELS[None], plain, None)


def _fed_at_a_pressure(bearing: JournalBearing, case: CaseFile) -> JournalBearing:
    """The bearing with the gauge pressure of its oil; the infinitely long film asks for none: then ambient."""
    supply = inputs(bearing, case).supply if isinstance(case, SingleBearing | SeveralBearings) else None
    if supply is None or supply.pressure is not None:
        return bearing
    unpressurised = supply.model_copy(update={"pressure": 0.0})
    said = "The oil comes to the film of finite width at ambient pressure."
    return bearing.model_copy(update={"supply": unpressurised, "assumptions": (*bearing.assumptions, said)})


def _feed_of(groove: Groove, place: float, design: SegmentCase) -> tuple[FeedSize, tuple[str, ...]]:
    """The groove as the film of finite width has it, and what was assumed of it."""
    extent = 2.0 * groove.width / design.bearing.diameter
    if groove.kind is GrooveKind.THROUGH:
        return FeedSize(place, extent, pressure=groove.pressure), ()
    width = design.bearing.width
    land = min(groove.width, 0.25 * width) if groove.end_land is None else groove.end_land
    said = f"Each end land of the blind groove is as wide as the groove, {written(land, 'mm')}."
    return FeedSize(place, extent, width - 2.0 * land, flow=0.0), () if groove.end_land is not None else (said,)


def with_groove_angles(result: Result, film: FilmCase, place: float | None) -> Result:
    """An answer with the angles of the groove from load line and widest gap, rad, and its pressure, Pa."""
    if place is None or not result.outcome.solved:
        return result
    sense = math.copysign(1.0, film.journal_speed)
    from_gap = sense * (place - result.narrowest_gap_angle) + math.pi
    pressure = film.bearing.feeds[-1].pressure  # that of a blind groove is found
    own = {
        "groove_angle_from_load": math.remainder(sense * (place - film.load_angle), TURN),
        "groove_angle_from_gap": from_gap % TURN,
        "groove_pressure": result.arrays["groove_pressures"][0][-1] if pressure is None else pressure,
    }
    return replace(result, values={**result.values, **own})
