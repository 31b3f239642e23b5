"""Design check of one bearing by its film: from the inputs to values, verdicts and doubts."""

from __future__ import annotations

import math
from collections.abc import Iterator
from time import perf_counter
from typing import TYPE_CHECKING

from babbitt.bearings.bore import LobedBore
from babbitt.bearings.extent import full_film_share, turbulent_share
from babbitt.bearings.grid_error import grid_errors
from babbitt.bearings.layout import ALL_TURBULENT, supply_numbers, without_pressure
from babbitt.bearings.model import FilmCase
from babbitt.bearings.orbit_answer import (
    orbit_assumptions,
    orbit_checks,
    orbit_doubts,
    orbit_failure,
    orbit_of,
    orbit_rows,
    orbit_values,
)
from babbitt.bearings.resting import doubts_about_rest, resting_places
from babbitt.bearings.thermal_answer import (
    doubts_about_heat,
    flow_without_pressure,
    stiffness_values,
    thermal_assumptions,
    thermal_rows,
    thermal_setting,
    thermal_values,
    with_own_coefficients,
)
from babbitt.bearings.thermal_film import settled_film
from babbitt.bearings.transition import transition_speed
from babbitt.bearings.warm_film import FilmState, under_found_load
from babbitt.bearings.whirl import Whirl, whirl_of
from babbitt.design.checks import USER, checks_not_made, clearance_check, limit_checks
from babbitt.design.conditions import GivenEccentricity, GivenPosition, contact_film
from babbitt.design.doubts import doubt_about_supply, doubts_about_film, doubts_about_running
from babbitt.design.failure import failure
from babbitt.design.screening import recommended_relative_clearance
from babbitt.design.values import (
    cooling_values,
    duty_values,
    heat_values,
    limit_values,
    oil_values,
    supply_values,
)
from babbitt.film.model import END_DAM, Cavitation
from babbitt.film.starved import FedFilm
from babbitt.notices import Notice
from babbitt.results import Bound, Check, Result

if TYPE_CHECKING:
    from babbitt.film.tilt import TiltCoefficients

METHOD = "film"

OIL_INVENTED_FROM = 0.05
"""Mass balance error above which a film without mass conservation is doubted."""

NO_MOMENT = 1e-10
"""Share of load times width below which a moment of the film is round-off."""

AXES = ("xx", "xy", "yx", "yy")


def film_check(case: FilmCase) -> Result:
    """Solve the film of a bearing with its global heat balance.

    Parameters
    ----------
    case : FilmCase

    Returns
    -------
    Result
        With a status in every case; the values of an unsolved case describe the last film reached.

    Notes
    -----
    The film has one viscosity, that at the effective temperature. As in ISO 7902 the oil enters with ``T_en``,
    leaves with ``T_ex``, and ``T_eff`` is the mean of both; without oil supply ``T_eff`` is that of the bearing.
    """
    start = perf_counter()
    found = settled_film(case)
    outcome, message = found.outcome, ""
    if not outcome.solved:
        message = failure(case, found)
    values: dict[str, float] = {}
    checks: tuple[Check, ...] = ()
    warnings = case.doubts
    not_made: tuple[Notice, ...] = ()
    arrays = {}
    if found.film is not None:
        state = found.film
        values, followed = _values(case, state), True
        if case.cavitation is not Cavitation.HALF_SOMMERFELD:
            arrays = {"stiffness": _rows(state.solution.stiffness), "damping": _rows(state.solution.damping)}
        if state.fed is not None:
            arrays["supply_fill"] = (_fills(case, state.fed),)
        if outcome.solved:
            if case.tilt_coefficients:
                from babbitt.film.tilt import tilt_coefficients

                tilt = tilt_coefficients(state.solution, case.accuracy.resolution)
                arrays |= {"tilt_stiffness": _rows(tilt.stiffness), "tilt_damping": _rows(tilt.damping)}
                values |= _tilt_values(tilt, state.load * case.bearing.width)
            if state.thermal is not None:
                arrays |= thermal_rows(case, state.thermal)
                state, followed = with_own_coefficients(case, state)
                arrays["stiffness"] = _rows(state.solution.stiffness)
            loaded = under_found_load(case, state)
            whirl = whirl_of(loaded, state) if case.cavitation is not Cavitation.HALF_SOMMERFELD else None
            values |= _running_values(loaded, state, whirl)
            values |= grid_errors(case, state) if case.error_estimate else {}
            checks = (*_limit_checks(case, values), *_whirl_checks(case, whirl), clearance_check(case, values))
            not_made = checks_not_made(case, values)
            warnings = tuple(_doubts(case, state, values, checks, whirl))
            if state.thermal is not None:
                values |= stiffness_values(state)
                warnings = (*warnings, *doubts_about_heat(case, state, values, followed))
            places = resting_places(case, state) if case.heat is None else None
            if places is not None:
                values["equilibria"] = float(len(places.places))
                warnings = (*warnings, *doubts_about_rest(places))
            orbit = orbit_of(case, state)
            if orbit is not None:
                outcome = orbit.outcome
                message = "" if outcome.solved else orbit_failure(orbit)
                values |= orbit_values(case, orbit)
                arrays["orbit"] = orbit_rows(orbit)
                checks = (*checks, *orbit_checks(checks, values))
                warnings = (*warnings, *orbit_doubts(case, orbit))
        values["iterations"] = float(found.evaluations)
    values["wall_time"] = perf_counter() - start
    return Result(
        case.name,
        case.kind,
        METHOD,
        outcome,
        {name: value for name, value in values.items() if not math.isnan(value)},
        checks,
        warnings,
        not_made,
        (*case.lubricant.assumptions, *case.assumptions, *_assumptions(case)),
        message,
        _settings(case),
        arrays,
    )


