"""Oils and metals of the catalogue on the page: tables, the viscosity chart, and putting one into the case."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from babbitt.app.answer import Table
from babbitt.app.form import Choice, Entry, Group, Item, Path
from babbitt.app.maps import INK
from babbitt.core.language import translated_if_known
from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants import catalogue, lubricant
from babbitt.properties.materials import bearing_metals, structural_materials
from babbitt.report import catalogue_tables
from babbitt.study.size_choices import standard_choices

__all__ = ["FIELDS", "field_for", "metals", "oils", "suggestions", "viscosity_chart"]

FIELDS = {"oil": ("lubricant", "oil"), "metal": ("bearing_metal",)}
"""Names of the fields of a case that take an entry."""

COLDEST, HOTTEST, STEPS = -10.0, 140.0, 31
"""Temperatures of the chart, degC."""

TEMPERATURES = (0, 20, 40, 60, 80, 100, 120, 140)
VISCOSITIES = (2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 5000, 50000)
"""What is written along the axes, degC and mm²/s."""

ADDITIVE = 0.7
"""mm²/s, of the axes of the chart (ASTM D341)."""


def oils() -> Table:
    """The lubricants."""
    return _spoken(catalogue_tables.LUBRICANT_HEADS, catalogue_tables.lubricant_rows())


def metals() -> Table:
    """The bearing metals with their limits."""
    return _spoken(catalogue_tables.METAL_HEADS, catalogue_tables.metal_rows(), words=2)


def suggestions(path: Path) -> tuple[str, ...]:
    """Names that a field takes: of the catalogue for oils, metals and other materials, else those that are usual.

    >>> suggestions(("lubricant",))[0], "SnSb8Cu4" in suggestions(("materials", "bearing_metal"))
    ('ISO VG 10', True)
    >>> "C45" in suggestions(("materials", "journal")), suggestions(("name",))
    (True, ())
    """
    if path[-1] in FIELDS["oil"]:
        return tuple(one.name for one in catalogue())
    if path[-1] in FIELDS["metal"]:
        return tuple(one.name for one in bearing_metals())
    if path[-2:-1] == ("materials",):
        return tuple(one.name for one in structural_materials())
    return standard_choices(".".join(map(str, path)))


def _spoken(heads: Iterable[str], rows: Iterable[tuple[str, ...]], words: int = 1) -> Table:
    """Heads and cells in the language that is written; names stay as they are."""
    said = tuple((name, *map(translated_if_known, cells)) for name, *cells in rows)
    return Table("", tuple(map(translated_if_known, heads)), said, words=words)


def field_for(items: Iterable[Item], names: Iterable[str]) -> Path | None:
    """The first field of a case, by its path, that has one of some names; None where it has none of them."""
    known = {path[-1]: path for path in reversed(list(_paths(items)))}
    return next((known[name] for name in names if name in known), None)


def _paths(items: Iterable[Item]) -> Iterable[Path]:
    for item in items:
        if isinstance(item, Entry | Choice):
            yield item.path
        if isinstance(item, Group):
            yield from _paths(item.items)


def on_chart(celsius: float, viscosity: float) -> tuple[float, float]:
    """Where a point lies on axes on which oils are straight: lg T and lg lg (ν + 0.7), ν in mm²/s (ASTM D341)."""
    return math.log10(celsius + ZERO_CELSIUS), math.log10(math.log10(viscosity + ADDITIVE))


def viscosity_chart(names: Iterable[str]) -> dict[str, Any]:
    """Kinematic viscosity over temperature of some oils, for Plotly; each over the range that its source gives."""
    lines = []
    for oil in map(lubricant, names):
        warm = [COLDEST + number * (HOTTEST - COLDEST) / (STEPS - 1) for number in range(STEPS)]
        points = [
            (one, 1e6 * oil.kinematic_viscosity(one + ZERO_CELSIUS))
            for one in warm
            if oil.covers(one + ZERO_CELSIUS)
        ]
        places = [on_chart(one, nu) for one, nu in points if nu > 1.0]
        said = [f"{one:.0f} °C, {nu:.4g} mm²/s" for one, nu in points if nu > 1.0]
        lines.append(
            {
                "type": "scatter", "mode": "lines", "name": oil.name, "text": said, "hoverinfo": "name+text",
                "x": [x for x, _ in places], "y": [y for _, y in places],
            }
        )  # fmt: skip
    across, up = (
        {"tickvals": values, "ticktext": [str(one) for one in shown], "title": {"text": title}, "zeroline": False}
        for values, shown, title in (
            ([on_chart(one, 10.0)[0] for one in TEMPERATURES], TEMPERATURES, "°C"),
            ([on_chart(0.0, one)[1] for one in VISCOSITIES], VISCOSITIES, "ν mm²/s"),
        )
    )
    layout = {
        "paper_bgcolor": "rgba(0,0,0,0)", "plot_bgcolor": "rgba(0,0,0,0)", "font": {"color": INK}, "xaxis": across,
        "yaxis": up, "margin": {"l": 60, "r": 20, "t": 20, "b": 50}, "showlegend": True,
    }  # fmt: skip
    return {"data": lines, "layout": layout, "config": {"displaylogo": False, "responsive": False}}
