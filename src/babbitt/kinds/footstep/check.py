"""From one heel to results: every steady state with values, warnings and stability; or why there is none."""

from __future__ import annotations

import math
from collections.abc import Iterator
from time import perf_counter

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.result_name import ResultName
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.warnings import LARGEST_RISE
from babbitt.kinds.footstep.axial import centrifugal_pressure
from babbitt.kinds.footstep.clearances import critical_clearances, fold_clearance
from babbitt.kinds.footstep.eccentric import leak_factor
from babbitt.kinds.footstep.face import number
from babbitt.kinds.footstep.heat_residual import heat_residual, leaving_flow, needed_flow, uncounted_share
from babbitt.kinds.footstep.model import PITCH_TOLERANCE, Footstep, LoadReference
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.rotating_member import turning_force
from babbitt.kinds.footstep.stability import RimDisturbance
from babbitt.kinds.footstep.states import (
    Method,
    NoSteadyStateError,
    StateName,
    SteadyState,
    draining_states,
    steady_states,
)
from babbitt.kinds.footstep.superposition import GroovedFootstep

__all__ = ["heel_results"]

LAMINAR_UP_TO = 1500.0
"""Reynolds number above which the laminar film is questioned."""
HOTTEST = 150.0 + ZERO_CELSIUS
"""K; mineral oil ages fast above it."""
LAND_SHARE = 1.0 / 3.0
"""Clearance over groove depth above which lands are no lands."""
LOWEST_AMBIENT = 50e3
"""Pa absolute; less looks like a gauge pressure."""
MANY_GROOVES = 20
"""From which narrow-groove theory meets the film in two dimensions within 1 % (validation: film_groove_pitch)."""
MINOR_RISE = 5.0
"""K; friction that would warm the oil by less may be left out of it."""
OPEN_BALANCE = 1e-6
"""Relative error of the mass balance at the rim from which a warning is given."""

TITLES = {
    StateName.SMOOTH: "smooth heel",
    StateName.HOT: "hot state",
    StateName.COLD: "cold state",
    StateName.MIDDLE: "middle state",
    StateName.ONLY: "grooved heel",
    StateName.FOLD: "fold state",
    StateName.DRAINING: "draining groove",
}

TURNING_FORCE = ("heel_force_along", "heel_force_across")
NO_TURNING_FILM = "the film in two dimensions of the turning heel has not been solved"
"""Why there is no force of it."""


def heel_results(case: FootstepProblem) -> tuple[Result, ...]:
    """Solve one heel.

    Parameters
    ----------
    case : FootstepProblem

    Returns
    -------
    tuple of Result
        One for each steady state, the hottest first; one with the outcome NO_STEADY_STATE where there is none.
    """
    begun = perf_counter()
    try:
        states = steady_states(case.footstep, case.method)
    except NoSteadyStateError as error:
        return (_unsolved(case, error, begun),)
    smooth = states[0] if not case.is_grooved else steady_states(case.smooth, case.method)[0]
    shared = _shared_values(case)
    titles = _titles(states)
    return tuple(
        _result(case, state, smooth, shared, title, begun) for state, title in zip(states, titles, strict=True)
    )


def _titles(states: tuple[SteadyState, ...]) -> list[str]:
    """Names of states; those that occur twice are numbered."""
    titles = [TITLES[state.name] for state in states]
    return [
        f"{titles[: i + 1].count(title)}. {title}" if titles.count(title) > 1 else title
        for i, title in enumerate(titles)
    ]


def _unsolved(case: FootstepProblem, error: NoSteadyStateError, begun: float) -> Result:
    far = error.failure
    values = {
        "face_gap": case.footstep.face_gap,
        "heel_clearance": case.footstep.clearance,
        "heel_groove_flow": error.groove_flow,
        "rim_pressure": error.rim_pressure,
        "rim_excess_flow": -error.largest_residual,
    }
    fold = fold_clearance(case.footstep)
    if fold is not None:
        values["fold_clearance"] = fold
        far = Notice("S020", "from_fold", {"far": far, "fold_clearance": fold})
    drained = tuple(map(_drained, draining_states(case.footstep)))
    if drained:
        far = Notice("S020", "drained", {"far": far, "drained": drained})
    return Result(
        ResultName(case.name, state="grooved heel"), case.kind, case.method.value, Outcome.NO_STEADY_STATE,
        values | {"wall_time": perf_counter() - begun},
        warnings=tuple(_warnings_about_inputs(case)), assumptions=_assumptions(case),
        settings=_settings(case), failure=Notice("S020", "tried", {"far": far}),
    )  # fmt: skip


def _drained(state: SteadyState) -> Notice:
    """A state whose groove drains the rim."""
    return Notice("W178", "stable" if state.stable else "not_stable", {
        "rim_pressure": state.rim_pressure,
        "flow": -state.groove_flow,
        "groove_outlet_temperature": state.groove_temperature,
        "load": state.load,
    })  # fmt: skip