def _values(case: FilmCase, state: FilmState) -> dict[str, float]:
    bearing, film, thermal = case.bearing, state.solution, state.thermal
    duty = duty_values(case, state)
    coefficient = state.friction_power / (state.load * duty["surface_speed"])
    values = {
        "diameter": bearing.diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        "relative_clearance": bearing.relative_clearance,
        "operating_relative_clearance": state.relative_clearance,
        **_lobe_values(case, state),
        **duty,
        **oil_values(case, state),
        "sommerfeld_number": film.sommerfeld_number,
        "american_sommerfeld_number": 1.0 / (2.0 * math.pi * film.sommerfeld_number),
        "eccentricity_ratio": film.eccentricity_ratio,
        "attitude_angle": film.attitude_angle,
        "load_angle": math.atan2(-film.force[1], -film.force[0]),
        "minimum_film_thickness": film.minimum_film_thickness,
        "maximum_pressure": film.maximum_pressure,
        "friction_number": coefficient / state.relative_clearance,
        "friction_coefficient": coefficient,
        "friction_torque": case.friction_factor * film.friction_torque,
        "friction_power": state.friction_power,
        **_flow_values(case, state),
        **(
            heat_values(case, state) | supply_values(case, state)
            if thermal is None
            else thermal_values(case, state)
        ),
        "recommended_relative_clearance": recommended_relative_clearance(duty["surface_speed"]),
        **_extent_values(state),
    }
    if state.feed is not None:
        values["element_pressure"] = state.feed.element_pressure
        values["tube_loss"] = state.feed.tube_loss
        values["hole_loss"] = state.feed.hole_loss
    values |= (cooling_values(case, state) if thermal is None else {}) | limit_values(case)
    for name, matrix in (("stiffness", film.stiffness), ("damping", film.damping)):
        values |= {f"{name}_{axes}": float(one) for axes, one in zip(AXES, matrix.ravel(), strict=True)}
    values["mass_balance_error"] = film.mass_balance_error
    return values


def _tilt_values(tilt: TiltCoefficients, scale: float) -> dict[str, float]:
    """Moments and the corner of tilt; a moment that is round-off beside load times width counts as none."""
    moments = {f"film_moment_{axis}": float(one) for axis, one in zip("xy", tilt.moment, strict=True)}
    values = {name: one if abs(one) > NO_MOMENT * scale else 0.0 for name, one in moments.items()}
    for name, matrix in (("tilt_stiffness", tilt.stiffness), ("tilt_damping", tilt.damping)):
        own = matrix[2:, 2:].ravel()
        values |= {f"{name}_{axes}": float(one) for axes, one in zip(AXES, own, strict=True)}
    return values


def _rows(matrix: object) -> tuple[tuple[float, ...], ...]:
    import numpy as np

    return tuple(tuple(float(one) for one in row) for row in np.asarray(matrix))


def _lobe_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    bore = case.bearing.bore
    if not isinstance(bore, LobedBore):
        return {}
    clearance = 0.5 * state.relative_clearance * case.bearing.diameter
    return {"preload": bore.preload, "lobe_clearance": clearance / (1.0 - bore.preload)}


