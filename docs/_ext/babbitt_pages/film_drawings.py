"""The drawings of the film method; the films in them are solved, so that they show what the engine does."""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import JournalFilm, Land, Pocket, Resolution, grooved_bore
from babbitt.reynolds.solution import FilmSolution
from babbitt_pages.svg import ACCENT, INK, PALE, SHADE, Drawing, Point, polar

SHELL, OIL, THIN_OIL, SUPPLY = "#cbd2d9", "#f0b48c", "#fbe9dd", "#4b7bb5"
LOAD_ANGLE = -90.0
GROOVE_EXTENT = 20.0
GAP = 34.0
"""Drawn clearance."""


def film_section() -> str:
    """A bearing with a groove above: frame, attitude angle, full film with its pressure, rupture, forming."""
    drawing = Drawing(
        720, 440, "Section of a journal bearing: groove, ruptured and full film, pressure, attitude angle"
    )
    lands = grooved_bore((0.5 * math.pi,), math.radians(GROOVE_EXTENT))
    film = JournalFilm(0.1, 0.08, 80e-6, 0.02, 300.0, lands)
    solved = solve_journal(film, (0.0, -12e3), Resolution(4, 48))
    centre, radius = (300.0, 222.0), 140.0
    x, y = (GAP / film.clearance * part for part in solved.position)
    journal = (centre[0] + x, centre[1] + y)
    angles = np.degrees(solved.angles[0])
    full = solved.pressure[0, :, 0] > 0.0

    drawing.circle(centre, radius + 24, fill=SHELL, weight=1)
    drawing.circle(centre, radius, fill=THIN_OIL)
    _pressure_curve(drawing, centre, radius, angles, solved.pressure[0, :, 0])
    drawing.circle(centre, radius + 24, ink=PALE, weight=1)
    start, end = angles[full][0], angles[full][-1]
    _gap_piece(drawing, centre, radius, (x, y), start, end, OIL)
    half = 0.5 * GROOVE_EXTENT
    drawing.sector(centre, radius - 1, radius + 16, 90.0 - half, 90.0 + half, fill=SUPPLY)
    for share in (0.3, 0.6, 0.85):
        _streamer(drawing, centre, radius, (x, y), angles[0], start, share)
        _streamer(drawing, centre, radius, (x, y), end, angles[-1], share)
    drawing.circle(journal, radius - GAP, fill=SHADE)

    _frame(drawing)
    gap_angle = math.degrees(math.atan2(y, x))
    drawing.line(
        polar(centre, radius + 30, gap_angle + 180), polar(centre, radius + 30, gap_angle), ink=PALE, dashes="6 4"
    )
    drawing.line(centre, polar(centre, 112, LOAD_ANGLE), ink=ACCENT, weight=3, arrow=True)
    drawing.words((centre[0] - 10, centre[1] - 96), "F", ink=ACCENT, style="italic", size=17, anchor="end")
    drawing.arc(centre, 74, LOAD_ANGLE, gap_angle, ink=ACCENT, arrow=True)
    drawing.words(
        polar(centre, 88, LOAD_ANGLE + 0.5 * (gap_angle - LOAD_ANGLE)), "β", ink=ACCENT, style="italic", size=17
    )
    drawing.circle(centre, 2.5, fill="black")
    drawing.circle(journal, 2.5, fill="black")
    drawing.arc(journal, 80, 60, 120, weight=2, arrow=True)
    drawing.words((journal[0], journal[1] + 56), "ω", style="italic", size=17)

    _label(drawing, polar(centre, radius + 8, 90.0 - half), (480, 418), "groove: nodes held at its pressure")
    _label(drawing, polar(centre, radius - 8, 40.0), (470, 350), "streamers: the gap is partly filled, p = 0")
    _label(drawing, polar(centre, radius - 8, end), (500, 150), "rupture: p and its slope vanish")
    _label(drawing, polar(centre, radius + 34, gap_angle), (480, 60), "line of centres, least gap")
    _label(drawing, polar(centre, radius - 16, start), (92, 300), "film closes", anchor="end")
    _label(drawing, polar(centre, radius + 42, 262.0), (148, 50), "pressure p", anchor="end")
    drawing.words(
        (centre[0], 10), "clearance drawn much too large; pressure in mid-plane as computed", size=12, ink=PALE
    )
    return drawing.text()


