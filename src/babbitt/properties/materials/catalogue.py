"""The materials on board, read once from ``catalogue.toml``."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from babbitt.properties.materials.bearing_metal import AlloyFamily, BearingMetal, LoadLimits
from babbitt.properties.materials.naming import find, spelling
from babbitt.properties.materials.sourced import SourcedText, SourcedValue
from babbitt.properties.materials.structural_material import StructuralMaterial


def bearing_metals() -> tuple[BearingMetal, ...]:
    """All bearing metals on board, in the order of the catalogue."""
    return _read()[0]


def structural_materials() -> tuple[StructuralMaterial, ...]:
    """All materials of shafts, shells and housings on board, in the order of the catalogue."""
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
    structures = tuple(
        StructuralMaterial(
            **{**entry, "aliases": tuple(entry.get("aliases", ())), "source": sources[entry["source"]]}
        )
        for entry in raw["structural_material"]
    )
    return metals, structures


def _metal(entry: Mapping[str, Any], sources: Mapping[str, str]) -> BearingMetal:
    """Bearing metal of one table of the catalogue."""

    def sourced(table: Mapping[str, Any], key: str) -> SourcedValue | None:
        value = table.get(key)
        return None if value is None else SourcedValue(float(value["value"]), sources[value["source"]])

    def limits(character: str) -> LoadLimits:
        table = entry.get(character, {})
        return LoadLimits(**{key: sourced(table, key) for key in table})

    return BearingMetal(
        name=entry["name"],
        family=AlloyFamily(entry["family"]),
        standard=entry["standard"],
        composition=SourcedText(entry["composition"]["text"], sources[entry["composition"]["source"]]),
        calm=limits("calm"),
        shock=limits("shock"),
        recommended_temperature=sourced(entry, "recommended_temperature"),
        limiting_temperature=sourced(entry, "limiting_temperature"),
        published_outlet_limit=sourced(entry, "published_outlet_limit"),
        thermal_expansion=sourced(entry, "thermal_expansion"),
        brinell_hardness=sourced(entry, "brinell_hardness"),
        aliases=tuple(entry.get("aliases", ())),
    )


@cache
def _metals_by_spelling() -> dict[str, BearingMetal]:
    return {spelling(name): metal for metal in bearing_metals() for name in (metal.name, *metal.aliases)}


@cache
def _structures_by_spelling() -> dict[str, StructuralMaterial]:
    return {spelling(name): entry for entry in structural_materials() for name in (entry.name, *entry.aliases)}
