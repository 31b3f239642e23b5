"""The named values of a tilting-pad bearing."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from babbitt.core.quantities import AXES
from babbitt.core.result import Matrix
from babbitt.design.conditions import OilSupply
from babbitt.design.values import duty_values, limit_values, oil_values
from babbitt.kinds.tilting_pad_journal.dynamics import PadDynamics, bounded_decrement, swinging
from babbitt.kinds.tilting_pad_journal.margins import PadMargin
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.reynolds.oil.turbulence import FilmTurbulence
from babbitt.reynolds.tilting_pads.bending_mode import BendingMode
from babbitt.reynolds.tilting_pads.kernel_pads import pad_widths
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pad_lands import pad_gaps
from babbitt.reynolds.tilting_pads.pivots import HertzContact
from babbitt.reynolds.tilting_pads.solution import PadState, PadStatus, TiltingPadSolution

__all__ = [
    "dynamic_rows",
    "dynamic_values",
    "eccentricity_ratio",
    "film_values",
    "outlet_values",
    "pad_rows",
    "place_values",
]

STATUS = {PadStatus.LOADED: 1.0, PadStatus.AT_LIMIT: 0.5, PadStatus.UNLOADED: 0.0}
"""Numbers that stand for a status: 1 loaded, 0 unloaded, between them at its limit."""

CENTRED = 1e-9
"""Eccentricity ratio below which its direction is round-off, and angle in rad that is."""

LEVEL = 1e-12
"""Tilt in rad that is round-off: of a pad that a flexure holds straight."""

ROUND_OFF = 1e-12
"""Share of the largest entry of a matrix below which another one is round-off."""


def film_values(case: PadCase, films: PadFilms, margins: tuple[PadMargin, ...]) -> dict[str, float]:
    """Numbers of bearing, place, films and oil, SI."""
    solution, bearing = films.solution, case.bearing
    duty = duty_values(case, films)
    loads = [pad.load for pad in solution.pads]
    largest = solution.most_loaded
    torque = solution.friction_torque
    fluid = oil_values(case, films)
    known = [one.margin for one in margins if math.isfinite(one.margin)]
    named = {
        "diameter": bearing.diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        "relative_clearance": bearing.relative_clearance,
        "pad_number": float(len(bearing.pads)),
        "largest_pad_clearance": bearing.pad_clearance,
        "assembled_clearance": bearing.assembled_clearance,
        "preload": least_preload(bearing.pads),
        **duty,
        **place_values(case, solution),
        "minimum_film_thickness": solution.minimum_film_thickness,
        "maximum_pressure": solution.maximum_pressure,
        "largest_pad_load": loads[largest],
        "largest_specific_load": loads[largest] / chord_area(case, largest),
        "smallest_pad_load": min(loads),
        "loaded_pads": float(len(solution.loaded)),
        "friction_torque": torque,
        "friction_power": solution.friction_power,
        "friction_coefficient": 2.0 * torque / (films.load * bearing.diameter) if films.load > 0.0 else math.nan,
        "side_flow": solution.side_flow,
        "total_flow": films.fresh_flow,
        "mass_balance_error": mass_balance_error(solution),
        **supply_values(case, films),
        "effective_temperature": films.temperature,
        **fluid,
        "american_sommerfeld_number": american_number(case, films),
        **limit_values(case),
    }
    if known:
        named["least_pad_margin"] = min(known)
    contacts = [one for one in contact_pressures(solution) if math.isfinite(one)]
    if contacts:
        named["largest_contact_pressure"] = max(contacts)
    if case.turbulence is not None:
        named["turbulent_share"] = turbulent_share(solution)
    return named


def turbulent_share(solution: TiltingPadSolution) -> float:
    """Share of the bores of all pads where the local Reynolds number exceeds that at which turbulence sets in."""
    law = solution.bearing.turbulence
    assert law is not None
    return share_of_bores(solution, local_reynolds_number(solution, law) > law.onset)


def ramp_share(solution: TiltingPadSolution, law: FilmTurbulence) -> float:
    """Share of the bores of the loaded pads where the film is between laminar and fully turbulent, by that law."""
    number = local_reynolds_number(solution, law)
    return share_of_bores(solution, (number > law.onset) & (number < law.end), solution.loaded)


def local_reynolds_number(solution: TiltingPadSolution, law: FilmTurbulence) -> NDArray[np.float64]:
    """Of the gap of every pad at the lines of its film, shape (pads, n + 1)."""
    bearing = solution.bearing
    speed = bearing.radius * abs(bearing.angular_speed)
    return law.density * speed * pad_gaps(solution) / bearing.viscosity


def share_of_bores(
    solution: TiltingPadSolution, where: NDArray[np.bool_], pads: Sequence[int] | None = None
) -> float:
    """Share of the bores of some pads, of all if not named, where something holds, shape (pads, n + 1)."""
    some = list(range(len(solution.pads)) if pads is None else pads)
    if not some:
        return 0.0
    areas = pad_widths(solution.bearing) * [pad.extent for pad in solution.bearing.pads]
    shares = np.trapezoid(where.astype(float), dx=1.0 / (where.shape[1] - 1))  # the sum of two flags is a flag
    return float(np.average(shares[some], weights=areas[some]))


def mass_balance_error(solution: TiltingPadSolution) -> float:
    """Oil that leaves the pads less what enters them, over the latter."""
    entering = sum(pad.inflow for pad in solution.pads)
    leaving = sum(pad.outflow + pad.side_flow for pad in solution.pads)
    return (leaving - entering) / entering


def least_preload(pads: tuple[TiltingPad, ...]) -> float:
    """Preload of the pad with the smallest one."""
    return min(pad.preload for pad in pads)


def chord_area(case: PadCase, number: int) -> float:
    """Projected area of a pad, m2: its width times the chord of its arc."""
    pad = case.bearing.pads[number]
    width = case.bearing.width if pad.width is None else pad.width
    return width * case.bearing.diameter * math.sin(min(0.5 * pad.extent, 0.5 * math.pi))


def american_number(case: PadCase, films: PadFilms) -> float:
    """American Sommerfeld number S = eta N L D (R/c)^2/F with the assembled clearance, N in rev/s."""
    bearing = case.bearing
    turns = abs(case.journal_speed) / (2.0 * math.pi)
    ratio = 1.0 / bearing.relative_clearance**2
    if films.load <= 0.0:
        return math.nan
    return films.viscosity * turns * bearing.width * bearing.diameter * ratio / films.load


def eccentricity_ratio(case: PadCase, solution: TiltingPadSolution) -> float:
    """Eccentricity over the assembled clearance as given, whatever growth leaves of it."""
    return math.hypot(*flat(plain(solution.position))) / case.bearing.assembled_clearance


def place_values(case: PadCase, solution: TiltingPadSolution) -> dict[str, float]:
    """Place of the journal: eccentricity over the assembled clearance, and its angles."""
    x, y = flat(plain(solution.position))
    load_angle = math.atan2(-float(solution.force[1]), -float(solution.force[0]))
    ratio = eccentricity_ratio(case, solution)
    shift = math.remainder(case.sense * (math.atan2(y, x) - load_angle), 2.0 * math.pi)
    return {
        "journal_x": x,
        "journal_y": y,
        "eccentricity_ratio": ratio,
        "attitude_angle": shift if ratio > CENTRED and abs(shift) > CENTRED else 0.0,
        "load_angle": load_angle,
    }


def supply_values(case: PadCase, films: PadFilms) -> dict[str, float]:
    """Temperatures of the oil on its way, and what of a given flow passes the pads by."""
    supply = case.oil_supply
    named: dict[str, float] = {}
    if supply is None:
        return named
    named["supply_temperature"] = supply.temperature
    if supply.flow is not None:
        named["given_flow"] = supply.flow
        if supply.flow >= films.fresh_flow:
            named["surplus_flow"] = supply.flow - films.fresh_flow
    found = films.temperatures
    if found is None:
        return named
    heat = films.volumetric_heat_capacity * films.fresh_flow * (found.drain - supply.temperature)
    return named | {
        "pad_inlet_temperature": found.inlet,
        "trailing_temperature": found.trailing,
        **outlet_values(supply, films, heat),
        "heat_to_oil": heat,
        "energy_balance_error": 1.0 - heat / films.friction_power,
    }


def outlet_values(supply: OilSupply, films: PadFilms, heat: float) -> dict[str, float]:
    """Mean temperature in K of the oil that leaves with a heat in W; none of pads that starve or draw in nothing.

    Films that draw in more than there is are colder than the real ones, and would leave colder oil.
    """
    flow = films.fresh_flow if supply.flow is None else supply.flow
    if flow < films.fresh_flow or flow <= 0.0:
        return {}
    return {"outlet_temperature": supply.temperature + heat / (films.volumetric_heat_capacity * flow)}


def dynamic_values(case: PadCase, dynamics: PadDynamics) -> dict[str, float]:
    """Synchronous and static coefficients, virtual masses, decrements, threshold."""
    named: dict[str, float] = {}
    for name, matrix in (
        ("stiffness", dynamics.synchronous.stiffness),
        ("damping", dynamics.synchronous.damping),
        ("static_stiffness", dynamics.static.stiffness),
    ):
        named |= {f"{name}_{axes}": one for axes, one in zip(AXES, flat(plain(matrix)), strict=True)}
    if dynamics.fit is not None:
        masses = zip(AXES, flat(plain(dynamics.fit.mass)), strict=True)
        named |= {f"virtual_mass_{axes}": one for axes, one in masses}
        named["fit_error"] = dynamics.fit.error
    motions = dynamics.motions
    if motions is None or case.rotor_mass is None:
        return named
    named |= {"rotor_mass": case.rotor_mass, "log_decrement": motions.log_decrement}
    if math.isfinite(motions.pad_decrement):
        named["pad_log_decrement"] = motions.pad_decrement
    if case.shaft_stiffness is not None:
        named["shaft_stiffness"] = case.shaft_stiffness
    own = motions.of_the_rotor
    names = ("forward", "backward") if len(own) == 2 or (own and own[0].forward) else ("backward",)
    for name, mode in zip(names, own, strict=False):
        named[f"log_decrement_{name}"] = bounded_decrement(mode)
        named[f"whirl_frequency_{name}"] = mode.frequency
    if math.isfinite(motions.threshold.value):
        named["threshold_mass"] = motions.threshold.value
    if math.isfinite(motions.threshold.frequency):
        named["threshold_frequency"] = motions.threshold.frequency
    return named


def pad_rows(case: PadCase, solution: TiltingPadSolution) -> dict[str, Matrix]:
    """One row with a number per pad for each quantity; nan where a pad has none."""
    pads, states = case.bearing.pads, solution.pads
    speed = abs(case.journal_speed)

    def of_states(name: str) -> list[float]:
        return [float(getattr(state, name)) for state in states]

    rows: dict[str, list[float]] = {
        "pad_pivot_angle": [pad.pivot_angle for pad in pads],
        "pad_clearance": [pad.clearance for pad in pads],
        "pad_assembled_clearance": [pad.assembled_clearance for pad in pads],
        "pad_preload": [pad.preload for pad in pads],
        "pad_status": [STATUS[state.status] for state in states],
        "pad_load": of_states("load"),
        "pad_tilt": [0.0 if abs(tilt) < LEVEL else tilt for tilt in (state.position.tilt for state in states)],
        "pad_eccentricity_ratio": of_states("eccentricity_ratio"),
        "pad_film_thickness": [pivot_film(*one) for one in zip(solution.bearing.pads, states, strict=True)],
        "pad_minimum_film_thickness": of_states("minimum_film_thickness"),
        "pad_maximum_pressure": of_states("maximum_pressure"),
        "pad_leading_flow": of_states("inflow"),
        "pad_trailing_flow": of_states("outflow"),
        "pad_side_flow": of_states("side_flow"),
        "pad_friction_power": [state.friction_torque * speed for state in states],
        "pivot_displacement": [state.position.pivot_displacement for state in states],
        "pivot_stiffness": [state.pivot_stiffness if state.load > 0.0 else math.nan for state in states],
    }
    if any(isinstance(pad.pivot, HertzContact) for pad in pads):
        rows["pivot_contact_pressure"] = contact_pressures(solution)
    if any(pad.bends for pad in pads):
        rows["pad_bending"] = [largest_bending(pad, state) for pad, state in zip(pads, states, strict=True)]
        rows["pad_bending_stiffness"] = [pad.bending_stiffness for pad in pads]
    return {name: (tuple(map(float, row)),) for name, row in rows.items() if any(map(math.isfinite, row))}


def contact_pressures(solution: TiltingPadSolution) -> list[float]:
    """Largest pressure in the contact of each pivot, Pa; nan of pivots that are no contacts of Hertz."""
    return [
        pad.pivot.contact_pressure(max(state.load, 0.0)) if isinstance(pad.pivot, HertzContact) else math.nan
        for pad, state in zip(solution.bearing.pads, solution.pads, strict=True)
    ]


def largest_bending(pad: TiltingPad, state: PadState) -> float:
    """What an edge of a pad that bends moves outward, m; 0 of one without load."""
    return 0.0 if state.bend is None else state.bend.deflection * BendingMode.of(pad).farthest


def pivot_film(pad: TiltingPad, state: PadState) -> float:
    """Film at the pivot, c_p (1 - eps_p) with the clearance of the pad as it runs, m."""
    return pad.clearance * (1.0 - state.eccentricity_ratio)


def dynamic_rows(case: PadCase, dynamics: PadDynamics) -> dict[str, Matrix]:
    """Matrices: synchronous, static, over the whirl ratio, fitted, and those of journal and pads together."""
    full, speed = dynamics.full, abs(case.journal_speed)
    named: dict[str, Matrix] = {
        "stiffness": rows_of(dynamics.synchronous.stiffness),
        "damping": rows_of(dynamics.synchronous.damping),
        "static_stiffness": rows_of(dynamics.static.stiffness),
        "static_damping": rows_of(dynamics.static.damping),
        "whirl_ratio": (case.whirl_ratios,),
        "dynamic_frequency": (tuple(ratio * speed for ratio in case.whirl_ratios),),
        "dynamic_stiffness": tuple(flat(plain(one.stiffness)) for one in dynamics.over_whirl),
        "dynamic_damping": tuple(flat(plain(one.damping)) for one in dynamics.over_whirl),
        "system_stiffness": rows_of(full.stiffness),
        "system_damping": rows_of(full.damping),
        "system_mass": rows_of(full.mass),
    }
    if dynamics.fit is not None:
        named |= {
            "fitted_stiffness": rows_of(dynamics.fit.stiffness),
            "fitted_damping": rows_of(dynamics.fit.damping),
            "virtual_mass": rows_of(dynamics.fit.mass),
        }
    if dynamics.motions is not None:
        named["rotor_modes"] = tuple(
            (mode.growth, mode.frequency, bounded_decrement(mode), mode.whirl, mode.share)
            for mode in swinging(dynamics.motions.modes)
        )
    return named


def rows_of(matrix: NDArray[np.float64]) -> Matrix:
    """A matrix as plain numbers, row by row."""
    return tuple(map(tuple, plain(matrix).tolist()))


def plain(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same without what is round-off beside the largest of them."""
    sizes = np.abs(values)
    return np.where(sizes > ROUND_OFF * sizes.max(initial=0.0), values, 0.0)


def flat(matrix: NDArray[np.float64]) -> tuple[float, ...]:
    """Plain numbers of an array, row after row."""
    return tuple(matrix.ravel().tolist())
