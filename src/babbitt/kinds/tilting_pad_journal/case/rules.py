"""Rules between the fields of a tilting-pad bearing; each names the pad and the field."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.error_messages import MISSING
from babbitt.case.part import Issue, is_given, refused
from babbitt.case.parts.clearance import issues_of
from babbitt.core.units import ZERO_CELSIUS, written
from babbitt.kinds.tilting_pad_journal.case.pads import THREE, JournalPads, OnePad, clearances, given_three
from babbitt.kinds.tilting_pad_journal.case.pivots import FlexureInput, RigidPivotInput

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase

__all__ = [
    "centres_of_gravity",
    "clearances_fit",
    "inertia_fits_the_pad",
    "inertia_holds_the_mass",
    "pivots_fit_the_pads",
    "pads_have_room",
    "position_within_the_pads",
    "alarm_before_the_trip",
    "speed_is_given",
    "surface_speed_is_plausible",
    "temperature_is_known",
]

LEAST_PRELOAD = -0.5
"""Below, a pad has half as much more room at its pivot than its bore is wider: a slip of clearances."""

AGREE = 1e-3
"""Share of the machined clearance to which three numbers that are given must agree."""

GREATEST_SURFACE_SPEED = 200.0
"""m/s. Assumption: a faster plain bearing is a slip of unit."""


def speed_is_given(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of an operating point without speed."""
    for _, point in case.duties():
        if not is_given(case, "speed") and (point is None or not is_given(point, "speed")):
            yield Issue(("speed",), MISSING, hint="needed: rotational speed, such as '3000 rpm'", code="E003")
            return


