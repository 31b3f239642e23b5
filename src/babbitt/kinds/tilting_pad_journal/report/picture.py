"""Journal among its pads, seen along the shaft, as a drawing for the screen."""

from __future__ import annotations

import math

import numpy as np

from babbitt.core.language import translated
from babbitt.core.quantities import QUANTITIES
from babbitt.core.solution import Solution
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.report.seen_along import FILM, PIVOT, PRESSURE, bore_of
from babbitt.report.names import shown_name
from babbitt.report.picture import Handle, Picture
from babbitt.report.picture_words import enlarged, named
from babbitt.reynolds.tilting_pads.solution import PadStatus, TiltingPadSolution

__all__ = ["pad_picture"]


def pad_picture(solution: Solution) -> Picture | None:
    """Pads and pivots to scale, films enlarged, the pressure of each pad, and the load."""
    if not solution.result.outcome.solved:
        return None
    case: PadCase = solution.problem
    films: TiltingPadSolution = solution.state.films.solution
    enlarged_by = FILM / case.bearing.pad_clearance
    deepest = max(pad.thickness for pad in case.bearing.pads) / films.bearing.radius
    inner = 1.0 + FILM + deepest + PIVOT
    said = translated(
        "{bearing}: journal among {number} pads", bearing=shown_name(solution.result.name), number=len(films.pads)
    )
    picture = Picture(inner + PRESSURE + 0.15, said)
    sizes = named(solution.result.values, "diameter", "width", "assembled_clearance")
    picture.notes(-0.98 * picture.reach, 0.94 * picture.reach, sizes)
    factor = enlarged("film", enlarged_by * films.bearing.radius)
    picture.notes(0.98 * picture.reach, 0.94 * picture.reach, (factor,), "end")
    picture.circle(0.0, 0.0, inner, "bore")
    for number in range(len(films.pads)):
        _pad(picture, films, number, enlarged_by, inner)
    x, y = (float(one) for one in enlarged_by * films.position)
    picture.circle(x, y, 1.0, "journal")
    picture.circle(0.0, 0.0, 0.018, "centre bearing")
    picture.circle(x, y, 0.022, "centre")
    angle = math.atan2(-float(films.force[1]), -float(films.force[0]))
    picture.load(angle, films.load, case.sense, Handle("load_angle", angle))
    return picture


def _pad(picture: Picture, films: TiltingPadSolution, number: int, enlarged_by: float, inner: float) -> None:
    pad, state = films.bearing.pads[number], films.pads[number]
    angles = np.linspace(*films.bearing.edges(pad), 49)
    bore = bore_of(films, number, angles, enlarged_by)
    back = bore + pad.thickness / films.bearing.radius
    c, s = np.cos(angles), np.sin(angles)
    outline = np.concatenate((bore * c, (back * c)[::-1])), np.concatenate((bore * s, (back * s)[::-1]))
    picture.area(outline, "bush" if state.status is not PadStatus.UNLOADED else "bore")
    wide, tip = 0.5 * PIVOT / inner, float(np.interp(pad.pivot_angle, angles, back))
    ends = ((inner, pad.pivot_angle - wide), (tip, pad.pivot_angle), (inner, pad.pivot_angle + wide))
    picture.area(([r * math.cos(a) for r, a in ends], [r * math.sin(a) for r, a in ends]), "pivot")
    middle = 0.5 * float(angles[0] + angles[-1])
    at = 0.5 * float(np.interp(middle, angles, bore + back))
    picture.text(at * math.cos(middle), at * math.sin(middle), f"{number + 1}")
    _pressure(picture, films, number, inner)


def _pressure(picture: Picture, films: TiltingPadSolution, number: int, inner: float) -> None:
    """Mid-plane pressure outward from the housing, and the load of the pad."""
    state, highest = films.pads[number], films.maximum_pressure
    if not (highest > 0.0 and state.load > 0.0):
        return
    order = np.argsort(state.angles)
    angles, pressure = state.angles[order], np.maximum(state.pressure[order, 0], 0.0)
    c, s = np.cos(angles), np.sin(angles)
    outer = inner + PRESSURE * pressure / highest
    around = np.concatenate((outer * c, (inner * c)[::-1])), np.concatenate((outer * s, (inner * s)[::-1]))
    picture.area(around, "pressure")
    top = int(pressure.argmax())
    out = float(outer[top]) + 0.11
    quantity = QUANTITIES["load"].suited(state.load)
    picture.text_within(out * float(c[top]), out * float(s[top]), quantity.with_unit(state.load))
