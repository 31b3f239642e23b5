"""A thrust bearing as a drawing for the screen: its pads seen along the shaft, and the film of one of them."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from babbitt.core.language import translated
from babbitt.core.solution import Solution
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.design import ThrustDesign
from babbitt.kinds.thrust.face import PlaneFace
from babbitt.kinds.thrust.gap import gap_along
from babbitt.kinds.thrust.pad import Pivot
from babbitt.kinds.thrust.peak import between_nodes
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import PadState
from babbitt.report.drawing import Array
from babbitt.report.picture import Canvas, Handle, Picture
from babbitt.report.picture_words import enlarged, millimetres, round_below, sized

__all__ = ["REACH", "pads_seen_along", "section_of_pad", "thrust_picture"]

REACH, PLAN, ABOVE, BELOW = 1.42, 1.3, 0.62, 0.82
"""Half the width of the picture, half the height of the pads seen along, and what a section takes above and below
the collar, over the outer radius of the pads."""

LENGTH, FILM, BODY, COLLAR, HIGHEST = 1.9, 0.36, 0.26, 0.12, 0.34
"""Of a section, over the outer radius: length of the pad, its thickest film at most, thickness of pad and collar,
the highest pressure."""

COARSE = 3
"""Of so many points of the film every one is drawn."""


def thrust_picture(solution: Solution) -> Picture:
    """Pads, pivots, loads and pressures to scale; below, the film of the pad that carries most, unrolled."""
    design: ThrustDesign = solution.problem
    bearing, name = design.bearing, solution.result.name
    if not solution.result.outcome.solved:
        seen = translated("{bearing}: {number} pads seen along the shaft", bearing=name, number=bearing.number)
        picture = Picture(REACH, seen, -PLAN, PLAN)
        pads_seen_along(picture, bearing, None)
        return picture
    share: Share = solution.state.share
    most = int(share.loads.argmax())
    lowest, highest = (sized("load", float(one)) for one in (share.loads.min(), share.loads.max()))
    spoken = translated(
        "{bearing}: {number} pads seen along the shaft, loads from {lowest} to {highest}; below, the film of pad "
        "{pad}, unrolled",
        bearing=name, number=bearing.number, lowest=lowest, highest=highest, pad=most + 1,
    )  # fmt: skip
    picture = Picture(REACH, spoken, -PLAN - ABOVE - BELOW, PLAN)
    pads_seen_along(picture, bearing, share)
    section_of_pad(picture.part(0.0, -PLAN - ABOVE, 1.0), share, most)
    return picture


def pads_seen_along(canvas: Canvas, bearing: ThrustBearing, share: Share | None) -> None:
    """Pads and pivots with the outer radius as unit; with a share of the load, their loads and pressures."""
    pad = bearing.pad
    inner, sense = pad.inner_radius / pad.outer_radius, bearing.sense
    highest = 0.0 if share is None else max(state.maximum_pressure for state in share.states)
    for number, at in enumerate(bearing.angles):
        edges = at + sense * (np.linspace(0.0, pad.extent, 25) - pad.pivot_angle)
        c, s = np.cos(edges), np.sin(edges)
        canvas.area((np.append(c, inner * c[::-1]), np.append(s, inner * s[::-1])), "bush pad")
        if share is not None and highest > 0.0:
            _pressure(canvas, share.states[number], at, sense, highest)
        _pivot(canvas, bearing, float(at))
        middle = float(edges[12])
        canvas.text((inner - 0.09) * math.cos(middle), (inner - 0.09) * math.sin(middle), f"{number + 1}")
        if share is not None:
            out = 1.1 + 0.1 * abs(math.cos(middle))
            canvas.text(out * math.cos(middle), out * math.sin(middle), sized("load", float(share.loads[number])))
    canvas.turning(0.0, 0.0, 0.5 * inner, 0.5 * math.pi, sense, "rotation")
    if bearing.tilt.offset > 0.0:
        _closest(canvas, bearing, inner)
    sizes = millimetres("D", 2.0 * pad.outer_radius), millimetres("d", 2.0 * pad.inner_radius)
    canvas.notes(-0.98 * canvas.reach, PLAN - 0.08, sizes)


def _pressure(canvas: Canvas, state: PadState, at: float, sense: float, highest: float) -> None:
    pad = state.pad
    radius, pressure = between_nodes(state.film.radius, state.pressure())
    angle = at + sense * (state.film.theta[: pressure.shape[0]] - pad.pivot_angle)
    angle, radius, pressure = angle[::COARSE], radius[::COARSE] / pad.outer_radius, pressure[::COARSE, ::COARSE]
    canvas.bands(np.outer(np.cos(angle), radius), np.outer(np.sin(angle), radius), pressure, highest)


def _pivot(canvas: Canvas, bearing: ThrustBearing, at: float) -> None:
    """A dot where a pad tilts about a point, a line where about a radius; nothing where it is fixed."""
    pad = bearing.pad
    c, s = math.cos(at), math.sin(at)
    if pad.pivot is Pivot.POINT:
        radius = pad.pivot_radius / pad.outer_radius
        canvas.circle(radius * c, radius * s, 0.022, "pivot")
    elif pad.pivot is Pivot.LINE:
        ends = np.array([pad.inner_radius / pad.outer_radius, 1.0])
        canvas.outline((ends * c, ends * s), "pivot line")


def _closest(canvas: Canvas, bearing: ThrustBearing, inner: float) -> None:
    """Where the tilted housing comes closest to the collar."""
    at = bearing.tilt.direction
    c, s = math.cos(at), math.sin(at)
    canvas.arrow(
        (0.1 * c, 0.1 * s), ((inner - 0.18) * c, (inner - 0.18) * s), "tilt", Handle("tilt.direction", at)
    )
    canvas.text(-0.12 * c, -0.12 * s - 0.09, translated("closest"))


def section_of_pad(canvas: Canvas, share: Share, number: int) -> None:
    """The film along the radius of the pivot, seen from outside: the collar slides above, the gap is enlarged.

    Lengths are over the outer radius, the collar at y = 0 and the middle of the pad at x = 0.
    """
    state, sense = share.states[number], share.bearing.sense
    pad = state.pad
    angle = np.linspace(0.0, pad.extent, 97)
    gap = gap_along(pad, state.motion, pad.pivot_radius, angle)
    plane = gap_along(replace(pad, face=PlaneFace(), crown=0.0), state.motion, pad.pivot_radius, angle[[0, -1]])
    across = LENGTH / (pad.extent * pad.pivot_radius)
    factor = round_below(FILM / (across * float(gap.max())))
    x, face = sense * LENGTH * (angle / pad.extent - 0.5), -factor * across * gap
    back = -factor * across * plane - BODY
    half = 0.5 * LENGTH + 0.14
    canvas.area((np.append(x, x[[-1, 0]]), np.append(face, [0.0, 0.0])), "film")
    _profile(canvas, state, x)
    canvas.box((-half, 0.0), (half, COLLAR), "journal")
    canvas.arrow((-0.2 * sense, 0.5 * COLLAR), (0.2 * sense, 0.5 * COLLAR), "rotation")
    canvas.area((np.append(x, x[[-1, 0]]), np.append(face, back[::-1])), "bush pad")
    if pad.pivot is not Pivot.FIXED:
        tip = back[0] + pad.pivot_fraction * (back[1] - back[0])
        _support(canvas, sense * LENGTH * (pad.pivot_fraction - 0.5), float(tip))
    for place in (0, -1):
        side = math.copysign(1.0, x[place])
        words = sized("film_thickness", float(gap[place]))
        canvas.text(x[place] - 0.03 * side, face[place] - 0.1, words, anchor="end" if side > 0.0 else "start")
    canvas.notes(-0.98 * canvas.reach, HIGHEST + 0.17, (translated(f"pad {number + 1}"), enlarged("film", factor)))


def _profile(canvas: Canvas, state: PadState, x: Array) -> None:
    """Pressure along the radius of the pivot, above the collar."""
    pad = state.pad
    radius, pressure = between_nodes(state.film.radius, state.pressure())
    column = int(np.abs(radius - pad.pivot_radius).argmin())
    theta = state.film.theta[: pressure.shape[0]]
    along = np.interp(np.linspace(0.0, pad.extent, x.size), theta, np.maximum(pressure[:, column], 0.0))
    top = float(along.max())
    if not top > 0.0:
        return
    height = COLLAR + HIGHEST * along / top
    canvas.area((np.append(x, x[::-1]), np.append(height, np.full(x.size, COLLAR))), "pressure")
    place = int(along.argmax())
    canvas.text(float(x[place]), COLLAR + HIGHEST + 0.08, sized("film_pressure", top))


def _support(canvas: Canvas, x: float, tip: float) -> None:
    """A wedge under the pivot."""
    base = tip - 0.12
    canvas.area(([x, x - 0.07, x + 0.07], [tip, base, base]), "pivot")
    canvas.outline(([x - 0.2, x + 0.2], [base, base]), "bore")
