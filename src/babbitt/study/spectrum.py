"""Load cases with their shares of time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.core.notices import InputError
from babbitt.study.grids import Rows
from babbitt.study.inputs import Input, inputs_of
from babbitt.study.rows import Columns, kelvin_name, margin_name

if TYPE_CHECKING:
    from babbitt.study.study import Study

__all__ = ["SpectrumSummary", "inputs_of_spectrum", "rows_of_spectrum", "spectrum_summary"]

SECONDS_PER_HOUR = 3600.0


def inputs_of_spectrum(case: CaseFile, block: StudyBlock) -> tuple[Input, ...]:
    """The fields that load cases set, each with its values in their order.

    Raises
    ------
    InputError
        E003 where a load case leaves out a field that another sets.
    """
    paths = tuple(dict.fromkeys(path for one in block.load_cases for path in one.set))
    for number, one in enumerate(block.load_cases, 1):
        if missing := [path for path in paths if path not in one.set]:
            name = one.name or str(number)
            says = f"load case {name} does not set {', '.join(missing)}, which another does"
            raise InputError("E003", f"study.load_cases: {says}; set the same fields in all")
    vary = {path: Vary(values=_each_once([one.set[path] for one in block.load_cases])) for path in paths}
    return inputs_of(case, block.model_copy(update={"vary": vary}))


def _each_once(values: list[object]) -> tuple[object, ...]:
    return tuple(value for place, value in enumerate(values) if value not in values[:place])


def rows_of_spectrum(inputs: tuple[Input, ...], block: StudyBlock) -> Rows:
    """A row for each load case, which names its group."""
    values = {}
    for one in inputs:
        given = [case.set[one.path] for case in block.load_cases]
        known = _each_once(given)
        values[one.path] = one.listed[[known.index(value) for value in given]]
    names = [one.name or f"load case {number}" for number, one in enumerate(block.load_cases, 1)]
    return values, np.array(names, object)


@dataclass(frozen=True)
class SpectrumSummary:
    """What a spectrum comes to for one bearing.

    Attributes
    ----------
    bearing : str
    governing_case : str
        Load case with the least margin; a case without a solution governs.
    governing_check : str
    margin : float
    means : dict of str to float
        Means over time, SI; NaN where a load case has no solution.
    yearly_energy : float
        Of friction, J; NaN where the results have no friction power.
    worst_margins, worst_kelvins : dict of str to float
        By the code of each check; those of temperatures in K, too.
    """

    bearing: str
    governing_case: str
    governing_check: str
    margin: float
    means: dict[str, float]
    yearly_energy: float
    worst_margins: dict[str, float]
    worst_kelvins: dict[str, float]


def _least(own: Columns, prefix: str) -> dict[str, float]:
    """The least of each column whose name begins so, by what follows, as far as all lines have a number."""
    least = {name.removeprefix(prefix): float(np.min(own[name])) for name in own if name.startswith(prefix)}
    return {code: value for code, value in least.items() if np.isfinite(value)}


def spectrum_summary(study: Study) -> tuple[SpectrumSummary, ...]:
    """Governing load case, means over time and worst margins of each bearing."""
    block, columns = study.block, study.columns
    shares = np.array([one.share for one in block.load_cases])
    summaries = []
    for bearing in dict.fromkeys(columns["bearing"]):
        own = {name: column[columns["bearing"] == bearing] for name, column in columns.items()}
        time = shares[own["row"]]
        margin = np.where(np.isfinite(own["margin"]), own["margin"], -np.inf)
        worst = int(np.argmin(margin))
        whole = own["row"].size == shares.size
        means = {name: float(np.sum(time * own[name])) if whole else np.nan for name in study.outputs}
        energy = means.get("friction_power", np.nan) * block.hours_per_year * SECONDS_PER_HOUR
        summaries.append(
            SpectrumSummary(
                str(bearing),
                str(own["group"][worst]),
                str(own["governing_check"][worst]),
                float(own["margin"][worst]),
                means,
                float(energy),
                _least(own, margin_name("")),
                _least(own, kelvin_name("")),
            )
        )
    return tuple(summaries)
