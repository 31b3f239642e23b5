"""Statics of shafts."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, quantity

SHAFTS: tuple[Quantity, ...] = (
    quantity("reaction_1", "R₁", "N", "kN", 5, "Load on the bearing far from the coupling"),
    quantity("reaction_2", "R₂", "N", "kN", 5, "Load on the bearing beside the coupling"),
    quantity("reaction_without_coupling", "R₀", "N", "kN", 5, "Load on either bearing without the coupling"),
    quantity("reaction_angle_1", "θ₁", "rad", "deg", 4, "Direction of R1 from the vertical"),
    quantity("reaction_angle_2", "θ₂", "rad", "deg", 4, "Direction of R2 from the vertical"),
    quantity("coupling_arm", "a", "m", "mm", 5, "Arm of the coupling weight beyond bearing 2"),
)
