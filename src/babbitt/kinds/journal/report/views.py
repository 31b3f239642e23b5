"""How the solutions of each method of a journal bearing are shown."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from babbitt.core.kind import LazyFunction
from babbitt.core.solution import Solution
from babbitt.kinds.journal.report.citations import (
    film_citations,
    iso7902_citations,
    long_film_citations,
    segment_citations,
)
from babbitt.kinds.journal.report.columns import COLUMNS, OVERVIEW_COLUMNS
from babbitt.kinds.journal.report.key_results import KEY_RESULTS
from babbitt.kinds.journal.report.oil_balance import oil_system_inputs, sentences, tables
from babbitt.kinds.journal.report.one_dimension import OWN_RESULTS
from babbitt.kinds.journal.report.result_rows import supply_rows
from babbitt.report.view import View, lubricant_of

if TYPE_CHECKING:
    from babbitt.report.drawing import Drawing
    from babbitt.report.line import Section

__all__ = ["FILM", "ISO7902", "LONG_FILM", "OIL_BALANCE", "SEGMENTS"]


def _alike(problem: Any) -> Any:
    return replace(problem, name="", given=(), bearing=replace(problem.bearing, relative_clearance=1.0))


def _calculation(solution: Solution) -> tuple[Section, ...]:
    from babbitt.kinds.journal.report.calculation import calculation

    return calculation(solution.problem, solution.result)


def _iso7902_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    from babbitt.kinds.journal.report.iso7902_figures import clearance_range, draw

    return draw(solution.problem, solution.result, clearance_range(solution.problem), image_format)


def _figures_along(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    from babbitt.kinds.journal.report.one_dimension_figures import figures_along_the_film

    return figures_along_the_film(solution.problem, solution.result, image_format)


LEFT_OUT = {
    "angular_span": ("span", "supply_element", "pockets"),
    "expansion_bearing": ("materials.bearing",),
    "expansion_journal": ("materials.journal",),
    "Form of the bore": ("bore", "displacement"),
    "Direction of the load from +x": ("load_angle", "station"),  # on a shaft it follows
    "Character of the load": ("materials.load_character",),
    "Clearance case": ("clearance_cases",),
    "supply_pressure": ("supply.pressure", "supply_pressure"),
    "ambient_temperature": ("cooling.ambient_temperature",),
    "heat_transfer_coefficient": ("cooling.heat_transfer_coefficient", "cooling.air_speed"),
    "cooling_surface": ("cooling.surface", "cooling.housing"),
    "composite_roughness": ("mixed_friction.composite_roughness",),
    "contact_modulus": ("mixed_friction.contact_modulus",),
    "Asperities: η_s β_s σ, σ/β_s": ("mixed_friction.asperity_density", "mixed_friction.asperity_sharpness"),
    "Mass that moves with the journal": ("dynamic_load.moving_mass",),
    "Procedure": ("method",),
    "Characteristics": ("characteristics",),
    "Friction": ("friction",),
    "Flow": ("turbulence",),
    "Viscosity under pressure": ("pressure_viscosity",),
    "Temperature": ("thermal", "effective_temperature"),
    "Bush and housing": ("walls.bush", "walls.housing"),
    "Journal": ("walls.journal",),
    "Where the film breaks up": ("cavitation",),
    "Where the film begins": ("film_start", "grooves", "pockets", "holes"),
    "Grid": ("accuracy",),
    "Discretisation": ("heat_exchange.discretisation",),
    "Ruptured film rubs and exchanges heat": ("heat_exchange.exchange_zone",),
    "Sectors": ("accuracy",),
    "Oil enters": ("heat_exchange.supply_angle",),
    "Nusselt number of the film": ("heat_exchange.nusselt",),
    "Bush": ("heat_exchange.bush",),
    "Along the shaft": ("heat_exchange.shaft_conductance",),
    "Wall": ("segments.compliance", "segments.profile"),
    "Groove": ("segments.groove",),
    "Fresh oil behind the groove": ("groove.mixing_factor",),
    "Gauge pressure in the groove": ("groove.pressure",),
}
"""Inputs that a case may leave out (`babbitt.report.view.View`)."""

COMMON = View(
    title="",
    key_results=tuple(dict.fromkeys((*KEY_RESULTS, *OWN_RESULTS))),
    fed_results=("supply_flow", "total_flow"),
    rows=supply_rows,
    inputs=LazyFunction("babbitt.kinds.journal.report.inputs:journal_inputs"),
    left_out=LEFT_OUT,
    columns=COLUMNS,
    alike=_alike,
    oil=lubricant_of,
    picture=LazyFunction("babbitt.kinds.journal.report.picture:round_picture"),
)
"""What the views of all methods share."""

ISO7902 = replace(
    COMMON,
    title="ISO 7902",
    sections=_calculation,
    figures=_iso7902_figures,
    report_figures=_iso7902_figures,
    overview=OVERVIEW_COLUMNS,
    citations=iso7902_citations,
)

FILM = replace(
    COMMON,
    title="Film in two dimensions",
    figures=LazyFunction("babbitt.kinds.journal.report.film_figures:all_figures"),
    report_figures=LazyFunction("babbitt.kinds.journal.report.film_figures:report_figures"),
    fields=LazyFunction("babbitt.kinds.journal.report.film_fields:film_fields"),
    picture=LazyFunction("babbitt.kinds.journal.report.picture:film_picture"),
    citations=film_citations,
)

LONG_FILM = replace(
    COMMON,
    title="Long film with heat exchange",
    figures=_figures_along,
    report_figures=_figures_along,
    citations=long_film_citations,
)

OIL_BALANCE = View(
    title="Oil balance of the machine",
    inputs=oil_system_inputs,
    tables=tables,
    terminal_tables=tables,
    sentences=sentences,
    in_machine_table=False,
)

SEGMENTS = replace(
    COMMON,
    title="Heat balance by segments",
    figures=_figures_along,
    report_figures=_figures_along,
    citations=segment_citations,
)
