"""What goes together in the film method: position, changing load, where the film begins, and its oil."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.part import Issue, is_given, rule
from babbitt.core.notices import InputError
from babbitt.core.units import written
from babbitt.reynolds.model import FilmStart

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.film_features import GrooveInput, PocketInput, SupplyHoleInput
    from babbitt.kinds.journal.case.journal import JournalBearing

SURFACE_FIELDS = ("steps", "crowning", "displacement", "compliance", "side_pressures", "tilt_coefficients")
"""What only a film can have that begins at a groove, pocket or hole, or that closes around the journal."""

CLEARANCE_GROWTH = 2.0
"""Assumption: a clearance does not grow by more than this from 20 degC to operation; a position beyond is
refused."""


@rule
def position_is_near_the_bearing(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a position that no clearance reaches."""
    if bearing.bore is not None and bearing.bore.kind != "round":
        return  # lobes and wear give more room in some directions; the calculation tells
    for path, duty in bearing.duties():
        if duty.position is None:
            continue
        try:
            clearance = bearing.clearance.at_20_degrees(bearing.diameter)
        except InputError:  # reported by its own rule
            return
        play = clearance.relative(bearing.diameter).maximum * bearing.diameter / 2.0
        away = math.hypot(duty.position.x, duty.position.y)
        if away >= CLEARANCE_GROWTH * play:
            says = f"position outside the clearance: {written(away, 'um')} from the bearing centre"
            yield Issue(
                (*path, "position"),
                says,
                f"less than the radial clearance in operation, which is {written(play, 'um')} at 20 degC "
                f"and taken to grow to at most {written(CLEARANCE_GROWTH * play, 'um')}",
            )