def _result(
    case: FootstepProblem,
    state: SteadyState,
    smooth: SteadyState,
    shared: dict[str, float],
    title: str,
    begun: float,
) -> Result:
    found = _values(case, state)
    values = {name: value for name, value in found.items() if not math.isnan(value)}
    if case.is_grooved:
        values["load_ratio_to_smooth"] = state.load / smooth.load
        values["friction_ratio_to_smooth"] = smooth.friction_power / state.friction_power
    values |= shared | {"wall_time": perf_counter() - begun}
    checks = (
        Check(
            "C130", "thermal_loop_gain", state.loop_gain, 1.0, Bound.AT_MOST,
            "less of a disturbance of temperature must come back than there was; a state that misses it has no "
            "verdict (W160)", advisory=True,
        ),
        _heat_check(case, state),
    )  # fmt: skip
    return Result(
        ResultName(case.name, state=title), case.kind, case.method.value, Outcome.CONVERGED, values, checks,
        (*_warnings_about_inputs(case), *_warnings(case, state, values)), (), _assumptions(case),
        _settings(case) | {"state": state.name.value, "stable": "yes" if state.stable else "no"},
        missing={name: NO_TURNING_FILM for name in TURNING_FORCE if name in found and name not in values},
    )  # fmt: skip


def _heat_check(case: FootstepProblem, state: SteadyState) -> Check:
    """Advice: the oil that leaves must be able to take the heat left out of it, else such a state cannot last."""
    needed = needed_flow(case.footstep, state, case.method, LARGEST_RISE)
    return Check(
        "C131", "heel_leaving_flow", leaving_flow(state, case.method), needed, Bound.AT_LEAST,
        f"friction heat at a rise of {LARGEST_RISE:.0f} K", advisory=True,
    )  # fmt: skip


def _values(case: FootstepProblem, state: SteadyState) -> dict[str, float]:
    step, nan = case.footstep, math.nan
    both = case.method is Method.SUPERPOSITION
    grooved = both and case.is_grooved
    return {
        "face_gap": step.face_gap,
        "heel_clearance": step.clearance,
        "load": state.load,
        "rim_pressure": state.rim_pressure,
        "face_flow": state.face_flow,
        "heel_groove_flow": state.groove_flow if grooved else nan,
        "heel_leakage": state.leakage if both or not case.is_grooved else nan,
        "heel_net_flow": state.leakage - state.groove_flow if grooved else state.leakage,
        "heel_leaving_flow": leaving_flow(state, case.method),
        "groove_outlet_temperature": state.groove_temperature,
        "face_outlet_temperature": state.face_temperature if both else nan,
        "face_film_temperature": nan if both else state.face_temperature,
        "rim_temperature": state.rim_temperature if both else nan,
        "clearance_film_temperature": nan if both else state.rim_temperature,
        "maximum_temperature": state.maximum_temperature,
        "friction_power": state.friction_power,
        "face_gap_stiffness": state.axial_stiffness,
        "face_gap_damping": state.axial_damping,
        "load_over_clearance": state.load_over_clearance,
        "thermal_loop_gain": state.loop_gain,
        "mass_balance_error": state.residual,
        "energy_balance_error": uncounted_share(step, state, case.method),
        "clearance_reynolds_number": step.oil.density
        * step.angular_speed
        * step.geometry.radius
        * step.clearance
        / step.oil.at(state.rim_temperature),
        **_eccentric_values(step, state),
    }


def _eccentric_values(step: Footstep, state: SteadyState) -> dict[str, float]:
    if step.end_eccentricities == (0.0, 0.0):
        return {}
    values = {"leak_factor": leak_factor(*step.end_eccentricities), "leakage_side_force": state.side_force}
    if step.groove is None:
        along, across = turning_force(step, state.rim_pressure, step.oil.at(state.rim_temperature))
        values |= dict(zip(TURNING_FORCE, (along, across), strict=True))
    return values


def _shared_values(case: FootstepProblem) -> dict[str, float]:
    """What all states of a heel have in common."""
    step, oil, part = case.footstep, case.footstep.oil, case.footstep.geometry
    stirring = step.angular_speed * part.recess_radius * part.recess_depth
    values = {
        "recess_reynolds_number": oil.density * stirring / oil.viscosity,
        "centrifugal_pressure": centrifugal_pressure(step),
    }  # fmt: skip
    if step.groove is None:
        return values
    speed = step.groove_speed * part.radius * math.cos(step.groove.angle)
    values["groove_reynolds_number"] = oil.density * speed * step.groove.depth / oil.viscosity
    if case.method is Method.SUPERPOSITION:
        critical = critical_clearances(step)
        if critical:
            values["critical_clearance"] = critical[0].clearance
            values["critical_temperature"] = critical[0].temperature
        fold = fold_clearance(step)
        if fold is not None:
            values["fold_clearance"] = fold
    return values


