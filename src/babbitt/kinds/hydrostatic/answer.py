"""Position, pressures and derivatives of a bearing, by the quick method or by its film."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.lines import DRAFT, ENGINEERING, REFERENCE, Grid
from babbitt.kinds.hydrostatic.lumped import level_under, lumped_at, lumped_under
from babbitt.kinds.hydrostatic.lumps import Lumps, journal_lumps, ring_lumps
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.network import NetworkState
from babbitt.kinds.hydrostatic.single_recess import WIDEST, gap_under, pad_at
from babbitt.kinds.hydrostatic.state import RecessState, SearchOutcome, ending_of, equilibrium_under, state_at
from babbitt.kinds.hydrostatic.surfaces import FilmOil, journal_surface, pad_surface, ring_surface
from babbitt.reynolds.recess.recess_film import RecessResponse, RecessSurface

__all__ = ["GRIDS", "HALF_REFERENCE", "Answer", "answer", "answer_at", "load_vector", "thinnest_film"]

Array = NDArray[np.float64]
HALF_REFERENCE = "half of reference"
GRIDS = {
    "draft": DRAFT,
    "engineering": ENGINEERING,
    "reference": REFERENCE,
    HALF_REFERENCE: Grid(REFERENCE.per_turn // 2, REFERENCE.degree),
}
THINNEST = 0.01
"""Of the gap at rest: where a search gives up."""
MOST_OPEN, LEAST_OPEN = 2e-3, 5e-7
"""Gaps between which that of a pad is sought, m."""
NEAR = 0.1
"""Of the load: as near Newton in all motions begins."""


@dataclass(frozen=True, eq=False)
class Answer:
    """State of a bearing.

    Attributes
    ----------
    response : RecessResponse
    network : NetworkState
    at : ndarray, shape (motions,)
        Journal: x, y. Pads: z from ``rest_gap``, and tilts.
    rest_gap : float
        m.
    ending : SearchOutcome
    minimum_gap : float
        m.
    steps : int
    carried : float
        Share of the load that was found to be carried, of an overloaded bearing.
    film : RecessState or None
        None by the quick method.
    """

    response: RecessResponse
    network: NetworkState
    at: Array
    rest_gap: float
    ending: SearchOutcome
    minimum_gap: float
    steps: int
    carried: float = 0.0
    film: RecessState | None = None


def load_vector(case: HydrostaticCase) -> Array:
    """Load on the moving part, N and N m; the film's force balances it."""
    load, duty = case.duty.load or 0.0, case.duty
    if case.is_journal:
        return load * np.array([math.cos(duty.load_angle), math.sin(duty.load_angle)])
    if isinstance(case.shape, RectangularPad):
        return np.array([-load])
    return np.array([-load, duty.moments[0], duty.moments[1]])


def given_position(case: HydrostaticCase) -> Array:
    """Position that the case prescribes."""
    if case.is_journal:
        return np.array(case.duty.position)
    return np.zeros(1) if isinstance(case.shape, RectangularPad) else np.array([0.0, *case.duty.tilt])


def answer(case: HydrostaticCase) -> Answer:
    """State of the case: at the position given, or under its load.

    Parameters
    ----------
    case : HydrostaticCase

    Returns
    -------
    Answer
    """
    if case.duty.load is None:
        return answer_at(case, given_position(case), case.rest_gap)
    if case.method == "quick":
        return quick_under(case)
    gap = case.rest_gap
    start = np.zeros(load_vector(case).size)
    if not case.is_journal:
        found = quick_gap(case)
        if math.isinf(found):
            return without_gap(case, found)
        gap = found if found > 0.0 else case.rest_gap
    state = equilibrium_under(
        builder(case, gap), case.feeding, load_vector(case), start, GRIDS[case.accuracy], THINNEST * gap
    )
    return of_film(state, gap)


def answer_at(case: HydrostaticCase, at: Array, gap: float) -> Answer:
    """State at a position from a gap at rest."""
    if case.method == "film":
        return of_film(state_at(builder(case, gap), case.feeding, at, GRIDS[case.accuracy]), gap)
    shape = case.shape
    if isinstance(shape, RecessedJournal | ThrustRing):
        lumps = lumps_of(case, gap)
        state = lumped_at(lumps, case.feeding, at)
        return Answer(state.response, state.network, at, gap, state.ending, lumps.thinnest(at), 1)
    pad = pad_at(lands_of(shape), case.feeding, case.oil.viscosity, gap + float(at[0]))
    return Answer(pad.response, pad.network, at[:1], gap, ending_of(pad.network), pad.gap, 1)


def thinnest_film(case: HydrostaticCase, found: Answer) -> float:
    """Minimum film thickness, m: of a round journal between the nodes of the grid, too."""
    if isinstance(case.shape, RecessedJournal):
        return case.shape.clearance - float(np.hypot(*found.at))
    return found.minimum_gap


