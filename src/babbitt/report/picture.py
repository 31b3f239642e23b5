"""A line drawing that a browser styles: shapes with words for what they are, written as SVG.

Lengths are those of what is drawn, x to the right and y up. Colours, lines and letters are those of the page, by
the class of each shape, so that one drawing serves light and dark pages and paper.
"""

from __future__ import annotations

import copy
import itertools
import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.report.picture_words import sized
from babbitt.report.text import plain_text

__all__ = ["LETTER", "Canvas", "Handle", "Picture"]

Array = NDArray[np.float64]

Place = tuple[float, float]

Points = tuple[ArrayLike, ArrayLike]
"""x and y of each."""

HEAD, LETTER = 0.09, 0.055
"""Length of the head of an arrow and height of a letter, over half the width of the picture."""

WIDE = 0.6
"""Width of a letter over its height, at most of those that numbers and units have on the average."""

STROKE, BOLD = 0.008, ("load", "reaction", "flow", "tilt", "curve")
"""Width of a line over half the width of the picture, and styles of lines twice as wide; a browser has its own."""

PRINTED = 300.0
"""Width of a drawing on paper, in points of SVG."""

STYLE = Path(__file__).parent / "templates" / "picture.css"
"""Of every drawing, its colours by the names that a page gives values."""

PAPER = {
    "ink": "#222", "quiet": "#555", "paper": "#fff", "metal": "#dcdcdc", "steel": "#98a4b0", "oil": "#2f6090",
    "bad": "#a02020", "good": "#207040", "near": "#9a6a10",
}  # fmt: skip
"""Values of the colours on paper, for programs that know no names of colours."""

LETTERS = 'text { font-family: "Libertinus Serif", serif; }'
"""On paper."""

CYCLE = "6s"
"""Time that a motion takes until it begins anew."""

SUBSCRIPT = re.compile(r"(?<=[A-Za-zα-ωΑ-Ω\u0304])_([A-Za-z0-9]+(?:,[A-Za-z0-9]+)?)")
"""What stands below the line, behind the letter of a symbol."""

LARGER = 1.25
"""Letters on paper over those on the screen, which can be enlarged."""

BANDS = (0.02, 0.2, 0.4, 0.6, 0.8)
"""Shares of the highest value at which a shade more begins."""


@dataclass(frozen=True)
class Handle:
    """What a hand may turn: the field of the case that holds its angle, and the angle now, rad."""

    field: str
    angle: float