def surface_speed_is_plausible(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of a speed that no plain bearing has."""
    for path, point in case.duties():
        own = point is not None and point.speed is not None
        speed = point.speed if own and point is not None else case.speed
        if speed is not None and (fast := 0.5 * abs(speed) * case.diameter) > GREATEST_SURFACE_SPEED * 1.000001:
            says = f"{written(speed, 'rpm')} is a surface speed of {fast:.4g} m/s"
            yield Issue((*(path if own else ()), "speed"), says, f"up to {GREATEST_SURFACE_SPEED:g} m/s")


def clearances_fit(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of clearances that do not suit the journal, and of a preload that does not follow from them."""
    pads = case.pads
    parts: list[tuple[tuple[str | int, ...], JournalPads | OnePad]] = [(("pads",), pads)]
    parts += [(("pads", "each", number), one) for number, one in enumerate(pads.each)]
    for path, part in parts:
        for name in ("clearance", "assembled_clearance"):
            clearance = getattr(part, name)
            if clearance is not None:
                for issue in issues_of(clearance, case.diameter):
                    yield Issue((*path, name, *issue.path[1:]), issue.says, issue.allowed, issue.hint, issue.code)
                    return
                if case.clearance_cases == "all" and path == ("pads",) and not has_limits(case):
                    says = "clearance_cases: all needs the limits of a clearance"
                    yield Issue((*path, name), says, "minimum and maximum besides mean", code="E003")
                    return
    for number in range(pads.count):
        fields = pads.fields_of(number)
        machined, assembled = clearances(fields, case.diameter)
        preload = 1.0 - assembled / machined
        given = given_three(fields)
        where = pad_path(case, number, *given)
        if len(given) == 3 and abs(preload - fields["preload"]) > AGREE:
            says = (
                f"pad {number + 1}: preload {fields['preload']:.4g} does not follow from a machined clearance of "
                f"{written(machined, 'um')} and an assembled one of {written(assembled, 'um')}, which make "
                f"{preload:.4g}"
            )
            yield Issue((*where, "preload"), says, f"two of {', '.join(THREE)}", "1 - assembled/machined")
            return
        if preload < LEAST_PRELOAD:
            says = (
                f"pad {number + 1}: an assembled clearance of {written(assembled, 'um')} over a machined one of "
                f"{written(machined, 'um')} is a preload of {preload:.3g}"
            )
            yield Issue((*where, "assembled_clearance"), says, f"a preload of {LEAST_PRELOAD:g} or more",
                        "are machined and assembled clearance exchanged?")  # fmt: skip
            return


def has_limits(case: TiltingPadJournalCase) -> bool:
    """Whether a clearance of the pads has limits."""
    parts: tuple[JournalPads | OnePad, ...] = (case.pads, *case.pads.each)
    known = [one for part in parts for one in (part.clearance, part.assembled_clearance) if one is not None]
    return any(one.has_limits for one in known)


def pad_path(case: TiltingPadJournalCase, number: int, *names: str) -> tuple[str | int, ...]:
    """Path to what says some fields of a pad: its own entry where it has one of them, else that of all pads."""
    if number < len(case.pads.each) and any(is_given(case.pads.each[number], name) for name in names):
        return ("pads", "each", number)
    return ("pads",)


def pads_have_room(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of pads that overlap."""
    from babbitt.kinds.tilting_pad_journal.case.build import pad_bearing

    if any(inertia_of_mass(case, number) > 0.0 for number in range(case.pads.count)):
        return  # reported for the inertia itself
    if any(clearances_fit(case)):
        return  # reported for the clearance itself
    yield from refused(("pads", "extent"), lambda: pad_bearing(case, "mean", case.sense).film(1.0, case.sense))


def centres_of_gravity(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of a centre of gravity beside the pad."""
    for number in range(case.pads.count):
        fields = case.pads.fields_of(number)
        offset, arc = fields["mass_offset"], 0.5 * case.diameter * fields["extent"]
        fraction = fields["pivot"].fraction
        ahead, behind = (1.0 - fraction) * arc, fraction * arc
        if not -behind <= offset <= ahead:
            at = f"{written(offset, 'mm')} ahead of the pivot"
            says = f"pad {number + 1}: its centre of gravity, {at}, is not in the pad"
            allowed = f"{written(-behind, 'mm')} to {written(ahead, 'mm')}"
            yield Issue((*pad_path(case, number, "mass_offset"), "mass_offset"), says, allowed)
            return


def inertia_of_mass(case: TiltingPadJournalCase, number: int) -> float:
    """What the inertia of a pad about its pivot lacks of that of its mass at its centre of gravity, kg m2."""
    fields = case.pads.fields_of(number)
    least = float(fields["mass"] * (fields["mass_offset"] ** 2 + fields["mass_inset"] ** 2))
    return least if fields["inertia"] < least * (1.0 - 1e-12) else 0.0


def inertia_holds_the_mass(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of an inertia below that of the mass alone."""
    for number in range(case.pads.count):
        if least := inertia_of_mass(case, number):
            given = case.pads.fields_of(number)["inertia"]
            says = f"pad {number + 1}: {given:.4g} kg m2 about the pivot is less than its mass has where it is"
            yield Issue((*pad_path(case, number, "inertia"), "inertia"), says, f"{least:.4g} kg m2 or more")
            return


def inertia_fits_the_pad(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of a radius of gyration about the pivot that is longer than any part of the pad is far from it."""
    for number in range(case.pads.count):
        fields = case.pads.fields_of(number)
        mass, thickness = fields["mass"], fields["thickness"]
        farthest = (0.5 * case.diameter + thickness) * fields["extent"] + thickness
        if mass > 0.0 and fields["inertia"] > mass * farthest**2:
            gyration = written(math.sqrt(fields["inertia"] / mass), "mm")
            says = (
                f"pad {number + 1}: {fields['inertia']:.4g} kg m2 of {mass:.4g} kg is a radius of gyration of "
                f"{gyration} about the pivot, from which no part of the pad is {written(farthest, 'mm')} away"
            )
            yield Issue((*pad_path(case, number, "inertia"), "inertia"), says,
                        f"up to {0.999 * mass * farthest**2:.4g} kg m2")  # fmt: skip
            return


def pivots_fit_the_pads(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of a contact along the pad that is longer than the pad is wide."""
    for number in range(case.pads.count):
        fields = case.pads.fields_of(number)
        width, pivot = fields["width"], fields["pivot"]
        own = case.pads.width if width is None else width
        length = getattr(pivot, "length", None)
        if length is not None and length > own * (1.0 + AGREE):
            says = f"pad {number + 1}: its pivot, {written(length, 'mm')} long, is longer than the pad is wide"
            yield Issue((*pad_path(case, number, "pivot"), "pivot", "length"), says,
                        f"up to {written(own, 'mm')}, or left out for that")  # fmt: skip
            return


def position_within_the_pads(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of a place at which the journal would touch a pad on a rigid pivot."""
    for path, point in case.duties():
        own = point is not None and point.position is not None
        at = point.position if own and point is not None else case.position
        if at is None or (point is not None and point.load is not None):
            continue
        for number, angle in enumerate(case.pads.angles):
            fields = case.pads.fields_of(number)
            rigid = isinstance(fields["pivot"], RigidPivotInput) or (
                isinstance(fields["pivot"], FlexureInput) and fields["pivot"].stiffness is None
            )
            _, gap = clearances(fields, case.diameter)
            towards = at.x * math.cos(angle) + at.y * math.sin(angle)
            if rigid and towards >= gap:
                says = (
                    f"the journal touches pad {number + 1}: it stands {written(towards, 'um')} towards its pivot, "
                    f"the assembled clearance is {written(gap, 'um')}"
                )
                yield Issue((*(path if own else ()), "position"), says, "a place nearer to the centre")
                break


def temperature_is_known(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of films whose temperature nothing says, or that the oil has no data for."""
    model = case.thermal_model
    oil = case.lubricant.lubricant()
    for path, point in case.duties():
        own = point is not None and point.supply_temperature is not None
        supplied = point.supply_temperature if own and point is not None else case.supply.temperature
        if supplied is None and (model != "isothermal" or case.effective_temperature is None):
            hint = "needed: temperature of the fresh oil such as '40 degC'"
            hint += "" if model != "isothermal" else ", or effective_temperature"
            yield Issue(("supply", "temperature"), MISSING, hint=hint, code="E003")
            return
        given = case.effective_temperature if model == "isothermal" else None
        counts = supplied if given is None else given
        if counts is not None and not oil.covers(counts):
            low, high = (kelvin - ZERO_CELSIUS for kelvin in oil.temperature_range)
            says = f"{counts - ZERO_CELSIUS:.4g} degC lies outside the data of {oil.name}"
            where = ("effective_temperature",) if given is not None else (
                (*path, "supply_temperature") if own else ("supply", "temperature")
            )  # fmt: skip
            yield Issue(where, says, f"{low:.4g} degC to {high:.4g} degC", code="E006")
            return


def alarm_before_the_trip(case: TiltingPadJournalCase) -> Iterator[Issue]:
    """Complain of an alarm above the trip."""
    alarm, trip = case.limits.probe_alarm, case.limits.probe_trip
    if alarm is not None and trip is not None and alarm > trip:
        says = f"the alarm, {written(alarm, 'degC')}, lies above the trip"
        yield Issue(("limits", "probe_alarm"), says, f"up to {written(trip, 'degC')}")
