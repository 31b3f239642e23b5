"""Clearance of a bearing at 20 °C, in the six ways a drawing or a designer states it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, TypeAdapter, ValidationError

from babbitt.case.part import Issue, Part, refused, rule
from babbitt.case.parts.fields import Name
from babbitt.case.shorthand import Shorthand
from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, bare_number, read, si, written
from babbitt.properties.fits import (
    Clearance,
    Deviations,
    SizeLimits,
    require_hole,
    require_shaft,
    tolerance_limits,
)

RelativeValue = Annotated[float, si("1", "0.01 permille", "50 permille")]
RadialValue = Annotated[float, si("m", "0.05 um", "500 mm", sample="60 um")]
DiametralValue = Annotated[float, si("m", "0.1 um", "1 m", sample="0.13 mm")]
Size = Annotated[float, si("m", "1 mm", "3 m")]
Deviation = Annotated[float, si("m", "-10 mm", "10 mm")]


class _MeanAndLimits(Part):
    """Mean clearance, and its limits where they are known."""

    mean: float
    minimum: float | None
    maximum: float | None

    @property
    def has_limits(self) -> bool:
        """Whether minimum and maximum are known."""
        return self.minimum is not None and self.maximum is not None

    @rule
    def _limits_in_order(self) -> Iterator[Issue]:
        if (self.minimum is None) != (self.maximum is None):
            missing = "minimum" if self.minimum is None else "maximum"
            yield Issue((missing,), "is missing", "both limits or none", code="E003")
        allowed, hint = "minimum <= mean <= maximum", "to vary the mean beyond its limits, leave both limits out"
        if self.minimum is not None and self.minimum > self.mean:
            yield Issue(("minimum",), "the minimum clearance is above the mean", allowed, hint)
        if self.maximum is not None and self.maximum < self.mean:
            yield Issue(("maximum",), "the maximum clearance is below the mean", allowed, hint)

    def _scaled(self, factor: float) -> Clearance:
        limits = (self.minimum, self.maximum)
        minimum, maximum = (self.mean if limit is None else limit for limit in limits)
        return Clearance(minimum * factor, self.mean * factor, maximum * factor)


class RelativeClearance(_MeanAndLimits):
    """Diametral clearance over diameter."""

    kind: Literal["relative"] = Field(description="Clearance over diameter, psi = C/D.")
    mean: RelativeValue = Field(description="Mean relative clearance. Usual 0.5 to 3 permille.")
    minimum: RelativeValue | None = Field(None, description="Smallest relative clearance of the tolerances.")
    maximum: RelativeValue | None = Field(None, description="Largest relative clearance of the tolerances.")

    def at_20_degrees(self, diameter: float) -> Clearance:
        """Give the diametral clearance."""
        return self._scaled(diameter)


class RadialClearance(_MeanAndLimits):
    """Radius of the bore minus that of the journal."""

    kind: Literal["radial"] = Field(description="Clearance on the radius, C/2.")
    mean: RadialValue = Field(description="Mean radial clearance.")
    minimum: RadialValue | None = Field(None, description="Smallest radial clearance of the tolerances.")
    maximum: RadialValue | None = Field(None, description="Largest radial clearance of the tolerances.")

    def at_20_degrees(self, diameter: float) -> Clearance:
        """Give the diametral clearance."""
        return self._scaled(2.0)


class DiametralClearance(_MeanAndLimits):
    """Bore minus journal diameter."""

    kind: Literal["diametral"] = Field(description="Clearance on the diameter, C.")
    mean: DiametralValue = Field(description="Mean diametral clearance.")
    minimum: DiametralValue | None = Field(None, description="Smallest diametral clearance of the tolerances.")
    maximum: DiametralValue | None = Field(None, description="Largest diametral clearance of the tolerances.")

    def at_20_degrees(self, diameter: float) -> Clearance:
        """Give the diametral clearance."""
        return self._scaled(1.0)


class FitClearance(Part):
    """ISO 286 tolerance classes."""

    kind: Literal["fit"] = Field(description="From ISO 286 tolerance classes about the diameter.")
    bore: Name = Field(description="Tolerance class of the bore, such as H7.")
    journal: Name = Field(description="Tolerance class of the journal, such as d8.")

    @rule
    def _classes_included(self) -> Iterator[Issue]:
        of_bore = [*refused(("bore",), lambda: require_hole(self.bore))]  # the wrong way round is one mistake
        yield from of_bore or refused(("journal",), lambda: require_shaft(self.journal))

    @property
    def has_limits(self) -> bool:
        """Tolerances always give limits."""
        return True

    def at_20_degrees(self, diameter: float) -> Clearance:
        """Give the diametral clearance."""
        return Clearance.from_tolerance_classes(diameter, self.bore, self.journal)


class _TwoSizes(Part):
    """Bore and journal, each as smallest and largest value."""

    bore: tuple[float, float]
    journal: tuple[float, float]

    @property
    def has_limits(self) -> bool:
        """Tolerances always give limits."""
        return True

    @rule
    def _bore_in_order(self) -> Iterator[Issue]:
        yield from _in_order("bore", self.bore)

    @rule
    def _journal_in_order(self) -> Iterator[Issue]:
        yield from _in_order("journal", self.journal)


class LimitsClearance(_TwoSizes):
    """Limits of size as they stand on the drawing."""

    kind: Literal["limits"] = Field(description="From the limits of size of bore and journal.")
    bore: tuple[Size, Size] = Field(description="Smallest and largest diameter of the bore.")
    journal: tuple[Size, Size] = Field(description="Smallest and largest diameter of the journal.")

    def at_20_degrees(self, diameter: float) -> Clearance:
        """Give the diametral clearance."""
        return Clearance.from_sizes(SizeLimits(*self.bore), SizeLimits(*self.journal))


class DeviationsClearance(_TwoSizes):
    """Deviations from the diameter as they stand on the drawing."""

    kind: Literal["deviations"] = Field(description="From the deviations of bore and journal from the diameter.")
    bore: tuple[Deviation, Deviation] = Field(description="Lower and upper deviation of the bore.")
    journal: tuple[Deviation, Deviation] = Field(description="Lower and upper deviation of the journal.")

    def at_20_degrees(self, diameter: float) -> Clearance:
        """Give the diametral clearance."""
        return Clearance.from_deviations(diameter, Deviations(*self.bore), Deviations(*self.journal))


CLEARANCE_KINDS = ("radial", "diametral", "relative", "fit", "limits", "deviations")


def is_bare(given: Any) -> bool:
    """Whether a clearance was written as one value, which does not say on what it is."""
    return isinstance(given, int | float | str) and not isinstance(given, bool) and "/" not in str(given)


_READINGS = (
    ("m", "on the radius or on the diameter", ("radial", "diametral")),
    ("1", "over the diameter", ("relative",)),
)
"""Unit of a bare value, what it may be the clearance on, and the kinds that say so."""


def _of_what(given: Any) -> tuple[str, str] | None:
    """What a bare value may be the clearance on, and how to write that; None if it is no value."""
    if bare_number(given) is not None:
        return "on the radius, on the diameter or over it", "{kind: radial, mean: 30 um}, with the unit"
    for unit, of, kinds in _READINGS:
        try:
            read(given, unit)
        except QuantityError:
            continue
        return of, ", or ".join(f"{{kind: {kind}, mean: {str(given).strip()}}}" for kind in kinds)
    return None


def _fit(given: Any) -> Any:
    if is_bare(given) and (meant := _of_what(given)) is not None:
        what, forms = meant
        says = f"'{str(given).strip()[:40]}' does not say that it is the clearance {what}"
        allowed = f"a fit such as H7/e8, or a mapping with kind: {', '.join(CLEARANCE_KINDS)}"
        raise QuantityError(says, allowed, f"write {forms}")
    bore, stroke, journal = given.partition("/") if isinstance(given, str) else ("", "", "")
    return {"kind": "fit", "bore": bore.strip(), "journal": journal.strip()} if stroke else given


ClearanceInput = Annotated[
    RelativeClearance
    | RadialClearance
    | DiametralClearance
    | FitClearance
    | LimitsClearance
    | DeviationsClearance,
    Discriminator("kind"),
    Shorthand(_fit, "an ISO 286 fit such as H7/e8"),
]


_STATED = {"radial": ("um", 0.5), "diametral": ("um", 1.0), "relative": ("permille", None)}
"""Kinds that state a gap by its values, with their unit and what of the diametral clearance they state."""


def restated(given: Any, kind: str, diameter: Any) -> Any:
    """The clearance of a case as another kind, of the same gap.

    Parameters
    ----------
    given, diameter : object
        As they stand in the case.
    kind : str
        One of ``CLEARANCE_KINDS``; empty for a fit in short.

    Returns
    -------
    dict or str
        The kind alone where the clearance or a diameter that it needs cannot be read, and where the clearance does
        not tell: classes only where it is given by them, sizes only where it is given by tolerances.

    Examples
    --------
    >>> restated({"kind": "relative", "mean": "1.5 permille"}, "radial", "120 mm")
    {'kind': 'radial', 'mean': '90 um'}
    >>> restated({"kind": "radial", "mean": "60 um"}, "diametral", "12")  # a diameter that is half written
    {'kind': 'diametral', 'mean': '120 um'}
    >>> restated("H7/e8", "deviations", "120 mm")
    {'kind': 'deviations', 'bore': ['0 um', '35 um'], 'journal': ['-126 um', '-72 um']}
    """
    try:
        clearance: ClearanceInput = TypeAdapter[ClearanceInput](ClearanceInput).validate_python(given)
        stated = _stated(clearance, kind, _length(diameter))
    except (ValidationError, InputError):
        stated = None
    if stated is None:
        return {"kind": kind} if kind else ""
    return {"kind": kind} | stated if kind else stated


def _length(diameter: Any) -> float:
    """A diameter in m; no number of one that is not given or half written, without which some kinds tell too."""
    try:
        return math.nan if diameter is None else read(diameter, "m")
    except QuantityError:
        return math.nan


def _stated(clearance: ClearanceInput, kind: str, size: float) -> Any:
    """What a clearance is as another kind, at a diameter in m, NaN if unknown; None where it does not tell."""
    if kind in _STATED:
        unit, share = _STATED[kind]
        gap, factor = clearance.at_20_degrees(size), 1.0 / size if share is None else share
        if math.isnan(factor * gap.mean):
            return None
        values = {"mean": gap.mean}
        if clearance.has_limits:
            values |= {"minimum": gap.minimum, "maximum": gap.maximum}
        return {name: _exact(factor * value, unit) for name, value in values.items()}
    if isinstance(clearance, FitClearance) and kind in ("", "fit"):
        bore, journal = clearance.bore, clearance.journal
        return {"bore": bore, "journal": journal} if kind else f"{bore}/{journal}"
    if kind not in ("limits", "deviations") or math.isnan(size) or (both := _sizes(clearance, size)) is None:
        return None
    less, unit = (0.0, "mm") if kind == "limits" else (size, "um")
    return {
        name: [_exact(one - less, unit) for one in (part.minimum, part.maximum)]
        for name, part in zip(("bore", "journal"), both, strict=True)
    }


def _exact(value: float, unit: str) -> str:
    """An SI value in a unit with six decimals, so that the way back leads to where it began."""
    factor = {"um": 1e6, "mm": 1e3, "permille": 1e3}[unit]
    return f"{round(factor * value, 6) + 0.0:.12g} {unit}"  # a difference of sizes that is round-off is 0, not -0


def _sizes(clearance: ClearanceInput, diameter: float) -> tuple[SizeLimits, SizeLimits] | None:
    """Limits of size of bore and journal, m; None of a clearance that is not given by them."""
    match clearance:
        case LimitsClearance():
            return SizeLimits(*clearance.bore), SizeLimits(*clearance.journal)
        case DeviationsClearance():
            return (
                Deviations(*clearance.bore).limits(diameter), Deviations(*clearance.journal).limits(diameter)
            )  # fmt: skip
        case FitClearance():
            classes = (clearance.bore, clearance.journal)
            bore, journal = (tolerance_limits(one, diameter).limits(diameter) for one in classes)
            return bore, journal
    return None


FAR_FROM_THE_MEAN = 1.05
"""Factor between the mean clearance and a limit from which films are questioned that are solved at the mean alone.

