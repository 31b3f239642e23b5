"""Tilting-pad journal bearings."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, entries, quantity

TILTING_PADS: tuple[Quantity, ...] = (
    quantity("largest_pad_clearance", "c_p", "m", "um", 4, "Machined clearance of the pads, the largest"),
    quantity("assembled_clearance", "c_b", "m", "um", 4, "Assembled clearance of the pads, the smallest"),
    quantity("journal_x", "x", "m", "um", 4, "Journal centre, to the right of the bearing centre"),
    quantity("journal_y", "y", "m", "um", 4, "Journal centre, above the bearing centre"),
    quantity("loaded_pads", "z_F", "1", "count", 3, "Pads that carry load"),
    quantity(
        "least_pad_margin",
        "Δε_p",
        "1",
        "",
        3,
        "Least eccentricity ratio at a pivot above that at which the pad unloads",
    ),
    quantity("pad_pivot_angle", "θ_p,i", "rad", "deg", 4, "Angle of each pivot, counter-clockwise from +x"),
    quantity("pad_clearance", "c_p,i", "m", "um", 4, "Machined clearance of each pad"),
    quantity("pad_assembled_clearance", "c_b,i", "m", "um", 4, "Assembled clearance of each pad"),
    quantity("pad_preload", "m_i", "1", "", 3, "Preload of each pad, 1 - c_b/c_p"),
    quantity("pad_status", "s_i", "1", "", 2, "Status of each pad: 1 loaded, 0 unloaded, 0.5 at its limit"),
    quantity("pad_tilt", "δ_i", "rad", "mrad", 4, "Tilt of each pad, counter-clockwise; none where unloaded"),
    quantity("pad_eccentricity_ratio", "ε_p,i", "1", "", 3, "Eccentricity ratio at each pivot, m + ξ/c_p"),
    quantity("pad_side_flow", "Q_s,i", "m3/s", "L/min2", 4, "Oil out over both sides of each pad"),
    quantity("pad_probe_temperature", "T_probe,i", "K", "degC", 4, "Temperature of each bore at its probe"),
    quantity("probe_temperature", "T_probe", "K", "degC", 4, "Highest temperature of a bore at its probe"),
    quantity("pad_mean_temperature", "T_p,i", "K", "degC", 4, "Mean temperature of each pad"),
    quantity("pad_heat", "P_pad,i", "W", "W", 4, "Heat that each pad gives off at its back"),
    quantity("pad_edge_heat", "P_edge,i", "W", "W", 4, "Heat that each pad gives back to the oil over its edges"),
    quantity("heat_to_pads", "P_pad", "W", "W", 4, "Heat that all pads give off at their backs"),
    quantity("dissipation_error", "ε_d", "1", "percent", 3, "Heat made in the films over friction power, less 1"),
    quantity("growth_share", "χ", "1", "percent", 3, "Share of the growth by heat with which films were found"),
    quantity("running_clearance", "c_b,r", "m", "um", 4, "Assembled clearance as growth leaves it, the smallest"),
    quantity("pad_growth", "g_i", "m", "um", 3, "By which growth narrows the clearance of each pad"),
    quantity("pad_bending", "w_i", "m", "um", 3, "Largest bending of each pad"),
    quantity("pad_bending_stiffness", "k_q,i", "N/m", "MN/m", 4, "Stiffness of each pad against bending"),
    quantity("pivot_displacement", "u_i", "m", "um", 3, "How far each pivot gives way"),
    quantity("pivot_stiffness", "k_p,i", "N/m", "GN/m", 4, "Stiffness of each pivot under its load"),
    quantity("pivot_contact_pressure", "p_0,i", "Pa", "MPa", 4, "Largest pressure in the contact of each pivot"),
    quantity("largest_contact_pressure", "p_0", "Pa", "MPa", 4, "Largest pressure in the contacts of the pivots"),
    quantity("static_stiffness", "K_0", "N/m", "MN/m", 4, "Stiffness at rest, pads following"),
    quantity("static_damping", "C_0", "N s/m", "kNs/m", 4, "Damping of slow motion, pads following"),
    *entries("static_stiffness", "k_0,", "N/m", "MN/m", "Stiffness at rest, force in {} over move in {}"),
    quantity("whirl_ratio", "ν", "1", "", 3, "Frequencies of the dynamic coefficients over that of the rotation"),
    quantity("fitted_stiffness", "K_f", "N/m", "MN/m", 4, "Stiffness fitted over the whirl ratios"),
    quantity("fitted_damping", "C_f", "N s/m", "kNs/m", 4, "Damping fitted over the whirl ratios"),
    quantity(
        "virtual_mass", "M_v", "kg", "kg", 4, "Virtual mass fitted over the whirl ratios, Z = K - ω² M + j ω C"
    ),
    *entries("virtual_mass", "m_v,", "kg", "kg", "Virtual mass, force in {} over acceleration in {}"),
    quantity("fit_error", "δ_KCM", "1", "percent", 3, "Misfit of stiffness, damping and virtual mass"),
    quantity("system_stiffness", "K_s", "N/m", "MN/m", 4, "Stiffness of journal and pads, in `motions`"),
    quantity("system_damping", "C_s", "N s/m", "kNs/m", 4, "Damping of journal and pads, in `motions`"),
    quantity("system_mass", "M_s", "kg", "kg", 4, "Mass of the pads, in `motions`"),
    quantity(
        "rotor_modes",
        "λ",
        "SI",
        "",
        4,
        "Free motions: growth 1/s, frequency rad/s, log decrement, whirl (1 forward), share of the rotor",
    ),
    quantity("log_decrement", "δ_log", "1", "", 3, "Log decrement of the motion of the rotor that lasts longest"),
    quantity(
        "pad_log_decrement", "δ_log,p", "1", "", 3, "Least log decrement of all other motions, of pads or housing"
    ),
    quantity("log_decrement_forward", "δ_log,f", "1", "", 3, "Log decrement of the rotor's most forward motion"),
    quantity("log_decrement_backward", "δ_log,b", "1", "", 3, "Log decrement of the rotor's other motion"),
    quantity("whirl_frequency_forward", "f_f", "rad/s", "Hz", 4, "Frequency of the rotor's most forward motion"),
    quantity("whirl_frequency_backward", "f_b", "rad/s", "Hz", 4, "Frequency of the rotor's other motion"),
    quantity(
        "anticipated_cross_coupling",
        "Q_A",
        "N/m",
        "MN/m",
        4,
        "Anticipated cross-coupling of the rotor, destabilising",
    ),
    quantity(
        "critical_cross_coupling", "Q_0", "N/m", "MN/m", 4, "Threshold cross-coupling, from which a motion grows"
    ),
    quantity(
        "cross_coupling_ratio",
        "Q_0/Q_A",
        "1",
        "",
        3,
        "Threshold cross-coupling over the anticipated one",
    ),
    quantity("log_decrement_anticipated", "δ_A", "1", "", 3, "Log decrement with the anticipated cross-coupling"),
    quantity(
        "synchronous_log_decrement", "δ_log,s", "1", "", 3, "Log decrement by synchronously reduced coefficients"
    ),
    quantity(
        "synchronous_log_decrement_anticipated",
        "δ_A,s",
        "1",
        "",
        3,
        "Log decrement with the anticipated cross-coupling, by synchronously reduced coefficients",
    ),
    quantity(
        "synchronous_critical_cross_coupling",
        "Q_0,s",
        "N/m",
        "MN/m",
        4,
        "Threshold cross-coupling of the rotor, by synchronously reduced coefficients",
    ),
    quantity(
        "synchronous_cross_coupling_ratio",
        "Q_0,s/Q_A",
        "1",
        "",
        3,
        "Threshold cross-coupling over the anticipated one, by synchronously reduced coefficients",
    ),
    quantity(
        "decrement_over_cross_coupling",
        "δ(Q)",
        "SI",
        "",
        4,
        "Cross-coupling N/m, log decrement, the same by synchronously reduced coefficients",
    ),
    quantity(
        "decrement_over_speed",
        "δ(n)",
        "SI",
        "",
        4,
        "Speed rad/s, log decrement without and with the anticipated cross-coupling, both by synchronously "
        "reduced coefficients",
    ),
    quantity("assumed_carry_over", "λ_c", "1", "", 3, "Carry-over: less, as assumed, more"),
    quantity(
        "assumed_back_coefficient", "h_b", "W/(m2 K)", "W/m2K", 3, "Heat transfer on the backs: less, as assumed, more"
    ),
    quantity("assumed_housing_temperature", "T_h", "K", "degC", 4, "Housing: colder, as assumed, warmer"),
    *(
        quantity(
            f"sensitivity_of_{name}",
            f"{symbol}(a)",
            unit,
            shown,
            4,
            f"{what} with less and more of what is assumed",
        )
        for name, symbol, unit, shown, what in (
            ("maximum_temperature", "T_max", "K", "degC", "Highest temperature of films and bores"),
            ("effective_temperature", "T_eff", "K", "degC", "Mean temperature of the films"),
            ("minimum_film_thickness", "h_min", "m", "um", "Minimum film thickness"),
            ("friction_power", "P_f", "W", "kW", "Friction power"),
            ("stiffness_yy", "k_yy", "N/m", "MN/m", "Synchronous stiffness"),
            ("damping_yy", "c_yy", "N s/m", "kNs/m", "Synchronous damping"),
        )
    ),
    quantity("pedestal_x", "x_P", "m", "um", 4, "Way of the housing on its pedestal, to the right"),
    quantity("pedestal_y", "y_P", "m", "um", 4, "Way of the housing on its pedestal, upward"),
    quantity("bearing_stiffness", "K_B", "N/m", "MN/m", 4, "Synchronous stiffness without the pedestal"),
    quantity("bearing_damping", "C_B", "N s/m", "kNs/m", 4, "Synchronous damping without the pedestal"),
    quantity("threshold_mass", "m_th", "kg", "t", 4, "Mass of the rotor above which a motion grows"),
    quantity("threshold_frequency", "f_th", "rad/s", "Hz", 4, "Frequency of the motion that begins to grow"),
)
