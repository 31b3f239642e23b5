"""From results at several speeds to the coefficient table that other programs take."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.export import CoefficientTable, Frame, Rotation
from babbitt.export.film_table import STATIC
from babbitt.export.frame import load_direction
from babbitt.kinds.journal.film.coefficients_over_speed import STATIC as HEAT
from babbitt.kinds.journal.film.coefficients_over_speed import method_of_coefficients
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_results import temperatures_of_coefficients
from babbitt.kinds.tilting_pad_journal.model import PadCase

if TYPE_CHECKING:
    from babbitt.api.results import BearingResult

__all__ = ["coefficients_of"]

SAME_DIRECTION = 1e-4
"""Angle in rad by which the direction of the load may differ from speed to speed."""


def coefficients_of(results: Sequence[BearingResult]) -> CoefficientTable:
    """Gather results of one bearing at several speeds, in any order.

    Parameters
    ----------
    results : sequence of BearingResult
        Of the method film, each solved, with different speeds.

    Returns
    -------
    CoefficientTable
        x right, y up.

    Raises
    ------
    InputError
        E003 for an unsolved result or equal speeds; E004 for a method without coefficients, a bearing that turns,
        too, and for results that differ in sense or direction.
    """
    if not results:
        raise InputError("E003", "no results; a coefficient table needs one speed or more")
    name = results[0].name
    if all(isinstance(one.solution.problem, PadCase) for one in results):
        return _of_pads(results)
    for one in results:
        if not isinstance(one.solution.problem, FilmCase):
            raise InputError(
                "E004", f"{one.name}: the method {one.method} has no coefficients over speed; film has"
            )
        _require_solved(one)
        if not {"stiffness", "damping"} <= set(one.arrays):
            raise InputError("E004", f"{one.name}: the film has no stiffness and damping under this cavitation")
        if one.solution.problem.bearing_speed:
            raise InputError("E004", f"{one.name}: the bearing turns, too; no table over the journal speed holds")
    ordered = sorted(results, key=lambda one: abs(one.solution.problem.journal_speed))
    cases: list[FilmCase] = [one.solution.problem for one in ordered]
    speeds = np.abs([case.journal_speed for case in cases])
    _require_rising(name, speeds)
    angles = np.array([one.values["load_angle"] for one in ordered])
    if (
        len({case.rotation for case in cases}) > 1
        or np.abs(np.sin(0.5 * (angles - angles[0]))).max() > SAME_DIRECTION
    ):
        raise InputError("E004", f"{name}: rotation sense or load direction differ; make one table for each")
    first = cases[0]
    clockwise = first.rotation.sense < 0.0
    carried = [quantity for quantity in (*STATIC, *HEAT) if all(quantity in one.values for one in ordered)]
    return CoefficientTable(
        name=str(name),
        speeds=speeds,
        stiffness=np.array([one.arrays["stiffness"] for one in ordered]),
        damping=np.array([one.arrays["damping"] for one in ordered]),
        frame=Frame(
            rotation=Rotation.CLOCKWISE if clockwise else Rotation.COUNTER_CLOCKWISE,
            load_angle=load_direction(float(angles[0])),
        ),
        static={quantity: np.array([one.values[quantity] for one in ordered]) for quantity in carried},
        method=method_of_coefficients(first),
        temperatures=temperatures_of_coefficients(first),
        warnings=tuple(one.solution.result.questioning_codes for one in ordered),
    )


def _of_pads(results: Sequence[BearingResult]) -> CoefficientTable:
    """Of tilting pads: over frequency, too, with the matrices of journal and pads."""
    from babbitt.kinds.tilting_pad_journal.coefficients_over_speed import table_of

    for one in results:
        _require_solved(one)
    ordered = sorted(results, key=lambda one: abs(one.solution.problem.journal_speed))
    cases: list[PadCase] = [one.solution.problem for one in ordered]
    _require_rising(results[0].name, np.abs([case.journal_speed for case in cases]))
    return table_of([one.solution.result for one in ordered], cases)


def _require_solved(one: BearingResult) -> None:
    if not one.solved:
        raise InputError("E003", f"{one.name}: no equilibrium ({one.outcome.value}); leave this speed out")


def _require_rising(name: str, speeds: NDArray[np.float64]) -> None:
    if np.any(np.diff(speeds) <= 0.0):
        raise InputError(
            "E003", f"{name}: two results have one speed; a table is made from a sweep over speed alone"
        )
