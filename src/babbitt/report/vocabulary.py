"""The words of a calculation: the vocabulary of results, and what only occurs on the way to them."""

from __future__ import annotations

from babbitt.core.quantities import QUANTITIES, DisplayUnit, Quantity
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.hydrostatic.report.words import HYDROSTATIC_WORDS
from babbitt.report.expression import Node
from babbitt.report.local_quantity import KILO, MICRO, MILLI, PRINTED_UNITS, local
from babbitt.report.symbols import symbol_node

__all__ = ["PRINTED_UNITS", "VOCABULARY", "calculated", "symbol"]

VOCABULARY: dict[str, Quantity] = QUANTITIES | {
    quantity.name: quantity
    for quantity in (
        local("radial_clearance", "c", "m", "Radial clearance", 4, MICRO),
        local("absolute_temperature", "T", "K (abs)", "Absolute temperature", 6),
        local("double_logarithm", "W", "1", "Double logarithm of the viscosity", 6),
        local("walther_intercept", "A_W", "1", "Walther's A", 7),
        local("walther_slope", "B_W", "1", "Walther's B", 7),
        local("walther_additive", "a_W", "1", "Additive constant"),
        local("kinematic_viscosity_number", "ν_mm", "mm²/s", "Kinematic viscosity at T_eff"),
        local("vogel_factor", "a_V", "Pa s", "Vogel's a", 6),
        local("vogel_activation", "b_V", "K (abs)", "Vogel's b", 6),
        local("vogel_pole", "c_V", "K (abs)", "Vogel's c", 6),
        local("reference_viscosity", "η_0", "Pa s", "Viscosity at T_0", 6),
        local(
            "reference_temperature", "T_0", "K", "Reference temperature", 5, DisplayUnit("°C", 1.0, -ZERO_CELSIUS)
        ),
        local("temperature_coefficient", "β_T", "1/K", "Temperature coefficient", 6),
        local("viscosity_at_50", "η_50", "Pa s", "Viscosity at 50 °C", 6),
        local("viscosity_exponent", "m", "1", "Exponent of the power law", 6),
        local("reference_density", "ρ_0", "kg/m³", "Density at T_0", 5),
        local("density_slope", "s_ρ", "kg/(m³ K)", "Change of density", 5),
        local("friction_factor", "k_f", "1", "Factor on the friction number"),
        local("full_sommerfeld_number", "So_360", "1", "Sommerfeld number of the full bearing at ε"),
        local(
            "full_attitude_angle",
            "β_360",
            "rad",
            "Attitude angle of the full bearing at ε",
            3,
            QUANTITIES["attitude_angle"].display,
        ),
        local("sheared_arc", "I", "1", "Integral of dφ/(1 + ε cos φ) over the arc"),
        local("peak_pressure_ratio", "p_max*", "1", "Maximum over mean pressure"),
        local("hole_diameter", "d_H", "m", "Diameter of the supply hole", 4, MILLI),
        local("pocket_width", "b_P", "m", "Width of the pocket", 4, MILLI),
        local("groove_width", "b_G", "m", "Width of the groove", 4, MILLI),
        local("heel_length", "L", "m", "Length of the heel", 4, MILLI),
        local("heel_radius", "r_1", "m", "Radius of the heel", 4, MILLI),
        local("recess_radius", "r_3", "m", "Radius of the recess", 4, MILLI),
        local("bore_radius", "r_2", "m", "Radius of the bore", 4, MILLI),
        local("recess_depth", "H", "m", "Depth of the recess", 4, MILLI),
        local("groove_angle", "φ", "rad", "Angle of the groove", 6, QUANTITIES["attitude_angle"].display),
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
        local("element_ratio", "s", "1", "Relative width of the supply element"),
        local("fitted_element_ratio", "s_q", "1", "Relative width at which the correction is taken"),
        local("starved_heat_capacity", "ρc_st", "J/(m3 K)", "Heat capacity of the oil at T_eff,st", 5),
        local("supply_gap", "h_s", "m", "Gap at the supply element", 4, MICRO),
        local("supply_axial_width", "b", "m", "Width over which the element gives oil", 4, MILLI),
        local("hole_correction", "q_H", "1", "Correction for a hole"),
        local("pocket_correction", "q_P", "1", "Correction for a pocket"),
        local("hole_number", "n_H", "1", "Equal holes at each place"),
        local("heat_transfer_coefficient", "k_A", "W/(m² K)", "Heat transfer coefficient"),
        local("cooling_surface", "A", "m²", "Surface that gives off heat"),
        local("roughness_bearing", "Rz_B", "m", "Roughness of the bearing", 3, MICRO),
        local("roughness_journal", "Rz_J", "m", "Roughness of the journal", 3, MICRO),
        local("tilt_offset", "B_y", "m", "Offset of the axis over the width by tilt", 3, MICRO),
        local("mean_deflection", "y", "m", "Mean deflection of the journal", 3, MICRO),
        local("waviness", "h_wav", "m", "Wave height of both surfaces", 3, MICRO),
        local("wave_factor", "E/G", "1", "Ratio of the functions of effective waviness", 3),
        local("transition_eccentricity", "ε_tr", "1", "Eccentricity at transition"),
        local("transition_sommerfeld_number", "So_tr", "1", "Sommerfeld number at transition"),
        local("regime_number", "λ", "1", "Orlov's regime number"),
        local("duct_flow", "Q", "m3/s", "Oil flow in the supply", 4, QUANTITIES["total_flow"].display),
        local("duct_number", "n", "1", "Equal ducts in parallel"),
        local("duct_diameter", "d", "m", "Diameter", 4, MILLI),
        local("duct_length", "l", "m", "Length", 4, MILLI),
        local("duct_coefficient", "ζ", "1", "Loss coefficient"),
        local("duct_velocity", "v", "m/s", "Mean velocity"),
        local("duct_reynolds_number", "Re_d", "1", "Reynolds number"),
        local("duct_friction", "λ_d", "1", "Friction factor"),
        local("duct_loss", "Δp", "Pa", "Pressure loss", 4, KILO),
        local("inlet_density", "ρ_en", "kg/m³", "Density at the inlet"),
        local(
            "inlet_kinematic_viscosity",
            "ν_en",
            "m2/s",
            "Kinematic viscosity at the inlet",
            4,
            QUANTITIES["effective_kinematic_viscosity"].display,
        ),
        *HYDROSTATIC_WORDS,
    )
}
"""The vocabulary of results and what only occurs on the way to them."""


def calculated(quantity: Quantity, value: float) -> float:
    """A value in the units in which the lines calculate: SI, and temperatures in °C."""
    return value - ZERO_CELSIUS if quantity.unit == "K" else value


def symbol(name: str) -> Node:
    """The symbol of a quantity."""
    return symbol_node(VOCABULARY[name].symbol)
