"""Smallest, mean and largest clearance by cold and hot oil: what varies where nothing is named, and which rows."""

from __future__ import annotations

from collections.abc import Container
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.case.kinds import KINDS
from babbitt.case.loading import build_case
from babbitt.case.named_files import NamedFiles
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.problems import CaseError
from babbitt.core.files.printing import printable
from babbitt.core.notices import InputError
from babbitt.core.units import SiNumber
from babbitt.study.fields import present_quantity
from babbitt.study.inputs import CASES, Input
from babbitt.study.laws import Choices

__all__ = ["CASES", "CORNER_RESULTS", "at_all_clearances", "clearance_input", "default_oil"]

OIL = ("supply.temperature", "cooling.ambient_temperature")
"""What makes the oil cold or hot: the first that the case gives."""

COLDER, HOTTER = 10.0, 10.0
"""K to each side of what the case gives (assumption: how far a cooler and the seasons let it wander)."""

CORNER_RESULTS = (
    "minimum_film_thickness",
    "maximum_temperature",
    "outlet_temperature",
    "effective_temperature",
    "friction_power",
    "total_flow",
    *(f"{what}_{axes}" for what in ("stiffness", "damping") for axes in ("xx", "xy", "yx", "yy")),
    "critical_mass",
    "threshold_speed",
    "log_decrement",
)
"""Kept where no outputs are named, as far as the method gives them."""


def default_oil(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """Corners with cold, given and hot oil, for those that name no fields.

    Raises
    ------
    InputError
        E003 where the case gives no temperature of the oil.
    """
    if block.vary:
        return block
    for path in OIL:
        if (given := present_quantity(case, path)) is not None:
            values = tuple(f"{one!r} K" for one in (given - COLDER, given, given + HOTTER))
            made: StudyBlock = block.model_copy(update={"vary": {path: Vary(values=values)}})
            return made
    says = f"{case.name} gives no {' or '.join(OIL)}, so that no oil is cold or hot"
    raise InputError("E003", f"study.vary: {says}; name fields with their values")


def at_all_clearances(given: dict[str, Any], fields: Container[str]) -> dict[str, Any]:
    """A case with all clearances computed, where its kind knows how; as it stands for others.

    Parameters
    ----------
    given : dict
        What stands in the case.
    fields : container of str
        Of its model.
    """
    if CASES not in fields:
        return given
    made = {**given, CASES: "all"}
    if isinstance(given.get("bearings"), list):
        bearings = given["bearings"]
        made["bearings"] = [{name: value for name, value in one.items() if name != CASES} for one in bearings]
    return made


def _has_limits(bearing: Any) -> bool:
    """Whether a bearing of a machine has a clearance with limits; a support of known stiffness has none."""
    clearance = getattr(bearing, "clearance", None)
    return clearance is not None and bool(clearance.has_limits)


def leaves_out_limits(case: CaseFile) -> bool:
    """Whether a case computes its mean clearance alone, of one that has a smallest and a largest."""
    fields, origin = KINDS[case.kind].model_fields, case.origin
    if CASES not in fields or origin is None:
        return False
    shared = getattr(case, CASES)
    if bearings := getattr(case, "bearings", ()):
        return any(_has_limits(one) and (getattr(one, CASES) or shared) != "all" for one in bearings)
    if shared == "all":
        return False
    files = NamedFiles(origin.file.parent, origin.reach)
    try:
        build_case(at_all_clearances(dict(origin.given), fields), printable(origin.file), files)
    except CaseError:
        return False
    return True


def clearance_input(case: CaseFile) -> Input | None:
    """The clearance as an input of a kind that computes one; None where the kind computes all by itself.

    Raises
    ------
    InputError
        E003 for a clearance without limits.
    """
    fields = KINDS[case.kind].model_fields
    origin = case.origin
    if CASES in fields and origin is not None:
        files = NamedFiles(origin.file.parent, origin.reach)
        build_case(at_all_clearances(dict(origin.given), fields), printable(origin.file), files)
        return None
    clearance, diameter = getattr(case, "clearance", None), getattr(case, "diameter", None)
    if clearance is None or diameter is None or not clearance.has_limits:
        says = f"{case.name} has no clearance with a smallest and a largest value"
        raise InputError("E003", f"study: {says}; give it limits, deviations or a fit such as H7/e8")
    sizes = clearance.at_20_degrees(diameter)
    given = {
        name: {"kind": "diametral", "mean": SiNumber(value)}
        for name, value in (("smallest", sizes.minimum), ("mean", sizes.mean), ("largest", sizes.maximum))
    }
    reason = f"{1e6 * sizes.minimum:.4g} to {1e6 * sizes.maximum:.4g} µm on the diameter, by its tolerances"
    law = Choices(tuple(given))
    return Input("clearance", "clearance", law, "", "Clearance at 20 °C", reason, "", "choice", given)
