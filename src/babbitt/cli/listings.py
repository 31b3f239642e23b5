"""What `babbitt list` prints: lubricants, materials, units, kinds of case, published cases."""

from __future__ import annotations

from rich.markup import escape
from rich.table import Table

from babbitt.core.files.printing import printable_lines
from babbitt.core.units import ZERO_CELSIUS
from babbitt.report.table import console


def print_lubricants() -> None:
    """Lubricants of the catalogue with viscosity, density and source."""
    from babbitt.properties.lubricants import catalogue

    table = _table("name", "ν 40 °C mm²/s", "ν 100 °C mm²/s", "ρ 15 °C kg/m³", "range °C", "source")
    for oil in catalogue():
        coldest, hottest = (kelvin - ZERO_CELSIUS for kelvin in oil.temperature_range)
        nu100 = f"{oil.kinematic_viscosity(373.15) * 1e6:.2f}" if oil.covers(373.15) else "–"
        table.add_row(
            oil.name,
            f"{oil.kinematic_viscosity(313.15) * 1e6:.2f}",
            nu100,
            f"{oil.density(288.15):.0f}",
            f"{coldest:.0f} to {hottest:.0f}",
            _with_origin(oil.source, oil.origin),
        )
    console().print(table)


def print_materials() -> None:
    """Bearing metals with their limits, then shaft and housing materials."""
    from babbitt.properties.materials import (
        BearingMetal,
        LoadCharacter,
        bearing_metals,
        metal_temperature_limit,
        structural_materials,
    )
    from babbitt.properties.materials.sourced import SourcedValue

    def shown(value: SourcedValue | None, scale: float = 1.0, offset: float = 0.0) -> str:
        return f"{value.value * scale + offset:.4g}" if value else "–"

    def sources(metal: BearingMetal) -> list[str]:
        calm = metal.limits(LoadCharacter.CALM)
        limits = (calm.specific_load, calm.sliding_speed, calm.pv, metal_temperature_limit(metal))
        return list(dict.fromkeys([metal.standard, *(limit.source for limit in limits if limit)]))

    metals = _table(
        "bearing metal", "family", "p̄ MPa", "shock", "U m/s", "p̄U MPa m/s", "T °C", "recomm. °C", "sources"
    )
    for metal in bearing_metals():
        calm = metal.limits(LoadCharacter.CALM)
        metals.add_row(
            metal.name,
            metal.family.value,
            shown(calm.specific_load, 1e-6),
            shown(metal.limits(LoadCharacter.SHOCK).specific_load, 1e-6),
            shown(calm.sliding_speed),
            shown(calm.pv, 1e-6),
            shown(metal_temperature_limit(metal), 1.0, -ZERO_CELSIUS),
            shown(metal.recommended_temperature, 1.0, -ZERO_CELSIUS),
            _with_origin("; ".join(sources(metal)), metal.origin),
        )
    others = _table("material", "kind", "α 1e-6/K", "λ W/(m K)", "E GPa", "source")
    for material in structural_materials():
        others.add_row(
            material.name,
            str(material.kind),
            f"{material.thermal_expansion * 1e6:.1f}",
            f"{material.thermal_conductivity:.0f}",
            f"{material.elastic_modulus * 1e-9:.0f}",
            _with_origin(material.source, material.origin),
        )
    to = console()
    to.print(metals)
    to.print(others)


def print_kinds() -> None:
    """Kinds of case that `babbitt new` writes."""
    from babbitt.case import kinds

    table = _table("kind", "describes")
    for name, meaning in kinds().items():
        table.add_row(name, meaning)
    console().print(table)


def print_units() -> None:
    """Kinds of quantities with the units that a case file may use."""
    from babbitt.core.units import KINDS

    table = _table("kind", "example", "units")
    for kind in KINDS.values():
        table.add_row(kind.phrase, kind.example, ", ".join(unit for unit in kind.everyday if unit))
    console().print(table)


def print_cases() -> None:
    """Published cases that `babbitt validate` runs."""
    from babbitt.validation import cases

    table = _table("case", "kind", "title", "source")
    for case in cases():
        table.add_row(case.name, case.evidence.value, case.title, case.story.source)
    console().print(table)


def _with_origin(source: str, origin: str) -> str:
    """Source of an entry, and the catalogue of the user in which it stands."""
    return escape(printable_lines(f"{source} ({origin})" if origin else source))


def _table(*columns: str) -> Table:
    table = Table()
    for column in columns:
        table.add_column(column)
    return table