Assumption: the load number goes with the square of the clearance, and differs there by a tenth. At 1.2 the least
clearance of bearings near their limits was 5 to 16 K hotter than the mean; of H7/d8, 1.37 at 120 mm, it misses
limits of the temperature that the mean keeps; a critical mass goes with 1.05 of the clearance by 5 %."""


def has_far_limits(least: float, mean: float, most: float) -> bool:
    """Whether a limit of a clearance is far from its mean."""
    return mean > FAR_FROM_THE_MEAN * least or most > FAR_FROM_THE_MEAN * mean


LIMITS = ("clearance.minimum", "clearance.maximum")
"""Fields that a bearing does not read that is computed at one clearance."""


def mean_radial(clearance: ClearanceInput, diameter: float) -> float:
    """Mean radial clearance, m, of a bearing that is computed at one clearance."""
    return 0.5 * clearance.at_20_degrees(diameter).mean


def mean_assumed(clearance: ClearanceInput, diameter: float) -> Iterator[str]:
    """Report the assumption of a bearing that is computed at one clearance and given by its tolerances."""
    if isinstance(clearance, FitClearance | LimitsClearance | DeviationsClearance):
        mean = f"{1e6 * mean_radial(clearance, diameter):.4g} µm"
        yield f"Radial clearance {mean}, the mean of its tolerances; their limits are not computed."


def issues_of(clearance: ClearanceInput, diameter: float) -> Iterator[Issue]:
    """Complain about a clearance that does not suit the diameter of its bearing."""
    if isinstance(clearance, LimitsClearance):
        for name, sizes in (("bore", clearance.bore), ("journal", clearance.journal)):
            if not all(0.95 * diameter <= size <= 1.05 * diameter for size in sizes):
                given = " to ".join(written(size, "mm") for size in sizes)
                says = f"{name} {given} does not belong to the diameter {written(diameter, 'mm')}"
                yield Issue(("clearance", name), says, "sizes within 5 % of the diameter")
                return
    yield from refused(("clearance",), lambda: clearance.at_20_degrees(diameter).relative(diameter))


def _in_order(name: str, limits: tuple[float, float]) -> Iterator[Issue]:
    if limits[0] > limits[1]:
        yield Issue(
            (name,), f"the lower limit of the {name} is above the upper", "[lower, upper]", "exchange them"
        )
