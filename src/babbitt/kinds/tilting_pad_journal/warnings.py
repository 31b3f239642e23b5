"""What is doubtful about a tilting-pad bearing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.warnings import (
    warnings_about_heat_balance,
    warnings_about_heating,
    warnings_about_pressure,
)
from babbitt.kinds.tilting_pad_journal.dynamics import LARGEST_FIT_ERROR, PadDynamics
from babbitt.kinds.tilting_pad_journal.film import PadFilms
from babbitt.kinds.tilting_pad_journal.margins import NEAR_FLUTTER, PadMargin, loading_preload
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.reynolds.tilting_pads.pivots import LineContact

__all__ = ["warnings_of_solution"]

WIDE_CONTACT = 0.05
"""Half width of a line contact over the radius of the pivot beyond which the half-spaces of Hertz end."""

OIL_INVENTED_FROM = 0.05
"""Mass balance error above which films that begin anew without oil are told."""

HOTTEST = ("maximum_temperature", "trailing_temperature", "outlet_temperature", "effective_temperature")
"""Temperatures of the oil, of which the first known counts as the hottest."""


def warnings_of_solution(
    case: PadCase, films: PadFilms, dynamics: PadDynamics, margins: tuple[PadMargin, ...],
    values: Mapping[str, float],
) -> Iterator[Notice]:  # fmt: skip
    """Warnings about a solved bearing."""
    yield from about_unloaded_pads(films, margins)
    if dynamics.fit is not None and dynamics.fit.error > LARGEST_FIT_ERROR:
        yield Notice("W403", f"misfit {dynamics.fit.error:.1%} over whirl ratios from "
                     f"{dynamics.fit.whirl_ratios.min():g} to {dynamics.fit.whirl_ratios.max():g}")  # fmt: skip
    yield from about_supply(case, films)
    yield from about_laminar_films(values)
    yield from about_contacts(films)
    if films.solution.indifferent:
        yield Notice("W411", "the loaded pads hold the journal in one direction alone")
    if abs(values["mass_balance_error"]) > OIL_INVENTED_FROM:
        yield Notice("W412", f"{abs(values['mass_balance_error']):.0%} of the oil that enters the pads comes from "
                     "nowhere")  # fmt: skip
    yield from warnings_about_pressure(values["maximum_pressure"])
    hottest = next(values[name] for name in HOTTEST if name in values)
    supplied = None if case.oil_supply is None else case.oil_supply.temperature
    yield from warnings_about_heating(hottest, supplied, case.lubricant)
    if films.temperature < case.lubricant.temperature_range[0]:
        yield Notice("W107", f"T_eff = {films.temperature - ZERO_CELSIUS:.1f} °C, colder than the data of "
                     f"{case.lubricant.name}")  # fmt: skip
    yield from warnings_about_heat_balance(values.get("energy_balance_error", 0.0))


def about_unloaded_pads(films: PadFilms, margins: tuple[PadMargin, ...]) -> Iterator[Notice]:
    """Pads that carry nothing, and pads that nearly do so."""
    for one in margins:
        pad = films.solution.bearing.pads[one.number - 1]
        if not one.loaded:
            advice = ""
            if one.fold == 0.0:  # a centred pivot
                needed = loading_preload(pad, films.solution)
                advice = f"; above a preload of {needed:.3f} it would carry (it has {pad.preload:.3f})"
            yield Notice("W401", f"pad {one.number}{advice}")
        elif one.margin < NEAR_FLUTTER:
            yield Notice("W402", f"pad {one.number} stands at ε_p = {one.fold + one.margin:.3f}, "
                         f"{one.margin:.3f} from {one.fold:.3f}, where it unloads")  # fmt: skip


def about_supply(case: PadCase, films: PadFilms) -> Iterator[Notice]:
    """A supply that gives less than the films draw in."""
    given = None if case.oil_supply is None else case.oil_supply.flow
    if given is not None and given < films.fresh_flow:
        wanted = f"the films draw in {films.fresh_flow * 6e4:.3g} L/min besides the {case.feed.carry_over:.0%}"
        yield Notice("W405", f"supply.flow is {given * 6e4:.3g} L/min, {wanted} carried over")


def about_laminar_films(values: Mapping[str, float]) -> Iterator[Notice]:
    """The Reynolds number at the machined clearance against the end of laminar films."""
    reynolds, critical = values["film_reynolds_number"], values["critical_reynolds_number"]
    if reynolds > critical:
        yield Notice("W407", f"Re = {reynolds:.0f} > {critical:.0f} = 41.3 sqrt(R/c_p)")


def about_contacts(films: PadFilms) -> Iterator[Notice]:
    """Line contacts so wide that the law of Hertz ends."""
    for number, (pad, state) in enumerate(zip(films.solution.bearing.pads, films.solution.pads, strict=True), 1):
        if isinstance(pad.pivot, LineContact) and state.load > 0.0:
            half = pad.pivot.half_width(state.load)
            if half > WIDE_CONTACT * pad.pivot.radius:
                yield Notice("W408", f"pad {number}: half width {1e3 * half:.3g} mm of a pivot of radius "
                             f"{1e3 * pad.pivot.radius:.4g} mm")  # fmt: skip
