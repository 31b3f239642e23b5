"""Warnings: where the result leaves the ground on which the standard stands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from babbitt.notices import Notice
from babbitt.results import Check
from babbitt.standards.iso7902.film import Film, surface_speed
from babbitt.standards.iso7902.model import Curves, DesignCase
from babbitt.standards.iso7902.screening import ROTORDYNAMIC_CHECK_ABOVE, WHIRL_FEARED_BELOW, Transition
from babbitt.standards.iso7902.supply import FIT_RANGE, CircumferentialGroove, Holes, Pockets

STANDARD_WIDTH_RATIOS = (0.125, 1.0)
"""Range of B/D in the tables of the standard."""

CURVES_FROM = 0.01
"""Eccentricity ratio at which the computed characteristics begin."""

RIGID_FILM_UP_TO = 0.95
"""Eccentricity ratio above which the rigid isoviscous film is too simple."""


def doubts_of(
    case: DesignCase, film: Film, values: Mapping[str, float], checks: tuple[Check, ...], change: Transition | None
) -> tuple[Notice, ...]:
    """All warnings that this operating point deserves."""
    return (
        *case.doubts,
        *_of_method(case, film, values),
        *_of_supply(case, film),
        *_of_running(case, values, checks, change),
    )


def _of_method(case: DesignCase, film: Film, values: Mapping[str, float]) -> Iterator[Notice]:
    reynolds, critical = values["film_reynolds_number"], values["critical_reynolds_number"]
    if reynolds > critical:
        yield Notice("W101", f"film Reynolds number {reynolds:.0f} > {critical:.0f} = 41.3 sqrt(D/C) (ISO 7902-1)")
    least, most = STANDARD_WIDTH_RATIOS
    if not least <= case.bearing.width_ratio <= most:
        ratio = case.bearing.width_ratio
        yield Notice("W102", f"B/D = {ratio:.3g} lies outside {least:g} to {most:g} of ISO 7902-2")
    if case.curves is Curves.CLOSED_FORM:
        yield Notice("W113", "closed forms of DIN 31652: up to 7 % in So and 2.5° in attitude angle")
    coldest, hottest = case.lubricant.temperature_range
    if not coldest <= film.temperature <= hottest:
        yield Notice(
            "W107",
            f"T_eff = {film.temperature - 273.15:.1f} °C lies outside {coldest - 273.15:.0f} to "
            f"{hottest - 273.15:.0f} °C, for which {case.lubricant.name} is described",
        )
    leaving = values.get("outlet_temperature", film.temperature)
    if case.oil_supply is not None and leaving < case.oil_supply.temperature - 1e-6:
        colder = case.oil_supply.temperature - leaving
        yield Notice("W118", f"the oil leaves at {leaving - 273.15:.1f} °C, {colder:.1f} K colder than it enters")
    if film.eccentricity_ratio < CURVES_FROM:
        yield Notice("W119", f"ε = {film.eccentricity_ratio:.2g} < {CURVES_FROM:g}, the first node of the tables")
    if case.bearing_speed:
        yield Notice("W114", "the bearing rotates; friction power counts the journal speed only")
    if film.eccentricity_ratio > RIGID_FILM_UP_TO:
        yield Notice("W116", f"ε = {film.eccentricity_ratio:.3f} > {RIGID_FILM_UP_TO:g}, end of the rigid film")


def _of_supply(case: DesignCase, film: Film) -> Iterator[Notice]:
    element = case.bearing.supply_element
    if film.feed is not None and film.feed.starved:
        yield Notice("W111", "losses in tubes and holes use up the whole supply pressure; supply flow taken as 0")
    if element is None:
        return
    if isinstance(element, Holes | Pockets):
        s = element.relative_width(case.bearing.width)
        if not FIT_RANGE[0] - 1e-9 <= s <= FIT_RANGE[1] + 1e-9:
            bound = FIT_RANGE[0] if s < FIT_RANGE[0] else FIT_RANGE[1]
            yield Notice(
                "W103",
                f"relative width {s:.3f} of the supply element lies outside {FIT_RANGE[0]:g} to {FIT_RANGE[1]:g}; "
                f"{bound:g} was used",
            )
    if isinstance(element, CircumferentialGroove):
        yield Notice("W106", "the load number was formed with the whole width; the groove leaves two lands")


def _of_running(
    case: DesignCase, values: Mapping[str, float], checks: tuple[Check, ...], change: Transition | None
) -> Iterator[Notice]:
    eccentricity = values["eccentricity_ratio"]
    clearance, least = values["operating_relative_clearance"], values["stability_relative_clearance"]
    if eccentricity < WHIRL_FEARED_BELOW:
        yield Notice("W108", f"ε = {eccentricity:.2f} < {WHIRL_FEARED_BELOW:g}: whirl is possible (Dmitriev)")
    elif clearance < least:
        yield Notice("W108", f"ψ_eff = {clearance * 1e3:.2f} ‰ < {least * 1e3:.2f} ‰: whirl is possible (Orlov)")
    speed = surface_speed(case)
    if speed > ROTORDYNAMIC_CHECK_ABOVE:
        yield Notice("W109", f"surface speed {speed:.1f} m/s > {ROTORDYNAMIC_CHECK_ABOVE:g} m/s")
    too_hot = any(check.code == "C104" and not check.ok for check in checks)
    if case.oil_supply is None and too_hot:
        yield Notice("W110", f"T_B = {values['bearing_temperature'] - 273.15:.0f} °C without pressure feed")
    limit_known = "transition_film_thickness" in values
    if limit_known and change is None:
        yield Notice("W112", "the film limit of the surfaces exceeds the radial clearance: no transition speed")
    elif change is not None and change.beyond_tables:
        yield Notice("W112", "the film limit lies beyond the tables; the transition speed is an upper bound")
    if case.limits.minimum_film_thickness is None and "empirical_film_limit" not in values:
        yield Notice("W115", f"no experience value of h_lim for D = {case.bearing.diameter * 1e3:.4g} mm")
