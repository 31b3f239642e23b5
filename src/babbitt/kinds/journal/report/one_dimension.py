"""The methods of one dimension in words: names, results worth a place on paper, choices of a case."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.grooved_long_bearing.model import GrooveKind, SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import (
    Discretisation,
    ExchangeZone,
    LongFilmCase,
    NusseltLaw,
)

OWN_RESULTS = (
    "supply_angle",
    "rupture_angle",
    "narrow_zone",
    "rupture_temperature",
    "film_flow",
    "flow_inconsistency",
    "heat_to_surroundings",
    "heat_to_shaft",
    "load_along_eccentricity",
    "load_across_eccentricity",
    "relative_load",
    "mean_temperature_load_ratio",
    "mean_temperature_relative_load_ratio",
    "groove_angle_from_load",
    "groove_angle_from_gap",
    "groove_pressure",
    "groove_side_flow",
    "groove_warm_flow",
    "groove_heat",
    *(
        f"segment_{place}_{name}"
        for place in (1, 2)
        for name in ("flow", "power", "inlet_temperature", "mean_temperature", "outlet_temperature")
    ),
    "groove_load_ratio",
    "ungrooved_specific_load",
    "ungrooved_outlet_temperature",
    "cut_specific_load",
    "cut_outlet_temperature",
    "ungrooved_eccentricity_at_load",
    "ungrooved_film_at_load",
    "ungrooved_outlet_at_load",
    "cut_outlet_at_load",
)
"""Results of these methods in addition to those that every film has."""

DISCRETISATION = {
    Discretisation.CONSISTENT: "divergence form; the same flow passes every section",
    Discretisation.PUBLISHED_MEAN: "as published, heat carried by the mean flow; does not conserve the flow",
    Discretisation.PUBLISHED_LITERAL: "as published, heat carried by the local flow; does not conserve the flow",
}

EXCHANGE_ZONE = {
    ExchangeZone.LIQUID_FRACTION: "by the share of the gap that its oil fills",
    ExchangeZone.ALL_AROUND: "as if it were full",
    ExchangeZone.FILM: "not at all",
}

GROOVE = {GrooveKind.THROUGH: "open at both ends, or fed", GrooveKind.BLIND: "closed at its ends"}


def describe(case: LongFilmCase | SegmentCase) -> Iterator[tuple[str, str]]:
    """Say what a case chooses: labels and words."""
    if isinstance(case, LongFilmCase):
        yield from _of_long_film(case)
    else:
        yield from _of_segments(case)


def _of_long_film(case: LongFilmCase) -> Iterator[tuple[str, str]]:
    exchange = case.exchange
    yield "Film", "infinitely long, laminar, one temperature across the gap; rupture by Reynolds' condition"
    yield "Discretisation", DISCRETISATION[case.discretisation]
    yield "Ruptured film rubs and exchanges heat", EXCHANGE_ZONE[case.film.zone]
    yield "Oil enters", f"{math.degrees(case.supply_angle):.4g}° from the narrowest gap with the rotation"
    yield "Sectors", str(case.cells)
    if isinstance(exchange.nusselt, NusseltLaw):
        law = exchange.nusselt
        power = f" (Pe h/D)^{law.exponent:.4g}" if law.exponent else ""
        yield "Nusselt number of the film", f"{law.coefficient:.4g}{power}"
    if exchange.bush is None:
        yield "Bush", "adiabatic"
    else:
        bush = exchange.bush
        yield "Bush", f"outside diameter {1e3 * bush.outer_diameter:.5g} mm, {bush.conductivity:.4g} W/(m K)"
        yield "From the bush to the surroundings", f"{bush.ambient_coefficient:.4g} W/(m² K)"
    yield "Along the shaft", f"{exchange.shaft_conductance:.4g} W/K"
    if exchange.ambient_temperature is not None:
        yield "Surroundings", f"{exchange.ambient_temperature - ZERO_CELSIUS:.4g} °C"


def _of_segments(case: SegmentCase) -> Iterator[tuple[str, str]]:
    yield "Film", "infinitely long, laminar, one mean temperature for each segment, adiabatic walls"
    wall = f"yields by {1e12 * case.compliance:.4g} µm/MPa" if case.compliance else "rigid"
    yield "Wall", "as given by the film thickness around the bearing" if case.profile else wall
    groove = case.groove
    if groove is None:
        yield "Groove", "none"
        return
    origin = "load line" if groove.at_place_in_bush else "widest gap"
    place = f"at {math.degrees(groove.angle):.4g}° from the {origin}, {1e3 * groove.width:.4g} mm wide"
    yield "Groove", f"{place}, {GROOVE[groove.kind]}"
    if groove.kind is GrooveKind.THROUGH:
        yield "Fresh oil behind the groove", f"{groove.mixing_factor:.3g} of what enters"
        yield "Gauge pressure in the groove", f"{1e-6 * groove.pressure:.4g} MPa"
