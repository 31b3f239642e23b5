"""What a film with its own temperatures adds to the answer of a bearing: values, rows, warnings, assumptions."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.core.notices import Notice
from babbitt.core.quantities import AXES
from babbitt.core.result import Matrix
from babbitt.design.warnings import BESIDE_THE_END
from babbitt.kinds.journal.film.heat_model import AxialTemperature, HeatModel, TemperatureCoefficients
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.layout import supply_numbers
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_film import film_heat, following_stiffness, thermal_resolution

if TYPE_CHECKING:
    from babbitt.reynolds.heat.thermal_solution import ThermalFilm
    from babbitt.reynolds.model import JournalFilm
    from babbitt.reynolds.solution import FilmSolution

__all__ = [
    "coefficient_settings",
    "warnings_about_heat",
    "flow_without_pressure",
    "is_notable",
    "settings_found",
    "stiffness_values",
    "temperatures_of_coefficients",
    "thermal_assumptions",
    "thermal_rows",
    "thermal_setting",
    "thermal_values",
    "with_own_coefficients",
]

BACK_FROM = 0.05
"""Oil that goes back into supplies from which it is reported, over what leaves by the sides or what the journal
drags through the mean gap, c B U/2, if that is less: fresh oil pressed through the unloaded gap hides none."""

NOTHING = 1e-6
"""Oil that goes back into supplies, over what leaves by the sides, up to which it is left out."""


def thermal_setting(case: FilmCase) -> str:
    """Thermal model in the words of the case language."""
    if case.heat is not None:
        return case.heat.name
    return "isothermal" if case.effective_temperature is not None else "global"


def coefficient_settings(heat: HeatModel) -> dict[str, str]:
    """Which temperatures stiffness, damping and stability stand for: only the stiffness may have following ones.

    A whirl near half the speed leaves bush and journal no time, and takes about as long as the oil stays in the
    film: stability is that of frozen temperatures.
    """
    frozen = TemperatureCoefficients.FROZEN.value
    return {
        "stiffness_temperatures": heat.coefficients.value,
        "damping_temperatures": frozen,
        "stability_temperatures": frozen,
        "carry_over": f"{heat.carry_over:g}",
    }


def settings_found(case: FilmCase, followed: bool) -> dict[str, str]:
    """Those settings after the search: stiffness is that of frozen temperatures where no other was found."""
    assert case.heat is not None
    return coefficient_settings(
        case.heat if followed else replace(case.heat, coefficients=TemperatureCoefficients.FROZEN)
    )


def temperatures_of_coefficients(case: FilmCase) -> str:
    """Temperatures for which stiffness and damping hold, in few words; one for the whole film is frozen, too."""
    if case.heat is None:
        return TemperatureCoefficients.FROZEN.value
    said = coefficient_settings(case.heat)
    stiffness, damping = said["stiffness_temperatures"], said["damping_temperatures"]
    return damping if stiffness == damping else f"stiffness {stiffness}, damping {damping}"


def thermal_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Named results of the temperatures, SI."""
    thermal, supply = state.thermal, case.oil_supply
    assert thermal is not None
    assert supply is not None
    angle, place = thermal.hot_spot
    conducting = case.heat is not None and case.heat.walls is not None
    wall = "bush" if conducting else "wall"  # an adiabatic film has no bush, only a wall that it touches
    values = {
        "effective_temperature": state.temperature,
        "supply_temperature": supply.temperature,
        "supply_pressure": supply.pressure,
        "outlet_temperature": thermal.side_temperature,
        "maximum_temperature": thermal.maximum_temperature,
        "hot_spot_angle": math.pi - (math.pi - angle) % (2.0 * math.pi),
        "groove_temperature": float(thermal.groove_temperatures.max()),
        f"mean_{wall}_temperature": thermal.mean_bush_temperature,
        f"maximum_{wall}_temperature": float(thermal.bush_temperature.max()),
        "journal_temperature": thermal.journal_temperature,
        "film_dissipation": thermal.heat.dissipation,
        "heat_to_oil": thermal.heat.oil,
        "energy_balance_error": thermal.heat.balance_error,
    }
    returned = float(thermal.returned_flow.sum())
    if returned > NOTHING * thermal.film.leaving_flow:
        values |= {"returned_flow": returned, "heat_returned": thermal.heat.returned}
    if conducting:
        values |= {"heat_film_to_bush": thermal.heat.bush, "heat_film_to_journal": thermal.heat.journal}
    if thermal.axial_positions.size > 1:
        values["hot_spot_position"] = place
    return values


