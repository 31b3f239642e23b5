"""What is doubtful about a tilting-pad bearing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS, NO_BOUNDS, TEMPERATURE_CHECKS, Bounds
from babbitt.design.kept_limits import about_kept_film, kept_by_little
from babbitt.design.warnings import (
    warnings_about_heat_balance,
    warnings_about_heating,
    warnings_about_pressure,
)
from babbitt.kinds.tilting_pad_journal.dynamics import LARGEST_FIT_ERROR, PadDynamics, with_pedestal
from babbitt.kinds.tilting_pad_journal.level_one import STABILITY_CHECKS
from babbitt.kinds.tilting_pad_journal.margins import (
    LIGHTLY_LOADED,
    NEAR_FOLD,
    PadMargin,
    loaded_at_fold,
    loading_preload,
)
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.values import ramp_share
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.pivots import HertzContact, LineContact

__all__ = [
    "about_stability_on_the_ramp",
    "starved_bounds",
    "warnings_about_kept_limits",
    "warnings_of_solution",
]

BORE_CHECKS = ("C104", "C108", "C404", "C405")
"""Limits of bores: of the case, of the metal, alarm and trip of a probe."""

STARVED_CHECKS = (*FILM_CHECKS, *TEMPERATURE_CHECKS, "C111", "C404", "C405")
"""What pads that get less oil than they draw in keep the less, the thinner and hotter their films are."""

WIDE_CONTACT = 0.05
"""Half width of a line contact over the radius of the pivot beyond which the half-spaces of Hertz end."""

TINY = 1e-9
"""Load of a bearing in N that stands for none."""

SETTLING = "W146"
"""Of a balance left open by less than a thousandth."""

OIL_INVENTED_FROM = 0.05
"""Mass balance error above which films that begin anew without oil are reported."""

HOTTEST = ("maximum_temperature", "trailing_temperature", "outlet_temperature", "effective_temperature")
"""Temperatures of the oil, of which the first known counts as the hottest."""


def warnings_of_solution(
    case: PadCase, films: PadFilms, dynamics: PadDynamics, margins: tuple[PadMargin, ...],
    values: Mapping[str, float],
) -> Iterator[Notice]:  # fmt: skip
    """Warnings about a solved bearing."""
    yield from about_unloaded_pads(case, films, margins)
    yield from about_light_pads(case, films, dynamics, margins)
    if dynamics.fit is not None and dynamics.fit.error > LARGEST_FIT_ERROR:
        ratios = dynamics.fit.whirl_ratios
        yield Notice("W403", values={
            "fit_error": dynamics.fit.error, "least": float(ratios.min()), "most": float(ratios.max()),
        })  # fmt: skip
    yield from about_supply(case, films)
    yield from about_carry_over(case, films)
    if case.turbulence is None:
        yield from about_laminar_films(values)
    yield from about_ramp(films)
    yield from about_contacts(films)
    if films.solution.indifferent:
        yield Notice("W411")
    if abs(values["mass_balance_error"]) > OIL_INVENTED_FROM:
        yield Notice("W412", values={"mass_balance_error": abs(values["mass_balance_error"])})
    yield from warnings_about_pressure(values["maximum_pressure"])
    hottest = next(values[name] for name in HOTTEST if name in values)
    supplied = None if case.oil_supply is None else case.oil_supply.temperature
    yield from warnings_about_heating(hottest, supplied, case.lubricant)
    if films.temperature < case.lubricant.temperature_range[0]:
        yield Notice("W107", "pads", {
            "effective_temperature": films.temperature, "lubricant": case.lubricant.name,
        })  # fmt: skip
    yield from about_heat_balance(films, values)


def about_heat_balance(films: PadFilms, values: Mapping[str, float]) -> Iterator[Notice]:
    """A heat balance left open; that of films with their own temperatures never closes to round-off."""
    for one in warnings_about_heat_balance(values.get("energy_balance_error", 0.0)):
        if films.thermal is None or one.code != SETTLING:
            yield one


def about_unloaded_pads(case: PadCase, films: PadFilms, margins: tuple[PadMargin, ...]) -> Iterator[Notice]:
    """Pads that carry nothing, all in one notice, and pads that nearly do so."""
    light = {one.number + 1 for one in films.solution.light}
    bare = [one for one in margins if not one.loaded and one.number not in light]
    told = tuple(about_unloaded(case, films, one) for one in bare)
    needed = [one.values["needed"] for one in told if "needed" in one.values]
    if len(told) == 1:
        yield told[0]
    elif told and len(needed) == len(told):
        yield Notice("W401", "all", {"pads": told, "needed": max(needed)})
    elif told:
        yield Notice("W401", "some", {"pads": told})
    for one in margins:
        if not one.loaded:
            continue
        share = films.solution.pads[one.number - 1].load / max(films.load, TINY)
        if one.margin < NEAR_FOLD or share < LIGHTLY_LOADED:
            yield from about_nearly_unloaded(one, share)


def about_unloaded(case: PadCase, films: PadFilms, margin: PadMargin) -> Notice:
    """A pad that carries nothing, with the preload that would load it where the journal stands."""
    pad = case.bearing.pads[margin.number - 1]  # preload is given of pads that have not grown
    needed = loading_preload(pad, films.solution, margin.fold)
    if needed > pad.preload:
        return Notice("W401", "needed", {"pad": margin.number, "needed": needed, "preload": pad.preload})
    # its fold was not found, or is another in films with temperatures of their own
    return Notice("W401", "unknown", {"pad": margin.number})


def about_nearly_unloaded(margin: PadMargin, share: float) -> Iterator[Notice]:
    """A pad that carries little or may soon carry nothing; one that unloads nowhere has no margin."""
    if not margin.margin < NEAR_FOLD:
        yield Notice("W402", light_variant(margin), {"pad": margin.number, "share": share})
        return
    ratio = margin.fold + margin.margin
    yield Notice("W402", "near", {
        "pad": margin.number, "share": share, "ratio": ratio, "margin": margin.margin, "fold": margin.fold,
    })  # fmt: skip


def light_variant(margin: PadMargin) -> str:
    """Which message fits a pad that carries little but is not known to be near its fold."""
    if math.isnan(margin.margin):
        return "unknown"
    return "kept" if math.isinf(margin.margin) else "light"


def about_light_pads(
    case: PadCase, films: PadFilms, dynamics: PadDynamics, margins: tuple[PadMargin, ...]
) -> Iterator[Notice]:
    """Pads without equilibrium about their folds, with what differs when they carry."""
    solution = films.solution
    for one in solution.light:
        pad, share = one.number + 1, one.need / films.load
        if math.isnan(one.least):
            yield Notice("W417", "heated", {"pad": pad, "need": one.need, "share": share})
            continue
        other = None if films.thermal is not None else loaded_at_fold(case, solution, margins[one.number])
        if other is None or not other.outcome.solved:  # folds are those of films of one temperature
            yield Notice("W417", "alone", {"pad": pad, "need": one.need, "share": share, "least": one.least})
            continue
        carrying = condensed_at(with_pedestal(case, full_coefficients(other), other), 1.0)
        thinner = other.minimum_film_thickness / solution.minimum_film_thickness - 1.0
        yield Notice("W417", "compared", {
            "pad": pad, "need": one.need, "share": share, "least": one.least,
            "stiffness": largest_difference(carrying.stiffness, dynamics.synchronous.stiffness),
            "damping": largest_difference(carrying.damping, dynamics.synchronous.damping),
            "film": abs(thinner),
        })  # fmt: skip


def largest_difference(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Largest difference of entries over the largest entry of the other matrix."""
    return float(np.abs(one - other).max() / np.abs(other).max())


