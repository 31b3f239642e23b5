"""The balance of a heel as lines that can be followed with a pocket calculator, for one steady state."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.footstep.model import BackflowViscosity, FaceOutlet, Footstep, FrictionViscosity
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.states import Method
from babbitt.report.line import Line, Section
from babbitt.report.worksheet import Worksheet

TOTAL = "2 * pi * heel_radius * heel_length / heel_clearance"


class FootstepSheet(Worksheet):
    """The numbers of one steady state; see `Worksheet`."""

    def __init__(self, step: Footstep, result: Result) -> None:
        part, oil, groove = step.geometry, step.oil, step.groove
        known = dict(result.values) | {
            "heel_length": part.length,
            "heel_radius": part.radius,
            "recess_radius": part.recess_radius,
            "bore_radius": part.bore_radius,
            "recess_depth": part.recess_depth,
            "inlet_viscosity": oil.viscosity,
            "viscosity_exponent_alpha": oil.exponent,
            "heel_inlet_temperature": oil.temperature,
            "volumetric_heat_capacity": oil.heat_capacity,
            "heel_supply_pressure": step.supply_pressure,
            "heel_ambient_pressure": step.ambient_pressure,
            "screw_speed": step.angular_speed,
            "groove_speed": step.groove_speed,
        }
        if groove is not None:
            known |= {
                "groove_angle": groove.angle,
                "groove_depth": groove.depth,
                "screw_groove_width": groove.groove_width,
                "screw_land_width": groove.land_width,
                "groove_starts": float(groove.starts),
            }
        super().__init__(known)


def heel_calculation(case: FootstepProblem, result: Result) -> tuple[Section, ...]:
    """Lines of one steady state by superposition; none for narrow grooves, unsolved heels and unusual options.

    Parameters
    ----------
    case : FootstepProblem
    result : Result
        One of its answers.
    """
    step = case.footstep
    plain = (
        step.options.face_outlet is FaceOutlet.CONSISTENT
        and step.options.backflow_viscosity is BackflowViscosity.INLET
        and step.options.entry_loss == 0.0
        and step.oil.exponent > 0.0
        and step.end_eccentricities == (0.0, 0.0)
    )
    if not (result.outcome.solved and case.method is Method.SUPERPOSITION and plain):
        return ()
    sheet = FootstepSheet(step, result)
    outward = sheet["face_flow"] > 0.0
    sections = [
        Section("Groove", tuple(_groove(sheet))) if case.is_grooved else None,
        Section("Recess and face gap", tuple(_face(sheet, outward))),
        Section("Clearance and balance", tuple(_clearance(sheet, outward, case.is_grooved))),
        Section("Friction power", tuple(_friction(sheet, step))),
    ]
    return tuple(section for section in sections if section is not None)


def _groove(sheet: FootstepSheet) -> Iterator[Line]:
    yield sheet.line("groove_wall_speed", "groove_speed * heel_radius * cos(groove_angle)")
    yield sheet.line("groove_length", "heel_length / sin(groove_angle)")
    yield sheet.given("heel_groove_flow", "at which the balance below closes")
    yield sheet.line("groove_line_flow", "heel_groove_flow / (groove_starts * screw_groove_width)")
    yield sheet.line("groove_drive", "6 * (groove_wall_speed * groove_depth - 2 * groove_line_flow)")
    yield sheet.line("groove_heat_term", "groove_drive**2 + 12 * (groove_depth * groove_wall_speed)**2")
    yield sheet.line("groove_stream_term", "12 * groove_line_flow * volumetric_heat_capacity * groove_depth**3")
    growth = (
        "ln(1 + inlet_viscosity * viscosity_exponent_alpha * groove_heat_term * groove_length / "
        "groove_stream_term)"
        " / viscosity_exponent_alpha"
    )
    yield sheet.line("groove_outlet_temperature", f"heel_inlet_temperature + {growth}", "no heat to the metal")
    yield sheet.line(
        "rim_pressure",
        "heel_ambient_pressure + groove_drive * groove_stream_term / (groove_depth**3 * groove_heat_term)"
        " * (groove_outlet_temperature - heel_inlet_temperature)",
        digits=8,
    )


def _face(sheet: FootstepSheet, outward: bool) -> Iterator[Line]:
    yield sheet.line(
        "face_resistance",
        "ln(heel_radius / recess_radius) / face_gap**3 + ln(recess_radius / bore_radius) / recess_depth**3",
    )
    yield sheet.line(
        "face_flow",
        "pi * volumetric_heat_capacity / (6 * viscosity_exponent_alpha * inlet_viscosity * face_resistance)"
        " * (exp(viscosity_exponent_alpha * (heel_supply_pressure - rim_pressure) / volumetric_heat_capacity) - "
        "1)",
        "" if outward else "negative: the rim feeds the recess",
        digits=9,
    )
    if outward:
        yield sheet.line(
            "face_outlet_temperature",
            "heel_inlet_temperature + (heel_supply_pressure - rim_pressure) / volumetric_heat_capacity",
        )


def _clearance(sheet: FootstepSheet, outward: bool, grooved: bool) -> Iterator[Line]:
    if grooved and outward:
        yield sheet.line(
            "rim_temperature",
            "(groove_outlet_temperature * heel_groove_flow + face_outlet_temperature * face_flow)"
            " / (heel_groove_flow + face_flow)",
        )
    else:
        source = "groove_outlet_temperature" if grooved else "face_outlet_temperature"
        yield sheet.line("rim_temperature", source, "all that leaves comes from there")
    yield sheet.line(
        "rim_viscosity",
        "inlet_viscosity * exp(-viscosity_exponent_alpha * (rim_temperature - heel_inlet_temperature))",
        digits=7,
    )
    yield sheet.line(
        "heel_leakage",
        "pi * heel_radius * heel_clearance**3 * (rim_pressure - heel_ambient_pressure)"
        " / (6 * rim_viscosity * heel_length)",
        digits=7,
    )
    parts = "heel_groove_flow + face_flow" if grooved else "face_flow"
    yield sheet.line("heel_leakage", parts, "the balance closes", digits=7)


def _friction(sheet: FootstepSheet, step: Footstep) -> Iterator[Line]:
    oil = step.oil
    if step.groove is None:
        shear = oil.at(sheet["face_outlet_temperature"] + ZERO_CELSIUS)
        yield sheet.given(
            "clearance_viscosity", "at the temperature at which oil leaves the face gap", value=shear
        )
        cylinder = f"clearance_viscosity * {TOTAL} * (screw_speed * heel_radius)**2"
    else:
        mean = step.options.friction_viscosity is FrictionViscosity.MEAN
        hot = oil.at(sheet["groove_outlet_temperature"] + ZERO_CELSIUS)
        shear = 0.5 * (oil.viscosity + hot) if mean else oil.at(sheet["rim_temperature"] + ZERO_CELSIUS)
        yield sheet.given("clearance_viscosity", step.options.friction_viscosity.value, value=shear)
        yield sheet.line("land_surface", "groove_starts * screw_land_width * groove_length")
        yield sheet.line("groove_surface", "groove_starts * screw_groove_width * groove_length")
        cylinder = (
            "clearance_viscosity * (land_surface / heel_clearance + groove_surface / (heel_clearance + "
            "groove_depth))"
            " * (groove_speed * heel_radius)**2"
        )
    outlet = sheet["face_outlet_temperature"] + ZERO_CELSIUS
    yield sheet.given(
        "face_viscosity", "at the mean temperature of the face gap", value=oil.at(0.5 * (oil.temperature + outlet))
    )
    yield sheet.line(
        "face_friction_power",
        "pi * face_viscosity * groove_speed**2 / 2 * ((heel_radius**4 - recess_radius**4) / face_gap"
        " + (recess_radius**4 - bore_radius**4) / recess_depth)",
    )
    yield sheet.line("friction_power", f"{cylinder} + face_friction_power", digits=6)
