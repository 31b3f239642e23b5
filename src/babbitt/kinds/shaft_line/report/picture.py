"""A shaft line on its thrust bearing as a drawing for the screen: the line, how it swings, the pads."""

from __future__ import annotations

import math

import numpy as np

from babbitt.core.language import decimal, translated
from babbitt.core.quantities import QUANTITIES
from babbitt.core.solution import Solution
from babbitt.core.units import written
from babbitt.kinds.shaft_line.answer import LineAnswer
from babbitt.kinds.shaft_line.axial import axial_amplitudes
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.line import Rod, ShaftLine
from babbitt.kinds.thrust.design import PrescribedThrust
from babbitt.kinds.thrust.report import picture as thrust
from babbitt.report.picture import Canvas, Picture
from babbitt.report.picture_words import enlarged, round_below, sized
from babbitt.report.us_words import in_us_units

__all__ = ["line_picture"]

REACH = thrust.REACH
"""Half the width of the picture: the pads below are drawn with their outer radius as 1."""

START, END = -0.93, 0.6
"""Ends of the line from the propeller to the collar."""

THICK, COLLAR, SWING = 0.22, 0.6, 0.26
"""Diameter of the thickest piece and of the collar at most, and the largest amplitude."""

LINE, MODES, NAMES = 0.62, 0.42, 0.12
"""Half the height of the line with its words, and of the swinging under it; height of a line of words."""


def line_picture(solution: Solution) -> Picture:
    """Propeller, shaft, collar and what carries it; below, the axial vibration, and the pads."""
    design: LineDesign = solution.problem
    solved = solution.result.outcome.solved
    below = 2.0 * MODES if solved else 0.0
    spoken = "{line}: shaft line from the propeller to the thrust bearing"
    if solved:
        spoken += ", its axial vibration, and the loads of its pads"
    said = translated(spoken, line=solution.result.name)
    picture = Picture(REACH, said, -LINE - below - 2.0 * thrust.PLAN, LINE)
    _line(picture, design)
    answer: LineAnswer | None = solution.state if solved else None
    if answer is not None:
        _swinging(picture.part(0.0, -LINE - MODES, 1.0), design.line, answer)
    pads = picture.part(0.0, -LINE - below - thrust.PLAN, 1.0)
    thrust.pads_seen_along(pads, design.thrust.bearing, None if answer is None else answer.static.share)
    return picture


def _line(picture: Picture, design: LineDesign) -> None:
    line, bearing = design.line, design.thrust.bearing
    length = sum(rod.length for rod in line.rods)
    along = (END - START) / length if line.rods else 0.0
    widest = max((_diameter(rod) for rod in line.rods), default=0.0)
    pads = 2.0 * bearing.pad.outer_radius
    factor = round_below(min(THICK / (along * widest), COLLAR / (along * pads))) if line.rods else math.nan
    _shaft(picture, line, along, factor)
    collar = 0.5 * COLLAR if not line.rods else 0.5 * factor * along * pads
    _propeller(picture, line)
    picture.box((END, -collar), (END + 0.08, collar), "journal")
    _support(picture, design, collar)
    picture.text(END + 0.04, -collar - NAMES, _mass(line.collar_mass))
    if isinstance(design.thrust.duty, PrescribedThrust):
        picture.arrow((START - 0.3, 0.0), (START - 0.06, 0.0), "load")
        picture.text(-0.98 * REACH, 0.12, sized("load", design.thrust.duty.thrust), anchor="start")
    notes = (
        [in_us_units(decimal(f"L = {written(length, 'm')}")), enlarged("diameters", factor)]
        if line.rods
        else [translated("rigid shaft")]
    )
    picture.notes(-0.98 * REACH, LINE - 0.1, notes)


def _diameter(rod: Rod) -> float:
    """Of a solid rod of the same area, m."""
    return math.sqrt(4.0 * rod.area / math.pi)


def _mass(kilograms: float) -> str:
    said: str = in_us_units(decimal(written(kilograms, "t" if kilograms >= 1e3 else "kg")))
    return said


