"""The design check repeated while one number of a design changes and all others stay, for figures of a result."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

from babbitt.core.notices import InputError
from babbitt.core.result import Result
from babbitt.core.solution import Calculation
from babbitt.kinds.journal.limits_of_clearance import for_values
from babbitt.study.sweep import Sweep, swept

__all__ = ["sweep_design", "varied"]

DesignT = TypeVar("DesignT")


def sweep_design(calculation: Calculation, path: str, points: Iterable[float]) -> Sweep:
    """Run the design check for each value of one number of a design.

    Nothing else changes: what a case would derive from the number keeps its value. To vary a field of a case with
    all that follows from it, see `babbitt.study.sweep.sweep`.

    Parameters
    ----------
    calculation : Calculation
        Of a problem that has one solution.
    path : str
        Dotted name of a scalar of the design: ``"journal_speed"``, ``"duty.load"``, ``"bearing.span"``,
        ``"oil_supply.temperature"``.
    points : iterable of float
        Values in SI; the span in degrees, as in the design.

    Returns
    -------
    Sweep
        Every point has an outcome; one that is not solved or refused leaves a gap and stops nothing.

    Raises
    ------
    ValueError
        If the design has no such number.
    """
    taken = [float(point) for point in points]
    calculation = for_values(calculation)  # what limits are held against besides is of the design as it is
    results: list[Result | None] = []
    refused: dict[int, str] = {}
    for place, point in enumerate(taken):
        try:
            problem = varied(calculation.problem, path, point)
            results.append(calculation.method.solve_one(problem).result)
        except InputError as error:
            results.append(None)
            refused[place] = str(error)
    return swept(path, taken, results, refused)


def varied(case: DesignT, path: str, value: float) -> DesignT:
    """The same design with another value of one number.

    A number that the design declares to be a whole one, such as the span in degrees, stays whole.
    """
    changed: DesignT = _replaced(case, path.split("."), value, path)
    return changed


def _replaced(part: Any, names: list[str], value: float, path: str) -> Any:
    name, *rest = names
    declared = _declared(part)
    if name not in declared:
        raise ValueError(f"the case has no {path!r}: {type(part).__name__} has no field {name!r}")
    present = getattr(part, name)
    if rest:
        return replace(part, **{name: _replaced(present, rest, value, path)})
    if isinstance(present, bool) or not isinstance(present, int | float):
        raise ValueError(f"{path!r} of the case is no number: {present!r}")
    return replace(part, **{name: round(value) if declared[name] in ("int", int) else value})


def _declared(part: object) -> dict[str, object]:
    """Fields of a dataclass and the types that they are declared with."""
    return {field.name: field.type for field in fields(part)} if is_dataclass(part) else {}
