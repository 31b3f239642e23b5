"""A shaft line in pictures: histories of load and film, mode shapes, rings, Campbell map, nonlinear motion."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.shaft_line.answer import LineAnswer
from babbitt.kinds.shaft_line.axial import axial_amplitudes
from babbitt.kinds.shaft_line.resonance import lobes_of
from babbitt.kinds.shaft_line.response import AMPLIFIED, THRUST, pad_forces, static_force
from babbitt.kinds.shaft_line.sweeps import barred_ranges
from babbitt.report.drawing import GREY, INK, PALE, Sheet, limit_line, mark

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DASHES = ("-", "--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)))
RPM = 30.0 / math.pi
NAMED = (14.0, 346.0)
"""Angles in degrees between which names stand clear of the frame."""


def histories(answer: LineAnswer, film_limit: float) -> Figure:
    """Loads and thinnest films of all pads over a revolution."""
    state = answer.state
    figure, ((above,), (below,)) = Sheet(166.0, 84.0, rows=2, left=14.0, between=5.0).panels(sharex=True)
    angles = np.degrees(state.forced.angles)
    loads = (state.share.loads[:, None] + state.forced.force_history()) / 1e3
    films = 1e6 * state.film.histories
    for panel, values, chosen, name in (
        (above, loads, int(loads.max(axis=1).argmax()), "load in kN"),
        (below, films, int(films.min(axis=1).argmin()), "thinnest film in µm"),
    ):
        for pad, history in enumerate(values):
            own = pad == chosen
            panel.plot(
                angles, history, color=INK if own else PALE, linewidth=1.2 if own else 0.7, zorder=3 if own else 2
            )
        place = int(values[chosen].argmax() if panel is above else values[chosen].argmin())
        panel.annotate(
            f"pad {chosen + 1}",
            (float(np.clip(angles[place], *NAMED)), values[chosen, place]),
            xytext=(0, 4 if panel is above else -4),
            textcoords="offset points",
            ha="center",
            va="bottom" if panel is above else "top",
            fontsize=7,
        )
        panel.set_ylabel(name)
        panel.set_ylim(min(0.0, 1.1 * float(values.min())), 1.12 * float(values.max()))
    limit_line(below, 1e6 * film_limit, "limit", beside=float(films[:, -1].min()))
    limit_line(above, state.share.mean_load / 1e3, "mean static load")
    below.set_xlabel("angle of the shaft in °")
    below.set_xlim(0.0, 360.0)
    below.set_xticks(range(0, 361, 45))
    return figure


def mode_shapes(answer: LineAnswer) -> Figure:
    """The lowest modes along the shaft."""
    figure, ((panel,),) = Sheet(81.0, 60.0, left=12.0).panels()
    for mode, dashes in zip(answer.modes[:4], DASHES, strict=False):
        panel.plot(
            mode.places,
            mode.shape,
            color=INK,
            linestyle=dashes,
            linewidth=1.0,
            label=f"{mode.frequency / math.tau:.1f} Hz",
        )
        end = float(mode.places[-1])
        panel.plot(np.full(mode.pads.size, 1.03 * end if end else 0.1), mode.pads, ".", color=GREY, markersize=3)
    panel.axhline(0.0, color=GREY, linewidth=0.5)
    panel.set_ylim(-1.1, 1.1)
    panel.set_xlabel("distance from the propeller in m")
    panel.set_ylabel("displacement")
    panel.legend(
        frameon=False, fontsize=7, loc="lower center", ncols=2, handlelength=2.6, bbox_to_anchor=(0.5, 0.0)
    )
    panel.set_ylim(-1.65, 1.1)
    return figure


def frequency_response(answer: LineAnswer) -> Figure:
    """Largest pad force over its static value for each kind of excitation."""
    figure, ((panel,),) = Sheet(166.0, 66.0, left=14.0).panels()
    state, found = answer.state, answer.resonances
    line, pads = state.duty.line, state.pads
    exciting = [part for part in state.forced.parts if part.harmonic.amplitude > 0.0]
    peaks = [peak.frequency * (1.0 + np.linspace(-0.03, 0.03, 61)) for peak in found.peaks]
    at = np.unique(np.concatenate([np.geomspace(found.lowest, found.highest, 400), *peaks]))
    at = at[(at >= found.lowest) & (at <= found.highest)]
    for lobes, dashes in zip(sorted({lobes_of(part.harmonic) for part in exciting}), DASHES, strict=False):
        forces = np.abs(pad_forces(line, pads, lobes, at)).max(axis=1)
        forces /= static_force(line, pads, lobes, found.lowest)
        label = "thrust ripple" if lobes == THRUST else f"runout of {lobes:g} lobe{'s' if lobes > 1.0 else ''}"
        panel.loglog(at / math.tau, forces, color=INK, linestyle=dashes, linewidth=1.0, label=label)
    panel.axhline(AMPLIFIED, color=GREY, linewidth=0.6)
    for peak in found.peaks:
        mark(panel, peak.frequency / math.tau, peak.amplification)
    panel.relim()
    low, high = panel.get_ylim()
    for mode in found.modes:
        if mode.resonates:
            panel.plot(
                [mode.frequency / math.tau] * 2, [low, low * (high / low) ** 0.06], color=INK, linewidth=1.2
            )
    for order, nu in sorted({(part.harmonic.order, part.response.frequency) for part in exciting}):
        panel.axvline(nu / math.tau, color=GREY, linestyle=":", linewidth=0.9)
        panel.annotate(
            f"{order:g}",
            (nu / math.tau, high),
            xytext=(0, 2),
            textcoords="offset points",
            ha="center",
            fontsize=7,
            annotation_clip=False,
        )
    panel.set_xlim(found.lowest / math.tau, found.highest / math.tau)
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_major_formatter("{x:g}")
    panel.set_ylim(low, high)
    panel.set_xlabel("frequency in Hz")
    panel.set_ylabel("pad force over static")
    panel.legend(frameon=False, fontsize=7, loc="upper left", handlelength=2.6)
    return figure


def ring_sweep(answer: LineAnswer, limit: float) -> Figure:
    """Dynamic load and first frequency over the ring stiffness."""
    figure, ((above,), (below,)) = Sheet(81.0, 84.0, rows=2, left=15.0, between=5.0).panels(sharex=True)
    rings = answer.rings
    c = np.array([point.stiffness for point in rings]) / 1e9
    for name, dashes in (("bound", "-"), ("runout", "--"), ("ripple", ":")):
        label = {"bound": "both", "runout": "runout", "ripple": "thrust ripple"}[name]
        above.semilogx(
            c,
            [100.0 * getattr(point, name) for point in rings],
            color=INK,
            linestyle=dashes,
            linewidth=1.0,
            label=label,
        )
    below.semilogx(c, [point.first_frequency / math.tau for point in rings], color=INK, linewidth=1.0)
    own = answer.state.duty.bearing.ring_stiffness / 1e9
    if math.isfinite(own):
        mark(above, own, 100.0 * answer.state.losses.mean_bound)
        mark(below, own, answer.modes[0].frequency / math.tau)
    if answer.half is not None:
        for panel, value in ((above, 100.0 * answer.half.bound), (below, answer.half.first_frequency / math.tau)):
            panel.plot([answer.half.stiffness / 1e9], [value], "o", color=INK, markerfacecolor="white", zorder=5)
    limit_line(above, 100.0 * limit, "limit", at=0.01)
    above.set_ylim(0.0, None)
    below.set_ylim(0.0, None)
    above.set_ylabel("dynamic load in %")
    below.set_ylabel("first frequency in Hz")
    below.set_xlabel("ring stiffness per pad in GN/m")
    above.legend(frameon=False, fontsize=7, loc="upper left", handlelength=2.4, bbox_to_anchor=(0.0, 0.70))
    return figure


def campbell(answer: LineAnswer, limit: float, speed: float) -> Figure:
    """Resonances and rays of excitation over speed, dynamic load below."""
    figure, ((above,), (below,)) = Sheet(166.0, 100.0, rows=2, left=14.0, between=5.0).panels(sharex=True)
    points = answer.campbell
    rpm = np.array([point.speed for point in points]) * RPM
    orders = sorted({part.harmonic.order for part in answer.state.forced.parts})
    first = [
        min((mode.frequency for mode in one.resonances.modes if mode.resonates), default=0.0) for one in points
    ]
    highest = (
        1.15 * max(max(orders) * points[-1].speed, *first, *(one.frequencies[0] for one in points)) / math.tau
    )
    for n in range(min(len(point.frequencies) for point in points)):
        above.plot(rpm, [point.frequencies[n] / math.tau for point in points], ":", color=GREY, linewidth=0.8)
    for at, point in zip(rpm, points, strict=True):
        damped = [mode.frequency / math.tau for mode in point.resonances.modes if mode.resonates]
        peaks = [peak.frequency / math.tau for peak in point.resonances.peaks]
        above.plot([at] * len(damped), damped, "_", color=INK, markersize=5, markeredgewidth=1.1)
        above.plot([at] * len(peaks), peaks, "o", color=INK, markerfacecolor="white", markersize=3)
    for order in orders:
        above.plot(rpm, order * rpm / 60.0, color=INK, linewidth=0.9)
        above.annotate(
            f"{order:g}",
            (rpm[-1], order * rpm[-1] / 60.0),
            xytext=(3, 0),
            textcoords="offset points",
            fontsize=7,
            va="center",
            annotation_clip=False,
        )
    for low, high, _ in barred_ranges(points):
        for panel in (above, below):
            panel.axvspan(low * RPM, high * RPM, color="0.92", linewidth=0.0, zorder=0)
    above.set_ylim(0.0, highest)
    above.set_ylabel("frequency in Hz")
    losses = [100.0 * point.state.losses.mean_bound for point in points]
    below.plot(rpm, losses, color=INK, linewidth=1.0)
    if rpm[0] <= speed * RPM <= rpm[-1]:
        mark(below, speed * RPM, 100.0 * answer.state.losses.mean_bound)
    limit_line(below, 100.0 * limit, "limit", beside=losses[-1])
    below.set_ylim(0.0, 1.15 * max(max(losses), 100.0 * limit))
    below.set_ylabel("dynamic load in %")
    below.set_xlabel("speed in rpm")
    below.set_xlim(rpm[0], rpm[-1])
    return figure


def axial_amplitude(answer: LineAnswer, limit: float | None, speed: float) -> Figure:
    """Axial vibration of shaft and collar over the speed."""
    figure, ((panel,),) = Sheet(166.0, 60.0, left=14.0).panels()
    rpm = np.array([point.speed for point in answer.campbell]) * RPM
    found = [axial_amplitudes(point.state) for point in answer.campbell]
    for name, dashes, label in (("largest", "-", "largest along the shaft"), ("collar", "--", "collar")):
        panel.semilogy(
            rpm, [1e6 * getattr(one, name) for one in found], dashes, color=INK, linewidth=1.0, label=label
        )
    if rpm[0] <= speed * RPM <= rpm[-1]:
        mark(panel, speed * RPM, 1e6 * axial_amplitudes(answer.state).largest)
    if limit is not None:
        limit_line(panel, 1e6 * limit, "admissible", beside=1e6 * found[-1].largest)
    panel.yaxis.set_major_formatter("{x:g}")
    panel.set_xlim(rpm[0], rpm[-1])
    panel.set_xlabel("speed in rpm")
    panel.set_ylabel("axial amplitude in µm")
    panel.legend(frameon=False, fontsize=7, loc="upper left", handlelength=2.6)
    return figure


def nonlinear(answer: LineAnswer) -> Figure:
    """Load of the pad with the largest dynamic load, nonlinear and linear."""
    moved, state = answer.nonlinear, answer.state
    assert moved is not None
    figure, ((panel,),) = Sheet(81.0, 60.0, left=13.0).panels()
    pad = state.losses.worst_pad
    turns = round((moved.angles[-1] + moved.angles[1]) / math.tau)
    angles = np.append(moved.angles, math.tau * turns)
    linear = sum(
        (part.response.forces[pad] * np.exp(1j * part.harmonic.order * angles)).real for part in state.forced.parts
    )
    panel.plot(
        np.degrees(angles), (state.share.loads[pad] + linear) / 1e3, color=INK, linestyle="--", linewidth=0.9
    )
    loads = np.append(moved.loads[:, pad], moved.loads[0, pad])
    panel.plot(np.degrees(angles), loads / 1e3, color=INK, linewidth=1.1)
    panel.axhline(state.share.loads[pad] / 1e3, color=GREY, linewidth=0.6)
    panel.set_xlim(0.0, 360.0 * turns)
    panel.set_xticks(range(0, 360 * turns + 1, 90 * turns))
    panel.set_xlabel("angle of the shaft in °")
    panel.set_ylabel(f"load of pad {pad + 1} in kN")
    return figure
