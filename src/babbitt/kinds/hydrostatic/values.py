"""The named values of a hydrostatic bearing."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Matrix
from babbitt.kinds.hydrostatic.answer import Answer, thinnest_film
from babbitt.kinds.hydrostatic.friction import friction_power, friction_torque, land_friction_power
from babbitt.kinds.hydrostatic.geometry import RecessedJournal
from babbitt.kinds.hydrostatic.heat_balance import temperature_rise
from babbitt.kinds.hydrostatic.impedance import damping_loss, impedance
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.optimum import least_power_gap, least_power_viscosity, stiffest_ratio
from babbitt.kinds.hydrostatic.pumping import law_of, pump_power, pumping_power
from babbitt.kinds.hydrostatic.restrictors import Capillary

__all__ = ["arrays", "values"]

Array = NDArray[np.float64]


def values(case: HydrostaticCase, found: Answer) -> dict[str, float]:
    """Numbers by name, SI."""
    network, response = found.network, found.response
    friction = friction_power(case, found)
    flow, supply = float(network.flows.sum()), network.supply_pressure
    pumping = pumping_power(case, network)
    stiffness, damping = impedance(response, network, case.compressibility, 0.0)
    named = place(case, found)
    named |= {
        "supply_pressure": supply,
        "total_flow": flow,
        "mean_pressure_ratio": float(network.pressures.mean()) / supply,
    }
    if found.film is not None:
        named["maximum_pressure"] = found.film.maximum_pressure
    named |= {
        "pumping_power": pumping,
        "pump_power": pump_power(case, network),
        "friction_power": friction,
        "power_ratio": friction / pumping,
        "temperature_rise": temperature_rise(case, found),
        "effective_viscosity": case.oil.viscosity,
    }
    if network.overflow > 0.0:
        named |= {"relief_flow": network.overflow, "relief_power": supply * network.overflow}
    if case.duty.angular_speed:
        named |= {
            "friction_torque": abs(friction_torque(case, found)),
            "angular_speed": abs(case.duty.angular_speed),
        }
    if case.is_journal:
        named |= {
            f"{name}_{axes}": float(matrix[i, j])
            for name, matrix in (("stiffness", stiffness), ("damping", damping))
            for axes, i, j in (("xx", 0, 0), ("xy", 0, 1), ("yx", 1, 0), ("yy", 1, 1))
        }
    else:
        named |= {"gap_stiffness": float(stiffness[0, 0]), "gap_damping": float(damping[0, 0])}
        if stiffness.shape[0] == 3 and case.kind == "hydrostatic_thrust_ring":
            named["least_tilt_stiffness"] = float(
                np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T)[1:, 1:]).min()
            )
        if case.count == 1:
            named["effective_area"] = abs(float(response.area[0, 0]))
    named["compressibility_damping_loss"] = damping_loss(response, network, case.compressibility)
    named["network_stability"] = network.least_eigenvalue
    best = stiffest_ratio(
        case.feeding.restrictors[0], case.shape if isinstance(case.shape, RecessedJournal) else None
    )
    if best is not None and case.feeding.is_uniform:
        named["stiffest_pressure_ratio"] = best
    if friction > 0.0 and pumping > 0.0:
        named["least_power_gap"] = least_power_gap(mean_gap(found), pumping, land_friction_power(case, found))
        named["least_power_viscosity"] = least_power_viscosity(case.oil.viscosity, pumping, friction)
    if found.film is not None:
        named |= {"cavitated_share": found.film.dry_share, "mass_balance_error": found.film.mass_balance_error}
    else:
        named["mass_balance_error"] = network.residual
    return named | validity_numbers(case, found)


def place(case: HydrostaticCase, found: Answer) -> dict[str, float]:
    """Load and position."""
    if isinstance(case.shape, RecessedJournal):
        force, at = found.response.force, found.at
        load_angle = case.duty.load_angle
        if case.duty.load is None:
            load_angle = math.atan2(-float(force[1]), -float(force[0]))
        sense = -1.0 if case.duty.angular_speed < 0.0 else 1.0
        shift = math.atan2(float(at[1]), float(at[0]))
        size = float(np.hypot(*at))
        angle = math.remainder(sense * (shift - load_angle), 2.0 * math.pi) if size > 1e-9 * case.rest_gap else 0.0
        found_angle = {"load_angle": load_angle} if case.duty.load is None else {}
        return {
            "load": float(np.hypot(*force)),
            **found_angle,
            "specific_load": float(np.hypot(*force)) / (case.shape.diameter * case.shape.width),
            "eccentricity_ratio": size / case.shape.clearance,
            "attitude_angle": angle,
            "minimum_film_thickness": thinnest_film(case, found),
        }
    named = {
        "load": float(found.response.force[0]),
        "gap": mean_gap(found),
        "minimum_film_thickness": thinnest_film(case, found),
    }
    if found.at.size == 3 and case.kind == "hydrostatic_thrust_ring":
        named |= {
            "tilt_x": level(float(found.at[1]), case, found),
            "tilt_y": level(float(found.at[2]), case, found),
            "moment_x": round_off(float(found.response.force[1]), case, found),
            "moment_y": round_off(float(found.response.force[2]), case, found),
        }
    return named


def round_off(moment: float, case: HydrostaticCase, found: Answer) -> float:
    """A moment, zero where it is no more than round-off of the load."""
    return 0.0 if abs(moment) < 1e-9 * abs(float(found.response.force[0])) * case.reach else moment


def level(tilt: float, case: HydrostaticCase, found: Answer) -> float:
    """A tilt, zero where it is no more than round-off of the gap."""
    return 0.0 if abs(tilt) * case.reach < 1e-9 * mean_gap(found) else tilt


def mean_gap(found: Answer) -> float:
    """Clearance of a journal; gap of a pad, m."""
    return found.rest_gap if found.at.size == 2 else found.rest_gap + float(found.at[0])


def validity_numbers(case: HydrostaticCase, found: Answer) -> dict[str, float]:
    """Reynolds numbers of capillaries; where something moves, of film and recess, and the edge inertia."""
    named = {}
    pairs = zip(case.feeding.restrictors, found.network.flows, strict=True)
    laws = [(law_of(one), float(flow)) for one, flow in pairs]
    numbers = [law.reynolds_number(flow) for law, flow in laws if isinstance(law, Capillary)]
    if numbers:
        named["restrictor_reynolds_number"] = max(numbers)
    if case.surface_speed == 0.0:
        return named
    scale = case.oil.density / case.oil.viscosity
    dynamic = 0.5 * case.oil.density * case.recess_speed**2
    return named | {
        "film_reynolds_number": scale * case.surface_speed * mean_gap(found),
        "recess_reynolds_number": scale * case.recess_speed * case.recesses.depth,
        "edge_inertia": dynamic / max(float(found.network.pressures.min()), 1.0),
    }


def arrays(case: HydrostaticCase, found: Answer) -> dict[str, Matrix]:
    """Values of several numbers."""
    network = found.network
    named: dict[str, Matrix] = {
        "recess_pressure": (tuple(map(float, network.pressures)),),
        "pressure_ratio": (tuple(map(float, network.pressures / network.supply_pressure)),),
        "restrictor_flow": (tuple(map(float, network.flows)),),
    }
    stiffness, damping = impedance(found.response, network, case.compressibility, 0.0)
    prefix = "" if case.is_journal else "pad_"
    if case.kind == "hydrostatic_thrust_ring":
        prefix = "runner_"
    if stiffness.shape[0] > 1 and (case.is_journal or prefix == "runner_"):
        named |= {f"{prefix}stiffness": matrix(stiffness), f"{prefix}damping": matrix(damping)}
        if prefix == "runner_":
            named["runner_tilt_stiffness"] = matrix(stiffness[1:, 1:])
    if case.frequencies:
        at = [impedance(found.response, network, case.compressibility, one) for one in case.frequencies]
        size = 1 if prefix == "pad_" else stiffness.shape[0]
        named |= {
            "dynamic_frequency": (tuple(case.frequencies),),
            "dynamic_stiffness": tuple(tuple(map(float, k[:size, :size].ravel())) for k, _ in at),
            "dynamic_damping": tuple(tuple(map(float, c[:size, :size].ravel())) for _, c in at),
        }
    return named


def matrix(of: Array) -> Matrix:
    """Rows of plain numbers."""
    return tuple(tuple(map(float, row)) for row in of)
