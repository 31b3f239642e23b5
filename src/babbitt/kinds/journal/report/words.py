"""What the calculation of a journal bearing needs on its way to the results."""

from __future__ import annotations

from babbitt.core.quantities import QUANTITIES, DisplayUnit
from babbitt.core.units import ZERO_CELSIUS
from babbitt.report.local_quantity import KILO, MICRO, MILLI, local

__all__ = ["JOURNAL_WORDS"]

ANGLE = QUANTITIES["attitude_angle"].metric

JOURNAL_WORDS = (
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
    local("reference_temperature", "T_0", "K", "Reference temperature", 5, DisplayUnit("°C", 1.0, -ZERO_CELSIUS)),
    local("temperature_coefficient", "β_T", "1/K", "Temperature coefficient", 6),
    local("viscosity_at_50", "η_50", "Pa s", "Viscosity at 50 °C", 6),
    local("viscosity_exponent", "m", "1", "Exponent of the power law", 6),
    local("reference_density", "ρ_0", "kg/m³", "Density at T_0", 5),
    local("density_slope", "s_ρ", "kg/(m³ K)", "Change of density", 5),
    local("friction_factor", "k_f", "1", "Factor on the friction number"),
    local("full_sommerfeld_number", "So_360", "1", "Sommerfeld number of the full bearing at ε"),
    local("full_attitude_angle", "β_360", "rad", "Attitude angle of the full bearing at ε", 3, ANGLE),
    local("sheared_arc", "I", "1", "Integral of dφ/(1 + ε cos φ) over the arc"),
    local("peak_pressure_ratio", "p_max*", "1", "Maximum over mean pressure"),
    local("starved_peak_pressure_ratio", "p_max,st*", "1", "Maximum over mean pressure"),
    local("hole_diameter", "d_H", "m", "Diameter of the supply hole", 4, MILLI),
    local("pocket_width", "b_P", "m", "Width of the pocket", 4, MILLI),
    local("groove_width", "b_G", "m", "Width of the groove", 4, MILLI),
    local("element_ratio", "s", "1", "Relative width of the supply element"),
    local("fitted_element_ratio", "s_q", "1", "Relative width at which the correction is taken"),
    local("starved_density", "ρ_st", "kg/m³", "Density of the oil at T_eff,st", 4),
    local("starved_heat_capacity", "ρc_st", "J/(m3 K)", "Heat capacity of the oil at T_eff,st", 5),
    local("supply_edge_angle", "α_s", "rad", "From the edge of the supply to the load", 4, ANGLE),
    local(
        "element_before_load",
        "α_1",
        "rad",
        "From the middle of the element before the load to the load",
        4,
        ANGLE,
    ),
    local("element_behind_load", "α_2", "rad", "From the load to the middle of the element behind it", 4, ANGLE),
    local("film_start_angle", "α_0", "rad", "From the start of the loaded film to the load", 4, ANGLE),
    local("film_start_gap", "h_0", "m", "Gap where the loaded film begins", 4, MICRO),
    local("returned_gap", "h_r", "m", "Film that leaves the loaded arc and comes back", 4, MICRO),
    local("supply_gap", "h_s", "m", "Gap at the edge of the supply element", 4, MICRO),
    local("supply_axial_width", "b", "m", "Width over which the element gives oil", 4, MILLI),
    local("hole_correction", "q_H", "1", "Correction for a hole"),
    local("pocket_correction", "q_P", "1", "Correction for a pocket"),
    local("hole_number", "n_H", "1", "Equal holes at each place"),
    local("roughness_bearing", "Rz_B", "m", "Roughness of the bearing", 3, MICRO),
    local("roughness_journal", "Rz_J", "m", "Roughness of the journal", 3, MICRO),
    local("tilt_offset", "B_y", "m", "Offset of the axis over the width by tilt", 3, MICRO),
    local("mean_deflection", "y", "m", "Mean deflection of the journal", 3, MICRO),
    local("waviness", "h_wav", "m", "Wave height of both surfaces", 3, MICRO),
    local("wave_factor", "E/G", "1", "Ratio of the functions of effective waviness", 3),
    local("transition_eccentricity", "ε_tr", "1", "Eccentricity at transition"),
    local("transition_sommerfeld_number", "So_tr", "1", "Sommerfeld number at transition"),
    local("regime_number", "λ", "1", "Orlov's regime number"),
    local("duct_flow", "Q", "m3/s", "Oil flow in the supply", 4, QUANTITIES["total_flow"].metric),
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
        QUANTITIES["effective_kinematic_viscosity"].metric,
    ),
)
"""Symbols as in ISO 7902 where it has one."""
