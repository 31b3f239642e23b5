"""What a hydrostatic bearing was computed from, in rows."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.language import listed
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase, Shape
from babbitt.kinds.hydrostatic.report.words import SUPPLY_TEMPERATURE
from babbitt.kinds.hydrostatic.restrictors import (
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
from babbitt.kinds.hydrostatic.supply import FixedPressure

Said = tuple[str, str, str]
"""Label, value, unit."""


def geometry_rows(shape: Shape) -> Iterator[Said]:
    """Shape of pad or bearing."""
    match shape:
        case CircularPad():
            yield "Outer diameter", _mm(2.0 * shape.outer_radius), "mm"
            yield "Recess diameter", _mm(2.0 * shape.recess_radius), "mm"
        case AnnularPad():
            yield "Diameters of edges and recess", listed(_mm(2.0 * r) for r in shape.radii), "mm"
        case RectangularPad():
            yield "Length × width of the pad", f"{_mm(shape.length)} × {_mm(shape.width)}", "mm"
            yield "Length × width of the recess", f"{_mm(shape.recess_length)} × {_mm(shape.recess_width)}", "mm"
        case ThrustRing():
            yield "Diameters of edges and recesses", listed(_mm(2.0 * r) for r in shape.radii.radii), "mm"
            yield from _recesses(shape.recess_angles, shape.recess_extent, shape.groove_extent)
        case RecessedJournal():
            yield "Bore", _mm(shape.diameter), "mm"
            yield "Width", _mm(shape.width), "mm"
            yield "Radial clearance", f"{1e6 * shape.clearance:.4g}", "µm"
            yield from _recesses(shape.recess_angles, shape.recess_extent, shape.groove_extent)
            yield "Axial length of a recess", _mm(shape.recess_length), "mm"


def _recesses(angles: tuple[float, ...], extent: float, groove: float) -> Iterator[Said]:
    yield "Number of recesses", str(len(angles)), ""
    middles = (f"{math.degrees(math.remainder(angle, 2.0 * math.pi)):.4g}" for angle in angles)
    yield "Middles of the recesses", listed(middles), "°"
    yield "Angle of a recess", f"{math.degrees(extent):.4g}", "°"
    if groove:
        yield "Angle of a drain groove", f"{math.degrees(groove):.4g}", "°"


def feeding_rows(case: HydrostaticCase) -> Iterator[Said]:
    """Restrictors, supply, recesses."""
    restrictors = case.feeding.restrictors
    if case.feeding.is_uniform:
        yield "Restrictor before every recess", describe_restrictor(restrictors[0]), ""
    else:
        for k, one in enumerate(restrictors, 1):
            yield f"Restrictor before recess {k}", describe_restrictor(one), ""
    supply = case.feeding.supply
    if isinstance(supply, FixedPressure):
        yield "Supply pressure", f"{1e-6 * supply.pressure:.5g}", "MPa"
    else:
        yield "Flow of the pump", f"{6e4 * supply.flow:.5g}", "L/min"
        yield "Leakage of the pump", f"{6e10 * supply.leakage:.4g}", "L/(min MPa)"
        if math.isfinite(supply.relief_pressure):
            yield "Relief valve opens at", f"{1e-6 * supply.relief_pressure:.5g}", "MPa"
    yield "Efficiency of the pump", f"{case.pump_efficiency:.3g}", ""
    yield "Depth of the recesses", _mm(case.recesses.depth), "mm"
    yield "Friction factor in the recesses", f"{case.recesses.friction_factor:.3g}", ""
    yield "Oil behind one restrictor", f"{1e6 * case.compressibility.recess_volume:.4g}", "mL"
    yield "Of it in line and ports", f"{1e6 * case.compressibility.line_volume:.4g}", "mL"
    if not isinstance(supply, FixedPressure):
        yield "Oil before the restrictors", f"{1e6 * case.compressibility.manifold_volume:.4g}", "mL"
    yield "Bulk modulus of the oil", f"{1e-9 * case.compressibility.bulk_modulus:.4g}", "GPa"


def describe_restrictor(restrictor: Restrictor) -> str:
    """Say what a restrictor is."""
    match restrictor:
        case CheckValve():
            return f"{describe_restrictor(restrictor.restrictor)}, with check valve"
        case Capillary():
            tubes = f"{restrictor.tubes} capillaries" if restrictor.tubes > 1 else "capillary"
            loss = f", entry loss {restrictor.entry_loss:g}" if restrictor.entry_loss else ""
            return f"{tubes} {_mm(restrictor.diameter)} mm × {_mm(restrictor.length)} mm{loss}"
        case Orifice():
            return f"orifice {_mm(restrictor.diameter)} mm, discharge coefficient {restrictor.discharge:g}"
        case Slot():
            return f"slot {_mm(restrictor.width)} × {_mm(restrictor.gap)} × {_mm(restrictor.length)} mm"
        case ConstantFlow():
            return f"pump of {6e4 * restrictor.flow:.4g} L/min"
        case MeteredFlow():
            return f"metering stage of {6e4 * restrictor.flow:.4g} L/min"
        case FlowValve():
            return f"flow valve {6e4 * restrictor.flow:.4g} L/min + {6e10 * restrictor.gain:.4g} L/(min MPa)"
        case MembraneValve():
            stiff = f"{1e6 * restrictor.compliance:.4g}/MPa"
            return f"membrane valve {6e10 * restrictor.conductance:.4g} L/(min MPa), compliance {stiff}"


def operation_rows(case: HydrostaticCase) -> Iterator[Said]:
    """Load or position, speed."""
    duty = case.duty
    if duty.load is not None:
        yield "Load", f"{1e-3 * duty.load:.6g}", "kN"
        if any(duty.moments):
            yield "Moments about x and y", listed(f"{one:.5g}" for one in duty.moments), "N m"
    elif case.is_journal:
        yield "Prescribed position x, y", listed(f"{1e6 * one:.5g}" for one in duty.position), "µm"
    else:
        yield "Prescribed gap", f"{1e6 * duty.gap:.5g}", "µm"
        if any(duty.tilt):
            yield "Prescribed tilt about x and y", listed(f"{1e3 * one:.5g}" for one in duty.tilt), "mm/m"
    if duty.sliding_speed:
        yield "Sliding speed", f"{duty.sliding_speed:.4g}", "m/s"
    elif not isinstance(case.shape, RectangularPad):  # which does not turn
        yield "Speed", f"{duty.angular_speed * 30.0 / math.pi:.5g}", "rpm"


def oil_rows(case: HydrostaticCase) -> Iterator[Said]:
    """The oil."""
    oil = case.oil
    if oil.lubricant is not None:
        yield "Lubricant", oil.lubricant.name, ""
    else:
        yield "Viscosity in the film", f"{1e3 * oil.viscosity:.4g}", "mPa s"
        yield "Density", f"{oil.density:.4g}", "kg/m³"
        yield "Specific heat", f"{oil.heat_capacity:.5g}", "J/(kg K)"
    if oil.supply_temperature is not None:
        yield SUPPLY_TEMPERATURE, f"{oil.supply_temperature - ZERO_CELSIUS:.4g}", "°C"
    if oil.film_temperature is not None:
        yield "Temperature of the film, given", f"{oil.film_temperature - ZERO_CELSIUS:.4g}", "°C"


GRIDS = {"reference": "reference; full films extrapolated from it and half of its lines"}
METHODS = {
    "film": "Reynolds equation in two dimensions with the flow network of the recesses",
    "quick": "closed forms; lands lumped where there are several recesses",
}


def groups(case: HydrostaticCase | JackingCase) -> tuple[tuple[str, tuple[Said, ...]], ...]:
    """All rows, by title."""
    if isinstance(case, JackingCase):
        return jacking_groups(case)
    method = [("Film", METHODS[case.method], "")]
    if case.method == "film":
        method += [("Where the film breaks up", "pressure and its gradient vanish (Reynolds)", ""),
                   ("Grid", GRIDS.get(case.accuracy, case.accuracy), "")]  # fmt: skip
    if case.least_gap is not None:
        method.append(("Least gap allowed", f"{1e6 * case.least_gap:.4g}", "µm"))
    return (
        ("Geometry", tuple(geometry_rows(case.shape))),
        ("Operation", tuple(operation_rows(case))),
        ("Oil", tuple(oil_rows(case))),
        ("Restrictors and recesses", tuple(feeding_rows(case))),
        ("Method", tuple(method)),
    )


def jacking_groups(case: JackingCase) -> tuple[tuple[str, tuple[Said, ...]], ...]:
    """Rows of jacking pockets."""
    oil = [("Viscosity of the cold oil", f"{1e3 * case.viscosity:.4g}", "mPa s"),
           ("Load", f"{1e-3 * case.load:.6g}", "kN"),
           ("Composite roughness height", f"{1e6 * case.roughness:.4g}", "µm")]  # fmt: skip
    if case.lift_gap is not None:
        oil.append(("Wanted smallest gap", f"{1e6 * case.lift_gap:.4g}", "µm"))
    if case.pump_flow is not None:
        oil.append(("Flow of the jacking pump", f"{6e4 * case.pump_flow:.4g}", "L/min"))
    if case.relief_pressure is not None:
        oil.append(("Relief valve opens at", f"{1e-6 * case.relief_pressure:.4g}", "MPa"))
    return ("Geometry", tuple(geometry_rows(case.bearing))), ("Lifting", tuple(oil))


def _mm(length: float) -> str:
    return f"{1e3 * length:.5g}"
