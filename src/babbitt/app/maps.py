"""Fields of a film for charts: what is known over the angle and across the width, whatever the kind of bearing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.app.answer import solved
from babbitt.app.units import from_si
from babbitt.core.language import language, phrases, translated
from babbitt.core.notices import InputError
from babbitt.core.quantities.display import written_in_system
from babbitt.report.names import shown_name
from babbitt.report.view import view_of

if TYPE_CHECKING:
    import xarray

__all__ = ["Map", "Sheet", "chart_of", "fields_file", "maps_of"]

SHOWN = {"Pa": "MPa", "m": "um", "K": "degC", "rad": "deg"}
"""Unit of a chart for one of SI."""

AROUND, ACROSS = "theta", "z"
"""Names of the places in the fields of every kind: angle, and place along the shaft."""

INK = "#76808b"
"""Of words in a chart: legible on a light page and on a dark one."""

EYE = {"x": 1.05, "y": -2.2, "z": 1.05}
"""Where a surface is seen from, in its own size: far enough for a narrow page."""

BELOW = {"orientation": "h", "y": 0.0, "yanchor": "top", "thickness": 12}
"""A scale of colours under a surface, which then has the whole width."""

MOST_PLACES = 181
"""Places along one side of a chart; a finer grid is thinned."""


@dataclass(frozen=True)
class Sheet:
    """Values over one film, of a bearing or of one pad of it.

    Attributes
    ----------
    angles : tuple of float
        Degrees, rising.
    widths : tuple of float
        Along the shaft; empty for what is known over the angle alone.
    values : tuple of tuple of float or None
        A row for each width (one row without widths), None where there is no value.
    """

    angles: tuple[float, ...]
    widths: tuple[float, ...]
    values: tuple[tuple[float | None, ...], ...]


@dataclass(frozen=True)
class Map:
    """One field of one bearing, its short name in words, and the unit of places along the shaft."""

    bearing: str
    name: str
    title: str
    meaning: str
    unit: str
    width_unit: str
    sheets: tuple[Sheet, ...]


def maps_of(text: str) -> tuple[Map, ...]:
    """All fields of all bearings of a case whose method has some."""
    found: list[Map] = []
    for solution in solved(text).solutions:
        fields = view_of(solution.result).fields
        if fields is not None and solution.result.outcome.solved:
            found += _maps(fields(solution), shown_name(solution.result.name))
    return tuple(found)


def fields_file(text: str) -> bytes:
    """The fields of all films of a case in one file, as `babbitt solve --fields` saves them.

    Raises
    ------
    CaseError
        With all that is wrong with the case.
    InputError
        E004 without a film, E007 where a package for it is not installed, E003 where no film has a solution.
    """
    from babbitt.report.fields import write_machine_fields

    with TemporaryDirectory(prefix="babbitt-") as folder:
        file = Path(folder) / "fields.nc"
        left_out = write_machine_fields(solved(text), file)
        if not file.exists():
            raise InputError("E003", f"no film has a solution: {', '.join(left_out)}")
        return file.read_bytes()


def _maps(fields: xarray.Dataset, bearing: str) -> Iterator[Map]:
    around, across = fields[AROUND], fields[ACROSS]
    film = dict.fromkeys((*around.dims, *across.dims))
    for name in fields.data_vars:
        one = fields[name]
        if name in (AROUND, ACROSS) or not one.dims:
            continue
        over_width = set(one.dims) == set(film) and len(film) > len(around.dims)
        if not over_width and one.dims != around.dims:
            continue
        si, width_unit = one.attrs["units"], written_in_system("mm")
        unit = written_in_system(SHOWN[si]) if si in SHOWN else ""
        said = unit.replace("deg", "°").replace("um", "µm") or ("" if si == "1" else si)
        values = from_si(np.asarray(one.transpose(*film) if over_width else one, float), unit)
        places = from_si(across.values, width_unit) if over_width else None
        sheets = tuple(_sheets(around.values, places, values))
        title = phrases(language()).get(f"field {name}") or str(name).replace("_", " ")
        yield Map(bearing, str(name), title, translated(one.attrs["long_name"]), said, width_unit, sheets)


def _sheets(around: Any, across: Any, values: Any) -> Iterator[Sheet]:
    """One sheet, or one for each pad where the angles have a row for each."""
    pads = range(len(around)) if around.ndim == 2 else (slice(None),)
    for pad in pads:
        angles = np.degrees(around[pad])
        widths = None if across is None else across[pad] if across.ndim == 2 else across
        yield _sheet(angles, widths, values[pad])


def _sheet(angles: Any, widths: Any, values: Any) -> Sheet:
    thin = max(1, -(-angles.size // MOST_PLACES))
    angles, values = angles[::thin], values[::thin]
    if widths is None:
        return Sheet(tuple(map(float, angles)), (), (_finite(values),))
    rows = tuple(_finite(row) for row in np.atleast_2d(values).T)
    return Sheet(tuple(map(float, angles)), tuple(map(float, widths)), rows)


def _finite(row: Any) -> tuple[float | None, ...]:
    return tuple(float(f"{value:.5g}") if np.isfinite(value) else None for value in row)


def chart_of(found: Map, as_surface: bool) -> dict[str, Any]:
    """A field as a chart for Plotly: a line over the angle, colours over the unrolled film, or a surface."""
    over_width = bool(found.sheets[0].widths)
    title = f"{found.title} {found.unit}".strip()
    angle, width = {"title": {"text": "φ °"}}, {"title": {"text": f"z {found.width_unit}"}}
    base = {
        "paper_bgcolor": "rgba(0,0,0,0)", "plot_bgcolor": "rgba(0,0,0,0)", "font": {"color": INK},
        "margin": {"l": 60, "r": 20, "t": 30, "b": 50}, "showlegend": False,
    }  # fmt: skip
    config = {"displaylogo": False, "responsive": False}
    if not over_width:
        lines = [
            {"type": "scatter", "mode": "lines", "x": sheet.angles, "y": sheet.values[0]} for sheet in found.sheets
        ]
        return {
            "data": lines,
            "layout": {**base, "xaxis": angle, "yaxis": {"title": {"text": title}}},
            "config": config,
        }
    kind = "surface" if as_surface else "heatmap"
    data = [
        {"type": kind, "x": sheet.angles, "y": sheet.widths, "z": sheet.values, "coloraxis": "coloraxis"}
        for sheet in found.sheets
    ]
    layout: dict[str, Any] = {
        **base,
        "coloraxis": {"colorscale": "Viridis", "colorbar": {"title": {"text": title, "side": "right"}}},
    }
    if as_surface:
        layout["coloraxis"]["colorbar"] = BELOW | {"title": {"text": title, "side": "top"}}
        names = {"xaxis": angle, "yaxis": width, "zaxis": {"title": {"text": ""}}}
        layout["scene"] = {**names, "aspectratio": {"x": 1.35, "y": 0.9, "z": 0.75}, "camera": {"eye": EYE}}
        layout["margin"] = {"l": 0, "r": 0, "t": 0, "b": 60}
        return {"data": data, "layout": layout, "config": config}
    return {"data": data, "layout": {**layout, "xaxis": angle, "yaxis": width}, "config": config}
