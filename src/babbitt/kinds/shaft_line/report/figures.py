"""Figures of a shaft line and its thrust bearing."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.solution import Solution
from babbitt.kinds.shaft_line.answer import LineAnswer
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.report.figures import Painted, drawings, pad_temperature
from babbitt.report.drawing import Drawing, style

__all__ = ["line_figures"]


def line_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Every figure of a solved line.

    Parameters
    ----------
    solution : Solution
        Of a shaft line; an unsolved one has no figures.
    image_format : {"svg", "pdf", "png"}
    """
    if not solution.result.outcome.solved:
        return ()
    with style():
        return drawings(_of_line(solution.problem, solution.state), image_format)


def _of_line(design: LineDesign, answer: LineAnswer) -> Iterator[Painted]:
    from babbitt.kinds.shaft_line.report import plots as line_painters
    from babbitt.kinds.thrust.report import plots as thrust_painters

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
    yield from pad_temperature(state.share)
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
