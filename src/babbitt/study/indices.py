"""Which input drives which output: slopes at the medians, and Sobol indices over the distributions."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.parts.study import StudyBlock
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install, optional_package
from babbitt.study.grids import NOMINAL, Rows
from babbitt.study.inputs import Input
from babbitt.study.rows import Columns

if TYPE_CHECKING:
    from babbitt.study.study import Study

__all__ = ["Indices", "indices_of", "require_numeric", "saltelli", "slopes_of"]

SALTELLI = "saltelli"
"""Group of the rows of Saltelli's scheme."""

CONFIDENCE = 0.95


def require_numeric(block: StudyBlock, inputs: Sequence[Input]) -> None:
    """Refuse words, tables and a missing SALib in a sensitivity.

    Raises
    ------
    InputError
        E003 for a field that takes words or shares a table; E007 where SALib is not installed.
    """
    if block.kind != "sensitivity":
        return
    for one in inputs:
        if one.is_choice:
            says = "is a choice, and Sobol indices need numbers"
            raise InputError("E003", f"study.vary.{one.path}: {says}; leave it out, or ask for a sweep over it")
        if one.table:
            says = "comes from a table, and Sobol indices need inputs that are independent of each other"
            raise InputError("E003", f"study.vary.{one.path}: {says}; give its distribution")
    _salib("SALib.sample.sobol")


def saltelli(inputs: Sequence[Input], base: int, seed: int) -> Rows:
    """Samples of Saltelli's scheme on a scrambled Sobol sequence, without second order: base (d + 2) rows."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that a number of samples that is no power of two is a little less even
        cube = _salib("SALib.sample.sobol").sample(
            _problem(inputs), base, calc_second_order=False, scramble=True, seed=seed
        )
    values = {one.path: one.drawn(cube[:, place]) for place, one in enumerate(inputs)}
    return values, np.full(len(cube), SALTELLI, object)


def _problem(inputs: Sequence[Input]) -> dict[str, Any]:
    return {
        "num_vars": len(inputs),
        "names": [one.path for one in inputs],
        "bounds": [[0.0, 1.0]] * len(inputs),
    }


@dataclass(frozen=True)
class Indices:
    """Sobol indices of one output of one bearing, by input, with half widths of 95 % intervals.

    Attributes
    ----------
    bearing, output : str
    inputs : tuple of str
    first, first_conf, total, total_conf : tuple of float
    used, base : int
        Base samples of which all rows are solved, and all.
    """

    bearing: str
    output: str
    inputs: tuple[str, ...]
    first: tuple[float, ...]
    first_conf: tuple[float, ...]
    total: tuple[float, ...]
    total_conf: tuple[float, ...]
    used: int
    base: int


def indices_of(study: Study) -> tuple[Indices, ...]:
    """First and total Sobol indices of all outputs (Saltelli 2010, Jansen 1999, by SALib).

    Base samples of which one row has no solution are left out; `Indices.used` counts the others.
    """
    analyse = _salib("SALib.analyze.sobol").analyze
    paths = tuple(one["path"] for one in study.inputs)
    problem = {"num_vars": len(paths), "names": list(paths), "bounds": [[0.0, 1.0]] * len(paths)}
    rows = study.of(SALTELLI)
    found = []
    for bearing in dict.fromkeys(rows["bearing"][rows["bearing"] != ""]):
        numbers = rows["row"] - rows["row"].min()
        base = (int(numbers.max()) + 1) // (len(paths) + 2)
        for output in study.outputs:
            own = rows["bearing"] == bearing
            values = np.full(base * (len(paths) + 2), np.nan)
            values[numbers[own]] = rows[output][own]
            by_base = values.reshape(base, len(paths) + 2)
            kept = by_base[np.isfinite(by_base).all(axis=1)]
            found.append(_indices(analyse, problem, str(bearing), output, paths, kept, base, study.block.seed))
    return tuple(found)


def _indices(
    analyse: Any,
    problem: dict[str, Any],
    bearing: str,
    output: str,
    paths: tuple[str, ...],
    kept: NDArray[np.float64],
    base: int,
    seed: int,
) -> Indices:
    """The indices of one output; NaN where it does not vary or hardly any sample is solved."""
    nothing = (np.nan,) * len(paths)
    if len(kept) < 2 or np.ptp(kept) <= 1e-12 * np.abs(kept).max():
        return Indices(bearing, output, paths, nothing, nothing, nothing, nothing, len(kept), base)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        said = analyse(
            problem, kept.ravel(), calc_second_order=False, conf_level=CONFIDENCE, seed=seed + 1
        )  # 0 means none
    first, first_conf, total, total_conf = (
        tuple(map(float, said[name])) for name in ("S1", "S1_conf", "ST", "ST_conf")
    )
    return Indices(bearing, output, paths, first, first_conf, total, total_conf, len(kept), base)


def slopes_of(study: Study) -> dict[tuple[str, str], dict[str, tuple[float, float]]]:
    """Slopes at the medians by central differences.

    Returns
    -------
    dict
        By bearing and output, by input: the slope in SI and the elasticity d ln(output)/d ln(input); NaN where one
        of the two sides has no solution.
    """
    middle = study.of(NOMINAL)
    found: dict[tuple[str, str], dict[str, tuple[float, float]]] = {}
    for place, bearing in enumerate(middle["bearing"]):
        for output in study.outputs:
            slopes = {}
            for one in study.inputs:
                path = one["path"]
                less, more = (_line(study.of(f"{side} {path}"), bearing) for side in ("less", "more"))
                step = more.get(path, np.nan) - less.get(path, np.nan)
                slope = (more.get(output, np.nan) - less.get(output, np.nan)) / step
                at, value = float(middle[path][place]), float(middle[output][place])
                slopes[path] = (slope, slope * at / value if value else np.nan)
            found[str(bearing), output] = slopes
    return found


def _line(columns: Columns, bearing: str) -> dict[str, float]:
    """The numbers of a bearing in a table of one row."""
    places = np.flatnonzero(columns["bearing"] == bearing)
    if not places.size:
        return {}
    return {name: float(column[places[0]]) for name, column in columns.items() if column.dtype == np.float64}


def _salib(module: str) -> Any:
    return optional_package(module, "Sobol indices", how_to_install("SALib", "studies"))
