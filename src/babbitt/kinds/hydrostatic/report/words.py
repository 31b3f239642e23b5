"""What the calculation of a hydrostatic bearing needs on its way to the results."""

from __future__ import annotations

from babbitt.core.quantities import DisplayUnit
from babbitt.report.local_quantity import MICRO, MILLI, local
from babbitt.report.meanings import PUMPED

__all__ = ["HYDROSTATIC_WORDS", "JACKING", "OF_RECESSED_JOURNALS", "OF_RUNNERS", "SUPPLY_TEMPERATURE"]

SUPPLY_TEMPERATURE = "Temperature before the restrictors"

OF_RECESSED_JOURNALS = PUMPED | {"supply_temperature": SUPPLY_TEMPERATURE}
"""Journals on recesses: their oil comes through restrictors."""

OF_RUNNERS = OF_RECESSED_JOURNALS | {
    "angular_speed": "Rotational speed of the runner",
    "friction_torque": "Friction torque on the runner",
}
"""Pads and rings, which have a runner and no journal."""

JACKING = PUMPED | {"total_flow": "Oil of all pockets", "effective_area": "Load over pocket pressure"}
"""Jacking pockets: the oil of a pump, not of restrictors."""

MEGA = DisplayUnit("MPa", 1e-6)
PER_MINUTE = DisplayUnit("L/min", 6e4)
CONDUCTANCE = "m³/(s Pa)"
CONDUCTS = DisplayUnit("L/(min MPa)", 6e10)
STIFF = DisplayUnit("MN/m", 1e-6)

HYDROSTATIC_WORDS = (
    local("pad_radius", "R", "m", "Outer radius of the pad", 5, MILLI),
    local("pad_recess_radius", "R_0", "m", "Radius of the recess", 5, MILLI),
    local("ring_inner_edge", "r_1", "m", "Inner edge of the ring", 5, MILLI),
    local("ring_recess_inner_edge", "r_2", "m", "Inner edge of the recess", 5, MILLI),
    local("ring_recess_outer_edge", "r_3", "m", "Outer edge of the recess", 5, MILLI),
    local("ring_outer_edge", "r_4", "m", "Outer edge of the ring", 5, MILLI),
    local("pad_length", "L_x", "m", "Length of the pad", 5, MILLI),
    local("pad_width", "L_y", "m", "Width of the pad", 5, MILLI),
    local("pad_recess_length", "l_x", "m", "Length of the recess", 5, MILLI),
    local("pad_recess_width", "l_y", "m", "Width of the recess", 5, MILLI),
    local("land_along", "a_x", "m", "Land along the pad", 5, MILLI),
    local("land_across", "a_y", "m", "Land across the pad", 5, MILLI),
    local("land_squares", "q_s", "1", "Squares of the lands in parallel", 6),
    local("land_conductance", "G", CONDUCTANCE, "Conductance of the lands", 6, CONDUCTS),
    local("one_recess_pressure", "p_r", "Pa", "Pressure of the recess", 6, MEGA),
    local("one_restrictor_flow", "Q_r", "m3/s", "Flow through its restrictor", 5, PER_MINUTE),
    local("restrictor_conductance", "G_c", CONDUCTANCE, "Conductance of the restrictor", 6, CONDUCTS),
    local("restrictor_slope", "G_r", CONDUCTANCE, "Slope of the restrictor −dQ/dp", 6, CONDUCTS),
    local("restrictor_viscosity", "η_c", "Pa s", "Viscosity in the restrictor", 5),
    local("restrictor_density", "ρ_c", "kg/m³", "Density in the restrictor", 5),
    local("capillary_number", "n_c", "1", "Capillaries side by side"),
    local("capillary_diameter", "d_c", "m", "Bore of the capillary", 5, MILLI),
    local("capillary_length", "l_c", "m", "Length of the capillary", 5, MILLI),
    local("entry_loss_factor", "ξ", "1", "Loss factor of the entry"),
    local("entry_term", "B_c", "Pa s²/m⁶", "Square term of the pressure drop", 6),
    local("orifice_diameter", "d_o", "m", "Diameter of the orifice", 5, MILLI),
    local("orifice_discharge", "C_d", "1", "Discharge coefficient"),
    local("slot_width", "w_s", "m", "Width of the slot", 5, MILLI),
    local("slot_gap", "s_s", "m", "Height of the slot", 5, MILLI),
    local("slot_length", "l_s", "m", "Length of the slot", 5, MILLI),
    local("stage_flow", "Q_0", "m3/s", "Flow at zero recess pressure", 5, PER_MINUTE),
    local("stage_leakage", "k_l", CONDUCTANCE, "Leakage of its pump", 5, CONDUCTS),
    local("valve_gain", "k_v", CONDUCTANCE, "Rise of the flow with the pressure", 5, CONDUCTS),
    local("open_conductance", "G_max", CONDUCTANCE, "Conductance of the open ports", 5, CONDUCTS),
    local("membrane_conductance", "G_m", CONDUCTANCE, "Conductance at zero pressure", 5, CONDUCTS),
    local("membrane_compliance", "s_m", "1/Pa", "Growth of its gap with the pressure", 5),
    local("recess_number", "n", "1", "Number of recesses"),
    local("recess_angle", "φ_r", "rad", "Angle of a recess", 6),
    local("recess_surface", "A_r", "m2", "Area of a recess", 6),
    local("recess_friction", "f_r", "1", "Friction factor in the recess"),
    local("recess_inertia", "I_r", "m⁴", "Integral of r² over the recesses", 6),
    local("shear_torque", "M_s", "N m", "Torque of the shear", 5),
    local("pressure_torque", "M_p", "N m", "Torque of the pressure", 5),
    local("ring_area", "A_e,r", "m2", "Area on which the mean recess pressure acts", 6, DisplayUnit("cm²", 1e4)),
    local("axial_land", "a", "m", "Axial land beside a recess", 5, MILLI),
    local("between_land", "b", "m", "Land between recesses, around", 5, MILLI),
    local("recess_axial_length", "l_r", "m", "Axial length of a recess", 5, MILLI),
    local("land_interaction", "γ", "1", "Lands between the recesses over axial ones", 6),
    local("centred_conductance", "G_z", CONDUCTANCE, "Conductance of all axial lands", 6, CONDUCTS),
    local("centred_ratio", "β_z", "1", "Pressure ratio of the centred journal", 5),
    local("centred_flow", "Q_z", "m3/s", "Flow of the centred journal", 5, PER_MINUTE),
    local("centred_stiffness", "K_z0", "N/m", "Stiffness of the centred journal", 5, STIFF),
    local("pump_delivery", "Q_pu", "m3/s", "Flow of the pump", 5, PER_MINUTE),
    local("efficiency_of_pump", "η_pu", "1", "Efficiency of the pump"),
    local("slide_speed", "U", "m/s", "Sliding speed"),
    local("oil_warming", "ΔT", "K (abs)", "Rise between manifold and drain", 4),
    local("projected_area", "A_p", "m2", "Area of the pockets along the load", 6, DisplayUnit("cm²", 1e4)),
    local("roughness_height", "R_k", "m", "Composite roughness height", 4, MICRO),
    local("pocket_conductance", "G", CONDUCTANCE, "Conductance of the film after lift", 6, CONDUCTS),
)
"""Symbols as in the theory manual."""
