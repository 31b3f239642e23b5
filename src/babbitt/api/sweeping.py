"""One case at many values: arrays that are broadcast, and products of values."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from babbitt.api.answers import first_answer
from babbitt.api.given import as_given
from babbitt.case.field_types import attributes_of_field, quantity_in, takes_list
from babbitt.case.problems import CaseError, Problem
from babbitt.core.notices import InputError
from babbitt.core.units import read
from babbitt.core.units.foreign import as_python
from babbitt.study.fields import given_in, types_at

if TYPE_CHECKING:
    import numpy as np

    from babbitt.api.case import Case
    from babbitt.api.result_set import ResultSet
    from babbitt.api.results import BearingResult

__all__ = ["over_arrays", "over_points", "over_product"]


def over_arrays(case: Case, values: Mapping[str, Any]) -> ResultSet | None:
    """Solve a case over arrays that are broadcast against each other; None where there is no array.

    Raises
    ------
    CaseError
        For arrays that do not fit each other.
    """
    import numpy as np

    plain = {path: as_python(value) for path, value in values.items()}
    arrays = {path: value for path, value in plain.items() if _is_array(case, path, value)}
    if not arrays:
        return None
    fixed = case.replace({path: value for path, value in plain.items() if path not in arrays})
    where = type(case).__name__
    texts = {path: np.array(as_given(value, where, (path,)), object) for path, value in arrays.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in texts.values()))
    except ValueError:
        shapes = ", ".join(f"{path} {array.shape}" for path, array in texts.items())
        raise _refused(case, "", f"the arrays do not fit each other: {shapes}", "shapes that broadcast") from None
    spread = {path: np.broadcast_to(array, shape) for path, array in texts.items()}
    flat = zip(*(array.flat for array in spread.values()), strict=True)
    points = [dict(zip(spread, point, strict=True)) for point in flat]
    parameters = {path: _in_si(case, path, array) for path, array in spread.items()}
    return _solved(fixed, points, parameters, shape, workers=1, keep="results")


def over_product(case: Case, over: Mapping[str, Any], workers: int, keep: str) -> ResultSet:
    """Solve the product of values in several fields; the last one varies fastest.

    Raises
    ------
    CaseError
        For a field without values, and where a case is wrong or incomplete.
    """
    import numpy as np

    if keep not in ("results", "solutions"):
        raise InputError("E005", f"keep is {keep!r}; allowed: results, solutions")
    axes: dict[str, np.ndarray[Any, Any]] = {}
    for path, values in over.items():
        given = as_given(values, type(case).__name__, (path,))
        if not isinstance(given, list) or not given:
            raise _refused(case, path, "has no values to go through", "a list or an array")
        axes[path] = np.empty(len(given), object)
        axes[path][:] = given
    points = [dict(zip(axes, point, strict=True)) for point in itertools.product(*axes.values())]
    parameters = {path: _in_si(case, path, axis) for path, axis in axes.items()}
    return _solved(case, points, parameters, tuple(map(len, axes.values())), workers, keep)


def _solved(
    case: Case,
    points: Sequence[Mapping[str, Any]],
    parameters: Mapping[str, np.ndarray[Any, Any]],
    shape: tuple[int, ...],
    workers: int,
    keep: str,
) -> ResultSet:
    from babbitt.api.result_set import ResultSet

    about = {path: attributes_of_field(case.model, path.split("."), given_in(case)) for path in parameters}
    return ResultSet(parameters, over_points(case, points, workers, keep), shape, keep, about)


def over_points(
    case: Case, points: Sequence[Mapping[str, Any]], workers: int, keep: str = "results"
) -> list[BearingResult]:
    """Solve a case with the values of each point, all of which are checked before the first is solved.

    Raises
    ------
    CaseError
        Where a case is wrong or incomplete, or has several bearings, operating points or clearances.
    """
    if workers < 1:
        raise InputError("E005", f"workers is {workers}; give 1 or more")
    cases = [case.replace(point).complete() for point in points]
    several = next((one for one in cases if len(one.calculations()) != 1), None)
    if several is not None:
        says = f"has {len(several.calculations())} bearings, operating points and clearances"
        raise _refused(case, "", says, "one of each in a sweep")
    from babbitt.api.many_cases import solved_cases

    found = solved_cases(cases, workers, keep)
    return [first_answer(one, solved) for one, solved in zip(found, cases, strict=True)]


def _is_array(case: Case, path: str, value: Any) -> bool:
    """Whether a list stands for several values of a field rather than for one."""
    found = types_at(case, path)
    return isinstance(value, list | tuple) and bool(found) and not any(takes_list(one) for one in found)


def _in_si(case: Case, path: str, values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Values of a field as coordinates: quantities in SI, anything else as given."""
    import numpy as np

    found = [quantity_in(one) for one in types_at(case, path)]
    quantity = next((one for one in found if one is not None), None)
    if quantity is None:
        return values
    flat = [read(value, quantity.unit) for value in values.flat]
    return np.array(flat, dtype=float).reshape(values.shape)


def _refused(case: Case, field: str, says: str, allowed: str) -> CaseError:
    return CaseError([Problem(type(case).__name__, 0, field, says, allowed=allowed)])
