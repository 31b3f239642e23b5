"""What the calculation of a shaft needs on its way to the results."""

from __future__ import annotations

from babbitt.core.quantities import DisplayUnit
from babbitt.report.local_quantity import MILLI, local

__all__ = ["SHAFT_WORDS"]

KILONEWTON = DisplayUnit("kN", 1e-3)
DEGREES = DisplayUnit("°", 57.29577951308232)

SHAFT_WORDS = (
    local("gear_torque", "T", "N m", "Torque of the gear", 5),
    local("pitch_diameter", "d", "m", "Pitch diameter", 5, MILLI),
    local("normal_pressure_angle", "α_n", "rad", "Normal pressure angle", 5, DEGREES),
    local("helix_angle", "β", "rad", "Helix angle", 5, DEGREES),
    local("tangential_force", "F_t", "N", "Tangential force", 5, KILONEWTON),
    local("radial_force", "F_r", "N", "Radial force", 5, KILONEWTON),
    local("axial_force", "F_a", "N", "Axial force", 5, KILONEWTON),
    local("axial_couple", "M_a", "N m", "Couple of the axial force", 5),
)
