"""How a case gave gears, couplings and pieces of a shaft, in an engineer's words."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.case.parts.uniform_piece import words_of_material
from babbitt.core.units import written
from babbitt.kinds.shaft.case.bearings import ShaftBearing
from babbitt.kinds.shaft.case.parts import GearInput
from babbitt.kinds.shaft.case.torque import TorquePart

if TYPE_CHECKING:
    from babbitt.kinds.shaft.case.shaft import ShaftCase

__all__ = ["words_of"]

BEARINGS = {
    "radial": "radial bearing",
    "axial": "axial bearing",
    "radial_axial": "radial and axial bearing",
    "journal": "journal bearing",
    "thrust": "thrust bearing",
}
"""Kinds of bearings on a shaft, as a reader calls them."""

Words = tuple[str, str]


def words_of(case: ShaftCase) -> Iterator[Words]:
    """Tell what turns and loads the shaft, one line each."""
    sense = "counter-clockwise" if case.speed > 0.0 else "clockwise"
    yield "Speed", f"{written(abs(case.speed), 'rpm')}, {sense} seen against z"
    for gear in case.gears:
        yield gear.name, f"{_at(gear.station)}, {_teeth(gear)}, {_transmits(gear)}{_mass(gear.mass)}"
    for coupling in case.couplings:
        yield coupling.name, f"{_at(coupling.station)}, {_transmits(coupling)}{_mass(coupling.mass)}"
    for mass in case.masses:
        yield mass.name, f"{_at(mass.station)}{_mass(mass.mass)}"
    for force in case.forces:
        sizes = [("x", force.x, "kN"), ("y", force.y, "kN"), ("z", force.z, "kN")]
        sizes += [("M_x", force.moment_x, "N m"), ("M_y", force.moment_y, "N m")]
        said = ", ".join(f"{axis} {written(value, unit)}" for axis, value, unit in sizes if value)
        yield force.name, f"{_at(force.station)}, {said or 'none'}"
    for bearing in case.bearings:
        yield (
            bearing.name,
            f"{BEARINGS[bearing.kind]}, {_at(bearing.station)}{_gives_way(bearing, bool(case.shaft))}",
        )
    for place, piece in enumerate(case.shaft, start=1):
        bore = f", bore {written(piece.inner_diameter, 'mm')}" if piece.inner_diameter else ""
        yield (
            f"Shaft, piece {place}",
            f"{written(piece.length, 'mm')}, diameter {written(piece.diameter, 'mm')}{bore}",
        )
    yield from words_of_material(case.shaft)
    if case.shaft:
        yield "Start of the first piece", _at(case.start)


def _at(station: float) -> str:
    return f"at {written(station, 'mm')}"


def _gives_way(bearing: ShaftBearing, bends: bool) -> str:
    if bearing.stiffness is not None:
        stiffness = f", {written(bearing.stiffness, 'MN/m')}"
    else:
        stiffness = ", rigid" if bends and bearing.as_support().radial else ""
    offset = bearing.offset
    return stiffness + (f", offset {1e6 * offset.x:.4g}, {1e6 * offset.y:.4g} µm" if offset.x or offset.y else "")


def _mass(mass: float) -> str:
    return f", {written(mass, 'kg')}" if mass else ""


def _teeth(gear: GearInput) -> str:
    diameter = f"pitch diameter {written(gear.diameter, 'mm')}, α_n {math.degrees(gear.pressure_angle):g}°"
    helix = f", β {math.degrees(gear.helix_angle):g}° {gear.helix}" if gear.helix_angle else ", spur"
    return f"{diameter}{helix}, mating gear at {math.degrees(gear.mesh_angle):g}°"


def _transmits(part: TorquePart) -> str:
    role = f"{part.role}, " if part.role else ""
    if part.torque is not None:
        return f"{role}{written(part.torque, 'N m')}"
    if part.power is not None:
        return f"{role}{written(part.power, 'kW')}"
    return f"{role}balance of the torques"
