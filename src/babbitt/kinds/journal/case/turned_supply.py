"""Whether supply elements whose place is counted from the load stand at one place at all operating points."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.case.parts.load_and_speed import SPEEDS
from babbitt.core.notices import Notice
from babbitt.kinds.journal.case.film_layout import feeds_of_element
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.operating_point import OperatingPoint, stating
from babbitt.kinds.journal.case.supply_element import UnevenPockets

__all__ = ["warnings_about_turned_supply"]

ONE_PLACE = math.radians(0.1)
"""Angle within which elements stand at one place."""

WHOLE_TURN = math.radians(359.0)


def warnings_about_turned_supply(bearing: JournalBearing, width: float) -> Iterator[Notice]:
    """Question operating points between which the supply element turns in the bore, with the load or its place.

    A bore has its holes, pockets and grooves at one place, and a load that turns towards them has another film.
    An operating point with uneven pockets of its own is left out: they say themselves where the load points.

    Parameters
    ----------
    bearing : JournalBearing
        With its own direction of the load.
    width : float
        m.
    """
    places: list[tuple[str, float, tuple[float, ...]]] = []
    for point in bearing.operating_points:
        angle = bearing.load_angle if point.load_angle is None else point.load_angle
        stands = _places(bearing, point, angle, width)
        if stands:
            places.append((point.name, angle, stands))
    if not places:
        return
    first, from_angle, at = places[0]
    for name, angle, stands in places[1:]:
        if not _alike(at, stands):
            yield Notice("W199", values={
                "first": first, "from_angle": from_angle, "at": _degrees(at),
                "other": name, "angle": angle, "there": _degrees(stands),
            })  # fmt: skip
            return


def _places(bearing: JournalBearing, point: OperatingPoint, load: float, width: float) -> tuple[float, ...]:
    """Angles of the elements in the bore, rad, rising from 0 to a turn; none of grooves around the bore."""
    element = bearing.element_at(point)
    if element is None or (isinstance(element, UnevenPockets) and point.supply_element is not None):
        return ()
    speed = stating(SPEEDS, bearing, point)
    sense = math.copysign(1.0, speed.speed or speed.surface_speed or 1.0)
    span = math.radians(bearing.span_at(point) or 360)
    feeds = feeds_of_element(element, span, load, sense, bearing.diameter, width)
    around = 2.0 * math.pi
    return tuple(sorted({feed.angle % around for feed in feeds if feed.extent < WHOLE_TURN}))


def _alike(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    """Whether every place of both is one of the other, too."""
    return all(
        any(abs(math.remainder(place - found, 2.0 * math.pi)) < ONE_PLACE for found in others)
        for places, others in ((one, other), (other, one))
        for place in places
    )


def _degrees(angles: tuple[float, ...]) -> str:
    return " and ".join(f"{math.degrees(angle):.3g}°" for angle in angles)
