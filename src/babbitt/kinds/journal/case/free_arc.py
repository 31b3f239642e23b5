"""The arc about the load that pockets and grooves leave to the loaded film."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.case.parts.load_and_speed import SPEEDS
from babbitt.design.span import conventional_span
from babbitt.kinds.journal.case.film_features import SupplyHoleInput
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.operating_point import OperatingPoint, stating
from babbitt.kinds.journal.case.supply_element import PocketElement, SlotElement
from babbitt.kinds.journal.iso7902.model import FreeArc
from babbitt.kinds.journal.iso7902.supply import Arrangement
from babbitt.numerics.scalar_or_array import functions_for, sense_of

ALL_AROUND = math.radians(359.0)
"""Extent in rad from which a pocket is a groove around the bore, which ends no arc."""

TURN = 2.0 * math.pi


def free_arcs(bearing: JournalBearing, point: OperatingPoint | None) -> tuple[FreeArc, ...]:
    """Give the centred arcs that the supply element leaves, and the pockets and grooves at their angles.

    Uneven pockets and half grooves have their own rules. A load that points into a pocket leaves none.

    Parameters
    ----------
    bearing : JournalBearing
    point : OperatingPoint or None
    """
    return (*_of_element(bearing, point), *_of_feeds(bearing, point))


def _of_element(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[FreeArc]:
    element, span = bearing.element_at(point), bearing.span_at(point)
    if not isinstance(element, PocketElement | SlotElement) or span is None:
        return
    ends_the_arc = element.place == "both_sides" and span < 360
    if ends_the_arc and not (isinstance(element, PocketElement) and element.extent is not None):
        return
    extent = element.extent_in(bearing.diameter)
    what = f"{'pockets' if isinstance(element, PocketElement) else 'slots'} of {_degrees(extent)}"
    middle = Arrangement(element.place).angle
    where = f"{'±' if element.place == 'both_sides' else ''}{_degrees(middle)} to the load"
    yield FreeArc(2.0 * (middle - extent / 2.0), f"{what} at {where}", certain=not ends_the_arc)


def _of_feeds(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[FreeArc]:
    speed = stating(SPEEDS, bearing, point)
    sense = sense_of(speed.speed or speed.surface_speed or 1.0)
    before, behind = [], []
    for path, given in bearing.feeds():
        feed = given.feed(bearing.diameter)
        if isinstance(given, SupplyHoleInput) or feed.extent >= ALL_AROUND:
            continue
        turn, half = sense * (feed.angle - bearing.load_angle) % TURN, feed.extent / 2.0
        if min(turn, TURN - turn) <= half:
            return
        behind.append((turn - half, f"{path[0]}.{path[1]}"))
        before.append((TURN - turn - half, f"{path[0]}.{path[1]}"))
    if not before:
        return
    (entry, entering), (leaving, left) = min(before), min(behind)
    arc = conventional_span(entry, leaving)
    at_exit = arc.exact < 2.0 * entry
    name, edge = (left, leaving) if at_exit else (entering, entry)
    said = f"{name}, whose edge lies {_degrees(edge)} {'behind' if at_exit else 'before'} the load,"
    yield FreeArc(arc.exact, said, certain=False)


def _degrees(angle: float) -> str:
    return f"{functions_for(angle).degrees(angle):.3g}°"
