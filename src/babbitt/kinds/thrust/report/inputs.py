"""What a thrust bearing was computed from: its load, speed, oil and metal; the case file says the other inputs."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.thrust.design import PrescribedFilm, PrescribedThrust, ThrustDesign
from babbitt.kinds.thrust.report.words import OF_THRUST
from babbitt.report.inputs import InputGroup, Row, metal_rows, named_row, oil_rows

__all__ = ["thrust_inputs"]


def thrust_inputs(design: ThrustDesign) -> Iterator[InputGroup]:
    """Groups of inputs of a thrust bearing."""
    yield InputGroup("Operation", tuple(_operation(design)))
    yield InputGroup("Lubricant", (*oil_rows(design.lubricant), *_oil(design)))
    yield InputGroup("Material", tuple(metal_rows(design.temperatures.given_metal)))


def _operation(design: ThrustDesign) -> Iterator[Row]:
    match design.duty:
        case PrescribedThrust(thrust):
            yield named_row("load", thrust, OF_THRUST["load"])
        case PrescribedFilm(film):
            yield Row("Prescribed mean film at the pivots", f"{1e6 * film:.4g}", None, "µm")
    yield named_row("angular_speed", design.speed, OF_THRUST["angular_speed"])


def _oil(design: ThrustDesign) -> Iterator[Row]:
    oil = design.oil
    if oil.supply_temperature is not None:
        yield named_row("supply_temperature", oil.supply_temperature)
        yield Row("Hot oil carried over", f"{100.0 * oil.carry_over:.4g}", None, "%")
        across = ", across the pads" if oil.resolved else ""
        yield Row(
            "Temperature of the films",
            f"varies along the pads{across} and across the gap (adiabatic)"
            if oil.own_temperatures
            else "one (global)",
        )
    if oil.effective_temperature is not None:
        yield named_row("effective_temperature", oil.effective_temperature, "Prescribed effective temperature")