def _warnings_about_inputs(case: FootstepProblem) -> Iterator[Notice]:
    step = case.footstep
    yield from case.warnings
    if step.ambient_pressure < LOWEST_AMBIENT:
        yield Notice("W163", values={"pressure": step.ambient_pressure, "limit": LOWEST_AMBIENT})
    groove = step.groove
    if groove is None:
        return
    if step.clearance >= LAND_SHARE * groove.depth:
        yield Notice("W162", values={"heel_clearance": step.clearance, "depth": groove.depth})
    misfit = groove.misfit(step.geometry.radius)
    if abs(misfit) > PITCH_TOLERANCE:
        yield Notice("W165", values={"part": 1.0 + misfit})
    if case.method is Method.SUPERPOSITION:
        yield Notice("W168")
    elif groove.starts < MANY_GROOVES:
        yield Notice("W169", values={"starts": groove.starts, "least": MANY_GROOVES})


def _warnings(case: FootstepProblem, state: SteadyState, values: dict[str, float]) -> Iterator[Notice]:
    if not state.stable:
        yield _departure(case, state)
    if state.name is StateName.DRAINING:
        yield _drained(state)
    if state.residual > OPEN_BALANCE:
        yield Notice("W177", values={"error": state.residual})
    hotter = state.maximum_temperature - case.footstep.oil.temperature
    if hotter > LARGEST_RISE:
        yield Notice("W176", "warmed", {"rise": hotter, "limit": LARGEST_RISE})
    if state.maximum_temperature > HOTTEST:
        yield Notice("W161", values={"maximum_temperature": state.maximum_temperature, "limit": HOTTEST})
    for where in ("groove", "recess", "clearance"):
        if (reynolds := values.get(f"{where}_reynolds_number", 0.0)) > LAMINAR_UP_TO:
            yield Notice("W164", where, {"reynolds_number": reynolds, "limit": LAMINAR_UP_TO})
    if state.face_flow < 0.0:
        yield Notice("W166", values={
            "face_flow": state.face_flow,
            "rim_pressure": state.rim_pressure,
            "recess_pressure": case.footstep.supply_pressure,
        })  # fmt: skip
    if state.axial_stiffness < 0.0:
        yield Notice("W167", values={"slope": -state.axial_stiffness})
    heat, rise = heat_residual(case.footstep, state, case.method)
    if rise > MINOR_RISE:
        yield Notice("W171", values={"heat": heat, "rise": rise})
        if rise > LARGEST_RISE and hotter <= LARGEST_RISE:
            leaving = leaving_flow(state, case.method)
            yield Notice("W176", "left_out", {"leaving": leaving, "rise": rise, "limit": LARGEST_RISE})
    if case.is_grooved and "leak_factor" in values:
        yield Notice("W170", values={"eccentricities": case.footstep.end_eccentricities})


def _departure(case: FootstepProblem, state: SteadyState) -> Notice:
    """How a state that is not stable is left, and where to."""
    if state.loop_gain < 1.0:
        return Notice("W160", "swinging")
    how = Notice("W160", "gain", {"thermal_loop_gain": state.loop_gain})
    if case.method is not Method.SUPERPOSITION or not case.is_grooved or state.groove_flow <= 0.0:
        return how
    model = GroovedFootstep(case.footstep)
    rate = RimDisturbance(model, model.balance(number(state.groove_flow))).growth_rate()
    if rate > 0.0:
        how = Notice("W160", "growth", {"thermal_loop_gain": state.loop_gain, "time": 1.0 / rate})
    drained = tuple(map(_drained, draining_states(case.footstep)))
    if not drained:
        return Notice("W160", "left", {"how": how})
    return Notice("W160", "drained", {"how": how, "drained": drained})


def _assumptions(case: FootstepProblem) -> tuple[str, ...]:
    step = case.footstep
    said = [
        *case.assumptions,
        "Laminar film, no cavitation, clearance the same at every temperature and pressure.",
    ]
    if case.method is Method.SUPERPOSITION:
        said.append("Adiabatic groove and face gap; the clearance holds oil of one temperature.")
        if case.is_grooved and step.options.speed_reduction == 0.0:
            said.append("The speed-reduction factor β of the study, which it never defines, is zero.")
    elif step.wall is None:
        said.append("The films are as warm as the oil that comes in.")
    else:
        said.append("Metal of one temperature, whose conductance both films share in equal halves.")
    if step.options.load_reference is LoadReference.ABSOLUTE:
        said.append("The load counts absolute pressures between bore and rim; the bore itself is not in it.")
    return tuple(said)


def _settings(case: FootstepProblem) -> dict[str, str]:
    options = case.footstep.options
    settings = {
        "variant": "grooved" if case.is_grooved else "smooth",
        "load_reference": options.load_reference.name.lower(),
    }
    if case.method is Method.SUPERPOSITION:
        settings |= {
            "friction_viscosity": options.friction_viscosity.name.lower(),
            "face_outlet": options.face_outlet.name.lower(),
            "backflow_viscosity": options.backflow_viscosity.name.lower(),
            "entry_loss": f"{options.entry_loss:g}",
        }
    return settings
