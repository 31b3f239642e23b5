"""The numbers of a bearing whose film is known: what was given, what the film does, coefficients."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import AXES
from babbitt.design.screening import recommended_relative_clearance
from babbitt.design.values import (
    cooling_values,
    duty_values,
    heat_values,
    limit_values,
    oil_values,
    supply_values,
)
from babbitt.kinds.journal.film.bore import LobedBore
from babbitt.kinds.journal.film.extent import full_film_share, turbulent_share
from babbitt.kinds.journal.film.field import highest_pressure, narrowest_gap_angle
from babbitt.kinds.journal.film.isothermal import FilmState, friction_of, load_found
from babbitt.kinds.journal.film.layout import closed_pockets, feeds_itself, supply_numbers, without_pressure
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_results import flow_without_pressure, thermal_values
from babbitt.kinds.journal.film.unloaded import NEEDS_A_LOAD, NOTHING_CARRIED, is_unloaded
from babbitt.reynolds.equilibrium.starved import FedFilm
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.model import FilmStart, JournalFilm

if TYPE_CHECKING:
    from babbitt.reynolds.surface.tilt_coefficients import TiltCoefficients

__all__ = ["fills_of", "film_values", "rows_of", "supply_pressures", "tilt_values"]

NO_MOMENT = 1e-10
"""Share of load times width below which a moment of the film is round-off."""

OF_THE_SUPPLY = ("supply_pressure", "element_pressure", "tube_loss", "hole_loss")
"""What is no property of a film whose grooves, pockets and holes all have a pressure or flow of their own."""


def film_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Named results of a bearing in its film, SI."""
    bearing, film, thermal = case.bearing, state.solution, state.thermal
    duty = duty_values(case, state)
    torque = case.friction_factor * friction_of(case, film)[0]
    coefficient = math.nan if is_unloaded(case, state) else 2.0 * torque / (state.load * bearing.diameter)
    values = {
        "diameter": bearing.diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        "relative_clearance": bearing.relative_clearance,
        "operating_relative_clearance": state.relative_clearance,
        **_lobe_values(case, state),
        **duty,
        "angular_speed": case.journal_speed,
        **oil_values(case, state),
        "sommerfeld_number": film.sommerfeld_number,
        "american_sommerfeld_number": _american_number(film.sommerfeld_number),
        "eccentricity_ratio": film.eccentricity_ratio,
        "attitude_angle": film.attitude_angle,
        **_misalignment_values(case),
        "load_angle": math.atan2(-film.force[1], -film.force[0]),
        "minimum_film_thickness": film.minimum_film_thickness,
        "narrowest_gap_angle": narrowest_gap_angle(film),
        "maximum_pressure": highest_pressure(film),
        "friction_number": coefficient / state.relative_clearance,
        "friction_coefficient": coefficient,
        "friction_torque": torque,
        **_without_streamers(case, state),
        "friction_power": state.friction_power,
        **_displacement_values(case, state),
        **_flow_values(case, state),
        **(_one_temperature(case, state) if thermal is None else thermal_values(case, state)),
        "recommended_relative_clearance": recommended_relative_clearance(duty["surface_speed"]),
        **_extent_values(state),
    }
    if state.feed is not None:
        values["element_pressure"] = state.feed.element_pressure
        values["tube_loss"] = state.feed.tube_loss
        values["hole_loss"] = state.feed.hole_loss
    values |= limit_values(case)
    for name, matrix in (("stiffness", film.stiffness), ("damping", film.damping)):
        values |= {f"{name}_{axes}": float(one) for axes, one in zip(AXES, matrix.ravel(), strict=True)}
    values["mass_balance_error"] = film.mass_balance_error
    if feeds_itself(case):
        values = {name: value for name, value in values.items() if name not in OF_THE_SUPPLY}
    if is_unloaded(case, state):
        values |= dict.fromkeys(NOTHING_CARRIED, 0.0) | dict.fromkeys(NEEDS_A_LOAD, math.nan)
    return values


def _american_number(sommerfeld_number: float) -> float:
    return 1.0 / (2.0 * math.pi * sommerfeld_number) if sommerfeld_number > 0.0 else math.nan


def _one_temperature(case: FilmCase, state: FilmState) -> dict[str, float]:
    return heat_values(case, state) | supply_values(case, state) | cooling_values(case, state)


