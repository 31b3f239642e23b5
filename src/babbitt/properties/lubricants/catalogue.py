"""The lubricants of the catalogue, read from ``catalogue.toml``, and the search by name."""

from __future__ import annotations

import functools
import tomllib
from dataclasses import replace
from functools import partial
from importlib import resources
from typing import Any

from babbitt.core.nearest_name import nearest_names
from babbitt.core.notices import InputError
from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants._evaluation import require_range
from babbitt.properties.lubricants.lubricant import Lubricant, PropertySources
from babbitt.properties.lubricants.property_laws import LinearProperty, PropertyLaw, ShiftedLaw
from babbitt.properties.lubricants.viscosity_index import nu40_from_viscosity_index, nu100_from_viscosity_index
from babbitt.properties.lubricants.viscosity_laws import ViscosityLaw, Vogel
from babbitt.properties.lubricants.walther import Walther
from babbitt.properties.own_catalogue import (
    OwnTables,
    own_entries,
    own_tables,
    part_of_entry,
    refuse_unknown_fields,
    texts,
)

_MM2_PER_S = 1e-6
_PROPERTIES = ("density", "heat_capacity", "conductivity")
FIELDS = (
    "source",
    "temperature_range",
    "viscosity",
    *_PROPERTIES,
    "fixed_volumetric_heat_capacity",
    "assumptions",
)

Table = dict[str, Any]


def lubricant(name: str) -> Lubricant:
    """Take a lubricant from the catalogue.

    Parameters
    ----------
    name : str
        Name or alias; case, spaces, hyphens and underscores do not matter.

    Raises
    ------
    InputError
        E005 when it is not in the catalogue; the message names the nearest.

    Examples
    --------
    >>> oil = lubricant("iso vg46")
    >>> oil.name, round(oil.kinematic_viscosity(313.15) * 1e6, 6)
    ('ISO VG 46', 46.0)
    """
    entry = _index().get(_key(name))
    if entry is None:
        raise InputError("E005", _not_included(name))
    return entry


@functools.cache
def catalogue() -> tuple[Lubricant, ...]:
    """All lubricants: those that ship in the order of the catalogue file, then those of the user's own catalogue.

    Warns
    -----
    UserWarning
        For entries of one's own that cannot be used (`babbitt.properties.own_catalogue`).
    """
    file = _file()
    shared = file["property_laws"]
    shipped = tuple(_lubricant(_with_family(file["families"], entry), shared) for entry in file["lubricants"])
    own = own_tables("lubricants.toml")
    return (*shipped, *own_entries(own, "lubricants", partial(_own_lubricant, own), _key, shipped))


def _own_lubricant(own: OwnTables | None, entry: Table, origin: str) -> Lubricant:
    """A lubricant of the user's catalogue, which may take families and laws of that which ships."""
    board, tables = _file(), own.tables if own is not None else {}
    refuse_unknown_fields(entry, ("name", "aliases", "family", *FIELDS))
    families = board["families"] | part_of_entry("families", lambda: dict(tables.get("families", {})))
    shared = board["property_laws"] | part_of_entry("property_laws", lambda: dict(tables.get("property_laws", {})))
    whole = part_of_entry("family", lambda: _with_family(families, entry))
    found = replace(_lubricant(whole, shared), origin=origin)
    lowest, highest = found.temperature_range
    for field in ("dynamic_viscosity", "density", "heat_capacity", "conductivity"):
        for kelvin in (lowest, 0.5 * (lowest + highest), highest):
            value = part_of_entry(field, partial(getattr(found, field), kelvin))
            if not value > 0.0:
                raise InputError("E003", f"{field}: is {value:.4g} at {kelvin - ZERO_CELSIUS:.4g} degC")
    return found


def shared_law(name: str) -> tuple[PropertyLaw, Table]:
    """One of the shared property laws of the catalogue and its table of texts (source, assumptions)."""
    table: Table = _file()["property_laws"][name]
    return _line(table), table


