"""ISO 7902 design check of one bearing at one operating point: from the inputs to values, verdicts and doubts."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from time import perf_counter

from babbitt.materials import empirical_minimum_film_thickness
from babbitt.notices import EXPLANATIONS
from babbitt.results import Outcome, Result
from babbitt.standards.iso7902.checks import checks_not_made, checks_of
from babbitt.standards.iso7902.doubts import doubts_of
from babbitt.standards.iso7902.film import (
    Film,
    critical_reynolds_number,
    curves_of,
    film_at,
    film_reynolds_number,
    hydrodynamic_speed,
    minimum_film_thickness,
    surface_speed,
)
from babbitt.standards.iso7902.heat_balance import (
    Equilibrium,
    at_prescribed_temperature,
    find_equilibrium,
    heat_paths,
    outlet_temperature,
)
from babbitt.standards.iso7902.model import DesignCase, GivenLoad
from babbitt.standards.iso7902.screening import (
    Transition,
    orlov_relative_clearance,
    recommended_relative_clearance,
    transition,
)

METHOD = "iso7902"


def check(case: DesignCase) -> Result:
    """Run the ISO 7902 procedure.

    Parameters
    ----------
    case : DesignCase

    Returns
    -------
    Result
        With a status in every case; the values of an unsolved case describe the last film reached.

    Notes
    -----
    ISO 7902-1, DIN 31652: effective clearance, Reynolds number, Sommerfeld number, eccentricity, film thickness,
    friction, flows, heat balance iterated on the effective temperature. The characteristics are solutions of the
    Reynolds equation by this package, not the tables of the standard.
    """
    start = perf_counter()
    found = find_equilibrium(case, partial(film_at, case=case, shape=curves_of(case)))
    return _result(case, found, start)


def check_at_temperature(case: DesignCase, effective_temperature: float) -> Result:
    """Run the ISO 7902 procedure at a prescribed effective temperature, without the heat balance.

    For repeating a calculation whose temperature is known, or a film whose temperature was measured.

    Parameters
    ----------
    case : DesignCase
    effective_temperature : float
        In K.

    Returns
    -------
    Result
        As of `check`; `energy_balance_error` says how far the heat balance stays open.
    """
    start = perf_counter()
    stated = f"effective temperature prescribed: {effective_temperature - 273.15:.1f} °C; heat balance not closed"
    prescribed = replace(case, assumptions=(*case.assumptions, stated))
    film_of = partial(film_at, case=case, shape=curves_of(case))
    return _result(prescribed, at_prescribed_temperature(effective_temperature, film_of), start)


def _result(case: DesignCase, found: Equilibrium, start: float) -> Result:
    """Values, verdicts and doubts of the film found, or how far an unsolved case came."""
    if found.film is None:
        return Result(
            case.name,
            case.kind,
            METHOD,
            found.outcome,
            {"wall_time": perf_counter() - start},
            warnings=case.doubts,
            assumptions=(*case.lubricant.assumptions, *case.assumptions),
            message=_failure(case, found),
            settings=_settings(case),
        )
    change = _transition(case, found.film)
    values = _values(case, found.film, change)
    checks = checks_of(case, values)
    warnings = doubts_of(case, found.film, values, checks, change) if found.outcome.solved else case.doubts
    values["iterations"] = float(found.evaluations)
    values["wall_time"] = perf_counter() - start
    return Result(
        case.name,
        case.kind,
        METHOD,
        found.outcome,
        values,
        checks if found.outcome.solved else (),
        warnings,
        checks_not_made(case, values) if found.outcome.solved else (),
        (*case.lubricant.assumptions, *case.assumptions),
        "" if found.outcome.solved else _failure(case, found),
        _settings(case),
    )


def _values(case: DesignCase, film: Film, change: Transition | None) -> dict[str, float]:
    bearing, shape = case.bearing, curves_of(case)
    diameter, eccentricity = bearing.diameter, film.eccentricity_ratio
    specific_load = film.load / (bearing.width * diameter)
    speed = surface_speed(case)
    coefficient = film.friction_number * film.relative_clearance
    to_oil, to_surroundings = heat_paths(film, case)
    values = {
        "diameter": diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        "angular_span": math.radians(bearing.span),
        "relative_clearance": bearing.relative_clearance,
        "operating_relative_clearance": film.relative_clearance,
        "load": film.load,
        "specific_load": specific_load,
        "angular_speed": abs(case.journal_speed),
        "hydrodynamic_speed": hydrodynamic_speed(case),
        "surface_speed": speed,
        "pressure_speed_product": specific_load * speed,
        "film_reynolds_number": film_reynolds_number(film, case),
        "critical_reynolds_number": critical_reynolds_number(film.relative_clearance),
        "effective_viscosity": film.viscosity,
        "effective_kinematic_viscosity": film.viscosity / film.density,
        "density": film.density,
        "volumetric_heat_capacity": film.volumetric_heat_capacity,
        "sommerfeld_number": film.sommerfeld_number,
        "american_sommerfeld_number": 1.0 / (2.0 * math.pi * film.sommerfeld_number),
        "eccentricity_ratio": eccentricity,
        "attitude_angle": shape.attitude_angle(eccentricity),
        "minimum_film_thickness": minimum_film_thickness(eccentricity, film.relative_clearance, diameter),
        "maximum_pressure": shape.pressure_ratio(eccentricity) * specific_load,
        "friction_number": film.friction_number,
        "friction_coefficient": coefficient,
        "friction_torque": coefficient * film.load * diameter / 2.0,
        "friction_power": film.friction_power,
        "side_flow_number": film.side_flow_number,
        "side_flow": film.side_flow,
        "supply_flow": film.supply_flow,
        "total_flow": film.total_flow,
        "effective_temperature": film.temperature,
        "heat_to_oil": to_oil,
        "heat_to_surroundings": to_surroundings,
        "energy_balance_error": (film.friction_power - to_oil - to_surroundings) / film.friction_power,
        "stability_relative_clearance": orlov_relative_clearance(
            film.viscosity, hydrodynamic_speed(case), specific_load, bearing.width_ratio
        ),
        "recommended_relative_clearance": recommended_relative_clearance(speed),
    }
    leaving = outlet_temperature(film.temperature, case)
    if case.oil_supply is not None and leaving is not None:
        values["supply_temperature"] = case.oil_supply.temperature
        values["outlet_temperature"] = leaving
        values["supply_pressure"] = case.oil_supply.pressure
    if film.feed is not None:
        values["supply_flow_number"] = film.feed.flow_number
        values["element_pressure"] = film.feed.element_pressure
        values["tube_loss"] = film.feed.tube_loss
        values["hole_loss"] = film.feed.hole_loss
    if case.cooling is not None:
        values["ambient_temperature"] = case.cooling.ambient_temperature
        values["bearing_temperature"] = film.temperature
    experience = empirical_minimum_film_thickness(diameter, speed)
    if experience is not None:
        values["empirical_film_limit"] = experience
    if bearing.surfaces is not None:
        values["geometric_film_limit"] = bearing.surfaces.film_limit
    contact = _contact_film(case)
    if contact is not None:
        values["transition_film_thickness"] = contact
    if change is not None:
        values["transition_speed"] = change.speed
    return values


def _settings(case: DesignCase) -> dict[str, str]:
    """The choices that the numbers depend on."""
    element = case.bearing.supply_element
    return {
        "lubricant": case.lubricant.name,
        "characteristics": case.curves.value,
        "friction": case.friction.value,
        "friction_factor": f"{case.friction_factor:g}",
        "span": f"{case.bearing.span} deg",
        "supply_element": type(element).__name__ if element else "none",
    }


def _contact_film(case: DesignCase) -> float | None:
    """Film thickness in m at which mixed friction begins: of the case, else of the surfaces."""
    if case.limits.transition_film_thickness is not None:
        return case.limits.transition_film_thickness
    return case.bearing.surfaces.film_limit if case.bearing.surfaces else None


def _transition(case: DesignCase, film: Film) -> Transition | None:
    contact = _contact_film(case)
    if contact is None:
        return None
    bearing = case.bearing
    return transition(
        contact,
        bearing.diameter,
        film.relative_clearance,
        film.viscosity,
        film.load / (bearing.width * bearing.diameter),
        curves_of(case),
    )


def _failure(case: DesignCase, found: Equilibrium) -> str:
    """How far an unsolved case came, and what to try."""
    reached = f"{found.last_temperature - 273.15:.1f} °C"
    match found.outcome:
        case Outcome.OVERLOADED:
            capacity = f"{found.capacity / 1e3:.4g} kN" if found.capacity is not None else "too little"
            far = f"at {reached} the film carries {capacity} at the largest eccentricity, 0.99"
            if isinstance(case.duty, GivenLoad):
                far += f", less than the load of {case.duty.load / 1e3:.4g} kN"
        case Outcome.THERMAL_RUNAWAY:
            far = f"at {reached} the friction power still exceeds the heat carried away"
        case Outcome.NO_CLEARANCE:
            far = f"the clearance is used up at {reached}"
        case Outcome.NO_LUBRICANT_DATA:
            far = f"the laws of {case.lubricant.name} were followed to {reached}"
        case _:
            far = f"the last effective temperature was {reached}"
    remedy = EXPLANATIONS[found.outcome.code].remedy
    return f"{far}. Try: {remedy[0].lower()}{remedy[1:]}"
