"""The page of lubricants, each with its source and what is assumed."""

from __future__ import annotations

from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants import Lubricant, catalogue
from babbitt_pages.markdown import anchor, table, text

TABLE_TEMPERATURES = (40.0, 60.0, 80.0, 100.0)


def page() -> str:
    """Markdown: a table of viscosities, then every entry with sources and assumptions."""
    headings = ["name", *(f"ν({t:.0f} °C) mm²/s" for t in TABLE_TEMPERATURES), "ρ(15 °C) kg/m³", "range °C"]
    overview = table(headings, (_row(oil) for oil in catalogue()))
    return "\n".join(["## Overview\n", overview, "## Entries\n", *(_entry(oil) for oil in catalogue())])


def _row(oil: Lubricant) -> list[str]:
    viscosities = (
        f"{oil.kinematic_viscosity(t + ZERO_CELSIUS) * 1e6:.4g}" if oil.covers(t + ZERO_CELSIUS) else "–"
        for t in TABLE_TEMPERATURES
    )
    coldest, hottest = (kelvin - ZERO_CELSIUS for kelvin in oil.temperature_range)
    density = f"{oil.density(15.0 + ZERO_CELSIUS):.0f}"
    return [text(oil.name), *viscosities, density, f"{coldest:.0f} to {hottest:.0f}"]


def _entry(oil: Lubricant) -> str:
    lines = [f"{anchor(_label(oil))}### {text(oil.name)}\n", f"Source: {text(oil.source)}\n"]
    if oil.aliases:
        lines.append(f"Also found as: {text(', '.join(oil.aliases))}\n")
    for field, source in vars(oil.sources).items():
        if source and source != oil.source:
            lines.append(f"- {field.replace('_', ' ')}: {text(source)}")
    lines += [f"- *assumption:* {text(assumption)}" for assumption in oil.assumptions]
    return "\n".join(lines) + "\n"


def _label(oil: Lubricant) -> str:
    return "oil-" + "".join(letter if letter.isalnum() else "-" for letter in oil.name.lower())
