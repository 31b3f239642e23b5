"""A shaft to scale from the side and from above, with what acts on it, as a drawing for the screen."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from babbitt.core.language import translated, translated_if_known
from babbitt.core.solution import Solution
from babbitt.kinds.shaft.answer import ShaftAnswer
from babbitt.kinds.shaft.gears import Gear
from babbitt.kinds.shaft.model import Array, PointLoad, Shaft
from babbitt.kinds.shaft.overhung_coupling import CouplingProblem
from babbitt.kinds.shaft.problem import ShaftProblem
from babbitt.kinds.shaft.report.side_view import GEAR_WIDTH, diameter_at, own_weight
from babbitt.kinds.shaft.statics import two_reactions
from babbitt.report.picture import LETTER, Canvas, Picture
from babbitt.report.picture_words import enlarged, millimetres, round_below, sized

__all__ = ["coupling_picture", "shaft_picture"]

REACH, ARROW, BENT = 1.25, 0.5, 0.12
"""Half the width of the picture, the longest arrow, and the largest deflection at most, over half the length of
the shaft, as all lengths here."""

NAMES, WEDGE = 0.12, 0.09
"""Room for sizes beyond the arrows, and for names beyond these, on each side of a view; height of a bearing."""

LEAST = 0.015
"""Share of the largest force below which no arrow is drawn."""

LETTER_WIDTH, MOST_LETTERS = 0.62, 28
"""Of a letter over its height, the widest, Cyrillic ones; letters of a name beyond which it is cut."""


def shaft_picture(solution: Solution) -> Picture:
    """Pieces, gears and bearings of a shaft with its forces; where its bending is known, its line enlarged."""
    problem: ShaftProblem = solution.problem
    answer: ShaftAnswer = solution.state
    places = answer.curves.stations
    view = _Views(problem.shaft, problem.gears, answer.reactions(), float(places[0]), float(places[-1]))
    picture = view.picture(solution.result.name)
    factor = view.bent(places, answer.curves.deflection) if answer.bends else None
    view.notes(picture, factor)
    return picture


def coupling_picture(solution: Solution) -> Picture:
    """A gear shaft with its mesh force, weights and the reactions of both bearings."""
    problem: CouplingProblem = solution.problem
    shaft = problem.shaft.shaft()
    reactions = tuple(
        PointLoad(one.name, one.station, (float(x), float(y), 0.0))
        for one, (x, y) in zip(shaft.supports, two_reactions(shaft), strict=True)
    )
    stations = shaft.stations
    view = _Views(shaft, (), reactions, min(stations), max(stations))
    picture = view.picture(solution.result.name)
    view.notes(picture, None)
    return picture


@dataclass(frozen=True)
class _Force:
    """An arrow of a view: what it stands for, N, and where it is drawn; `along` the shaft for a thrust."""

    style: str
    force: float
    tail: tuple[float, float]
    tip: tuple[float, float]
    along: bool


class _Views:
    """The shaft in the planes z-y, from the side, and z-x, from above, one below the other.

    Parameters
    ----------
    shaft : Shaft
    gears : sequence of Gear
    reactions : sequence of PointLoad
        Of the bearings on the shaft.
    start, end : float
        Stations between which it is drawn, m.
    """

    def __init__(
        self, shaft: Shaft, gears: Sequence[Gear], reactions: Sequence[PointLoad], start: float, end: float
    ) -> None:
        self.shaft, self.gears, self.reactions = shaft, gears, reactions
        self.middle, self.scale = 0.5 * (start + end), 2.0 / (end - start)
        self.acting = (*shaft.loads, *own_weight(shaft))
        forces = [abs(force) for one in (*self.acting, *reactions) for force in one.force]
        self.largest = max(forces, default=0.0) or 1.0
        bodies = [piece.diameter for piece in shaft.pieces] + [gear.diameter for gear in gears]
        self.body = 0.5 * self.scale * max(bodies, default=0.0)
        self.parts: list[Canvas] = []

    def place(self, station: float) -> float:
        """Where a station is drawn."""
        return self.scale * (station - self.middle)

    def picture(self, name: str) -> Picture:
        """Both views, without the bending."""
        loads = ", ".join(
            f"{translated_if_known(one.name)} {sized('support_load', math.hypot(*one.force[:2]))}"
            for one in self.reactions
        )
        spoken = translated(
            "{shaft} from the side and from above; loads of the bearings: {loads}", shaft=name, loads=loads
        )
        side, above = list(self._arrows(1)), list(self._arrows(0))
        (top, bottom), (above_top, above_bottom) = self._reach(side), self._reach(above)
        letter = LETTER * REACH
        over = _levels(((self.place(station), name) for station, name in self._acting_names()), letter)
        held = ((self.place(one.station), _cut(translated_if_known(one.name))) for one in self.shaft.supports)
        under = _levels(held, letter)
        names = [1.3 * letter * (1 + max((level for *_, level in row), default=-1)) for row in (over, under)]
        lowered = bottom + above_top + 2.5 * NAMES + names[1]
        picture = Picture(REACH, spoken, -lowered - above_bottom - 2.0 * NAMES, top + NAMES + names[0])
        for height, arrows, axis in ((0.0, side, "y"), (-lowered, above, "x")):
            part = picture.part(0.0, height, 1.0)
            self.parts.append(part)
            self._bodies(part)
            for one in arrows:
                part.arrow(one.tail, one.tip, one.style)
            self._sizes(part, [one for one in arrows if axis == "x" or one.style == "reaction"])
            part.arrow((-1.19, 0.0), (-1.19, 0.16), "dimension")
            part.arrow((-1.19, 0.0), (-1.05, 0.0), "dimension")
            part.text(-1.19, 0.21, axis)
            part.text(-1.14, -0.08, "z")
        for row, from_axis, step in ((over, top + NAMES, 1.3 * letter), (under, -bottom - NAMES, -1.3 * letter)):
            for x, name, level in row:
                self.parts[0].text(x, from_axis + level * step, name, "note")
        return picture

    def _acting_names(self) -> list[tuple[float, str]]:
        """Of what loads the shaft and is drawn in one of the planes at least, with its arrows from the side.

        Short arrows lie near to each other there: their sizes stand with the names, not beside the arrows.
        """
        least = LEAST * self.largest
        named = []
        for one in self.acting:
            if max(map(abs, one.force)) > least:
                _, y, z = (abs(force) if abs(force) > least else 0.0 for force in one.force)
                sizes = [f"{axis} {sized('support_load', size)}" for axis, size in (("y", y), ("z", z)) if size]
                name = _cut(translated_if_known(one.name))
                named.append((one.station, f"{name}: {', '.join(sizes)}" if sizes else name))
        return sorted(named)

    def bent(self, stations: Array, deflection: Array) -> float | None:
        """The line of the bent shaft in both views, and by how much it is enlarged; None for a straight one."""
        largest = float(np.abs(deflection).max())
        if not largest > 0.0:
            return None
        factor = round_below(BENT / (self.scale * largest))
        x = self.scale * (stations - self.middle)
        for part, axis in zip(self.parts, (1, 0), strict=True):
            part.outline((x, factor * self.scale * deflection[:, axis]), "curve")
        return factor

    def notes(self, picture: Picture, factor: float | None) -> None:
        """Length of the shaft, and by how much its bending is enlarged."""
        lines = [millimetres("L", 2.0 / self.scale)] + ([] if factor is None else [enlarged("deflection", factor)])
        picture.notes(-0.98 * REACH, picture.low + 0.1, [", ".join(lines)])

    def _reach(self, arrows: Sequence[_Force]) -> tuple[float, float]:
        """How far bodies and arrows of a view reach upward and downward."""
        tails = [one.tail[1] for one in arrows]
        return max(self.body, *tails, 0.1), max(self.body, *(-tail for tail in tails), 0.2)

    def _bodies(self, part: Canvas) -> None:
        for start, piece in zip(self.shaft.ends, self.shaft.pieces, strict=False):
            ends = self.place(start), self.place(start + piece.length)
            radius, inner = 0.5 * self.scale * piece.diameter, 0.5 * self.scale * piece.inner_diameter
            part.box((ends[0], -radius), (ends[1], radius), "journal")
            for y in (inner, -inner) if inner > 0.0 else ():
                part.outline((ends, (y, y)), "dashed")
        if not self.shaft.pieces:
            part.outline(((-1.0, 1.0), (0.0, 0.0)), "bore")
        for gear in self.gears:
            x, radius = self.place(gear.station), 0.5 * self.scale * gear.diameter
            part.box((x - 2.0 * GEAR_WIDTH, -radius), (x + 2.0 * GEAR_WIDTH, radius), "bush pad")
        part.outline(((-1.04, 1.08), (0.0, 0.0)), "dashed")
        for one in self.shaft.supports:
            x, surface = self.place(one.station), self._surface(one.station)
            if one.radial:
                part.area(([x, x - 0.05, x + 0.05], [-surface, -surface - WEDGE, -surface - WEDGE]), "pivot")
            if one.axial:
                part.outline(([x, x], [-surface - 0.05, surface + 0.05]), "bore")

    def _surface(self, station: float) -> float:
        return 0.5 * self.scale * diameter_at(self.shaft, station)

    def _arrows(self, axis: int) -> Iterator[_Force]:
        """Forces of one plane, loads up to the axis and reactions up to the surface, and thrusts from the side."""
        for style, group in (("load", self.acting), ("reaction", self.reactions)):
            for one in group:
                x, across = self.place(one.station), ARROW * one.force[axis] / self.largest
                if abs(across) > LEAST * ARROW:
                    tip = 0.0
                    if style == "reaction":
                        surface = self._surface(one.station)
                        tip = -surface - WEDGE if across > 0.0 else surface
                    yield _Force(style, one.force[axis], (x, tip - across), (x, tip), along=False)
                along = ARROW * one.force[2] / self.largest
                if axis == 1 and abs(along) > LEAST * ARROW:
                    yield _Force(style, one.force[2], (x - along, 0.0), (x, 0.0), along=True)

    def _sizes(self, part: Canvas, arrows: Sequence[_Force]) -> None:
        taken: list[tuple[float, float]] = []
        for one in sorted(arrows, key=lambda one: one.along):
            self._size(part, one, taken)

    def _size(self, part: Canvas, one: _Force, taken: list[tuple[float, float]]) -> None:
        """The size of a force at the tail of its arrow, farther out where another stands there."""
        words = sized("support_load", abs(one.force))
        wide, step = LETTER_WIDTH * part.letter * len(words), 1.15 * part.letter
        x, y = one.tail
        out = 1.0 if y >= 0.0 else -1.0
        if one.along:
            x -= math.copysign(0.5 * wide + 0.02, one.force)
        else:
            out = math.copysign(1.0, -one.force)
            y += 0.7 * out * part.letter
        x = min(max(x, -REACH + 0.5 * wide), REACH - 0.5 * wide)
        while any(abs(x - a) < wide and abs(y - b) < step for a, b in taken):
            y += out * step
        taken.append((x, y))
        part.text(x, y, words)


def _cut(name: str) -> str:
    """A name of any length in so many letters as there is room for."""
    return name if len(name) <= MOST_LETTERS else f"{name[: MOST_LETTERS - 1]}…"


def _levels(named: Iterable[tuple[float, str]], letter: float) -> list[tuple[float, str, int]]:
    """Names at their places within the picture, and on which level each stands clear of the others."""
    ends: list[float] = []  # of the last name of each level
    placed = []
    for place, name in sorted(named):
        half = 0.5 * LETTER_WIDTH * letter * len(name)
        x = min(max(place, half - REACH), REACH - half)
        level = next((level for level, end in enumerate(ends) if end < x - half), len(ends))
        ends[level : level + 1] = [x + half + letter]
        placed.append((x, name, level))
    return placed