@rule
def changing_load_is_added_to_a_load(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a changing load beside a prescribed position, or in a film without damping."""
    if bearing.dynamic_load is None:
        return
    for path, duty in bearing.duties():
        prescribed = [name for name in ("eccentricity_ratio", "position") if is_given(duty, name)]
        if prescribed:
            says = f"a changing load moves the journal, and {prescribed[0]} holds it"
            yield Issue((*path, prescribed[0]), says, "load or specific_load")
    for path, feed in bearing.feeds():
        if feed.flow is not None:
            says = "the orbit under a changing load does not count the oil that a supply of given flow delivers"
            yield Issue((*path, "flow"), says, "a pressure")
    if bearing.cavitation == "half_sommerfeld":
        yield Issue(("cavitation",), "a half-Sommerfeld film has no damping and makes no orbit", "reynolds")


@rule
def mixed_friction_goes_with_the_film(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about asperities in films whose bore, position or oil the mixed branch does not know."""
    if bearing.mixed_friction is None or bearing.method != "film":
        return
    if bearing.cavitation == "half_sommerfeld":
        says = (
            "a half-Sommerfeld film has no stiffness, by which the journal is sought between film and asperities"
        )
        yield Issue(("cavitation",), says, "mass_conserving, reynolds, or no mixed_friction")
    if bearing.compliance:
        says = "asperities are those of a rigid bore; this one gives way"
        yield Issue(("mixed_friction",), says, "no compliance, or no mixed_friction")
    if bearing.bearing_speed:
        yield Issue(("mixed_friction",), "is known for a bearing at rest only", "bearing_speed: 0 rpm")
    for path, feed in bearing.feeds():
        if feed.flow is not None:
            says = "the mixed branch knows supplies of given pressure only"
            yield Issue((*path, "flow"), says, "a pressure, or no mixed_friction")


@rule
def half_sommerfeld_is_of_a_plain_ring(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about the half-Sommerfeld condition anywhere but in a plain closed ring."""
    if bearing.cavitation != "half_sommerfeld" or bearing.method != "film":
        return
    allowed = "a plain round bore without feeding, tilt, steps and turbulence; else cavitation: reynolds"
    says = "the half-Sommerfeld condition is for a plain closed ring"
    if bearing.film_start not in (None, "periodic"):
        yield Issue(("film_start",), f"{says}, where the film begins nowhere", "periodic")
    elif bearing.feeds() or bearing.supply_element is not None:
        yield Issue(("cavitation",), f"{says}, and this bearing is fed", allowed)
    elif _is_special(bearing):
        yield Issue(("cavitation",), says, allowed)
    elif bearing.effective_temperature is None:
        says = "half-Sommerfeld films have no flow to carry heat away"
        yield Issue(("effective_temperature",), f"{says}: it is missing", "the temperature of the film",
                        code="E003")  # fmt: skip


def _is_special(bearing: JournalBearing) -> bool:
    """Whether a film is anything but laminar oil of one viscosity around an aligned journal in a round bore."""
    return (
        (bearing.bore is not None and bearing.bore.kind != "round")
        or bearing.misalignment is not None
        or bearing.turbulence != "laminar"
        or bearing.pressure_viscosity is not None
        or any(is_given(bearing, name) for name in SURFACE_FIELDS)
    )


@rule
def closed_ring_is_plain(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a closed ring that is cut, or that runs dry."""
    if bearing.film_start != "periodic" or bearing.method != "film":
        return
    if bearing.grooves:
        says = "a film that closes around the journal has no grooves as wide as the bearing"
        yield Issue(("film_start",), says, "groove")
    if bearing.span not in (None, 360):
        says = f"a film that closes around the journal has no ends; span is {bearing.span} deg"
        yield Issue(("film_start",), says, "groove, or span 360 deg")
    if bearing.cavitation == "mass_conserving" and not bearing.feeds():
        says = "a mass-conserving film that nothing feeds runs dry"
        yield Issue(("cavitation",), says, "reynolds, half_sommerfeld, or give pockets or holes")


@rule
def sides_stand_above_cavitation(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about sides at less than the pressure at which the film breaks."""
    for index, pressure in enumerate(bearing.side_pressures or ()):
        if pressure < bearing.cavitation_pressure:
            says = f"{written(pressure, 'kPa')} is less than the pressure at which the film breaks"
            yield Issue(("side_pressures", index), says, f"at least {written(bearing.cavitation_pressure, 'kPa')}")


@rule
def widest_gap_is_of_a_plain_bore(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about anything but a plain bore whose film starts at the widest gap."""
    if bearing.film_start != "widest_gap" or bearing.method != "film":
        return
    if bearing.feeds():
        says = "a film that starts at the widest gap has no grooves, pockets or holes"
        yield Issue(("film_start",), says, "groove")
    if (bearing.bore is not None and bearing.bore.kind != "round") or bearing.misalignment is not None:
        says = "a film that starts at the widest gap needs a round bore and an aligned journal"
        yield Issue(("film_start",), says, "groove")
    for name in SURFACE_FIELDS:
        if is_given(bearing, name):
            says = f"a film that starts at the widest gap has no {name.replace('_', ' ')}"
            yield Issue(("film_start",), says, "groove")
    if bearing.span not in (None, 360):
        says = f"a film that starts at the widest gap surrounds the journal; span is {bearing.span} deg"
        yield Issue(("film_start",), says, "groove, or span 360 deg")
    for name in ("turbulence", "pressure_viscosity"):
        if getattr(bearing, name) not in (None, "laminar"):
            says = "a film that starts at the widest gap is laminar and of constant viscosity"
            yield Issue((name,), says, "film_start: groove")
    if bearing.cavitation == "mass_conserving":
        says = "a film that starts at the widest gap does not conserve the oil"
        yield Issue(("cavitation",), says, "reynolds")


@rule
def given_flows_are_counted(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about given flows in a film that does not count its oil."""
    for path, feed in bearing.feeds():
        if feed.flow is None:
            continue
        if feed.flow == 0.0 and bearing.method == "film" and all(not _feeds(one) for _, one in bearing.feeds()):
            says = "every pocket and hole is closed (flow: 0 L/min): nothing feeds the film"
            yield Issue((*path, "flow"), says, "a pressure for one of them, or one more that feeds the film")
            return
        if bearing.method == "film" and bearing.cavitation != "mass_conserving":
            says = "the Reynolds condition does not count the oil that a supply of given flow delivers"
            yield Issue((*path, "flow"), says, "cavitation: mass_conserving, or a pressure")


def _feeds(feed: GrooveInput | PocketInput | SupplyHoleInput) -> bool:
    return feed.flow is None or feed.flow > 0.0


@rule
def grooves_stand_still(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about grooves that turn with the bearing."""
    if bearing.method == "film" and bearing.bearing_speed and bearing.film_starts() is FilmStart.GROOVE:
        says = "grooves and pockets that turn with the bearing leave no steady film"
        yield Issue(("bearing_speed",), says, "0 rpm, or film_start: widest_gap")
    if bearing.method == "film" and bearing.bearing_speed:
        for field, given in (
            ("turbulence", bearing.turbulence != "laminar"), ("dynamic_load", bearing.dynamic_load is not None)
        ):  # fmt: skip
            if given:
                says = f"`{field}` is known for a bearing at rest only: shear and film forces have two speeds here"
                yield Issue(("bearing_speed",), says, f"0 rpm, or no {field}")
