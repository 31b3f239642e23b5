"""Lines of the calculation that give what a restrictor lets through at the pressures found."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.hydrostatic.pumping import law_of
from babbitt.kinds.hydrostatic.restrictors import (
    SMOOTHING,
    Capillary,
    CheckValve,
    ConstantFlow,
    FlowValve,
    MembraneValve,
    MeteredFlow,
    Orifice,
    Restrictor,
    Slot,
)
from babbitt.report.line import Line
from babbitt.report.worksheet import Worksheet

__all__ = ["is_linear", "restrictor_lines"]

DROP = "(supply_pressure - one_recess_pressure)"
PLAIN_ROOT_FROM = 100.0 * SMOOTHING
"""Share of the supply pressure from which the smoothed law of an orifice is the plain root to 3e-5."""


def is_linear(restrictor: Restrictor) -> bool:
    """Whether the flow is a conductance times the pressure drop."""
    return isinstance(restrictor, Slot) or (isinstance(restrictor, Capillary) and restrictor.entry_loss == 0.0)


def restrictor_lines(sheet: Worksheet, restrictor: Restrictor) -> Iterator[Line]:
    """From its dimensions to its flow; the sheet knows both pressures and the flow."""
    drop = sheet["supply_pressure"] - sheet["one_recess_pressure"]
    law = law_of(restrictor)
    if isinstance(law, Capillary | Slot):
        yield _conductance(sheet, law)
    if isinstance(restrictor, CheckValve) and drop <= 0.0:
        yield sheet.given("one_restrictor_flow", "the recess stands above the supply: the check valve is shut")
        return
    if isinstance(law, Capillary) and law.entry_loss:
        sheet.note(entry_loss_factor=law.entry_loss, restrictor_density=law.density, capillary_number=law.tubes)
        made = "8 * restrictor_density * entry_loss_factor / (pi**2 * capillary_diameter**4 * capillary_number**2)"
        yield sheet.line("entry_term", made)
    flow = _flow(sheet, law, drop)
    if flow:
        yield sheet.line("one_restrictor_flow", flow, digits=8)
    else:
        yield sheet.given("one_restrictor_flow", "by its law")


def _conductance(sheet: Worksheet, law: Capillary | Slot) -> Line:
    sheet.note(restrictor_viscosity=law.viscosity)
    if isinstance(law, Slot):
        sheet.note(slot_width=law.width, slot_gap=law.gap, slot_length=law.length)
        made = "slot_width * slot_gap**3 / (12 * restrictor_viscosity * slot_length)"
    else:
        sheet.note(capillary_diameter=law.diameter, capillary_length=law.length)
        made = "pi * capillary_diameter**4 / (128 * restrictor_viscosity * capillary_length)"
        if law.tubes > 1:
            sheet.note(capillary_number=float(law.tubes))
            made = f"capillary_number * {made}"
    return sheet.line("restrictor_conductance", made)


def _flow(sheet: Worksheet, law: Restrictor, drop: float) -> str:
    """Expression of the flow; empty where it needs more words than it is worth."""
    match law:
        case Slot():
            return f"restrictor_conductance * {DROP}"
        case Capillary():
            if law.entry_loss == 0.0:
                return f"restrictor_conductance * {DROP}"
            linear = "1 / restrictor_conductance"
            root = f"sqrt(({linear})**2 + 4 * entry_term * {DROP})"
            return f"({root} - {linear}) / (2 * entry_term)" if drop > 0.0 else ""
        case Orifice():
            sheet.note(
                orifice_discharge=law.discharge, orifice_diameter=law.diameter, restrictor_density=law.density
            )
            root = f"sqrt(2 * {DROP} / restrictor_density)"
            smoothed = drop < PLAIN_ROOT_FROM * sheet["supply_pressure"]
            return "" if smoothed else f"orifice_discharge * pi * orifice_diameter**2 / 4 * {root}"
        case ConstantFlow():
            sheet.note(stage_flow=law.flow, stage_leakage=law.leakage)
            return "stage_flow - stage_leakage * one_recess_pressure" if law.leakage else "stage_flow"
        case MeteredFlow():
            sheet.note(stage_flow=law.flow)
            return "stage_flow"
        case FlowValve():
            sheet.note(stage_flow=law.flow, valve_gain=law.gain, open_conductance=law.open_conductance)
            is_open = law.open_conductance * drop < law.flow + law.gain * sheet["one_recess_pressure"]
            return f"open_conductance * {DROP}" if is_open else "stage_flow + valve_gain * one_recess_pressure"
        case MembraneValve():
            sheet.note(membrane_conductance=law.conductance, membrane_compliance=law.compliance)
            return f"membrane_conductance * (1 + membrane_compliance * one_recess_pressure)**3 * {DROP}"
        case _:
            return ""