def film_nodes() -> str:
    """The unrolled half of a film: lines, nodes between them, a pocket, and which nodes hold pressure."""
    drawing = Drawing(
        760, 330, "Unrolled film: lines, nodes across half the width, a pocket, full and ruptured film"
    )
    land = Land(math.radians(100.0), math.radians(440.0))
    pocket = Pocket(0.0, math.radians(30.0), 0.05, pressure=1e5)
    film = JournalFilm(0.1, 0.1, 80e-6, 0.02, 300.0, (land,), pockets=(pocket,))
    solved = solve_journal(film, (0.0, -8e3), Resolution(4, 12, 12))
    corner, width, height = (60.0, 80.0), 660.0, 200.0
    angles, places = np.degrees(solved.angles[0]), solved.axial_positions

    def at(angle: float, place: float) -> Point:
        return corner[0] + (angle - angles[0]) / 360.0 * width, corner[1] + place / places[-1] * height

    def rectangle(first: float, last: float, top: float, fill: str) -> None:
        drawing.area([at(first, 0.0), at(last, 0.0), at(last, top), at(first, top)], fill=fill, ink=PALE)

    rectangle(angles[0], angles[-1], places[-1], THIN_OIL)
    rectangle(440.0, angles[-1], places[-1], "#c9d8ea")
    rectangle(345.0, 375.0, 0.5 * pocket.axial_length, "#c9d8ea")
    for angle in angles:
        drawing.line(at(angle, 0.0), at(angle, places[-1]), ink=PALE, weight=0.8)
    for brk in solved.axial_breaks:
        drawing.line(at(angles[0], places[brk]), at(angles[-1], places[brk]), ink=PALE, weight=0.8, dashes="5 4")
    for i, angle in enumerate(angles):
        for j, place in enumerate(places):
            fill, ink, size = _node_style(solved, pocket, i, j)
            drawing.circle(at(angle, place), size, fill=fill, ink=ink, weight=1.1)

    drawing.words(
        at(angles[0], -0.0085), "mid-plane, of which both sides are alike", size=12, anchor="start", ink=PALE
    )
    drawing.words(
        (corner[0], corner[1] + height + 10), "side: held at its pressure", size=12, anchor="start", ink=PALE
    )
    drawing.words(at(360.0, -0.0045), "pocket", size=12, ink=SUPPLY)
    drawing.words(at(450.0, -0.0045), "groove", size=12, ink=SUPPLY)
    drawing.words(at(230.0, -0.0045), "full film", size=12, ink=ACCENT)
    drawing.words(at(128.0, -0.0045), "ruptured film", size=12)
    drawing.words(at(418.0, -0.0045), "ruptured", size=12)
    drawing.line((230, 306), (330, 306), weight=1.8, arrow=True)
    drawing.words((340, 302), "motion of the journal", size=12, anchor="start")
    legend = (
        (ACCENT, ACCENT, "unknown: pressure"),
        ("white", INK, "unknown: void"),
        (SUPPLY, SUPPLY, "held by a supply"),
        ("white", PALE, "held by the side"),
    )
    for number, (fill, ink, words) in enumerate(legend):
        place = (78.0 + 170.0 * number, 20.0)
        drawing.circle(place, 4.0, fill=fill, ink=ink)
        drawing.words((place[0] + 12, place[1] - 4), words, size=12, anchor="start")
    return drawing.text()


def film_blocks() -> str:
    """Blocks of the matrix: of a land whose lines are full, partly full and empty, and of a closed ring."""
    drawing = Drawing(
        760, 380, "Blocks of the elimination: modal, dense and void lines of a land; closed ring with its border"
    )
    cell, count = 30.0, 9
    kinds = ("modal",) * 4 + ("dense",) * 3 + ("void",) * 2
    left, top = 60.0, 320.0
    for i, kind in enumerate(kinds):
        _block(drawing, left, top, cell, i, i, "diagonal" if kind == "modal" else kind)
        if i + 1 < count:
            _block(drawing, left, top, cell, i + 1, i, "coupling")
            if kinds[i + 1] != "void":
                _block(drawing, left, top, cell, i, i + 1, "coupling")
    drawing.box((left - 6, top - cell * count - 6), cell * count + 12, cell * count + 12, fill="none")
    right = 440.0
    for i in range(count):
        _block(drawing, right, top, cell, i, i, "border" if i == 0 else "dense")
        for j in ((i + 1) % count, (i - 1) % count):
            _block(drawing, right, top, cell, i, j, "bordered" if 0 in (i, j) else "coupling")
    drawing.box((right - 6, top - cell * count - 6), cell * count + 12, cell * count + 12, fill="none")

    drawing.words((left, 350), "land between grooves", size=14, anchor="start", style="bold")
    drawing.words((right, 350), "closed ring", size=14, anchor="start", style="bold")
    drawing.words((left + cell * count, top - cell + 10), "full lines: modes, O(m)", size=12, anchor="end")
    drawing.words((left, top - cell * 6 + 10), "from the first", size=12, anchor="start")
    drawing.words((left, top - cell * 7 + 20), "dry node: dense, O(m³)", size=12, anchor="start")
    drawing.words((left, top - cell * 9 + 8), "empty lines: transport only", size=12, anchor="start")
    drawing.words(
        (right, 26), "line 0 is the border: all others answer to it", size=12, anchor="start", ink=ACCENT
    )
    drawing.words(
        (left, 26), "each line couples to its neighbours node by node", size=12, anchor="start", ink=PALE
    )
    return drawing.text()


