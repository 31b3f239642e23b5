"""Which fields of a case vary in a study, and how a value of one gets into the case."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.case.named_files import NamedFiles, TableError
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.variation import variation_of
from babbitt.core.files.spreadsheet import read_rows
from babbitt.core.notices import InputError
from babbitt.core.units import KINDS, SiNumber
from babbitt.core.units.kinds import kind_of
from babbitt.properties.fits import Clearance, tolerance_limits
from babbitt.properties.lubricants import Lubricant, viscosity_index
from babbitt.study.fields import (
    NUMERIC_FORMS,
    FieldReader,
    annotations_of,
    meaning_of,
    numeric_field,
    part_in,
    path_in,
    refused,
)
from babbitt.study.laws import CUT, Choices, Difference, HalfNormal, Law, Listed, Normal, Triangular, Uniform
from babbitt.study.shares import EVERYWHERE, SHARED, places_of, require_buildable, share_of

__all__ = ["CASES", "Input", "inputs_of"]

CASES = "clearance_cases"
"""Field of kinds that compute all clearances by themselves."""

FEW = 3
"""Places of a quantity that is varied everywhere, which are named one by one."""

VG_SCATTER = 0.1
"""Share by which nu40 may differ from that of its viscosity grade (ISO 3448)."""


LARGEST_TABLE = 20_000_000
"""Bytes of a table of samples."""


@dataclass(frozen=True, eq=False)
class Input:
    """A field that varies.

    Attributes
    ----------
    path : str
        As the study names it; the name of its column, too.
    field : str
        The same in words of the case, bearings by their number.
    law : Law or Choices
    unit : str
        In SI; empty for numbers without unit and for words.
    meaning : str
    reason : str
        Where the distribution comes from, or that it is assumed.
    table : str
        File whose rows the law has in common with other fields; empty where it stands alone.
    form : str
        What a value of the column is: ``quantity``, ``number``, ``choice``, ``clearance`` (on the diameter),
        ``viscosity`` (nu40 of the oil) or ``share`` (of what the case has in several fields).
    given : mapping
        By the word of a choice, what stands in the case for it; of an oil, its data but nu40; of a share, by the
        path of each field what the case has there, in SI; of a clearance, by its path each field that goes with
        it.
    """

    path: str
    field: str
    law: Law | Choices
    unit: str = ""
    meaning: str = ""
    reason: str = ""
    table: str = ""
    form: str = "quantity"
    given: Mapping[str, Any] | None = None

    @property
    def is_choice(self) -> bool:
        """Whether its values are words."""
        return isinstance(self.law, Choices)

    def drawn(self, share: NDArray[np.float64]) -> NDArray[Any]:
        """Values at shares of the distribution, shape (n,): SI numbers, or words."""
        return self.law.chosen(share) if isinstance(self.law, Choices) else self.law.quantiles(share)

    @property
    def listed(self) -> NDArray[Any]:
        """The values of a list in its order.

        Raises
        ------
        InputError
            E003 for a continuous distribution.
        """
        if isinstance(self.law, Listed | Choices):
            return np.array(self.law.values, object if self.is_choice else float)
        says = f"a grid needs values, and this is a distribution ({self.law.words})"
        raise refused(self.path, f"{says}; give a list, range or log_range, or ask for kind: tolerance")

    def places(self, value: Any) -> Iterator[tuple[str, Any]]:
        """Every field that a value of the column sets, and what stands in it."""
        if self.form == "share":
            yield from ((field, share_of(one, float(value))) for field, one in (self.given or {}).items())
        else:
            yield self.field, self.in_case(value)
            if self.form == "clearance":
                yield from (self.given or {}).items()

    def in_case(self, value: Any) -> Any:
        """What stands in the case for a value of the column."""
        known = self.given or {}
        match self.form:
            case "choice":
                return known[str(value)]
            case "clearance":
                return {"kind": "diametral", "mean": SiNumber(value)}
            case "viscosity":
                return {**known, "nu40": SiNumber(value)}
            case "number":
                return float(value)
            case "whole":
                return round(float(value))
        return SiNumber(value)


def inputs_of(case: CaseFile, block: StudyBlock) -> tuple[Input, ...]:
    """The fields that vary in a study, with their distributions.

    Raises
    ------
    InputError
        For a path that leads to no field, a value that is none of the field, an empty range, or a distribution
        that reaches beyond what the field takes.
    """
    found = tuple(_input(case, path, given) for path, given in block.vary.items())
    for one, given in zip(found, block.vary.values(), strict=True):
        _require_possible(case, one, given)
    return found


def _input(case: CaseFile, path: str, given: Vary) -> Input:
    if path.startswith(EVERYWHERE):
        return _share(case, path, given)
    field = path_in(case, path)
    annotations = annotations_of(case, path)
    meaning = meaning_of(case, path, field)
    if given.fit is not None:
        return _fit(case, path, field, given, meaning)
    if given.scatter is not None:
        return _oil(case, path, field)
    form, quantity = numeric_field(annotations)
    if not form:
        return _choices(path, field, given, meaning)
    unit = quantity.unit if quantity is not None else "1"
    law, reason = _law(case, path, given, unit)
    shown = "" if unit == "1" else KINDS[unit].unit
    return Input(path, field, law, shown, meaning, reason, given.table or "", form)


def _share(case: CaseFile, path: str, given: Vary) -> Input:
    """A quantity in all places where the case gives it, by its share of what stands there."""
    name = path.removeprefix(EVERYWHERE)
    there = ", ".join(f"{EVERYWHERE}{one}" for one in SHARED)
    if name not in SHARED:
        raise refused(path, f"names nothing that is varied everywhere; there are: {there}")
    places = places_of(case, name)
    if not places:
        raise refused(path, f"the case gives no {' or '.join(SHARED[name])}")
    law, reason = _law(case, path, given, "1")
    where = ", ".join(places) if len(places) <= FEW else f"{name} in {len(places)} places"
    meaning = f"Share of {where} of the case"
    return Input(path, path, law, "", meaning, reason, given.table or "", "share", places)


def _law(case: CaseFile, path: str, given: Vary, unit: str) -> tuple[Law, str]:
    """The distribution of a quantity, and its reason."""
    number = FieldReader(path, unit)
    stated = "stated in the study"
    if given.values is not None:
        return Listed(tuple(number(one) for one in given.values)), stated
    if given.range is not None or given.log_range is not None:
        return _spaced(number, given), stated
    if given.uniform is not None:
        low, high = (number(one) for one in given.uniform)
        _require_order(path, "uniform", given.uniform, low < high)
        return Uniform(low, high), stated
    if given.triangular is not None:
        low, likely, high = (number(one) for one in given.triangular)
        _require_order(path, "triangular", given.triangular, low <= likely <= high and low < high)
        return Triangular(low, likely, high), stated
    cut = CUT if given.truncated is None else given.truncated
    if given.normal is not None:
        mean, deviation = number(given.normal[0]), number.difference(given.normal[1])
        _require_order(path, "normal", given.normal, deviation > 0.0, "a standard deviation above zero")
        return Normal(mean, deviation, cut), stated
    if given.half_normal is not None:
        deviation = number.difference(given.half_normal)
        _require_order(path, "half_normal", (given.half_normal,), deviation > 0.0, "a deviation above zero")
        return HalfNormal(deviation, cut), stated
    assert given.table is not None, "the model asks for one law"
    return Listed(_column(case, path, given.table, number)), f"samples in {given.table}"


def _spaced(number: FieldReader, given: Vary) -> Listed:
    """Values in equal steps, or in equal ratios."""
    logarithmic = given.log_range is not None
    first_given, last_given, count = given.log_range or given.range or ("", "", 0)
    first, last = number(first_given), number(last_given)
    name = "log_range" if logarithmic else "range"
    if first == last:
        raise refused(number.path, f"{name} [{first_given}, {last_given}] is empty: both ends are the same")
    if logarithmic and not first * last > 0.0:
        raise refused(number.path, f"log_range [{first_given}, {last_given}] needs two ends above zero")
    values = np.geomspace(first, last, count) if logarithmic else np.linspace(first, last, count)
    return Listed(tuple(values.tolist()), f"{count} values")


def _choices(path: str, field: str, given: Vary, meaning: str) -> Input:
    """A field that takes words or mappings."""
    if given.values is None:
        law = next(name for name in type(given).model_fields if getattr(given, name) is not None)
        hint = NUMERIC_FORMS.get(field.rpartition(".")[2], "give a list of its values")
        raise refused(path, f"is not numeric, so that '{law}' says nothing of it; {hint}")
    if any(isinstance(one, str | bool | int | float | Mapping) is False for one in given.values):
        raise refused(path, "takes words, numbers or mappings in a list")
    labels = tuple(_label(one) for one in given.values)
    if len(set(labels)) < len(labels):
        raise refused(path, "has a value twice in its list")
    known = dict(zip(labels, given.values, strict=True))
    return Input(path, field, Choices(labels), "", meaning, "stated in the study", "", "choice", known)


def _label(value: Any) -> str:
    if isinstance(value, Mapping):
        parts = [str(one) if key == "kind" else f"{key} {one}" for key, one in value.items()]
        return str(value.get("name") or ", ".join(parts))
    return str(value).lower() if isinstance(value, bool) else str(value)


def _fit(case: CaseFile, path: str, field: str, given: Vary, meaning: str) -> Input:
    """The clearance of a fit: bore and journal each within its ISO 286 zone, independent of each other."""
    if field.rpartition(".")[2] != "clearance":
        raise refused(path, "is no clearance, so that it has no fit; write clearance: {fit: H7/e8}")
    bore, stroke, journal = str(given.fit).partition("/")
    diameter = getattr(part_in(case, field.split(".")[:-1]), "diameter", None)
    if not stroke or diameter is None:
        raise refused(path, f"'{given.fit}' is no fit; write bore and journal class as in H7/e8")
    try:
        Clearance.from_tolerance_classes(diameter, bore.strip(), journal.strip())
        zones = [tolerance_limits(one.strip(), diameter) for one in (bore, journal)]
    except InputError as error:
        raise refused(path, error.message) from None
    laws: list[Normal | Uniform] = []
    for zone in zones:
        if given.law == "uniform":
            laws.append(Uniform(zone.lower, zone.upper))
        else:
            laws.append(Normal(0.5 * (zone.lower + zone.upper), (zone.upper - zone.lower) / (2.0 * CUT)))
    mean = _mean_alone(case, field)
    law = Difference(laws[0], laws[1], f"fit {given.fit}, both sizes {given.law} in their zones")
    reason = "ISO 286 zones; sizes uniform in them (assumption)"
    if given.law == "normal":
        reason = "ISO 286 zones; sizes normal about their middle with the zone ±3σ wide (assumption: Cp = 1)"
    if mean:
        reason += "; clearance_cases: mean, since each row has one clearance"
    return Input(path, field, law, "m", f"{meaning}, on the diameter", reason, "", "clearance", mean)


def _mean_alone(case: CaseFile, field: str) -> dict[str, str]:
    """What lets a bearing whose case asks for all clearances be solved at the one of a row, by its path."""
    way = field.split(".")[:-1]
    asked = getattr(part_in(case, way), CASES, None) or getattr(case, CASES, None)
    return {".".join((*way, CASES)): "mean"} if asked == "all" else {}


def _oil(case: CaseFile, path: str, field: str) -> Input:
    """The scatter of an oil about its viscosity grade: nu40 varies, viscosity index and density stay."""
    part = part_in(case, field.split("."))
    if not hasattr(part, "lubricant"):
        raise refused(path, "is no lubricant, so that it has no viscosity grade; write lubricant: {scatter: vg}")
    found: Lubricant = part.lubricant()
    try:
        nu40, nu100 = (float(found.kinematic_viscosity(kelvin)) for kelvin in (313.15, 373.15))
        index = viscosity_index(nu40, nu100)
    except InputError as error:
        raise refused(path, f"the oil has no viscosity index: {error.message}") from None
    known: dict[str, Any] = {
        "kind": "viscosity_index",
        "name": found.name,
        "viscosity_index": index,
        "density": SiNumber(found.density(288.15)),
        "density_slope": SiNumber((found.density(323.15) - found.density(288.15)) / 35.0),
        "heat_capacity": SiNumber(found.heat_capacity(323.15)),
        "heat_capacity_slope": SiNumber((found.heat_capacity(353.15) - found.heat_capacity(323.15)) / 30.0),
        "conductivity": SiNumber(found.conductivity(323.15)),
    }
    if found.fixed_volumetric_heat_capacity is not None:
        known["volumetric_heat_capacity"] = SiNumber(found.fixed_volumetric_heat_capacity)
    law = Uniform(nu40 * (1.0 - VG_SCATTER), nu40 * (1.0 + VG_SCATTER))
    reason = "ISO 3448: nu40 within ±10 % of the grade; uniform, viscosity index and density fixed (assumptions)"
    meaning = "Kinematic viscosity at 40 °C"
    return Input(path, field, law, "m2/s", meaning, reason, "", "viscosity", known)


def _column(case: CaseFile, path: str, name: str, number: FieldReader) -> tuple[float, ...]:
    """A column of a table of samples, headed by the path of its field and its unit in brackets."""
    origin = case.origin
    assert origin is not None, "only a case that was read is varied"
    example = f"a CSV file with the column '{path} [unit]'"
    try:
        text = NamedFiles(origin.file.parent, origin.reach).text(name, ("vary", path), LARGEST_TABLE, example)
        rows = read_rows(text)
    except (TableError, csv.Error) as error:
        raise refused(path, str(error)) from None
    heads = [head.partition("[")[0].strip() for head in rows[0]] if rows else []
    if path not in heads:
        there = ", ".join(heads) or "none"
        raise refused(path, f"{name} has no column of that name; there are: {there}; write {example}")
    place = heads.index(path)
    unit = rows[0][place].partition("[")[2].rstrip("] ").strip()
    values = [row[place].strip() if place < len(row) else "" for row in rows[1:] if any(map(str.strip, row))]
    found = tuple(number(f"{value} {unit}".strip()) for value in values)
    if not found:
        raise refused(path, f"{name} has no samples")
    return found


def _as_given(value: float, one: Input, given: Vary) -> str:
    """A value in the unit in which the study writes its numbers."""
    numbers = given.uniform or given.normal or given.triangular or given.range or given.log_range or ()
    for text in numbers:
        unit = str(text).strip().partition(" ")[2].strip()
        kind = kind_of(unit) if unit else None
        if kind is not None and one.form == "quantity":
            return f"{kind.from_si(value, unit):.6g} {unit}"
    return f"{value:.6g} {one.unit}".strip()


def _require_possible(case: CaseFile, one: Input, given: Vary) -> None:
    """Refuse a distribution that reaches beyond what the field takes, and a list of which nothing is taken."""
    first = next(iter(one.given or {})) if one.form == "share" else one.field
    variation = variation_of(case, first)
    if isinstance(one.law, Listed | Choices) and not one.table:
        refusals = []
        for value in one.listed:
            try:
                require_buildable(variation, one, value)
                return
            except InputError as error:
                refusals.append(error)
        raise refused(one.path, f"takes none of its values: {refusals[0].message}")
    low, high = one.law.support  # type: ignore[union-attr]
    for value, side in ((low, "smallest"), (high, "largest")):
        try:
            require_buildable(variation, one, value)
        except InputError as error:
            shown = _as_given(value, one, given)
            says = f"the {side} value {shown} of its distribution ({one.law.words}) is not possible"
            raise refused(one.path, f"{says}: {error.message}") from None


def _require_order(path: str, law: str, given: Sequence[Any], holds: bool, allowed: str = "rising values") -> None:
    if not holds:
        raise refused(path, f"{law} [{', '.join(map(str, given))}] is not possible; allowed: {allowed}")
