"""A film at a prescribed place that carries nothing, as that of a centred journal."""

from __future__ import annotations

from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import FilmCase

UNLOADED = 1e-6
"""Sommerfeld number below which the force of a film at a prescribed place is round-off."""

NOTHING_CARRIED = ("load", "specific_load", "pressure_speed_product", "sommerfeld_number")
"""Results that are zero in such a film."""

NEEDS_A_LOAD = (
    "american_sommerfeld_number", "attitude_angle", "load_angle", "friction_number", "friction_coefficient"
)  # fmt: skip
"""Results without meaning in such a film."""

NO_LOAD = "the film carries no load at this position: it has no direction, and friction no measure"
"""Why they are missing."""


def is_unloaded(case: FilmCase, state: FilmState) -> bool:
    """Whether the film at a prescribed place carries no more than round-off."""
    return not isinstance(case.duty, PrescribedLoad) and state.solution.sommerfeld_number < UNLOADED


def missing_without_load(case: FilmCase, state: FilmState | None) -> dict[str, str]:
    """Give the results that a film without load lacks, each with the reason."""
    if state is None or not is_unloaded(case, state):
        return {}
    return dict.fromkeys(NEEDS_A_LOAD, NO_LOAD)
