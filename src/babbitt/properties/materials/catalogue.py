"""The materials of the catalogue, read once from ``catalogue.toml``."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, partial
from importlib.resources import files
from typing import Any, TypeVar

from babbitt.properties.materials.bearing_metal import AlloyFamily, BearingMetal, LoadLimits
from babbitt.properties.materials.naming import find, spelling
from babbitt.properties.materials.sourced import SourcedText, SourcedValue
from babbitt.properties.materials.structural_material import StructuralMaterial
from babbitt.properties.own_catalogue import (
    OwnTables,
    own_entries,
    own_tables,
    part_of_entry,
    refuse_unknown_fields,
    texts,
)

Material = TypeVar("Material", BearingMetal, StructuralMaterial)

SOURCED = (
    "recommended_temperature",
    "limiting_temperature",
    "published_outlet_limit",
    "thermal_expansion",
    "brinell_hardness",
)
METAL = ("name", "aliases", "family", "standard", "composition", "calm", "shock", *SOURCED)
"""Fields of a bearing metal."""

NUMBERS = ("thermal_expansion", "thermal_conductivity", "elastic_modulus", "poisson_ratio", "density")
STRUCTURE = ("name", "aliases", "kind", "source", *NUMBERS)
"""Fields of a material of shafts and housings."""


def bearing_metals() -> tuple[BearingMetal, ...]:
    """All bearing metals, in the order of the catalogue."""
    return _read()[0]


def structural_materials() -> tuple[StructuralMaterial, ...]:
    """All materials of shafts, shells and housings, in the order of the catalogue."""
    return _read()[1]


def bearing_metal(name: str) -> BearingMetal:
    """Bearing metal of that name or alias; case, spaces and hyphens do not matter.

    Parameters
    ----------
    name : str
        Such as ``"B83"`` or ``"SnSb8Cu4"``.

    Raises
    ------
    InputError
        E005 naming the nearest entries.

    Examples
    --------
    >>> b83 = bearing_metal("b 83")
    >>> b83.calm.specific_load.value / 1e6, b83.shock.specific_load.value / 1e6
    (15.0, 10.0)
    """
    return find(name, _metals_by_spelling(), "bearing metal", tuple(metal.name for metal in bearing_metals()))


def structural_material(name: str) -> StructuralMaterial:
    """Material of a shaft, shell or housing of that name or alias; case, spaces and hyphens do not matter.

    Parameters
    ----------
    name : str
        Such as ``"42CrMo4"`` or ``"EN-GJL-250"``.

    Raises
    ------
    InputError
        E005 naming the nearest entries.

    Examples
    --------
    >>> structural_material("en gjs 400").name
    'EN-GJS-400-15'
    """
    names = tuple(material.name for material in structural_materials())
    return find(name, _structures_by_spelling(), "shaft or housing material", names)


@cache
def _read() -> tuple[tuple[BearingMetal, ...], tuple[StructuralMaterial, ...]]:
    raw = tomllib.loads(
        files("babbitt.properties.materials").joinpath("catalogue.toml").read_text(encoding="utf-8")
    )
    sources: Mapping[str, str] = raw["sources"]
    metals = tuple(_metal(entry, sources) for entry in raw["bearing_metal"])
    structures = tuple(_structure(entry, sources) for entry in raw["structural_material"])
    own = own_tables("materials.toml")
    own_metal, own_structure = partial(_own, own, _metal, METAL), partial(_own, own, _structure, STRUCTURE)
    return (
        (*metals, *own_entries(own, "bearing_metal", own_metal, spelling, metals)),
        (*structures, *own_entries(own, "structural_material", own_structure, spelling, structures)),
    )


def _own(
    own: OwnTables | None,
    read: Callable[[Mapping[str, Any], Mapping[str, str]], Material],
    known: tuple[str, ...],
    entry: Mapping[str, Any],
    origin: str,
) -> Material:
    """An entry of the user's catalogue with its own ``[sources]``."""
    refuse_unknown_fields(entry, known)
    sources = part_of_entry("sources", lambda: dict(own.tables.get("sources", {})) if own is not None else {})
    return replace(read(entry, sources), origin=origin)


def _structure(entry: Mapping[str, Any], sources: Mapping[str, str]) -> StructuralMaterial:
    """Material of a shaft or a housing of one table of the catalogue."""
    numbers: dict[str, Any] = {field: part_of_entry(field, partial(_number, entry, field)) for field in NUMBERS}
    return StructuralMaterial(
        name=entry["name"],
        kind=part_of_entry("kind", lambda: texts([entry["kind"]])[0]),
        source=part_of_entry("source", lambda: sources[entry["source"]]),
        aliases=part_of_entry("aliases", lambda: texts(entry.get("aliases", ()))),
        **numbers,
    )


def _number(entry: Mapping[str, Any], field: str) -> float:
    value = entry[field]
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TypeError(f"{value!r} is no number")
    return float(value)


def _metal(entry: Mapping[str, Any], sources: Mapping[str, str]) -> BearingMetal:
    """Bearing metal of one table of the catalogue."""

    def sourced(table: Mapping[str, Any], key: str) -> SourcedValue | None:
        value = table.get(key)
        return None if value is None else SourcedValue(_number(value, "value"), sources[value["source"]])

    def limits(character: str) -> LoadLimits:
        table = entry.get(character, {})
        return LoadLimits(**{key: sourced(table, key) for key in table})

    values: dict[str, Any] = {field: part_of_entry(field, partial(sourced, entry, field)) for field in SOURCED}
    return BearingMetal(
        name=entry["name"],
        family=part_of_entry("family", lambda: AlloyFamily(entry["family"])),
        standard=part_of_entry("standard", lambda: texts([entry["standard"]])[0]),
        composition=part_of_entry(
            "composition",
            lambda: SourcedText(entry["composition"]["text"], sources[entry["composition"]["source"]]),
        ),
        calm=part_of_entry("calm", partial(limits, "calm")),
        shock=part_of_entry("shock", partial(limits, "shock")),
        aliases=part_of_entry("aliases", lambda: texts(entry.get("aliases", ()))),
        **values,
    )


@cache
def _metals_by_spelling() -> dict[str, BearingMetal]:
    return {spelling(name): metal for metal in bearing_metals() for name in (metal.name, *metal.aliases)}


@cache
def _structures_by_spelling() -> dict[str, StructuralMaterial]:
    return {spelling(name): entry for entry in structural_materials() for name in (entry.name, *entry.aliases)}
