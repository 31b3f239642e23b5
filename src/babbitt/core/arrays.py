"""Arrays of numbers as a program gives them: in SI, of a known shape, each refused by its name."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError

__all__ = ["numbers", "positive", "require_one_count", "require_workers"]

Array = NDArray[np.float64]


def numbers(name: str, unit: str, given: object) -> Array:
    """An array of numbers; text and quantities, which a single bearing would take, are refused by name.

    Raises
    ------
    InputError
        E101.
    """
    says = f"{name}: a batch takes numbers in {unit} or arrays of them"
    if hasattr(given, "magnitude"):
        raise InputError("E101", f"{says}, not quantities; give .to({unit!r}).magnitude")
    try:
        found = np.asarray(given)
    except ValueError:
        raise InputError("E101", f"{says}; the rows of this list differ in length") from None
    if found.dtype.kind not in "iuf":
        first = next(iter(found.ravel().tolist()), given)
        raise InputError("E101", f"{says}, not {first!r}, which is a {type(first).__name__}")
    return found.astype(np.float64)


def positive(name: str, unit: str, given: object, axes: tuple[str, ...] = ("bearings",), why: str = "") -> Array:
    """Positive numbers with at most as many axes as are named; ``why`` goes on where one is not positive.

    Raises
    ------
    InputError
        E101.
    """
    values = numbers(name, unit, given)
    if values.ndim > len(axes):
        words = {1: "one axis, (bearings,)", 2: "one axis or two, (bearings,) or (bearings, pads)"}[len(axes)]
        raise InputError("E101", f"{name} has shape {values.shape}; give a scalar or {words}")
    if not (np.isfinite(values) & (values > 0.0)).all():
        raise InputError("E101", f"{name} must be positive and finite everywhere, in SI{why}")
    return values


def require_one_count(shapes: Mapping[str, tuple[int, ...]]) -> int:
    """How many bearings arrays stand for; one goes with any number, arrays of different lengths are refused by
    name.

    Raises
    ------
    InputError
        E101.
    """
    counts = {name: shape[0] for name, shape in shapes.items() if shape and shape[0] != 1}
    if len(set(counts.values())) > 1:
        named = ", ".join(f"{name} {count}" for name, count in counts.items())
        raise InputError("E101", f"the numbers of bearings differ: {named}")
    return next(iter(counts.values()), 1)


def require_workers(workers: object) -> None:
    """Refuse what is no number of threads.

    Raises
    ------
    InputError
        E101.
    """
    if workers is not None and not (isinstance(workers, int | np.integer) and workers >= 1):
        raise InputError("E101", f"workers is {workers!r}; it must be a whole number, one or more")
