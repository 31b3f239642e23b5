"""Bore, feeds and choices of a film in words."""

from __future__ import annotations

import math

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.film.bore import Bore, LobedBore, MeasuredBore, PressureDamBore, TaperedBore, WornBore
from babbitt.kinds.journal.film.changing_load import ChangingLoad, RotatingLoad, TabulatedLoad
from babbitt.kinds.journal.film.heat_model import AxialTemperature, HeatModel
from babbitt.kinds.journal.film.model import FeedSize, FilmBearing, OilUnderPressure
from babbitt.reynolds.heat.heat_model import ConductingWalls
from babbitt.reynolds.model import Cavitation, FilmStart, Step
from babbitt.reynolds.oil.turbulence import TurbulenceLaw

CAVITATION = {
    Cavitation.MASS_CONSERVING: "the oil is conserved (Jakobsson, Floberg, Olsson)",
    Cavitation.REYNOLDS: "pressure and its gradient vanish (Reynolds, Swift-Stieber)",
    Cavitation.HALF_SOMMERFELD: "suctions of the full film count as nothing (half-Sommerfeld, Gumbel)",
}

FILM_START = {
    FilmStart.GROOVE: "at the grooves, pockets and holes",
    FilmStart.PERIODIC: "at the grooves, pockets and holes",
    FilmStart.WIDEST_GAP: "at the widest gap, at ambient pressure",
}


THINNEST_RING = 2e-5
"""m; a thinner ring stands for a contact."""


def describe_heat(heat: HeatModel | None, temperature: float | None) -> str:
    """Say how the temperature of the film is found."""
    if heat is None:
        return "one for the whole film, from the heat balance" if temperature is None else "one, prescribed"
    means = heat.axial_temperature is AxialTemperature.MEAN
    along = "means over the width" if means else "resolved along the width"
    walls = "walls that take no heat" if heat.walls is None else "bush and journal that conduct"
    return f"around the journal and across the gap, {along}; {walls}"


def describe_flow(law: TurbulenceLaw | None) -> str:
    """Say whether the film is laminar, and after whom it is turbulent."""
    return "laminar" if law is None else f"turbulent after {law.name} ({law.source})"


def describe_pressure(oil: OilUnderPressure | None) -> str:
    """Say how the viscosity grows with the pressure."""
    if oil is None:
        return "constant"
    return f"after {oil.law.value.capitalize()}, {oil.coefficient * 1e9:.4g} 1/GPa at ambient pressure"


def describe_bush(walls: ConductingWalls) -> str:
    """Say what the bush and its surroundings are, from the bore outwards."""
    bush = walls.bush
    rings = "; ".join(
        f"{2e3 * outer:.5g} mm, {conductivity:.4g} W/(m K)"
        for inner, outer, conductivity in zip(bush.radii[:-1], bush.radii[1:], bush.conductivities, strict=True)
        if outer - inner > THINNEST_RING
    )
    outside = f"{bush.heat_transfer_coefficient:.4g} W/(m² K) to {bush.ambient_temperature - ZERO_CELSIUS:.4g} °C"
    return f"rings up to {rings}; outside {outside}"


def describe_journal(walls: ConductingWalls) -> str:
    """Say how the journal finds its temperature."""
    journal = walls.journal
    if journal.temperature is not None:
        return f"held at {journal.temperature - ZERO_CELSIUS:.4g} °C"
    if journal.shaft_conductance == 0.0:
        return "in balance with the film alone"
    ambient = journal.ambient_temperature - ZERO_CELSIUS
    return f"{journal.shaft_conductance:.4g} W/K along the shaft to {ambient:.4g} °C"


def describe_start(bearing: FilmBearing) -> str:
    """Say where the film begins."""
    if bearing.film_start is FilmStart.PERIODIC and not bearing.feeds:
        return "nowhere: it closes around the journal, and nothing feeds it"
    return FILM_START[bearing.film_start]


def describe_changing_load(load: ChangingLoad) -> str:
    """Say what a changing load is."""
    match load:
        case RotatingLoad():
            speed = f"{load.speed_ratio:.4g} times the speed of the journal"
            return f"{1e-3 * load.magnitude:.4g} kN rotating at {speed}, from {math.degrees(load.phase):.4g}°"
        case TabulatedLoad():
            return f"table of {len(load.angles)} points over {math.degrees(load.cycle):.4g}°"
        case _:
            return "as given"


def describe_bore(bore: Bore) -> str:
    """Say what form a bore has."""
    match bore:
        case LobedBore():
            return f"lobes, preload {bore.preload:.3g}, narrowest at {bore.offset:.3g} of the lobe"
        case TaperedBore():
            return f"lands tapered by {1e6 * bore.depth:.4g} µm over {bore.share:.3g} of their length"
        case PressureDamBore():
            said = (
                f"round with a recess {1e6 * bore.depth:.4g} µm deep, {1e3 * bore.width:.4g} mm wide and "
                f"{math.degrees(bore.extent):.4g}° long that ends in a dam at {math.degrees(bore.angle):.4g}°"
            )
            return said if bore.relief is None else f"{said}; relief track: {describe_step(bore.relief)}"
        case WornBore():
            return f"worn {1e6 * bore.depth:.4g} µm deep at {math.degrees(bore.angle):.4g}°"
        case MeasuredBore():
            return f"measured at {len(bore.departures)} points"
        case _:
            return "round"


def describe_step(step: Step) -> str:
    """Say where a step is and how deep it lies."""
    where = f"at {math.degrees(math.remainder(step.centre_angle, 2.0 * math.pi)):.4g}°"
    if step.axial_centre:
        where += f", {1e3 * step.axial_centre:.4g} mm from the mid-plane"
    size = f"{math.degrees(step.extent):.4g}° long, {1e3 * step.axial_length:.4g} mm wide"
    return f"{where}, {size}, {1e6 * step.depth:.4g} µm deep"


def describe_feed(feed: FeedSize) -> tuple[str, str]:
    """Say what a feed is, and where it is."""
    extent = math.degrees(feed.extent)
    where = f"at {math.degrees(math.remainder(feed.angle, 2.0 * math.pi)):.4g}°, {extent:.3g}° long"
    if feed.is_closed:
        where += ", closed"
    if feed.pressure is not None:
        where += f", {1e-3 * feed.pressure:.4g} kPa"
    if feed.width is None:
        return ("Line of supply" if feed.extent == 0.0 else "Axial groove"), f"{where}, as wide as the bearing"
    if feed.axial_position:
        where += f", {1e3 * feed.axial_position:.4g} mm from the mid-plane"
    if extent > 359.9:
        return "Circumferential groove", f"{1e3 * feed.width:.4g} mm wide"
    return "Pocket or hole", f"{where}, {1e3 * feed.width:.4g} mm wide"
