"""Whether the model that counts most keeps the limits that a simpler one of the same bearing keeps."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError, Notice
from babbitt.core.result import Outcome, Result
from babbitt.design.oil import highest_usable
from babbitt.kinds.tilting_pad_journal.model import HeatChoices, PadCase, Thermal
from babbitt.kinds.tilting_pad_journal.one_temperature import asks_own_temperatures
from babbitt.kinds.tilting_pad_journal.sensitivity import worse
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.thermal_film import LEAST_CLEARANCE, pad_heat
from babbitt.reynolds.tilting_pads.bending_mode import bending_stiffness
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pad_heat import PadBending

__all__ = ["ROUNDS", "kept_by_little", "narrowed_pads", "warnings_of_fuller_model", "with_growth"]

KEPT_BY_LITTLE = {"W415", "W416", "W421"}
"""Of limits that are kept by less than what is uncertain of films with temperatures of their own, or of one, and
of stability in the transition to turbulence."""

GROWN = 0.25
"""Share of an assembled clearance that growth may take of pads of one temperature.

Assumption by searches of turbulent pads: models with all that is left out close where growth at the one
temperature takes 29.7 to 61 %, and have films at up to 59 %; the journal is hotter than that."""

MOSTLY_LAMINAR = 0.6
"""Share of the bearing surface that may be turbulent of films, or of those that growth narrows, that are asked for
laminar ones with temperatures of their own, too. Assumption by searches: pads of which these close have shares of
2 to 62 %, or up to 50.5 once they have grown."""

TURBULENT = "W407"
"""Of laminar films of a bearing that is turbulent."""

ROUNDS, SAME_TEMPERATURE = 15, 0.05
"""Growth of pads of one temperature is found anew so often, or until the films would change by less (K)."""

FARTHEST = 5.0
"""Times the rise of the films above the temperature of their growth: the most that this follows it at once."""

Solve = Callable[[PadCase], tuple[Result, PadFilms | None]]


def warnings_of_fuller_model(case: PadCase, films: PadFilms, result: Result, solve: Solve) -> Iterator[Notice]:
    """What a bearing that misses no limit misses once temperatures, conduction, growth and bending count.

    Films with temperatures of their own where the fresh oil is known and films are laminar; else pads of one
    temperature with clearances that growth narrows, bent by pressure.

    Parameters
    ----------
    case : PadCase
        Nothing is asked of one without `fuller` choices.
    films : PadFilms
        Of it.
    result : Result
        Of it, with its checks.
    solve : callable
        Result and films of another case.
    """
    if case.fuller is None or not all(one.ok for one in result.limits):
        return
    if asks_own_temperatures(case, result.values):
        told = tuple(with_own_temperatures(case, case.fuller, result, solve))
    else:
        grown = with_growth(case, case.fuller, films, result, solve)
        told = (*grown.told, *with_laminar_films(case, case.fuller, result, grown.turbulent_share, solve))
    if told:
        yield Notice("W422", "fuller", {"told": told})


def with_own_temperatures(case: PadCase, fuller: HeatChoices, result: Result, solve: Solve) -> Iterator[Notice]:
    """What is worse with temperatures of the films' own; nothing of films that count all."""
    full = with_temperatures(case, fuller)
    if full.thermal is case.thermal and full.heat == case.heat:
        return
    laminar = "" if case.turbulence is None else ", turbulence: laminar"
    said = Notice("W422", "model", {"model": f"thermal: full, deformation: [growth, bending]{laminar}"})
    try:
        found = solve(full)[0]
    except InputError as error:  # its films may need more oil than is supplied
        yield from worse(result, said, None, error.message)
        return
    yield from worse(result, said, found, "")
    yield from kept_by_little(result, said, found)


def with_laminar_films(
    case: PadCase, fuller: HeatChoices, result: Result, grown_share: float, solve: Solve
) -> Iterator[Notice]:
    """What is worse with temperatures of the films' own where most of the bearing surface has laminar films.

    As calculated, or with the turbulent share once growth narrows the gaps. The pads that carry most have the
    narrowest gaps, and these are laminar. That others are not (W407) is known.
    """
    if case.oil_supply is None or min(result.values.get("turbulent_share", 1.0), grown_share) > MOSTLY_LAMINAR:
        return
    for told in with_own_temperatures(case, fuller, result, solve):
        if told.variant != "no_verdict":
            yield told
        elif codes := tuple(one for one in told.values["codes"] if one != TURBULENT):
            yield replace(told, values={**told.values, "codes": codes})


def with_temperatures(case: PadCase, fuller: HeatChoices) -> PadCase:
    """The case with films of their own temperatures among all that takes heat and is deformed."""
    pads = tuple(replace(pad, bending_stiffness=math.inf) for pad in case.bearing.pads)  # they bend by that heat
    return replace(
        case, bearing=replace(case.bearing, pads=pads), thermal=Thermal.FULL, heat=fuller, fuller=None,
        effective_temperature=None, turbulence=None,
    )  # fmt: skip


