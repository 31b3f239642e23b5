"""What goes together in the shape of a film: tilt, wear, steps, displacement and lobes against the clearance."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.part import Issue, rule
from babbitt.case.parts.compliance import issues_of_compliance
from babbitt.core.units import written
from babbitt.kinds.journal.case.film_features import (
    MOST_DEPARTURE,
    LobedBoreInput,
    MeasuredBoreInput,
    PressureDamBoreInput,
    WornBoreInput,
)
from babbitt.kinds.journal.case.film_surface import issues_of_steps

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.journal import JournalBearing


@rule
def tilt_leaves_a_film(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a tilted journal that touches at the edges."""
    width = bearing.actual_width
    if bearing.misalignment is None or width is None:
        return
    play = (
        bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter).minimum
        * bearing.diameter
        / 2.0
    )
    offset = math.hypot(bearing.misalignment.x, bearing.misalignment.y) * width / 2.0
    if offset >= play:
        says = f"the journal touches at the edges: it leans {written(offset, 'um')} there"
        yield Issue(("misalignment",), says, f"less than the radial clearance, {written(play, 'um')}")


@rule
def departures_are_of_the_size_of_the_clearance(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a worn or measured bore far from its circle."""
    if not isinstance(bearing.bore, WornBoreInput | MeasuredBoreInput):
        return
    largest = bearing.bore.largest_departure
    clearance = bearing.clearance.at_20_degrees(bearing.diameter).mean / 2.0
    if largest > MOST_DEPARTURE * clearance:
        says = f"the bore departs by {written(largest, 'um')} from its circle"
        allowed = f"up to {MOST_DEPARTURE:g} times the radial clearance of {written(clearance, 'um')}"
        yield Issue(("bore",), says, allowed)


@rule
def steps_fit(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about steps and recesses outside the bearing."""
    width = bearing.actual_width
    yield from issues_of_steps(bearing.steps, width)
    if isinstance(bearing.bore, PressureDamBoreInput) and width is not None:
        yield from bearing.bore.too_wide(width)


@rule
def dam_stays_on_its_land(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a recess that runs over a groove at any of the operating points."""
    if not isinstance(bearing.bore, PressureDamBoreInput):
        return
    speeds = [duty.speed if duty.speed is not None else duty.surface_speed for _, duty in bearing.duties()]
    for sense in sorted({math.copysign(1.0, speed) for speed in speeds if speed is not None}):
        yield from bearing.bore.across_grooves(tuple(bearing.grooves), sense)


@rule
def displacement_is_of_the_size_of_the_clearance(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about surfaces displaced by many clearances."""
    if bearing.displacement is None:
        return
    clearance = bearing.clearance.at_20_degrees(bearing.diameter).mean / 2.0
    if bearing.displacement.largest > MOST_DEPARTURE * clearance:
        says = f"the surfaces are displaced by {written(bearing.displacement.largest, 'um')}"
        allowed = f"up to {MOST_DEPARTURE:g} times the radial clearance of {written(clearance, 'um')}"
        yield Issue(("displacement",), says, allowed)


@rule
def own_bore_is_the_whole_bore(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a bore of one's own beside another form of the bore, or that ends before the sides do."""
    table = bearing.displacement
    if table is None or table.form is None:
        return
    if bearing.bore is not None and bearing.bore.kind != "round":
        says = f"'{table.form}' is the form of a bore given beside another, {bearing.bore.kind}"
        yield Issue(("displacement", "form"), says, "one of them; a displacement of other bores has no form")
    width, places = bearing.actual_width, table.places or ()
    if width is None or len(places) < 2:
        return
    reach = min(-places[0], places[-1])
    if reach < width / 2.0 * (1.0 - 1e-6):
        says = f"the table of '{table.form}' ends at {written(reach, 'mm')} from the mid-plane"
        yield Issue(("displacement", "places"), says, f"the sides, {written(width / 2.0, 'mm')}, or one place")


@rule
def compliance_fits(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about rings inside the bore, and about soft bores under a changing load."""
    yield from issues_of_compliance(bearing.compliance, bearing.diameter)
    if bearing.compliance and bearing.dynamic_load is not None:
        says = "the orbit under a changing load does not count a bore that gives way"
        yield Issue(("compliance",), says, "leave it out, or give a displacement")


@rule
def lobes_lie_between_grooves(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about lobes without grooves between them."""
    if isinstance(bearing.bore, LobedBoreInput) and len(bearing.grooves) < 2:
        says = f"lobes lie between grooves; {len(bearing.grooves)} given"
        yield Issue(("bore",), says, "as many grooves as lobes, at least two")
