"""Lines of the calculation that concern the oil supply: flow through the element, losses on the way."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.design.ducts import LAMINAR_UP_TO, TURBULENT_FROM, Duct, pipe_friction_factor
from babbitt.kinds.journal.iso7902.film import returned_gap, start_of_film
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
    fitted_width,
    logarithm_width,
)
from babbitt.report.line import Line
from babbitt.report.worksheet import Worksheet

if TYPE_CHECKING:
    from babbitt.kinds.journal.iso7902.model import DesignCase

_FILM_FACTOR = {
    Arrangement.OPPOSITE: "pi / 48 * (1 + eccentricity_ratio)**3",
    Arrangement.SIDE: "pi / 48",
    Arrangement.BOTH_SIDES: "pi / 24",
}
_HOLE_CORRECTION = "1.204 + 0.368 * {s} - 1.046 * {s}**2 + 1.942 * {s}**3"
_POCKET_CORRECTION = "1.188 + 1.582 * {s} - 2.585 * {s}**2 + 5.563 * {s}**3"
_GROOVE_360 = "pi * (1 + 1.5 * eccentricity_ratio**2) / (24 * width_ratio * (1 - element_ratio))"
_GROOVE_180 = (
    "(pi * (1 + 1.5 * eccentricity_ratio**2) + 6 * eccentricity_ratio + 4 / 3 * eccentricity_ratio**3)"
    " / (48 * width_ratio * (1 - element_ratio))"
)


def flow_lines(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    """Supply-flow number by the formula of the element, supply flow, total flow."""
    if case.oil_supply is None:
        return
    if case.bearing.supply_element is not None and "supply_flow_number" in sheet:
        yield from _element(case, sheet)
        if not (case.oil_supply.tubes or case.oil_supply.holes):
            yield sheet.line("element_pressure", "supply_pressure", "no losses on the way")
        yield sheet.line(
            "supply_flow",
            "supply_flow_number * diameter**3 * operating_relative_clearance**3 * element_pressure"
            " / effective_viscosity",
        )
    yield sheet.line("total_flow", "side_flow + supply_flow")


def _element(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    element = case.bearing.supply_element
    match element:
        case Holes():
            sheet.note(hole_diameter=element.diameter, hole_number=element.number)
            yield from _correction(sheet, "hole", "hole_diameter", _HOLE_CORRECTION)
            share = f"{_FILM_FACTOR[element.arrangement]} / (ln(1 / {_logarithm(sheet)}) * hole_correction)"
            several = element.number != 1.0
            yield sheet.line(
                "supply_flow_number", f"hole_number * ({share})" if several else share, _place(element.arrangement)
            )
        case Pockets():
            sheet.note(pocket_width=element.width)
            yield from _correction(sheet, "pocket", "pocket_width", _POCKET_CORRECTION)
            yield sheet.line(
                "supply_flow_number",
                f"{_FILM_FACTOR[element.arrangement]} / (ln(1 / {_logarithm(sheet)}) * pocket_correction)",
                _place(element.arrangement),
            )
        case CircumferentialGroove() | HalfCircumferentialGroove():
            sheet.note(groove_width=element.width)
            yield sheet.line("element_ratio", "groove_width / width")
            whole = isinstance(element, CircumferentialGroove)
            remark = "groove around the circumference" if whole else "groove around the unloaded half"
            yield sheet.line("supply_flow_number", _GROOVE_360 if whole else _GROOVE_180, remark)
        case _:
            yield sheet.read("supply_flow_number", "eccentricity_ratio")


def _correction(sheet: Worksheet, kind: str, size: str, expression: str) -> Iterator[Line]:
    """Relative width of the element, and the correction at that width or at the nearest within its range."""
    yield sheet.line("element_ratio", f"{size} / width")
    ratio = sheet["element_ratio"]
    if fitted_width(ratio) == ratio:
        yield sheet.line(f"{kind}_correction", expression.format(s="element_ratio"))
        return
    outside = f"{ratio:.3f} lies outside the range of the correction"
    yield sheet.given("fitted_element_ratio", outside, value=fitted_width(ratio))
    yield sheet.line(f"{kind}_correction", expression.format(s="fitted_element_ratio"))


def _logarithm(sheet: Worksheet) -> str:
    """The relative width in the logarithm, as a name or, where it is limited, as a number."""
    ratio = sheet["element_ratio"]
    return "element_ratio" if logarithm_width(ratio) == ratio else f"{logarithm_width(ratio):g}"


def _place(arrangement: Arrangement) -> str:
    return {
        Arrangement.OPPOSITE: "opposite the load",
        Arrangement.SIDE: "at 90° to the load",
        Arrangement.BOTH_SIDES: "on both sides, ±90° to the load",
    }[arrangement]


def capacity_lines(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    """What the supply can deliver."""
    if "supply_capacity" in sheet:
        yield from _capacity(case, sheet)


def _capacity(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    """What pressure and the journal take from the supply element, or tubes and holes where they pass less."""
    element = case.bearing.supply_element
    if "supply_limit" in sheet:
        yield sheet.given("supply_limit", "tubes and holes pass no more at the whole supply pressure")
        yield sheet.given("supply_capacity", "by pressure and shear, behind tubes and holes that pass it")
        return
    if isinstance(element, CircumferentialGroove):
        yield sheet.line("supply_capacity", "supply_flow", "pressure alone takes oil out of a groove all around")
        return
    if not isinstance(element, Holes | Pockets | HalfCircumferentialGroove):
        return
    of = "groove" if isinstance(element, HalfCircumferentialGroove) else "supply element"
    edge = element.edge_before_load(math.radians(case.bearing.span))
    yield sheet.given("supply_edge_angle", f"from the edge of the {of} before the load to the load", value=edge)
    yield sheet.line(
        "supply_gap", "radial_clearance * (1 - eccentricity_ratio * cos(supply_edge_angle + attitude_angle))"
    )
    fresh = "supply_gap"
    if isinstance(element, Pockets):
        yield from _returned(case, sheet)
        fresh = "(supply_gap - returned_gap)" if sheet["supply_gap"] > sheet["returned_gap"] else "0"
    size = {Pockets: "pocket_width", Holes: "hole_diameter"}.get(type(element), "groove_width")
    side_by_side = isinstance(element, Holes) and element.number != 1.0
    expression = f"hole_number * {size}" if side_by_side else size
    if element.axial_width(case.bearing.width) == case.bearing.width:
        expression = "width"
    yield sheet.line("supply_axial_width", expression)
    sheared = "" if fresh == "0" else f" + surface_speed / 2 * {fresh} * supply_axial_width"
    pressed = "supply_flow"
    if "supply_flow_at_place" in sheet and isinstance(element, Holes | Pockets):
        yield from _flow_at_place(case, element, sheet)
        pressed = "supply_flow_at_place"
    yield sheet.line("supply_capacity", f"{pressed}{sheared}")


def _flow_at_place(case: DesignCase, element: Holes | Pockets, sheet: Worksheet) -> Iterator[Line]:
    """Q_p of elements closer to the load than 90 deg, by the gaps where they stand."""
    before, behind = element.places(math.radians(case.bearing.span))
    yield sheet.given("element_before_load", value=before)
    yield sheet.given("element_behind_load", value=behind)
    if case.oil_supply is not None and (case.oil_supply.tubes or case.oil_supply.holes):
        yield sheet.given("supply_flow_at_place", "with the mean cube of both gaps, behind tubes and holes")
        return
    gaps = (
        "(1 - eccentricity_ratio * cos(element_before_load + attitude_angle))**3",
        "(1 - eccentricity_ratio * cos(element_behind_load - attitude_angle))**3",
    )
    yield sheet.line(
        "supply_flow_at_place", f"supply_flow * ({gaps[0]} + {gaps[1]}) / 2", "mean cube of both gaps"
    )


def _returned(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    """The film that comes back to a pocket: what enters the loaded film less what that loses at its sides."""
    start = start_of_film(math.radians(case.bearing.span), sheet["attitude_angle"])
    where = "edge of the arc" if start == math.radians(case.bearing.span) / 2.0 else "widest gap"
    yield sheet.given("film_start_angle", f"from the {where} to the load", value=start)
    yield sheet.line(
        "film_start_gap", "radial_clearance * (1 - eccentricity_ratio * cos(film_start_angle + attitude_angle))"
    )
    left = "film_start_gap - 2 * side_flow / (surface_speed * width)"
    remark = "film that comes back to the pocket"
    if returned_gap_of(case, sheet) > 0.0:
        yield sheet.line("returned_gap", left, remark)
    else:
        yield sheet.given("returned_gap", remark, value=0.0)


def returned_gap_of(case: DesignCase, sheet: Worksheet) -> float:
    """Thickness in m of the film that comes back, by the numbers of the sheet."""
    return returned_gap(
        case,
        sheet["eccentricity_ratio"],
        sheet["attitude_angle"],
        sheet["operating_relative_clearance"],
        sheet["side_flow"],
    )


def loss_lines(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    """Velocity, friction factor and pressure loss of each duct, and what is left at the element."""
    oil = case.oil_supply
    if oil is None or not (oil.tubes or oil.holes) or "element_pressure" not in sheet:
        return
    sheet.note(
        duct_flow=sheet["supply_limit"] if "supply_limit" in sheet else sheet["total_flow"],
        inlet_density=case.lubricant.density(oil.temperature),
        inlet_kinematic_viscosity=case.lubricant.kinematic_viscosity(oil.temperature),
    )
    for kind, ducts in (("tube", oil.tubes), ("hole", oil.holes)):
        for place, duct in enumerate(ducts, start=1):
            label = f"{kind} {place}" if len(ducts) > 1 else kind
            yield from _duct(duct, label, sheet)
    yield sheet.line("element_pressure", "supply_pressure - tube_loss - hole_loss")


def _duct(duct: Duct, label: str, sheet: Worksheet) -> Iterator[Line]:
    for name in ("duct_velocity", "duct_reynolds_number", "duct_friction", "duct_loss"):
        sheet.numbers.pop(name, None)
    sheet.note(
        duct_number=duct.number,
        duct_diameter=duct.diameter,
        duct_length=duct.length,
        duct_coefficient=duct.loss_coefficient,
    )
    parallel = "duct_number * " if duct.number != 1.0 else ""
    yield sheet.line("duct_velocity", f"4 * duct_flow / ({parallel}pi * duct_diameter**2)", label)
    yield sheet.line("duct_reynolds_number", "duct_velocity * duct_diameter / inlet_kinematic_viscosity")
    reynolds = sheet["duct_reynolds_number"]
    if reynolds <= LAMINAR_UP_TO:
        yield sheet.line("duct_friction", "64 / duct_reynolds_number", "laminar")
    elif reynolds >= TURBULENT_FROM:
        yield sheet.line("duct_friction", "0.3164 / duct_reynolds_number**(1 / 4)", "turbulent, smooth (Blasius)")
    else:
        yield sheet.given(
            "duct_friction", "between laminar and turbulent, blended", value=pipe_friction_factor(reynolds)
        )
    yield sheet.line(
        "duct_loss",
        "(duct_friction * duct_length / duct_diameter + duct_coefficient) * inlet_density * duct_velocity**2 / 2",
    )