def _block(drawing: Drawing, left: float, top: float, cell: float, row: int, column: int, kind: str) -> None:
    """One block of a matrix; a diagonal one is a stroke, a dense one is filled."""
    x, y = left + cell * column, top - cell * (row + 1)
    inset = 3.0
    if kind in ("dense", "border"):
        drawing.box(
            (x + inset, y + inset), cell - 2 * inset, cell - 2 * inset, fill=OIL if kind == "dense" else "#e58a55"
        )
        return
    ink = {"diagonal": INK, "void": INK, "coupling": PALE, "bordered": ACCENT}[kind]
    weight = 3.0 if kind == "diagonal" else 1.8
    drawing.line(
        (x + inset, y + cell - inset), (x + cell - inset, y + inset), ink=ink, weight=weight,
        dashes="3 3" if kind == "void" else "",
    )  # fmt: skip


def _node_style(solved: FilmSolution, pocket: Pocket, line: int, node: int) -> tuple[str, str, float]:
    """Fill, ink and size of the mark of a node."""
    angle, place = math.degrees(solved.angles[0, line]), solved.axial_positions[node]
    if node == solved.axial_positions.size - 1:
        return "white", PALE, 2.5
    in_pocket = abs(angle - 360.0) < 15.01 and place < 0.5 * pocket.axial_length + 1e-9
    if in_pocket or angle < 100.01 or angle > 439.99:
        return SUPPLY, SUPPLY, 3.0
    return (ACCENT, ACCENT, 3.4) if solved.pressure[0, line, node] > 0.0 else ("white", INK, 3.0)


def _gap_place(centre: Point, radius: float, offset: Point, angle: float, share: float) -> Point:
    """Point between bore (0) and journal (1) in a direction."""
    turned = math.radians(angle)
    along = offset[0] * math.cos(turned) + offset[1] * math.sin(turned)
    aside = offset[0] * math.sin(turned) - offset[1] * math.cos(turned)
    inner = along + math.sqrt((radius - GAP) ** 2 - aside**2)
    return polar(centre, radius + share * (inner - radius), angle)


def _gap_piece(
    drawing: Drawing, centre: Point, radius: float, offset: Point, start: float, end: float, fill: str
) -> None:
    """The gap between two angles, filled."""
    angles = np.linspace(start, end, 90)
    outline = [polar(centre, radius, angle) for angle in angles]
    outline += [_gap_place(centre, radius, offset, angle, 1.0) for angle in angles[::-1]]
    drawing.area(outline, fill=fill, ink=fill)
    for angle in (start, end):
        drawing.line(
            polar(centre, radius, angle), _gap_place(centre, radius, offset, angle, 1.0), ink=ACCENT, weight=2
        )


def _streamer(
    drawing: Drawing, centre: Point, radius: float, offset: Point, start: float, end: float, share: float
) -> None:
    """A streamer of the ruptured film."""
    points = [_gap_place(centre, radius, offset, angle, share) for angle in np.linspace(start, end, 40)]
    drawing.line(*points, ink="#d48a5c", weight=1.0, dashes="7 5")


def _pressure_curve(
    drawing: Drawing, centre: Point, radius: float, angles: np.ndarray, pressure: np.ndarray
) -> None:
    """Pressure drawn outward from the bore."""
    reach = 60.0 / float(pressure.max())
    full = np.flatnonzero(pressure > 0.0)
    part = slice(max(full[0] - 1, 0), full[-1] + 2)
    outline = [
        polar(centre, radius + reach * p, angle) for p, angle in zip(pressure[part], angles[part], strict=True)
    ]
    back = [polar(centre, radius, angle) for angle in angles[part][::-1]]
    drawing.area(outline + back, fill="#f6d3bb", ink=ACCENT)


def _frame(drawing: Drawing) -> None:
    """The fixed frame."""
    drawing.line((30, 350), (85, 350), arrow=True)
    drawing.line((30, 350), (30, 405), arrow=True)
    drawing.words((94, 346), "x", anchor="start", style="italic")
    drawing.words((40, 402), "y", anchor="start", style="italic")
    drawing.arc((30, 350), 36, 0, 50, ink=PALE, arrow=True)
    drawing.words((68, 376), "θ", anchor="start", style="italic", ink=PALE)


def _label(drawing: Drawing, place: Point, words_at: Point, words: str, anchor: str = "start") -> None:
    """Words with a thin line to what they name."""
    away = 4.0 if anchor == "start" else -4.0
    drawing.line(place, (words_at[0] - away, words_at[1] + 4.0), ink=INK, weight=0.8)
    drawing.words(words_at, words, size=12, anchor=anchor)
