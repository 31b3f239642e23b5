"""The line drawings of the documentation."""

from __future__ import annotations

from collections.abc import Callable

from babbitt_pages.film_drawings import film_blocks, film_nodes, film_section
from babbitt_pages.svg import ACCENT, PALE, SHADE, Drawing, polar

SHELL = "#cbd2d9"
LOAD_ANGLE = -90.0
"""Direction of the load in the drawings, degrees: the default of a case."""


def frame() -> str:
    """The fixed frame, the load, the eccentric journal, the attitude angle and the narrowest gap."""
    drawing = Drawing(460, 400, "Frame, load, eccentricity and attitude angle of a journal bearing")
    bearing, radius, clearance, eccentricity, attitude = (235.0, 205.0), 150.0, 34.0, 23.0, 48.0
    gap_angle = LOAD_ANGLE + attitude
    journal = polar(bearing, eccentricity, gap_angle)
    drawing.circle(bearing, radius + 22, fill=SHELL, weight=1)
    drawing.circle(bearing, radius, fill="white")
    drawing.circle(journal, radius - clearance, fill=SHADE)

    # frame
    drawing.line((20, 330), (70, 330), arrow=True)
    drawing.line((20, 330), (20, 380), arrow=True)
    drawing.words((80, 325), "x", anchor="start", style="italic")
    drawing.words((30, 378), "y", anchor="start", style="italic")

    # line of centres, through both centres to the narrowest gap
    drawing.line(
        polar(bearing, radius + 6, gap_angle + 180), polar(bearing, radius + 16, gap_angle), ink=PALE, dashes="6 4"
    )
    drawing.words(polar(bearing, radius + 34, gap_angle), "h_min", anchor="start", style="italic")
    drawing.words(polar(bearing, radius - 16, gap_angle + 172), "φ = 0", size=12, ink=PALE)

    # load and attitude angle, which start at the bearing centre
    drawing.line(bearing, polar(bearing, 128, LOAD_ANGLE), ink=ACCENT, weight=3, arrow=True)
    drawing.words((bearing[0] - 12, bearing[1] - 118), "F", ink=ACCENT, style="italic", size=17, anchor="end")
    drawing.arc(bearing, 78, LOAD_ANGLE, gap_angle, ink=ACCENT, arrow=True)
    drawing.words(polar(bearing, 94, LOAD_ANGLE + attitude / 2), "β", ink=ACCENT, style="italic", size=17)

    drawing.circle(bearing, 3, fill="black")
    drawing.circle(journal, 3, fill="black")
    drawing.words((bearing[0] - 8, bearing[1] - 12), "O_B", anchor="end", style="italic", size=12)
    drawing.words((journal[0] + 9, journal[1] + 3), "O_J", anchor="start", style="italic", size=12)

    # rotation
    drawing.arc(journal, 92, 55, 112, weight=2, arrow=True)
    drawing.words(polar(journal, 72, 85), "ω", style="italic", size=17)
    drawing.words(
        (235, 16), "e: distance of the centres, ε = e/c; clearance drawn much too large", size=12, ink=PALE
    )
    return drawing.text()


