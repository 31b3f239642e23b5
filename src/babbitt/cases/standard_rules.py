"""What the procedure of the standard does not know, and the film method does."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.cases.film_rules import SURFACE_FIELDS
from babbitt.cases.operating_point import SPEEDS, stating
from babbitt.cases.part import Complaint, is_given, rule
from babbitt.cases.supply_element import UnevenPockets
from babbitt.units import written

if TYPE_CHECKING:
    from babbitt.cases.journal import JournalBearing

DOWNWARD = -math.pi / 2.0
"""rad. Load angle of a bearing that gives none."""

JOINT_TOLERANCE = math.radians(5.0)
"""Assumption: pockets farther than this from a level or upright joint are not at it."""


@rule
def standard_knows_the_bearing(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about what the standard does not know."""
    if bearing.method == "iso7902":
        yield from film_alone_knows(bearing, "ISO 7902")
        yield from _load_points_between_its_pockets(bearing)


def _load_points_between_its_pockets(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about a load angle that puts uneven pockets elsewhere than at a level or upright joint.

    Uneven pockets say already where the load points between them; a load angle besides says it again.
    """
    if not is_given(bearing, "load_angle") or bearing.load_angle == DOWNWARD:
        return
    for point in bearing.operating_points or (None,):
        element, speed = bearing.element_at(point), stating(SPEEDS, bearing, point)
        if not isinstance(element, UnevenPockets):
            continue
        sense = math.copysign(1.0, speed.speed or speed.surface_speed or 1.0)
        entry, leaving = (
            bearing.load_angle - sense * element.entry_angle,
            bearing.load_angle + sense * element.exit_angle,
        )
        if max(abs(math.remainder(angle, math.pi / 2.0)) for angle in (entry, leaving)) <= JOINT_TOLERANCE:
            continue
        level = math.pi if sense > 0.0 else 0.0
        before = sense * (bearing.load_angle - level) % (2.0 * math.pi)
        says = (
            f"with it the uneven pockets stand {_degrees(entry)} and {_degrees(leaving)} from +x, at no level or "
            "upright joint; ISO 7902 knows the load from entry_angle and exit_angle alone"
        )
        fits = f"entry_angle {_degrees(before)} and exit_angle {_degrees(math.pi - before)} of a level joint"
        yield Complaint(("load_angle",), says, f"leave it out{f', or {fits}' if 0.0 < before < math.pi else ''}")
        return


def _degrees(angle: float) -> str:
    return written(math.remainder(angle, 2.0 * math.pi), "deg")


def film_alone_knows(bearing: JournalBearing, method: str) -> Iterator[Complaint]:
    """Complain about what only the film method knows.

    Parameters
    ----------
    bearing : JournalBearing
    method : str
        The method asked for, as a sentence begins with it.
    """
    if bearing.bore is not None and bearing.bore.kind != "round":
        yield Complaint(("bore",), f"{method} knows round bores only, not {bearing.bore.kind}", "method: film")
    if bearing.misalignment is not None:
        yield Complaint(("misalignment",), f"{method} knows no misaligned journal", "method: film")
    if bearing.turbulence != "laminar":
        yield Complaint(("turbulence",), f"{method} knows laminar films only", "method: film")
    if bearing.pressure_viscosity is not None:
        yield Complaint(("pressure_viscosity",), f"{method} knows no viscosity under pressure", "method: film")
    for name in SURFACE_FIELDS:
        if is_given(bearing, name):
            says = f"{method} knows no {name.replace('_', ' ')}"
            yield Complaint((name,), says, "method: film, or leave it out")
    for path, duty in bearing.duties():
        if duty.attitude_angle is not None:
            says = f"{method} finds the attitude angle itself"
            yield Complaint((*path, "attitude_angle"), says, "method: film, or leave it out")
        if duty.position is not None:
            says = f"{method} finds the attitude angle itself and takes no position"
            yield Complaint((*path, "position"), says, "method: film, or eccentricity_ratio")
    if bearing.dynamic_load is not None:
        yield Complaint(("dynamic_load",), f"{method} knows steady loads only", "method: film")
