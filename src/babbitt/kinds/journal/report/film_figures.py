"""Figures of one film bearing: maps, the bearing seen along the shaft, locus, coefficients, threshold of whirl."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.core.solution import Solution
from babbitt.kinds.journal.film.isothermal import FilmState, under_found_load
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.report.drawing import Drawing, rendered, style
from babbitt.reynolds.model import Cavitation

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SLOW = 4500
"""Grid points of a film beyond which sweeps take seconds."""

KEPT = "at the clearance and viscosity of the operating point"

LEFT_OUT = (
    " Curves over load and speed are left out of the report: the film of this bearing has so many grid points "
    "that they take long. The option --plots writes them."
)

Painted = tuple[str, str, "Figure", bool]
"""Name, caption, figure, whether it takes the width of the page."""


def report_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Figures for the report of a solved bearing; those that take long are left out, and the caption says so.

    Parameters
    ----------
    solution : Solution
        Of a film; an unsolved one has no figures.
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Drawing
    """
    return _drawings(solution, _for_report, image_format)


def all_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Every figure of a solved bearing, the pressure as a surface included; as `report_figures`."""
    return _drawings(solution, _all, image_format)


def _drawings(
    solution: Solution, choice: Callable[[FilmCase, FilmState, Result], Iterator[Painted]], image_format: str
) -> tuple[Drawing, ...]:
    if not solution.result.outcome.solved:
        return ()
    case = under_found_load(solution.problem, solution.state)
    with style():
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), wide)
            for name, caption, figure, wide in choice(case, solution.state, solution.result)
        )


def _for_report(case: FilmCase, state: FilmState, result: Result) -> Iterator[Painted]:
    slow = is_slow(state)
    yield from _at_rest(case, state, LEFT_OUT if slow else "")
    yield from _temperatures(case, state)
    yield from _moving(state, result)
    yield from _mixed(result)
    if not slow:
        yield from _swept(case, state, result)


def _all(case: FilmCase, state: FilmState, result: Result) -> Iterator[Painted]:
    yield from _at_rest(case, state)
    yield from _temperatures(case, state)
    yield from _surface(case, state)
    yield from _moving(state, result)
    yield from _mixed(result)
    yield from _swept(case, state, result)


def is_slow(state: FilmState) -> bool:
    """Whether sweeps of this film take seconds."""
    return bool(state.solution.pressure.size > SLOW)


def _at_rest(case: FilmCase, state: FilmState, remark: str = "") -> Iterator[Painted]:
    from babbitt.kinds.journal.film.field import field_of
    from babbitt.kinds.journal.report import film_maps, film_polar

    field = field_of(state.solution, case.load_angle - math.pi)
    yield (
        "pressure-map",
        "Pressure (above) and film thickness (below) over the unrolled bore. Blank: grooves, pockets and holes; "
        "hatched within the broken line: the film is ruptured; crosses: highest pressure, thinnest film." + remark,
        film_maps.unrolled(case, state.solution, field),
        True,
    )
    yield (
        "pressure-polar",
        "Pressure in the mid-plane on the bore, against the rotation axis; the clearance is enlarged.",
        film_polar.polar(case, state.solution, field),
        False,
    )


def _temperatures(case: FilmCase, state: FilmState) -> Iterator[Painted]:
    if state.thermal is None:
        return
    from babbitt.kinds.journal.film.field import field_of
    from babbitt.kinds.journal.report import film_temperature

    thermal, walls = state.thermal, case.heat.walls if case.heat is not None else None
    field = field_of(thermal.film, case.load_angle - math.pi)
    cut = film_temperature.describe_place(thermal)
    yield (
        "temperature-map",
        f"Temperature over the unrolled bore, mean across the gap (above), and across the gap {cut} "
        "(below; upwards: the journal). Cross: the hottest place. Blank: grooves, pockets and holes, with "
        "their mixing temperature; hatched: the film is ruptured.",
        film_temperature.unrolled(case, thermal, field),
        True,
    )
    yield (
        "temperature-through",
        f"Temperature through film and bush {cut}, seen against the rotation axis; the film is drawn thick, bush "
        "and housing to scale. Cross: the hottest place; the arrow is the load.",
        film_temperature.through(case, thermal, walls.bush if walls is not None else None),
        False,
    )
    yield (
        "heat-split",
        "Where the heat generated in the film goes.",
        film_temperature.split(thermal),
        False,
    )
    yield (
        "centre-line",
        "Pressure and temperatures along the middle of the width. Grey: grooves, pockets and holes; broken: the "
        "load direction.",
        film_temperature.along(case, thermal, field),
        True,
    )


def _surface(case: FilmCase, state: FilmState) -> Iterator[Painted]:
    from babbitt.kinds.journal.film.field import field_of
    from babbitt.kinds.journal.report import film_maps

    field = field_of(state.solution, case.load_angle - math.pi)
    yield "pressure-surface", "Pressure over the unrolled bore.", film_maps.surface(field), True


def _moving(state: FilmState, result: Result) -> Iterator[Painted]:
    from babbitt.kinds.journal.report import film_orbit

    if "orbit" in result.arrays:
        yield (
            "orbit",
            "Orbit of the journal under the changing load within the room that the bore leaves it, named by the "
            "angle that the journal has turned; the cross is its place under the steady load alone. Beside it the "
            "least film thickness and the size of the load over one cycle. Filled: the thinnest film.",
            film_orbit.orbit(state, result),
            True,
        )


def _mixed(result: Result) -> Iterator[Painted]:
    if result.arrays.get("stribeck"):
        from babbitt.kinds.journal.report.stribeck import CAPTION, stribeck

        yield "stribeck", CAPTION, stribeck(result), False


def _swept(case: FilmCase, state: FilmState, result: Result) -> Iterator[Painted]:
    from babbitt.kinds.journal.film.unloaded import is_unloaded
    from babbitt.kinds.journal.report import film_curves, film_stability
    from babbitt.kinds.journal.study.locus import locus_over_load, locus_over_speed
    from babbitt.kinds.journal.study.stability_map import stability_map
    from babbitt.report.progress import shown

    if case.cavitation is Cavitation.HALF_SOMMERFELD:
        return  # a film without stiffness and damping
    if is_unloaded(case, state):
        return  # no load to vary

    beside = "."
    if state.thermal is not None:
        beside = ", whose film has its own temperatures; the lines are films of one viscosity and pass beside it."
    by_load = locus_over_load(case, state, watch=shown(f"{case.name}: over the load"))
    by_speed = locus_over_speed(case, state, watch=shown(f"{case.name}: over the speed"))
    yield (
        "journal-locus",
        "Journal centre over the load (line) and, from a quarter to two and a half times the speed, over the "
        f"speed (broad, pale), within the room that the bore leaves it, {KEPT}. Filled: the operating point"
        + beside,
        film_curves.locus(case, state, by_load, by_speed),
        False,
    )
    yield (
        "coefficients",
        f"Stiffness and damping over the speed at the given load, {KEPT}; below, the same films without dimension "
        "over the Sommerfeld number. Filled: the operating point" + beside,
        film_curves.coefficients(state, result, by_speed),
        True,
    )
    whose = "of the given mass" if case.rotor_mass is not None else "whose weight is the load"
    shaft = "a rigid rotor" if case.shaft_stiffness is None else "a rotor on its elastic shaft"
    found = stability_map(case, state, watch=shown(f"{case.name}: stability map"))
    yield (
        "stability-map",
        f"Left: where {shaft} {whose} whirls (grey), over load and speed, {KEPT}; thin lines: the critical mass "
        "as a multiple of the mass m of the rotor. Right: the critical mass without dimension over the Sommerfeld "
        "number, for loads at the given speed. Filled: the operating point.",
        film_stability.stability(case, state, found, by_load),
        True,
    )
