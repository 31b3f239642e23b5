"""What the calculation of a footstep needs on its way to the results."""

from __future__ import annotations

from babbitt.core.quantities import QUANTITIES, DisplayUnit
from babbitt.core.units import ZERO_CELSIUS
from babbitt.report.local_quantity import MILLI, local

__all__ = ["FOOTSTEP_WORDS"]

FOOTSTEP_WORDS = (
    local("heel_length", "L", "m", "Length of the heel", 4, MILLI),
    local("heel_radius", "r_1", "m", "Radius of the heel", 4, MILLI),
    local("recess_radius", "r_3", "m", "Radius of the recess", 4, MILLI),
    local("bore_radius", "r_2", "m", "Radius of the bore", 4, MILLI),
    local("groove_angle", "φ", "rad", "Angle of the groove", 6, QUANTITIES["attitude_angle"].metric),
    local("groove_depth", "h_k", "m", "Depth of the groove", 4, MILLI),
    local("screw_groove_width", "a", "m", "Width of a groove", 4, MILLI),
    local("screw_land_width", "b", "m", "Width of a land", 4, MILLI),
    local("groove_starts", "z_n", "1", "Number of starts"),
    local("groove_length", "l", "m", "Length of a groove", 5, MILLI),
    local("groove_wall_speed", "U_k", "m/s", "Speed of the wall along the groove", 6),
    local("groove_line_flow", "q", "m2/s", "Groove flow per width", 8),
    local("groove_drive", "N", "m2/s", "Six times the shear flow less twice the flow", 8),
    local("groove_heat_term", "M_3", "m⁴/s²", "Term of the heat in the groove", 8),
    local("groove_stream_term", "M_4", "J m²/(s K)", "Term of the stream of heat", 8),
    local("face_resistance", "κ", "1/m³", "Resistance of recess and face gap", 8),
    local("inlet_viscosity", "μ_0", "Pa s", "Viscosity of the oil that comes in", 6),
    local("viscosity_exponent_alpha", "α", "1/K (abs)", "Exponent of viscosity", 6),
    local("heel_inlet_temperature", "θ_0", "K", "Inlet temperature", 6, DisplayUnit("°C", 1.0, -ZERO_CELSIUS)),
    local("heel_supply_pressure", "p_2", "Pa", "Pressure in the recess", 6),
    local("heel_ambient_pressure", "p_a", "Pa", "Pressure of the surroundings", 6),
    local("screw_speed", "ω_0", "rad/s", "Speed of the screw", 6),
    local("groove_speed", "ω", "rad/s", "Speed in the model of the groove", 6),
    local("rim_viscosity", "μ_c", "Pa s", "Viscosity at the rim", 7),
    local("clearance_viscosity", "μ_1", "Pa s", "Viscosity of the friction in the clearance", 7),
    local("face_viscosity", "μ_2", "Pa s", "Viscosity of the friction in the face gap", 7),
    local("land_surface", "S_1", "m2", "Surface of the lands", 6),
    local("groove_surface", "S_2", "m2", "Surface of the grooves", 6),
    local("face_friction_power", "P_face", "W", "Friction power of recess and face gap", 6),
)
"""Symbols as in the study of the footstep."""
