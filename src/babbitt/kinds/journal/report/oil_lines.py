"""Lines of the calculation that give density and viscosity of the oil at the effective temperature."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants import (
    AstmD341,
    ConstantViscosity,
    Exponential,
    LinearProperty,
    PowerLaw,
    ShiftedLaw,
    ViscosityKind,
    Vogel,
    Walther,
)
from babbitt.report.line import Line
from babbitt.report.worksheet import Worksheet

if TYPE_CHECKING:
    from babbitt.kinds.journal.iso7902.model import DesignCase

_DOUBLE_LOGARITHM = "walther_intercept - walther_slope * lg(absolute_temperature)"


def oil_lines(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    """Density, kinematic and dynamic viscosity, and heat capacity per volume."""
    law = case.lubricant.viscosity_law
    yield from _density(case, sheet)
    yield from _viscosity(case, sheet)
    if law.kind is ViscosityKind.KINEMATIC:
        yield sheet.line("effective_viscosity", "effective_kinematic_viscosity * density")
    else:
        yield sheet.line("effective_kinematic_viscosity", "effective_viscosity / density")
    if case.lubricant.fixed_volumetric_heat_capacity is not None:
        yield sheet.given("volumetric_heat_capacity", "constant, as usual for the design check")
    else:
        yield sheet.read("volumetric_heat_capacity", "effective_temperature", remark="density times specific heat")


def _density(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    law = case.lubricant.density_law
    line, offset = (law.reference, law.offset) if isinstance(law, ShiftedLaw) else (law, 0.0)
    if isinstance(line, LinearProperty):
        sheet.note(
            reference_density=line.reference_value + offset,
            density_slope=line.slope,
            reference_temperature=line.reference_temperature - ZERO_CELSIUS,
        )
        yield sheet.given("reference_temperature")
        yield sheet.given("reference_density", "of the lubricant")
        yield sheet.given("density_slope", "of the lubricant")
        yield sheet.line(
            "density", "reference_density + density_slope * (effective_temperature - reference_temperature)"
        )
    else:
        yield sheet.read("density", "effective_temperature", remark="density law of the lubricant")


def _viscosity(case: DesignCase, sheet: Worksheet) -> Iterator[Line]:
    law = case.lubricant.viscosity_law
    kinematic = law.kind is ViscosityKind.KINEMATIC
    found = "effective_kinematic_viscosity" if kinematic else "effective_viscosity"
    match law:
        case Walther() | AstmD341():
            sheet.note(walther_intercept=law.intercept, walther_slope=law.slope)
            through = (
                ""
                if isinstance(law, AstmD341)
                else "of lg lg(ν + a_W) = A_W − B_W lg(T), ν in mm²/s, by the viscosities of the lubricant"
            )
            yield sheet.given("walther_intercept", through)
            yield sheet.given("walther_slope")
            yield sheet.line("absolute_temperature", "effective_temperature + 273.15")
            yield sheet.line("double_logarithm", _DOUBLE_LOGARITHM, "Walther, ASTM D341")
            if isinstance(law, Walther):
                sheet.note(walther_additive=law.additive)
                yield sheet.line("kinematic_viscosity_number", "10**10**double_logarithm - walther_additive")
                yield sheet.line(found, "kinematic_viscosity_number * 1e-6")
            else:
                remark = "ν + 0.7 + exp(−1.47 − 1.84 ν − 0.51 ν²) = 10^10^W, ν in mm²/s"
                yield sheet.read(found, "double_logarithm", remark=remark)
        case Vogel():
            sheet.note(vogel_factor=law.factor, vogel_activation=law.activation, vogel_pole=law.pole)
            yield sheet.line("absolute_temperature", "effective_temperature + 273.15")
            yield sheet.line(
                found, "vogel_factor * exp(vogel_activation / (absolute_temperature - vogel_pole))", "Vogel"
            )
        case Exponential():
            sheet.note(
                reference_viscosity=law.reference_viscosity,
                temperature_coefficient=law.temperature_coefficient,
                reference_temperature=law.reference_temperature - ZERO_CELSIUS,
            )
            yield sheet.line(
                found,
                "reference_viscosity * "
                "exp(-(temperature_coefficient * (effective_temperature - reference_temperature)))",
                "exponential law",
            )
        case PowerLaw():
            sheet.note(viscosity_at_50=law.viscosity_at_50, viscosity_exponent=law.exponent)
            yield sheet.line(
                found, "viscosity_at_50 * (50 / effective_temperature)**viscosity_exponent", "power law"
            )
        case ConstantViscosity():
            yield sheet.given(found, "constant")
        case _:
            yield sheet.read(found, "effective_temperature", remark="viscosity law of the lubricant")
