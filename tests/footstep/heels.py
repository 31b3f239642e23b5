"""Footsteps for tests: that of the published study, and variations of it."""

import math

from babbitt.case import template
from babbitt.kinds.footstep.model import Footstep, FootstepGeometry, FootstepOil, ScrewGroove

GEOMETRY = FootstepGeometry(35e-3, 21.8e-3, 14e-3, 5e-3, 5e-3)
GROOVE = ScrewGroove(math.radians(10.0), 0.3e-3, 1.2e-3, 3.58e-3, 5)
OIL = FootstepOil(0.0225, 298.15, 0.026, 1.76e6, 880.0)

STUDY = (
    template("screw_heel")
    .replace("method: narrow_groove ", "method: superposition ")
    .replace(
        "\nwall: {temperature: 25 degC, conductance: 10 W/K}",
        "\n# wall: {temperature: 25 degC, conductance: 10 W/K}",
    )
)
"""The template by the equations of the study, which know no metal."""


def footstep(face_gap=20.0, clearance=20.0, **changes):
    """The published footstep at a face gap and a clearance in micrometres."""
    given = {
        "geometry": GEOMETRY, "oil": OIL, "angular_speed": 1450.0 * math.pi / 30.0, "supply_pressure": 0.63e6,
        "ambient_pressure": 0.101e6, "face_gap": face_gap * 1e-6, "clearance": clearance * 1e-6, "groove": GROOVE,
    }  # fmt: skip
    return Footstep(**(given | changes))