def spans() -> str:
    """A centred arc between two pockets, and uneven pockets with the angles that a case asks for."""
    drawing = Drawing(720, 360, "Angular span of the loaded arc and the angles of uneven pockets")
    left, right, radius = (180.0, 190.0), (540.0, 190.0), 110.0

    _shell(drawing, left, radius, (-180.0 + 15.0, -15.0), (15.0, 165.0))
    drawing.circle(left, radius - 8, fill=SHADE)
    drawing.arc(left, radius + 42, -165, -15, ink=ACCENT, arrow=True)
    drawing.words(polar(left, radius + 58, -62), "Ω", ink=ACCENT, style="italic", size=17)
    _load(drawing, left)
    _rotation(drawing, left)
    drawing.words((left[0] + radius + 8, left[1] - 5), "pocket", anchor="start", size=12)
    drawing.words((left[0], 340), "span: 150 deg, load through its centre", size=13)

    entry, exit_, extent = 75.0, 104.0, 20.0
    before, behind = LOAD_ANGLE - entry, LOAD_ANGLE + exit_
    half = extent / 2
    _shell(drawing, right, radius, (before + half, behind - half), (behind + half, before + 360.0 - half))
    drawing.circle(right, radius - 8, fill=SHADE)
    for centre_angle in (before, behind):
        drawing.line(
            polar(right, radius - 8, centre_angle), polar(right, radius + 60, centre_angle), ink=PALE, dashes="5 4"
        )
    drawing.arc(right, radius + 46, before, LOAD_ANGLE, ink=ACCENT, arrow=True)
    drawing.arc(right, radius + 46, LOAD_ANGLE, behind, ink=ACCENT, arrow=True)
    drawing.words((right[0] - 112, 28), "entry_angle", ink=ACCENT, size=13)
    drawing.words((right[0] + 112, 28), "exit_angle", ink=ACCENT, size=13)
    drawing.arc(right, radius + 32, behind - half, behind + half, weight=2.5)
    drawing.words(polar(right, radius + 38, behind + 14), "extent", anchor="start", size=12)
    _load(drawing, right)
    _rotation(drawing, right)
    drawing.words((right[0], 340), "kind: uneven_pockets", size=13)
    return drawing.text()


def flow() -> str:
    """What happens between a case file and a report."""
    drawing = Drawing(760, 190, "How data flow through Babbitt")
    steps = (
        ("case file", "YAML, with units", "what you write"),
        ("Case", "checked, SI", "babbitt.case"),
        ("Problem", "one film, one point", "babbitt.kinds"),
        ("Solution", "result and its film", "babbitt.core.solution"),
        ("report", "table, JSON, PDF, HTML", "babbitt.report"),
    )
    width, step = 128.0, 148.0
    for index, (name, content, home) in enumerate(steps):
        x = 20.0 + index * step
        drawing.box((x, 92), width, 62, fill=SHADE)
        drawing.words((x + width / 2, 128), name, size=13, style="bold")
        drawing.words((x + width / 2, 106), content, size=11)
        drawing.words((x + width / 2, 72), home, size=11, ink=PALE)
        if index:
            drawing.line((x - step + width + 1, 123), (x - 2, 123), weight=2, arrow=True)
    verbs = ("load_case", "calculations", "method.solve", "print, write")
    for index, verb in enumerate(verbs):
        drawing.words((20.0 + index * step + (width + step) / 2, 166), verb, size=11, ink=ACCENT)
    drawing.words(
        (380, 26),
        "solve(case) takes the two middle steps for every bearing, operating point and clearance",
        size=12,
        ink=PALE,
    )
    return drawing.text()


DRAWINGS: dict[str, Callable[[], str]] = {
    "frame": frame,
    "spans": spans,
    "flow": flow,
    "film_section": film_section,
    "film_nodes": film_nodes,
    "film_blocks": film_blocks,
}
"""Name of the file and the function that draws it."""


def _shell(drawing: Drawing, centre: tuple[float, float], radius: float, *lands: tuple[float, float]) -> None:
    for start, end in lands:
        drawing.sector(centre, radius, radius + 22, start, end, fill=SHELL)


def _load(drawing: Drawing, centre: tuple[float, float]) -> None:
    drawing.line(centre, polar(centre, 84, LOAD_ANGLE), ink=ACCENT, weight=3, arrow=True)
    drawing.words((centre[0] + 10, centre[1] - 70), "F", ink=ACCENT, style="italic", size=16, anchor="start")


def _rotation(drawing: Drawing, centre: tuple[float, float]) -> None:
    drawing.arc(centre, 62, 55, 125, weight=2, arrow=True)
    drawing.words(polar(centre, 42, 90), "ω", style="italic", size=16)
