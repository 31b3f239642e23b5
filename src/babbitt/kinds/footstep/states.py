"""The search for all steady states of a footstep, by either method."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.footstep.axial import axial_damping, load_slopes
from babbitt.kinds.footstep.draining import DrainedFootstep, cold_groove_drains
from babbitt.kinds.footstep.eccentric import side_force_of_leakage
from babbitt.kinds.footstep.face import number
from babbitt.kinds.footstep.model import Footstep, FootstepOptions
from babbitt.kinds.footstep.stability import (
    RimDisturbance,
    Stability,
    stability_of_films,
    stability_of_grooved,
    stability_of_smooth,
)
from babbitt.kinds.footstep.steady_state import Method, NoSteadyStateError, StateName, SteadyState
from babbitt.kinds.footstep.superposition import Balance, GroovedFootstep, SmoothFootstep
from babbitt.kinds.footstep.thermal_films import ThermalFilmPair, ThermalFilms
from babbitt.numerics.roots import bracketed_root

__all__ = ["Method", "NoSteadyStateError", "StateName", "SteadyState", "draining_states", "steady_states"]

Array = NDArray[np.float64]

SMALLEST_SHARE = 1e-6
"""Of the largest groove flow: states with less are not sought. For very small exponents of viscosity the hot state
lies at exponentially small flows."""
SAMPLES = 600
"""Of the logarithmic and of the linear grid each."""
THERMAL_SAMPLES = 250
"""Of each grid of narrow-groove theory, whose residual is smooth."""
_COARSE = np.geomspace(SMALLEST_SHARE, 1.0, 160)
TOUCHING = 1e-12
"""Largest residual over the largest groove flow below zero at which a double root is seen."""


def steady_states(footstep: Footstep, method: Method = Method.SUPERPOSITION) -> tuple[SteadyState, ...]:
    """All steady states, the hottest first.

    Parameters
    ----------
    footstep : Footstep
    method : Method

    Returns
    -------
    tuple of SteadyState
        One for a smooth heel; by superposition two for a grooved one whose groove feeds the rim (one where the
        viscosity does not change). Where the groove is too weak for that even with cold oil: those in which it
        drains the rim.

    Raises
    ------
    NoSteadyStateError
        Superposition only: the groove would feed the rim if its oil stayed cold, and cannot with its heat.
    InputError
        E130 where narrow-groove theory is given options of the study's equations.
    """
    if method is Method.NARROW_GROOVE:
        _refuse_options_of_the_study(footstep.options)
        return _thermal_states(footstep)
    if footstep.groove is None:
        return (_smooth_state(footstep),)
    if cold_groove_drains(footstep):
        return draining_states(footstep)
    return _grooved_states(footstep)


def _refuse_options_of_the_study(options: FootstepOptions) -> None:
    usual = FootstepOptions()
    for name in ("friction_viscosity", "face_outlet", "backflow_viscosity", "entry_loss", "speed_reduction"):
        if getattr(options, name) != getattr(usual, name):
            raise InputError(
                "E130",
                f"options: {name} belongs to the equations of the study, and narrow-groove theory does not know "
                "it; leave it out, or take Method.SUPERPOSITION",
            )


def draining_states(footstep: Footstep) -> tuple[SteadyState, ...]:
    """Steady states by superposition in which the groove drains the rim, the hottest first.

    With a viscosity that falls there is one beside every pair of states whose groove feeds the rim: the one to
    which a hot state runs when its groove stops.
    """
    model = DrainedFootstep(footstep)
    pressures = model.pressures(SAMPLES)
    roots = crossings(model.residual, pressures, model.residual(pressures), 1e-7)
    return tuple(_of_draining(model, root) for root in reversed(roots))


def roots_of_balance(model: GroovedFootstep) -> tuple[float, ...]:
    """Groove flows in m³/s at which the rim is in balance, ascending.

    Raises
    ------
    NoSteadyStateError
    """
    most = model.channel.largest_flow
    share = np.union1d(np.geomspace(SMALLEST_SHARE, 1.0, SAMPLES), np.linspace(0.0, 1.0, SAMPLES + 1)[1:])
    flows = share * most
    values = model.residual(flows)
    roots = crossings(model.residual, flows, values, 1e-20)
    if roots:
        return roots
    peak = int(np.argmax(values))
    flow = _summit(model, flows[max(peak - 1, 0)], flows[min(peak + 1, flows.size - 1)])
    largest = float(model.residual(number(flow)))
    if largest >= 0.0:  # two roots between neighbours of the grid
        ends = np.array([flows[max(peak - 1, 0)], flow, flows[min(peak + 1, flows.size - 1)]])
        return crossings(model.residual, ends, model.residual(ends), 1e-20) or (flow,)
    if largest >= -TOUCHING * most:
        return (flow,)
    raise NoSteadyStateError(largest, flow, float(model.balance(number(flow)).rim_pressure))


def has_steady_state(model: GroovedFootstep) -> bool:
    """Whether the rim of a grooved heel can be in balance, by superposition."""
    if (model.residual(_COARSE * model.channel.largest_flow) > 0.0).any():
        return True  # between there and either end, where more comes than leaves
    try:
        roots_of_balance(model)
    except NoSteadyStateError:
        return False
    return True


def crossings(
    function: Callable[[Array], Array], places: Array, values: Array, absolute: float
) -> tuple[float, ...]:
    """Every place where a function changes its sign between neighbours of a grid."""
    signs = np.signbit(values)
    return tuple(
        bracketed_root(
            lambda x: float(function(number(x))), float(places[i]), float(places[i + 1]), absolute, 1e-13
        )
        for i in np.flatnonzero(signs[1:] != signs[:-1])
    )


def _summit(model: GroovedFootstep, low: float, high: float) -> float:
    """Groove flow of the largest residual between two flows."""
    from scipy.optimize import minimize_scalar

    found = minimize_scalar(
        lambda flow: -float(model.residual(number(flow))),
        bounds=(low, high),
        method="bounded",
        options={"xatol": 1e-9 * high},
    )
    return float(found.x)


def _grooved_states(footstep: Footstep) -> tuple[SteadyState, ...]:
    model = GroovedFootstep(footstep)
    roots = roots_of_balance(model)
    return tuple(_of_balance(model, root, name) for root, name in zip(roots, _names(model, roots), strict=True))


def _names(model: GroovedFootstep, roots: tuple[float, ...]) -> Iterator[StateName]:
    """Hot where the residual rises through zero, cold where it falls, fold where it only touches."""
    for root in roots:
        below, above = (float(model.residual(number(root * (1.0 + sign * 1e-6)))) for sign in (-1.0, 1.0))
        if not model.footstep.oil.exponent:
            yield StateName.ONLY
        elif below < 0.0 and above < 0.0:
            yield StateName.FOLD
        else:
            yield StateName.HOT if above > below else StateName.COLD


def _smooth_state(footstep: Footstep) -> SteadyState:
    model = SmoothFootstep(footstep)
    root = bracketed_root(
        lambda p: float(model.residual(number(p))),
        footstep.ambient_pressure,
        footstep.supply_pressure,
        0.0,
    )
    return _of_balance(model, root, StateName.SMOOTH)


def _of_balance(model: GroovedFootstep | SmoothFootstep, root: float, name: StateName) -> SteadyState:
    """Everything of a state by superposition; the unknown is the groove flow, or the pressure of a smooth rim."""
    at = model.balance(number(root))
    residual = abs(float(at.residual) / float(at.leakage))
    if isinstance(model, SmoothFootstep):
        return _superposed(model, root, at, name, stability_of_smooth(model, at), 0.0, residual)
    disturbance = RimDisturbance(model, at)
    stability = stability_of_grooved(disturbance)
    if name is StateName.FOLD:
        stability = replace(stability, stable=False)
    return _superposed(model, root, at, name, stability, disturbance.conductance, residual)


def _of_draining(model: DrainedFootstep, root: float) -> SteadyState:
    """Everything of a state whose groove drains the rim; the unknown is the pressure of the rim."""
    at = model.balance(number(root))
    disturbance = RimDisturbance(model.heel, at)
    stability, residual = stability_of_grooved(disturbance), abs(float(model.residual(number(root)))) / root
    return _superposed(model, root, at, StateName.DRAINING, stability, disturbance.conductance, residual)


def _superposed(
    model: GroovedFootstep | SmoothFootstep | DrainedFootstep,
    root: float,
    at: Balance,
    name: StateName,
    stability: Stability,
    groove_conductance: float,
    residual: float,
) -> SteadyState:
    """A state by superposition with its slopes."""
    footstep, oil = model.footstep, model.footstep.oil
    p1, outlet, leakage = float(at.rim_pressure), float(at.face_temperature), float(at.leakage)
    outflow = leakage / (p1 - footstep.ambient_pressure) + groove_conductance
    smooth = isinstance(model, SmoothFootstep)
    by_face_gap, by_clearance = load_slopes(model, root)
    return SteadyState(
        name=name,
        stable=stability.stable,
        loop_gain=stability.loop_gain,
        rim_pressure=p1,
        face_flow=float(at.face_flow),
        leakage=leakage,
        groove_flow=0.0 if smooth else float(at.groove_flow),
        rim_temperature=float(at.rim_temperature),
        face_temperature=outlet,
        groove_temperature=float("nan") if smooth else float(at.groove_temperature),
        load=model.load(at),
        friction_power=model.friction_power(at),
        axial_stiffness=-by_face_gap,
        axial_damping=axial_damping(footstep, oil.at(0.5 * (oil.temperature + outlet)), outflow),
        load_over_clearance=by_clearance,
        side_force=side_force_of_leakage(footstep, p1),
        residual=residual,
    )


def _thermal_states(footstep: Footstep) -> tuple[SteadyState, ...]:
    """States by narrow-groove theory: an odd number, since the residual has opposite signs at the ends."""
    model = ThermalFilms(footstep)
    roots = crossings(model.residual, *_temperature_grid(model), 1e-22)
    states = sorted((_thermal_state_of(model, root) for root in roots), key=lambda state: -state.rim_temperature)
    names = _names_of_thermal_states(footstep, len(states))
    return tuple(replace(state, name=name) for state, name in zip(states, names, strict=True))


def _names_of_thermal_states(footstep: Footstep, number: int) -> Iterable[StateName]:
    """Names of states, the hottest first."""
    if number == 1:
        return (StateName.SMOOTH if footstep.groove is None else StateName.ONLY,)
    return (StateName.HOT, *[StateName.MIDDLE] * (number - 2), StateName.COLD)


def _temperature_grid(model: ThermalFilms) -> tuple[Array, Array]:
    """Flows towards the rim, from more leakage than the supply drives to that without pressure, and R there."""
    step, annulus = model.footstep, model.annulus
    cold = float(model.viscosity(number(step.oil.temperature)))
    size = annulus.conductance * (step.supply_pressure - step.ambient_pressure) / cold + annulus.dragged_flow
    high = annulus.dragged_flow
    low = high - 2.0 * size
    while float(model.residual(number(low))) <= 0.0:
        low = high - 2.0 * (high - low)
    # The temperatures change fastest where hardly anything flows, hence a grid that is logarithmic from zero.
    fine = np.geomspace(1e-7, 1.0, THERMAL_SAMPLES)
    flows = np.unique(np.concatenate((low * fine, [0.0], np.linspace(low, high, THERMAL_SAMPLES), high * fine)))
    return flows, model.residual(flows)


def _thermal_state_of(model: ThermalFilms, root: float) -> SteadyState:
    """Everything of a state by narrow-groove theory; the unknown is the flow of the clearance towards the rim."""
    footstep = model.footstep
    at: ThermalFilmPair = model.state(number(root))
    stability = stability_of_films(model, root)
    outflow = model.annulus.conductance / float(model.viscosity(at.annulus_temperature))
    pressure = float(at.annulus_pressure)
    by_face_gap, by_clearance = load_slopes(model, root)
    return SteadyState(
        name=StateName.ONLY,
        stable=stability.stable,
        loop_gain=stability.loop_gain,
        rim_pressure=pressure,
        face_flow=-root,
        leakage=-root,
        groove_flow=float("nan"),
        rim_temperature=float(at.annulus_temperature),
        face_temperature=float(at.face_temperature),
        groove_temperature=float("nan"),
        load=model.load(at),
        friction_power=model.friction_power(at),
        axial_stiffness=-by_face_gap,
        axial_damping=axial_damping(footstep, float(model.viscosity(at.face_temperature)), outflow),
        load_over_clearance=by_clearance,
        side_force=side_force_of_leakage(footstep, pressure) if footstep.groove is None else float("nan"),
        residual=abs(float(at.residual)) / pressure,
    )
