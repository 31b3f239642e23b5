"""Values of a film at vanishing intervals, by Richardson from its grid and half of its lines.

The errors of a full film fall with the square of the number of lines (``lines``). A rupture stands on grid lines
and moves in steps, so that ruptured films are not extrapolated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from babbitt.core.result import Matrix
from babbitt.kinds.hydrostatic.answer import HALF_REFERENCE, Answer, answer
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.state import SearchOutcome

__all__ = ["half_of", "richardson", "richardson_of_matrices"]

OF_THE_GRID = {"mass_balance_error", "cavitated_share", "minimum_film_thickness"}
"""Values that tell how the grid did, with nothing behind them to go to, and the least gap, which is looked for
among nodes and moves in steps."""


def half_of(case: HydrostaticCase, found: Answer) -> Answer | None:
    """The same case on half the lines, where its film is to be extrapolated.

    Parameters
    ----------
    case : HydrostaticCase
    found : Answer
        Of the case.

    Returns
    -------
    Answer or None
        None for other accuracies, the quick method, ruptured films, and where the coarser film has no state.
    """
    if case.accuracy != "reference" or found.film is None or found.film.dry_share > 0.0:
        return None
    half = answer(replace(case, accuracy=HALF_REFERENCE))
    full = half.film is not None and half.film.dry_share == 0.0
    return half if half.ending is SearchOutcome.SOLVED and full else None


def richardson(fine: Mapping[str, float], half: Mapping[str, float]) -> dict[str, float]:
    """Values of second order in the number of lines, extrapolated: f + (f - f_half)/3.

    Examples
    --------
    >>> richardson({"load": 4.0, "cavitated_share": 0.5}, {"load": 1.0, "cavitated_share": 0.0})
    {'load': 5.0, 'cavitated_share': 0.5}
    """
    gone = {
        name: value + (value - half[name]) / 3.0 if name in half and name not in OF_THE_GRID else value
        for name, value in fine.items()
    }
    if "eccentricity_ratio" in gone:  # the gap of a journal follows its place
        shift = gone["eccentricity_ratio"] - fine["eccentricity_ratio"]
        gone["minimum_film_thickness"] *= 1.0 - shift / (1.0 - fine["eccentricity_ratio"])
    return gone


def richardson_of_matrices(fine: Mapping[str, Matrix], half: Mapping[str, Matrix]) -> dict[str, Matrix]:
    """The same for values of several numbers."""
    return {
        name: tuple(
            tuple(value + (value - coarse) / 3.0 for value, coarse in zip(row, other, strict=True))
            for row, other in zip(matrix, half[name], strict=True)
        )
        for name, matrix in fine.items()
    }
