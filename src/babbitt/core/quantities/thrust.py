"""Thrust bearings."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, quantity

THRUST: tuple[Quantity, ...] = (
    quantity("pad_number", "z", "1", "count", 3, "Number of pads"),
    quantity("pivot_film_thickness", "h_p", "m", "um", 3, "Film at the pivot of the pad that carries most"),
    quantity("largest_pad_load", "W_max", "N", "kN", 4, "Load of the pad that carries most"),
    quantity("largest_specific_load", "p̄_max", "Pa", "MPa", 3, "Mean pressure of the pad that carries most"),
    quantity("smallest_pad_load", "W_least", "N", "kN", 4, "Load of the pad that carries least"),
    quantity("pad_load_ratio", "W_max*", "1", "", 3, "Largest over mean pad load"),
    quantity("collar_moment", "M_c", "N m", "kNm", 4, "Static moment of uneven pad loads on the collar"),
    quantity("collar_moment_amplitude", "M_dyn", "N m", "kNm", 4, "Dynamic moment on the collar, any phases"),
    quantity(
        "quasi_static_load_ratio",
        "W_turn*",
        "1",
        "",
        3,
        "Largest over mean pad load while the collar turns slowly",
    ),
    quantity(
        "quasi_static_minimum_film_thickness",
        "h_turn",
        "m",
        "um",
        3,
        "Thinnest film while the collar turns slowly with its runout",
    ),
    quantity(
        "pad_inlet_temperature", "T_in", "K", "degC", 4, "Oil temperature at the leading edges, after mixing"
    ),
    quantity("trailing_temperature", "T_tr", "K", "degC", 4, "Oil temperature at the trailing edges"),
    quantity(
        "hottest_trailing_temperature", "T_tr,max", "K", "degC", 4, "Oil temperature at the hottest trailing edge"
    ),
    quantity("axial_stiffness", "K_ax", "N/m", "GN/m", 4, "Stiffness of all films at rest, tilts free"),
    quantity("axial_damping", "C_ax", "N s/m", "MNs/m", 4, "Damping of all films at the frequency of the shaft"),
    quantity("ring_stiffness", "k_r", "N/m", "GN/m", 4, "Stiffness of the backing ring per pad"),
    quantity("pad_load", "W_i", "N", "kN", 4, "Static load of each pad"),
    quantity("pad_film_thickness", "h_i", "m", "um", 3, "Static film at the pivot of each pad"),
    quantity("pad_minimum_film_thickness", "h_min,i", "m", "um", 3, "Thinnest static film of each pad"),
    quantity("pad_maximum_pressure", "p_max,i", "Pa", "MPa", 3, "Largest pressure of each pad"),
    quantity("passing_flow", "Q_z", "m3/s", "L/min", 3, "Oil through the films of all pads"),
    quantity("pad_leading_flow", "Q_l,i", "m3/s", "L/min2", 4, "Oil in over the leading edge of each pad"),
    quantity("pad_trailing_flow", "Q_t,i", "m3/s", "L/min2", 4, "Oil out over the trailing edge of each pad"),
    quantity("pad_inner_flow", "Q_i,i", "m3/s", "L/min", 3, "Oil out over the inner edge of each pad"),
    quantity("pad_outer_flow", "Q_o,i", "m3/s", "L/min", 3, "Oil out over the outer edge of each pad"),
    quantity("pad_friction_power", "P_f,i", "W", "kW", 4, "Friction power under each pad"),
    quantity("pad_mixed_temperature", "T_in,i", "K", "degC", 4, "Oil temperature at the leading edge of each pad"),
    quantity("pad_effective_temperature", "T_eff,i", "K", "degC", 4, "Effective temperature of each film"),
    quantity(
        "pad_trailing_temperature", "T_tr,i", "K", "degC", 4, "Oil temperature at the trailing edges, each pad"
    ),
    quantity("pad_maximum_temperature", "T_max,i", "K", "degC", 4, "Highest temperature in the film of each pad"),
    quantity("pad_stiffness", "k_i", "N/m", "GN/m", 4, "Stiffness of each film at rest, tilts free"),
    quantity("pad_damping", "d_i", "N s/m", "MNs/m", 4, "Damping of each film at the frequency of the shaft"),
    quantity("pad_slope_radial", "α_x", "rad", "urad", 4, "Slope of each pad along the radius"),
    quantity("pad_slope_along", "α_y", "rad", "urad", 4, "Slope of each pad along the motion"),
    quantity(
        "full_stiffness",
        "K_p",
        "N/m",
        "GN/m",
        4,
        "Stiffness of a pad over (height, radial slope, slope along the motion), 3 x 3, SI",
    ),
    quantity("full_damping", "C_p", "N s/m", "MNs/m", 4, "Damping of a pad over the same motions, 3 x 3, SI"),
)
