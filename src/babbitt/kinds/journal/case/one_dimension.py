"""What the methods of one dimension, `long_film` and `segments`, ask of a bearing, and what they do not know."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.part import Issue, is_given
from babbitt.case.parts.load_and_speed import LOADS
from babbitt.core.notices import InputError
from babbitt.kinds.journal.case import grooved_segments as segments
from babbitt.kinds.journal.case import heat_exchange
from babbitt.kinds.journal.case.film_heat import SOLVED_BY_COMPARE
from babbitt.kinds.journal.case.methods import KNOWN_TO
from babbitt.kinds.journal.case.standard_rules import film_alone_knows
from babbitt.kinds.journal.infinitely_long_bearing.model import THICKEST_FILM

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.journal import JournalBearing

METHODS = {"long_film": "the long film", "segments": "the heat balance by segments"}
"""Methods of one dimension, and what they are called in messages."""

GREATEST_EXPONENT = 5.0
"""Of the power law of viscosity, by the source of the heat balance by segments."""


def issues_of(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about what a method of one dimension does not know, and about its fields in another method."""
    for block, (method, *_) in KNOWN_TO.items():
        if method in METHODS and is_given(bearing, block) and bearing.method != method:
            says = f"method {bearing.method} does not read it"
            yield Issue((block,), says, f"method: {method}")
    if bearing.method not in METHODS:
        return
    yield from unknown(bearing, METHODS[bearing.method])
    if bearing.friction.factor != 1.0:
        says = f"{METHODS[bearing.method]} knows no factor on friction"
        compared = f", or method: film, {SOLVED_BY_COMPARE}" if bearing.method == "long_film" else ""
        yield Issue(("friction", "factor"), says, f"1, or leave it out{compared}")
    if bearing.method == "long_film":
        yield from _thick_film(bearing)
        yield from heat_exchange.issues_of(bearing.heat_exchange, bearing.diameter)
        return
    yield from segments.issues_of(bearing.segments, bearing.diameter, bearing.actual_width)
    oil = bearing.lubricant
    exponent = getattr(oil, "exponent", 0.0)
    if exponent > GREATEST_EXPONENT:
        says = f"exponent {exponent:g} of the power law of viscosity"
        yield Issue(("lubricant", "exponent"), says, f"up to {GREATEST_EXPONENT:g}")


def unknown(bearing: JournalBearing, method: str) -> Iterator[Issue]:
    """Complain about what a method of one dimension does not know, a factor on friction apart."""
    yield from film_alone_knows(bearing, method)
    for name in ("grooves", "pockets", "holes"):
        if is_given(bearing, name):
            yield Issue((name,), f"{method} knows no {name} at places of their own", "method: film")
    if bearing.effective_temperature is not None:
        says = f"{method} finds its temperatures itself"
        yield Issue(("effective_temperature",), says, "method: iso7902 or film, or leave it out")
    if bearing.bearing_speed:
        yield Issue(("bearing_speed",), f"{method} knows no turning bearing", "0 rpm")


def issues_of_loads(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a load beside a film profile, from which the load follows."""
    for path, duty in bearing.duties():
        for name in LOADS:
            if is_given(duty, name):
                says = "the load follows from the film thickness given in segments.profile"
                yield Issue((*path, name), says, "segments.profile or a load", "remove one")


def _thick_film(bearing: JournalBearing) -> Iterator[Issue]:
    """The long film has a bound of c/R, the relative clearance; what no clearance can be is refused before."""
    try:
        widest = bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter).maximum
    except InputError:
        return
    if widest > THICKEST_FILM:
        says = f"the clearance is {1e3 * widest:.4g} permille of the bearing, too thick for the long film"
        yield Issue(("clearance",), says, f"up to {1e3 * THICKEST_FILM:g} permille, or method: film")
