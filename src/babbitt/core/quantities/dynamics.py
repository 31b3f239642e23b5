"""Dynamics of films: coefficients, whirl, orbits, errors."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, entries, quantity

AGAINST_TILT = "against tilt, moment int z dF_{} over"

DYNAMICS: tuple[Quantity, ...] = (
    quantity("stiffness", "K", "N/m", "MN/m", 4, "Film stiffness, dF = -K dx, [[xx, xy], [yx, yy]]"),
    *entries("stiffness", "k_", "N/m", "MN/m", "Film stiffness, force in {} over move in {}"),
    quantity("frozen_stiffness", "K_fr", "N/m", "MN/m", 4, "Film stiffness at frozen temperatures, for stability"),
    quantity("damping", "C", "N s/m", "kNs/m", 4, "Film damping, dF = -C dx', [[xx, xy], [yx, yy]]"),
    *entries("damping", "c_", "N s/m", "kNs/m", "Film damping, force in {} over speed in {}"),
    *entries("tilt_stiffness", "k_φ_", "N m/rad", "kNm/rad", f"Film stiffness {AGAINST_TILT} slope d{{}}/dz"),
    *entries(
        "tilt_damping", "c_φ_", "N m s/rad", "Nms/rad", f"Film damping {AGAINST_TILT} rate of the slope d{{}}/dz"
    ),
    quantity(
        "tilt_stiffness",
        "K_φ",
        "SI",
        "",
        4,
        "Film stiffness, d(F_x, F_y, M_x, M_y) = -K d(x, y, dx/dz, dy/dz), M = int z dF; N/m, N, N m/rad",
    ),
    quantity(
        "tilt_damping",
        "C_φ",
        "SI",
        "",
        4,
        "Film damping in the motions of tilt_stiffness, those units times s",
    ),
    *(
        quantity(f"film_moment_{axis}", f"M_{axis}", "N m", "Nm", 4, f"Moment of the film, int z dF_{axis}")
        for axis in "xy"
    ),
    quantity("rotor_mass", "m", "kg", "t", 4, "Mass of the rigid rotor carried by the bearing"),
    quantity("stable_at_any_mass", "–", "1", "", 1, "Stable whatever the mass of the rotor: 1 yes, 0 no"),
    quantity("critical_mass", "m_cr", "kg", "t", 4, "Mass above which a rigid rotor whirls"),
    quantity("least_stable_mass", "m_min", "kg", "t", 4, "Mass below which a rigid rotor whirls"),
    quantity(
        "whirl_frequency_ratio",
        "ν_w",
        "1",
        "",
        3,
        "Whirl frequency on the threshold over rotational frequency; 0: no mass is on it",
    ),
    quantity("threshold_speed", "N_w", "rad/s", "rpm", 4, "Speed above which the rotor whirls"),
    quantity("shaft_stiffness", "k_s", "N/m", "MN/m", 4, "Stiffness of the shaft between rotor mass and journal"),
    quantity(
        "critical_mass_elastic", "m_cr,e", "kg", "t", 4, "Mass above which a rotor on the elastic shaft whirls"
    ),
    quantity(
        "threshold_speed_elastic",
        "N_w,e",
        "rad/s",
        "rpm",
        4,
        "Speed above which the rotor on the elastic shaft whirls",
    ),
    quantity("preload", "m_l", "1", "", 3, "Preload of the lobes, 1 - c/c_l"),
    quantity("lobe_clearance", "c_l", "m", "um", 4, "Radial clearance of the lobes"),
    quantity("equilibria", "n_eq", "1", "count", 1, "Equilibrium positions found under the load"),
    quantity("least_resting_film", "h_rest", "m", "um", 3, "Least film thickness at the other equilibria"),
    # orbit under a changing load
    quantity("orbit", "r(t)", "SI", "", 4, "Rows of angle turned, x, y, F_x, F_y, least film, largest pressure"),
    quantity(
        "orbit_largest_eccentricity_ratio", "ε_max", "1", "", 3, "Largest relative eccentricity on the orbit"
    ),
    quantity("orbit_minimum_film_thickness", "h_min,o", "m", "um", 3, "Least film thickness on the orbit"),
    quantity("orbit_minimum_film_direction", "φ_min", "rad", "deg", 3, "Direction of the journal there, from +x"),
    quantity("orbit_minimum_film_turned", "τ_min", "rad", "deg", 3, "Angle that the journal has turned by then"),
    quantity("orbit_maximum_pressure", "p_max,o", "Pa", "MPa", 3, "Maximum film pressure on the orbit"),
    quantity("orbit_specific_load", "p̄_o", "Pa", "MPa", 3, "Largest load on the orbit per projected area"),
    quantity("orbit_pressure_speed_product", "p̄U_o", "Pa m/s", "pv", 3, "That load per area times sliding speed"),
    quantity(
        "orbit_friction_power", "P_f,o", "W", "kW", 4, "Mean friction power on the orbit, torque times speed"
    ),
    quantity("orbit_load_power", "P_F,o", "W", "kW", 3, "Mean power that the moving load does on the film"),
    quantity(
        "orbit_load_error",
        "δ_F,o",
        "1",
        "",
        2,
        "Grid error of the force at the thinnest film, over the load",
    ),
    quantity("orbit_cycles", "n_o", "1", "count", 2, "Cycles until the orbit closed"),
    quantity("mass_balance_error", "δ_m", "1", "balance", 2, "Oil lost in the film over the oil supplied"),
    quantity("energy_balance_error", "δ_E", "1", "balance", 2, "Heat balance defect over friction power"),
    quantity("minimum_film_thickness_error", "δ_h", "1", "percent", 2, "Error of h_min by the grid, estimated"),
    quantity("position_error", "δ_e", "1", "percent", 2, "Error of the position by the grid over c, estimated"),
    quantity("load_error", "δ_F", "1", "percent", 2, "Error of the load found by the grid, estimated"),
    quantity("stiffness_error", "δ_K", "1", "percent", 2, "Error of the stiffness matrix by the grid, estimated"),
    quantity("damping_error", "δ_C", "1", "percent", 2, "Error of the damping matrix by the grid, estimated"),
    quantity("iterations", "n", "1", "count", 3, "Evaluations of the temperature iteration"),
    quantity("wall_time", "t", "s", "s", 3, "Time taken"),
)
