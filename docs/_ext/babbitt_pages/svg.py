"""Just enough SVG for line drawings: pixels, y upward, angles in degrees counter-clockwise from +x."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from html import escape

Point = tuple[float, float]

INK, PALE, SHADE, ACCENT = "#1f2933", "#7b8794", "#e4e7eb", "#b44d12"


def polar(centre: Point, radius: float, angle: float) -> Point:
    """Point at a distance and a direction from a centre."""
    turned = math.radians(angle)
    return centre[0] + radius * math.cos(turned), centre[1] + radius * math.sin(turned)


@dataclass
class Drawing:
    """A drawing of given width and height; every method adds one thing."""

    width: float
    height: float
    title: str
    _parts: list[str] = field(default_factory=list)

    def circle(
        self, centre: Point, radius: float, *, fill: str = "none", ink: str = INK, weight: float = 1.5
    ) -> None:
        """A circle."""
        x, y = self._at(centre)
        self._add(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}" {_stroke(ink, weight)}/>')

    def line(
        self, *points: Point, ink: str = INK, weight: float = 1.5, dashes: str = "", arrow: bool = False
    ) -> None:
        """A line through points, with an arrow at its end if asked for."""
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self._at, points))
        self._add(f'<polyline points="{path}" fill="none" {_stroke(ink, weight, dashes)}/>')
        if arrow:
            self._arrowhead(points[-2], points[-1], ink)

    def arc(
        self,
        centre: Point,
        radius: float,
        start: float,
        end: float,
        *,
        ink: str = INK,
        weight: float = 1.5,
        dashes: str = "",
        arrow: bool = False,
    ) -> None:
        """An arc from one direction to another."""
        steps = max(2, int(abs(end - start) / 3.0))
        points = [polar(centre, radius, start + (end - start) * i / steps) for i in range(steps + 1)]
        self.line(*points, ink=ink, weight=weight, dashes=dashes)
        if arrow:
            self._arrowhead(points[-2], points[-1], ink)

    def sector(self, centre: Point, inner: float, outer: float, start: float, end: float, *, fill: str) -> None:
        """A piece of a ring."""
        steps = max(2, int(abs(end - start) / 3.0))
        angles = [start + (end - start) * i / steps for i in range(steps + 1)]
        ring = [polar(centre, outer, angle) for angle in angles]
        ring += [polar(centre, inner, angle) for angle in reversed(angles)]
        self.area(ring, fill=fill)

    def area(self, outline: list[Point], *, fill: str, ink: str = INK, weight: float = 1.0) -> None:
        """A filled outline."""
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self._at, outline))
        self._add(f'<polygon points="{path}" fill="{fill}" {_stroke(ink, weight)}/>')

    def box(self, corner: Point, width: float, height: float, *, fill: str = "white") -> None:
        """A box with round corners; the corner is the lower left one."""
        x, y = self._at((corner[0], corner[1] + height))
        self._add(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" rx="5" fill="{fill}" '
            f"{_stroke(INK, 1.2)}/>"
        )

    def words(
        self,
        place: Point,
        words: str,
        *,
        size: float = 14,
        anchor: str = "middle",
        ink: str = INK,
        style: str = "",
    ) -> None:
        """A line of text; `anchor` is start, middle or end. In an italic symbol `_` begins the subscript."""
        x, y = self._at(place)
        shape = {"italic": ' font-style="italic"', "bold": ' font-weight="600"'}.get(style, "")
        self._add(
            f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size:g}" text-anchor="{anchor}" fill="{ink}"{shape}>'
            f"{_symbol(words) if style == 'italic' else escape(words)}</text>"
        )

    def text(self) -> str:
        """The SVG document."""
        size = f'width="{self.width:g}" height="{self.height:g}" viewBox="0 0 {self.width:g} {self.height:g}"'
        head = (
            f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img" '
            'font-family="Helvetica, Arial, DejaVu Sans, sans-serif">\n'
            f"<title>{escape(self.title)}</title>\n"
            f'<rect width="{self.width:g}" height="{self.height:g}" rx="6" fill="white"/>\n'
        )
        return head + "\n".join(self._parts) + "\n</svg>\n"

    def _at(self, point: Point) -> Point:
        return point[0], self.height - point[1]

    def _add(self, part: str) -> None:
        self._parts.append(part)

    def _arrowhead(self, before: Point, tip: Point, ink: str) -> None:
        backward = math.degrees(math.atan2(before[1] - tip[1], before[0] - tip[0]))
        wings = [polar(tip, 9.0, backward - 20.0), tip, polar(tip, 9.0, backward + 20.0)]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self._at, wings))
        self._add(f'<polygon points="{path}" fill="{ink}"/>')


def _symbol(words: str) -> str:
    letter, _, subscript = words.partition("_")
    if not subscript:
        return escape(letter)
    return f'{escape(letter)}<tspan dy="3" font-size="72%">{escape(subscript)}</tspan>'


def _stroke(ink: str, weight: float, dashes: str = "") -> str:
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'stroke="{ink}" stroke-width="{weight:g}"{dashed}'
