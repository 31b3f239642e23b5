"""Heated pads that were left without load, asked what they carry at the temperatures of the state without them."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.tilting_pads._pads import CONVERGED, LIMIT
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, LOADED, UNLOADED
from babbitt.reynolds.tilting_pads.pad_films import PadFilms
from babbitt.reynolds.tilting_pads.solution import LightPad
from babbitt.reynolds.tilting_pads.thermal_pad_states import Settled

__all__ = ["returning_pads"]

Array = NDArray[np.float64]

MOST_STEPS = 100
"""Of the journal."""


def returning_pads(settled: Settled, load: Array) -> tuple[LightPad, ...]:
    """Pads left without load that do not stay unloaded when they may carry again.

    Each is placed once where the journal stands; then the journal is sought with all pads at the viscosity as it
    is, which tells what they would have to carry. A pad that stays unloaded is in equilibrium and none of these.
    """
    films = settled.films
    if not films.without or not settled.outcome.solved:
        return ()
    here = films.freed()
    here.place(settled.placement.at)
    pads = [k for k in films.without if here.places.status[k] != UNLOADED]
    if not pads:
        return ()
    moved = films.freed()
    status = moved.carry(load, settled.placement.at, films.resolution.tolerance, MOST_STEPS).status
    return tuple(light_pad(here, moved, status, k) for k in pads)


def light_pad(here: PadFilms, moved: PadFilms, status: int, k: int) -> LightPad:
    """What a pad would have to carry, from its films with the journal as it stands and in equilibrium."""
    force, need, least = here.scales.force, math.nan, math.nan
    if status == LIMIT and moved.places.status[k] == AT_LIMIT:
        need, least = float(moved.places.need[k]) * force, float(moved.places.least[k]) * force
    elif status == CONVERGED:
        need = float(-moved.places.answers[k, 0]) * force
    return LightPad(k, need, least, returning_load(here, k))


def returning_load(here: PadFilms, k: int) -> float:
    """Load of a pad where the journal stands, N; at its limit the least that it can carry."""
    if here.places.status[k] == LOADED:
        return float(-here.places.answers[k, 0]) * here.scales.force
    if here.places.status[k] == AT_LIMIT:
        return float(here.places.least[k]) * here.scales.force
    return math.nan
