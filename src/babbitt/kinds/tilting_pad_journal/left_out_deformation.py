"""What growth of shaft and pads and bending of pads would take, of bearings that are solved without them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.kinds.tilting_pad_journal.model import PadCase, Thermal
from babbitt.kinds.tilting_pad_journal.one_temperature import LESS_STABLE, kept_stability
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.thermal_film import pad_heat
from babbitt.kinds.tilting_pad_journal.warnings import is_of_bore
from babbitt.reynolds.tilting_pads.bending_mode import edge_under_heat, edge_under_load

__all__ = ["CLOSES", "left_out_bending", "left_out_growth", "warnings_about_left_out_deformation"]

CLOSES, WITH_BENDING = 0.22, 0.5
"""Share of the assembled clearance that growth takes at the temperatures of films without it, from which on it may
leave no film: narrower, the films warm further; with bending that moves edges by w of the clearance c less by
0.5 w/c of it.

Assumption by measurement of the 397 random bearings below and of 177 before: of all that growth closes, with or
without bending of w below c, they are more."""

THINNER_BY_GROWTH, HOTTER_BY_GROWTH, LESS_STABLE_BY_GROWTH = 1.5, 1.5, 3.0
"""Shares of the film thickness, of the rise of bores above the fresh oil, and of log decrement and threshold
cross-coupling that growth takes, or adds, over what it takes of the clearance (assumption by measurement: of the
same bearings 99 in 100 lose no more; of the 177 before some decrements above 1, up to 8 times the share). Of 116
whose clearances a housing of aluminium widens, two with decrements near zero lose all stability, and two with
shares below 0.005 up to 4 % of the film."""

THINNER_BY_BENDING, LESS_STABLE_BY_BENDING, LEAST_BY_BENDING = 0.15, 2.5, 0.1
"""What bending takes, by what it would move the edge of a pad by, w (`left_out_bending`): h falls to
h/(1 + 0.15 w/h); of log decrement and threshold cross-coupling it leaves 0.9/(1 + 2.5 w/c), c the assembled
clearance.

Assumption by measurement of 397 random bearings (three to six pads on all pivots, 20 to 800 mm, pads of 6 to 20 %
of the diameter of steel and of bronze of 100 GPa, 3 to 95 m/s, 0.15 to 4 MPa, ISO VG 22 to 100, assembled
clearances of 0.8 to 2.6 permille, 50 to 1500 W/(m2 K) on the backs): of those with w below c 5 of 332 lose more of
the film, most of them nearly concentric, 3 of 218 of the decrement and 4 of 131 of the cross-coupling; of those
that lack growth, too, none of 306, none of 198 and 1 of 118 more than by both."""

FOLDS = 1.0
"""w/c from which on bending is warned of whatever the limits: of some such bearings it leaves no film."""

UNMOVED = 1e-3
"""Share of the clearance below which growth is not named."""

OF_FILM = (*FILM_CHECKS, "C111")
"""Limits of the film thickness, that of transition among them."""


@dataclass(frozen=True)
class _LeftOut:
    """Shares that may be less: of stability and film; and by which bores may be hotter above the fresh oil."""

    stable: float
    film: float
    hotter: float


def warnings_about_left_out_deformation(
    case: PadCase, films: PadFilms, checks: Sequence[Check], values: Mapping[str, float]
) -> Iterator[Notice]:
    """Whether growth or bending that is left out may close the clearance or miss a limit that is kept without.

    Of pads of one temperature also with what temperatures of their own take of the stability: limits must hold
    with all of it.

    Parameters
    ----------
    case : PadCase
    films : PadFilms
    checks : sequence of Check
    values : Mapping of str to float
        Named results.
    """
    given = case.fuller.journal
    assert given is not None
    found = values.get("journal_temperature", math.nan)
    journal = given.temperature or (films.temperature if math.isnan(found) else found)
    pads = max(journal, films.temperature)  # beside a journal that is kept cold they are as warm as their films
    share, bend = left_out_growth(case, journal, pads), left_out_bending(case, films, pads)
    over_clearance = bend / case.bearing.assembled_clearance
    if over_clearance > FOLDS and share <= CLOSES:
        yield Notice("W422", "folds", {"bend": over_clearance, "advice": _advice(case, "growth", "bending")})
        return
    if share > 0.0 and share / CLOSES + WITH_BENDING * over_clearance > 1.0:
        asked = ("growth",) if share > CLOSES else ("growth", "bending")
        yield Notice("W422", "closes", {"share": share, "advice": _advice(case, *asked)})
        return
    moved = abs(share)  # wider clearances take of the stability, too, and less of the film
    stable = max(1.0 - LESS_STABLE_BY_GROWTH * moved, 0.0) / (1.0 + LESS_STABLE_BY_BENDING * over_clearance)
    stable *= 1.0 - LEAST_BY_BENDING * (bend > 0.0)
    over_film = bend / values["minimum_film_thickness"]
    left = _LeftOut(
        stable=1.0 - stable * (1.0 if case.thermal.is_resolved else LESS_STABLE),
        film=1.0 - max(1.0 - THINNER_BY_GROWTH * moved, 0.0) / (1.0 + THINNER_BY_BENDING * over_film),
        hotter=HOTTER_BY_GROWTH * max(share, 0.0),
    )
    supply = math.nan if case.oil_supply is None else case.oil_supply.temperature
    named = tuple(_named(case, share, over_clearance))
    if named and (near := tuple(_kept_by_little(checks, left, supply))):
        yield Notice("W422", "kept", {
            "kept": near, "left": named, "stable": left.stable, "film": left.film,
            "hotter": (Notice("W422", "hotter", {"hotter": left.hotter}),) if share > 0.0 else (),
            "advice": _advice(case, "growth", "bending"),
        })  # fmt: skip


def _named(case: PadCase, share: float, bend: float) -> Iterator[Notice]:
    """What is left out: growth and bending, and with them temperatures of the films' own."""
    if abs(share) > UNMOVED:
        yield Notice("W422", "growth" if share > 0.0 else "widening", {"share": abs(share)})
    if bend > 0.0:
        yield Notice("W422", "bending", {"bend": bend})
    if (abs(share) > UNMOVED or bend > 0.0) and not case.thermal.is_resolved:
        yield Notice("W422", "temperatures")


