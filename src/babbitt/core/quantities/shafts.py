"""Statics of shafts."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, quantity

SHAFTS: tuple[Quantity, ...] = (
    quantity("largest_support_load", "F_B,max", "N", "kN", 5, "Largest load on a bearing of the shaft"),
    quantity("axial_load", "F_ax", "N", "kN", 5, "Thrust of the shaft, positive along z"),
    quantity("largest_torque", "M_t", "N m", "Nm", 5, "Largest torque in the shaft"),
    quantity("bending_moment", "M_max", "N m", "Nm", 5, "Largest bending moment of the shaft"),
    quantity("support_slope", "φ_B", "rad", "mrad", 4, "Largest slope of the shaft in a radial bearing"),
    quantity("shaft_deflection", "w_max", "m", "um", 4, "Largest deflection of the shaft"),
    quantity("equilibrium_error", "δ_eq", "1", "balance", 2, "Error of the equilibrium of the shaft"),
    quantity("support_station", "z_B", "m", "mm", 6, "Place of a bearing along the shaft"),
    quantity("support_load", "F_B", "N", "kN", 5, "Load across the shaft on a bearing"),
    quantity("support_load_x", "F_Bx", "N", "kN", 5, "Load on a bearing to the right"),
    quantity("support_load_y", "F_By", "N", "kN", 5, "Load on a bearing upward"),
    quantity("support_load_angle", "ψ", "rad", "deg", 4, "Direction of the load on a bearing, from +x"),
    quantity("support_axial_load", "F_Bz", "N", "kN", 5, "Thrust on a bearing, positive along z"),
    quantity("support_slope_x", "φ_Bx", "rad", "mrad", 4, "Slope dx/dz of the shaft in a bearing"),
    quantity("support_slope_y", "φ_By", "rad", "mrad", 4, "Slope dy/dz of the shaft in a bearing"),
    quantity("reaction_1", "R₁", "N", "kN", 5, "Load on the bearing far from the coupling"),
    quantity("reaction_2", "R₂", "N", "kN", 5, "Load on the bearing beside the coupling"),
    quantity("reaction_without_coupling", "R₀", "N", "kN", 5, "Load on either bearing without the coupling"),
    quantity("reaction_angle_1", "θ₁", "rad", "deg", 4, "Direction of R1 from the vertical"),
    quantity("reaction_angle_2", "θ₂", "rad", "deg", 4, "Direction of R2 from the vertical"),
    quantity("coupling_arm", "a", "m", "mm", 5, "Arm of the coupling weight beyond bearing 2"),
)
