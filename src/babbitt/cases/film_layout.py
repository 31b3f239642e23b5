"""Where the film of a bearing is fed, from its grooves, pockets and holes or from what ISO 7902 knows of it.

The rule for bearings described by `span` and `supply_element` alone:

- uneven pockets stand at their true angles with their true width and extent;
- pockets at both sides of an arc shorter than 360 deg begin where the arc ends;
- a half groove is a pocket of its width around the unloaded 180 deg, a full groove one of 360 deg;
- holes, slots and pockets of a full bearing stand opposite the load, at 90 deg before it, or at 90 deg on both
  sides;
- any other arc ends at lines of supply as wide as the bearing; behind them the rest of the bore carries film, too;
- a full bearing without supply element is fed along a line opposite the load.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from babbitt.bearings.model import Hollow
from babbitt.cases.journal import JournalBearing
from babbitt.cases.operating_point import OperatingPoint
from babbitt.cases.supply_element import (
    GrooveElement,
    HoleElement,
    PocketElement,
    SlotElement,
    SupplyElementGiven,
    UnevenPockets,
)
from babbitt.film.model import FilmStart
from babbitt.units import written

POCKET_EXTENT = math.radians(20.0)
"""Extent around the bore of a pocket that does not give its own. Assumption."""

HALF, QUARTER = math.pi, math.pi / 2.0

ALMOST_A_TURN = math.radians(359.0)


@dataclass(frozen=True)
class FilmLayout:
    """Hollows of the film, and the assumptions behind them."""

    hollows: tuple[Hollow, ...]
    assumptions: tuple[str, ...] = ()


def film_layout(bearing: JournalBearing, point: OperatingPoint | None, width: float, sense: float) -> FilmLayout:
    """Give the hollows that feed the film of a bearing at an operating point.

    Parameters
    ----------
    bearing : JournalBearing
    point : OperatingPoint or None
    width : float
        Of the bearing, m.
    sense : float
        1 if the journal turns counter-clockwise, -1 if not.
    """
    given = bearing.hollows()
    if bearing.film_starts() is FilmStart.WIDEST_GAP:
        return FilmLayout(
            (), ("The film starts at the widest gap, at ambient pressure: nothing feeds it elsewhere.",)
        )
    if bearing.film_starts() is FilmStart.PERIODIC and not given:
        return FilmLayout((), ("The film closes around the journal, and nothing feeds it.",))
    if given:
        return FilmLayout(tuple(hollow.hollow(bearing.diameter) for _, hollow in given))
    return _by_rule(bearing, point, width, sense)


def _by_rule(bearing: JournalBearing, point: OperatingPoint | None, width: float, sense: float) -> FilmLayout:
    element, span = bearing.element_at(point), math.radians(bearing.span_at(point) or 360)
    load = bearing.load_angle
    full = span > ALMOST_A_TURN
    match element:
        case UnevenPockets():
            hollows = tuple(
                Hollow(load + turn, element.extent, element.width)
                for turn in (-sense * element.entry_angle, sense * element.exit_angle)
            )
            return FilmLayout(hollows, ("The film has the pockets at their true angles, width and extent.",))
        case GrooveElement():
            around = 2.0 * HALF if element.kind == "groove_360" else HALF
            return FilmLayout(
                (Hollow(load + HALF, around, element.width),),
                (f"The film has the groove of {written(element.width, 'mm')} around {written(around, 'deg')}.",),
            )
        case PocketElement() if not full and element.place == "both_sides":
            extent = element.extent or POCKET_EXTENT
            away = span / 2.0 + extent / 2.0
            hollows = tuple(Hollow(load + turn, extent, element.width) for turn in (-away, away))
            said = f"The pockets of the film begin where the loaded arc of {written(span, 'deg')} ends"
            return FilmLayout(hollows, (f"{said} and extend {written(extent, 'deg')}.",))
        case None if full:
            return FilmLayout((Hollow(load + HALF, 0.0),), ("The film is fed along a line opposite the load.",))
        case _ if not full or element is None:
            hollows = tuple(Hollow(load + turn, 0.0) for turn in (-span / 2.0, span / 2.0))
            said = f"The loaded arc of {written(span, 'deg')} ends at lines of supply as wide as the bearing"
            return FilmLayout(hollows, (f"{said}; behind them the rest of the bore carries film, too.",))
        case _:
            places = {"opposite": (HALF,), "side": (-sense * QUARTER,), "both_sides": (-QUARTER, QUARTER)}
            hollows = tuple(
                hollow
                for turn in places[element.place]
                for hollow in _of_element(element, load + turn, bearing.diameter, width)
            )
            return FilmLayout(hollows, tuple(_said_of(element)))


def _of_element(element: SupplyElementGiven, angle: float, diameter: float, width: float) -> Iterator[Hollow]:
    match element:
        case HoleElement():
            for number in range(element.number):
                place = ((number + 0.5) / element.number - 0.5) * width
                yield Hollow.hole(angle, element.diameter, diameter, place)
        case SlotElement():
            along = element.length < width
            size, around = (element.length, element.width) if along else (element.width, element.length)
            yield Hollow(angle, 2.0 * around / diameter, size)
        case PocketElement():
            yield Hollow(angle, element.extent or POCKET_EXTENT, element.width)
        case _:
            return


def _said_of(element: SupplyElementGiven) -> Iterator[str]:
    match element:
        case HoleElement():
            yield "A hole is a square of the same area in the film."
        case SlotElement():
            yield "The longer side of the slot lies along the shaft, if it fits into the width."
        case PocketElement() if element.extent is None:
            yield f"Each pocket extends {written(POCKET_EXTENT, 'deg')} around the bore."
        case _:
            return
