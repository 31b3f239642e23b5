"""Fields of a case by their paths: what they mean, which quantity they take, what the case has in them."""

from __future__ import annotations

import typing
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from babbitt.case.aliases import in_todays_words
from babbitt.case.case_file import CaseFile
from babbitt.case.error_messages import listed
from babbitt.case.field_types import attributes_of_field, field_annotations, names_within, quantity_in
from babbitt.case.part import Part
from babbitt.case.parts.fields import WholeNumber
from babbitt.case.suggestions import near_typo
from babbitt.case.variation import variation_of
from babbitt.core.notices import InputError
from babbitt.core.units import KINDS, QuantityError, SiField, read
from babbitt.core.units.kinds import Kind
from babbitt.study.shares import EVERYWHERE

__all__ = [
    "NUMERIC_FORMS",
    "FieldReader",
    "annotations_of",
    "given_in",
    "meaning_of",
    "metadata_in",
    "model_of",
    "numbers_of",
    "numeric_field",
    "part_in",
    "path_in",
    "present_quantity",
    "refused",
    "types_at",
    "unknown_field",
]

NUMERIC_FORMS = {
    "clearance": "vary clearance.mean, or give {fit: H7/e8}",
    "lubricant": "give a list of oils, or {scatter: vg}",
}
"""What to write where a field that holds several values is asked to be distributed."""


def path_in(case: CaseFile, path: str) -> str:
    """A path with bearings by their number, where it names one: ``bearings.Pinion.load``."""
    origin = case.origin
    bearings = origin.given.get("bearings") if origin is not None else None
    if not path.startswith("bearings.") or not isinstance(bearings, list):
        return path
    rest = path.removeprefix("bearings.")
    names = {str(one.get("name")): place for place, one in enumerate(bearings) if isinstance(one, Mapping)}
    for name in sorted(names, key=len, reverse=True):
        if rest.startswith(f"{name}."):
            return f"bearings.{names[name]}.{rest.removeprefix(f'{name}.')}"
    return path


def numbers_of(case: CaseFile, path: str) -> tuple[Callable[[Any], float], Kind]:
    """What reads the numbers of a field, as a case file has them, into SI, and what kind of quantity they are.

    Raises
    ------
    InputError
        For a path that leads to no field, or to one that takes no quantity.
    """
    if path.startswith(EVERYWHERE):
        return FieldReader(path, "1"), KINDS["1"]
    _, quantity = numeric_field(annotations_of(case, path))
    if quantity is None:
        hint = NUMERIC_FORMS.get(path.rpartition(".")[2], "give a list of its values")
        raise refused(path, f"takes no quantity, such as a load; {hint}")
    return FieldReader(path, quantity.unit), quantity.kind


def present_quantity(case: CaseFile, path: str) -> float | None:
    """What a case has in a field, in SI, of a share all of it; None where it has nothing, or no quantity."""
    if path.startswith(EVERYWHERE):
        return 1.0
    try:
        _, quantity = numeric_field(annotations_of(case, path))
        given = variation_of(case, path_in(case, path)).present
        return None if quantity is None or given is None else read(given, quantity.unit)
    except (InputError, QuantityError):
        return None


def annotations_of(case: CaseFile, path: str) -> tuple[Any, ...]:
    """Types of a field; raises InputError for a path that leads to none."""
    found = types_at(case, path)
    if not found:
        raise refused(path, unknown_field(case, path_in(case, path)))
    return found


def types_at(case: CaseFile, path: str) -> tuple[Any, ...]:
    """Types of a field, of a part of several kinds those of the kind that the case has; empty for no field."""
    return field_annotations(model_of(case), path_in(case, path).split("."), given_in(case))


def given_in(case: CaseFile) -> Any:
    """What stands in a case, in words of today."""
    given = getattr(case, "given", None) if case.origin is None else case.origin.given
    return in_todays_words(model_of(case), given)


def numeric_field(annotations: Sequence[Any]) -> tuple[str, SiField | None]:
    """Whether a field takes a ``quantity`` or ``whole`` numbers, or neither (empty), and which quantity."""
    quantity = next((one for one in map(quantity_in, annotations) if isinstance(one, SiField)), None)
    whole = any(isinstance(one, WholeNumber) for annotation in annotations for one in metadata_in(annotation))
    return ("quantity" if quantity is not None else "whole" if whole else ""), quantity


def meaning_of(case: CaseFile, path: str, field: str) -> str:
    """What a field means, in words."""
    return attributes_of_field(model_of(case), field.split("."), given_in(case)).get("long_name", path)


def unknown_field(case: CaseFile, field: str) -> str:
    """Say how far a path leads, and what is near."""
    steps = field.split(".")
    if not all(steps):
        return "names no field; write it as load, or clearance.mean"
    known, given = 0, given_in(case)
    while known < len(steps) and field_annotations(model_of(case), steps[: known + 1], given):
        known += 1
    name = steps[known]
    names = _names_at(case, steps[:known])
    meant = near_typo(name, names)
    where = f" of {'.'.join(steps[:known])}" if known else ""
    hint = (
        f"did you mean '{meant}'?"
        if meant
        else f"there are: {listed(names)}"
        if names
        else f"'{'.'.join(steps[:known])}' holds one value"
    )
    return f"'{name}' is no field{where}; {hint}"


def _names_at(case: CaseFile, steps: Sequence[str]) -> list[str]:
    if not steps:
        return list(model_of(case).model_fields)
    return names_within(model_of(case), steps, given_in(case))


def metadata_in(annotation: Any) -> Iterable[Any]:
    """What an annotated type holds besides its type, at any depth."""
    yield from getattr(annotation, "__metadata__", ())
    for one in typing.get_args(annotation):
        yield from metadata_in(one)


def model_of(case: CaseFile) -> type[Part]:
    """The case model: that of the language, of a case of the Python front door, too."""
    model: type[Part] = getattr(case, "model", type(case))
    return model


def part_in(case: CaseFile, steps: Sequence[str]) -> Any:
    """What a path leads to in a case that was read; None where there is nothing."""
    place: Any = case
    for step in steps:
        if isinstance(place, tuple) and step.isdecimal() and int(step) < len(place):
            place = place[int(step)]
        else:
            place = getattr(place, step, None)
    return place


def refused(path: str, says: str) -> InputError:
    """The refusal of a field that a study varies."""
    return InputError("E003", f"study.vary.{path}: {says}")


class FieldReader:
    """Reads the numbers of one field."""

    def __init__(self, path: str, unit: str) -> None:
        self.path, self.unit = path, unit

    def __call__(self, given: Any, unit: str = "") -> float:
        """A value as a case file has it, in SI."""
        field = SiField(unit or self.unit)
        try:
            return field.as_written(given)
        except QuantityError as error:
            raise refused(self.path, str(error)) from None

    def difference(self, given: Any) -> float:
        """A standard deviation: of temperatures a difference, which 0 degC is not."""
        return self(given, "K difference" if self.unit == "K" else "")