class Canvas:
    """Shapes in the order in which they are drawn.

    Parameters
    ----------
    root : Element
        Of SVG, into which they go.
    reach : float
        Half the width of the whole picture in the lengths of this canvas: the size of letters and of the heads of
        arrows.
    """

    def __init__(self, root: ElementTree.Element, reach: float) -> None:
        self.reach, self._root = reach, root

    def part(self, x: float, y: float, scale: float) -> Canvas:
        """A canvas with an origin and lengths of its own, so many of this one to each of its units."""
        moved = f"translate({_number(x)} {_number(-y)}) scale({_number(scale)})"
        return Canvas(ElementTree.SubElement(self._root, "g", {"transform": moved}), self.reach / scale)

    def moving(self, points: Points, times: ArrayLike) -> Canvas:
        """A canvas whose origin goes through points at times from 0 to 1, again and again."""
        x, y = (np.asarray(one, dtype=np.float64) for one in points)
        places = [f"{_number(a)} {_number(-b)}" for a, b in zip(x, y, strict=True)]
        moved = ElementTree.SubElement(self._root, "g", {"transform": f"translate({places[0]})"})
        ElementTree.SubElement(moved, "animateTransform", {
            "attributeName": "transform", "type": "translate", "values": ";".join(places), "dur": CYCLE,
            "keyTimes": ";".join(map(_number, np.asarray(times, dtype=np.float64))), "repeatCount": "indefinite",
        })  # fmt: skip
        return Canvas(moved, self.reach)

    @property
    def moves(self) -> bool:
        """Whether something in it moves."""
        return self._root.find(".//animateTransform") is not None

    @property
    def letter(self) -> float:
        """Height of a letter."""
        return LETTER * self.reach

    def outline(self, points: Points, style: str) -> None:
        """A line through points."""
        self._add("path", style, {"d": _path(points)})

    def area(self, points: Points, style: str, handle: Handle | None = None, hole: Points | None = None) -> None:
        """A closed figure, with a hole in it where one is given."""
        inside = "" if hole is None else _path(hole) + "Z"
        self._add("path", style, {"d": _path(points) + "Z" + inside, "fill-rule": "evenodd"}, handle)

    def box(self, low: Place, high: Place, style: str) -> None:
        """A rectangle between two of its corners."""
        (left, bottom), (right, top) = low, high
        self.area(([left, right, right, left], [bottom, bottom, top, top]), style)

    def circle(self, x: float, y: float, radius: float, style: str) -> None:
        """A circle."""
        self._add("circle", style, {"cx": _number(x), "cy": _number(-y), "r": _number(radius)})

    def bands(self, x: Array, y: Array, values: Array, highest: float) -> None:
        """Shades of a field on a grid, the darker the nearer to the highest value."""
        from contourpy import FillType, contour_generator

        found = contour_generator(x, y, values, fill_type=FillType.OuterOffset)
        for share in BANDS:
            for points, ends in zip(*found.filled(share * highest, 2.0 * highest), strict=True):
                rings = [points[a:b] for a, b in itertools.pairwise(ends)]
                path = "".join(_path((ring[:, 0], ring[:, 1])) + "Z" for ring in rings)
                self._add("path", "shade", {"d": path, "fill-rule": "evenodd"})

    def arrow(self, tail: Place, tip: Place, style: str, handle: Handle | None = None) -> None:
        """A straight arrow."""
        self._arrow(np.array([tail[0], tip[0]]), np.array([tail[1], tip[1]]), style, handle)

    def turning(self, x: float, y: float, radius: float, about: float, sense: float, style: str) -> None:
        """An arrow around a centre, in the middle of which stands the angle `about`, rad."""
        angles = about + sense * np.linspace(-0.55, 0.55, 25)
        self._arrow(x + radius * np.cos(angles), y + radius * np.sin(angles), style, None)

    def load(self, angle: float, load: float, sense: float, handle: Handle | None = None) -> None:
        """A load in N on a journal of radius 1 in its direction, with its size, the rotation ahead of it.

        `sense` is 1 for counter-clockwise, -1 for clockwise, 0 for a journal that does not turn.
        """
        c, s = math.cos(angle), math.sin(angle)
        self.arrow((-0.75 * c, -0.75 * s), (-0.08 * c, -0.08 * s), "load", handle)
        if sense:
            self.turning(0.0, 0.0, 0.62, angle, sense, "rotation")
        if math.isfinite(load):
            self.text(-0.45 * c - 0.3 * s, -0.45 * s + 0.3 * c, sized("load", load))

    def text(self, x: float, y: float, words: str, style: str = "label", anchor: str = "middle") -> None:
        """Words about a place, or from it on (`start`), or up to it (`end`)."""
        place = {"x": _number(x), "y": _number(-y), "font-size": _number(self.letter)}
        aligned = {
            "text-anchor": anchor,
            "dominant-baseline": "middle",
            "stroke-width": _number(0.25 * self.letter),
        }
        self._write(self._add("text", style, place | aligned), plain_text(words))

    def _write(self, text: ElementTree.Element, words: str) -> None:
        """Words whose symbols have subscripts: ψ_eff is written as such, with smaller letters below the line."""
        stem, *others = re.split(SUBSCRIPT, words)
        text.text = stem
        for subscript, after in zip(others[::2], others[1::2], strict=True):
            lower = {"dy": _number(0.3 * self.letter), "font-size": _number(0.75 * self.letter)}
            ElementTree.SubElement(text, "tspan", lower).text = subscript
            ElementTree.SubElement(text, "tspan", {"dy": _number(-0.3 * self.letter)}).text = after

    def notes(self, x: float, y: float, lines: Iterable[str], anchor: str = "start") -> None:
        """Lines of words one below the other, the first at a place."""
        for number, words in enumerate(lines):
            self.text(x, y - 1.5 * number * self.letter, words, "note", anchor)

    def _arrow(self, x: Array, y: Array, style: str, handle: Handle | None) -> None:
        along = math.atan2(y[-1] - y[-2], x[-1] - x[-2])
        size = min(HEAD * self.reach, 0.6 * float(np.hypot(np.diff(x), np.diff(y)).sum()))
        sides = [(x[-1] - size * math.cos(along + a), y[-1] - size * math.sin(along + a)) for a in (0.35, -0.35)]
        self._add("path", f"{style} line", {"d": _path((x, y))}, handle)
        if handle is not None:  # wide enough to be held
            self._add("path", "grip", {"d": _path((x, y))}, handle)
        head_x, head_y = zip((x[-1], y[-1]), *sides, strict=True)
        self._add("path", f"{style} head", {"d": _path((head_x, head_y)) + "Z"}, handle)

    def _add(
        self, tag: str, style: str, attributes: dict[str, str], handle: Handle | None = None
    ) -> ElementTree.Element:
        width = STROKE * self.reach * (2.0 if style.split()[0] in BOLD else 1.0)
        own = {
            "class": style if handle is None else f"{style} handle",
            "stroke-width": _number(width),
            **attributes,
        }
        if handle is not None:
            own |= {"data-field": handle.field, "data-angle": _number(math.degrees(handle.angle))}
        return ElementTree.SubElement(self._root, tag, own)


