"""Values of the static share of a thrust bearing, and a row of numbers per pad."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from babbitt.core.result import Matrix
from babbitt.design.pad_heat import PadTemperatures, Temperatures
from babbitt.kinds.thrust.design import ThrustDesign, ThrustState
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import condensed

__all__ = [
    "effective_viscosity",
    "hottest_oil",
    "pad_arrays",
    "reynolds_number",
    "rise_of_passing_oil",
    "share_values",
]

UNKNOWN = 323.15
"""Temperature of oil of which only the viscosity is given, K; an assumption."""


def share_values(design: ThrustDesign, state: ThrustState) -> dict[str, float]:
    """Values of the static share."""
    share, bearing = state.share, design.bearing
    worst = share.states[int(share.loads.argmax())]
    viscosity = effective_viscosity(design, state)
    speed = design.speed * 0.5 * (bearing.pad.inner_radius + bearing.pad.outer_radius)
    values = {
        "load": share.thrust,
        "pad_number": float(bearing.number),
        "specific_load": share.thrust / bearing.area,
        "angular_speed": bearing.sense * design.speed,
        "surface_speed": speed,
        "ring_stiffness": bearing.ring_stiffness,
        "pivot_film_thickness": worst.height,
        "minimum_film_thickness": min(pad.minimum_film_thickness for pad in share.states),
        "maximum_pressure": max(pad.maximum_pressure for pad in share.states),
        "largest_pad_load": float(share.loads.max()),
        "largest_specific_load": float(share.loads.max()) / bearing.pad.area,
        "pressure_speed_product": float(share.loads.max()) / bearing.pad.area * speed,
        "smallest_pad_load": float(share.loads.min()),
        "pad_load_ratio": share.largest_over_mean,
        "collar_moment": share.collar_moment,
        "friction_torque": sum(pad.friction_torque for pad in share.states),
        "friction_power": sum(pad.friction_power for pad in share.states),
        "side_flow": sum(pad.side_flow for pad in share.states),
        **_temperatures(design, state.temperatures, share),
        **hottest_oil(share),
        "mass_balance_error": max(pad.mass_balance_error for pad in share.states),
        "effective_viscosity": viscosity,
        "film_reynolds_number": reynolds_number(design, share, viscosity, state.temperatures),
        "axial_stiffness": float(sum(condensed(pad, 0.0).real for pad in share.states)),
        "axial_damping": float(
            sum(condensed(pad, design.speed, bearing.inertia).imag for pad in share.states) / design.speed
        ),
    }
    return {name: value for name, value in values.items() if np.isfinite(value)}


def effective_viscosity(design: ThrustDesign, state: ThrustState) -> float:
    """Of the films, Pa s: theirs, or that at the effective temperature where each has its own."""
    if state.temperatures is None or (design.oil.thermal is None and not _own_balances(state.share)):
        return state.films.viscosity
    return float(design.lubricant.dynamic_viscosity(state.temperatures.effective))


def hottest_oil(share: Share) -> dict[str, float]:
    """Highest temperature of films that vary, K, or that of the hottest trailing edge; nothing of others."""
    found = [pad.heat.maximum for pad in share.states if pad.heat is not None]
    if found:
        return {"maximum_temperature": max(found)}
    trailing = [pad.trailing for pad in _own_balances(share)]
    return {"hottest_trailing_temperature": max(trailing)} if trailing else {}


def _own_balances(share: Share) -> list[PadTemperatures]:
    """Temperatures of pads each of which has its own; nothing where they share evenly, and have the same."""
    found = [pad.balance for pad in share.states if pad.balance is not None]
    return found if len(set(found)) > 1 else []


def _temperatures(design: ThrustDesign, found: Temperatures | None, share: Share) -> dict[str, float]:
    if found is None:
        prescribed = design.oil.effective_temperature
        own = {} if prescribed is None else {"effective_temperature": prescribed}
        passing = sum(pad.trailing_flow + pad.side_flow for pad in share.states)
        return {**own, "passing_flow": passing, "temperature_rise": rise_of_passing_oil(design, share)}
    return {
        "total_flow": found.fresh_flow,
        "supply_temperature": found.supply,
        "pad_inlet_temperature": found.inlet,
        "trailing_temperature": found.trailing,
        "effective_temperature": found.effective,
        "outlet_temperature": found.drain,
        "energy_balance_error": abs(found.error),
    }


def rise_of_passing_oil(design: ThrustDesign, share: Share) -> float:
    """By how much the friction of films of a given viscosity would warm the oil that passes the pads, K."""
    capacity = float(design.lubricant.volumetric_heat_capacity(_property_temperature(design, None)))
    power = sum(pad.friction_power for pad in share.states)
    return power / (capacity * sum(pad.trailing_flow + pad.side_flow for pad in share.states))


def reynolds_number(design: ThrustDesign, share: Share, viscosity: float, found: Temperatures | None) -> float:
    """Of the thickest pivot film at the mean radius."""
    pad = design.bearing.pad
    density = float(design.lubricant.density(_property_temperature(design, found)))
    surface = design.speed * 0.5 * (pad.inner_radius + pad.outer_radius)
    return density * surface * float(share.heights.max()) / viscosity


def _property_temperature(design: ThrustDesign, found: Temperatures | None) -> float:
    """K, at which density and heat capacity are taken; where only a viscosity is known, they hardly vary."""
    known = found.effective if found is not None else design.oil.effective_temperature
    return UNKNOWN if known is None else known


def pad_arrays(share: Share, speed: float) -> dict[str, Matrix]:
    """One row with a number per pad for each quantity, and the full coefficients of the pad loaded most."""
    inertia = share.bearing.inertia
    rows: dict[str, Iterable[float]] = {
        "pad_load": share.loads,
        "pad_film_thickness": share.heights,
        "pad_minimum_film_thickness": [pad.minimum_film_thickness for pad in share.states],
        "pad_maximum_pressure": [pad.maximum_pressure for pad in share.states],
        "pad_leading_flow": [pad.leading_flow for pad in share.states],
        "pad_trailing_flow": [pad.trailing_flow for pad in share.states],
        "pad_inner_flow": [pad.inner_flow for pad in share.states],
        "pad_outer_flow": [pad.outer_flow for pad in share.states],
        "pad_friction_power": [pad.friction_power for pad in share.states],
        "pad_slope_radial": [pad.slope_x for pad in share.states],
        "pad_slope_along": [pad.slope_y for pad in share.states],
        "pad_stiffness": [condensed(pad, 0.0).real for pad in share.states],
        "pad_damping": [condensed(pad, speed, inertia).imag / speed for pad in share.states],
    }
    heats = [pad.heat for pad in share.states if pad.heat is not None]
    if heats:
        rows["pad_mixed_temperature"] = [heat.inlet for heat in heats]
        rows["pad_trailing_temperature"] = [heat.trailing for heat in heats]
        rows["pad_maximum_temperature"] = [heat.maximum for heat in heats]
    if balances := _own_balances(share):
        rows["pad_mixed_temperature"] = [pad.inlet for pad in balances]
        rows["pad_effective_temperature"] = [pad.effective for pad in balances]
        rows["pad_trailing_temperature"] = [pad.trailing for pad in balances]
    worst = share.states[int(share.loads.argmax())]
    arrays: dict[str, Matrix] = {name: (tuple(float(one) for one in row),) for name, row in rows.items()}
    for name, matrix in (("full_stiffness", worst.stiffness), ("full_damping", worst.damping)):
        arrays[name] = tuple(tuple(float(one) for one in row) for row in matrix)
    return arrays