def _advice(case: PadCase, *asked: str) -> tuple[Notice, ...]:
    """The model that counts more, as a case writes it; turbulent films have no temperatures of their own."""
    bends = any(pad.bends for pad in case.bearing.pads)
    if case.turbulence is not None:
        asked = () if bends or "bending" not in asked else ("bending",)
    elif bends or case.heat.bending is not None or case.heat.growth is not None:
        asked = ("growth", "bending")
    if not asked:
        return ()
    films = () if case.thermal is Thermal.FULL or case.turbulence is not None else ("thermal: full",)
    model = ", ".join((*films, f"deformation: [{', '.join(asked)}]"))
    return (Notice("W422", "advice", {"model": model}),)


def _kept_by_little(checks: Iterable[Check], left: _LeftOut, supply_temperature: float) -> Iterator[Notice]:
    """Limits that less stability, thinner films and hotter bores would miss, each with its margin.

    Of bores none where the temperature of the supply is not known (nan).

    >>> from babbitt.core.result import Bound
    >>> film = Check("C101", "minimum_film_thickness", 1.15e-5, 1e-5, Bound.AT_LEAST, "")
    >>> bore = Check("C108", "maximum_temperature", 380.0, 387.0, Bound.AT_MOST, "")
    >>> [one.message for one in _kept_by_little([film, bore], _LeftOut(0.3, 0.15, 0.15), 320.0)]
    ['by 15.0 % (C101)', 'by 7.0 K (C108)']
    >>> list(_kept_by_little([film, bore], _LeftOut(0.2, 0.1, 0.1), 320.0))
    []
    """
    yield from kept_stability("W422", checks, 1.0 - left.stable)
    for one in checks:
        if not one.ok or one.advisory:
            continue
        if one.code in OF_FILM and (1.0 - left.film) * one.value < one.limit:
            yield Notice("W422", "stable", {"margin": one.margin, "check": one.code})
        if is_of_bore(one) and one.value + left.hotter * (one.value - supply_temperature) > one.limit:
            yield Notice("W422", "temperature", {"margin": one.limit - one.value, "check": one.code})


def left_out_growth(case: PadCase, journal: float, pads: float) -> float:
    """Share of the assembled clearance that growth would take of the pad that it narrows most; 0 where it counts.

    Below zero where the housing makes more room than journal and pads take.

    Journal and pads have temperatures in K and expand as the case says, else as steel.
    """
    if case.heat.growth is not None:
        return 0.0
    heat, bearing = pad_heat(case, case.fuller, pads), case.bearing.film(1.0, case.journal_speed)
    return max(
        heat.narrowing(bearing, number, journal, pads) / pad.assembled_clearance
        for number, pad in enumerate(bearing.pads)
    )


def left_out_bending(case: PadCase, films: PadFilms, warm: float) -> float:
    """What bending would move the edge of a pad by that it moves most, m; 0 where it counts.

    Under the load on its pivot, spread evenly, and with what the heat that it gives off at its back makes of the
    difference between the temperature of the journal or films, K, and that of the oil behind it. Pads of one
    temperature that bend lack the part of the heat.
    """
    if case.heat.bending is not None:
        return 0.0
    heat, edges = pad_heat(case, case.fuller, warm), []
    for number, (pad, state) in enumerate(zip(case.bearing.pads, films.solution.pads, strict=True)):
        bending, walls = heat.bending_of(number), heat.walls_of(number)
        assert bending is not None
        assert walls is not None
        back = heat.supply_temperature if walls.back_temperature is None else walls.back_temperature
        biot = walls.back_coefficient * pad.thickness / walls.conductivity
        radius = 0.5 * case.bearing.diameter + pad.clearance
        edge = edge_under_heat(pad, radius, bending, max(warm - back, 0.0) * biot / (1.0 + biot))
        if not pad.bends:
            width = case.bearing.width if pad.width is None else pad.width
            edge += edge_under_load(pad, radius, width, bending, max(state.load, 0.0))
        edges.append(edge)
    return max(edges)
