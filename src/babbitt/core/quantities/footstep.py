"""Footsteps of screw pumps."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, quantity

FOOTSTEP: tuple[Quantity, ...] = (
    quantity("face_gap", "h_f", "m", "um2", 4, "Face gap of the footstep"),
    quantity("heel_clearance", "δ", "m", "um2", 4, "Radial clearance of the heel"),
    quantity("rim_pressure", "p₁", "Pa", "MPa3", 4, "Pressure at the rim of the heel, absolute"),
    quantity("face_flow", "Q₂", "m3/s", "mm3/s", 4, "Flow from recess to rim; negative: the rim feeds the recess"),
    quantity("heel_groove_flow", "Q_k", "m3/s", "mm3/s", 4, "Flow of the groove towards the rim"),
    quantity(
        "heel_leakage",
        "Q_l",
        "m3/s",
        "mm3/s",
        4,
        "Leakage through the clearance to ambient, not through the groove",
    ),
    quantity(
        "heel_net_flow",
        "Q_n",
        "m3/s",
        "mm3/s",
        4,
        "Net flow of clearance and groove to ambient; negative: oil is drawn in",
    ),
    quantity(
        "heel_leaving_flow",
        "Q_out",
        "m3/s",
        "mm3/s",
        4,
        "All oil that leaves the footstep: to ambient, by the groove and back into the bore",
    ),
    quantity("rim_excess_flow", "ΔQ", "m3/s", "mm3/s", 4, "Oil that the rim receives and cannot give away"),
    quantity(
        "groove_outlet_temperature", "θ₁′", "K", "degC", 4, "Temperature of the oil at the end of the groove"
    ),
    quantity("face_outlet_temperature", "θ₁″", "K", "degC", 4, "Temperature of the oil that leaves the face gap"),
    quantity("rim_temperature", "θ_m", "K", "degC", 4, "Temperature of the mixed oil at the rim"),
    quantity("face_film_temperature", "θ_f", "K", "degC", 4, "Temperature of the film in face gap and recess"),
    quantity("clearance_film_temperature", "θ_c", "K", "degC", 4, "Temperature of the film in the clearance"),
    quantity("face_gap_stiffness", "K_a", "N/m", "N/um", 3, "Axial stiffness, -dF over the face gap"),
    quantity("face_gap_damping", "D_a", "N s/m", "kNs/m", 3, "Axial damping, -dF over the speed of the face gap"),
    quantity("load_over_clearance", "dF/dδ", "N/m", "N/um", 3, "Change of the load with the clearance"),
    quantity(
        "thermal_loop_gain",
        "g_θ",
        "1",
        "",
        3,
        "Share of a disturbance of temperature that comes back through viscosity and flow; 1 or more: not stable",
    ),
    quantity("load_ratio_to_smooth", "F/F_s", "1", "", 4, "Load over that of the smooth heel"),
    quantity("friction_ratio_to_smooth", "P_s/P_f", "1", "", 4, "Friction power of the smooth heel over this one"),
    quantity("critical_clearance", "δ_cr", "m", "um2", 4, "Clearance at which the face gap passes no oil"),
    quantity("critical_temperature", "θ_cr", "K", "degC", 4, "Temperature of the groove at critical clearance"),
    quantity("fold_clearance", "δ_f", "m", "um2", 4, "Smallest clearance with a steady state at this face gap"),
    quantity("groove_reynolds_number", "Re_k", "1", "", 3, "Reynolds number of the groove, oil as it enters"),
    quantity("clearance_reynolds_number", "Re_δ", "1", "", 3, "Reynolds number of the clearance"),
    quantity("centrifugal_pressure", "Δp_c", "Pa", "kPa", 3, "Pressure that rotation adds from recess to rim"),
    quantity("leak_factor", "k_ε", "1", "", 4, "Leakage of the eccentric clearance over the concentric one"),
    quantity(
        "leakage_side_force", "F_ε", "N", "N", 4, "Side force of the leakage; positive: away from the centre"
    ),
    quantity("heel_force_along", "F_x", "N", "N", 4, "Force of the turning film along the eccentricity"),
    quantity("heel_force_across", "F_y", "N", "N", 4, "Force of the turning film across the eccentricity"),
)
