"""The angular span of a bearing whose pockets limit the loaded arc unevenly.

The standard knows only arcs centred on the load. A published gearbox study (2023) takes twice the angle from the
downstream edge of the entry-side pocket to the load as a conventional span, and disregards the exit-side pocket
when its edge lies at least 60° behind the load, because the film pressure has ended there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

TABULATED_SPANS = (360, 180, 150, 120, 90)
"""Spans in degrees for which the characteristics exist."""

EXIT_EDGE_DISREGARDED_FROM = math.radians(60.0)
"""Angle behind the load beyond which an exit-side pocket no longer shortens the loaded film."""


class SpanRounding(Enum):
    """How a conventional span is brought to a tabulated one."""

    DOWN = "down"
    NEAREST = "nearest"


@dataclass(frozen=True)
class ConventionalSpan:
    """A tabulated span in degrees, and the exact one in rad that it stands for.

    `too_short` marks an arc shorter than the shortest tabulated one: the tables then flatter the bearing.
    """

    tabulated: int
    exact: float
    exit_side_disregarded: bool
    too_short: bool


def conventional_span(
    entry_edge_angle: float, exit_edge_angle: float, rounding: SpanRounding = SpanRounding.DOWN
) -> ConventionalSpan:
    """Span of the centred arc that stands for an arc between uneven pockets.

    Parameters
    ----------
    entry_edge_angle : float
        From the downstream edge of the entry-side pocket to the load, rad.
    exit_edge_angle : float
        From the load to the upstream edge of the exit-side pocket, rad.
    rounding : SpanRounding
        Rounding down is the safe choice; the published study takes the nearest.

    Returns
    -------
    ConventionalSpan

    Examples
    --------
    >>> conventional_span(math.radians(65), math.radians(94)).tabulated
    120
    """
    disregarded = exit_edge_angle >= EXIT_EDGE_DISREGARDED_FROM
    limiting = entry_edge_angle if disregarded else min(entry_edge_angle, exit_edge_angle)
    exact = 2.0 * limiting
    degrees = math.degrees(exact)
    if rounding is SpanRounding.NEAREST:
        tabulated = min(TABULATED_SPANS, key=lambda span: abs(span - degrees))
    else:
        tabulated = max((span for span in TABULATED_SPANS if span <= degrees + 1e-9), default=TABULATED_SPANS[-1])
    return ConventionalSpan(tabulated, exact, disregarded, degrees < TABULATED_SPANS[-1] - 1e-9)
