"""A study as it is read: every quantity that of the film against which the limits of its row are held."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.limited_flow import is_limited, limited, whole

if TYPE_CHECKING:
    from babbitt.study.study import Study

__all__ = ["WITH_LIMITED_FLOW", "as_read", "column_held", "value_held"]

WITH_LIMITED_FLOW = "with_limited_flow"
"""Column of a study that is read: whether the film of a line has no more oil than the supply delivers."""


def column_held(columns: Mapping[str, NDArray[Any]], name: str) -> NDArray[Any]:
    """The readings of a quantity that limits are held against, shape (n,)."""
    return columns[limited(name)] if limited(name) in columns else columns[name]


def value_held(line: Mapping[str, Any], name: str) -> float:
    """The reading of a quantity in one line that limits are held against; NaN where the line has none.

    >>> value_held({"total_flow": 2.0, "starved_total_flow": 1.0}, "total_flow"), value_held({}, "total_flow")
    (1.0, nan)
    """
    return float(line.get(limited(name), line.get(name, math.nan)))


def as_read(study: Study) -> Study:
    """The study with one column a quantity, for tables, figures and answers; files keep those of both films."""
    twice = [name for name in study.outputs if is_limited(name) and whole(name) in study.outputs]
    if not twice or study.kind == "design":  # whose rules name the films they read
        return study
    columns = {name: column for name, column in study.columns.items() if name not in twice}
    less = np.zeros(columns["row"].size, bool)
    for name in twice:
        held, full = study.columns[name], study.columns[whole(name)]
        less |= np.isfinite(held) & (held != full)
        columns[whole(name)] = held
    outputs = [name for name in study.outputs if name not in twice]
    return replace(
        study, description={**study.description, "outputs": outputs}, columns=columns | {WITH_LIMITED_FLOW: less}
    )
