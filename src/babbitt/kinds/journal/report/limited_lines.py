"""Lines of the calculation of the film that has no more oil than its supply delivers."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import PrescribedEccentricity
from babbitt.report.line import Line
from babbitt.report.worksheet import Worksheet

if TYPE_CHECKING:
    from babbitt.kinds.journal.iso7902.model import DesignCase

__all__ = ["limited_lines"]


def limited_lines(
    case: DesignCase, sheet: Worksheet, load_scale: str, arguments: tuple[str, str], friction: Iterable[Line]
) -> Iterator[Line]:
    """The steps of the standard once more, at the temperature that the limited flow leaves.

    Parameters
    ----------
    case : DesignCase
    sheet : Worksheet
        After the lines of the film with all its oil.
    load_scale : str
        What the Sommerfeld number divides by, as an expression.
    arguments : tuple of str
        What the characteristics are read for in addition to load or position.
    friction : iterable of Line
        Of its friction coefficient.
    """
    if "starved_total_flow" not in sheet:
        return
    temperature = sheet["starved_effective_temperature"]
    sheet.note(
        starved_density=case.lubricant.density(temperature + ZERO_CELSIUS),
        starved_heat_capacity=case.lubricant.volumetric_heat_capacity(temperature + ZERO_CELSIUS),
    )
    yield from _temperature(sheet)
    yield sheet.line(
        "starved_operating_relative_clearance",
        "relative_clearance + (expansion_bearing - expansion_journal) * (starved_effective_temperature - 20)",
    )
    yield sheet.read(
        "starved_effective_viscosity", "starved_effective_temperature", remark="by the viscosity law above"
    )
    yield from _laminar(sheet)
    found = not isinstance(case.duty, PrescribedEccentricity)
    if found:
        yield sheet.line(
            "starved_sommerfeld_number",
            f"load * starved_operating_relative_clearance**2 / ({load_scale})",
        )
        yield sheet.read("starved_eccentricity_ratio", "starved_sommerfeld_number", *arguments)
    else:
        yield sheet.given("starved_eccentricity_ratio", "prescribed")
    yield sheet.read("starved_attitude_angle", "starved_eccentricity_ratio", *arguments)
    yield sheet.line(
        "starved_minimum_film_thickness",
        "starved_operating_relative_clearance * diameter / 2 * (1 - starved_eccentricity_ratio)",
    )
    if found:  # else the mean pressure is that of this film, too
        ratio = sheet["starved_maximum_pressure"] / sheet["specific_load"]
        yield sheet.read("starved_peak_pressure_ratio", "starved_eccentricity_ratio", *arguments, value=ratio)
        yield sheet.line("starved_maximum_pressure", "starved_peak_pressure_ratio * specific_load")
    yield from friction
    if found:  # else the load is that of this film, which no result names
        yield sheet.line("starved_friction_power", "starved_friction_coefficient * load * surface_speed")
    else:
        yield sheet.given("starved_friction_power")
    yield sheet.given(
        "starved_side_flow", "what the journal takes from the supply, at most Q₃, by the steps above"
    )
    yield sheet.given("starved_supply_flow", "by the steps above, at this film")
    yield sheet.line("starved_total_flow", "starved_side_flow + starved_supply_flow")
    if "starved_heat_to_oil" in sheet and case.cooling is None:
        yield sheet.line(
            "starved_friction_power",
            "starved_heat_capacity * starved_total_flow * (starved_outlet_temperature - supply_temperature)",
            "the balance closes",
        )


def _temperature(sheet: Worksheet) -> Iterator[Line]:
    """That at which the heat balance closes with the flow that the supply delivers."""
    outlet, found = "starved_outlet_temperature", "starved_effective_temperature"
    closes = "closes the balance with the flow that the supply delivers"
    if outlet not in sheet:
        yield sheet.given(found, closes)
        return
    yield sheet.given(outlet, closes)
    if math.isclose(sheet[found], (sheet["supply_temperature"] + sheet[outlet]) / 2.0, abs_tol=1e-6):
        yield sheet.line(found, "(supply_temperature + starved_outlet_temperature) / 2")
    else:
        yield sheet.given(found, closes)


def _laminar(sheet: Worksheet) -> Iterator[Line]:
    yield sheet.line(
        "starved_film_reynolds_number",
        "starved_density * surface_speed * starved_operating_relative_clearance * diameter"
        " / (2 * starved_effective_viscosity)",
    )
    yield sheet.line("starved_critical_reynolds_number", "41.3 / sqrt(starved_operating_relative_clearance)")
