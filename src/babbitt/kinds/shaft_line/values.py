"""Values of a shaft line, and its tables."""

from __future__ import annotations

import math

import numpy as np

from babbitt.core.result import Matrix
from babbitt.kinds.shaft_line.admissible_amplitude import motion_values
from babbitt.kinds.shaft_line.answer import MODES, LineAnswer
from babbitt.kinds.shaft_line.axial import axial_amplitudes
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.inverse import AdmissibleAmplitude
from babbitt.kinds.shaft_line.sweeps import barred_ranges
from babbitt.kinds.thrust.values import pad_arrays, share_values

__all__ = ["bearables", "line_arrays", "line_values"]

HISTORY = 180
"""Angles of the shaft, at least, at which pad loads are written."""


def line_values(design: LineDesign, answer: LineAnswer) -> dict[str, float]:
    """Named values in SI; those of the static share among them."""
    state, losses = answer.state, answer.state.losses
    axial = axial_amplitudes(state)
    values = share_values(design.thrust, answer.static)
    values |= {
        **motion_values(state),
        "collar_axial_amplitude": axial.collar,
        "far_end_axial_amplitude": axial.far_end,
        "loss_mean_peak": losses.mean_peak,
        "loss_mean_worst_turn": state.worst_turn_loss,
        "loss_own_bound": losses.own_bound,
        "loss_own_peak": losses.own_peak,
        "unload_margin_peak": losses.margin_peak,
        "dynamic_minimum_film_peak": float(state.film.thinnest.min()),
        "relative_film_amplitude": float(state.film.relative.max()),
        "collar_moment_amplitude": state.moment_amplitude,
        "runout_share": answer.causes.runout,
        "ripple_share": answer.causes.ripple,
        "tilt_share": answer.causes.tilt,
        "elasticity_share": answer.causes.elasticity,
        **{f"natural_frequency_{n}": mode.frequency for n, mode in enumerate(answer.modes[:MODES], start=1)},
    }
    for mode in answer.resonances.modes:
        if mode.order == 1:
            values["damping_ratio_1"] = mode.damping_ratio
    if math.isfinite(answer.separation):
        values["frequency_separation"] = answer.separation
    values |= {name: one.largest for name, one in bearables(answer).items() if math.isfinite(one.largest)}
    if answer.half is not None:
        values["half_load_ring_stiffness"] = answer.half.stiffness
    if answer.best is not None:
        values |= {"best_ring_stiffness": answer.best.stiffness, "best_ring_loss": answer.best.bound}
    if answer.nonlinear is not None:
        moved = answer.nonlinear
        values |= {
            "nonlinear_load_peak": float(moved.load_peaks.max()),
            "nonlinear_unload_peak": float(moved.unload_peaks.max()),
            "nonlinear_minimum_film": moved.minimum_film,
            "mean_film_shift": float(moved.film_shift.max()),
        }
    return values


def bearables(answer: LineAnswer) -> dict[str, AdmissibleAmplitude]:
    """What the line can bear, by the names of its results."""
    found = answer.bearable
    each = {
        "admissible_runout": found.runout,
        "admissible_tilt": found.tilt,
        "admissible_ripple": found.ripple,
    }
    return {name: one for name, one in each.items() if one is not None}


def line_arrays(design: LineDesign, answer: LineAnswer) -> dict[str, Matrix]:
    """Rows of one number per pad, modes and sweeps."""
    state = answer.state
    forced = state.forced
    arrays = pad_arrays(state.share, design.thrust.speed)
    frequencies = sorted(set(state.frequencies))
    films = state.pads.films(np.array(frequencies))
    for name, values in (
        ("pad_stiffness_over_frequency", films.real),
        ("pad_damping_over_frequency", films.imag / np.array(frequencies)[:, None]),
    ):
        arrays[name] = tuple((nu, *map(float, row)) for nu, row in zip(frequencies, values, strict=True))
    axial = axial_amplitudes(state)
    arrays["axial_amplitude_along"] = tuple(
        (float(place), *map(float, row)) for place, row in zip(axial.places, axial.each.T, strict=True)
    )
    if forced.commensurate:
        step = max(1, forced.angles.size // HISTORY)
        loads = state.share.loads[:, None] + forced.force_history()
        arrays["pad_load_history"] = tuple(
            (float(angle), *map(float, row))
            for angle, row in zip(forced.angles[::step], loads.T[::step], strict=True)
        )
    rows = {
        "runout_force": forced.bounds_of(runout=True),
        "ripple_force": forced.bounds_of(runout=False),
        "dynamic_peak": forced.peaks(),
        "dynamic_bound": forced.bounds(),
        "pad_dynamic_film": state.film.thinnest_bound,
    }
    arrays |= {name: (tuple(float(one) for one in row),) for name, row in rows.items()}
    found = answer.resonances
    arrays["damped_modes"] = tuple((mode.frequency, mode.damping_ratio, mode.order) for mode in found.modes)
    arrays["response_peaks"] = tuple((peak.frequency, peak.amplification, peak.lobes) for peak in found.peaks)
    arrays["ring_sweep"] = tuple(
        (
            p.stiffness,
            p.runout,
            p.ripple,
            p.bound,
            p.film_amplitude,
            p.thinnest_film,
            p.first_frequency,
            p.largest_over_mean,
        )
        for p in answer.rings
    )
    if answer.campbell:
        arrays["campbell"] = tuple((p.speed, p.state.losses.mean_bound, *p.frequencies) for p in answer.campbell)
        arrays["axial_amplitude_over_speed"] = tuple(
            (p.speed, found.collar, found.far_end, found.largest)
            for p, found in ((p, axial_amplitudes(p.state)) for p in answer.campbell)
        )
        arrays["resonances_met"] = tuple(
            (p.speed, met.order, met.resonance, met.separation)
            for p in answer.campbell
            for met in p.resonances.encounters
        )
        if barred := barred_ranges(answer.campbell):
            arrays["barred_ranges"] = barred
    return arrays
