"""Lines of the calculation of a hydrostatic bearing that concern friction, pumping and what both warm."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.hydrostatic.geometry import RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.pumping import has_own_pump, is_pumped
from babbitt.kinds.hydrostatic.report.land_lines import journal_friction, pad_friction, ring_friction
from babbitt.kinds.hydrostatic.report.sheet import HydrostaticSheet
from babbitt.kinds.hydrostatic.supply import Pump
from babbitt.report.line import Line

__all__ = ["power_lines"]


def power_lines(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Line]:
    """Friction, pumping, and what both warm."""
    rubs = sheet["friction_power"] > 0.0
    if rubs:
        yield from _friction(case, sheet)
    yield from _pumping(case, sheet)
    if rubs:
        yield sheet.line("power_ratio", "friction_power / pumping_power", "1 to 3 is near the least power")
    lost = "pumping_power + friction_power" if rubs else "pumping_power"
    if "volumetric_heat_capacity" not in sheet:
        rate = (sheet["pumping_power"] + sheet["friction_power"]) / sheet["total_flow"]
        warm = rate / sheet["oil_warming"]
        yield sheet.given(
            "volumetric_heat_capacity", "of the lubricant at the temperature of the film", value=warm
        )
    whole = f"({lost})" if rubs else lost
    yield sheet.line("oil_warming", f"{whole} / (volumetric_heat_capacity * total_flow)", "no heat to the walls")
    if rubs:
        remark = "where lands rub with three times the pumping power, at these pressures, restrictors made to suit"
        yield sheet.given("least_power_gap", remark)


def _friction(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Line]:
    shape = case.shape
    if isinstance(shape, RectangularPad):
        yield pad_friction(sheet, shape)
        return
    if case.method == "film":
        yield sheet.given("friction_torque", "shear over lands and recesses, and the part of the pressure")
    elif isinstance(shape, RecessedJournal):
        yield from journal_friction(sheet)
    elif isinstance(shape, ThrustRing):
        yield from ring_friction(sheet, case.duty.angular_speed < 0.0)
    else:
        yield pad_friction(sheet, shape)
        return
    yield sheet.line("friction_power", "friction_torque * angular_speed")


def _pumping(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Line]:
    supply, own = case.feeding.supply, is_pumped(case)
    above = own and sheet["one_recess_pressure"] > sheet["supply_pressure"]
    each = above or any(map(has_own_pump, case.feeding.restrictors))
    if each and case.count > 1:
        yield sheet.given("pumping_power", "sum over the recesses, each at the pressure of its oil")
        yield sheet.given("pump_power", "the same with leakage, over the efficiency")
        return
    pressure = "one_recess_pressure" if each else "supply_pressure"
    yield sheet.line("pumping_power", f"{pressure} * total_flow", digits=6)
    if own and not case.feeding.is_uniform:
        yield sheet.given("pump_power", "sum over the recesses, with leakage, over the efficiency")
        return
    moved = "total_flow"
    if own:
        moved = "recess_number * stage_flow" if case.count > 1 else "stage_flow"
    elif isinstance(supply, Pump):
        sheet.note(pump_delivery=supply.flow)
        moved = "pump_delivery"
    yield sheet.line("pump_power", f"{pressure} * {moved} / efficiency_of_pump", digits=6)
