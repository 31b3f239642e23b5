"""What a footstep was computed from, in words and numbers for the report."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.states import Method

Said = tuple[str, str, str]
"""What it is, its value, its unit."""

METHODS = {
    Method.SUPERPOSITION: "Equations of the study, corrected: adiabatic groove beside a full slit",
    Method.NARROW_GROOVE: "Narrow-groove theory for the clearance, one temperature for each film",
}


def heel_inputs(case: FootstepProblem) -> tuple[tuple[str, tuple[Said, ...]], ...]:
    """Groups of inputs: title, and what is said."""
    step = case.footstep
    if step.groove is None and case.other is not None:
        step = case.other
    return (
        ("Heel and recess", tuple(_heel(step))),
        ("Screw groove", tuple(_groove(step))),
        ("Oil", tuple(_oil(step))),
        ("Operation", tuple(_operation(step))),
        ("Method", tuple(_method(case, step))),
    )


def _millimetres(value: float) -> tuple[str, str]:
    return f"{1e3 * value:.5g}", "mm"


def _micrometres(value: float) -> tuple[str, str]:
    return f"{1e6 * value:.5g}", "µm"


def _heel(step: Footstep) -> Iterator[Said]:
    part = step.geometry
    yield "Length L", *_millimetres(part.length)
    yield "Radius r₁", *_millimetres(part.radius)
    yield "Radius of the recess r₃", *_millimetres(part.recess_radius)
    yield "Radius of the bore r₂", *_millimetres(part.bore_radius)
    yield "Depth of the recess H", *_millimetres(part.recess_depth)
    yield "Face gap h_f", *_micrometres(step.face_gap)
    yield "Radial clearance δ", *_micrometres(step.clearance)
    if step.end_eccentricities != (0.0, 0.0):
        ends = ", ".join(f"{one:.3g}" for one in step.end_eccentricities)
        yield "Eccentricity over clearance at rim, outer end", ends, ""


def _groove(step: Footstep) -> Iterator[Said]:
    groove = step.groove
    if groove is None:
        return
    yield "Angle from the circumference φ", f"{math.degrees(groove.angle):.5g}", "°"
    yield "Depth", *_millimetres(groove.depth)
    yield "Groove width a, normal", *_millimetres(groove.groove_width)
    yield "Land width b, normal", *_millimetres(groove.land_width)
    yield "Starts", f"{groove.starts}", ""


def _oil(step: Footstep) -> Iterator[Said]:
    oil = step.oil
    yield "Viscosity of the oil that comes in", f"{1e3 * oil.viscosity:.5g}", "mPa s"
    yield "Its temperature", f"{oil.temperature - ZERO_CELSIUS:.5g}", "°C"
    yield "Exponent of viscosity α", f"{oil.exponent:.4g}", "1/K"
    yield "Density times heat capacity", f"{1e-6 * oil.heat_capacity:.4g}", "MJ/(m³ K)"
    yield "Density", f"{oil.density:.4g}", "kg/m³"


def _operation(step: Footstep) -> Iterator[Said]:
    yield "Speed", f"{step.angular_speed * 30.0 / math.pi:.5g}", "rpm"
    yield "Pressure in the recess, absolute", f"{1e-6 * step.supply_pressure:.5g}", "MPa"
    yield "Pressure of the surroundings, absolute", f"{1e-6 * step.ambient_pressure:.5g}", "MPa"
    if step.wall is not None:
        yield "Metal", f"{step.wall.temperature - ZERO_CELSIUS:.4g} °C, {step.wall.conductance:.4g} W/K", ""


def _method(case: FootstepProblem, step: Footstep) -> Iterator[Said]:
    yield "Equations", METHODS[case.method], ""
    options = step.options
    yield "Load counts", options.load_reference.value, ""
    if case.method is Method.NARROW_GROOVE:
        return
    yield "Friction in the clearance", options.friction_viscosity.value, ""
    yield "Face gap heats the oil", options.face_outlet.value, ""
    yield "Viscosity of backflow", options.backflow_viscosity.value, ""
    if options.entry_loss:
        yield "Local loss coefficient of the groove inlet", f"{options.entry_loss:.4g}", ""
    if options.speed_reduction:
        yield "Speed-reduction factor β", f"{options.speed_reduction:.4g}", ""
