"""Whether the model that counts most keeps the limits that a simpler one of the same bearing keeps."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

from babbitt.core.notices import InputError, Notice
from babbitt.core.result import Result
from babbitt.kinds.tilting_pad_journal.model import HeatChoices, PadCase, Thermal
from babbitt.kinds.tilting_pad_journal.sensitivity import worse
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.thermal_film import LEAST_CLEARANCE, pad_heat
from babbitt.reynolds.tilting_pads.bending_mode import bending_stiffness
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pad_heat import PadBending

__all__ = ["narrowed_pads", "warnings_of_fuller_model"]

KEPT_BY_LITTLE = "W415"
"""Of limits of bores that are kept by less than what is uncertain of films with temperatures of their own."""

ROUNDS, SAME_TEMPERATURE = 10, 0.5
"""Growth of pads of one temperature is found anew so often, or until the films are as warm as before (K)."""


def warnings_of_fuller_model(
    case: PadCase, films: PadFilms, result: Result, solve: Callable[[PadCase], tuple[Result, PadFilms | None]]
) -> Iterator[Notice]:
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
    if case.asks_own_temperatures:
        full = with_temperatures(case, case.fuller)
        if full.thermal is case.thermal and full.heat == case.heat:
            return
        said = Notice("W422", "model", {"model": "thermal: full, deformation: [growth, bending]"})
        try:
            found, refusal = solve(full)[0], ""
        except InputError as error:  # its films may need more oil than is supplied
            found, refusal = None, error.message
    else:
        said, found = grown(case, case.fuller, films, solve)
        refusal = ""
    if told := (*worse(result, said, found, refusal), *kept_by_little(result, said, found)):
        yield Notice("W422", "fuller", {"told": told})


def with_temperatures(case: PadCase, fuller: HeatChoices) -> PadCase:
    """The case with films of their own temperatures among all that takes heat and is deformed."""
    pads = tuple(replace(pad, bending_stiffness=math.inf) for pad in case.bearing.pads)  # they bend by that heat
    return replace(
        case, bearing=replace(case.bearing, pads=pads), thermal=Thermal.FULL, heat=fuller, fuller=None,
        effective_temperature=None,
    )  # fmt: skip


def grown(
    case: PadCase,
    fuller: HeatChoices,
    films: PadFilms,
    solve: Callable[[PadCase], tuple[Result, PadFilms | None]],
) -> tuple[Notice, Result]:
    """Pads of one temperature, grown at the temperature of their own films, and bent by pressure."""
    state: PadFilms | None = films
    for _ in range(ROUNDS):
        assert state is not None
        warm = state.temperature
        pads = narrowed_pads(case, fuller, warm)
        share = 1.0 - min(new.assembled_clearance / pad.assembled_clearance
                          for new, pad in zip(pads, case.bearing.pads, strict=True))  # fmt: skip
        said = Notice("W422", "narrowed", {"share": share, "temperature": warm})
        found, state = solve(replace(case, bearing=replace(case.bearing, pads=pads), fuller=None))
        if state is None or abs(state.temperature - warm) <= SAME_TEMPERATURE:
            break
    return said, found


def narrowed_pads(case: PadCase, fuller: HeatChoices, warm: float) -> tuple[TiltingPad, ...]:
    """Pads with the clearances that growth leaves at a temperature of the films in K, and that bend by pressure.

    The journal is as warm as the films where its temperature is not given. Clearances that growth uses up become
    `LEAST_CLEARANCE`, in which there is no film.
    """
    assert fuller.journal is not None
    heat, bearing = pad_heat(case, fuller, warm), case.bearing.film(1.0, case.journal_speed)
    journal = warm if fuller.journal.temperature is None else fuller.journal.temperature
    pads = []
    for number, pad in enumerate(case.bearing.pads):
        narrower, bending = heat.narrowing(bearing, number, journal, warm), heat.bending_of(number)
        assert bending is not None
        pads.append(replace(
            pad,
            clearance=max(pad.clearance - narrower, LEAST_CLEARANCE),
            assembled_clearance=max(pad.assembled_clearance - narrower, LEAST_CLEARANCE),
            bending_stiffness=pad.bending_stiffness if pad.bends else stiffness_of(case, pad, bending),
        ))  # fmt: skip
    return tuple(pads)


def stiffness_of(case: PadCase, pad: TiltingPad, bending: PadBending) -> float:
    """Stiffness of a pad against bending by pressure, N/m."""
    width = case.bearing.width if pad.width is None else pad.width
    modulus = bending.elastic_modulus / (1.0 - bending.poisson_ratio**2)
    return bending_stiffness(pad, 0.5 * case.bearing.diameter + pad.clearance, width, modulus)


def kept_by_little(base: Result, said: Notice, found: Result | None) -> Iterator[Notice]:
    """Limits of bores that the fuller model keeps by less than what is uncertain, and the simpler one by more."""
    codes = (KEPT_BY_LITTLE,)
    if found is not None and {*codes} & {*found.questioning_codes} - {*base.questioning_codes}:
        yield Notice("W422", "little", {"model": said, "codes": codes})
