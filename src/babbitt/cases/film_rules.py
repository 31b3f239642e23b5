"""What goes together in the film method: position, changing load, and films that close around the journal."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.cases.part import Complaint, is_given
from babbitt.notices import InputError
from babbitt.units import written

if TYPE_CHECKING:
    from babbitt.cases.journal import JournalBearing

SURFACE_FIELDS = ("steps", "crowning", "displacement", "side_pressures", "tilt_coefficients")
"""What only a film can have that begins at a groove, pocket or hole, or that closes around the journal."""

CLEARANCE_GROWTH = 2.0
"""Assumption: a clearance does not grow by more than this from 20 degC to operation; a position beyond is
refused."""


def complaints_about_position(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about a position that no clearance reaches."""
    if bearing.bore is not None and bearing.bore.kind != "round":
        return  # lobes and wear give more room in some directions; the calculation tells
    for path, duty in bearing.duties():
        if duty.position is None:
            continue
        try:
            clearance = bearing.clearance.at_20_degrees(bearing.diameter)
        except InputError:  # told by its own rule
            return
        play = clearance.relative(bearing.diameter).maximum * bearing.diameter / 2.0
        away = math.hypot(duty.position.x, duty.position.y)
        if away >= CLEARANCE_GROWTH * play:
            says = f"position outside the clearance: {written(away, 'um')} from the bearing centre"
            yield Complaint((*path, "position"), says, f"less than the radial clearance, {written(play, 'um')}")


def complaints_about_changing_load(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about a changing load beside a prescribed position, or in a film without damping."""
    if bearing.dynamic_load is None:
        return
    for path, duty in bearing.duties():
        prescribed = [name for name in ("eccentricity_ratio", "position") if is_given(duty, name)]
        if prescribed:
            says = f"a changing load moves the journal, and {prescribed[0]} holds it"
            yield Complaint((*path, prescribed[0]), says, "load or specific_load")
    for path, hollow in bearing.hollows():
        if hollow.flow is not None:
            says = "the orbit under a changing load does not count the oil that a supply of given flow delivers"
            yield Complaint((*path, "flow"), says, "a pressure")
    if bearing.cavitation == "half_sommerfeld":
        yield Complaint(("cavitation",), "a half-Sommerfeld film has no damping and makes no orbit", "reynolds")


def complaints_about_half_sommerfeld(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about the half-Sommerfeld condition anywhere but in a plain closed ring."""
    if bearing.cavitation != "half_sommerfeld" or bearing.method != "film":
        return
    allowed = "a plain round bore without grooves, pockets, holes, tilt, steps and turbulence; else cavitation: reynolds"
    says = "the half-Sommerfeld condition is for a plain closed ring"
    if bearing.film_start not in (None, "periodic"):
        yield Complaint(("film_start",), f"{says}, where the film begins nowhere", "periodic")
    elif bearing.hollows() or bearing.supply_element is not None:
        yield Complaint(("cavitation",), f"{says}, and this bearing is fed", allowed)
    elif _is_special(bearing):
        yield Complaint(("cavitation",), says, allowed)
    elif bearing.effective_temperature is None:
        says = "half-Sommerfeld films have no flow to carry heat away"
        yield Complaint(("effective_temperature",), f"{says}: it is missing", "the temperature of the film",
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


def complaints_about_closed_ring(bearing: JournalBearing) -> Iterator[Complaint]:
    """Complain about a closed ring that is cut, or that runs dry."""
    if bearing.film_start != "periodic" or bearing.method != "film":
        return
    if bearing.grooves:
        says = "a film that closes around the journal has no grooves as wide as the bearing"
        yield Complaint(("film_start",), says, "groove")
    if bearing.span not in (None, 360):
        says = f"a film that closes around the journal has no ends; span is {bearing.span} deg"
        yield Complaint(("film_start",), says, "groove, or span 360 deg")
    if bearing.cavitation == "mass_conserving" and not bearing.hollows():
        says = "a mass-conserving film that nothing feeds runs dry"
        yield Complaint(("cavitation",), says, "reynolds, half_sommerfeld, or give pockets or holes")
