"""Results as tables of pandas and datasets of xarray."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt import __version__
from babbitt.core.optional_package import optional_package
from babbitt.core.quantities import AXES, QUANTITIES
from babbitt.report.fields import require_package

if TYPE_CHECKING:
    import pandas
    import xarray

    from babbitt.api.results import BearingResult

__all__ = ["attributes_of", "axes_of", "dataset_of", "frame_of"]


def frame_of(
    leading: Sequence[Mapping[str, Any]], results: Sequence[BearingResult], units: Mapping[str, str] | None = None
) -> pandas.DataFrame:
    """A row for each result: what leads it, status and verdict, values, entries of its matrices.

    ``frame.attrs["units"]`` has the unit of each column that is a quantity.

    Parameters
    ----------
    leading : sequence of mapping
        Columns before the others, one mapping for each result.
    results : sequence of BearingResult
    units : mapping, optional
        Of leading columns.

    Raises
    ------
    InputError
        E007 where pandas is not installed.
    """
    pandas_package = optional_package("pandas", "tables", "Install it with: pip install pandas")
    frame: pandas.DataFrame = pandas_package.DataFrame(
        [{**before, **_row(one)} for before, one in zip(leading, results, strict=True)]
    )
    known = {column: attributes_of(_quantity_in(column)).get("units", "") for column in frame.columns}
    frame.attrs["units"] = {column: unit for column, unit in {**known, **(units or {})}.items() if unit}
    return frame


def _quantity_in(column: str) -> str:
    """The quantity of a column: its own name, or that of the matrix of which it is an entry."""
    name, _, axes = column.rpartition("_")
    return name if axes in AXES and column not in QUANTITIES else column


def _row(one: BearingResult) -> dict[str, Any]:
    row: dict[str, Any] = {"name": str(one.name), "outcome": one.outcome.name.lower(), "verdict": one.verdict.key}
    row |= {"within_limits": one.within_limits}
    row |= {name: value for name, value in one.values.items() if name != "wall_time"}
    for name, array in one.arrays.items():
        if array.shape == (2, 2):
            for index in np.ndindex(array.shape):
                row[f"{name}_{'xy'[index[0]]}{'xy'[index[1]]}"] = float(array[index])
    return row


def dataset_of(one: BearingResult) -> xarray.Dataset:
    """Values without dimension, arrays over rows and columns."""
    package = require_package("xarray")
    variables: dict[str, Any] = {
        name: ((), value, attributes_of(name)) for name, value in one.values.items() if name != "wall_time"
    }
    coordinates: dict[str, Any] = {}
    for name, array in one.arrays.items():
        dimensions, own = axes_of(name, array.shape)
        variables[name] = (dimensions, array, attributes_of(name))
        coordinates |= own
    made: xarray.Dataset = package.Dataset(
        variables,
        coords=coordinates,
        attrs={
            "title": str(one.name), "kind": one.kind, "method": one.method, "outcome": one.outcome.name.lower(),
            "verdict": one.verdict.key, "source": f"Babbitt {__version__}",
        },
    )  # fmt: skip
    return made


def axes_of(name: str, shape: tuple[int, ...]) -> tuple[tuple[str, ...], dict[str, Any]]:
    """Dimensions of an array, and their coordinates where it is a matrix of force over motion in x and y."""
    if len(shape) == 1:
        return ("pad" if name.startswith(("pad_", "pivot_")) else f"{name}_column",), {}
    if shape == (2, 2):
        return ("force", "motion"), {"force": ["x", "y"], "motion": ["x", "y"]}
    return (f"{name}_row", f"{name}_column"), {}


def attributes_of(name: str) -> dict[str, str]:
    """Unit and meaning of a named quantity."""
    known = QUANTITIES.get(name)
    return {} if known is None else {"units": known.unit, "long_name": known.meaning}
