"""The numbers of one hydrostatic bearing as its calculation goes on."""

from __future__ import annotations

import math

from babbitt.core.result import Result
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase, Shape
from babbitt.report.worksheet import Worksheet

__all__ = ["HydrostaticSheet", "JackingSheet"]


class HydrostaticSheet(Worksheet):
    """Values of the result, and of the case what they follow from; see `Worksheet`.

    Where the result has several recesses, the pressure and flow are those of the recess with the highest.
    """

    def __init__(self, case: HydrostaticCase, result: Result) -> None:
        pressures, flows = result.arrays["recess_pressure"][0], result.arrays["restrictor_flow"][0]
        self.highest = max(range(len(pressures)), key=pressures.__getitem__)
        self.pressures = pressures
        known = dict(result.values) | {
            "one_recess_pressure": pressures[self.highest],
            "one_restrictor_flow": flows[self.highest],
            "oil_warming": result.values["temperature_rise"],
            "recess_number": float(case.count),
            "recess_surface": case.recess_area,
            "recess_depth": case.recesses.depth,
            "recess_friction": case.recesses.friction_factor,
            "efficiency_of_pump": case.pump_efficiency,
            "slide_speed": case.duty.sliding_speed,
        }
        known |= lengths(case.shape)
        if not case.oil.is_warmed:
            known["volumetric_heat_capacity"] = case.oil.density * case.oil.heat_capacity
        super().__init__(known)


class JackingSheet(Worksheet):
    """Values of the result and of the case with jacking pockets; see `Worksheet`."""

    def __init__(self, case: JackingCase, result: Result) -> None:
        known = dict(result.values) | lengths(case.bearing)
        known |= {
            "projected_area": case.projected_area,
            "roughness_height": case.roughness,
            "efficiency_of_pump": case.pump_efficiency,
        }
        super().__init__(known)


def lengths(shape: Shape) -> dict[str, float]:
    """Dimensions of a shape by the names of the vocabulary."""
    match shape:
        case CircularPad():
            return {"pad_radius": shape.outer_radius, "pad_recess_radius": shape.recess_radius}
        case AnnularPad():
            return edges(shape)
        case RectangularPad():
            along, across = shape.lands
            return {
                "pad_length": shape.length,
                "pad_width": shape.width,
                "pad_recess_length": shape.recess_length,
                "pad_recess_width": shape.recess_width,
                "land_along": along,
                "land_across": across,
            }
        case ThrustRing():
            return edges(shape.radii) | {"recess_angle": shape.recess_extent}
        case RecessedJournal():
            between = (2.0 * math.pi / shape.count - shape.recess_extent) * shape.radius
            return {
                "diameter": shape.diameter,
                "width": shape.width,
                "radial_clearance": shape.clearance,
                "recess_axial_length": shape.recess_length,
                "between_land": between,
            }


def edges(ring: AnnularPad) -> dict[str, float]:
    """Radii of a ring and of its recess."""
    names = ("ring_inner_edge", "ring_recess_inner_edge", "ring_recess_outer_edge", "ring_outer_edge")
    return dict(zip(names, ring.radii, strict=True))