def of_film(state: RecessState, gap: float) -> Answer:
    """Answer of a film."""
    return Answer(
        state.response, state.network, state.at, gap, state.ending, state.gap, state.steps, state.carried, state
    )


def builder(case: HydrostaticCase, gap: float) -> partial[RecessSurface]:
    """Grid to surface."""
    unit = case.feeding.nominal_pressure or 1e6
    oil = FilmOil(case.oil.viscosity, case.duty.angular_speed, unit, case.cavitation_pressure)
    shape = case.shape
    if isinstance(shape, RecessedJournal):
        return partial(journal_surface, shape, oil)
    if isinstance(shape, RectangularPad):
        return partial(pad_surface, shape, gap, oil)
    return partial(ring_surface, shape, gap, oil)


def lumps_of(case: HydrostaticCase, gap: float) -> Lumps:
    """Lumped lands of a bearing with several recesses."""
    if isinstance(case.shape, RecessedJournal):
        return journal_lumps(case.shape, case.oil.viscosity, case.duty.angular_speed)
    assert isinstance(case.shape, ThrustRing)
    return ring_lumps(case.shape, gap, case.oil.viscosity, case.duty.angular_speed)


def quick_gap(case: HydrostaticCase) -> float:
    """Gap under the load by closed forms, of a ring nearly and as if level.

    As of `babbitt.kinds.hydrostatic.gap_search.gap_for_load`: 0, infinite or nan where there is none.
    """
    shape, load = case.shape, case.duty.load or 0.0
    assert not isinstance(shape, RecessedJournal)
    if not isinstance(shape, ThrustRing):
        return gap_under(lands_of(shape), case.feeding, case.oil.viscosity, load, LEAST_OPEN)
    return level_under(lumps_of(case, case.rest_gap), case.feeding, load, (LEAST_OPEN, MOST_OPEN), 1e-3)[0]


def quick_under(case: HydrostaticCase) -> Answer:
    """Equilibrium by closed forms or lumped lands."""
    if isinstance(case.shape, RecessedJournal):
        lumps = lumps_of(case, case.rest_gap)
        state = lumped_under(lumps, case.feeding, load_vector(case), lumped_at(lumps, case.feeding, np.zeros(2)))
        return Answer(state.response, state.network, state.at, case.rest_gap, state.ending,
                      lumps.thinnest(state.at), 1, state.carried)  # fmt: skip
    if isinstance(case.shape, ThrustRing):
        return quick_ring(case)
    gap = quick_gap(case)
    return answer_at(case, np.zeros(3), gap) if 0.0 < gap < math.inf else without_gap(case, gap)


def quick_ring(case: HydrostaticCase) -> Answer:
    """Equilibrium of a ring by lumped lands, from near the gap at which it carries the load level."""
    lumps = lumps_of(case, case.rest_gap)
    near, level = level_under(lumps, case.feeding, case.duty.load or 0.0, (LEAST_OPEN, MOST_OPEN), NEAR)
    if not 0.0 < near < math.inf:
        return without_gap(case, near)
    state = lumped_under(lumps, case.feeding, load_vector(case), level)
    gap, tilts = lumps.gap + float(state.at[0]), state.at * (0.0, 1.0, 1.0)
    return Answer(state.response, state.network, tilts, gap, state.ending, lumps.thinnest(state.at), 1,
                  state.carried)  # fmt: skip


def without_gap(case: HydrostaticCase, found: float) -> Answer:
    """A pad or ring that no gap of the search holds, where the search gave up: see `quick_gap`."""
    widest = MOST_OPEN if isinstance(case.shape, ThrustRing) else WIDEST
    gap, ending = {0.0: (LEAST_OPEN, SearchOutcome.OVERLOADED), math.inf: (widest, SearchOutcome.LIFTED_OFF)}.get(
        found, (case.rest_gap, SearchOutcome.NOT_CONVERGED)
    )
    last = answer_at(replace(case, method="quick"), np.zeros(load_vector(case).size), gap)
    if last.ending is SearchOutcome.UNSTABLE_NETWORK:
        ending = last.ending  # what it carries is no load
    share = 0.0 if ending is SearchOutcome.LIFTED_OFF else float(last.response.force[0]) / (case.duty.load or 1.0)
    return replace(last, ending=ending, minimum_gap=gap, carried=max(share, 0.0))


def coarser(case: HydrostaticCase, found: Answer) -> RecessState:
    """The film of an answer at the same place on half the lines, for the error estimate."""
    grid = GRIDS[case.accuracy]
    half = Grid(grid.per_turn // 2, grid.degree)
    return state_at(builder(case, found.rest_gap), case.feeding, found.at, half)
