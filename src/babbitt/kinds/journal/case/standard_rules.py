"""What the procedure of the standard does not know, and the film method does."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.part import Issue, is_given, rule
from babbitt.core.units import written
from babbitt.kinds.journal.case.film_rules import SURFACE_FIELDS
from babbitt.kinds.journal.case.load_direction import load_points_between_its_pockets
from babbitt.kinds.journal.case.supply_element import half_bearing_width
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import WIDTH_RATIOS as CLOSED_FORM_WIDTH_RATIOS

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.journal import JournalBearing

LEAST_WIDTH_RATIO, LARGEST_TABULATED_RATIO = 0.1, 1.5
"""Range of B/D for which characteristics are included."""

LARGEST_WIDTH_RATIO = 10.0
"""B/D. Assumption: a longer plain bearing is a slip of unit; of the methods only the standard ends before."""


@rule
def standard_knows_the_bearing(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about what the standard does not know."""
    if bearing.method == "iso7902":
        yield from film_alone_knows(bearing, "ISO 7902")
        yield from width_is_in_the_tables(bearing)
        yield from load_points_between_its_pockets(bearing)
        yield from half_bearings_are_in_the_tables(bearing)
        yield from width_is_in_the_closed_forms(bearing)


def width_is_in_the_tables(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a bearing wider than those whose characteristics are included."""
    width = bearing.actual_width
    if width is not None and LARGEST_TABULATED_RATIO < width / bearing.diameter <= LARGEST_WIDTH_RATIO:
        texts = (f"{width / bearing.diameter:.{digits}g}" for digits in range(3, 18))
        ratio = next(text for text in texts if float(text) > LARGEST_TABULATED_RATIO)
        says = f"ISO 7902 has no characteristics for a bearing of B/D {ratio}"
        allowed = f"{_widths(bearing, LARGEST_TABULATED_RATIO)}, or method: film, or long_film from B/D 2"
        yield Issue(("width" if bearing.width is not None else "width_ratio",), says, allowed)


def width_is_in_the_closed_forms(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about closed forms for a bearing wider or narrower than those to which they were fitted."""
    if bearing.characteristics != "closed_form" or bearing.actual_width is None:
        return
    least, most = CLOSED_FORM_WIDTH_RATIOS
    for point in bearing.operating_points or (None,):
        half = half_bearing_width(bearing.element_at(point), bearing.actual_width)
        ratio = (bearing.actual_width if half is None else half) / bearing.diameter
        if ratio > most or (half is None and ratio < least):
            says = f"the closed forms of DIN 31652 hold for B/D {least:g} to {most:g}, and it is {ratio:.3g}"
            yield Issue(("characteristics",), says, "computed")
            return


def width_is_plausible(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a width that no plain bearing has, whatever the method."""
    if bearing.width is None:
        return
    ratio = bearing.width / bearing.diameter
    if not LEAST_WIDTH_RATIO <= ratio <= LARGEST_WIDTH_RATIO:
        largest = LARGEST_TABULATED_RATIO if bearing.method == "iso7902" else LARGEST_WIDTH_RATIO
        says = f"width {written(bearing.width, 'mm')} is {ratio:.3g} of the diameter"
        yield Issue(("width",), says, _widths(bearing, largest))


def _widths(bearing: JournalBearing, largest: float) -> str:
    """Widths up to a ratio, in words."""
    least, most = (written(ratio * bearing.diameter, "mm") for ratio in (LEAST_WIDTH_RATIO, largest))
    return f"{least} to {most} (B/D {LEAST_WIDTH_RATIO:g} to {largest:g})"


def half_bearings_are_in_the_tables(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a groove around the circumference that leaves half bearings too narrow for the tables."""
    if bearing.actual_width is None:
        return
    least = CLOSED_FORM_WIDTH_RATIOS[0] if bearing.characteristics == "closed_form" else LEAST_WIDTH_RATIO
    for point in bearing.operating_points or (None,):
        half = half_bearing_width(bearing.element_at(point), bearing.actual_width)
        if half is None or half <= 0.0 or half / bearing.diameter >= least:
            continue
        own = point is not None and point.supply_element is not None
        path = ("operating_points", bearing.operating_points.index(point)) if own and point is not None else ()
        yield Issue(
            (*path, "supply_element"),
            f"the groove parts the bearing into halves of {written(half, 'mm')}, "
            f"{half / bearing.diameter:.3g} of the diameter",
            f"at least {written(least * bearing.diameter, 'mm')} each (B/D {least:g})",
            "a narrower groove, or method: film",
        )
        return


def film_alone_knows(bearing: JournalBearing, method: str) -> Iterator[Issue]:
    """Complain about what only the film method knows.

    Parameters
    ----------
    bearing : JournalBearing
    method : str
        The method asked for, as a sentence begins with it.
    """
    if bearing.bore is not None and bearing.bore.kind != "round":
        yield Issue(("bore",), f"{method} knows round bores only, not {bearing.bore.kind}", "method: film")
    if bearing.misalignment is not None:
        yield Issue(("misalignment",), f"{method} knows no misaligned journal", "method: film")
    if bearing.turbulence != "laminar":
        yield Issue(("turbulence",), f"{method} knows laminar films only", "method: film")
    if bearing.pressure_viscosity is not None:
        yield Issue(("pressure_viscosity",), f"{method} knows no viscosity under pressure", "method: film")
    for name in SURFACE_FIELDS:
        if is_given(bearing, name):
            says = f"{method} knows no {name.replace('_', ' ')}"
            yield Issue((name,), says, "method: film, or leave it out")
    for path, duty in bearing.duties():
        if duty.attitude_angle is not None:
            says = f"{method} finds the attitude angle itself"
            yield Issue((*path, "attitude_angle"), says, "method: film, or leave it out")
        if duty.position is not None:
            says = f"{method} finds the attitude angle itself and takes no position"
            yield Issue((*path, "position"), says, "method: film, or eccentricity_ratio")
    if bearing.mixed_friction is not None:
        says = f"{method} knows hydrodynamic friction only"
        yield Issue(("mixed_friction",), says, "method: film, or leave it out")
    if bearing.dynamic_load is not None:
        yield Issue(("dynamic_load",), f"{method} knows steady loads only", "method: film")
