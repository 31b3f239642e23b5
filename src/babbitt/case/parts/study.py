"""The `study` block of a case: which fields vary, how, and what is asked.

Quantities stand here as they are written: which unit they want is known once the field that varies is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, exactly_one, is_given, rule
from babbitt.case.parts.fields import Name, WholeNumber
from babbitt.case.shorthand import Shorthand
from babbitt.core.units import si

__all__ = ["LoadCase", "StudyBlock", "StudyKind", "Vary", "VaryInput"]

StudyKind = Literal[
    "sweep", "size", "tolerance", "map", "corners", "sensitivity", "optimise", "design", "spectrum", "table"
]

READ_BY: Mapping[str, tuple[str, ...]] = {
    "samples": ("tolerance", "sensitivity"),
    "sampling": ("tolerance", "sensitivity"),
    "minimise": ("optimise",),
    "maximise": ("optimise",),
    "population": ("optimise",),
    "generations": ("optimise",),
    "load_cases": ("spectrum",),
    "hours_per_year": ("spectrum",),
    "field": ("size",),
    "limits": ("size",),
    "over_tolerance": ("size",),
    "preferred": ("size",),
    "reserve": ("design",),
    "proposals": ("design",),
    "rows": ("table",),
    "points": ("map",),
}
"""Which kinds read a field that not all of them do."""

LAWS = (
    "values",
    "range",
    "log_range",
    "uniform",
    "normal",
    "triangular",
    "half_normal",
    "fit",
    "scatter",
    "table",
)
"""Ways to say which values a field takes; one of them is given."""

SHARES_MISS = 1e-6
"""By which the shares of time may miss 1."""

Scalar = str | float
Share = Annotated[float, si("1", "0", "1")]


class Vary(Part):
    """Values that a field takes: a list, or how they are distributed."""

    values: tuple[Any, ...] | None = Field(
        None, min_length=1, max_length=10_000, description="The values themselves. A list alone will do."
    )
    range: tuple[Scalar, Scalar, Annotated[int, WholeNumber(2, 10_000)]] | None = Field(
        None, description="First value, last value and number of equally spaced values."
    )
    log_range: tuple[Scalar, Scalar, Annotated[int, WholeNumber(2, 10_000)]] | None = Field(
        None, description="First value, last value and number of values in equal ratios."
    )
    uniform: tuple[Scalar, Scalar] | None = Field(
        None, description="Smallest and largest value, all between equally likely."
    )
    normal: tuple[Scalar, Scalar] | None = Field(None, description="Mean and standard deviation.")
    triangular: tuple[Scalar, Scalar, Scalar] | None = Field(
        None, description="Smallest, most likely and largest value."
    )
    half_normal: Scalar | None = Field(
        None, description="One-sided from zero: the standard deviation of the normal law whose magnitude it is."
    )
    fit: Name | None = Field(
        None, description="ISO 286 fit such as H7/e8: bore and journal each within its tolerance zone."
    )
    scatter: Literal["vg"] | None = Field(
        None, description="Of a lubricant: nu40 within +-10 %, as ISO 3448 allows a viscosity grade, uniform."
    )
    table: Name | None = Field(
        None, description="CSV file of samples with one column for the field, such as 'load [kN]'."
    )
    truncated: Annotated[float, si("1", "0.1", "8")] | None = Field(
        None, description="Standard deviations to each side at which a normal law ends. 3 if not given."
    )
    law: Literal["normal", "uniform"] = Field(
        "normal",
        description="Of a fit: how sizes lie in their zone, normal with the zone +-3 standard deviations wide "
        "(assumption: Cp = 1), or uniform.",
    )

    @rule
    def _one_law(self) -> Iterator[Issue]:
        yield from exactly_one(self, *LAWS)

    @rule
    def _options_belong(self) -> Iterator[Issue]:
        if is_given(self, "truncated") and not (is_given(self, "normal") or is_given(self, "half_normal")):
            yield Issue(("truncated",), "belongs to a normal law", "with normal or half_normal", "remove it")
        if is_given(self, "law") and not is_given(self, "fit"):
            yield Issue(("law",), "belongs to a fit", "with fit", "remove it")


def _listed(given: Any) -> Any:
    return {"values": given} if isinstance(given, list | tuple) else given


VaryInput = Annotated[Vary, Shorthand(_listed, "a list of values")]


class LoadCase(Part):
    """One load case of a spectrum."""

    name: Name | None = Field(None, description="How tables call it. Its number if not given.")
    share: Share = Field(description="Share of the time, such as 20 %.")
    set: dict[str, Any] = Field(
        min_length=1, description="Values by the paths of their fields, such as {speed: 1500 rpm}."
    )


class StudyBlock(Part):
    """A study of the case: one question over many variants of it."""

    kind: StudyKind = Field(description="What is asked.")
    vary: dict[str, VaryInput] = Field(
        default={},
        max_length=40,
        description="By the path of a field, such as clearance.mean, the values that it takes.",
    )
    outputs: tuple[Name, ...] = Field(
        (), description="Quantities that are kept. The key results of the method if not given."
    )
    samples: Annotated[float, si("1", "1", "1e18")] | None = Field(
        None, description="Samples of a tolerance (1000 if not given), base samples of a sensitivity (256)."
    )
    sampling: Literal["latin_hypercube", "sobol", "random"] = Field(
        "latin_hypercube", description="How joint samples are drawn."
    )
    seed: Annotated[int, WholeNumber(0, 2**31 - 1)] = Field(
        0, description="Of the random numbers; the same seed gives the same samples."
    )
    minimise: tuple[Name, ...] = Field((), description="Of an optimisation: quantities that are to be small.")
    maximise: tuple[Name, ...] = Field((), description="Of an optimisation: quantities that are to be large.")
    population: Annotated[int, WholeNumber(4, 1000)] = Field(
        24, description="Of an optimisation: designs in a generation."
    )
    generations: Annotated[int, WholeNumber(1, 10_000)] = Field(
        20, description="Of an optimisation: generations that are computed."
    )
    rows: Name | None = Field(
        None,
        description="Of a table: CSV file or workbook with a bearing in each row, its columns headed by paths of "
        "fields with their units, such as 'diameter [mm]'.",
    )
    load_cases: tuple[LoadCase, ...] = Field(
        (), description="Of a spectrum: load cases with their shares of time."
    )
    hours_per_year: Annotated[float, si("1", "1", "8784")] = Field(
        8760.0, description="Of a spectrum: hours of operation that the yearly energy counts."
    )

    field: Name | None = Field(
        None,
        description="Of a size without vary: the field that is sought, a decade to each side of what the case "
        "has, or among its usual choices.",
    )
    limits: tuple[Name, ...] = Field(
        ("all",),
        min_length=1,
        description="Of a size: all, recommended (recommendations count too), or codes of the checks that count.",
    )
    over_tolerance: bool = Field(
        False, description="Of a size: whether limits hold at the smallest, mean and largest clearance."
    )
    preferred: bool = Field(
        False, description="Of a size: also try the preferred numbers (R20 of ISO 3) that lie within."
    )
    reserve: Annotated[float, si("1", "0", "1")] = Field(
        0.1,
        description="Of a design: margin to every limit from which proposals are ranked by their friction power.",
    )
    proposals: Annotated[int, WholeNumber(1, 50)] = Field(5, description="Of a design: proposals that are made.")

    points: Annotated[int, WholeNumber(2, 1000)] = Field(
        19, description="Of a map that names no fields: values along each axis."
    )

    @rule
    def _is_read(self) -> Iterator[Issue]:
        for name, kinds in READ_BY.items():
            if is_given(self, name) and self.kind not in kinds:
                says = f"is not read by a study of kind {self.kind}"
                yield Issue((name,), says, f"kind: {' or '.join(kinds)}", "remove it")

    @rule
    def _has_something_to_vary(self) -> Iterator[Issue]:
        if self.kind not in ("map", "corners", "spectrum", "size", "design", "table") and not self.vary:
            says = f"names no field, and a study of kind {self.kind} varies at least one"
            yield Issue(("vary",), says, "paths of fields with their values", code="E003")
        if self.kind == "map" and self.vary and len(self.vary) != 2:
            says = f"names {len(self.vary)} field{'s' * (len(self.vary) != 1)}, and a map has two axes"
            yield Issue(("vary",), says, "two fields, or none for those of the kind, speed and load of most")
        if is_given(self, "points") and self.vary:
            yield Issue(
                ("points",), "belongs to a map that names no fields", "kind: map without vary", "remove it"
            )
        if self.kind == "size" and len(self.vary) + is_given(self, "field") != 1:
            says = f"names {len(self.vary) + is_given(self, 'field')} fields, and a size is sought of one"
            yield Issue(("vary",), says, "one field with its values, or field: load", code="E003")

    @rule
    def _rows_of_table(self) -> Iterator[Issue]:
        if self.kind != "table":
            return
        if self.rows is None:
            yield Issue(("rows",), "is missing", "a CSV file or workbook with a bearing in each row", code="E003")
        if self.vary:
            yield Issue(("vary",), "is not read by a study of kind table", "columns of the table", "remove it")

    @rule
    def _objectives(self) -> Iterator[Issue]:
        if self.kind == "optimise" and not (self.minimise or self.maximise):
            says = "an optimisation needs an objective"
            yield Issue(("minimise",), says, "minimise or maximise with quantities", lacks=())
        for name in (name for name in self.maximise if name in self.minimise):
            says = f"'{name}' stands under minimise, too: the two contradict each other"
            yield Issue(("maximise",), says, "each quantity once")

    @rule
    def _spectrum(self) -> Iterator[Issue]:
        if self.kind != "spectrum":
            return
        if not self.load_cases:
            yield Issue(("load_cases",), "is missing", "a list of load cases", code="E003")
            return
        total = sum(one.share for one in self.load_cases)
        if abs(total - 1.0) > SHARES_MISS:
            yield Issue(("load_cases",), f"the shares sum up to {total:.6g}", "shares that sum up to 1")
        names = Counter(one.name for one in self.load_cases if one.name)
        for name in (name for name, count in names.items() if count > 1):
            yield Issue(("load_cases",), f"two load cases are called '{name}'", "each name once")

    @rule
    def _samples_are_drawn(self) -> Iterator[Issue]:
        if self.kind == "sensitivity" and is_given(self, "sampling") and self.sampling != "sobol":
            says = "a sensitivity draws its samples by Saltelli's scheme on a Sobol sequence"
            yield Issue(("sampling",), says, "sobol", "remove it")
        if self.samples is not None and not float(self.samples).is_integer():
            yield Issue(("samples",), f"{self.samples:g} is no whole number", "a whole number")
