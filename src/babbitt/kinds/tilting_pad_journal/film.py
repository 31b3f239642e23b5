"""The films of all pads at one temperature, and the temperature at which their heat balance closes."""

from __future__ import annotations

import math
from functools import partial

from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.heat_balance import (
    COARSE_SEARCH,
    Equilibrium,
    NoFilmError,
    at_prescribed_temperature,
    coolest_equilibrium,
)
from babbitt.design.oil import properties_at
from babbitt.design.pad_heat import HeatBalance, mixed_temperatures
from babbitt.design.turbulence import film_turbulence
from babbitt.kinds.tilting_pad_journal.model import LIGHT, PadCase, Thermal
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.thermal_film import thermal_films
from babbitt.reynolds.tilting_pads.solve import solve_with_light_pads, tilting_pads_at

__all__ = ["film_at_temperature", "operating_films"]


def operating_films(case: PadCase) -> Equilibrium[PadFilms]:
    """Films at the temperature that the case gives, at which friction and fresh oil balance, or with their own.

    Always ends with a status; the films of a pad at its limit are an equilibrium of heat and none of forces.
    """
    film_at = partial(film_at_temperature, case=case)
    match case.thermal:
        case Thermal.ISOTHERMAL:
            found = at_prescribed_temperature(case.effective_temperature or math.nan, film_at)
        case Thermal.GLOBAL:
            assert case.oil_supply is not None
            found = coolest_equilibrium(film_at, _surplus, case.oil_supply.temperature, COARSE_SEARCH)
        case Thermal.ADIABATIC | Thermal.FULL:
            return thermal_films(case)
    if found.film is not None and found.outcome.solved and not found.film.solution.outcome.solved:
        return Equilibrium(found.film.solution.outcome, found.film, found.evaluations, found.last_temperature)
    return found


def _surplus(temperature: float, film: PadFilms) -> float:
    """By how much friction warms the films above the temperature of their oil, K."""
    assert film.temperatures is not None
    return film.temperatures.effective - temperature


def film_at_temperature(temperature: float, case: PadCase) -> PadFilms:
    """Films at an effective temperature in K.

    Raises
    ------
    NoFilmError
        When the engine ends without a place of the journal, or a law of the lubricant has no usable value. A pad
        at its limit is no reason: its films stand where the search ended, and another temperature may free it.
    """
    density, viscosity, capacity = properties_at(case.lubricant, temperature)
    relative = case.bearing.pad_relative_clearance
    turbulent = None if case.turbulence is None else film_turbulence(case.turbulence, relative, density)
    pads = case.bearing.film(viscosity, case.journal_speed, turbulent)
    resolution = case.accuracy.resolution
    if isinstance(case.duty, PrescribedLoad):
        load = case.duty.load * math.cos(case.load_angle), case.duty.load * math.sin(case.load_angle)
        solution = solve_with_light_pads(pads, load, resolution, LIGHT)
    else:
        solution = tilting_pads_at(pads, (case.duty.x, case.duty.y), resolution)
    if not solution.outcome.solved and solution.outcome is not Outcome.PAD_AT_LIMIT:
        raise NoFilmError(solution.outcome)
    entering = sum(pad.inflow for pad in solution.pads)
    trailing = sum(pad.outflow for pad in solution.pads)
    fresh, temperatures = entering - case.feed.carry_over * trailing, None
    if case.thermal is not Thermal.ISOTHERMAL and case.oil_supply is not None:
        if not fresh > 0.0:  # nothing carries their heat off
            raise NoFilmError(Outcome.THERMAL_RUNAWAY)
        balance = HeatBalance(case.lubricant, case.oil_supply.temperature, case.feed.carry_over)
        temperatures = mixed_temperatures(
            balance, solution.friction_power, trailing, entering - trailing, temperature
        )
    return PadFilms(temperature, density, viscosity, capacity, relative, solution, fresh, temperatures)
