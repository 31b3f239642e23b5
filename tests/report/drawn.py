"""A picture read back: its shapes in the lengths of the whole picture, y up."""

import re
from dataclasses import dataclass
from functools import lru_cache
from xml.etree import ElementTree

import numpy as np

from babbitt.app.answer import as_quick, read
from babbitt.app.document import CaseDocument
from babbitt.core.kind import kinds
from babbitt.report.view import view_of
from babbitt.solving import solve

SPACE = "{http://www.w3.org/2000/svg}"
PLACED = re.compile(r"translate\((\S+) (\S+)\) scale\((\S+)\)")


@dataclass(frozen=True)
class Shape:
    tag: str
    style: str
    points: np.ndarray
    """Of a path, of the centre of a circle, of the place of words."""
    size: float
    """Radius of a circle, height of letters."""
    words: str
    given: dict

    @property
    def length(self):
        return float(np.hypot(*(self.points[-1] - self.points[0])))


class Drawn:
    def __init__(self, svg):
        self.root = ElementTree.fromstring(svg)
        x, y, width, height = map(float, self.root.get("viewBox").split())
        self.low, self.high = np.array([x, -y - height]), np.array([x + width, -y])
        self.shapes = list(_shapes(self.root, np.zeros(2), 1.0))

    @property
    def said(self):
        return self.root.get("aria-label")

    def of(self, style, tag="path"):
        return [one for one in self.shapes if one.style == style and one.tag == tag]

    def words(self):
        return [one.words for one in self.shapes if one.tag == "text"]

    def factor(self, what):
        """Of enlargement, as the words have it."""
        return float(
            next(filter(None, (re.search(rf"{what} enlarged (\S+) times", one) for one in self.words())))[1]
        )


def _shapes(element, moved, scale):
    for one in element:
        tag = one.tag.removeprefix(SPACE)
        if tag == "g":
            x, y, own = map(float, PLACED.fullmatch(one.get("transform")).groups())
            yield from _shapes(one, moved + scale * np.array([x, -y]), scale * own)
        elif tag != "desc":
            points, size = _place(one, tag)
            yield Shape(
                tag, one.get("class"), moved + scale * points, scale * size, one.text or "", dict(one.items())
            )


def _place(one, tag):
    if tag == "path":
        numbers = np.array([float(n) for n in re.findall(r"[-\d.e+]+", one.get("d"))])
        return numbers.reshape(-1, 2) * (1.0, -1.0), 0.0
    names = ("cx", "cy", "r") if tag == "circle" else ("x", "y", "font-size")
    x, y, size = (float(one.get(name)) for name in names)
    return np.array([[x, -y]]), size


def changed(kind, **changes):
    """The template of a kind with other fields, a dot between a part and its field."""
    document = CaseDocument(kinds()[kind].read_template())
    for path, value in changes.items():
        document.change(tuple(path.split("__")), value)
    return document.text


@lru_cache(maxsize=64)
def drawn(text):
    """Solutions of a case on a draft grid, each with its picture, or None."""
    found = []
    for solution in solve(as_quick(read(text))).solutions:
        picture = view_of(solution.result).picture(solution)
        found.append((solution, None if picture is None else Drawn(picture.svg())))
    return found