def warnings_about_kept_limits(films: PadFilms, checks: Sequence[Check]) -> Iterator[Notice]:
    """Limits of bores and films that are kept by less than their films can tell."""
    if films.thermal is None:
        return
    yield from about_kept_film("W415", checks)
    of_bore = [check for check in checks if is_of_bore(check)]
    near = kept_by_little(of_bore, films.thermal.heat.supply_temperature)
    if near:
        yield Notice("W415", "kept", {
            "uncertain": max(one.uncertain for one in near),
            "kept": tuple(
                Notice("W415", "temperature", {"margin": one.margin, "check": one.check}) for one in near
            ),
        })  # fmt: skip


def is_of_bore(check: Check) -> bool:
    """Whether a limit is one of a bore: where the case sets none, C104 holds the outlet to a general one."""
    return check.code in BORE_CHECKS and check.quantity != "outlet_temperature"


def starved_bounds(case: PadCase, films: PadFilms) -> Bounds:
    """Checks that films flatter which get less oil than they draw in: a miss is one, keeping them says nothing."""
    if not any(about_supply(case, films)):
        return NO_BOUNDS
    return {code: Notice(code, "starved_pads") for code in STARVED_CHECKS}


def about_supply(case: PadCase, films: PadFilms) -> Iterator[Notice]:
    """A supply that gives less than the films draw in."""
    given = None if case.oil_supply is None else case.oil_supply.flow
    if given is not None and given < films.fresh_flow:
        over = case.feed.carry_over
        yield Notice("W405", values={"given": given, "wanted": films.fresh_flow, "carry_over": over})


