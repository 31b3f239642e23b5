"""Friction heat that a method leaves out of the oil: by the energy balance of the whole footstep."""

from __future__ import annotations

from babbitt.footstep.model import Footstep
from babbitt.footstep.states import Method
from babbitt.footstep.steady_state import SteadyState

__all__ = ["uncounted_heat"]


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
        W and K; zero where the heat of the films goes into metal and oil (narrow grooves with a wall).
    """
    if method is Method.NARROW_GROOVE and step.wall is not None:
        return 0.0, 0.0
    oil = step.oil
    given = state.friction_power + (step.supply_pressure - step.ambient_pressure) * state.face_flow
    carried, leaving = 0.0, abs(state.leakage)
    if method is Method.SUPERPOSITION:
        outward = max(state.face_flow, 0.0)
        carried = outward * (state.face_temperature - oil.temperature)
        if state.groove_flow > 0.0:
            carried += state.groove_flow * (state.groove_temperature - oil.temperature)
        leaving = state.leakage + outward - state.face_flow
    heat = given - oil.heat_capacity * carried
    return heat, heat / (oil.heat_capacity * leaving)
