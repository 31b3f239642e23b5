"""Figures of a thrust bearing and its shaft line."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.kinds.shaft_line.answer import LineAnswer, line_answer
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.design import ThrustDesign, bearing_state
from babbitt.kinds.thrust.sharing import Share
from babbitt.report.drawing import Drawing, rendered, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["thrust_figures"]

Painted = tuple[str, str, "Figure", bool]


def thrust_figures(
    design: ThrustDesign | LineDesign, result: Result, image_format: str = "svg"
) -> tuple[Drawing, ...]:
    """Every figure of a solved bearing or line.

    Parameters
    ----------
    design : ThrustDesign or LineDesign
    result : Result
        Its answer; an unsolved one has no figures.
    image_format : {"svg", "pdf", "png"}
    """
    if not result.outcome.solved:
        return ()
    with style():
        painted = _of_line(design) if isinstance(design, LineDesign) else _of_bearing(design)
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), wide) for name, caption, figure, wide in painted
        )


def _of_bearing(design: ThrustDesign) -> Iterator[Painted]:
    from babbitt.kinds.thrust.report import plots as thrust_painters

    state = bearing_state(design)
    yield (
        "pads-polar",
        "Static load of each pad, outward from the ring; the collar turns as the arrow says. Thin ring: "
        "mean load; dotted: where the housing comes closest.",
        thrust_painters.pads_polar(state.share, None),
        False,
    )
    yield (
        "pad-pressure",
        "Pressure on the pad that carries most, seen from the collar. Cross: highest pressure; circle: pivot.",
        thrust_painters.pad_pressure(state.share),
        False,
    )
    yield from _temperature(state.share)


def _temperature(share: Share) -> Iterator[Painted]:
    from babbitt.kinds.thrust.report import plots as thrust_painters

    if any(pad.heat is not None for pad in share.states):
        yield (
            "pad-temperature",
            "Temperature of the film in °C along the hottest pad and across the gap; the cross marks the highest.",
            thrust_painters.pad_temperature(share),
            False,
        )


def _of_line(design: LineDesign) -> Iterator[Painted]:
    from babbitt.kinds.shaft_line.report import plots as line_painters
    from babbitt.kinds.thrust.report import plots as thrust_painters

    answer: LineAnswer = line_answer(design)
    state = answer.state
    yield (
        "pads-polar",
        "Static load of each pad (grey) and the range of its dynamic load for any phases (black), outward "
        "from the ring. Thin ring: mean load; dotted: where the housing comes closest.",
        thrust_painters.pads_polar(state.share, state.forced.bounds()),
        False,
    )
    yield (
        "pad-pressure",
        "Static pressure on the pad that carries most, seen from the collar. Cross: highest pressure; "
        "circle: pivot.",
        thrust_painters.pad_pressure(state.share),
        False,
    )
    yield from _temperature(state.share)
    if state.forced.commensurate:
        yield (
            "film-history",
            "Load (above) and thinnest film (below) of the pads over a revolution with the phases given. "
            "Black: the pads with the largest load and the thinnest film; broken: limit of the film.",
            line_painters.histories(answer, design.thrust.film_limit),
            True,
        )
    yield (
        "mode-shapes",
        "Axial mode shapes along the shaft, the propeller on the left; dots: pads.",
        line_painters.mode_shapes(answer),
        False,
    )
    if answer.resonances.encounters or answer.resonances.peaks:
        yield (
            "frequency-response",
            "Largest pad force over its static value for one kind of excitation each, films and tilts at that "
            "frequency. Dotted: excitations with their order; line: twice the static force; filled: peaks that "
            "count as resonances; bars below: damped modes with a damping ratio below 25 %.",
            line_painters.frequency_response(answer),
            True,
        )
    if answer.rings:
        yield (
            "ring-sweep",
            "Dynamic load over the stiffness of the backing ring (above), and the first natural frequency "
            "(below, undamped). Filled: the ring of this line; ring: the stiffest that halves the load.",
            line_painters.ring_sweep(answer, design.loss_limit),
            False,
        )
    if answer.campbell:
        yield (
            "campbell",
            "Excitations (rays, with their order) over the speed; damped modes with a damping ratio below 25 % "
            "(bars) and peaks of the response near an excitation (rings), with films at their own frequency; "
            "dotted: undamped on films at rest. The dynamic load below. Grey: within 20 % of a resonance.",
            line_painters.campbell(answer, design.loss_limit, design.thrust.speed),
            True,
        )
    if answer.campbell and state.losses.mean_bound > 0.0:
        yield (
            "axial-amplitude",
            "Axial vibration over the speed for any phases: largest along the shaft (full) and of the collar "
            "(broken). Filled: the speed of the case.",
            line_painters.axial_amplitude(answer, design.axial_limit, design.thrust.speed),
            True,
        )
    if answer.nonlinear is not None:
        yield (
            "nonlinear",
            "Load of the pad with the largest dynamic load over a revolution: nonlinear films (full) and "
            "films linear about the static ones (broken).",
            line_painters.nonlinear(answer),
            False,
        )
