"""The catalogues of lubricants and of materials as rows of text: for the screen and for the page alike."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.units import ZERO_CELSIUS

if TYPE_CHECKING:
    from babbitt.properties.materials.sourced import SourcedValue

__all__ = ["LUBRICANT_HEADS", "METAL_HEADS", "STRUCTURAL_HEADS", "lubricant_rows", "metal_rows", "structural_rows"]

LUBRICANT_HEADS = ("name", "ν 40 °C mm²/s", "ν 100 °C mm²/s", "ρ 15 °C kg/m³", "range °C", "source")
METAL_HEADS = (
    "bearing metal", "family", "p̄ MPa", "shock", "U m/s", "p̄U MPa m/s", "T °C", "recomm. °C", "sources",
)  # fmt: skip
STRUCTURAL_HEADS = ("material", "kind", "α 1e-6/K", "λ W/(m K)", "E GPa", "source")

Row = tuple[str, ...]
"""Cells; the last one is the source, the first the name."""


def lubricant_rows() -> Iterator[Row]:
    """Lubricants of the catalogue with viscosity, density and source."""
    from babbitt.properties.lubricants import catalogue

    for oil in catalogue():
        coldest, hottest = (kelvin - ZERO_CELSIUS for kelvin in oil.temperature_range)
        nu100 = f"{oil.kinematic_viscosity(373.15) * 1e6:.2f}" if oil.covers(373.15) else "–"
        yield (
            oil.name,
            f"{oil.kinematic_viscosity(313.15) * 1e6:.2f}",
            nu100,
            f"{oil.density(288.15):.0f}",
            f"{coldest:.0f} to {hottest:.0f}",
            _with_origin(oil.source, oil.origin),
        )


def metal_rows() -> Iterator[Row]:
    """Bearing metals with their limits."""
    from babbitt.properties.materials import LoadCharacter, bearing_metals, metal_temperature_limit

    for metal in bearing_metals():
        calm = metal.limits(LoadCharacter.CALM)
        limits = (calm.specific_load, calm.sliding_speed, calm.pv, metal_temperature_limit(metal))
        sources = dict.fromkeys([metal.standard, *(limit.source for limit in limits if limit)])
        yield (
            metal.name,
            metal.family.value,
            _shown(calm.specific_load, 1e-6),
            _shown(metal.limits(LoadCharacter.SHOCK).specific_load, 1e-6),
            _shown(calm.sliding_speed),
            _shown(calm.pv, 1e-6),
            _shown(metal_temperature_limit(metal), 1.0, -ZERO_CELSIUS),
            _shown(metal.recommended_temperature, 1.0, -ZERO_CELSIUS),
            _with_origin("; ".join(sources), metal.origin),
        )


def structural_rows() -> Iterator[Row]:
    """Materials of shafts and housings."""
    from babbitt.properties.materials import structural_materials

    for material in structural_materials():
        yield (
            material.name,
            str(material.kind),
            f"{material.thermal_expansion * 1e6:.1f}",
            f"{material.thermal_conductivity:.0f}",
            f"{material.elastic_modulus * 1e-9:.0f}",
            _with_origin(material.source, material.origin),
        )


def _shown(value: SourcedValue | None, scale: float = 1.0, offset: float = 0.0) -> str:
    return f"{value.value * scale + offset:.4g}" if value else "–"


def _with_origin(source: str, origin: str) -> str:
    """Source of an entry, and the catalogue of the user in which it stands."""
    return f"{source} ({origin})" if origin else source
