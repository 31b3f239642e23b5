"""Temperature around the bore of a grooved film of one dimension, with either kind of groove and without."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentCase, SegmentFilm
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState
from babbitt.report.drawing import GREY, INK, Sheet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from babbitt.core.result import Result

__all__ = ["common", "drawn"]

BAND = "0.88"
"""Of the groove."""

LINES = {GrooveKind.THROUGH: (INK, "-"), GrooveKind.BLIND: (INK, (0, (6, 1.5))), None: (GREY, "-")}
NAMES = {GrooveKind.THROUGH: "through groove", GrooveKind.BLIND: "blind groove", None: "no groove"}


def common(case: SegmentCase) -> str:
    """What the films drawn have in common, in words."""
    return "under the same load" if isinstance(case.duty, PrescribedLoad) else "at the same eccentricity"


def drawn(case: SegmentCase, result: Result) -> Figure:
    """Temperature over the angle from the load line, of all films that carry the load of the case.

    Parameters
    ----------
    case : SegmentCase
    result : Result
        Its answer.
    """
    figure, ((panel,),) = Sheet(166.0, 66.0, left=13.0).panels()
    figure.subplots_adjust(top=1.0 - 7.0 / 66.0)
    for kind, state in _states(case):
        places = (np.degrees(state.grid.angles + state.attitude_angle) + 360.0) % 360.0 - 180.0
        film = state.film_temperature - ZERO_CELSIUS
        turn = int(np.flatnonzero(np.diff(places) < 0.0)[0]) + 1  # there the plot ends and begins again
        places, film = (np.insert(one, turn, math.nan) for one in (places, film))
        colour, line = LINES[kind]
        panel.plot(places, film, color=colour, linestyle=line, label=NAMES[kind])
    if case.groove is not None:
        middle = math.degrees(result.groove_angle_from_load)
        half = math.degrees(case.groove.width / case.bearing.diameter)
        panel.axvspan(middle - half, middle + half, color=BAND, zorder=0)
    panel.axvline(0.0, color=GREY, linewidth=0.5)
    panel.set_xlim(-180.0, 180.0)
    panel.set_xticks(range(-180, 181, 30))
    panel.set_xlabel("angle from the load line in °")
    panel.set_ylabel("$T$ in °C")
    panel.legend(frameon=False, fontsize=7, ncols=3, loc="lower left", bbox_to_anchor=(0.0, 1.0), borderpad=0.0)
    return figure


def _states(case: SegmentCase) -> Iterator[tuple[GrooveKind | None, SegmentFilmState]]:
    """The film of each kind of groove, as far as there is one, and that without."""
    if case.groove is not None:
        for kind in GrooveKind:
            pressure = case.groove.pressure if kind is GrooveKind.THROUGH else 0.0
            groove = replace(case.groove, kind=kind, pressure=pressure)
            yield from ((kind, state) for state in _solved(case, replace(case.film, groove=groove)))
    yield from ((None, state) for state in _solved(case, case.film.without_groove()))


def _solved(case: SegmentCase, film: SegmentFilm) -> Iterator[SegmentFilmState]:
    """The film of the duty of the case; nothing where there is none."""
    try:
        if isinstance(case.duty, PrescribedLoad):
            state = film_under_load(film, case.duty.load)
        elif case.duty is not None:
            state = film_at_eccentricity(film, case.duty.eccentricity_ratio)
        else:
            return
    except NoFilmError:
        return
    if state.converged:
        yield state
