"""ISO 7902 design check of one bearing at one operating point: from inputs to values, verdicts and warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from time import perf_counter

from babbitt.core.notices import Notice
from babbitt.core.result import Check, Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import contact_film
from babbitt.design.failure import failure_of
from babbitt.design.heat_balance import Equilibrium, at_prescribed_temperature, find_equilibrium
from babbitt.design.numbers import minimum_film_thickness
from babbitt.design.own_limits import checks_by_experience
from babbitt.design.screening import recommended_relative_clearance
from babbitt.design.values import (
    cooling_values,
    duty_values,
    heat_values,
    limit_values,
    oil_values,
    supply_values,
)
from babbitt.kinds.journal.iso7902.checks import checks_not_made, checks_of, whirl_not_checked
from babbitt.kinds.journal.iso7902.film import Film, SuppliedFilm, curves_of, film_at, supplied_film
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.iso7902.screening import Transition, orlov_relative_clearance, transition
from babbitt.kinds.journal.iso7902.supply_capacity import (
    assumptions_about_capacity,
    capacity_check,
    capacity_not_checked,
    starved_equilibrium,
    starved_values,
    warnings_about_capacity,
    worse_of,
)
from babbitt.kinds.journal.iso7902.warnings import all_warnings

METHOD = "iso7902"


def check(case: DesignCase) -> Result:
    """Run the ISO 7902 procedure at the clearance of a bearing, whatever the limits of that.

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
    if case.effective_temperature is not None:
        return check_at_temperature(case, case.effective_temperature)
    start = perf_counter()
    found = _supplied(case, find_equilibrium(case, partial(film_at, case=case, shape=curves_of(case))))
    return _result(case, found, _starved(case, found), start)


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
        As of `check`, but for what only a heat balance tells: the outlet temperature and the heat carried away.
    """
    start = perf_counter()
    celsius = effective_temperature - ZERO_CELSIUS
    stated = f"effective temperature prescribed: {celsius:.1f} °C; heat balance not closed"
    prescribed = replace(
        case, effective_temperature=effective_temperature, assumptions=(*case.assumptions, stated)
    )
    film_of = partial(film_at, case=case, shape=curves_of(case))
    found = _supplied(case, at_prescribed_temperature(effective_temperature, film_of))
    return _result(prescribed, found, None, start)


def _supplied(case: DesignCase, found: Equilibrium[Film]) -> Equilibrium[SuppliedFilm]:
    """The equilibrium with what the supply of its film can deliver."""
    film = None if found.film is None else supplied_film(case, found.film)
    return Equilibrium(found.outcome, film, found.evaluations, found.last_temperature, found.failure)


def _starved(case: DesignCase, found: Equilibrium[SuppliedFilm]) -> Equilibrium[Film] | None:
    """The heat balance with what the supply delivers, where a film found wants more."""
    return starved_equilibrium(case, found.film) if found.film is not None and found.outcome.solved else None


@dataclass(frozen=True)
class Design:
    """What a film comes to: values and checks, those of the film with less oil included.

    `hotter` are the values of that film, where there is one; `change` is where mixed friction begins. `replaced`
    are the limits that those of the case stand in place of.
    """

    values: Mapping[str, float]
    checks: tuple[Check, ...]
    hotter: Mapping[str, float]
    change: Transition | None
    replaced: tuple[Check, ...]


def design_of(case: DesignCase, film: SuppliedFilm, starved: Equilibrium[Film] | None) -> Design:
    """Values and checks of a film, and of the one with less oil; the limits are held against the worse of both."""
    change = _transition(case, film)
    values = _values(case, film, change)
    checks, replaced = checks_of(case, values), checks_by_experience(case, values)
    hotter: dict[str, float] = {}
    if starved is not None and starved.film is not None and starved.outcome.solved:
        hotter = _values(case, starved.film, _transition(case, starved.film))
        checks = worse_of(checks, checks_of(case, hotter))
        replaced = worse_of(replaced, checks_by_experience(case, hotter))
        values |= starved_values(hotter)
    return Design(values, (*checks, *capacity_check(film, starved)), hotter, change, replaced)


def warnings_of(
    case: DesignCase, film: SuppliedFilm, starved: Equilibrium[Film] | None, design: Design
) -> tuple[Notice, ...]:
    """All remarks about a film that was found, those about its supply last."""
    about_supply = tuple(warnings_about_capacity(case, film, starved, design.hotter))
    worse = {warning.code for warning in about_supply}
    of_film = all_warnings(case, film, design.values, design.checks, design.replaced, design.change)
    return (*(one for one in of_film if one.code not in worse), *about_supply)


def _result(
    case: DesignCase, found: Equilibrium[SuppliedFilm], starved: Equilibrium[Film] | None, start: float
) -> Result:
    """Values, verdicts and warnings of the film found, or how far an unsolved case came."""
    if found.film is None:
        return Result(
            case.name,
            case.kind,
            METHOD,
            found.outcome,
            {"wall_time": perf_counter() - start},
            warnings=case.warnings,
            assumptions=(*case.lubricant.assumptions_but_of_conduction, *case.assumptions),
            settings=_settings(case),
            failure=failure_of(case, found),
        )
    return result_of(case, found, starved, design_of(case, found.film, starved), start)


def result_of(
    case: DesignCase,
    found: Equilibrium[SuppliedFilm],
    starved: Equilibrium[Film] | None,
    design: Design,
    start: float,
) -> Result:
    """The result of a film that was found, or reached last.

    Parameters
    ----------
    case : DesignCase
    found, starved : Equilibrium
        With all the oil that the film wants, and with what the supply delivers where that is less.
    design : Design
        What they come to.
    start : float
        When the calculation began.
    """
    assert found.film is not None, "design is of it"
    values, checks = dict(design.values), design.checks
    warnings = warnings_of(case, found.film, starved, design) if found.outcome.solved else case.warnings
    values["iterations"] = float(found.evaluations)
    values["wall_time"] = perf_counter() - start
    not_checked = (
        *checks_not_made(case, values),
        *whirl_not_checked(case),
        *capacity_not_checked(case, found.film),
    )
    return Result(
        case.name,
        case.kind,
        METHOD,
        found.outcome,
        values,
        checks if found.outcome.solved else (),
        warnings,
        not_checked if found.outcome.solved else (),
        (
            *case.lubricant.assumptions_but_of_conduction,
            *case.assumptions,
            *assumptions_about_heat(case),
            *assumptions_about_capacity(case, found.film),
        ),
        settings=_settings(case),
        failure=None if found.outcome.solved else failure_of(case, found),
    )


def assumptions_about_heat(case: DesignCase) -> Iterator[str]:
    """What the heat balance of the standard takes for granted, where it is made."""
    if case.effective_temperature is not None:
        return
    mean = "Heat balance of ISO 7902-1: T_eff = (T_en + T_ex)/2"
    if case.oil_supply is None:
        yield "Heat balance of ISO 7902-1: T_eff is that of the bearing; the surroundings take all heat of it."
    elif case.cooling is None:
        yield f"{mean}; all heat of friction leaves with the oil."
    else:
        yield f"{mean}; all heat of friction leaves with the oil and to the surroundings."


def _values(case: DesignCase, film: Film, change: Transition | None) -> dict[str, float]:
    bearing, shape = case.bearing, curves_of(case)
    diameter, eccentricity = bearing.diameter, film.eccentricity_ratio
    duty = duty_values(case, film)
    coefficient = film.friction_number * film.relative_clearance
    values = {
        "diameter": diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        **_half_bearings(case),
        "angular_span": math.radians(bearing.span),
        "relative_clearance": bearing.relative_clearance,
        "operating_relative_clearance": film.relative_clearance,
        **duty,
        **oil_values(case, film),
        "sommerfeld_number": film.sommerfeld_number,
        "american_sommerfeld_number": 1.0 / (2.0 * math.pi * film.sommerfeld_number),
        "eccentricity_ratio": eccentricity,
        "attitude_angle": shape.attitude_angle(eccentricity),
        "minimum_film_thickness": minimum_film_thickness(eccentricity, film.relative_clearance, diameter),
        "maximum_pressure": shape.pressure_ratio(eccentricity) * duty["specific_load"],
        "friction_number": film.friction_number,
        "friction_coefficient": coefficient,
        "friction_torque": coefficient * film.load * diameter / 2.0,
        "friction_power": film.friction_power,
        "side_flow_number": film.side_flow_number,
        "side_flow": film.side_flow,
        "supply_flow": film.supply_flow,
        "total_flow": film.total_flow,
        **heat_values(case, film),
        "stability_relative_clearance": orlov_relative_clearance(
            film.viscosity, duty["hydrodynamic_speed"], duty["specific_load"], bearing.part_width_ratio
        ),
        "recommended_relative_clearance": recommended_relative_clearance(duty["surface_speed"]),
        **supply_values(case, film),
    }
    values |= film.feed_values() | cooling_values(case, film) | limit_values(case)
    if case.load_angle is not None:
        values["load_angle"] = case.load_angle
    if change is not None:
        values["transition_speed"] = change.speed
    return values


def _half_bearings(case: DesignCase) -> dict[str, float]:
    """Width of each of two half bearings beside a groove around the circumference; empty without one."""
    bearing = case.bearing
    if bearing.parts == 1:
        return {}
    return {"half_bearing_width": bearing.part_width, "half_bearing_width_ratio": bearing.part_width_ratio}


def _settings(case: DesignCase) -> dict[str, str]:
    """The choices that the numbers depend on."""
    element, parts = case.bearing.supply_element, case.bearing.parts
    halves = {"half_bearings": f"{parts} of {case.bearing.part_width * 1e3:.4g} mm"} if parts > 1 else {}
    return {
        "lubricant": case.lubricant.name,
        "characteristics": case.curves.value,
        "friction": case.friction.value,
        "friction_factor": f"{case.friction_factor:g}",
        "span": f"{case.bearing.span} deg",
        "supply_element": type(element).__name__ if element else "none",
        **halves,
    }


def _transition(case: DesignCase, film: Film) -> Transition | None:
    contact = contact_film(case)
    if contact is None:
        return None
    bearing = case.bearing
    return transition(
        contact,
        bearing.diameter,
        film.relative_clearance,
        film.viscosity,
        film.load / (bearing.loaded_width * bearing.diameter),
        curves_of(case),
    )
