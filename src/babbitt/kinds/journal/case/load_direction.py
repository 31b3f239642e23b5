"""Whether the direction of the load suits what else the case says of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.part import Issue, is_given
from babbitt.case.parts.load_and_speed import SPEEDS
from babbitt.core.units import written
from babbitt.kinds.journal.case.operating_point import stating
from babbitt.kinds.journal.case.supply_element import UnevenPockets
from babbitt.numerics.scalar_or_array import sense_of

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.journal import JournalBearing

DOWNWARD = -math.pi / 2.0
"""rad. Load angle of a bearing that gives none."""

JOINT_TOLERANCE = math.radians(5.0)
"""Assumption: pockets farther than this from a level or upright joint are not at it."""


def load_points_between_its_pockets(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a load angle that puts uneven pockets elsewhere than at a level or upright joint.

    Uneven pockets say already where the load points between them; a load angle in addition says it again.
    """
    for index, point in enumerate(bearing.operating_points or (None,)):
        own = point is not None and point.load_angle is not None
        angle = point.load_angle if point is not None and point.load_angle is not None else bearing.load_angle
        if not (own or is_given(bearing, "load_angle")) or angle == DOWNWARD:
            continue
        element, speed = bearing.element_at(point), stating(SPEEDS, bearing, point)
        if not isinstance(element, UnevenPockets):
            continue
        sense = sense_of(speed.speed or speed.surface_speed or 1.0)
        entry, leaving = (
            angle - sense * element.entry_angle,
            angle + sense * element.exit_angle,
        )
        if max(abs(math.remainder(edge, math.pi / 2.0)) for edge in (entry, leaving)) <= JOINT_TOLERANCE:
            continue
        level = math.pi if sense > 0.0 else 0.0
        before = sense * (angle - level) % (2.0 * math.pi)
        says = (
            f"with it the uneven pockets stand {_degrees(entry)} and {_degrees(leaving)} from +x, at no level or "
            "upright joint; ISO 7902 knows the load from entry_angle and exit_angle alone"
        )
        fits = f"entry_angle {_degrees(before)} and exit_angle {_degrees(math.pi - before)} of a level joint"
        at = ("operating_points", index) if own else ()
        yield Issue((*at, "load_angle"), says, f"leave it out{f', or {fits}' if 0.0 < before < math.pi else ''}")
        return


def _degrees(angle: float) -> str:
    return written(math.remainder(angle, 2.0 * math.pi), "deg")
