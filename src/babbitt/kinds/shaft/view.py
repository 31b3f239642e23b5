"""How solved shafts are shown."""

from __future__ import annotations

from dataclasses import replace

from babbitt.report.columns import column_of
from babbitt.report.view import View

__all__ = ["BEAM", "STATICS"]

STATICS = View(
    title="Equilibrium of the rigid shaft",
    columns=(column_of("largest_support_load", 0), column_of("axial_load", 1)),
    sweep=("largest_support_load", "axial_load", "support_slope", "shaft_deflection", "bending_moment"),
)
BEAM = replace(STATICS, title="Stepped beam on its bearings")
