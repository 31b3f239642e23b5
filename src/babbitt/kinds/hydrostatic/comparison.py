"""A hydrostatic bearing by its film and by closed forms."""

from __future__ import annotations

from collections.abc import Mapping

from babbitt.core.notices import InputError
from babbitt.core.quantities import AXES
from babbitt.core.solution import Calculation, Method
from babbitt.kinds.hydrostatic.case.hydrostatic_file import HydrostaticFile
from babbitt.kinds.hydrostatic.case.jacking import JackingPocketCase
from babbitt.kinds.hydrostatic.methods import JACKING_METHODS, METHODS
from babbitt.study.comparison import Comparison, Variant

__all__ = ["compare", "compare_jacking"]

REMARKS = {
    "film": "sees corners, interaction and rupture; assumes one viscosity for the whole film",
    "quick": "closed forms and lumped lands; neglects corners of unequal lands and squeeze between recesses",
}
JACKING_REMARKS = {
    "film": "sees how far the pressure spreads around the bore, where the gap hardly opens beside the pocket",
    "quick": "counts pressure on the pocket and half of its axial lands and none around the bore: a smaller area, "
    "so that the same load seems to need more pressure, flow and power",
}
COMPARED = (
    "load",
    "gap",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "mean_pressure_ratio",
    "total_flow",
    "pumping_power",
    "friction_power",
    "temperature_rise",
    "effective_area",
    "gap_stiffness",
    "gap_damping",
    "least_tilt_stiffness",
    *(f"{name}_{axes}" for name in ("stiffness", "damping") for axes in AXES),
    "critical_mass",
    "whirl_frequency_ratio",
    "threshold_speed",
    "load_capacity",
    "breakaway_pressure",
    "lying_pressure",
    "pocket_pressure",
)
"""What is put side by side."""


def compare(case: HydrostaticFile) -> tuple[Comparison, ...]:
    """Solve a pad, ring or recessed journal bearing by both methods."""
    return (_compared(case.calculations()[0], REMARKS, METHODS),)


def compare_jacking(case: JackingPocketCase) -> tuple[Comparison, ...]:
    """Solve jacking pockets by both methods."""
    return (_compared(case.calculations()[0], JACKING_REMARKS, JACKING_METHODS),)


def _compared(asked: Calculation, remarks: Mapping[str, str], methods: Mapping[str, Method]) -> Comparison:
    own = asked.method.name
    found, left_out = [Variant(own, remarks[own], asked.method.solve_one(asked.problem))], ""
    for other in remarks.keys() - {own}:
        try:
            found.append(Variant(other, remarks[other], methods[other].solve_one(asked.problem)))
        except InputError as error:  # closed forms do not reach every shape
            left_out = f"{other} is left out: {error.message}"
    return Comparison(asked.problem.name, tuple(found), COMPARED, left_out)
