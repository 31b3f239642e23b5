"""Both segments, the groove between them and the compliant wall in equilibrium."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.eccentricity_search import film_that_carries, rising_eccentricities
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.grooved_long_bearing.balance import pressure_of, segments_of
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentFilm
from babbitt.kinds.journal.grooved_long_bearing.pressure import Gap, Grid
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState, groove_angle_from_load

Array = NDArray[np.float64]

FIRST_RISE = 5.0
"""K above the supply at which the iteration starts."""

RELAXATION = 0.5
TEMPERATURE_TOLERANCE, DISPLACEMENT_TOLERANCE = 1e-4, 1e-5
"""In K, and over the clearance."""

FRACTION, LEAST_FRACTION = 0.3, 0.02
"""Of the thinnest film, what a step may move the wall; taken back by a tenth whenever the wall overshoots."""

CLOSE = 1e-9
"""Tolerance of the eccentricity ratio."""

PLACE_TOLERANCE = 1e-6
"""In rad: of a groove that keeps its place in the bush."""

MOST_ITERATIONS = 4000
GREATEST_ECCENTRICITY = 0.995
SCAN = rising_eccentricities(GREATEST_ECCENTRICITY)
BEYOND_CONTACT = tuple(np.arange(1.0, 1.2001, 0.01).tolist())
"""Eccentricity ratios that only a compliant wall allows."""


def film_at_eccentricity(
    film: SegmentFilm, eccentricity_ratio: float, start: SegmentFilmState | None = None
) -> SegmentFilmState:
    """The film in thermal (and elastic) equilibrium at an eccentricity ratio; ignored where a profile is given.

    Parameters
    ----------
    film : SegmentFilm
    eccentricity_ratio : float
        From 0; below 1 for a rigid film.
    start : SegmentFilmState, optional
        A neighbouring answer to start from.

    Raises
    ------
    InputError
        E003 for an eccentricity outside its bounds.
    NoFilmError
        NOT_CONVERGED where the film has no rupture point or the iteration breaks down, NO_LUBRICANT_DATA.
    """
    if not film.profile and not (0.0 <= eccentricity_ratio < (1.0 if film.compliance == 0.0 else math.inf)):
        raise InputError(
            "E003", f"eccentricity_ratio must lie from 0 to below 1 for a rigid film, given {eccentricity_ratio!r}"
        )
    asked, film = film, _placed(film, start)
    grid = Grid.of(film)
    rigid = _rigid(film, grid, eccentricity_ratio)
    count = 1 if film.groove is None else 2
    means = np.full(count, film.supply_temperature + FIRST_RISE)
    displaced = np.zeros(grid.angles.size)
    if start is not None:
        means = np.array([one.mean_temperature for one in start.segments])
        displaced = film.compliance * start.film_pressure
    fraction, worst, gap = FRACTION, math.inf, None
    for iteration in range(1, MOST_ITERATIONS + 1):
        if gap is None or film.compliance:
            thickness = rigid + displaced / film.clearance
            if not thickness.min() > 0.0:
                raise NoFilmError(Outcome.NOT_CONVERGED)
            gap = Gap.of(grid, thickness)
        segments, groove_pressure, short = segments_of(film, grid, gap, means)
        pressure = pressure_of(film, grid, segments, groove_pressure)
        change = np.array([one.mean_temperature for one in segments]) - means
        strain = film.compliance * pressure - displaced
        off, bent = float(np.abs(change).max()), float(np.abs(strain).max())
        turn = _turn_to_place(asked, film, grid, pressure)
        done = (
            off < TEMPERATURE_TOLERANCE
            and bent < DISPLACEMENT_TOLERANCE * film.clearance
            and abs(turn) < PLACE_TOLERANCE
        )
        if done or iteration == MOST_ITERATIONS:
            thick = film.clearance * gap.thickness
            return SegmentFilmState(
                film, eccentricity_ratio, grid, thick, pressure, segments, groove_pressure, short, iteration, done,
                (off, bent),
            )  # fmt: skip
        means = means + RELAXATION * change
        if film.compliance:
            fraction = max(LEAST_FRACTION, 0.9 * fraction) if bent > worst else fraction
            worst = bent
            room = (
                film.clearance * float(gap.thickness.min()) / max(film.compliance * float(pressure.max()), 1e-300)
            )
            displaced = displaced + min(RELAXATION, fraction * room) * strain
        if abs(turn) >= PLACE_TOLERANCE:
            film, before = _shifted(film, RELAXATION * turn), grid
            grid, gap = Grid.of(film), None
            rigid = _rigid(film, grid, eccentricity_ratio)
            bends = film.compliance > 0.0
            displaced = np.interp(grid.angles, before.angles, displaced) if bends else np.zeros(grid.angles.size)
    raise AssertionError("unreachable")


def _placed(film: SegmentFilm, start: SegmentFilmState | None) -> SegmentFilm:
    """The film with its groove at an angle from the widest gap: its own, or a first one for its place in the
    bush."""
    if film.groove is None or not film.groove.at_place_in_bush:
        return film
    if start is not None and start.film.groove is not None:
        return film.with_groove_at(start.film.groove.angle)
    return _shifted(film.with_groove_at(math.pi), film.groove.angle)


def _turn_to_place(asked: SegmentFilm, film: SegmentFilm, grid: Grid, pressure: Array) -> float:
    """Angle in rad by which the groove of a film must turn to its place in the bush; 0 where it has none."""
    groove = asked.groove
    if groove is None or not groove.at_place_in_bush:
        return 0.0
    return math.remainder(groove.angle - groove_angle_from_load(film, grid, pressure), 2.0 * math.pi)


def _shifted(film: SegmentFilm, turn: float) -> SegmentFilm:
    """The film with its groove turned by an angle, as far as it stays inside the film."""
    assert film.groove is not None
    half = film.groove.width / film.diameter + PLACE_TOLERANCE
    angle = min(max(film.groove.angle + turn, film.start + half), 2.0 * math.pi - half)
    return film.with_groove_at(angle)


def film_under_load(film: SegmentFilm, load: float) -> SegmentFilmState:
    """The film that carries a load, with the least eccentricity that does.

    Raises
    ------
    NoFilmError
        OVERLOADED with the largest load reached, NOT_CONVERGED, NO_LUBRICANT_DATA.
    """
    if not 0.0 < load < math.inf:
        raise InputError("E003", f"load must be above 0, given {load!r}")
    return film_that_carries(load, _rising(film), lambda at, near: film_at_eccentricity(film, at, near), CLOSE)


def _rising(film: SegmentFilm) -> Iterator[SegmentFilmState]:
    """Films of growing eccentricity, each begun from the one before, up to the last one that converges."""
    state: SegmentFilmState | None = None
    for eccentricity in (*SCAN, *(BEYOND_CONTACT if film.compliance else ())):
        try:
            state = film_at_eccentricity(film, eccentricity, state)
        except NoFilmError as failure:
            if state is None and failure.outcome is Outcome.NO_LUBRICANT_DATA:
                raise  # the oil has no viscosity as it comes: no question of load
            return
        if not state.converged:
            if abs(_turn_to_place(film, state.film, state.grid, state.film_pressure)) >= PLACE_TOLERANCE:
                raise NoFilmError(Outcome.NOT_CONVERGED)  # the groove lies across the start of the film
            return
        yield state


def _rigid(film: SegmentFilm, grid: Grid, eccentricity_ratio: float) -> Array:
    if not film.profile:
        return np.asarray(1.0 + eccentricity_ratio * grid.cosine)
    angles, thickness = np.array(film.profile).T
    return np.asarray(np.interp(grid.angles, angles, thickness, period=2.0 * math.pi) / film.clearance)
