"""The films of pads with their own temperatures, at the heat capacity that belongs to these."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.heat_balance import CEILING, Equilibrium, NoFilmError
from babbitt.design.oil import bounded_viscosity, highest_usable, properties_at
from babbitt.kinds.tilting_pad_journal.model import LIGHT, HeatChoices, PadCase
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_heat import PadHeat
from babbitt.reynolds.tilting_pads.thermal_pad_solution import PadTemperatures, ThermalTiltingPadSolution
from babbitt.reynolds.tilting_pads.thermal_pads import thermal_pads_with_light_ones, thermal_tilting_pads_at

__all__ = ["LEAST_CLEARANCE", "pad_heat", "thermal_films"]

MOST_ROUNDS = 10
SAME_TEMPERATURE = 0.05
"""Change of the mean temperature in K at which density and heat capacity count as settled."""

TOO_HOT = (Outcome.THERMAL_RUNAWAY, Outcome.NO_LUBRICANT_DATA)
LEAST_CLEARANCE = 1e-12
"""Clearance in m that stands for none: of bearings that growth has closed, which are not solved."""


def thermal_films(case: PadCase) -> Equilibrium[PadFilms]:
    """Films with their own temperatures in equilibrium with journal, pads, bending and growth.

    Always ends with a status; the films of an unsolved bearing are where the search ended.
    """
    assert case.oil_supply is not None
    temperature = case.oil_supply.temperature
    for rounds in range(1, MOST_ROUNDS + 1):
        try:
            found = found_at(case, temperature)
        except NoFilmError as failure:
            return Equilibrium(failure.outcome, None, rounds, temperature, failure)
        outcome = outcome_of(case, found)
        before, temperature = temperature, mean_temperature(found)
        if outcome in TOO_HOT:
            return Equilibrium(outcome, None, rounds, highest_usable(case.lubricant))
        if not math.isfinite(temperature):
            return Equilibrium(outcome, None, rounds, before)
        goes_on = outcome.solved or outcome is Outcome.PAD_AT_LIMIT  # which the properties of the oil may change
        known = abs(temperature - before) <= SAME_TEMPERATURE or heat_of_oil(case, before) == heat_of_oil(
            case, temperature
        )
        if not goes_on or known:
            return Equilibrium(outcome, films_of(case, found, temperature), rounds, temperature)
    return Equilibrium(Outcome.NOT_CONVERGED, films_of(case, found, temperature), MOST_ROUNDS, temperature)


def pad_heat(case: PadCase, heat: HeatChoices, temperature: float) -> PadHeat:
    """Heat of films, pads and journal, with oil of the heat capacity and conductivity of a temperature in K.

    Fresh oil whose temperature is not known is as warm as that.
    """
    capacity, conductivity = heat_of_oil(case, temperature)
    supply = temperature if case.oil_supply is None else case.oil_supply.temperature
    return PadHeat(
        bounded_viscosity(case.lubricant), capacity, conductivity, supply,
        heat.journal, heat.walls, heat.bending, heat.growth, carry_over=case.feed.carry_over,
        materials=heat.materials,
    )  # fmt: skip


def heat_of_oil(case: PadCase, temperature: float) -> tuple[float, float]:
    """Heat capacity in J/(m³ K) and conductivity in W/(m K) of the oil at a temperature in K."""
    return properties_at(case.lubricant, temperature)[2], case.lubricant.conductivity(temperature)


def found_at(case: PadCase, temperature: float) -> ThermalTiltingPadSolution:
    """Films at the heat capacity and conductivity that the oil has at a temperature in K."""
    model = pad_heat(case, case.heat, temperature)
    _, fresh_viscosity, _ = properties_at(case.lubricant, model.supply_temperature)
    pads = case.bearing.film(fresh_viscosity, case.journal_speed)
    resolution = case.accuracy.thermal_resolution
    if isinstance(case.duty, PrescribedLoad):
        load = case.duty.load * math.cos(case.load_angle), case.duty.load * math.sin(case.load_angle)
        return thermal_pads_with_light_ones(pads, load, model, resolution, LIGHT)
    return thermal_tilting_pads_at(pads, (case.duty.x, case.duty.y), model, resolution)


def outcome_of(case: PadCase, found: ThermalTiltingPadSolution) -> Outcome:
    """How the search ended, with oil that is hotter than its laws reach."""
    hottest = found.maximum_temperature
    if math.isfinite(hottest) and hottest >= (usable := highest_usable(case.lubricant)):
        return Outcome.THERMAL_RUNAWAY if usable >= CEILING else Outcome.NO_LUBRICANT_DATA
    return found.outcome


def mean_temperature(found: ThermalTiltingPadSolution) -> float:
    """Of all films, by their area, K."""
    bearing = found.bearing
    areas = [pad.extent * (bearing.width if pad.width is None else pad.width) for pad in bearing.pads]
    return float(np.average([film_temperature(pad) for pad in found.temperatures], weights=areas))


def film_temperature(pad: PadTemperatures) -> float:
    """Mean over the film of a pad, K."""
    mean = pad.film_mean
    return float(mean[:-1].mean() + mean[1:].mean()) / 2.0


def films_of(case: PadCase, found: ThermalTiltingPadSolution, temperature: float) -> PadFilms:
    """The films with the bearing that runs."""
    density, viscosity, capacity = properties_at(case.lubricant, temperature)
    return PadFilms(
        temperature, density, viscosity, capacity, case.bearing.pad_relative_clearance,
        replace(found, bearing=running_bearing(case, found, viscosity)), found.supplied_flow, None,
    )  # fmt: skip


def running_bearing(case: PadCase, found: ThermalTiltingPadSolution, viscosity: float) -> TiltingPadBearing:
    """The bearing as heat leaves it, with the viscosity of every pad at the mean temperature of its film."""
    pads = tuple(
        running_pad(case, pad, heat, found.bearing.sense)
        for pad, heat in zip(found.bearing.pads, found.temperatures, strict=True)
    )
    return replace(found.bearing, pads=pads, viscosity=viscosity)


def running_pad(case: PadCase, pad: TiltingPad, heat: PadTemperatures, sense: float) -> TiltingPad:
    """A pad grown and bent. What its bore comes nearer its thickness takes: the pivot keeps its radius."""
    bent = heat.deflection if sense > 0.0 else heat.deflection[::-1]
    _, viscosity, _ = properties_at(case.lubricant, film_temperature(heat))
    return replace(
        pad,
        clearance=max(pad.clearance - heat.growth, LEAST_CLEARANCE),
        assembled_clearance=max(pad.assembled_clearance - heat.growth, LEAST_CLEARANCE),
        thickness=pad.thickness + heat.growth,
        viscosity=viscosity,
        profile=tuple(float(one) for one in bent) if bent.any() else pad.profile,
    )