def _flow_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Flow by film pressure and by supply pressure: the latter is what the supply adds at the same position."""
    flow, film = state.total_flow, state.solution.film
    if math.isnan(flow):
        return {}
    calm = without_pressure(film)
    if calm == film:
        return {"side_flow": flow, "supply_flow": 0.0, "total_flow": flow}
    from babbitt.film.solve import film_at_position

    x, y = state.solution.position
    if state.thermal is None:
        alone = film_at_position(calm, (x, y), resolution=case.accuracy.resolution).leaving_flow
    else:
        alone = flow_without_pressure(case, state, calm)
    return {"side_flow": alone, "supply_flow": flow - alone, "total_flow": flow}


def _fills(case: FilmCase, fed: FedFilm) -> tuple[float, ...]:
    """Fill of every groove, pocket and hole in the order of the case."""
    return tuple(fed.fill[number] for number in supply_numbers(case, fed.solution.film))


def _extent_values(state: FilmState) -> dict[str, float]:
    """Where the film is full and where it is turbulent, and what the supplies of given flow do."""
    values, film = {}, state.solution.film
    if film.turbulence is not None:
        values["turbulent_share"] = turbulent_share(state.solution)
    if state.fed is not None:
        values |= {
            "full_film_share": full_film_share(state.solution),
            "least_fill": min(state.fed.fill),
            "given_flow": sum(state.fed.drawn) + state.fed.surplus,
            "surplus_flow": state.fed.surplus,
        }
    return values


def _running_values(case: FilmCase, state: FilmState, whirl: Whirl | None) -> dict[str, float]:
    values = {} if whirl is None else _whirl_values(case, whirl)
    contact = contact_film(case)
    slow = transition_speed(case, state, contact) if contact is not None else None
    if slow is not None:
        values["transition_speed"] = slow
    return values


def _limit_checks(case: FilmCase, values: dict[str, float]) -> Iterator[Check]:
    """Those of every method; a film that was solved as turbulent need not be laminar."""
    yield from (one for one in limit_checks(case, values) if one.code != "C110" or case.turbulence is None)


def _whirl_values(case: FilmCase, whirl: Whirl) -> dict[str, float]:
    values = {"rotor_mass": whirl.rotor_mass, "whirl_frequency_ratio": whirl.frequency_ratio}
    if math.isfinite(whirl.critical_mass):
        values["critical_mass"] = whirl.critical_mass
    if whirl.threshold_speed is not None:
        values["threshold_speed"] = whirl.threshold_speed
    if whirl.elastic is not None and case.shaft_stiffness is not None:
        values["shaft_stiffness"] = case.shaft_stiffness
        if math.isfinite(whirl.elastic.critical_mass):
            values["critical_mass_elastic"] = whirl.elastic.critical_mass
        if whirl.elastic.threshold_speed is not None:
            values["threshold_speed_elastic"] = whirl.elastic.threshold_speed
    return values


def _whirl_checks(case: FilmCase, whirl: Whirl | None) -> Iterator[Check]:
    if whirl is None:
        return
    own = case.rotor_mass is not None
    source = USER if own else "load over g, as if the load were the weight of the rotor"
    for name, critical in _critical_masses(whirl).items():
        if math.isfinite(critical):
            yield Check("C115", name, critical, whirl.rotor_mass, Bound.AT_LEAST, source, not own)


def _critical_masses(whirl: Whirl) -> dict[str, float]:
    rigid = {"critical_mass": whirl.critical_mass}
    return rigid if whirl.elastic is None else rigid | {"critical_mass_elastic": whirl.elastic.critical_mass}


def _doubts(
    case: FilmCase, state: FilmState, values: dict[str, float], checks: tuple[Check, ...], whirl: Whirl | None
) -> Iterator[Notice]:
    yield from case.doubts
    yield from (
        doubt for doubt in doubts_about_film(case, values) if doubt.code != "W101" or case.turbulence is None
    )
    if state.fed is not None and state.fed.starved:
        fills = ", ".join(f"{fill:.0%}" for fill in _fills(case, state.fed))
        flow = values["given_flow"] * 6e4
        yield Notice("W140", f"the supplies fill {fills} of the gap with the {flow:.3g} L/min given")
    if case.bearing_speed:
        yield Notice("W114", "the bearing rotates; friction power counts the journal speed only")
    yield from doubt_about_supply(state.feed is not None and state.feed.starved)
    if values["mass_balance_error"] > OIL_INVENTED_FROM:
        share = values["mass_balance_error"]
        yield Notice("W122", f"{share:.0%} of the oil that passes the film comes from nowhere")
    grooved = any(hollow.width is None for hollow in case.bearing.hollows)
    if grooved and without_pressure(state.solution.film) != state.solution.film:
        flow = values["supply_flow"] * 6e4
        yield Notice(
            "W121", f"supply flow of {flow:.2g} L/min from grooves as wide as the bearing: a rough estimate"
        )
    if case.error_estimate and "position_error" not in values and "load_error" not in values:
        yield Notice("W125", "the film on the finer grid was not found")
    if whirl is not None:
        yield from _doubts_about_whirl(whirl)
    yield from doubts_about_running(case, values, checks)


def _doubts_about_whirl(whirl: Whirl) -> Iterator[Notice]:
    least = min(_critical_masses(whirl).values())
    if least < whirl.rotor_mass:
        shaft = " on its elastic shaft" if whirl.elastic is not None else ""
        yield Notice(
            "W120",
            f"critical mass{shaft} {least:.4g} kg < {whirl.rotor_mass:.4g} kg; whirl at "
            f"{whirl.frequency_ratio:.2f} of the speed",
        )


def _assumptions(case: FilmCase) -> Iterator[str]:
    flow = "laminar film" if case.turbulence is None else f"turbulence after {case.turbulence.name}"
    if case.heat is None:
        yield f"One viscosity for the whole film, that at the effective temperature; rigid surfaces; {flow}."
    else:
        yield from thermal_assumptions(case, flow)
    if case.turbulence is not None:
        yield (
            f"The film is laminar up to the local Reynolds number 41.3 sqrt(D/C) and fully turbulent from "
            f"{ALL_TURBULENT:g} times that number."
        )
    if case.pressure_viscosity is not None:
        law = case.pressure_viscosity
        yield (
            f"Viscosity grows with pressure after {law.law.value.capitalize()}, {law.coefficient * 1e9:.3g} 1/GPa "
            "at ambient pressure."
        )
    if _flows_given(case):
        yield (
            "Supplies of given flow: oil that a flooded film does not draw returns without passing it; stiffness, "
            "damping and thresholds hold for the fills of the operating point; no oil is stored in grooves."
        )
    grooves = [hollow for hollow in case.bearing.hollows if hollow.width is None]
    if any(hollow.pressure != 0.0 for hollow in grooves) and case.oil_supply is not None:
        yield (
            f"The pressure of grooves as wide as the bearing falls to that of the sides over the last "
            f"{100.0 * END_DAM:g} % of the width at either end."
        )
    if case.bearing.side_pressures != (0.0, 0.0):
        yield "Oil that a side under pressure presses into the film is as warm as that of the supply."
    if case.bearing.hollows:
        yield "Grooves, pockets and holes are deep: the oil in them is not sheared."
    if case.changing_load is not None:
        yield from orbit_assumptions(case)
    if case.cavitation is Cavitation.HALF_SOMMERFELD:
        yield "Half-Sommerfeld film: neither flows nor stiffness, damping and threshold of whirl follow from it."
    elif case.rotor_mass is None:
        yield "The mass of the rotor is not given: stability is judged as if the load were its weight."
    by_attitude = isinstance(case.duty, GivenEccentricity) and case.duty.attitude_angle is not None
    if by_attitude or isinstance(case.duty, GivenPosition):
        yield "The position is prescribed: the load found need not point along the load angle."
    if case.effective_temperature is not None:
        yield (
            f"Effective temperature prescribed: {case.effective_temperature - 273.15:.1f} °C; heat balance "
            f"not closed."
        )


def _flows_given(case: FilmCase) -> bool:
    common = case.oil_supply is not None and case.oil_supply.flow is not None
    return common or any(hollow.flow is not None for hollow in case.bearing.hollows)


def _settings(case: FilmCase) -> dict[str, str]:
    """The choices that the numbers depend on."""
    grooves = sum(hollow.width is None for hollow in case.bearing.hollows)
    orbit = {} if case.changing_load is None else {"orbit_cavitation": Cavitation.REYNOLDS.name.lower()}
    return orbit | {
        "lubricant": case.lubricant.name,
        "thermal": thermal_setting(case),
        "cavitation": case.cavitation.name.lower(),
        "film_start": case.bearing.film_start.name.lower(),
        "accuracy": case.accuracy.value,
        "rotation": case.rotation.value,
        "bore": type(case.bearing.bore).__name__,
        "grooves": str(grooves),
        "pockets": str(len(case.bearing.hollows) - grooves),
        "friction_factor": f"{case.friction_factor:g}",
        "turbulence": case.turbulence.name if case.turbulence is not None else "laminar",
        "pressure_viscosity": case.pressure_viscosity.law.value if case.pressure_viscosity is not None else "none",
    }