def tilt_values(tilt: TiltCoefficients, scale: float) -> dict[str, float]:
    """Moments and the corner of tilt; a moment that is round-off beside load times width counts as none."""
    moments = {f"film_moment_{axis}": float(one) for axis, one in zip("xy", tilt.moment, strict=True)}
    values = {name: one if abs(one) > NO_MOMENT * scale else 0.0 for name, one in moments.items()}
    for name, matrix in (("tilt_stiffness", tilt.stiffness), ("tilt_damping", tilt.damping)):
        own = matrix[2:, 2:].ravel()
        values |= {f"{name}_{axes}": float(one) for axes, one in zip(AXES, own, strict=True)}
    return values


def rows_of(matrix: object) -> tuple[tuple[float, ...], ...]:
    """A matrix as plain numbers, row by row."""
    return tuple(tuple(float(one) for one in row) for row in np.asarray(matrix))


def fills_of(case: FilmCase, fed: FedFilm) -> tuple[float, ...]:
    """Fill of every groove, pocket and hole in the order of the case."""
    return tuple(fed.fill[number] for number in supply_numbers(case, fed.solution.film))


def supply_pressures(case: FilmCase, film: JournalFilm) -> tuple[float, ...]:
    """Gauge pressure of every groove, pocket and hole in the order of the case, Pa."""
    grooves = 0 if film.film_start is FilmStart.PERIODIC else len(film.lands)
    behind = [film.lands[number].end_pressure for number in film.land_order[:grooves]]
    every = [*behind, *(pocket.pressure for pocket in film.pockets)]
    return tuple(every[number] for number in supply_numbers(case, film))


def _misalignment_values(case: FilmCase) -> dict[str, float]:
    """Slopes of the journal axis that the film was solved with; nothing for an aligned journal."""
    slopes = case.bearing.misalignment
    return {} if slopes == (0.0, 0.0) else dict(zip(("misalignment_x", "misalignment_y"), slopes, strict=True))


def _lobe_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    bore = case.bearing.bore
    if not isinstance(bore, LobedBore):
        return {}
    clearance = 0.5 * state.relative_clearance * case.bearing.diameter
    return {"preload": bore.preload, "lobe_clearance": clearance / (1.0 - bore.preload)}


def _flow_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Flow by film pressure and by supply pressure: the latter is what the supply adds at the same position.

    Both NaN where the film without supply pressure is not found.
    """
    flow, film = state.total_flow, state.solution.film
    if math.isnan(flow):
        return {}
    return _flows_of_causes(case, state, flow, film) | _boundary_flows(state)


def _boundary_flows(state: FilmState) -> dict[str, float]:
    """What enters the film at its start and what its sides draw in; a closed film has no start."""
    solution = state.solution
    values = {"side_inflow": solution.side_inflow}
    if solution.film.film_start is not FilmStart.PERIODIC:
        values["inlet_flow"] = float(solution.inflow.sum())
    return values


def _flows_of_causes(case: FilmCase, state: FilmState, flow: float, film: JournalFilm) -> dict[str, float]:
    calm = without_pressure(film, closed_pockets(case))
    if calm == film:
        return {"side_flow": flow, "supply_flow": 0.0, "total_flow": flow}
    from babbitt.reynolds.equilibrium.position import film_at_position

    if state.thermal is None:
        x, y = state.solution.position
        frame = LoadFrame.of(calm, load_found(state))
        found = film_at_position(frame.film, frame.start((x, y)), resolution=case.accuracy.resolution)
        alone = found.leaving_flow if found.outcome.solved else math.nan
    else:
        alone = flow_without_pressure(case, state, calm)
    return {"side_flow": alone, "supply_flow": flow - alone, "total_flow": flow}


def _without_streamers(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Friction torque of the full film alone, as tables have it that do not count the oil behind the rupture."""
    solution = state.solution
    full = case.friction_factor * (solution.friction_torque - solution.streamer_torque)
    return {} if math.isnan(full) else {"friction_torque_without_streamers": full}


def _displacement_values(case: FilmCase, state: FilmState) -> dict[str, float]:
    """Largest displacement of a bore by all that moves it, against the pressure or with it; and by heat alone."""
    compliance, growth = case.bearing.compliance, case.heat.growth if case.heat is not None else None
    if not compliance and growth is None:
        return {}
    from babbitt.kinds.journal.film.elastic_film import displacement_under, distortion_by, thermal_displacement

    if growth is None or state.thermal is None:
        displaced = displacement_under(compliance, state.solution)
        return {"maximum_displacement": float(np.abs(displaced).max())}
    return {
        "maximum_displacement": float(np.abs(thermal_displacement(compliance, growth, state.thermal)).max()),
        "thermal_distortion": float(np.abs(distortion_by(growth, state.thermal)).max()),
    }


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
