"""What a bearing was computed from: rows that an engineer can check against the drawing, in groups."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from babbitt.core.quantities.display import SI, in_system
from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants import (
    AstmD341,
    ConstantViscosity,
    Exponential,
    Lubricant,
    PowerLaw,
    TabulatedViscosity,
    ViscosityKind,
    Vogel,
    Walther,
)
from babbitt.properties.materials import BearingMetal
from babbitt.report.expression import Node, number_node, text
from babbitt.report.labels import label
from babbitt.report.text import plain_text
from babbitt.report.vocabulary import VOCABULARY, symbol

if TYPE_CHECKING:
    from babbitt.design.conditions import Surfaces
    from babbitt.report.view import View

__all__ = [
    "InputGroup", "Row", "as_given", "groups_in_words", "inputs", "metal_rows", "named_row", "oil_rows",
    "surface_rows",
]  # fmt: skip

LAWS = {
    Walther: "Walther (ASTM D341, short form)",
    AstmD341: "ASTM D341",
    Vogel: "Vogel",
    Exponential: "exponential",
    PowerLaw: "power law (50/t)^m",
    TabulatedViscosity: "table, Andrade's law from point to point",
    ConstantViscosity: "constant",
}

OIL = {
    "density": ("lubricant.density", "oil.density"),
    "heat_capacity": ("lubricant.heat_capacity", "oil.heat_capacity", "lubricant.volumetric_heat_capacity"),
    "volumetric_heat_capacity": ("lubricant.volumetric_heat_capacity",),
}
"""Fields of what is known of an oil beyond its viscosity; a name of the catalogue does not give it."""

SURFACES = {
    "tilt_offset": ("surfaces.tilt_offset", "surfaces.profile_tolerance_bearing"),
    "mean_deflection": ("surfaces.mean_deflection",),
    "waviness": ("surfaces.waviness", "surfaces.roundness_tolerance_bearing"),
    "wave_factor": ("surfaces.wave_factor",),
}
"""Fields of what keeps surfaces apart beyond their roughness."""

NUMBERED = re.compile(r"(.+), (?:pieces?|harmonic|wave) (\d+)(?: to \d+)?")
"""Label of an input of one of several without names, and its number; of alike pieces the first speaks for all."""

UNITS = {"1e-6/K": "× 10⁻⁶/K"}
"""Units as they look on paper, where the vocabulary writes them for a plain terminal."""


@dataclass(frozen=True)
class Row:
    """One input: what it is, its symbol where it has one, its value with the unit; the quantity, or no name."""

    label: str
    value: str
    symbol: Node | None = None
    unit: str = ""
    name: str = ""

    def is_left_out(self, left_out: Mapping[str, tuple[str, ...]], given: Collection[str]) -> bool:
        """Whether the case may leave this input out and did: it is a default or an assumption.

        Parameters
        ----------
        left_out : Mapping of str to tuple of str
            As of `babbitt.report.view.View`, and those of every oil and all surfaces.
        given : collection of str
            Paths of the fields that the case has written; empty where that is not known.
        """
        numbered = NUMBERED.fullmatch(self.label)
        what = numbered[1] if numbered else self.label.partition(", pad ")[0]
        fields = {**left_out, **OIL, **SURFACES}.get(self.name or what, ())
        if numbered:
            fields = tuple(field.replace(".", f".{numbered[2]}.", 1) for field in fields)
        return bool(fields and given) and not any(_is_field(path, one) for one in fields for path in given)


def _is_field(path: str, field: str) -> bool:
    """Whether a path ends at a field; one that is named alone stands in a case, bearing or operating point."""
    within = path.removeprefix("bearings.").removeprefix("operating_points.")
    return within == field or ("." in field and path.endswith(f".{field}"))


@dataclass(frozen=True)
class InputGroup:
    """Inputs that belong together."""

    title: str
    rows: tuple[Row, ...]


def inputs(problem: Any, view: View, given: Iterable[tuple[str, str]]) -> tuple[InputGroup, ...]:
    """All inputs of a problem, grouped: as the case gave them, then by what they are.

    Parameters
    ----------
    problem : Problem
    view : View
        Of the method.
    given : iterable of (str, str)
        What the case gave in other terms than those of the calculation, and in which words.

    Returns
    -------
    tuple of InputGroup
        Groups that say nothing are left out.
    """
    return tuple(group for group in (as_given(given), *view.inputs(problem)) if group.rows)


def as_given(given: Iterable[tuple[str, str]]) -> InputGroup:
    """What the case gave in other terms than those of the calculation."""
    return InputGroup("As given", tuple(Row(plain_text(what), plain_text(words)) for what, words in given))


def groups_in_words(said: Iterable[tuple[str, Iterable[tuple[str, str, str]]]]) -> Iterator[InputGroup]:
    """Groups of rows that another module has put into words."""
    for title, rows in said:
        yield InputGroup(title, tuple(Row(what, plain_text(value), None, unit) for what, value, unit in rows))


def named_row(name: str, value: float, given_label: str = "") -> Row:
    """An input under its name in the vocabulary, in the engineer's unit, as exactly as it was given."""
    quantity = VOCABULARY[name]
    shown = text(number_node(quantity.shown(value), 6)).replace("e−", " × 10^−")
    return Row(
        given_label or label(name),
        shown,
        symbol(name),
        UNITS.get(quantity.display.label, quantity.display.label),
        name,
    )


