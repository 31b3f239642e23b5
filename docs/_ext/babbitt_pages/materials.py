"""The page of materials: bearing metals with their limits, shaft and housing materials, experience."""

from __future__ import annotations

from collections.abc import Iterable

from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.materials import (
    AlloyFamily,
    BearingMetal,
    LoadCharacter,
    SourcedValue,
    bearing_metals,
    experience_limits,
    metal_temperature_limit,
    specific_load_limit,
    structural_materials,
)
from babbitt_pages.markdown import table, text


def page() -> str:
    """Markdown of all materials and limits."""
    return "\n".join(
        [
            "## Bearing metals\n",
            *(_metal(metal) for metal in bearing_metals()),
            "## Shaft, shell and housing materials\n",
            _structures(),
            "## Limits by experience\n",
            _experience(),
        ]
    )


def _metal(metal: BearingMetal) -> str:
    rows = [
        ["composition", text(metal.composition.text), text(metal.composition.source)],
        *_limit_rows(metal),
        *_rows("recommended temperature", metal.recommended_temperature, " °C", 1.0, -ZERO_CELSIUS),
        *_rows("limiting temperature", metal_temperature_limit(metal), " °C", 1.0, -ZERO_CELSIUS),
        *_rows("oil outlet, published", metal.published_outlet_limit, " °C", 1.0, -ZERO_CELSIUS),
        *_rows("thermal expansion", metal.thermal_expansion, "·10⁻⁶/K", 1e6),
        *_rows("hardness", metal.brinell_hardness, " HBW"),
    ]
    also = f" Also found as: {text(', '.join(metal.aliases))}." if metal.aliases else ""
    head = f"### {text(metal.name)}\n\n{text(metal.standard)}, {text(metal.family.value)}.{also}\n"
    return f"{head}\n{table(['property', 'value', 'source'], rows)}"


def _limit_rows(metal: BearingMetal) -> Iterable[list[str]]:
    for character in LoadCharacter:
        limits = metal.limits(character)
        yield from _rows(f"specific load, {character.value}", limits.specific_load, " MPa", 1e-6)
        yield from _rows(f"surface speed, {character.value}", limits.sliding_speed, " m/s")
        yield from _rows(f"load times speed, {character.value}", limits.pv, " MPa m/s", 1e-6)


def _rows(
    name: str, value: SourcedValue | None, unit: str, scale: float = 1.0, offset: float = 0.0
) -> Iterable[list[str]]:
    if value is not None:
        yield [name, f"{value.value * scale + offset:.4g}{unit}", text(value.source)]


def _structures() -> str:
    headings = ["name", "kind", "α 10⁻⁶/K", "λ W/(m K)", "E GPa", "ν", "ρ kg/m³", "source"]
    rows = (
        [
            text(", ".join((material.name, *material.aliases))),
            text(str(material.kind)),
            f"{material.thermal_expansion * 1e6:.1f}",
            f"{material.thermal_conductivity:.3g}",
            f"{material.elastic_modulus * 1e-9:.4g}",
            f"{material.poisson_ratio:.2f}",
            f"{material.density:.0f}",
            text(material.source),
        ]
        for material in structural_materials()
    )
    return table(headings, rows)


def _experience() -> str:
    limits = experience_limits()
    loads = [
        [family.value, f"{found.general * 1e-6:.3g}", f"{found.exceptional * 1e-6:.3g}"]
        for family in AlloyFamily
        if (found := specific_load_limit(family)) is not None
    ]
    minutes = f"{limits.circulation_time / 60.0:.0f} min"
    temperatures = [
        [name, f"{limit.general - ZERO_CELSIUS:.0f}", f"{limit.exceptional - ZERO_CELSIUS:.0f}"]
        for name, limit in (
            ("bearing temperature, self-cooled", limits.self_cooled),
            (
                f"oil outlet, fed, oil volume over flow at most {minutes} or unknown",
                limits.pressure_fed_little_oil,
            ),
            (f"oil outlet, fed, oil volume over flow above {minutes}", limits.pressure_fed_much_oil),
        )
    ]
    return "\n".join(
        [
            f"Source: {text(limits.source)}. Values by experience are no material constants; set your "
            "own with `limits` in the case, one by one or as whole tables (`limits: {tables: FILE.toml}`).\n",
            "Least permissible film thickness of steadily loaded bearings, in µm:\n",
            _film_table(),
            "Specific load in MPa by family of bearing metal:\n",
            table(["family", "general", "exceptional, only at low surface speed (up to 1 m/s)"], loads),
            "Temperature in °C:\n",
            table(["limited temperature", "general", "exceptional"], temperatures),
        ]
    )


def _film_table() -> str:
    film = experience_limits().film_thickness
    speeds = film.surface_speeds
    columns = [f"U up to {speed:g} m/s" for speed in speeds] + [f"above {speeds[-1]:g} m/s"]
    steps = zip(film.diameters[:-1], film.diameters[1:], film.films, strict=True)
    rows = (
        [f"above {above * 1e3:g} up to {up_to * 1e3:g}", *(f"{limit * 1e6:.0f}" for limit in row)]
        for above, up_to, row in steps
    )
    return table(["D in mm", *columns], rows)
