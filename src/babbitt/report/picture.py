"""A line drawing that a browser styles: shapes with words for what they are, written as SVG.

Lengths are those of what is drawn, x to the right and y up. Colours, lines and letters are those of the page, by
the class of each shape, so that one drawing serves light and dark pages and paper.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from xml.etree import ElementTree

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.quantities import QUANTITIES

__all__ = ["Handle", "Picture"]

Array = NDArray[np.float64]

Points = tuple[ArrayLike, ArrayLike]
"""x and y of each."""

HEAD = 0.09
"""Length of the head of an arrow, over half the width of the picture."""


@dataclass(frozen=True)
class Handle:
    """What a hand may turn: the field of the case that holds its angle, and the angle now, rad."""

    field: str
    angle: float


class Picture:
    """Shapes in the order in which they are drawn.

    Parameters
    ----------
    reach : float
        Half the side of the square that is seen, around the origin.
    spoken : str
        What it shows, in a sentence, for those who do not see it.
    """

    def __init__(self, reach: float, spoken: str) -> None:
        self.reach = reach
        self._root = ElementTree.Element(
            "svg",
            {
                "xmlns": "http://www.w3.org/2000/svg",
                "viewBox": " ".join(_number(value) for value in (-reach, -reach, 2.0 * reach, 2.0 * reach)),
                "role": "img",
                "aria-label": spoken,
                "class": "picture",
            },
        )

    def outline(self, points: Points, style: str) -> None:
        """A line through points."""
        self._add("path", style, {"d": _path(points)})

    def area(self, points: Points, style: str, handle: Handle | None = None, hole: Points | None = None) -> None:
        """A closed figure, with a hole in it where one is given."""
        inside = "" if hole is None else _path(hole) + "Z"
        self._add("path", style, {"d": _path(points) + "Z" + inside, "fill-rule": "evenodd"}, handle)

    def circle(self, x: float, y: float, radius: float, style: str) -> None:
        """A circle."""
        self._add("circle", style, {"cx": _number(x), "cy": _number(-y), "r": _number(radius)})

    def arrow(
        self, tail: tuple[float, float], tip: tuple[float, float], style: str, handle: Handle | None = None
    ) -> None:
        """A straight arrow."""
        self._arrow(np.array([tail[0], tip[0]]), np.array([tail[1], tip[1]]), style, handle)

    def turning(self, x: float, y: float, radius: float, about: float, sense: float, style: str) -> None:
        """An arrow around a centre, in the middle of which stands the angle `about`, rad."""
        angles = about + sense * np.linspace(-0.55, 0.55, 25)
        self._arrow(x + radius * np.cos(angles), y + radius * np.sin(angles), style, None)

    def load(self, angle: float, load: float, sense: float, handle: Handle | None = None) -> None:
        """A load in N on a journal of radius 1 in its direction, its size beside it, the rotation ahead of it."""
        c, s = math.cos(angle), math.sin(angle)
        self.arrow((-0.75 * c, -0.75 * s), (-0.08 * c, -0.08 * s), "load", handle)
        self.turning(0.0, 0.0, 0.62, angle, sense, "rotation")
        if math.isfinite(load):
            words = QUANTITIES["load"].suited(load).with_unit(load)
            self.text(-0.45 * c - 0.3 * s, -0.45 * s + 0.3 * c, words)

    def text(self, x: float, y: float, words: str, style: str = "label") -> None:
        """Words, centred about a place."""
        place = {"x": _number(x), "y": _number(-y), "font-size": _number(0.055 * self.reach)}
        self._add("text", style, place | {"text-anchor": "middle", "dominant-baseline": "middle"}).text = words

    def svg(self) -> str:
        """The drawing as a text of SVG."""
        return ElementTree.tostring(self._root, encoding="unicode")

    def _arrow(self, x: Array, y: Array, style: str, handle: Handle | None) -> None:
        along = math.atan2(y[-1] - y[-2], x[-1] - x[-2])
        size = HEAD * self.reach
        sides = [(x[-1] - size * math.cos(along + a), y[-1] - size * math.sin(along + a)) for a in (0.35, -0.35)]
        self._add("path", f"{style} line", {"d": _path((x, y))}, handle)
        if handle is not None:  # wide enough to be held
            self._add("path", "grip", {"d": _path((x, y))}, handle)
        head_x, head_y = zip((x[-1], y[-1]), *sides, strict=True)
        self._add("path", f"{style} head", {"d": _path((head_x, head_y)) + "Z"}, handle)

    def _add(
        self, tag: str, style: str, attributes: dict[str, str], handle: Handle | None = None
    ) -> ElementTree.Element:
        own = {"class": style if handle is None else f"{style} handle", **attributes}
        if handle is not None:
            own |= {"data-field": handle.field, "data-angle": _number(math.degrees(handle.angle))}
        return ElementTree.SubElement(self._root, tag, own)


def _path(points: Points) -> str:
    x, y = (np.asarray(one, dtype=np.float64) for one in points)
    return "M" + "L".join(f"{_number(a)} {_number(-b)}" for a, b in zip(x, y, strict=True))


def _number(value: float) -> str:
    return f"{value:.5g}"