def about_carry_over(case: PadCase, films: PadFilms) -> Iterator[Notice]:
    """Pads that are brought more hot oil than they take, each with the pad that brings it."""
    if films.thermal is None:
        return
    states, over = films.solution.pads, case.feed.carry_over
    step = -1 if films.solution.bearing.sense > 0.0 else 1
    for place, pad in enumerate(films.thermal.temperatures):
        if pad.is_capped:
            before = (place + step) % len(states)
            share = () if over >= 1.0 else (Notice("W404", "share", {"carry_over": over}),)
            yield Notice("W404", "capped", {
                "pad": place + 1, "taken": states[place].inflow,
                "before": before + 1, "sent": states[before].outflow, "share": share,
                "most": states[place].inflow / states[before].outflow,
            })  # fmt: skip


def about_laminar_films(values: Mapping[str, float]) -> Iterator[Notice]:
    """The Reynolds number at the machined clearance against the end of laminar films, and that at the assembled
    one, which pads with preload have at their pivots."""
    reynolds, critical = values["film_reynolds_number"], values["critical_reynolds_number"]
    if reynolds > critical:
        machined, assembled = values["largest_pad_clearance"], values["assembled_clearance"]
        yield Notice("W407", values={
            "film_reynolds_number": reynolds, "critical_reynolds_number": critical, "machined": machined,
            "assembled": assembled, "preload": values["preload"], "at_assembled": reynolds * assembled / machined,
            "critical_assembled": critical * math.sqrt(machined / assembled),
        })  # fmt: skip


def about_ramp(films: PadFilms) -> Iterator[Notice]:
    """Loaded pads with films in transition to turbulence, of which coefficients take the slope."""
    law = films.solution.bearing.turbulence
    if law is not None and (share := ramp_share(films.solution, law)) > 0.0:
        yield Notice("W420", values={"share": share, "onset": law.onset, "end": law.end})


def about_stability_on_the_ramp(checks: Sequence[Check], told: Sequence[Notice]) -> Iterator[Notice]:
    """Limits of stability that are kept with coefficients of the assumed ramp, of which W420 tells."""
    kept = tuple(one.code for one in checks if one.code in STABILITY_CHECKS and one.ok)
    if kept and any(one.code == "W420" for one in told):
        yield Notice("W421", values={"kept": kept})


def about_contacts(films: PadFilms) -> Iterator[Notice]:
    """Contacts that begin to yield, and line contacts so wide that the law of Hertz ends."""
    for number, (pad, state) in enumerate(zip(films.solution.bearing.pads, films.solution.pads, strict=True), 1):
        if isinstance(pad.pivot, HertzContact) and state.load > 0.0:
            pressure, bearable = pad.pivot.contact_pressure(state.load), pad.pivot.bearable_pressure
            if pressure > bearable:
                yield Notice("W418", values={
                    "pad": number, "pressure": pressure, "bearable": bearable,
                    "strength": pad.pivot.yield_strength,
                })  # fmt: skip
        if isinstance(pad.pivot, LineContact) and state.load > 0.0:
            half = pad.pivot.half_width(state.load)
            if half > WIDE_CONTACT * pad.pivot.radius:
                yield Notice("W408", values={
                    "pad": number, "half_width": half, "radius": pad.pivot.radius,
                })  # fmt: skip