def thermal_rows(case: FilmCase, thermal: ThermalFilm) -> dict[str, Matrix]:
    """Direction, flows and mixing temperature of every groove, pocket and hole in the order of the case."""
    numbers = list(supply_numbers(case, thermal.film.film))
    rows: dict[str, Iterable[float]] = {
        "groove_angles": [feed.angle for feed in case.bearing.feeds],
        "groove_fresh_flows": [  # that of a closed one is what the search for its pressure leaves
            max(flow, 0.0) if feed.is_closed else flow
            for feed, flow in zip(case.bearing.feeds, thermal.fresh_flow[numbers], strict=True)
        ],
        "groove_returned_flows": thermal.returned_flow[numbers],
        "groove_temperatures": thermal.groove_temperatures[numbers],
    }
    return {name: (tuple(float(one) for one in row),) for name, row in rows.items()}


def with_own_coefficients(case: FilmCase, state: FilmState) -> tuple[FilmState, bool]:
    """State with the stiffness that the case asks for, and whether it was found."""
    if case.heat is None or case.heat.coefficients is TemperatureCoefficients.FROZEN:
        return state, True
    stiffness = following_stiffness(case, state)
    if stiffness is None:
        return state, False
    return replace(state, solution=replace(state.solution, stiffness=stiffness)), True


def stiffness_values(state: FilmState) -> dict[str, float]:
    """The stiffness as single numbers."""
    own = state.solution.stiffness.ravel()
    return {f"stiffness_{axes}": float(one) for axes, one in zip(AXES, own, strict=True)}


def flow_without_pressure(case: FilmCase, state: FilmState, calm: JournalFilm) -> float:
    """Flow of the same journal position without supply pressure, m3/s; NaN where there is no such film."""
    from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at

    x, y = state.solution.position
    heat = film_heat(case, state.volumetric_heat_capacity, state.temperature)
    found = thermal_film_at(calm, heat, (float(x), float(y)), thermal_resolution(case)).film
    return found.leaving_flow if found.outcome.solved else math.nan


def is_notable(returned: float, found: FilmSolution) -> bool:
    """Whether so much oil goes back into supplies, m3/s, that it is reported."""
    film = found.film
    dragged = 0.25 * abs(film.angular_speed) * film.diameter * film.clearance * film.width
    return returned > BACK_FROM * min(found.leaving_flow, dragged)


def warnings_about_heat(
    case: FilmCase, state: FilmState, values: dict[str, float], followed: bool
) -> Iterator[Notice]:
    """Lubricant data, laminar flow, balance and coefficients of a film with its own temperatures."""
    assert state.thermal is not None
    coldest, hottest = case.lubricant.temperature_range
    low, high = float(state.thermal.temperature.min()), values["maximum_temperature"]
    if low < coldest - BESIDE_THE_END:
        yield Notice("W145", values={
            "low": low, "high": high, "lubricant": case.lubricant.name, "coldest": coldest, "hottest": hottest,
        })  # fmt: skip
    thermal = state.thermal
    back = float(thermal.returned_flow.sum())
    if is_notable(back, thermal.film):
        warmth = thermal.heat.returned / (state.volumetric_heat_capacity * back)
        share = thermal.heat.returned / thermal.heat.oil
        yield Notice("W148", "own_temperatures", {
            "flow": back, "mean": float(thermal.supply_temperature + warmth), "share": float(share),
        })  # fmt: skip
    if not followed:
        yield Notice("W147")


def thermal_assumptions(case: FilmCase, surfaces: str, flow: str) -> Iterator[str]:
    """What the model of a film with its own temperatures assumes; its surfaces and its flow come in words."""
    heat = case.heat
    assert heat is not None
    along = "" if heat.axial_temperature is AxialTemperature.MEAN else "over the width, "
    yield (
        f"Temperature and viscosity of the film vary around the journal, {along}and across the gap; "
        f"{surfaces}; {flow}."
    )
    if heat.axial_temperature is AxialTemperature.MEAN and all(one.width is None for one in case.bearing.feeds):
        yield "One profile of temperature across the gap for the whole width."
    yield "Heat capacity, conductivity and density of the oil are those at the effective temperature."
    yield "Grooves, pockets and holes mix fresh oil with what the film brings, completely" + (
        "; all of it goes on, as far as the next film takes it."
        if heat.carry_over == 1.0
        else f"; {heat.carry_over:.0%} of it goes on, fresh oil replaces the rest (carry_over)."
    )
    yield "Bush and journal expand freely, each by the mean temperature of its surface."
    yield from _wall_assumptions(heat)
    if heat.coefficients is TemperatureCoefficients.FROZEN:
        yield "Stiffness and damping at temperatures that do not follow the motion (frozen)."
    else:
        yield (
            "Stiffness with temperatures that follow every displacement (following), for slow changes; damping "
            "and stability at frozen ones."
        )
    yield "Thresholds of whirl and of mixed friction at other speeds keep the effective viscosity."


def _wall_assumptions(heat: HeatModel) -> Iterator[str]:
    if heat.walls is None:
        yield "No heat leaves the film through bush and journal: the oil carries all of it."
        return
    yield "The bush conducts around and outwards, not along the shaft; the journal has one temperature."
