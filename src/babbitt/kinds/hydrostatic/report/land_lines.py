"""Lines of the calculation that concern the lands: what they let out, what they carry, how they rub."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.hydrostatic.closed_forms import CORNER_LOAD
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, PadShape, RectangularPad
from babbitt.report.line import Line
from babbitt.report.worksheet import Worksheet

__all__ = ["annular_area", "centred_lines", "journal_friction", "land_lines", "pad_friction", "ring_friction"]

THROUGH = "pi * gap**3 / (6 * effective_viscosity"
SPAN = "ln(pad_radius / pad_recess_radius)"
INNER, OUTER = "ln(ring_recess_inner_edge / ring_inner_edge)", "ln(ring_outer_edge / ring_recess_outer_edge)"
SHEAR = "effective_viscosity * angular_speed"


def annular_area() -> str:
    """Effective area of a ring with an annular recess."""
    return (
        f"pi / 2 * ((ring_outer_edge**2 - ring_recess_outer_edge**2) / {OUTER}"
        f" - (ring_recess_inner_edge**2 - ring_inner_edge**2) / {INNER})"
    )


def land_lines(sheet: Worksheet, pad: PadShape) -> Iterator[Line]:
    """Conductance and effective area of a pad with one recess by closed forms."""
    match pad:
        case CircularPad():
            yield sheet.line("land_conductance", f"{THROUGH} * {SPAN})")
            yield sheet.line("effective_area", f"pi * (pad_radius**2 - pad_recess_radius**2) / (2 * {SPAN})")
        case AnnularPad():
            yield sheet.line("land_conductance", f"{THROUGH}) * (1 / {INNER} + 1 / {OUTER})")
            yield sheet.line("effective_area", annular_area())
        case RectangularPad():
            yield from _rectangle(sheet, sheet["effective_area"])


def _rectangle(sheet: Worksheet, area: float) -> Iterator[Line]:
    sides = "(pad_recess_length + pad_recess_width)"
    equal = (
        f"pad_recess_length * pad_recess_width + {sides} * land_along + 4 * {CORNER_LOAD} * land_along**2",
        f"2 * {sides} / land_along + 4 * (1 - 2 * ln(2) / pi)",
    )
    crude = (
        "(pad_length * pad_width + pad_recess_length * pad_recess_width) / 2",
        "2 * (pad_recess_length / land_across + pad_recess_width / land_along)",
    )
    is_equal = abs(sheet["land_along"] / sheet["land_across"] - 1.0) < 1e-6
    carries, squares = equal if is_equal else crude
    yield sheet.line("land_squares", squares, "strips and corners" if is_equal else "strips without corners")
    yield sheet.line("land_conductance", "land_squares * gap**3 / (12 * effective_viscosity)")
    yield sheet.line("effective_area", carries)


def pad_friction(sheet: Worksheet, pad: PadShape) -> Line:
    """Friction power of a pad at one gap everywhere."""
    match pad:
        case CircularPad():
            lands = "(pad_radius**4 - pad_recess_radius**4) / gap"
            recess = "recess_friction * pad_recess_radius**4 / recess_depth"
        case AnnularPad():
            lands = (
                "(ring_outer_edge**4 - ring_recess_outer_edge**4 + ring_recess_inner_edge**4"
                " - ring_inner_edge**4) / gap"
            )
            recess = "recess_friction * (ring_recess_outer_edge**4 - ring_recess_inner_edge**4) / recess_depth"
        case RectangularPad():
            lands = "(pad_length * pad_width - recess_surface) / gap"
            recess = "recess_friction * recess_surface / recess_depth"
            return sheet.line("friction_power", f"effective_viscosity * slide_speed**2 * ({lands} + {recess})")
    return sheet.line("friction_power", f"pi * effective_viscosity * angular_speed**2 / 2 * ({lands} + {recess})")


def ring_friction(sheet: Worksheet, backward: bool) -> Iterator[Line]:
    """Friction torque of a ring with lumped lands at its mean gap."""
    raised = "recess_number * recess_angle / 4 * (ring_recess_outer_edge**4 - ring_recess_inner_edge**4)"
    yield sheet.line("recess_inertia", raised)
    lands = "(pi / 2 * (ring_outer_edge**4 - ring_inner_edge**4) - recess_inertia) / gap"
    recesses = "recess_friction * recess_inertia / recess_depth"
    yield sheet.line("shear_torque", f"{SHEAR} * ({lands} + {recesses})")
    yield sheet.line("pressure_torque", "(tilt_x * moment_y - tilt_y * moment_x) / 2")
    yield sheet.line("friction_torque", f"shear_torque {'-' if backward else '+'} pressure_torque")


def journal_friction(sheet: Worksheet) -> Iterator[Line]:
    """Friction torque of a journal with lumped lands, as if the lands were all around."""
    lands = (
        "(pi * diameter * width - recess_number * recess_surface)"
        " / (radial_clearance * sqrt(1 - eccentricity_ratio**2))"
    )
    recesses = "recess_friction * recess_number * recess_surface / recess_depth"
    yield sheet.line("shear_torque", f"{SHEAR} * diameter**2 / 4 * ({lands} + {recesses})")
    yield sheet.line("pressure_torque", "radial_clearance * eccentricity_ratio * load * sin(attitude_angle) / 2")
    yield sheet.line("friction_torque", "shear_torque + pressure_torque")


def centred_lines(sheet: Worksheet) -> Iterator[Line]:
    """The centred journal with equal linear restrictors, without drain grooves."""
    yield sheet.line("axial_land", "(width - recess_axial_length) / 2")
    outer = "pi * diameter * radial_clearance**3 / (6 * effective_viscosity * axial_land)"
    yield sheet.line("centred_conductance", outer)
    yield sheet.line("centred_ratio", "1 / (1 + centred_conductance / (recess_number * restrictor_conductance))")
    yield sheet.line(
        "centred_flow", "recess_number * restrictor_conductance * supply_pressure * (1 - centred_ratio)"
    )
    yield sheet.line(
        "land_interaction",
        "recess_number * axial_land * (width - axial_land) / (pi * diameter * between_land)",
    )
    yield sheet.line(
        "centred_stiffness",
        "3 * recess_number**2 / (2 * pi) * sin(pi / recess_number)**2 * diameter * (width - axial_land)"
        " * supply_pressure * centred_ratio * (1 - centred_ratio)"
        " / (radial_clearance * (1 + land_interaction * (1 - centred_ratio) * (1 - cos(2 * pi / recess_number))))",
    )
