"""What is doubtful about the motion of a shaft line."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.kinds.shaft_line.answer import LineAnswer
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.losses import LINEAR_UP_TO
from babbitt.kinds.shaft_line.resonance import NEAR

__all__ = ["line_warnings"]


def line_warnings(design: LineDesign, answer: LineAnswer) -> Iterator[Notice]:
    """Warnings about the motion; `babbitt.kinds.thrust.warnings.sharing_warnings` are about the static share."""
    yield from _about_the_motion(answer)
    yield from _about_the_sweeps(design, answer)


def _about_the_motion(answer: LineAnswer) -> Iterator[Notice]:
    state = answer.state
    relative = float(state.film.relative.max())
    if relative > LINEAR_UP_TO:
        yield Notice(
            "W202",
            f"film amplitude {relative:.2f} of the static film at pad "
            f"{1 + int(state.film.relative.argmax())} > {LINEAR_UP_TO:g}",
        )
    for nu in sorted(set(state.frequencies)):
        damping = state.pads.film(nu).imag / nu
        if damping.min() < 0.0:
            yield Notice(
                "W212",
                f"pad {1 + int(damping.argmin())} at {nu / math.tau:.2f} Hz, {damping.min():.3g} N s/m",
            )
    for met in answer.resonances.encounters:
        if met.separation < NEAR:
            where = (
                f"a peak of the response at {met.resonance / math.tau:.2f} Hz, pad forces {met.amplification:.1f} "
                "times the static ones"
                if met.amplification is not None
                else f"a damped mode of {met.resonance / math.tau:.2f} Hz, damping ratio {met.damping_ratio:.1%}"
            )
            yield Notice(
                "W203",
                f"excitation {met.excitation / math.tau:.2f} Hz (order {met.order:g}) is {met.separation:.0%} "
                f"away from {where}",
            )
    if answer.not_repeating:
        yield Notice("W210", answer.not_repeating)
    moved = answer.nonlinear
    if moved is not None:
        unloaded, closest = 1 + int(moved.lifted.argmax()), 1 + int(moved.thinnest.min(axis=0).argmin())
        for happens, said in (
            (
                moved.lifts_off,
                f"pad {unloaded} carries nothing during {moved.lifted.max():.0%} of the period at most",
            ),
            (moved.touches, f"pad {closest} comes as close as {moved.minimum_film * 1e6:.2f} µm"),
            (moved.outside, "tilts leave the tabulated films"),
        ):
            if happens:
                yield Notice("W205", said)


def _about_the_sweeps(design: LineDesign, answer: LineAnswer) -> Iterator[Notice]:
    speeds, speed = design.speeds, design.thrust.speed
    if speeds and not min(speeds) <= speed <= max(speeds):
        low, at, high = (one * 30.0 / math.pi for one in (min(speeds), speed, max(speeds)))
        yield Notice("W206", f"speed {at:.0f} rpm, map from {low:.0f} to {high:.0f} rpm")
    for what, wanted, found in (
        ("speeds of the map", len(speeds), len(answer.campbell)),
        ("backing rings", answer.wanted_rings, len(answer.rings)),
    ):
        if found < wanted:
            yield Notice("W208", f"{wanted - found} of {wanted} {what}")
