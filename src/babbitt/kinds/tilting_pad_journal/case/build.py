"""From a tilting-pad bearing, as the engineer wrote it, to problems: numbers in SI, all choices made."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import is_given, not_read
from babbitt.case.parts.clearance import ClearanceInput, has_far_limits
from babbitt.case.parts.turbulence import LAWS_OF_TURBULENCE
from babbitt.core.notices import Notice
from babbitt.core.result_name import ResultName
from babbitt.design.conditions import OilSupply, PrescribedLoad, PrescribedPosition
from babbitt.kinds.tilting_pad_journal.case.as_given import words_of
from babbitt.kinds.tilting_pad_journal.case.heat import (
    fuller_choices,
    heat_assumptions,
    heat_choices,
    heat_not_read,
    mode_stiffness,
)
from babbitt.kinds.tilting_pad_journal.case.pads import JournalPads, OnePad, clearances, given_three, own_path
from babbitt.kinds.tilting_pad_journal.case.pivots import contact_assumptions
from babbitt.kinds.tilting_pad_journal.model import (
    Accuracy,
    Feed,
    PadBearing,
    PadCase,
    Thermal,
    on_one_line,
)
from babbitt.properties.materials import LoadCharacter
from babbitt.reynolds.tilting_pads.model import TiltingPad

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.case.bearing import PadOperatingPoint, TiltingPadJournalCase

__all__ = ["pad_bearing", "pad_cases"]

CARRY_OVER = {"flooded": 1.0, "leading_edge_groove": 0.7, "spray_bar": 0.8}
"""Assumptions: share of the oil of a pad that enters the next one, by what feeds the pads."""

CARRY_OVER_OF = {
    "flooded": "flooded grooves",
    "leading_edge_groove": "grooves in the leading edges",
    "spray_bar": "spray bars",
}


def pad_cases(case: TiltingPadJournalCase) -> tuple[PadCase, ...]:
    """One problem for each operating point and clearance, in the order of the file."""
    every = case.clearance_cases == "all"
    return tuple(
        pad_case(case, point, which if every else "", which)
        for point in case.operating_points or (None,)
        for which in (("minimum", "mean", "maximum") if every else ("mean",))
    )


def pad_case(case: TiltingPadJournalCase, point: PadOperatingPoint | None, named: str, which: str) -> PadCase:
    """The problem of one operating point (None: the bearing as such) at one clearance."""
    speed = case.speed if point is None or point.speed is None else point.speed
    assert speed is not None
    temperature = case.supply.temperature
    if point is not None and point.supply_temperature is not None:
        temperature = point.supply_temperature
    thermal = Thermal(case.thermal_model)
    effective = None
    if thermal is Thermal.ISOTHERMAL:
        effective = temperature if case.effective_temperature is None else case.effective_temperature
    angle = case.load_angle if point is None or point.load_angle is None else point.load_angle
    return PadCase(
        name=ResultName(case.name, "" if point is None else point.name, named),
        bearing=pad_bearing(case, which, math.copysign(1.0, speed)),
        duty=duty_of(case, point),
        journal_speed=speed,
        lubricant=case.lubricant.lubricant(),
        thermal=thermal,
        feed=feed_of(case),
        oil_supply=supply_of(case, temperature),
        effective_temperature=effective,
        heat=heat_choices(case, temperature),
        fuller=fuller_choices(case, temperature),
        turbulence=LAWS_OF_TURBULENCE[case.turbulence],
        load_angle=angle,
        accuracy=Accuracy(case.accuracy),
        whirl_ratios=case.whirl_ratios,
        rotor_mass=case.rotor_mass,
        shaft_stiffness=case.shaft_stiffness,
        anticipated_cross_coupling=case.anticipated_cross_coupling,
        pedestal=None if case.pedestal is None else case.pedestal.pedestal(),
        limits=case.limits.limits(),
        least_log_decrement=case.limits.log_decrement,
        probe_alarm=case.limits.probe_alarm,
        probe_trip=case.limits.probe_trip,
        assumption_sensitivity=case.assumption_sensitivity,
        given_clearances=tuple(given_three(case.pads.fields_of(number)) for number in range(case.pads.count)),
        given=tuple(words_of(case, speed, which)),
        assumptions=(*case.assumptions, *assumptions_of(case, which)),
        warnings=(*about_grouped_digits(case), *warnings_of(case, speed, which), *fields_not_read(case, point)),
    )


def duty_of(case: TiltingPadJournalCase, point: PadOperatingPoint | None) -> PrescribedLoad | PrescribedPosition:
    """What the bearing carries, or where its journal stands: of the operating point, else of the bearing."""
    states = case if point is None or (point.load is None and point.position is None) else point
    if states.load is not None:
        return PrescribedLoad(states.load)
    assert states.position is not None
    return PrescribedPosition(states.position.x, states.position.y)


def supply_of(case: TiltingPadJournalCase, temperature: float | None) -> OilSupply | None:
    """Fresh oil; None where no temperature is known."""
    if temperature is None:
        return None
    return OilSupply(
        temperature, case.groove_pressure, circulation_time=case.supply.circulation_time, flow=case.supply.flow
    )


def feed_of(case: TiltingPadJournalCase) -> Feed:
    """What brings oil to the pads, with the carry-over that is given or assumed."""
    return Feed(case.feed, CARRY_OVER[case.feed] if case.carry_over is None else case.carry_over)


def pad_bearing(case: TiltingPadJournalCase, which: str, sense: float) -> PadBearing:
    """Pads at one clearance; against the sense of the case they run backward: what led trails."""
    backward = sense != case.sense
    return PadBearing(
        case.diameter,
        case.pads.width,
        tuple(pad_of(case, number, which, backward) for number in range(case.pads.count)),
        case.groove_pressure,
        None if case.surfaces is None else case.surfaces.surfaces(),
        case.materials.metal(),
        LoadCharacter(case.materials.load_character or LoadCharacter.CALM),
    )


def pad_of(case: TiltingPadJournalCase, number: int, which: str, backward: bool) -> TiltingPad:
    """One pad of the calculation."""
    fields = case.pads.fields_of(number)
    machined, assembled = clearances(fields, case.diameter, which)
    pivot = fields["pivot"]
    motions = pivot.motions()
    probe = fields["probe_fraction"]
    if backward:
        motions["pivot_fraction"], probe = 1.0 - motions["pivot_fraction"], 1.0 - probe
    pad = TiltingPad(
        pivot_angle=case.pads.angles[number],
        extent=fields["extent"],
        clearance=machined,
        assembled_clearance=assembled,
        thickness=fields["thickness"],
        width=fields["width"],
        pivot=pivot.law(fields["width"]),
        mass=fields["mass"],
        inertia=fields["inertia"],
        mass_offset=-fields["mass_offset"] if backward else fields["mass_offset"],
        mass_inset=fields["mass_inset"],
        probe_fraction=probe,
        **motions,
    )
    return replace(pad, bending_stiffness=mode_stiffness(case, number, pad))


def assumptions_of(case: TiltingPadJournalCase, which: str) -> Iterator[str]:
    """What is assumed at one clearance where the case does not say it."""
    feed = feed_of(case)
    pads = [case.pads.fields_of(number) for number in range(case.pads.count)]
    if which != "mean" and any(pad["preload"] is not None for pad in pads):
        yield (
            "At a limit of the clearance the preload is that of the mean; to hold the bore of the pads instead, "
            "give their clearance beside assembled_clearance, in place of preload."
        )
    if case.carry_over is None:
        yield f"Carry-over {feed.carry_over:g} of {CARRY_OVER_OF[case.feed]}."
    if case.thermal_model == "isothermal" and case.effective_temperature is None:
        yield "The films are as warm as the fresh oil."
    if not case.deformation:
        yield "Clearances hold in operation: neither heat nor load changes them."
    if case.anticipated_cross_coupling is not None:
        yield "The rotor stands on two such bearings, of which each bears half of the cross-coupling."
    yield from contact_assumptions(pad["pivot"] for pad in pads)
    if case.pedestal is not None:
        yield "Stiffness and damping, and what follows from them, are those of bearing and pedestal in series."
    yield from heat_assumptions(case)


def warnings_of(case: TiltingPadJournalCase, speed: float, which: str) -> Iterator[Notice]:
    """What of the pads is unusual at one clearance."""
    fields = [case.pads.fields_of(number) for number in range(case.pads.count)]
    if case.pads.count == 2:
        free = all(pad["pivot"].kind != "flexure" for pad in fields)  # a web holds its pad across the line, too
        yield Notice("W410", "line" if free and on_one_line(case.pads.angles) else "two")
    for number, pad in enumerate(fields, 1):
        machined, assembled = clearances(pad, case.diameter, which)
        if assembled > machined:
            yield Notice("W410", "preload", {"pad": number, "preload": 1.0 - assembled / machined})
    if case.anticipated_cross_coupling is not None and case.clearance_cases == "mean":
        yield Notice("W413")
    before = tuple(number for number, pad in enumerate(fields, 1) if pad["pivot"].fraction < 0.5)
    if before and math.copysign(1.0, speed) == case.sense:
        yield Notice("W409", "leading", {"pads": before})
    offset = tuple(number for number, pad in enumerate(fields, 1) if pad["pivot"].fraction > 0.5)
    if offset and math.copysign(1.0, speed) != case.sense:
        yield Notice("W409", "against", {"pads": offset})


def fields_not_read(case: TiltingPadJournalCase, point: PadOperatingPoint | None) -> Iterator[Notice]:
    """Fields that make no difference to this bearing."""
    if case.clearance_cases == "mean" and (unread := tuple(limits_not_used(case))):
        is_near = is_given(case, "clearance_cases") and not is_far_from_limits(case)
        code, variant = ("W183", "mean_clearances") if is_near else ("W174", "pads")
        yield Notice(code, variant, {"fields": unread})
    if unread := tuple(masses_not_felt(case)):
        yield Notice("W183", "pad_mass", {"fields": unread})
    if isinstance(duty_of(case, point), PrescribedPosition):
        yield from not_read(case, "found_load", "load_angle")
    if case.thermal_model != "isothermal":
        yield from not_read(case, "found_temperature", "effective_temperature")
    if unread := tuple(heat_not_read(case)):
        yield Notice("W183", "other_heat", {
            "fields": unread, "thermal": case.thermal_model, "deformation": case.deformation or ("none",),
        })  # fmt: skip
    if case.thermal_model == "isothermal" and case.effective_temperature is not None:
        yield from not_read(case, "given_temperature", "supply.circulation_time")


def clearances_with_limits(case: TiltingPadJournalCase) -> Iterator[tuple[str, ClearanceInput]]:
    """Clearances that have limits, with their paths."""
    parts: list[tuple[str, JournalPads | OnePad]] = [("pads", case.pads)]
    parts += [(own_path(number), one) for number, one in enumerate(case.pads.each)]
    for path, part in parts:
        for name in ("clearance", "assembled_clearance"):
            clearance = getattr(part, name)
            if clearance is not None and clearance.has_limits:
                yield f"{path}.{name}", clearance


def limits_not_used(case: TiltingPadJournalCase) -> Iterator[str]:
    """Paths of limits of clearances, or of what gives them."""
    for path, clearance in clearances_with_limits(case):
        given = [name for name in ("minimum", "maximum") if getattr(clearance, name, None) is not None]
        yield from (f"{path}.{name}" for name in given) if given else (path,)


def is_far_from_limits(case: TiltingPadJournalCase) -> bool:
    """Whether a limit of a clearance is far from its mean."""
    found = (one.at_20_degrees(case.diameter) for _, one in clearances_with_limits(case))
    return any(has_far_limits(one.minimum, one.mean, one.maximum) for one in found)


def masses_not_felt(case: TiltingPadJournalCase) -> Iterator[str]:
    """Paths of masses that are given of pads that give way in no direction, nor with their housing."""
    if case.pedestal is not None:
        return
    pads = pad_bearing(case, "mean", case.sense).pads
    still = [pad.is_rigid for pad in pads]
    light = [rigid and not pad.bends for rigid, pad in zip(still, pads, strict=True)]
    fixed = [math.isinf(pad.tangential_stiffness) for pad in pads]
    for name, rigid in (("mass", light), ("mass_offset", still), ("mass_inset", fixed)):
        if all(rigid) and is_given(case.pads, name):
            yield f"pads.{name}"
        for number, one in enumerate(case.pads.each):
            if rigid[number] and is_given(one, name):
                yield f"{own_path(number)}.{name}"
