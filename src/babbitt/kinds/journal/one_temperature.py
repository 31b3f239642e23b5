"""Limits kept by less than films with temperatures of their own differ from one temperature, or can tell."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import Any, Protocol

from babbitt.core.limited_flow import is_limited, limited
from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.design.checks import knows_hottest_place
from babbitt.design.conditions import CheckedProblem, Limits
from babbitt.design.kept_limits import about_kept_film, kept_by_little
from babbitt.design.uncertainty import shear_heat
from babbitt.design.warnings import PLAIN_BEARING_UP_TO
from babbitt.numerics.scalar_or_array import functions_for, holds_anywhere, larger
from babbitt.properties.materials import (
    highest_metal_temperature,
    metal_temperature_limit,
    published_metal_temperature,
)

__all__ = [
    "checks_of_metal",
    "warnings_about_heat_left_out",
    "warnings_about_kept_limits",
    "warnings_about_margins",
    "warnings_about_unknown_metal",
]

THINNER, HOTTER = 0.55, 15.0
"""Margin of the film thickness, and K above the outlet, by which films with temperatures of their own may differ.

Assumptions by measurement (docs/theory/procedure.md, ``benchmarks/one_temperature.py``): nineteen of twenty films
with temperatures of their own and walls that conduct differ by less with oils up to ISO VG 68, from ISO 7902 and
from films of one temperature alike; their thickness by less than 0.45, but of wide ones with a cool inlet under
high load that a search found by 0.53. Fast bearings and thick oils add ``HOTTER_BY_SHEAR`` and
``LOADED_BY_SHEAR``."""

THINNER_BESIDE_PRESSED, MUCH_PRESSED = 0.85, 1.0
"""``THINNER`` where the supply presses more than Q₃ through the gap, or as many times Q₃.

Assumption by a search for the thinnest films among 2400 clean passes (docs/theory/procedure.md): wide slow
bearings with a pocket opposite under 0.9 MPa, which presses 10 to 22 times Q₃, have 0.60 of the film. Narrow ones
that a search found (B/D 0.15, a groove around half of the bore, 1.4 times Q₃) have 0.56; none was found below Q₃
that lacks more than ``THINNER``."""

RISE_OF_METAL, RISE_OF_METAL_BESIDE_PRESSED = 6.2e-3, 8.2e-3
"""K over the root of Pa m/s: rise of the hottest bush above the inlet over sqrt(p̄ U), fast and loaded bearings;
and of those whose supply presses more than ``PRESSED`` of Q₃ through the gap.

Assumption by the same measurement, at 15 to 60 m/s and 1.5 to 5 MPa: of nineteen of twenty it is less. The second
by the search of ``THINNER_BESIDE_PRESSED``: 7.8 of a narrow fast one with a groove around the bore."""

HOTTER_BY_SHEAR, HOTTER_BESIDE_PRESSED, PRESSED = 9.0, 12.0, 0.5
"""K over m/s times the root of Pa s: by how much the hottest bush lies above the outlet, over U sqrt(η_eff), and
the same where the supply presses more than a share of Q₃ through the gap, which cools the outlet alone.

Its root is that of the heat of shear over conduction across the gap, η U²/λ. Assumption by measurement of 207
bearings with ISO VG 22 to 460 (docs/theory/procedure.md, set ``thick``) and of 120 narrow ones with hot thick oil
and grooves around the bore or half of it (set ``hot``): the hottest bush of none is hotter than by this, by
``HOTTER`` or ``RISE_OF_METAL``; of those beyond the last two it is at most 7.9, and 11.7 in the set ``hot`` (6.5
where Q_p is less than half of Q₃). A search among clean passes found two narrow ones with hot thick oil and slots
that just deliver Q₃ of 8.8, Q_p being less than half of it."""

METAL_PRESSED = 0.25
"""Share of Q₃ from which on ``HOTTER_BESIDE_PRESSED`` and ``RISE_OF_METAL_BESIDE_PRESSED`` are asked of the metal.

