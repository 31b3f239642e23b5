"""Transition to mixed friction: the speed at which the film thins to what the surfaces need."""

from __future__ import annotations

import math

from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.whirl import at_speed
from babbitt.numerics.roots import bracketed_root
from babbitt.reynolds.stability.whirl_limits import SPEED_TOLERANCE

SLOWEST = 1e-5
"""Share of the operating speed down to which the transition is sought."""


def transition_speed(case: FilmCase, state: FilmState, film_thickness: float) -> float | None:
    """Speed in rad/s at which the film is as thin as `film_thickness` (m), load and oil kept.

    None where no slower speed gives such a film, or the film at the operating point is thinner already and no
    speed up to ten times as high lifts it.
    """

    def surplus(log_speed: float) -> float:
        found = at_speed(case, state, math.exp(log_speed))
        return math.log(found.minimum_film_thickness / film_thickness) if found.outcome.solved else -10.0

    here = math.log(abs(state.solution.film.angular_speed))
    if surplus(here) < 0.0:
        low, high = here, here + math.log(10.0)
        if surplus(high) < 0.0:
            return None
    else:
        low, high = here - math.log(2.0), here
        while surplus(low) > 0.0:
            low, high = low - math.log(2.0), low
            if low < here + math.log(SLOWEST):
                return None
    return math.exp(bracketed_root(surplus, low, high, absolute=SPEED_TOLERANCE))
