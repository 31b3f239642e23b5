"""What a changing load adds to the answer of a bearing: the orbit, its numbers, verdicts and warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Check, Matrix, Outcome
from babbitt.design.conditions import PrescribedLoad, sliding_speed
from babbitt.design.warnings import RIGID_FILM_UP_TO, warnings_about_pressure
from babbitt.kinds.journal.film.changing_load import TabulatedLoad
from babbitt.kinds.journal.film.isothermal import FilmState, is_expensive
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.properties.materials import LoadCharacter, SourcedValue
from babbitt.reynolds.model import DRAFT, Cavitation

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.orbit import Orbit

__all__ = [
    "orbit_assumptions",
    "orbit_checks",
    "orbit_warnings",
    "orbit_failure",
    "orbit_of",
    "orbit_rows",
    "orbit_values",
]

GRID_REPORTED_FROM = 0.05
"""Share of the load that a finer grid does not confirm, from which the orbit is questioned."""


HELD_ON_ORBIT = ("minimum_film_thickness", "maximum_pressure", "specific_load", "pressure_speed_product")
"""Results of the steady load whose limits hold for the worst instant of an orbit, too."""


def orbit_of(case: FilmCase, state: FilmState, watch: ProgressCallback = no_progress) -> Orbit | None:
    """Orbit of the journal in the film of the operating point; None under a steady load.

    It is seen on the grid of the case, or on a draft grid where each of its instants would take long.
    """
    if case.changing_load is None or not isinstance(case.duty, PrescribedLoad):
        return None
    from babbitt.kinds.journal.film.orbit import find_orbit

    film = state.solution.film
    return find_orbit(
        film,
        case.changing_load,
        load_vector(case, case.duty.load),
        case.journal_speed,
        case.moving_mass,
        DRAFT if is_expensive(state) else case.accuracy.resolution,
        watch,
    )


def orbit_values(case: FilmCase, orbit: Orbit) -> dict[str, float]:
    """Named results of an orbit, SI."""
    largest = float(np.hypot(*orbit.load.T).max())
    pressure = largest / (case.bearing.loaded_width * case.bearing.diameter)
    return {
        "orbit_largest_eccentricity_ratio": orbit.largest_eccentricity_ratio,
        "orbit_minimum_film_thickness": float(orbit.film_thickness[orbit.thinnest]),
        "orbit_minimum_film_direction": orbit.thinnest_direction,
        "orbit_minimum_film_turned": float(orbit.turned[orbit.thinnest]),
        "orbit_maximum_pressure": float(orbit.maximum_pressure.max()),
        "orbit_specific_load": pressure,
        "orbit_pressure_speed_product": pressure * sliding_speed(case),
        "orbit_friction_power": case.friction_factor * orbit.friction_power,
        "orbit_load_power": orbit.load_power,
        "orbit_load_error": orbit.load_error,
        "orbit_cycles": float(orbit.cycles),
    }


def orbit_rows(orbit: Orbit) -> Matrix:
    """One row per instant: angle turned, x, y, load in x and y, smallest film thickness, largest pressure; SI."""
    columns = (
        orbit.turned, *orbit.position.T, *orbit.load.T, orbit.film_thickness, orbit.maximum_pressure,
    )  # fmt: skip
    return tuple(tuple(float(one) for one in row) for row in zip(*columns, strict=True))


def orbit_checks(checks: tuple[Check, ...], values: dict[str, float]) -> Iterator[Check]:
    """The limits of film thickness, load and pressure, asked of the worst instants of the orbit that are known."""
    for check in checks:
        name = f"orbit_{check.quantity}"
        if check.quantity in HELD_ON_ORBIT and math.isfinite(values[name]):
            yield replace(check, quantity=name, value=values[name])


def orbit_warnings(case: FilmCase, orbit: Orbit, values: Mapping[str, float]) -> Iterator[Notice]:
    """Where the orbit leaves the ground on which it stands."""
    if orbit.load_error > GRID_REPORTED_FROM:
        yield Notice("W133", values={"orbit_load_error": orbit.load_error})
    yield from _about_shocks(case, values)
    yield from warnings_about_pressure(float(orbit.maximum_pressure.max()), "orbit")
    depth = 1.0 - float(orbit.film_thickness.min()) / orbit.clearance
    if depth > RIGID_FILM_UP_TO:
        yield Notice("W116", "orbit", {"depth": depth, "limit": RIGID_FILM_UP_TO})


def _about_shocks(case: FilmCase, values: Mapping[str, float]) -> Iterator[Notice]:
    """A largest specific load, or load times speed, that the metal bears calmly and not in shocks."""
    metal = case.bearing.metal
    if metal is None or case.bearing.load_character is LoadCharacter.SHOCK:
        return
    shocks, calm = metal.limits(LoadCharacter.SHOCK), metal.limits(LoadCharacter.CALM)
    load, product = values["orbit_specific_load"], values["orbit_pressure_speed_product"]
    limit = _limit_in_shocks(load, shocks.specific_load, calm.specific_load)
    if limit is not None:
        yield Notice("W200", "load", {"orbit_specific_load": load, "metal": metal.name, "limit": limit})
    limit = _limit_in_shocks(product, shocks.pv, calm.pv)
    if limit is not None:
        yield Notice("W200", "load_times_speed", {
            "orbit_pressure_speed_product": product, "metal": metal.name, "limit": limit,
        })  # fmt: skip


def _limit_in_shocks(largest: float, shock: SourcedValue | None, calm: SourcedValue | None) -> float | None:
    """The limit in shocks, where a value passes it and keeps that of a calm load."""
    if shock is None or not largest > shock.value or (calm is not None and largest > calm.value):
        return None
    return shock.value


def orbit_assumptions(case: FilmCase) -> Iterator[str]:
    """What the orbit takes for granted."""
    yield "The orbit has the oil, temperature and clearance of the operating point under the steady load alone."
    if case.cavitation is Cavitation.MASS_CONSERVING:
        yield "The film of the orbit ruptures by the Reynolds condition at every instant, without memory."
    if not case.moving_mass:
        yield "The journal of the orbit has no mass: the film balances the load at every instant."


def orbit_failure(case: FilmCase, orbit: Orbit) -> Notice:
    """How far an orbit came that does not close, and what to try of what the case has."""
    code, thinnest = orbit.outcome.code, float(orbit.film_thickness.min())
    far = Notice(code, "cycles", {"cycles": orbit.cycles})
    if math.isfinite(thinnest):
        far = Notice(code, "cycles_film", {"cycles": orbit.cycles, "minimum_film_thickness": thinnest})
    if orbit.outcome is Outcome.NOT_PERIODIC and not case.moving_mass:
        return Notice("S008", "massless", {"far": far})
    if orbit.outcome is Outcome.SQUEEZED_OUT and isinstance(case.changing_load, TabulatedLoad):
        return Notice("S007", "table", {"far": far})
    return Notice(code, "tried", {"far": far})
