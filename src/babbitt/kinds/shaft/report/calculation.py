"""The calculation of a shaft as lines: forces of every gear, then the load of every bearing."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.solution import Solution
from babbitt.kinds.shaft.gears import Gear, Helix
from babbitt.report.line import Line, Section
from babbitt.report.worksheet import Worksheet

__all__ = ["shaft_calculation"]

SIGNS = (
    "On the shaft; with n towards the mating gear and t in the positive sense of rotation, the force is "
    "±F_t t − F_r n, and the axial force acts at d/2 along n."
)
STATICS = "Moments about each bearing vanish."
BENDING = "Found with the deflection of the shaft at its bearings."


def shaft_calculation(solution: Solution) -> Iterator[Section]:
    """Sections of a solved shaft.

    Parameters
    ----------
    solution : Solution
        Of a shaft.
    """
    for gear in solution.problem.gears:
        yield Section(f"Forces of {gear.name}", tuple(_gear(gear)), SIGNS)
    arrays = solution.result.arrays
    two = len(solution.problem.shaft.carriers) == 2
    for place, support in enumerate(solution.problem.shaft.supports):
        if not support.radial:
            continue
        names = ("support_load_x", "support_load_y", "support_load")
        sheet = Worksheet({name: arrays[name][0][place] for name in names})
        lines = (
            sheet.given("support_load_x"),
            sheet.given("support_load_y"),
            sheet.line("support_load", "sqrt(support_load_x**2 + support_load_y**2)"),
        )
        yield Section(f"Load of {support.name}", lines, STATICS if two else BENDING)


def _gear(gear: Gear) -> Iterator[Line]:
    sheet = Worksheet(
        {
            "gear_torque": abs(gear.torque),
            "pitch_diameter": gear.diameter,
            "normal_pressure_angle": gear.pressure_angle,
            "helix_angle": gear.helix_angle,
        }
    )
    yield sheet.given("gear_torque")
    yield sheet.line("tangential_force", "2 * gear_torque / pitch_diameter")
    if gear.helix_angle == 0.0:
        yield sheet.line("radial_force", "tangential_force * tan(normal_pressure_angle)")
        return
    yield sheet.line("radial_force", "tangential_force * tan(normal_pressure_angle) / cos(helix_angle)")
    if gear.helix is not Helix.DOUBLE:
        yield sheet.line("axial_force", "tangential_force * tan(helix_angle)")
        yield sheet.line("axial_couple", "axial_force * pitch_diameter / 2")