@dataclass(frozen=True)
class Grown:
    """What is worse with pads that grow, and the share of the bearing surface that is turbulent then, if known."""

    told: tuple[Notice, ...]
    turbulent_share: float = 1.0


def with_growth(case: PadCase, fuller: HeatChoices, films: PadFilms, result: Result, solve: Solve) -> Grown:
    """Pads of one temperature that grow at the temperature of their own films and bend."""
    warm, before, rise_before = films.temperature, math.nan, math.nan
    for _ in range(ROUNDS):
        pads, share = narrowed_pads(case, fuller, warm)
        narrowed = share >= 0.0
        said = Notice("W422", "narrowed" if narrowed else "widened", {"share": abs(share), "temperature": warm})
        if warm >= highest_usable(case.lubricant):
            break
        if share >= 1.0:
            return Grown((Notice("W419", "unsolved", {"end": said, "outcome": Outcome.NO_CLEARANCE.value}),))
        try:
            found, state = solve(replace(case, bearing=replace(case.bearing, pads=pads), fuller=None))
        except InputError as error:  # narrowed pads may need more oil than is supplied
            return Grown(tuple(worse(result, said, None, error.message)))
        told = tuple(worse(result, said, found, ""))
        if state is None:
            return Grown(told)
        rise = state.temperature - warm
        falls = (rise_before - rise) / (warm - before)  # of the rise over the temperature: nan at first
        step = rise if math.isnan(falls) else rise / max(falls, 1.0 / FARTHEST)
        if abs(step) <= SAME_TEMPERATURE or rise == 0.0:
            told = (*told, *kept_by_little(result, said, found))
            if share > GROWN:
                told = (*told, Notice("W422", "grown", {"model": said}))
            return Grown(told, found.values.get("turbulent_share", 1.0))
        before, rise_before, warm = warm, rise, warm + step
    return Grown((Notice("W419", "unsolved", {"end": said, "outcome": Outcome.NOT_CONVERGED.value}),))


def narrowed_pads(case: PadCase, fuller: HeatChoices, warm: float) -> tuple[tuple[TiltingPad, ...], float]:
    """Pads with the clearances that growth leaves at a temperature of the films in K, and that bend by pressure.

    The journal is as warm as the films where its temperature is not given. Clearances that growth uses up become
    `LEAST_CLEARANCE`; besides, the largest share of an assembled clearance that growth takes.
    """
    assert fuller.journal is not None
    heat, bearing = pad_heat(case, fuller, warm), case.bearing.film(1.0, case.journal_speed)
    journal = warm if fuller.journal.temperature is None else fuller.journal.temperature
    pads, shares = [], []
    for number, pad in enumerate(case.bearing.pads):
        narrower, bending = heat.narrowing(bearing, number, journal, warm), heat.bending_of(number)
        assert bending is not None
        shares.append(narrower / pad.assembled_clearance)
        pads.append(replace(
            pad,
            clearance=max(pad.clearance - narrower, LEAST_CLEARANCE),
            assembled_clearance=max(pad.assembled_clearance - narrower, LEAST_CLEARANCE),
            bending_stiffness=pad.bending_stiffness if pad.bends else stiffness_of(case, pad, bending),
        ))  # fmt: skip
    return tuple(pads), max(shares)


def stiffness_of(case: PadCase, pad: TiltingPad, bending: PadBending) -> float:
    """Stiffness of a pad against bending by pressure, N/m."""
    width = case.bearing.width if pad.width is None else pad.width
    return bending_stiffness(pad, 0.5 * case.bearing.diameter + pad.clearance, width, bending.plate_modulus)


def kept_by_little(base: Result, said: Notice, found: Result) -> Iterator[Notice]:
    """Limits that the fuller model keeps by little, and the simpler one by more."""
    before = {check: margin for one in hardly_kept(base) for check, margin in margins(one)}
    kept = tuple(
        one
        for one in hardly_kept(found)
        if any(margin < before.get(check, math.inf) for check, margin in margins(one))
    )
    if kept:
        yield Notice("W422", "little", {"model": said, "kept": kept})


def hardly_kept(result: Result) -> tuple[Notice, ...]:
    """Warnings of limits that are kept by less than what is uncertain."""
    return tuple(one for one in result.warnings if one.code in KEPT_BY_LITTLE)


def margins(warning: Notice) -> Iterator[tuple[str, float]]:
    """Checks that such a warning names, each with its margin; 0 where it tells none."""
    for kept in warning.values["kept"]:
        yield (kept, 0.0) if isinstance(kept, str) else (kept.values["check"], kept.values["margin"])