Assumption: searches among clean passes of narrow bearings with hot thick oil found bushes above the outlet by 8.7,
8.8, 9.8 and 9.2 K times U sqrt(η_eff) where Q_p is 0.32, 0.33, 0.45 and 0.50 of Q₃, none below a quarter."""

MOST_TOLD = 5.0
"""Margin beyond which its number, and a temperature that asks for it, say nothing more."""

MEGA_ROOT = 1e3
"""Root of Pa in MPa, in which the rise over the root of p̄ U is given."""

THINS = 1.1
"""Viscosity over that at a temperature ``HOTTER`` of an oil that thins: those of the catalogue have 1.24 to
2.55 from 40 to 120 °C, water 1.14 at the least."""

RISE_OF_LOADED_FILM, LOADED_BESIDE_PRESSED = 2.1e-3, 3.6e-3
"""K over the root of Pa m/s: rise above the inlet of the oil that carries the load, over sqrt(p̄ U); and of
bearings whose supply presses more than ``PRESSED`` of Q₃ through the gap, by the same search.

Oil that the supply presses through the unloaded gap leaves without cooling it, yet one temperature mixes it in.
Assumption by measurement of bearings with Q_p of 0.5 to 10 times Q₃ (docs/theory/procedure.md, set ``pressed``):
58 of 60 films with temperatures of their own are no thinner than by the viscosities of both temperatures."""

LOADED_BY_SHEAR, SHEARED_BESIDE_PRESSED = 9.5, 12.0
"""K over the root of m/s times the root of Pa s: by how much the oil that carries the load may be hotter than the
one temperature, over the root of U sqrt(η_eff); and of bearings whose supply presses more than ``PRESSED`` of Q₃
through the gap.

Assumption by measurement of the same bearings, 207 by ISO 7902 and 69 films of one temperature: none of their
films with temperatures of their own is thinner than by its viscosity there, or by ``THINNER``. A search among
clean passes found 106 narrow fast bearings with cold oil that half grooves press (2.4 to 3.5 times Q₃), with
0.43 to 0.51 of the film of the standard: 10.35 at the most."""

LOADED_BY_PRESSURE, LOADED_SHORT_OF_OIL = 5e-6, 1e-5
"""K/Pa: by how much the oil that carries the load may be hotter than the one temperature, over p̄; and the same of
the film with the limited flow of a supply that delivers less than Q₃. A film that keeps its heat warms by about
7/(ρ c) times p̄, whatever its oil and speed.

Assumption by measurement of 378 bearings with 2.5 to 7 MPa and ISO VG 22 to 460 (docs/theory/procedure.md, set
``heavy``), the films of none are thinner than by the viscosity at 3.9 K/MPa above, and by searches that climbed to
4.4 in wide clearances, and to 8.9 where feeds on both sides deliver three quarters of Q₃ under little pressure."""

FASTEST_AND_LOADED, FASTEST_OF_NARROW, NARROW = 3e8, 1.5e8, 0.3
"""Pa m/s: the largest p̄ U of the bearings that were measured, and that of those narrower than a share of their
diameter. A search found narrow ones beyond it with 1.6 times ``TURBULENT_SOONER`` and films of 0.45."""

PRESSES_HARDER = 1.6
"""Largest pressure of films with temperatures of their own, which are thinner, over that of one temperature.

Assumption: searches among clean passes without a metal found 1.26 under 13 to 17 MPa, and 1.55 at the most."""

GROWN = 0.25
"""Share of the clearance that growth may take at the one temperature: the loaded film is hotter, so is the
journal, the clearance narrower and the film hotter still.

Assumption by measurement of 104 bearings that pass cleanly around a journal of stainless steel in cast iron
(docs/theory/procedure.md): conducting films with temperatures of their own miss a limit or close in two of them,
of which growth takes 31 and 40 %; in another bearing from 30 % on."""

TURBULENT_SOONER = 3.2
"""Reynolds number of films with temperatures of their own over that of one temperature.

