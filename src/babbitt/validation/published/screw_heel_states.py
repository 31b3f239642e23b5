"""Steady states of the screw-grooved footstep, beside an independent prototype of the corrected equations."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.footstep.clearances import critical_clearances, fold_clearance
from babbitt.kinds.footstep.model import Wall
from babbitt.kinds.footstep.narrow_groove import NarrowGrooveAnnulus
from babbitt.kinds.footstep.states import Method, NoSteadyStateError, StateName, SteadyState, steady_states
from babbitt.kinds.footstep.superposition import GrooveChannel
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import GREY, INK
from babbitt.validation.published.screw_heel_common import (
    CUBIC_MILLIMETRE,
    MEGA,
    MICRO,
    SOURCE,
    footstep,
    smooth,
    states,
)
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TABLE = Within(relative=1e-5)
_COLUMNS: tuple[tuple[str, str, Callable[[SteadyState], float]], ...] = (
    ("Q_k", "mm³/s", lambda s: s.groove_flow / CUBIC_MILLIMETRE),
    ("Q₂", "mm³/s", lambda s: s.face_flow / CUBIC_MILLIMETRE),
    ("Q_l", "mm³/s", lambda s: s.leakage / CUBIC_MILLIMETRE),
    ("p₁", "MPa", lambda s: s.rim_pressure / MEGA),
    ("θ₁′", "°C", lambda s: s.groove_temperature - ZERO_CELSIUS),
    ("θ", "°C", lambda s: s.rim_temperature - ZERO_CELSIUS),
    ("T", "N", lambda s: s.load),
    ("P", "W", lambda s: s.friction_power),
)


def run() -> tuple[Comparison, ...]:
    """Table of states, stiffness, clearances, constant viscosity, narrow grooves, warm films."""
    return (*_table(), *_stiffness(), *_clearances(), *_constant_viscosity(), *_narrow_grooves(), *_warm_films())


def _table() -> Iterator[Comparison]:
    for row in reference_data("screw_heel")["states"]:
        gap, clearance, name = row[:3]
        state, place = states(footstep(gap, clearance))[name], f"h = {gap} µm, δ = {clearance} µm, {name}"
        for (symbol, unit, read), published in zip(_COLUMNS, row[3:11], strict=True):
            if published is not None:
                yield Comparison(symbol, place, published, read(state), _TABLE, unit, "table of states")
        yield Comparison(
            "stable", place, float(row[11]), float(state.stable), Within(absolute=0.5), "", "table of states",
            remark="1: stable, 0: not stable",
        )  # fmt: skip


def _stiffness() -> Iterator[Comparison]:
    for name, published in reference_data("screw_heel")["stiffness_h_20_delta_20_N_um"].items():
        ours = -states(footstep())[name].axial_stiffness * 1e-6
        place = f"h = δ = 20 µm, {name}"
        yield Comparison("dT/dh", place, published, ours, Within(absolute=0.006), "N/µm", "prototype", 2)


def _clearances() -> Iterator[Comparison]:
    data = reference_data("screw_heel")
    for gap, published in data["fold_clearance_um"]:
        fold = fold_clearance(footstep(gap))
        ours = float("nan") if fold is None else fold / MICRO
        yield Comparison("δ_f", f"h = {gap} µm", published, ours, Within(absolute=0.01), "µm", "prototype", 3)
    study = data["critical_clearance"]
    for found, name in zip(critical_clearances(footstep()), ("hot", "cold"), strict=True):
        yield Comparison(
            "δ_cr", name, study[f"{name}_um"], found.clearance / MICRO, Within(absolute=6e-4), "µm", "prototype", 3
        )
        yield Comparison(
            "θ₁′ at δ_cr", name, study[f"{name}_C"], found.temperature - ZERO_CELSIUS, Within(absolute=6e-3), "°C",
            "prototype", 2,
        )  # fmt: skip
        flow = found.groove_flow / CUBIC_MILLIMETRE
        published = study[f"{name}_flow_mm3_s"]
        yield Comparison("Q_k at δ_cr", name, published, flow, Within(relative=3e-4), "mm³/s", "prototype")


def _constant_viscosity() -> Iterator[Comparison]:
    study = reference_data("screw_heel")["constant_viscosity"]
    step = replace(footstep(), oil=replace(footstep().oil, exponent=0.0))
    (grooved,), (plain,) = steady_states(step), steady_states(smooth(step))
    wide = steady_states(smooth(replace(step, face_gap=5e-3)))[0]
    rows = (
        ("p₁", "α = 0, grooved", "MPa", study["rim_pressure_MPa"], grooved.rim_pressure / MEGA, 1e-6),
        ("Q_k", "α = 0, grooved", "mm³/s", study["groove_flow_mm3_s"],
         grooved.groove_flow / CUBIC_MILLIMETRE, 1e-6),
        ("Q_l", "α = 0, grooved", "mm³/s", study["leakage_mm3_s"], grooved.leakage / CUBIC_MILLIMETRE, 1e-6),
        ("Q₂", "α = 0, grooved", "mm³/s", study["face_flow_mm3_s"], grooved.face_flow / CUBIC_MILLIMETRE, 1e-6),
        ("T", "α = 0, grooved", "N", study["load_N"], grooved.load, 1e-6),
        ("Q", "α = 0, smooth", "mm³/s", study["smooth_flow_mm3_s"], plain.leakage / CUBIC_MILLIMETRE, 1e-6),
        ("p₁", "α = 0, smooth", "MPa", study["smooth_rim_pressure_MPa"], plain.rim_pressure / MEGA, 1e-6),
        ("T", "α = 0, smooth", "N", study["smooth_load_N"], plain.load, 1e-6),
        ("p₁ − p_a", "α = 0, dead-end groove", "MPa", study["dead_end_rise_MPa"],
         GrooveChannel(step).dead_end_rise / MEGA, 1e-4),
        ("T", "h → ∞, smooth", "N", study["largest_load_N"], wide.load, 1e-4),
    )  # fmt: skip
    for symbol, place, unit, published, ours, relative in rows:
        yield Comparison(symbol, place, published, ours, Within(relative=relative), unit, "closed form")


def _narrow_grooves() -> Iterator[Comparison]:
    study, annulus = reference_data("screw_heel")["narrow_groove"], NarrowGrooveAnnulus(footstep())
    mu = footstep().oil.viscosity

    def power(rise: float) -> float:
        return mu * float(annulus.wall_power(np.asarray(annulus.dragged_flow - annulus.conductance * rise / mu)))

    rows = (
        ("Q₀", "mm³/s", study["dragged_flow_mm3_s"], annulus.dragged_flow / CUBIC_MILLIMETRE),
        ("G", "m³/(s Pa)", study["conductance_m3_s_Pa"], annulus.conductance / mu),
        ("P at Δp = 0", "W", study["friction_W"], power(0.0)),
        ("P at Δp = 0.5 MPa", "W", study["friction_at_half_MPa_W"], power(0.5e6)),
    )
    for symbol, unit, published, ours in rows:
        yield Comparison(
            symbol, "narrow grooves, δ = 20 µm", published, ours, Within(relative=1e-6), unit, "prototype"
        )


@lru_cache
def _warm(clearance: float, conductance: float) -> tuple[SteadyState, SteadyState]:
    step = replace(footstep(20.0, clearance), wall=Wall(25.0 + ZERO_CELSIUS, conductance))
    found = states(step, Method.NARROW_GROOVE)
    return found["smooth"], found["grooved"]


def _warm_films() -> Iterator[Comparison]:
    study = reference_data("screw_heel")["warm_films"]
    plain, grooved = _warm(20.0, study["conductance_W_K"])
    yield Comparison(
        "T",
        "metal 10 W/K, grooved",
        study["grooved_load_N"],
        grooved.load,
        Within(absolute=0.1),
        "N",
        "prototype",
        1,
    )
    yield Comparison(
        "T", "metal 10 W/K, smooth", study["smooth_load_N"], plain.load, Within(absolute=0.1), "N", "prototype", 1
    )
    for clearance, conductance, gain, ratio in (
        (20.0, study["conductance_W_K"], study["load_gain_percent"], study["power_ratio"]),
        (10.0, study["conductance_W_K"], study["load_gain_at_10_um_percent"], study["power_ratio_at_10_um"]),
        (20.0, study["conductance_for_10_percent_W_K"], 10.0, study["power_ratio_there"]),
    ):
        plain, grooved = _warm(clearance, conductance)
        place = f"metal {conductance:g} W/K, δ = {clearance:g} µm"
        ours = 100.0 * (grooved.load / plain.load - 1.0)
        yield Comparison("load gain", place, gain, ours, Within(absolute=0.06), "%", "prototype", 1)
        ours = plain.friction_power / grooved.friction_power
        yield Comparison("power ratio", place, ratio, ours, Within(absolute=0.006), "", "prototype", 2)


def draw(figure: Figure) -> None:
    """Steady states over the clearance for three face gaps."""
    figure.set_size_inches(7.2, 3.2)
    for axes, gap in zip(figure.subplots(1, 3, sharey=True), (10.0, 20.0, 40.0), strict=True):
        clearances = np.geomspace(6.0, 60.0, 60)
        found = [_states_at(gap, clearance) for clearance in clearances]
        for name, stable, style, colour in (
            (StateName.SMOOTH, True, "-", GREY), (StateName.HOT, True, "-", INK),
            (StateName.HOT, False, "--", INK),
            (StateName.COLD, True, "-", INK), (StateName.COLD, False, "--", INK),
        ):  # fmt: skip
            loads = [
                next((s.load for s in each if s.name is name and s.stable is stable), float("nan"))
                for each in found
            ]
            axes.plot(clearances, loads, linestyle=style, color=colour)
        for row in reference_data("screw_heel")["states"]:
            if row[0] == gap:
                axes.plot(row[1], row[9], "o", color=INK, markerfacecolor=INK if row[11] else "white")
        axes.set_xlabel("δ in µm")
        axes.set_title(f"h = {gap:g} µm")
        axes.set_ylabel("T in N")
        axes.label_outer()


def _states_at(gap: float, clearance: float) -> tuple[SteadyState, ...]:
    step = footstep(gap, clearance)
    try:
        return (*steady_states(smooth(step)), *steady_states(step))
    except NoSteadyStateError:
        return steady_states(smooth(step))


CASE = ValidationCase(
    name="screw_heel_states",
    title="Screw-grooved footstep: steady states, clearances, narrow grooves, warm films",
    story=Story(
        what="A footstep with a screw-grooved heel has two steady states, a hot and a cold one, or none. Flows, "
        "pressure, temperatures, load, friction and stability of each are compared, the clearances at which "
        "states "
        "vanish, the closed forms of constant viscosity, narrow-groove theory, and films that give heat to the "
        "metal.",
        source=f"{SOURCE} The reference values come from a prototype of the same corrected equations, written "
        "separately; they check our code against an independent one, not the equations against a pump.",
        assumptions="The study never defines its speed-reduction factor β (zero here) nor says whether the supply "
        "pressure is absolute (absolute here, since it is printed beside an absolute ambient pressure). The "
        "metal's "
        "conductance is shared by both films in equal halves.",
        tolerances="Seven digits of the prototype allow 1e-5; elsewhere half of the last digit given. The fold "
        "is known "
        "to 0.01 µm. A stability flag has to be right.",
        differences="The prototype's fold at h = 12 µm lies 0.004 µm higher; at the fold the search of either "
        "program "
        "ends on its own last grid.",
    ),
    run=run,
    draw=draw,
    caption="Load over clearance for three face gaps. Full lines: stable; broken: not stable; grey: smooth heel; "
    "points: the prototype, open where not stable.",
    evidence=Evidence.REGRESSION,
)
