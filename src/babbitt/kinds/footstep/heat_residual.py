"""Friction heat that a method leaves out of the oil: by the energy balance of the whole footstep."""

from __future__ import annotations

import math

from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.states import Method
from babbitt.kinds.footstep.steady_state import SteadyState

__all__ = ["leaving_flow", "needed_flow", "heat_residual", "uncounted_share"]


def heat_residual(step: Footstep, state: SteadyState, method: Method) -> tuple[float, float]:
    """Heat that neither oil nor metal receives, and by how much it would warm the oil that leaves.

    What the screw gives by friction and the oil by its loss of pressure must leave with oil or metal. The study's
    equations warm the oil of the groove and of the face gap by their own dissipation and nothing by the shear of
    heel and lands; narrow-groove theory without metal keeps its films as cold as the oil that comes in, and with
    metal it lets the oil enter each film at the temperature of the supply: what the first film gave to the oil is
    lost on the way to the second.

    Parameters
    ----------
    step : Footstep
    state : SteadyState
    method : Method

    Returns
    -------
    heat, rise : float
        W and K. The rise is that of the oil that leaves and of the metal, as far as there is one; infinite where
        nothing could take the heat.
    """
    oil, conductance = step.oil, _conductance(step, method)
    metal = 0.0
    if step.wall is not None:
        films = state.rim_temperature + state.face_temperature
        metal = 0.5 * conductance * (films - 2.0 * step.wall.temperature)
    heat = given_power(step, state) - metal - oil.heat_capacity * _carried(step, state, method)
    takes = oil.heat_capacity * leaving_flow(state, method) + conductance
    if takes <= 0.0:
        return heat, math.inf if heat > 0.0 else 0.0
    return heat, heat / takes


def needed_flow(step: Footstep, state: SteadyState, method: Method, rise: float) -> float:
    """Oil that must leave to take the heat left out of it, beside the metal, at a rise of temperature, m3/s."""
    heat, _ = heat_residual(step, state, method)
    return max(heat / rise - _conductance(step, method), 0.0) / step.oil.heat_capacity


def _conductance(step: Footstep, method: Method) -> float:
    """To the metal, W/K; narrow-groove theory alone knows it."""
    return step.wall.conductance if method is Method.NARROW_GROOVE and step.wall is not None else 0.0


def uncounted_share(step: Footstep, state: SteadyState, method: Method) -> float:
    """Heat that neither oil nor metal receives over the power that the screw and the pressure give."""
    return abs(heat_residual(step, state, method)[0]) / given_power(step, state)


def given_power(step: Footstep, state: SteadyState) -> float:
    """What the screw gives by friction and the oil by its loss of pressure, W."""
    return state.friction_power + (step.supply_pressure - step.ambient_pressure) * state.face_flow


def _carried(step: Footstep, state: SteadyState, method: Method) -> float:
    """Oil that leaves times its rise of temperature, m³ K/s."""
    inlet = step.oil.temperature
    if method is Method.NARROW_GROOVE:
        if step.wall is None:
            return 0.0
        last = state.rim_temperature if state.leakage > 0.0 else state.face_temperature
        return abs(state.leakage) * (last - inlet)
    outward = max(state.face_flow, 0.0)
    if state.groove_flow < 0.0:  # what leaves through the groove is hotter than the rim
        beside = state.leakage * (state.rim_temperature - inlet)
        return beside - state.groove_flow * (state.groove_temperature - inlet)
    warmed = outward * (state.face_temperature - inlet)
    if state.groove_flow > 0.0:
        warmed += state.groove_flow * (state.groove_temperature - inlet)
    return warmed


def leaving_flow(state: SteadyState, method: Method) -> float:
    """Oil that leaves the footstep with its heat, to ambient and back into the bore, m3/s."""
    if method is Method.SUPERPOSITION:
        return state.leakage + max(-state.face_flow, 0.0) + max(-state.groove_flow, 0.0)
    return abs(state.leakage)
