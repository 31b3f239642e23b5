"""The ISO 7902 calculation of one bearing as lines that can be followed with a pocket calculator.

The formulas stand here as expressions in names of the vocabulary. The values are those of the result, not
recomputed; a test holds every expression against them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from babbitt.core.limited_flow import limited
from babbitt.core.result import Result
from babbitt.kinds.journal.iso7902.film import curves_of
from babbitt.kinds.journal.iso7902.model import Friction, PrescribedEccentricity
from babbitt.kinds.journal.report.limited_lines import limited_lines
from babbitt.kinds.journal.report.oil_lines import oil_lines
from babbitt.kinds.journal.report.sheet import JournalSheet
from babbitt.kinds.journal.report.supply_lines import capacity_lines, flow_lines, loss_lines
from babbitt.report.line import SUBSTITUTED_DIGITS, Line, Section

if TYPE_CHECKING:
    from babbitt.kinds.journal.iso7902.model import DesignCase

LOAD_SCALE = "{width} * diameter * {viscosity} * hydrodynamic_speed"
HALVES = "2 * half_bearing_width"
LIMITED_REMARK = "The limits are held against the worse of both films; of this one its symbols have the index st."


def calculation(case: DesignCase, result: Result) -> tuple[Section, ...]:
    """The lines of a solved bearing, in the order of the standard.

    Parameters
    ----------
    case : DesignCase
    result : Result
        The answer to that case; for an unsolved one there is nothing to follow.

    Returns
    -------
    tuple of Section
        Empty for an unsolved result.
    """
    if not result.outcome.solved:
        return ()
    sheet = JournalSheet(case, result)
    sections = (
        Section("Operating clearance", tuple(_clearance(sheet))),
        Section("Load and speed", tuple(_load_and_speed(sheet))),
        Section("Oil at the effective temperature", tuple(oil_lines(case, sheet))),
        Section("Validity: laminar film", tuple(_validity(sheet))),
        Section(
            "Load number and position of the journal",
            tuple(_position(case, sheet)),
            "So, β, p_max/p̄ and Q₃* are read from solutions of the Reynolds equation for this span and "
            + ("B_H/D of each half bearing." if is_parted(sheet) else "B/D."),
        ),
        Section("Friction", tuple(_friction(case, sheet))),
        Section("Oil flow", (*_side_flow(sheet), *flow_lines(case, sheet))),
        Section("Heat balance", tuple(_heat(case, sheet)), _iteration(result)),
        Section("Supply capacity", tuple(capacity_lines(case, sheet))),
        Section("The film with the flow that the supply delivers", tuple(_limited(case, sheet)), LIMITED_REMARK),
        Section("Permissible values", tuple(_limits(case, sheet))),
        Section("Transition to mixed friction", tuple(_transition(case, sheet))),
        Section("Screening for whirl and clearance", tuple(_screening(sheet))),
        Section("Pressure losses in the supply", tuple(loss_lines(case, sheet))),
    )
    return tuple(section for section in sections if section.lines)


def is_parted(sheet: JournalSheet) -> bool:
    """Whether a groove around the circumference parts the bearing into two half bearings."""
    return "half_bearing_width" in sheet


def _loaded_width(sheet: JournalSheet) -> str:
    return HALVES if is_parted(sheet) else "width"


def _arguments(sheet: JournalSheet) -> tuple[str, str]:
    """What the characteristics are read for in addition to load or position."""
    return "half_bearing_width_ratio" if is_parted(sheet) else "width_ratio", "angular_span"


def _clearance(sheet: JournalSheet) -> Iterator[Line]:
    yield sheet.line(
        "operating_relative_clearance",
        "relative_clearance + (expansion_bearing - expansion_journal) * (effective_temperature - 20)",
    )
    yield sheet.line("radial_clearance", "operating_relative_clearance * diameter / 2")


def _load_and_speed(sheet: JournalSheet) -> Iterator[Line]:
    if is_parted(sheet):
        sheet.note(groove_width=sheet["width"] - 2.0 * sheet["half_bearing_width"])
        halves = "two half bearings side by side, each with half the load"
        yield sheet.line("half_bearing_width", "(width - groove_width) / 2", halves)
        yield sheet.line("half_bearing_width_ratio", "half_bearing_width / diameter")
    yield sheet.line("specific_load", f"load / ({_loaded_width(sheet)} * diameter)")
    backward = sheet["angular_speed"] < 0.0
    yield sheet.line("surface_speed", f"{'abs(angular_speed)' if backward else 'angular_speed'} * diameter / 2")


def _validity(sheet: JournalSheet) -> Iterator[Line]:
    yield sheet.line("film_reynolds_number", "density * surface_speed * radial_clearance / effective_viscosity")
    yield sheet.line(
        "critical_reynolds_number", "41.3 / sqrt(operating_relative_clearance)", "Re must not exceed it"
    )


def _position(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    scale = LOAD_SCALE.format(width=_loaded_width(sheet), viscosity="effective_viscosity")
    arguments = _arguments(sheet)
    if isinstance(case.duty, PrescribedEccentricity):
        yield sheet.given("eccentricity_ratio", "prescribed")
        yield sheet.read("sommerfeld_number", "eccentricity_ratio", *arguments)
        yield sheet.line(
            "load", f"sommerfeld_number * {scale} / operating_relative_clearance**2", "the load found"
        )
    else:
        yield sheet.line("sommerfeld_number", f"load * operating_relative_clearance**2 / ({scale})")
        yield sheet.read("eccentricity_ratio", "sommerfeld_number", *arguments)
    yield sheet.read("attitude_angle", "eccentricity_ratio", *arguments)
    yield sheet.line(
        "minimum_film_thickness", "operating_relative_clearance * diameter / 2 * (1 - eccentricity_ratio)"
    )
    ratio = sheet["maximum_pressure"] / sheet["specific_load"]
    yield sheet.read("peak_pressure_ratio", "eccentricity_ratio", *arguments, value=ratio)
    yield sheet.line("maximum_pressure", "peak_pressure_ratio * specific_load")


def _friction(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    yield from _read_for_friction(case, sheet, str)
    expression, remark = _friction_number(case, str)
    yield sheet.line("friction_number", expression, remark)
    yield sheet.line("friction_coefficient", "friction_number * operating_relative_clearance")
    yield sheet.line("friction_power", "friction_coefficient * load * surface_speed")
    yield sheet.line("friction_torque", "friction_coefficient * load * diameter / 2")


def _limited_friction(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    yield from _read_for_friction(case, sheet, limited)
    expression, remark = _friction_number(case, limited)
    if case.friction_factor == 1.0:
        expression = f"({expression})"
    yield sheet.line(
        "starved_friction_coefficient", f"{expression} * starved_operating_relative_clearance", remark
    )


Named = Callable[[str], str]
"""How a quantity is called of the film in question: with all the oil that it wants, or with the limited flow."""


def _read_for_friction(case: DesignCase, sheet: JournalSheet, named: Named) -> Iterator[Line]:
    """What the friction number needs besides the results of a film."""
    if case.friction is Friction.CURVE360:
        from babbitt.kinds.journal.iso7902.characteristics import curves

        full = curves(360, case.bearing.part_width_ratio)
        eccentricity, ratio = named("eccentricity_ratio"), _arguments(sheet)[0]
        for name, value in (
            ("full_sommerfeld_number", full.sommerfeld_number(sheet[eccentricity])),
            ("full_attitude_angle", full.attitude_angle(sheet[eccentricity])),
        ):
            yield sheet.read(name, eccentricity, ratio, value=value)
    elif case.friction is Friction.ARC:
        yield sheet.read(
            "sheared_arc",
            named("eccentricity_ratio"),
            named("attitude_angle"),
            "angular_span",
            value=_sheared_arc(case, sheet, named),
        )


def _friction_number(case: DesignCase, named: Named) -> tuple[str, str]:
    """Expression of the friction number, and what it is of."""
    so, eccentricity, angle = map(named, ("sommerfeld_number", "eccentricity_ratio", "attitude_angle"))
    remark = "film around the whole circumference"
    sheared = f"pi / ({{so}} * sqrt(1 - {eccentricity}**2))"
    if case.friction is Friction.CURVE360:
        so, angle = "full_sommerfeld_number", "full_attitude_angle"
        remark = "friction number of the full bearing at the same eccentricity"
    elif case.friction is Friction.ARC:
        remark = "film on the loaded arc only"
        sheared = "sheared_arc / (2 * {so})"
    expression = f"{sheared.format(so=so)} + {eccentricity} / 2 * sin({angle})"
    if case.friction_factor != 1.0:
        expression = f"friction_factor * ({expression})"
        remark += ", times a factor chosen in the case"
    return expression, remark


def _sheared_arc(case: DesignCase, sheet: JournalSheet, named: Named) -> float:
    """The integral I that the friction number of the result contains."""
    so, eps, beta, coefficient, clearance = (
        sheet[named(name)]
        for name in (
            "sommerfeld_number",
            "eccentricity_ratio",
            "attitude_angle",
            "friction_coefficient",
            "operating_relative_clearance",
        )
    )
    return 2.0 * so * (coefficient / clearance / case.friction_factor - eps / 2.0 * math.sin(beta))


def _limited(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    scale = LOAD_SCALE.format(width=_loaded_width(sheet), viscosity="starved_effective_viscosity")
    yield from limited_lines(case, sheet, scale, _arguments(sheet), _limited_friction(case, sheet))


def _side_flow(sheet: JournalSheet) -> Iterator[Line]:
    yield sheet.read("side_flow_number", "eccentricity_ratio", *_arguments(sheet))
    whole = "diameter**3 * operating_relative_clearance * hydrodynamic_speed * side_flow_number"
    if is_parted(sheet):
        yield sheet.line("side_flow", f"2 * {whole}", "of both half bearings")
    else:
        yield sheet.line("side_flow", whole)


def _heat(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    if case.effective_temperature is not None:
        return
    if case.oil_supply is not None:
        outlet, inlet = sheet["outlet_temperature"], sheet["supply_temperature"]
        if math.isclose(sheet["effective_temperature"], (inlet + outlet) / 2.0, abs_tol=1e-6):
            yield sheet.line("effective_temperature", "(supply_temperature + outlet_temperature) / 2")
        else:
            yield sheet.given("outlet_temperature", "that of the surroundings, which the oil cannot fall below")
        cancelled = math.floor(math.log10(max(abs(outlet) / max(abs(outlet - inlet), 1e-6), 1.0)))
        yield sheet.line(
            "heat_to_oil",
            "volumetric_heat_capacity * total_flow * (outlet_temperature - supply_temperature)",
            digits=SUBSTITUTED_DIGITS + cancelled,
        )
    if case.cooling is not None:
        yield sheet.line(
            "heat_to_surroundings",
            "heat_transfer_coefficient * cooling_surface * (bearing_temperature - ambient_temperature)",
        )
    parts = [
        name
        for name, present in (("heat_to_oil", case.oil_supply), ("heat_to_surroundings", case.cooling))
        if present is not None
    ]
    yield sheet.line("friction_power", " + ".join(parts), "the balance closes")


def _iteration(result: Result) -> str:
    evaluations = result.values.get("iterations")
    defect = abs(result.values.get("energy_balance_error", math.nan))
    if evaluations is None or not math.isfinite(defect):
        return ""
    size = "less than 1e-9" if defect < 1e-9 else f"{defect:.1e}"
    return (
        "The effective temperature is the one at which this balance closes; found in "
        f"{evaluations:.0f} evaluations of the film, with a defect of {size} of the friction power."
    )


def _limits(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    if "empirical_film_limit" in sheet:
        yield sheet.read("empirical_film_limit", "diameter", "surface_speed", remark="table of experience values")
    if case.bearing.surfaces is not None:
        yield sheet.line(
            "geometric_film_limit",
            "roughness_bearing + roughness_journal + tilt_offset / 2 + mean_deflection / 2"
            " + waviness * wave_factor",
        )
    elif "geometric_film_limit" in sheet:
        yield sheet.read("geometric_film_limit", "width", remark="slope of the shaft times half the width")
    yield sheet.line("pressure_speed_product", "specific_load * surface_speed")


def _transition(case: DesignCase, sheet: JournalSheet) -> Iterator[Line]:
    if "transition_speed" not in sheet:
        return
    yield sheet.given(
        "transition_film_thickness", "as set in the case" if case.limits.transition_film_thickness else "h_lim,2"
    )
    yield from _transition_of(case, sheet, str, "viscosity and clearance of the operating point")
    if "starved_transition_speed" not in sheet:
        return
    remark = "viscosity and clearance of the film with the limited flow"
    if isinstance(case.duty, PrescribedEccentricity):  # under a load of its own, which no result names
        yield sheet.given("starved_transition_speed", remark)
    else:
        yield from _transition_of(case, sheet, limited, remark)


def _transition_of(case: DesignCase, sheet: JournalSheet, named: Named, remark: str) -> Iterator[Line]:
    """The speed at which a film thins to that of transition."""
    curves, clearance = curves_of(case), named("operating_relative_clearance")
    eccentricity = 1.0 - 2.0 * sheet["transition_film_thickness"] / (sheet[clearance] * case.bearing.diameter)
    reachable = min(eccentricity, curves.largest_eccentricity_ratio)
    sheet.note(transition_eccentricity=eccentricity)
    yield sheet.line("transition_eccentricity", f"1 - 2 * transition_film_thickness / ({clearance} * diameter)")
    beyond = "beyond the tables: So at their end, the speed is an upper bound" if eccentricity > reachable else ""
    yield sheet.read(
        "transition_sommerfeld_number",
        "transition_eccentricity",
        *_arguments(sheet),
        value=curves.sommerfeld_number(reachable),
        remark=beyond,
    )
    viscosity = named("effective_viscosity")
    yield sheet.line(
        named("transition_speed"),
        f"specific_load * {clearance}**2 / ({viscosity} * transition_sommerfeld_number)",
        remark,
    )


def _screening(sheet: JournalSheet) -> Iterator[Line]:
    yield sheet.line("regime_number", "1e6 * effective_viscosity * hydrodynamic_speed / (2 * pi * specific_load)")
    ratio = _arguments(sheet)[0]
    yield sheet.line("stability_relative_clearance", f"3.5e-3 * sqrt(regime_number * {ratio})", "Orlov")
    yield sheet.line("recommended_relative_clearance", "0.8e-3 * surface_speed**(1 / 4)", "Vogelpohl")
