"""What is doubtful about the motion of a shaft line."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.kinds.shaft_line.answer import LineAnswer
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.losses import LINEAR_UP_TO
from babbitt.kinds.shaft_line.resonance import NEAR, Encounter

__all__ = ["line_warnings"]


def line_warnings(design: LineDesign, answer: LineAnswer) -> Iterator[Notice]:
    """Warnings about the motion; `babbitt.kinds.thrust.warnings.sharing_warnings` are about the static share."""
    yield from _about_the_motion(answer)
    yield from _about_the_sweeps(design, answer)


def _about_the_motion(answer: LineAnswer) -> Iterator[Notice]:
    state = answer.state
    relative = float(state.film.relative.max())
    if relative > LINEAR_UP_TO:
        pad = 1 + int(state.film.relative.argmax())
        yield Notice("W202", values={"amplitude": relative, "pad": pad, "limit": LINEAR_UP_TO})
    for nu in sorted(set(state.frequencies)):
        damping = state.pads.film(nu).imag / nu
        if damping.min() < 0.0:
            pad, least = 1 + int(damping.argmin()), float(damping.min())
            yield Notice("W212", "frequency", {"pad": pad, "frequency": float(nu), "damping": least})
    for met in answer.resonances.encounters:
        if met.separation < NEAR:
            yield _near(met)
    if answer.not_repeating is not None:
        yield answer.not_repeating
    moved = answer.nonlinear
    if moved is not None:
        unloaded, closest = 1 + int(moved.lifted.argmax()), 1 + int(moved.thinnest.min(axis=0).argmin())
        if moved.lifts_off:
            yield Notice("W205", "unloaded", {"pad": unloaded, "share": float(moved.lifted.max())})
        if moved.touches:
            yield Notice("W205", "close", {"pad": closest, "film": float(moved.minimum_film)})
        if moved.outside:
            yield Notice("W205", "outside")


def _near(met: Encounter) -> Notice:
    """An excitation close to a resonance, by a peak of the response or by a damped mode."""
    if met.amplification is not None:
        return Notice("W203", "peak", {
            "excitation": met.excitation, "order": met.order, "separation": met.separation,
            "resonance": met.resonance, "amplification": met.amplification,
        })  # fmt: skip
    return Notice("W203", "mode", {
        "excitation": met.excitation, "order": met.order, "separation": met.separation,
        "resonance": met.resonance, "damping_ratio": met.damping_ratio,
    })  # fmt: skip


def _about_the_sweeps(design: LineDesign, answer: LineAnswer) -> Iterator[Notice]:
    speeds, speed = design.speeds, design.thrust.speed
    if speeds and not min(speeds) <= speed <= max(speeds):
        yield Notice("W206", values={"speed": speed, "low": min(speeds), "high": max(speeds)})
    for what, wanted, found in (
        ("speeds", len(speeds), len(answer.campbell)),
        ("rings", answer.wanted_rings, len(answer.rings)),
    ):
        if found < wanted:
            yield Notice("W208", what, {"missing": wanted - found, "wanted": wanted})