Assumption by the same measurement, nineteen of twenty lie below 2.1, and by searches for the largest, 3.1: their
oil is thinner where it carries no load."""

LIGHTER, LIGHTER_BY_SHEAR = 0.1, 0.04
"""Margin of the critical mass by which films with temperatures of their own may differ, and the same over
U sqrt(η_eff) in m/s times the root of Pa s, where that is more.

Assumption by the same measurement: of nineteen of twenty their critical mass is more than 0.98 of that of the film
with one temperature; and of two fast bearings with thick oil that were found with 0.76 of it (6.9 and 10.3)."""


class HeatBalancedProblem(CheckedProblem, Protocol):
    """A bearing whose friction may be multiplied."""

    @property
    def friction_factor(self) -> float:
        """Factor on the friction of the film."""


def warnings_about_margins(
    checks: tuple[Check, ...],
    values: Mapping[str, float],
    of_metal: Collection[str],
    viscosity: Callable[[float], float],
    narrowed: Callable[[Check, float], Notice | None] | None = None,
) -> Iterator[Notice]:
    """Whether a limit is kept by less than films with temperatures of their own usually differ.

    Parameters
    ----------
    checks : tuple of Check
    values : Mapping[str, float]
        Named results of the film with one temperature.
    of_metal : collection of str
        Codes of the checks that hold the metal to its limit; see `checks_of_metal`.
    viscosity : callable
        Dynamic viscosity of the oil, Pa s, over the temperature in K.
    narrowed : callable, optional
        What is said of a check of film thickness in a gap that tilt or form narrows, with the viscosity over that
        of the loaded film; None for other gaps, whose film goes at most with the viscosity.
    """
    near = [
        one
        for check in (*checks, *_transition(checks, values))
        if not check.advisory and check.ok
        for one in _near(check, values, of_metal, viscosity, narrowed)
    ]
    near += [*_beyond_measured(values), *_near_largest_pressure(values)]
    if reduce(operator.or_, (one.holds for one in near), False):
        yield Notice("W191", "kept", {"kept": tuple(one.notice() for one in near if holds_anywhere(one.holds))})


def _transition(checks: Iterable[Check], values: Mapping[str, float]) -> Iterator[Check]:
    """The film thickness of transition as a limit of the film, where C111 holds speeds against each other."""
    film = next((one for one in checks if one.code == "C101"), None)
    by_speed = any(one.code == "C111" and one.quantity == "hydrodynamic_speed" for one in checks)
    if film is not None and by_speed and "transition_film_thickness" in values:
        yield replace(film, code="C111", limit=values["transition_film_thickness"])


@dataclass(frozen=True)
class _Near:
    """Whether a limit is kept by too little, and what is said of it."""

    holds: Any
    notice: Callable[[], Notice]


def _beyond_measured(values: Mapping[str, float]) -> Iterator[_Near]:
    """Whether load times speed is more than that of all bearings by which the margins were measured."""
    if "specific_load" not in values or "width_ratio" not in values:
        return
    power = values["specific_load"] * abs(values["surface_speed"])
    most = FASTEST_AND_LOADED + (FASTEST_OF_NARROW - FASTEST_AND_LOADED) * (values["width_ratio"] < NARROW)
    yield _Near(power > most, lambda: Notice("W191", "beyond", {"power": power, "most": most}))


def _near_largest_pressure(values: Mapping[str, float]) -> Iterator[_Near]:
    """Whether the thinner film may press harder than plain bearings know, and that of one temperature not."""
    name = "maximum_pressure"
    if name not in values:
        return
    pressure = larger(values[name], values.get(limited(name), 0.0))
    near = (pressure <= PLAIN_BEARING_UP_TO) & (PRESSES_HARDER * pressure > PLAIN_BEARING_UP_TO)
    yield _Near(
        near,
        lambda: Notice(
            "W191", "pressure", {"pressure": pressure, "limit": PLAIN_BEARING_UP_TO, "factor": PRESSES_HARDER}
        ),
    )


def _near(
    check: Check,
    values: Mapping[str, float],
    of_metal: Collection[str],
    viscosity: Callable[[float], float],
    narrowed: Callable[[Check, float], Notice | None] | None,
) -> Iterator[_Near]:
    """What of one limit that is kept may be too near."""
    if check.code in FILM_CHECKS or check.quantity.endswith("minimum_film_thickness"):
        thinner = thinner_oil(check, values, viscosity)
        asked = larger(thinner - 1.0, least_margin(values))
        # Any film keeps a limit of zero, and there is no share of it.
        by_little = (check.margin < asked) & (check.limit > 0.0)
        yield _Near(by_little, lambda: _about_film(check, values, thinner))
        if narrowed is not None and not by_little and (gap := narrowed(check, thinner)) is not None:
            yield _Near(True, lambda: gap)
    if check.code in of_metal:
        by_estimate = check.limit < hottest_metal(check.value, values)
        yield _Near(by_estimate, lambda: _about_metal(check, values))
    if check.code == "C110":
        sooner = larger(thinner_oil(check, values, viscosity), TURBULENT_SOONER)
        yield _Near(
            check.value * sooner > check.limit,
            lambda: Notice(
                "W191",
                "reynolds_number",
                {
                    "factor": check.limit / check.value,
                    "check": check.code,
                    "asked": sooner,
                },
            ),
        )
    if check.code == "C115":
        by_little = check.margin < larger(LIGHTER, LIGHTER_BY_SHEAR * heat_of_shear(values))
        yield _Near(
            by_little, lambda: Notice("W191", "critical_mass", {"margin": check.margin, "check": check.code})
        )


def warnings_about_heat_left_out(case: HeatBalancedProblem, values: Mapping[str, float]) -> Iterator[Notice]:
    """What makes one temperature lower than that of films with temperatures of their own, or its flow larger.

    Parameters
    ----------
    case : HeatBalancedProblem
    values : Mapping[str, float]
        Named results of the film with one temperature.
    """
    if case.effective_temperature is not None:
        return
    if case.friction_factor < 1.0:
        yield Notice("W216", values={"factor": case.friction_factor})
    viscosity, film = case.lubricant.dynamic_viscosity, values["effective_temperature"]
    if viscosity(film) < THINS * viscosity(film + HOTTER):
        yield Notice("W217")
    cold, warm = (values[name] for name in ("relative_clearance", "operating_relative_clearance"))
    warmest = values.get(limited("operating_relative_clearance"), warm)  # of a film that is short of oil
    if cold - warmest > GROWN * cold:
        yield Notice("W218", values={"share": 1.0 - warmest / cold})


def warnings_about_unknown_metal(
    case: CheckedProblem, checks: Iterable[Check], values: Mapping[str, float]
) -> Iterator[Notice]:
    """A bush that may be hotter than films with temperatures of their own permit where its metal has no limit.

    Those films hold it against the general limit of bearing temperatures; where only the temperature of the oil
    that leaves is known, no check does.
    """
    metal, tables = case.bearing.metal, case.limits.tables
    usual = None if metal is None else metal.without_own_limits
    if knows_hottest_place(values) or published_metal_temperature(usual, tables) is not None:
        return
    of_metal = None if metal is None or metal.limiting_temperature is None else metal.limiting_temperature.value
    of_case = [one for one in (case.limits.temperature, of_metal) if one is not None]
    limit = metal_temperature_limit(usual, tables) if of_metal is None else highest_metal_temperature(tables)
    general = limit.value
    if any(one <= general for one in of_case):
        return
    for check in checks:
        if check.code == "C104" and general < (hottest := hottest_metal(check.value, values)):
            yield Notice("W191", "metal", {"hottest": hottest, "limit": general, "check": "C108"})


def hottest_metal(leaving: float, values: Mapping[str, float]) -> float:
    """Temperature in K that a bush may have whose oil leaves at one temperature."""
    return reduce(larger, (hottest for hottest, _, _ in _estimates(leaving, values)))


def _estimates(leaving: float, values: Mapping[str, float]) -> tuple[tuple[float, float, float], ...]:
    """Temperatures in K that a bush may have: above the outlet, by shear, and above the inlet.

    Each with its factor and what that multiplies: K and 1; K over m/s times the root of Pa s, and U sqrt(η);
    K over the root of MPa m/s, and the root of p̄ U.
    """
    pressed = may_be_pressed(values, METAL_PRESSED)
    by_shear = HOTTER_BY_SHEAR + (HOTTER_BESIDE_PRESSED - HOTTER_BY_SHEAR) * pressed
    heat = heat_of_shear(values)
    rise = RISE_OF_METAL + (RISE_OF_METAL_BESIDE_PRESSED - RISE_OF_METAL) * pressed
    above = above_inlet(values, rise)
    root = (above - values["supply_temperature"]) / rise if "supply_temperature" in values else 0.0
    return (
        (leaving + HOTTER, HOTTER, 1.0),
        (leaving + by_shear * heat, by_shear, heat),
        (above, rise * MEGA_ROOT, root / MEGA_ROOT),
    )


def _about_metal(check: Check, values: Mapping[str, float]) -> Notice:
    """The largest estimate, with the numbers to compute it anew."""
    margin, code = check.limit - check.value, check.code
    (outlet, hotter, _), (sheared, by_shear, heat), (inlet, rise, root) = _estimates(check.value, values)
    told = (
        (outlet, Notice("W191", "above_outlet", {
            "margin": margin, "check": code, "hottest": outlet, "hotter": hotter,
        })),
        (sheared, Notice("W191", "by_shear", {
            "margin": margin, "check": code, "hottest": sheared, "factor": by_shear, "heat": heat,
        })),
        (inlet, Notice("W191", "above_inlet", {
            "margin": margin, "check": code, "hottest": inlet, "factor": rise, "root": root,
        })),
    )  # fmt: skip
    return max(told, key=lambda one: one[0])[1]


def least_margin(values: Mapping[str, float]) -> float:
    """Margin of a limit of the film that films with temperatures of their own may need, whatever their oil."""
    return THINNER + (THINNER_BESIDE_PRESSED - THINNER) * may_be_pressed(values, MUCH_PRESSED)


def _about_film(check: Check, values: Mapping[str, float], thinner: float) -> Notice:
    if not holds_anywhere(thinner - 1.0 > least_margin(values)):
        return Notice("W191", "film", {
            "margin": check.margin, "check": check.code, "asked": least_margin(values),
        })  # fmt: skip
    if not holds_anywhere(thinner - 1.0 <= MOST_TOLD):
        return Notice("W191", "hot_film", {"margin": check.margin, "check": check.code, "most": MOST_TOLD})
    return Notice("W191", "loaded_film", {
        "margin": check.margin, "check": check.code, "loaded": loaded_temperature(check, values),
        "asked": thinner - 1.0,
    })  # fmt: skip


def thinner_oil(check: Check, values: Mapping[str, float], viscosity: Callable[[float], float]) -> float:
    """Viscosity at the one temperature of a checked film over that where it carries the load, at least 1.

    The film thickness goes at most with the viscosity, the Reynolds number with its inverse.

    >>> from babbitt.core.result import Bound
    >>> of_film = Check("C101", "minimum_film_thickness", 2e-5, 1e-5, Bound.AT_LEAST, "")
    >>> warm = {"supply_temperature": 313.0, "specific_load": 4e6, "surface_speed": 25.0}
    >>> calm = warm | {"effective_temperature": 320.0, "supply_flow": 0.0, "side_flow": 1.0}
    >>> thinner_oil(of_film, calm, lambda kelvin: 1.0 / kelvin)  # 340 K there
    1.0625
    """
    one = one_temperature(check, values)
    return viscosity(one) / viscosity(larger(loaded_temperature(check, values), one))


def one_temperature(check: Check, values: Mapping[str, float]) -> float:
    """Temperature in K of a checked film, with the flow that the supply delivers where the check asks for that."""
    name = "effective_temperature"
    return values.get(limited(name) if is_limited(check.quantity) else name, math.inf)


def loaded_temperature(check: Check, values: Mapping[str, float]) -> float:
    """Temperature in K that the oil which carries the load may have.

    >>> from babbitt.core.result import Bound
    >>> of_film = Check("C101", "minimum_film_thickness", 2e-5, 1e-5, Bound.AT_LEAST, "")
    >>> thick = {"effective_temperature": 320.0, "surface_speed": 20.0, "effective_viscosity": 0.04}
    >>> flows = {"supply_flow": 0.0, "side_flow": 1.0}
    >>> loaded_temperature(of_film, thick | flows)  # 9.5 K times the root of 4
    339.0
    """
    one, shear = one_temperature(check, values), heat_of_shear(values)
    pressed = may_be_pressed(values)
    by_shear = LOADED_BY_SHEAR + (SHEARED_BESIDE_PRESSED - LOADED_BY_SHEAR) * pressed
    sheared = one + by_shear * functions_for(shear).sqrt(shear)
    rise = RISE_OF_LOADED_FILM + (LOADED_BESIDE_PRESSED - RISE_OF_LOADED_FILM) * pressed
    loaded: float = larger(above_inlet(values, rise), sheared)
    if "specific_load" not in values:
        return loaded
    by_pressure = LOADED_SHORT_OF_OIL if is_limited(check.quantity) else LOADED_BY_PRESSURE
    return larger(loaded, one + by_pressure * values["specific_load"])


def may_be_pressed(values: Mapping[str, float], share: float = PRESSED) -> float:
    """1 where the supply presses more than a share of Q₃ through the gap, or the flows are not known, else 0.

    >>> may_be_pressed({"supply_flow": 1.0, "side_flow": 3.0}), may_be_pressed({"side_flow": 3.0})
    (0.0, 1.0)
    """
    return 1.0 - (values.get("supply_flow", math.nan) <= share * values.get("side_flow", math.nan))


def heat_of_shear(values: Mapping[str, float]) -> float:
    """`shear_heat` of a film, with all the oil that it wants, as measured; 0 of unknown viscosity."""
    if "effective_viscosity" not in values:
        return 0.0
    found: float = shear_heat(values["surface_speed"], values["effective_viscosity"])
    return found


def warnings_about_kept_limits(
    checks: Sequence[Check], of_metal: Collection[str], supply_temperature: float
) -> Iterator[Notice]:
    """Limits of metal and film that a film with temperatures of its own keeps by less than it can tell; K."""
    yield from about_kept_film("W172", checks)
    near = kept_by_little((check for check in checks if check.code in of_metal), supply_temperature)
    if near:
        yield Notice("W172", "kept", {
            "uncertain": max(one.uncertain for one in near),
            "kept": tuple(
                Notice("W172", "temperature", {"margin": one.margin, "check": one.check}) for one in near
            ),
        })  # fmt: skip


def checks_of_metal(limits: Limits) -> tuple[str, ...]:
    """Codes of the checks that hold the metal to its limit: that of the case is one of the metal, too."""
    return ("C108",) if limits.temperature is None else ("C104", "C108")


def above_inlet(values: Mapping[str, float], rise: float) -> float:
    """Temperature in K that lies above the inlet by a rise, K over the root of Pa m/s; 0 without an inlet.

    >>> above_inlet({"supply_temperature": 313.15, "specific_load": 4e6, "surface_speed": 25.0}, RISE_OF_METAL)
    375.15
    """
    if "supply_temperature" not in values:
        return 0.0
    power = values["specific_load"] * abs(values["surface_speed"])
    root: float = functions_for(power).sqrt(power)
    return values["supply_temperature"] + rise * root