def oil_rows(oil: Lubricant) -> Iterator[Row]:
    """Rows of a lubricant: its law, viscosities, density, specific heat, source."""
    yield Row("Name", plain_text(oil.name))
    yield Row("Viscosity law", LAWS.get(type(oil.viscosity_law), type(oil.viscosity_law).__name__))
    law = oil.viscosity_law
    if isinstance(law, ConstantViscosity):
        yield _constant(law)
    else:
        for kelvin in (40.0 + ZERO_CELSIUS, 100.0 + ZERO_CELSIUS):
            if oil.covers(kelvin):
                viscosity = oil.kinematic_viscosity(kelvin)
                yield _row(f"Kinematic viscosity at {_temperature(kelvin)}", viscosity, "mm2/s")
    if oil.covers(293.15):
        yield _row(f"Density at {_temperature(293.15)}", oil.density(293.15), "kg/m3", "density")
    if oil.fixed_volumetric_heat_capacity is not None:
        yield named_row("volumetric_heat_capacity", oil.fixed_volumetric_heat_capacity)
    else:
        yield _row(f"Specific heat at {_temperature(323.15)}", oil.heat_capacity(323.15), "J/kgK", "heat_capacity")
    yield Row("Source", plain_text(oil.source))
    if oil.origin:
        yield Row("From the catalogue of the user", plain_text(PurePath(oil.origin).name))


def _constant(law: ConstantViscosity) -> Row:
    """What is constant, once: over a density that falls with temperature the other one would seem to rise."""
    if law.kind is ViscosityKind.DYNAMIC:
        return _row("Dynamic viscosity", law.viscosity, "mPas")
    return _row("Kinematic viscosity", law.viscosity, "mm2/s")


def _row(what: str, value: float, unit: str, name: str = "") -> Row:
    """An input that the vocabulary does not name, in the unit of the system that is spoken."""
    shown = in_system(SI[unit])
    return Row(what, f"{value * shown.scale:.4g}", None, shown.label, name)


def _temperature(kelvin: float) -> str:
    shown = in_system(SI["degC"])
    return f"{kelvin * shown.scale + shown.offset:.0f} {shown.label}"


def surface_rows(surfaces: Surfaces | None) -> Iterator[Row]:
    """Rows of what keeps the surfaces apart at least; none where it is not known."""
    if surfaces is not None:
        for name, value in vars(surfaces).items():
            yield named_row(name, value)


def metal_rows(metal: BearingMetal | None) -> Iterator[Row]:
    """Rows of a bearing metal; none without one."""
    if metal is not None:
        yield Row("Bearing metal", plain_text(metal.name))
        yield Row("Specified in", plain_text(metal.standard))