def _shaft(picture: Picture, line: ShaftLine, along: float, factor: float) -> None:
    """The pieces as solid rods of their area, masses at the joints."""
    if not line.rods:
        picture.box((START, -0.5 * THICK), (END, 0.5 * THICK), "journal")
        return
    x = START
    between = (*(line.joint_masses or (0.0,) * (len(line.rods) - 1)), 0.0)
    for rod, mass in zip(line.rods, between, strict=True):
        radius, end = 0.5 * factor * along * _diameter(rod), x + along * rod.length
        picture.box((x, -radius), (end, radius), "journal")
        if mass > 0.0:
            picture.box((end - 0.03, -1.8 * radius), (end + 0.03, 1.8 * radius), "bush pad")
            picture.text(end, 1.8 * radius + 0.09, _mass(mass))
        x = end


def _propeller(picture: Picture, line: ShaftLine) -> None:
    """Two blades and the mass; nothing at a free end."""
    if not line.propeller_mass > 0.0:
        return
    around = np.linspace(0.0, 2.0 * math.pi, 49)
    for side in (1.0, -1.0):
        picture.area((START + 0.05 * np.cos(around), side * (0.17 + 0.15 * np.sin(around))), "bush pad")
    picture.text(START, -0.32 - NAMES, _mass(line.propeller_mass))


def _support(picture: Picture, design: LineDesign, collar: float) -> None:
    """Pads, ring, housing and seating beyond the collar; what is rigid is drawn without a spring."""
    bearing, seating = design.thrust.bearing, design.line.seating
    inner = collar * bearing.pad.inner_radius / bearing.pad.outer_radius
    x = END + 0.1
    ring, seat = not math.isinf(bearing.ring_stiffness), seating is not None
    for side in (1.0, -1.0):
        picture.box((x, side * inner), (x + 0.05, side * collar), "bush pad")
        if ring:
            _spring(picture, x + 0.05, x + 0.2, side * 0.5 * (inner + collar))
    housing = x + (0.2 if ring else 0.06)
    picture.box((housing, -collar), (housing + 0.07, collar), "bush")
    wall = housing + (0.26 if seat else 0.09)
    if seat:
        _spring(picture, housing + 0.07, wall, 0.0)
    picture.outline(([wall, wall], [-collar - 0.06, collar + 0.06]), "bore")
    words = [
        translated("ring {stiffness} a pad", stiffness=sized("axial_stiffness", bearing.ring_stiffness))
        if ring
        else translated("rigid ring"),
        translated("rigid seating")
        if seating is None
        else translated("seating {stiffness}", stiffness=sized("axial_stiffness", seating.stiffness)),
    ]
    picture.notes(0.98 * REACH, LINE - 0.1, words, "end")


def _spring(picture: Canvas, start: float, end: float, y: float) -> None:
    """A zigzag between two places."""
    x = np.linspace(start, end, 10)
    aside = np.array([0.0, 0.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 0.0, 0.0])
    picture.outline((x, y + 0.045 * aside), "thin")


def _swinging(canvas: Canvas, line: ShaftLine, answer: LineAnswer) -> None:
    """Largest axial amplitude along the shaft for any phases, and the shape of the first mode."""
    length = sum(rod.length for rod in line.rods)

    def along(places: np.ndarray) -> np.ndarray:
        return START + (END - START) * places / length if line.rods else np.array([START, END])

    canvas.outline(([START, END], [0.0, 0.0]), "thin")
    notes = []
    if answer.state.forced.parts:
        found = axial_amplitudes(answer.state)
        if found.largest > 0.0:
            x = along(found.places)
            size = SWING / found.largest * found.each.sum(axis=0) * np.ones(x.size)
            canvas.area((np.append(x, x[::-1]), np.append(size, -size[::-1])), "pressure")
            largest = sized("film_thickness", found.largest)
            notes.append(translated("axial amplitude up to {amplitude}", amplitude=largest))
    if answer.modes:
        first = answer.modes[0]
        x = along(first.places)
        canvas.outline((x, SWING * first.shape * np.ones(x.size)), "dashed")
        frequency = QUANTITIES["natural_frequency_1"].with_unit(first.frequency)
        notes.append(translated("dashed: first mode, {frequency}", frequency=frequency))
    canvas.notes(-0.98 * canvas.reach, MODES - 0.06, [", ".join(notes)])
