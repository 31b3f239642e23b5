"""Figures of a thrust bearing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from babbitt.core.solution import Solution
from babbitt.kinds.thrust.design import ThrustState
from babbitt.kinds.thrust.sharing import Share
from babbitt.report.drawing import Drawing, rendered, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Painted", "drawings", "pad_temperature", "thrust_figures"]

Painted = tuple[str, str, "Figure", bool]
"""Name, caption, figure, whether it takes the width of the page."""


def thrust_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Every figure of a solved bearing.

    Parameters
    ----------
    solution : Solution
        Of a thrust bearing; an unsolved one has no figures.
    image_format : {"svg", "pdf", "png"}
    """
    if not solution.result.outcome.solved:
        return ()
    with style():
        return drawings(_of_bearing(solution.state), image_format)


def drawings(painted: Iterable[Painted], image_format: str) -> tuple[Drawing, ...]:
    """Figures in a format."""
    return tuple(
        Drawing(name, caption, rendered(figure, image_format), wide) for name, caption, figure, wide in painted
    )


def _of_bearing(state: ThrustState) -> Iterator[Painted]:
    from babbitt.kinds.thrust.report import plots as thrust_painters

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
    yield from pad_temperature(state.share)


def pad_temperature(share: Share) -> Iterator[Painted]:
    """Temperature of the hottest pad; nothing for films of one temperature."""
    from babbitt.kinds.thrust.report import plots as thrust_painters

    if any(pad.heat is not None for pad in share.states):
        yield (
            "pad-temperature",
            "Temperature of the film in °C along the hottest pad and across the gap; the cross marks the highest.",
            thrust_painters.pad_temperature(share),
            False,
        )
