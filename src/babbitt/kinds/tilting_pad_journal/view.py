"""How the solutions of tilting-pad bearings are shown."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.core.kind import LazyFunction
from babbitt.kinds.tilting_pad_journal.report.columns import COLUMNS
from babbitt.report.citations import JOHNSON, REYNOLDS
from babbitt.report.view import View, lubricant_of

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.model import PadCase

__all__ = ["FILM"]

LUND = "J. W. Lund, Spring and damping coefficients for the tilting-pad journal bearing, Trans. ASLE 7 (1964) 342"
API_617 = (
    "API Standard 617, Axial and Centrifugal Compressors and Expander-compressors, stability analysis, level I"
)
ALLAIRE = (
    "P. E. Allaire, J. K. Parsell, L. E. Barrett, A pad perturbation method for the dynamic coefficients of "
    "tilting-pad journal bearings, Wear 72 (1981) 29 (the same for several motions of a pad)"
)
FILLON = (
    "M. Fillon, J.-C. Bligoud, J. Frene, Experimental study of tilting-pad journal bearings, ASME J. Tribology "
    "114 (1992) 579 (what temperatures are compared with: `babbitt validate fillon_1992`)"
)
DOWSON = (
    "D. Dowson, A generalized Reynolds equation for fluid-film lubrication, Int. J. Mech. Sci. 4 (1962) 159 "
    "(viscosity that varies across the film)"
)
PATANKAR = "S. V. Patankar, Numerical Heat Transfer and Fluid Flow (1980), 5.2 (scheme of the energy equation)"
TIMOSHENKO = "S. Timoshenko, Strength of Materials II (1956), thin curved bars (bending of the pads)"
CARRY_OVER = (
    "Babbitt, theory of tilting pads, section Heat: shares of hot oil that are carried over by feed, heat "
    "transfer at backs and edges, and growth of pads, journal and housing are assumptions without published source"
)
PALMGREN = (
    "A. Palmgren, Ball and Roller Bearing Engineering (1959); T. A. Harris, Rolling Bearing Analysis: empirical "
    "displacement of a steel roller on its raceway, 4.36e-7 Q^0.9/l^0.8 in inches and pounds (rocker pivots)"
)

KEY_RESULTS = (
    "load",
    "specific_load",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "maximum_pressure",
    "largest_pad_load",
    "largest_specific_load",
    "largest_contact_pressure",
    "loaded_pads",
    "least_pad_margin",
    "preload",
    "assembled_clearance",
    "largest_pad_clearance",
    "friction_power",
    "total_flow",
    "surplus_flow",
    "effective_temperature",
    "maximum_temperature",
    "probe_temperature",
    "journal_temperature",
    "hottest_trailing_temperature",
    "trailing_temperature",
    "outlet_temperature",
    "heat_to_pads",
    "running_clearance",
    "growth_share",
    "effective_viscosity",
    "film_reynolds_number",
    "turbulent_share",
    "stiffness_xx",
    "stiffness_xy",
    "stiffness_yx",
    "stiffness_yy",
    "damping_xx",
    "damping_xy",
    "damping_yx",
    "damping_yy",
    "fit_error",
    "log_decrement",
    "pad_log_decrement",
    "log_decrement_forward",
    "log_decrement_backward",
    "whirl_frequency_forward",
    "whirl_frequency_backward",
    "threshold_mass",
    "threshold_frequency",
    "critical_cross_coupling",
    "cross_coupling_ratio",
    "log_decrement_anticipated",
    "synchronous_log_decrement",
    "synchronous_critical_cross_coupling",
    "synchronous_cross_coupling_ratio",
    "synchronous_log_decrement_anticipated",
    "pedestal_x",
    "pedestal_y",
)
"""Results at the head of a report."""

SWEEP = (
    "minimum_film_thickness",
    "friction_power",
    "maximum_temperature",
    "probe_temperature",
    "trailing_temperature",
    "total_flow",
    "stiffness_xx",
    "stiffness_yy",
    "damping_xx",
    "damping_yy",
    "log_decrement",
    "log_decrement_anticipated",
    "cross_coupling_ratio",
    "loaded_pads",
)
"""Results of a sweep, what matters most first."""


def _alike(problem: PadCase) -> PadCase:
    pads = tuple(replace(pad, clearance=1.0, assembled_clearance=1.0) for pad in problem.bearing.pads)
    bearing = replace(problem.bearing, pads=pads)
    return replace(problem, name="", given=(), assumptions=(), warnings=(), bearing=bearing)


def _citations(problem: PadCase) -> Iterable[str]:
    from babbitt.kinds.tilting_pad_journal.model import Thermal
    from babbitt.reynolds.tilting_pads.pivots import HertzContact, RockerContact

    yield REYNOLDS
    yield LUND
    if problem.anticipated_cross_coupling is not None:
        yield API_617
    yield ALLAIRE
    if problem.thermal.is_resolved:
        yield DOWSON
        yield PATANKAR
        yield FILLON
    if problem.heat.bending is not None or any(pad.bends for pad in problem.bearing.pads):
        yield TIMOSHENKO
    if problem.turbulence is not None:
        yield problem.turbulence.source
    if problem.thermal is not Thermal.ISOTHERMAL:
        yield CARRY_OVER
    if any(isinstance(pad.pivot, HertzContact) for pad in problem.bearing.pads):
        yield JOHNSON
    if any(isinstance(pad.pivot, RockerContact) for pad in problem.bearing.pads):
        yield PALMGREN


LEFT_OUT = {
    "Pivot": ("pads.pivot", "each.pivot"),
    "Pivot, from the leading edge": ("pivot.fraction",),
    "Mass of a pad": ("pads.mass", "each.mass"),
    "Inertia of a pad about its pivot": ("pads.inertia", "each.inertia"),
    "Probe, from the leading edge": ("pads.probe_fraction", "each.probe_fraction"),
    "Pressure between the pads": ("groove_pressure",),
    "Whirl ratios": ("whirl_ratios",),
    "Mass on the pedestal, without the pads": ("pedestal.mass",),
    "Flow": ("turbulence",),
    "Feed": ("feed",),
    "Hot oil carried over": ("carry_over",),
    "Temperature of the films": ("thermal",),
    "Temperature of the journal": ("walls.journal.temperature",),
    "Conductance along the shaft": ("walls.journal.shaft_conductance",),
    "Conductivity of the pads": ("walls.pads.conductivity",),
    "Heat transfer on backs": ("walls.pads.heat_transfer_coefficient",),
    "Heat transfer on edges": ("walls.pads.edge_coefficient",),
    "ambient_temperature": ("walls.pads.temperature",),
    "Elastic modulus of the pads": ("materials.pads",),
    "Poisson's ratio of the pads, plates": ("materials.pads.poisson_ratio",),
    "Clearances hold at": ("reference_temperature",),
    "Expansion of pads, journal, housing": ("materials.pads", "materials.journal", "materials.housing"),
    "Temperature of the housing": ("walls.housing.temperature",),
}
"""Inputs that a case may leave out (`babbitt.report.view.View`)."""

FIGURES = LazyFunction("babbitt.kinds.tilting_pad_journal.report.figures:pad_figures")

FILM = View(
    title="Tilting pads, films in two dimensions",
    key_results=KEY_RESULTS,
    fed_results=("total_flow",),
    rows=LazyFunction("babbitt.kinds.tilting_pad_journal.report.tables:rows_of_clearances"),
    inputs=LazyFunction("babbitt.kinds.tilting_pad_journal.report.inputs:pad_inputs"),
    left_out=LEFT_OUT,
    sections=LazyFunction("babbitt.kinds.tilting_pad_journal.report.calculation:pad_calculation"),
    figures=FIGURES,
    report_figures=FIGURES,
    tables=LazyFunction("babbitt.kinds.tilting_pad_journal.report.tables:tables"),
    terminal_tables=LazyFunction("babbitt.kinds.tilting_pad_journal.report.tables:sensitivity_tables"),
    picture=LazyFunction("babbitt.kinds.tilting_pad_journal.report.picture:pad_picture"),
    columns=COLUMNS,
    sweep=SWEEP,
    alike=_alike,
    citations=_citations,
    oil=lubricant_of,
    fields=LazyFunction("babbitt.kinds.tilting_pad_journal.report.fields:pad_fields"),
)
