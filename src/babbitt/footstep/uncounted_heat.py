"""Friction heat that a method leaves out of the oil: by the energy balance of the whole footstep."""

from __future__ import annotations

import math

from babbitt.footstep.model import Footstep
from babbitt.footstep.states import Method
from babbitt.footstep.steady_state import SteadyState

__all__ = ["leaving_flow", "uncounted_heat"]


def uncounted_heat(step: Footstep, state: SteadyState, method: Method) -> tuple[float, float]:
    """Heat that neither oil nor metal receives, and by how much it would warm the oil that leaves.

    What the screw gives by friction and the oil by its loss of pressure must leave with oil or metal. The study's
    equations warm the oil of the groove and of the face gap by their own dissipation and nothing by the shear of
    heel and lands; narrow-groove theory without metal keeps its films as cold as the oil that comes in.

    Parameters
    ----------
    step : Footstep
    state : SteadyState
    method : Method

    Returns
    -------
    heat, rise : float
        W and K; zero where the heat of the films goes into metal and oil (narrow grooves with a wall). The rise is
        infinite where no oil leaves that could take the heat.
    """
    if method is Method.NARROW_GROOVE and step.wall is not None:
        return 0.0, 0.0
    oil = step.oil
    given = state.friction_power + (step.supply_pressure - step.ambient_pressure) * state.face_flow
    carried = 0.0
    if method is Method.SUPERPOSITION:
        outward = max(state.face_flow, 0.0)
        carried = outward * (state.face_temperature - oil.temperature)
        if state.groove_flow > 0.0:
            carried += state.groove_flow * (state.groove_temperature - oil.temperature)
    heat, takes = given - oil.heat_capacity * carried, oil.heat_capacity * leaving_flow(state, method)
    if takes <= 0.0:
        return heat, math.inf if heat > 0.0 else 0.0
    return heat, heat / takes


def leaving_flow(state: SteadyState, method: Method) -> float:
    """Oil that leaves the footstep with its heat, to ambient and back into the bore, m3/s."""
    if method is Method.SUPERPOSITION:
        return state.leakage + max(-state.face_flow, 0.0)
    return abs(state.leakage)
