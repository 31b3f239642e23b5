"""What is to be remarked on a film that was found: its oil, its pressure, its feeds and its margins."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.oil import usable_viscosity
from babbitt.design.own_limits import asked_for_margins, checks_by_experience, missed_but_for_own
from babbitt.design.warnings import (
    warnings_about_film,
    warnings_about_hole,
    warnings_about_pressure,
    warnings_about_running,
)
from babbitt.kinds.journal.feed_pressure import pressed_area, warnings_about_pressing
from babbitt.kinds.journal.film.fuller_film import thinner_film
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.layout import closed_pockets, supply_numbers, without_pressure
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_results import is_notable
from babbitt.kinds.journal.film.unloaded import is_unloaded
from babbitt.kinds.journal.film.values import fills_of, supply_pressures
from babbitt.kinds.journal.one_temperature import (
    checks_of_metal,
    warnings_about_heat_left_out,
    warnings_about_kept_limits,
    warnings_about_margins,
    warnings_about_unknown_metal,
)
from babbitt.reynolds.model import END_DAM
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.stability.whirl_checks import (
    warnings_about_whirl,
)
from babbitt.reynolds.stability.whirl_limits import Whirl

__all__ = ["film_warnings"]

ALMOST_A_TURN = math.radians(359.0)
"""Extent in rad from which a groove surrounds the journal."""

AT_A_LINE = 1e-6
"""Angle in rad within which a load points at a line of supply."""

DRAWN_IN_FROM = 0.02
"""Oil that the sides draw in, over what leaves, from which it is reported."""

OIL_INVENTED_FROM = 0.05
"""Mass balance error above which a film without mass conservation is questioned."""


def film_warnings(
    case: FilmCase, state: FilmState, values: dict[str, float], checks: tuple[Check, ...], whirl: Whirl | None
) -> Iterator[Notice]:
    """What is to be remarked on a film that was found, its values and its checks."""
    yield from case.warnings
    yield from (
        warning
        for warning in warnings_about_film(case, values)
        if warning.code != "W101" or case.turbulence is None
    )
    if state.fed is not None and state.fed.starved:
        yield Notice("W140", values={"fills": fills_of(case, state.fed), "given_flow": values["given_flow"]})
    if case.bearing_speed:
        yield Notice("W114")
    if values["mass_balance_error"] > OIL_INVENTED_FROM:
        yield Notice("W122", values={"share": values["mass_balance_error"]})
    film = state.solution
    if film.side_inflow > DRAWN_IN_FROM * film.leaving_flow:
        yield Notice("W141", values={"side_inflow": film.side_inflow})
    yield from warnings_about_pressure(values["maximum_pressure"])
    yield from _warnings_about_holes(case, state)
    if not _pressed(case, state):
        yield Notice("W124", "no_pressure_left")
    yield from _warnings_about_grooves(case, state, values)
    if case.error_estimate and "stiffness_error" not in values:
        yield Notice("W125")
    if whirl is not None:
        yield from warnings_about_whirl(whirl)
    replaced = checks_by_experience(case, values)
    held = asked_for_margins(checks, replaced)
    if case.heat is None:
        yield from _warnings_about_feed_pressure(case, state, values)
        if case.effective_temperature is None:
            yield from _warnings_about_returned_oil(film)
        if case.fuller is None:
            yield from _warnings_about_one_temperature(case, state, values, held)
    elif case.oil_supply is not None:
        supplied = case.oil_supply.temperature
        yield from warnings_about_kept_limits(held, checks_of_metal(case.limits), supplied)
    unfit = {"W109"} if whirl is not None else set()  # the dynamics of the film are solved for
    if not case.limiting_speeds:
        unfit.add("W112")  # a speed of transition that was not looked for
    yield from (warning for warning in warnings_about_running(case, values, checks) if warning.code not in unfit)
    yield from missed_but_for_own(checks, replaced)


def _warnings_about_one_temperature(
    case: FilmCase, state: FilmState, values: dict[str, float], checks: tuple[Check, ...]
) -> Iterator[Notice]:
    """Estimates of what a film with temperatures of its own may miss, where none is known; else it is solved."""
    metal, viscosity = checks_of_metal(case.limits), usable_viscosity(case.lubricant)
    yield from warnings_about_margins(checks, values, metal, viscosity, thinner_film(case, state))
    yield from warnings_about_unknown_metal(case, checks, values)
    yield from warnings_about_heat_left_out(case, values)


def _warnings_about_holes(case: FilmCase, state: FilmState) -> Iterator[Notice]:
    """The hole that costs most of the supply pressure, if that is notable."""
    supply, film = case.oil_supply, state.solution
    if supply is None or supply.flow is not None:
        return
    numbered = zip(case.bearing.feeds, supply_numbers(case, film.film), strict=True)
    passed = [
        (float(film.supply_flow[number]), feed.bore_hole)
        for feed, number in numbered
        if feed.bore_hole is not None and feed.pressure is None and feed.flow is None
    ]
    if passed:
        flow, diameter = max(passed, key=lambda one: one[0] / one[1] ** 2)
        density = case.lubricant.density(supply.temperature)
        yield from warnings_about_hole(supply, diameter, max(flow, 0.0), density)


def _warnings_about_returned_oil(film: FilmSolution) -> Iterator[Notice]:
    """Oil that a film of one temperature presses back into supplies, whose heat its balance does not know."""
    returned = -float(film.supply_flow[film.supply_flow < 0.0].sum())
    if is_notable(returned, film):
        yield Notice("W148", "one_temperature", {"flow": returned})


def _warnings_about_feed_pressure(case: FilmCase, state: FilmState, values: dict[str, float]) -> Iterator[Notice]:
    """What the pressure of the feeds does that a heat balance of one temperature does not know."""
    fed = [
        (feed, pressure)
        for feed, pressure in zip(case.bearing.feeds, supply_pressures(case, state.solution.film), strict=True)
        if not feed.is_closed
    ]
    if not fed or is_unloaded(case, state) or case.effective_temperature is not None:
        return
    load, towards = values["load"], values["load_angle"]
    x, y = load, 0.0
    for feed, pressure in fed:
        width = case.bearing.width if feed.width is None else feed.width
        force = pressure * pressed_area(case.bearing.diameter, width, feed.extent)
        x -= force * math.cos(feed.angle - towards)
        y -= force * math.sin(feed.angle - towards)
    highest = max(pressure for _, pressure in fed)
    heat_capacity = values["volumetric_heat_capacity"]
    yield from warnings_about_pressing(math.hypot(x, y) / load - 1.0, highest, heat_capacity)


def _pressed(case: FilmCase, state: FilmState) -> bool:
    """Whether oil is pressed through a supply, by pressure or as a flow, or the film is fed nowhere."""
    supply, feed = case.oil_supply, state.feed
    fed = [one for one in case.bearing.feeds if not one.is_closed]
    if not fed or supply is None or supply.flow is not None or feed is None or feed.limit is not None:
        return True  # W111 tells where tubes and holes use up the pressure
    pressures = (feed.element_pressure if one.pressure is None else one.pressure for one in fed)
    return any(one.flow is not None for one in fed) or any(pressure > 0.0 for pressure in pressures)


def _warnings_about_grooves(case: FilmCase, state: FilmState, values: dict[str, float]) -> Iterator[Notice]:
    """Flow of grooves as wide as the bearing, and a load that points into one, or into a pocket."""
    grooves = [feed for feed in case.bearing.feeds if feed.width is None]
    calm = without_pressure(state.solution.film, closed_pockets(case))
    if grooves and calm != state.solution.film:
        flow = values["supply_flow"]
        if math.isnan(flow):
            yield Notice("W121", "unknown")
        elif flow < 0.0:
            yield Notice("W121", "drawn" if state.solution.side_inflow > 0.0 else "less", {"less": -flow})
        else:
            yield Notice("W121", "more", {"supply_flow": flow})
    for pocket in case.bearing.feeds:
        if pocket.width is None or pocket.flow is not None:
            continue
        land = 0.5 * (case.bearing.width - pocket.width) - abs(pocket.axial_position)
        if land < END_DAM * case.bearing.width:
            yield Notice("W121", "pocket", {"width": pocket.width, "land": land, "least": END_DAM})
    for groove in case.bearing.feeds:
        if groove.extent > ALMOST_A_TURN:  # no load could point beside it
            continue
        aside = abs(math.remainder(values["load_angle"] - groove.angle, 2.0 * math.pi))
        if aside <= 0.5 * groove.extent + AT_A_LINE:
            load, first, last = (
                values["load_angle"], groove.angle - 0.5 * groove.extent, groove.angle + 0.5 * groove.extent,
            )  # fmt: skip
            if groove.width is None:
                yield Notice("W143", "groove", {"load_angle": load, "first": first, "last": last})
            else:
                yield Notice("W143", "pocket", {
                    "load_angle": load, "width": groove.width, "first": first, "last": last,
                })  # fmt: skip
