"""What a tilting-pad bearing was computed from."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import PrescribedPosition
from babbitt.kinds.tilting_pad_journal.case.pivots import written_pivot
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.report.inputs import InputGroup, Row, metal_rows, named_row, oil_rows, surface_rows
from babbitt.reynolds.tilting_pads.model import TiltingPad
from babbitt.reynolds.tilting_pads.pedestal import Pedestal

__all__ = ["pad_inputs"]


def pad_inputs(case: PadCase) -> Iterator[InputGroup]:
    """Groups of inputs."""
    yield InputGroup("Bearing", tuple(_bearing(case)))
    yield InputGroup("Operation", tuple(_operation(case)))
    yield InputGroup("Lubricant", (*oil_rows(case.lubricant), *_oil(case)))
    yield InputGroup("Surfaces", tuple(surface_rows(case.bearing.surfaces)))
    yield InputGroup("Material", tuple(metal_rows(case.bearing.metal)))


def _bearing(case: PadCase) -> Iterator[Row]:
    bearing = case.bearing
    yield named_row("diameter", bearing.diameter, "Diameter of the journal")
    yield Row("Angles of the pivots", _angles(bearing.pads), None, "°")
    for label, unit, of in (
        ("Angle of a pad", "°", lambda pad: f"{math.degrees(pad.extent):.6g}"),
        ("Width of a pad", "mm", lambda pad: f"{1e3 * (pad.width or bearing.width):.6g}"),
        ("Thickness of a pad", "mm", lambda pad: f"{1e3 * pad.thickness:.6g}"),
        ("Machined clearance", "µm", lambda pad: f"{1e6 * pad.clearance:.5g}"),
        ("Assembled clearance", "µm", lambda pad: f"{1e6 * pad.assembled_clearance:.5g}"),
        ("Preload, 1 − assembled/machined clearance", "", lambda pad: f"{pad.preload:.4g}"),
        ("Pivot", "", written_pivot),
        ("Pivot, from the leading edge", "%", lambda pad: f"{100.0 * pad.pivot_fraction:.4g}"),
        ("Mass of a pad", "kg", lambda pad: f"{pad.mass:.4g}"),
        ("Inertia of a pad about its pivot", "kg m²", lambda pad: f"{pad.inertia:.4g}"),
    ):
        yield from _of_pads(label, unit, bearing.pads, of)
    if case.thermal.is_resolved:
        label = "Probe, from the leading edge"
        yield from _of_pads(label, "%", bearing.pads, lambda pad: f"{100.0 * pad.probe_fraction:.4g}")
    if any(pad.bends for pad in bearing.pads):
        label = "Stiffness against bending"
        yield from _of_pads(label, "MN/m", bearing.pads, lambda pad: f"{1e-6 * pad.bending_stiffness:.4g}")
    if bearing.groove_pressure:
        yield Row("Pressure between the pads", f"{1e-3 * bearing.groove_pressure:.4g}", None, "kPa")


def _angles(pads: tuple[TiltingPad, ...]) -> str:
    return ", ".join(f"{math.degrees(pad.pivot_angle):.5g}" for pad in pads)


def _of_pads(
    label: str, unit: str, pads: tuple[TiltingPad, ...], of: Callable[[TiltingPad], str]
) -> Iterator[Row]:
    """One row where all pads are alike, else one for every value with the pads that have it."""
    whose: dict[str, list[str]] = {}
    for number, pad in enumerate(pads, 1):
        whose.setdefault(of(pad), []).append(str(number))
    for value, numbers in whose.items():
        which = "" if len(whose) == 1 else f", pad {', '.join(numbers)}"
        yield Row(f"{label}{which}", value, None, unit)


def _operation(case: PadCase) -> Iterator[Row]:
    if isinstance(case.duty, PrescribedPosition):
        yield named_row("journal_x", case.duty.x, "Given, journal centre, to the right of the bearing centre")
        yield named_row("journal_y", case.duty.y, "Given, journal centre, above the bearing centre")
    else:
        yield named_row("load", case.duty.load)
        yield named_row("load_angle", case.load_angle, "Direction of the load, counter-clockwise from +x")
    yield named_row("angular_speed", case.journal_speed)
    if case.rotor_mass is not None:
        yield named_row("rotor_mass", case.rotor_mass)
    if case.shaft_stiffness is not None:
        yield named_row("shaft_stiffness", case.shaft_stiffness)
    if case.anticipated_cross_coupling is not None:
        yield named_row("anticipated_cross_coupling", case.anticipated_cross_coupling)
    if case.pedestal is not None:
        yield from _pedestal(case.pedestal)
    yield Row("Whirl ratios", ", ".join(f"{ratio:g}" for ratio in case.whirl_ratios))


def _pedestal(pedestal: Pedestal) -> Iterator[Row]:
    for axis, stiffness, damping in zip("xy", pedestal.stiffness, pedestal.damping, strict=True):
        yield Row(f"Stiffness of the pedestal along {axis}", f"{1e-6 * stiffness:.4g}", None, "MN/m")
        yield Row(f"Damping of the pedestal along {axis}", f"{1e-3 * damping:.4g}", None, "kN s/m")
    yield Row("Mass on the pedestal, without the pads", f"{pedestal.mass:.4g}", None, "kg")


def _oil(case: PadCase) -> Iterator[Row]:
    supply = case.oil_supply
    if supply is not None:
        yield named_row("supply_temperature", supply.temperature)
        if supply.flow is not None:
            yield named_row("given_flow", supply.flow)
    yield Row("Flow", "laminar" if case.turbulence is None else f"turbulent after {case.turbulence.name}")
    yield Row("Feed", case.feed.kind.replace("_", " "))
    yield Row("Hot oil carried over", f"{100.0 * case.feed.carry_over:.4g}", None, "%")
    if case.effective_temperature is not None:
        yield named_row("effective_temperature", case.effective_temperature, "Temperature of the films, given")
    elif not case.thermal.is_resolved:
        yield Row("Temperature of the films", "one, from friction and fresh oil (global)")
    else:
        yield from _heat(case)


def _own_materials(case: PadCase) -> Iterator[Row]:
    """What single pads are made of."""
    for number, own in enumerate(case.heat.materials, 1):
        for label, value, unit in (
            ("Conductivity", own.conductivity, "W/(m K)"),
            ("Elastic modulus", None if own.elastic_modulus is None else 1e-9 * own.elastic_modulus, "GPa"),
            ("Expansion", None if own.thermal_expansion is None else 1e6 * own.thermal_expansion, "10⁻⁶/K"),
            ("Poisson's ratio", own.poisson_ratio, ""),
        ):
            if value is not None:
                yield Row(f"{label} of pad {number}", f"{value:.4g}", None, unit)


def _heat(case: PadCase) -> Iterator[Row]:
    """Walls and deformation of films with their own temperatures."""
    heat = case.heat
    yield Row("Temperature of the films", f"their own ({case.thermal.value})")
    if heat.journal is not None:
        at = heat.journal.temperature
        known = "one, from its heat balance" if at is None else f"{at - ZERO_CELSIUS:.4g} °C"
        yield Row("Temperature of the journal", known)
        if heat.journal.shaft_conductance:
            yield Row("Conductance along the shaft", f"{heat.journal.shaft_conductance:.4g}", None, "W/K")
    if heat.walls is not None:
        yield Row("Conductivity of the pads", f"{heat.walls.conductivity:.4g}", None, "W/(m K)")
        yield Row("Heat transfer on backs", f"{heat.walls.back_coefficient:.4g}", None, "W/(m² K)")
        yield Row("Heat transfer on edges", f"{heat.walls.edge_coefficient:.4g}", None, "W/(m² K)")
        if heat.walls.back_temperature is not None:
            yield named_row("ambient_temperature", heat.walls.back_temperature, "Oil behind the pads")
        else:
            yield Row("Oil behind the pads", "as warm as the fresh oil, assumed")
    if heat.bending is not None:
        yield Row("Elastic modulus of the pads", f"{1e-9 * heat.bending.elastic_modulus:.4g}", None, "GPa")
        if heat.bending.poisson_ratio:
            yield Row("Poisson's ratio of the pads, plates", f"{heat.bending.poisson_ratio:.4g}")
    yield from _own_materials(case)
    if heat.growth is not None:
        growth = heat.growth
        yield Row("Clearances hold at", f"{growth.reference_temperature - ZERO_CELSIUS:.4g}", None, "°C")
        expansions = (growth.pad_expansion, growth.journal_expansion, growth.housing_expansion)
        parts = ", ".join(f"{1e6 * one:.4g}" for one in expansions)
        yield Row("Expansion of pads, journal, housing", parts, None, "10⁻⁶/K")
        if growth.housing_temperature is not None:
            yield Row("Temperature of the housing", f"{growth.housing_temperature - ZERO_CELSIUS:.4g}", None, "°C")
        else:
            yield Row("Temperature of the housing", "that of the fresh oil, assumed")
