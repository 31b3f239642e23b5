"""Many tilting-pad bearings of one layout, from arrays to arrays: how K, C and temperatures scatter."""

from __future__ import annotations

from collections.abc import Callable

from numpy.typing import ArrayLike

from babbitt.core.notices import InputError
from babbitt.kinds.tilting_pad_journal.batch import Band, PadBatch
from babbitt.kinds.tilting_pad_journal.batch import solve_pad_batch as solve_cases
from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase
from babbitt.kinds.tilting_pad_journal.model import PadCase

__all__ = ["Band", "PadBatch", "solve_pad_batch"]


def solve_pad_batch(
    bearing: TiltingPadJournalCase | PadCase,
    *,
    clearance: ArrayLike | None = None,
    assembled_clearance: ArrayLike | None = None,
    preload: ArrayLike | None = None,
    load: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> PadBatch:
    """Solve many bearings that differ from one in clearances, preload, load or speed.

    Each is solved as by itself, with the same numbers; oil, pads, pivots, walls and thermal model are those of
    `bearing`. Checks and figures are left out: for them solve single bearings.

    Parameters
    ----------
    bearing : TiltingPadBearing or PadCase
        One bearing at one operating point, read from a file, made in Python, or in SI without the case language
        (`babbitt.kinds.tilting_pad_journal.model`).
    clearance, assembled_clearance, preload : array_like, optional
        Machined and assembled clearance on the radius, m, and 1 less the latter over the former: a scalar, one
        for each bearing, or (bearings, pads). Two of them at most; with one alone the other that `bearing` gives
        is held, as in a sweep of that field: of pads given by assembled clearance and preload, a preload moves the
        machined clearance. Where `bearing` gives the other two the machined clearance is held, or beside it the
        preload.
    load : array_like, optional
        Magnitude, N, in the direction of `bearing`.
    speed : array_like, optional
        Of the journal without its sign, rad/s, in the sense of `bearing`.
    workers : int, optional
        Threads; by default as many as there are cores. The answer does not depend on it.
    progress : callable, optional
        Called with how many bearings are done, and how many there are.

    Returns
    -------
    PadBatch
        Its `solved` first: the numbers of an unsolved bearing are NaN, and its `outcomes` say why.

    Raises
    ------
    CaseError
        For a bearing from which something is missing.
    InputError
        E101, with the name of the argument, for text and quantities, for what is not positive and finite, numbers
        of bearings or pads that do not fit each other, and three clearances; E003 for several operating points or
        clearances.

    Examples
    --------
    >>> import numpy as np
    >>> import babbitt
    >>> bearing = babbitt.TiltingPadBearing(
    ...     diameter=0.1, load=10e3, speed=419.0, lubricant="ISO VG 32", supply={"temperature": "40 degC"},
    ...     pads={"number": 4, "first_pivot": "45 deg", "extent": "75 deg", "width": 0.07, "thickness": 0.02,
    ...           "clearance": babbitt.radial_clearance(148e-6), "preload": 0.47},
    ...     method=babbitt.Film(thermal="isothermal", accuracy="draft"))
    >>> found = solve_pad_batch(bearing, preload=np.linspace(0.4, 0.5, 5))
    >>> found.solved.all(), found.band("stiffness").mean.shape
    (np.True_, (2, 2))
    """
    return solve_cases(
        bearing if isinstance(bearing, PadCase) else problem_of(bearing), clearance=clearance,
        assembled_clearance=assembled_clearance, preload=preload, load=load, speed=speed, workers=workers,
        progress=progress,
    )  # fmt: skip


def problem_of(bearing: TiltingPadJournalCase) -> PadCase:
    """The one problem of a bearing."""
    if not isinstance(bearing, TiltingPadJournalCase):
        kind = type(bearing).__name__
        raise InputError("E101", f"bearing is of the class {kind}; give a TiltingPadBearing or a PadCase.")
    problems = bearing.complete().problems()
    if len(problems) != 1:
        raise InputError(
            "E003", f"the bearing has {len(problems)} operating points and clearances; a batch begins with one. "
            "Leave operating_points and clearance_cases out."
        )  # fmt: skip
    problem: PadCase = problems[0]
    return problem