@functools.cache
def _file() -> Table:
    text = resources.files("babbitt.properties.lubricants").joinpath("catalogue.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


@functools.cache
def _index() -> dict[str, Lubricant]:
    return {_key(name): entry for entry in catalogue() for name in (entry.name, *entry.aliases)}


def _key(name: str) -> str:
    return "".join(letter for letter in name.casefold() if letter.isalnum())


def _not_included(name: str) -> str:
    near = nearest_names(_key(name), _index())
    hint = f"The nearest is '{_index()[near[0]].name}'." if near else "No name in the catalogue is near it."
    return (
        f"No lubricant named {name!r} is in the catalogue. {hint} `babbitt list lubricants` shows all; "
        "own oils are given by two viscosities or by nu40 and viscosity index."
    )


def _with_family(families: Table, entry: Table) -> Table:
    """The entry on top of what its family says, table by table."""
    base = entry.get("family") or entry.get("extends")
    if base is None:
        return entry
    merged = dict(_with_family(families, families[base]))
    for field, value in entry.items():
        both_tables = isinstance(value, dict) and isinstance(merged.get(field), dict)
        merged[field] = merged[field] | value if both_tables else value
    return merged


def _lubricant(entry: Table, shared: Table) -> Lubricant:
    """A lubricant of its whole table; what is wrong with it is reported by its field."""
    lowest, highest = part_of_entry("temperature_range", partial(_range, entry))
    viscosity, computed = part_of_entry("viscosity", lambda: _viscosity(entry["viscosity"], (lowest, highest)))
    laws = {field: part_of_entry(field, partial(_law_in, entry, field, shared)) for field in _PROPERTIES}
    fixed = entry.get("fixed_volumetric_heat_capacity", {})
    assumptions = [*part_of_entry("assumptions", lambda: texts(entry.get("assumptions", ()))), *computed]
    assumed = {field: part_of_entry(field, partial(_assumptions, entry[field], shared)) for field in _PROPERTIES}
    of_product = (
        [part_of_entry("fixed_volumetric_heat_capacity", lambda: str(fixed["assumption"]))] if fixed else []
    )
    used = [one for field, said in assumed.items() if not (fixed and field == "heat_capacity") for one in said]
    assumptions += [*used, *of_product]
    sources = {field: part_of_entry(field, partial(_source, entry[field], shared)) for field in _PROPERTIES}
    return Lubricant(
        name=entry["name"],
        viscosity_law=viscosity,
        density_law=laws["density"],
        heat_capacity_law=laws["heat_capacity"],
        conductivity_law=laws["conductivity"],
        temperature_range=(lowest, highest),
        source=part_of_entry("source", lambda: texts([entry["source"]])[0]),
        fixed_volumetric_heat_capacity=part_of_entry(
            "fixed_volumetric_heat_capacity", lambda: 1.0 * fixed["value"] if fixed else None
        ),
        assumptions=tuple(assumptions),
        heat_capacity_assumptions=(*assumed["heat_capacity"], *of_product),
        conductivity_assumptions=tuple(assumed["conductivity"]),
        viscosity_index=entry["viscosity"].get("viscosity_index"),
        sources=PropertySources(viscosity=entry["viscosity"].get("source", ""), **sources),
        aliases=part_of_entry("aliases", lambda: texts(entry.get("aliases", ()))),
    )


def _viscosity(table: Table, temperature_range: tuple[float, float]) -> tuple[ViscosityLaw, list[str]]:
    """The viscosity law of an entry and what had to be computed for it."""
    if table.get("form") == "vogel":
        coldest, middle, warmest = ((_kelvin(t), value) for t, value in table["points"])
        return Vogel.through(coldest, middle, warmest, temperature_range=temperature_range), []
    if "points" in table:
        colder, warmer = ((_kelvin(t), value * _MM2_PER_S) for t, value in table["points"])
        additive = table["additive"]
        law = Walther.through(colder, warmer, additive=additive, temperature_range=temperature_range)
        return law, []
    nu40, nu100, computed = _nu40_and_nu100(table)
    points = (_kelvin(40.0), nu40), (_kelvin(100.0), nu100)
    return Walther.through(*points, temperature_range=temperature_range), computed


def _nu40_and_nu100(table: Table) -> tuple[float, float, list[str]]:
    if "viscosity_index" not in table:
        return table["nu40"] * _MM2_PER_S, table["nu100"] * _MM2_PER_S, []
    index = table["viscosity_index"]
    if "nu40" in table:
        nu40 = table["nu40"] * _MM2_PER_S
        nu100 = nu100_from_viscosity_index(index, nu40)
        said, value = "100 degC", nu100
    else:
        nu100 = table["nu100"] * _MM2_PER_S
        nu40 = nu40_from_viscosity_index(index, nu100)
        said, value = "40 degC", nu40
    text = (
        f"Viscosity at {said} computed from viscosity index {index:g} (ISO 2909): {value / _MM2_PER_S:.4g} mm2/s."
    )
    return nu40, nu100, [text]


def _range(entry: Table) -> tuple[float, float]:
    lowest, highest = (_kelvin(t) for t in entry["temperature_range"])
    require_range("temperature_range", (lowest, highest))
    return lowest, highest


def _law_in(entry: Table, field: str, shared: Table) -> PropertyLaw:
    return _property_law(entry[field], shared)


def _property_law(table: Table, shared: Table) -> PropertyLaw:
    """A line of its own when the entry gives a slope, else the shared law, shifted where a value is known."""
    if "slope" in table:
        return _line(table)
    law = _line(shared[table["law"]])
    return ShiftedLaw.through(law, _kelvin(table["at"]), table["value"]) if "value" in table else law


def _line(table: Table) -> LinearProperty:
    return LinearProperty(table["value"], _kelvin(table["at"]), table["slope"])


def _assumptions(table: Table, shared: Table) -> list[str]:
    """What is assumed of one property: by the entry itself, and by the shared law it leans on."""
    own = [table["assumption"]] if "assumption" in table else []
    if "slope" in table:
        return own
    law = shared[table["law"]]
    return [*own, law["slope_assumption"] if "value" in table else law["assumption"]]


def _source(table: Table, shared: Table) -> str:
    own: str = table.get("source", "")
    if "slope" in table:
        return own
    law = shared[table["law"]]
    return f"{own}; slope: {law['slope_source']}" if "value" in table else str(law["source"])


def _kelvin(celsius: float) -> float:
    return celsius + ZERO_CELSIUS