class Picture(Canvas):
    """A drawing around its origin.

    Parameters
    ----------
    reach : float
        Half of its width.
    spoken : str
        What it shows, in a sentence, for those who do not see it.
    low, high : float, optional
        Between which y it is seen; a square if they are omitted.
    """

    def __init__(self, reach: float, spoken: str, low: float | None = None, high: float | None = None) -> None:
        self.low, self.high = (-reach if low is None else low), (reach if high is None else high)
        self.spoken, height = plain_text(spoken), self.high - self.low
        self.tall = height >= 2.2 * reach
        seen = {
            "xmlns": "http://www.w3.org/2000/svg",
            "viewBox": " ".join(_number(value) for value in (-reach, -self.high, 2.0 * reach, height)),
            "role": "img",
            "aria-label": self.spoken,
            "class": "picture tall" if self.tall else "picture",
        }
        super().__init__(ElementTree.Element("svg", seen), reach)
        ElementTree.SubElement(self._root, "desc").text = self.spoken

    def text_within(self, x: float, y: float, words: str) -> None:
        """Words about a place, moved as far as they need to lie within the drawing."""
        half_width, half_height = 0.5 * WIDE * self.letter * len(words), 0.75 * self.letter
        x = min(max(x, half_width - self.reach), self.reach - half_width)
        self.text(x, min(max(y, self.low + half_height), self.high - half_height), words)

    def svg(self, may_turn: Callable[[str], bool] = lambda field: True) -> str:
        """The drawing as a text of SVG, to be styled by the page that shows it.

        Parameters
        ----------
        may_turn : callable
            Whether a hand may turn what has a field; what it may not is drawn without a handle.
        """
        root = copy.deepcopy(self._root)
        for shape in root.iter():
            field = shape.get("data-field")
            if field is not None and not may_turn(field):
                del shape.attrib["data-field"], shape.attrib["data-angle"]
                shape.set("class", shape.attrib["class"].removesuffix(" handle"))
        return ElementTree.tostring(root, encoding="unicode")

    def printed(self) -> str:
        """The drawing as a text of SVG in the style of paper."""
        style = ElementTree.Element("style")
        named = STYLE.read_text(encoding="utf-8")
        style.text = re.sub(r"var\(--(\w+)\)", lambda name: PAPER[name[1]], named) + LETTERS
        size = {"width": f"{PRINTED:g}", "height": f"{PRINTED * 0.5 * (self.high - self.low) / self.reach:.5g}"}
        page = ElementTree.Element("svg", self._root.attrib | size)
        page.extend((style, *copy.deepcopy(list(self._root))))
        for letters in (one for one in page.iter() if "font-size" in one.attrib):
            letters.set("font-size", _number(LARGER * float(letters.attrib["font-size"])))
        for moved in page.iter("g"):
            for motion in moved.findall("animateTransform"):
                moved.remove(motion)
        return ElementTree.tostring(page, encoding="unicode")


def _path(points: Points) -> str:
    x, y = (np.asarray(one, dtype=np.float64) for one in points)
    return "M" + "L".join(f"{_number(a)} {_number(-b)}" for a, b in zip(x, y, strict=True))


def _number(value: float) -> str:
    return f"{value:.5g}"
