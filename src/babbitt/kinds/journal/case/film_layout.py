"""Where the film of a bearing is fed, from its grooves, pockets and holes or from what ISO 7902 knows of it.

The rule for bearings described by `span` and `supply_element` alone:

- uneven pockets stand at their true angles with their true width and extent;
- a half groove is a pocket of its width around the unloaded 180 deg, a full groove one of 360 deg;
- holes, slots and pockets stand opposite the load or at 90 deg before it; on both sides at 90 deg, or where the
  arc ends, if it is shorter than 360 deg;
- without supply element, the film is fed along lines as wide as the bearing: one opposite the load, or one at
  either end of an arc shorter than 360 deg, behind which the rest of the bore carries film, too.

`span` moves nothing else: the film surrounds the journal and ends where it breaks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.core.units import written
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.operating_point import OperatingPoint
from babbitt.kinds.journal.case.supply_element import (
    POCKET_EXTENT,
    GrooveElement,
    HoleElement,
    PocketElement,
    SlotElement,
    SupplyElementInput,
    UnevenPockets,
)
from babbitt.kinds.journal.film.model import FeedSize
from babbitt.reynolds.model import FilmStart

HALF, QUARTER = math.pi, math.pi / 2.0

ALMOST_A_TURN = math.radians(359.0)


@dataclass(frozen=True)
class FilmLayout:
    """Feeds of the film, the assumptions behind them, and warnings; `by_element` where they follow the load."""

    feeds: tuple[FeedSize, ...]
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    by_element: bool = False


def film_layout(bearing: JournalBearing, point: OperatingPoint | None, width: float, sense: float) -> FilmLayout:
    """Give the feeds of the film of a bearing at an operating point.

    Parameters
    ----------
    bearing : JournalBearing
    point : OperatingPoint or None
    width : float
        Of the bearing, m.
    sense : float
        1 if the journal turns counter-clockwise, -1 if not.
    """
    given = bearing.feeds()
    if bearing.film_starts() is FilmStart.WIDEST_GAP:
        return FilmLayout(
            (),
            ("The film starts at the widest gap, at ambient pressure: nothing feeds it elsewhere.",),
            (*_not_used(bearing, point, ("supply_element",), "widest_gap"), Notice("W184", "widest_gap")),
        )
    if bearing.film_starts() is FilmStart.PERIODIC and not given:
        return FilmLayout(
            (),
            ("The film closes around the journal, and nothing feeds it.",),
            (*_not_used(bearing, point, ("supply_element",), "closed"), Notice("W184", "closed")),
        )
    if given:
        return FilmLayout(
            tuple(feed.feed(bearing.diameter) for _, feed in given),
            warnings=_not_used(bearing, point, ("supply_element", "span"), "own_feeds"),
        )
    return _by_rule(bearing, point, width, sense)


def _not_used(
    bearing: JournalBearing, point: OperatingPoint | None, fields: tuple[str, ...], why: str
) -> tuple[Notice, ...]:
    """Report fields that the bearing or the operating point gives and that this film does not read."""
    own = [name for name in fields if getattr(bearing, name) is not None]
    if point is not None:
        at = f"operating_points[{bearing.operating_points.index(point)}]"
        own += [f"{at}.{name}" for name in fields if getattr(point, name) is not None]
    return (Notice("W183", why, {"fields": tuple(own)}),) if own else ()


def _by_rule(bearing: JournalBearing, point: OperatingPoint | None, width: float, sense: float) -> FilmLayout:
    element, span = bearing.element_at(point), math.radians(bearing.span_at(point) or 360)
    load = bearing.load_angle
    full = span > ALMOST_A_TURN
    if element is None:
        return _by_lines(load, span)
    unread = () if full else _not_used(bearing, point, ("span",), "unbroken")
    feeds = feeds_of_element(element, span, load, sense, bearing.diameter, width)
    match element:
        case UnevenPockets():
            said = ("The film has the pockets at their true angles, width and extent.",)
            return FilmLayout(feeds, said, unread, by_element=True)
        case GrooveElement():
            around = written(feeds[0].extent, "deg")
            said = (f"The film has the groove of {written(element.width, 'mm')} around {around}.",)
            return FilmLayout(feeds, said, unread, by_element=True)
        case HoleElement() | SlotElement() | PocketElement():
            by_span = not full and element.place == "both_sides"
            said = (*_describe_element(element), *((_at_the_ends(element, span),) if by_span else ()))
            return FilmLayout(feeds, said, () if by_span else unread, by_element=True)


def feeds_of_element(
    element: SupplyElementInput, span: float, load: float, sense: float, diameter: float, width: float
) -> tuple[FeedSize, ...]:
    """Where a supply element whose place is counted from the load stands in the bore.

    Parameters
    ----------
    element : SupplyElementInput
    span : float
        Of the loaded arc, rad.
    load : float
        Direction of the load, rad from +x.
    sense : float
        1 if the journal turns counter-clockwise, -1 if not.
    diameter, width : float
        m.
    """
    match element:
        case UnevenPockets():
            turns = (-sense * element.entry_angle, sense * element.exit_angle)
            return tuple(FeedSize(load + turn, element.extent, element.width) for turn in turns)
        case GrooveElement():
            around = 2.0 * HALF if element.kind == "groove_360" else HALF
            return (FeedSize(load + HALF, around, element.width),)
        case HoleElement() | SlotElement() | PocketElement():
            extent = next(_of_element(element, load, diameter, width)).extent
            side = QUARTER if span > ALMOST_A_TURN else span / 2.0 + extent / 2.0
            places = {"opposite": (HALF,), "side": (-sense * QUARTER,), "both_sides": (-side, side)}
            return tuple(
                feed
                for turn in places[element.place]
                for feed in _of_element(element, load + turn, diameter, width)
            )


def _by_lines(load: float, span: float) -> FilmLayout:
    """Lines of supply of a bearing that does not say what feeds it; angles in rad."""
    if span > ALMOST_A_TURN:
        said = "The film is fed along a line opposite the load."
        return FilmLayout((FeedSize(load + HALF, 0.0),), (said,), (Notice("W184", "line"),))
    ends = f"The loaded arc of {written(span, 'deg')} ends at lines of supply as wide as the bearing"
    said = f"{ends}; behind them the rest of the bore carries film, too."
    feeds = tuple(FeedSize(load + turn, 0.0) for turn in (-span / 2.0, span / 2.0))
    return FilmLayout(feeds, (said,), (Notice("W184", "lines"),))


def _of_element(element: SupplyElementInput, angle: float, diameter: float, width: float) -> Iterator[FeedSize]:
    match element:
        case HoleElement():
            for number in range(element.number):
                place = ((number + 0.5) / element.number - 0.5) * width
                yield FeedSize.hole(angle, element.diameter, diameter, place)
        case SlotElement():
            yield FeedSize(angle, element.extent_in(diameter), element.length)
        case PocketElement():
            yield FeedSize(angle, element.extent_in(diameter), element.width)
        case _:
            return


def _describe_element(element: SupplyElementInput) -> Iterator[str]:
    match element:
        case HoleElement():
            yield "A hole is a square of the same area in the film."
        case SlotElement():
            yield "The longer side of the slot lies along the shaft."
        case PocketElement() if element.extent is None:
            yield f"Each pocket extends {written(POCKET_EXTENT, 'deg')} around the bore."
        case _:
            return


def _at_the_ends(element: HoleElement | SlotElement | PocketElement, span: float) -> str:
    return f"The {element.kind}s of the film begin where the loaded arc of {written(span, 'deg')} ends."
