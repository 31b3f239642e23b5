"""Named results that every method gives in the same way."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Protocol

from babbitt.design.conditions import CheckedProblem, contact_film, sliding_speed, surface_speed
from babbitt.design.heat_balance import FilmAtTemperature, heat_paths, outlet_temperature
from babbitt.design.numbers import critical_reynolds_number, film_reynolds_number
from babbitt.properties.materials import empirical_minimum_film_thickness

Named = dict[str, float]


class DesignFilm(FilmAtTemperature, Protocol):
    """What the named results need to know of a film of any method, SI."""

    @property
    def relative_clearance(self) -> float: ...  # noqa: D102
    @property
    def density(self) -> float: ...  # noqa: D102
    @property
    def viscosity(self) -> float: ...  # noqa: D102
    @property
    def load(self) -> float: ...  # noqa: D102


def hydrodynamic_speed(case: CheckedProblem) -> float:
    """Effective hydrodynamic speed ``ω_h = ω_J + ω_B`` in rad/s, whichever way it turns."""
    return abs(case.journal_speed + case.bearing_speed)


def friction_between(case: CheckedProblem, shear: float, pressure: float) -> tuple[float, float]:
    """Friction torque on the journal in N m, and friction power in W, where the bearing may turn, too.

    The film is that of a bearing at rest in which the journal turns with ``ω_h = ω_J + ω_B``, but its oil is
    sheared with ``ω_J - ω_B``. With T_s the torque of that shear, ``M_J = T_s + F e sin(β)/2`` on the journal and
    ``M_B = T_s - F e sin(β)/2`` on the bearing do the work ``P = M_J ω_J - M_B ω_B``.

    Parameters
    ----------
    case : CheckedProblem
    shear : float
        Torque of shear with a bearing at rest and a journal that turns with ω_h, N m.
    pressure : float
        Torque ``F e sin(β)/2`` of the pressure on the journal, N m.
    """
    turning = case.journal_speed + case.bearing_speed
    sliding = (case.journal_speed - case.bearing_speed) / turning
    return sliding * shear + pressure, abs(turning) * (sliding**2 * shear + pressure)


def duty_values(case: CheckedProblem, film: DesignFilm) -> Named:
    """Load and speed."""
    pressure, speed = film.load / (case.bearing.loaded_width * case.bearing.diameter), surface_speed(case)
    return {
        "load": film.load,
        "specific_load": pressure,
        "angular_speed": case.journal_speed,
        "hydrodynamic_speed": hydrodynamic_speed(case),
        "surface_speed": speed,
        "pressure_speed_product": pressure * sliding_speed(case),
    }


def oil_values(case: CheckedProblem, film: DesignFilm) -> Named:
    """The oil at the effective temperature, and whether the film is laminar."""
    psi, diameter = film.relative_clearance, case.bearing.diameter
    reynolds = film_reynolds_number(film.density, sliding_speed(case), psi, diameter, film.viscosity)
    return {
        "film_reynolds_number": reynolds,
        "critical_reynolds_number": critical_reynolds_number(psi),
        "effective_viscosity": film.viscosity,
        "effective_kinematic_viscosity": film.viscosity / film.density,
        "density": film.density,
        "volumetric_heat_capacity": film.volumetric_heat_capacity,
    }


def heat_values(case: CheckedProblem, film: DesignFilm) -> Named:
    """The temperature and where the heat goes; the latter is unknown at a temperature that is prescribed."""
    values = {"effective_temperature": film.temperature}
    if case.effective_temperature is not None or (case.oil_supply is None and case.cooling is None):
        return values
    to_oil, to_surroundings = heat_paths(film, case)
    open_balance = film.friction_power - to_oil - to_surroundings
    return values | {
        "heat_to_oil": to_oil,
        "heat_to_surroundings": to_surroundings,
        "energy_balance_error": open_balance / film.friction_power,
    }


def supply_values(case: CheckedProblem, film: DesignFilm) -> Named:
    """Oil that comes and goes; empty without a supply.

    The temperature of the oil that goes follows from the heat balance: none is given at a temperature that is
    prescribed, at which the film makes another heat than the oil would carry away.
    """
    leaving = outlet_temperature(film.temperature, case)
    if case.oil_supply is None or leaving is None:
        return {}
    values = {"supply_temperature": case.oil_supply.temperature}
    if case.effective_temperature is None:
        values["outlet_temperature"] = leaving
    if case.oil_supply.flow is None:
        values["supply_pressure"] = case.oil_supply.pressure
    return values


def cooling_values(case: CheckedProblem, film: DesignFilm) -> Named:
    """What the housing cools; empty without cooling."""
    if case.cooling is None:
        return {}
    return {"ambient_temperature": case.cooling.ambient_temperature, "bearing_temperature": film.temperature}


def limit_values(case: CheckedProblem) -> Named:
    """Film thicknesses that limit the film, as far as the case and experience know them."""
    values: Named = {}
    experience = empirical_minimum_film_thickness(case.bearing.diameter, surface_speed(case), case.limits.tables)
    if experience is not None:
        values["empirical_film_limit"] = experience
    if case.bearing.surfaces is not None:
        values["geometric_film_limit"] = case.bearing.surfaces.film_limit
    elif case.bearing.edge_loss > 0.0:  # without the roughness, which is at least zero
        values["geometric_film_limit"] = case.bearing.edge_loss
    contact = contact_film(case)
    if contact is not None:
        values["transition_film_thickness"] = contact
    return values


def pumped_flow(values: Mapping[str, float]) -> float:
    """Oil in m³/s that a pump brings to a bearing; NaN where its flow is not known.

    What leaves the film, less what its sides draw in from the surroundings, and the part of a given flow that
    returns without passing the film.
    """
    leaving = values.get("total_flow", math.nan)
    return leaving - values.get("side_inflow", 0.0) + values.get("surplus_flow", 0.0)
