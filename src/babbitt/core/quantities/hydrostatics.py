"""Hydrostatic bearings and jacking."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, quantity

HYDROSTATICS: tuple[Quantity, ...] = (
    quantity("gap", "h_m", "m", "um", 4, "Gap of the pad"),
    quantity("recess_pressure", "p_r", "Pa", "MPa", 4, "Gauge pressures of the recesses"),
    quantity("pressure_ratio", "β_r", "1", "", 4, "Recess over supply pressure, of every recess"),
    quantity("mean_pressure_ratio", "β_m", "1", "", 4, "Recess over supply pressure, mean of the recesses"),
    quantity("restrictor_flow", "Q_r", "m3/s", "L/min", 4, "Oil flow through every restrictor"),
    quantity("pumping_power", "P_p", "W", "kW", 4, "Flow times the pressure to which it is pumped"),
    quantity("pump_power", "P_pu", "W", "kW", 4, "Power at the shaft of the pump"),
    quantity("relief_flow", "Q_v", "m3/s", "L/min", 4, "Oil over the relief valve of the pump"),
    quantity("relief_power", "P_v", "W", "kW", 4, "Power lost over the relief valve"),
    quantity("power_ratio", "P_f/P_p", "1", "", 3, "Friction power over pumping power"),
    quantity("temperature_rise", "ΔT", "K", "K", 3, "Rise of the oil between manifold and drain"),
    quantity("effective_area", "A_e", "m2", "cm2", 4, "Load over recess pressure"),
    quantity("gap_stiffness", "K_z", "N/m", "MN/m", 4, "Stiffness of the pad along its axis, slow motion"),
    quantity("gap_damping", "C_z", "N s/m", "kNs/m", 4, "Damping of the pad along its axis, slow motion"),
    quantity("least_tilt_stiffness", "K_φ,min", "N m/rad", "kNm/mrad", 4, "Least stiffness against tilting"),
    quantity(
        "runner_tilt_stiffness", "K_φφ", "N m/rad", "kNm/mrad", 4, "Stiffness against the tilts about x and y"
    ),
    quantity(
        "runner_stiffness", "K_z,φ", "N/m", "MN/m", 4, "Stiffness of the runner in z and the tilts about x and y"
    ),
    quantity(
        "runner_damping", "C_z,φ", "N s/m", "kNs/m", 4, "Damping of the runner in z and the tilts about x and y"
    ),
    quantity("dynamic_frequency", "f_d", "rad/s", "Hz", 4, "Frequencies of the dynamic coefficients"),
    quantity("dynamic_stiffness", "K_ν", "N/m", "MN/m", 4, "Stiffness at every frequency, row by row"),
    quantity("dynamic_damping", "C_ν", "N s/m", "kNs/m", 4, "Damping at every frequency, row by row"),
    quantity(
        "compressibility_damping_loss",
        "δ_κ",
        "1",
        "percent",
        3,
        "Damping lost to compressible oil",
    ),
    quantity("network_stability", "λ_min", "1", "", 3, "Least eigenvalue of the recess network over the largest"),
    quantity("stiffest_pressure_ratio", "β_opt", "1", "", 3, "Pressure ratio of greatest stiffness, gap given"),
    quantity("least_power_gap", "h_P", "m", "um", 3, "Gap or clearance of least total power at these pressures"),
    quantity("least_power_viscosity", "η_P", "Pa s", "mPas", 4, "Viscosity of least total power at this gap"),
    quantity("load_capacity", "F_max", "N", "kN", 4, "Load at the least gap allowed"),
    quantity("tilt_x", "φ_x", "rad", "mrad", 4, "Tilt of the runner about x"),
    quantity("tilt_y", "φ_y", "rad", "mrad", 4, "Tilt of the runner about y"),
    quantity("moment_x", "M_φx", "N m", "Nm", 4, "Moment of the film about x"),
    quantity("moment_y", "M_φy", "N m", "Nm", 4, "Moment of the film about y"),
    quantity("recess_reynolds_number", "Re_r", "1", "count", 3, "Reynolds number in the recess"),
    quantity(
        "restrictor_reynolds_number",
        "Re_c",
        "1",
        "count",
        3,
        "Greatest Reynolds number in the capillaries",
    ),
    quantity("edge_inertia", "Π_e", "1", "", 3, "ρ U²/2 at the recess edge over the lowest recess pressure"),
    quantity("cavitated_share", "s_c", "1", "percent", 2, "Share of the lands without film"),
    quantity("grid_error", "δ_g", "1", "percent", 2, "Estimated error of the force by the grid"),
    quantity("breakaway_pressure", "p_b", "Pa", "MPa", 4, "Breakaway pressure without seepage, upper bound"),
    quantity("lying_pressure", "p_l", "Pa", "MPa", 4, "Breakaway pressure with seepage on roughness, lower bound"),
    quantity("pocket_pressure", "p_j", "Pa", "MPa", 4, "Pocket pressure after lift"),
    quantity("lift", "Δh", "m", "um", 3, "Lift of the shaft"),
)
