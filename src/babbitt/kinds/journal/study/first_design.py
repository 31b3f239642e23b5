"""From a duty to first designs of a journal bearing: which widths, fits, oils and feeds are tried, and why."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, cast

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.study import Vary
from babbitt.core.check_text import number, written
from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, read
from babbitt.design.conditions import CheckedProblem, surface_speed
from babbitt.design.screening import recommended_relative_clearance
from babbitt.properties.fits import Clearance
from babbitt.properties.lubricants import catalogue
from babbitt.study.size_choices import JOURNAL_CLASSES

__all__ = ["METHODS", "OUTPUTS", "REASONS", "choices", "duty", "fit_together", "reasons", "shown"]

OUTPUTS = (
    "width_ratio",
    "relative_clearance",
    "specific_load",
    "minimum_film_thickness",
    "outlet_temperature",
    "friction_power",
    "total_flow",
    "starved_minimum_film_thickness",
    "starved_outlet_temperature",
    "side_flow",
    "supply_capacity",
    "recommended_relative_clearance",
)
"""Quantities that proposals are ranked by and shown with."""

WIDTH_RATIOS = (0.4, 1.0)
"""B/D of the widths that are tried. Assumption: what drawings of plain journal bearings usually have."""

STEPS = (1e-3, 2e-3, 5e-3, 10e-3, 20e-3, 50e-3)
"""Widths are whole multiples of one of these lengths, in m."""

STEPS_A_DIAMETER = 20.0
"""The step of the widths is about the diameter over this number."""

BORE_CLASS = "H7"
FITS = 3
"""How many fits are tried: those of `JOURNAL_CLASSES` and c8 with a mean clearance nearest to the recommended."""

NEAR = math.log(1.3)
"""Logarithm of the ratio to the recommended clearance up to which a fit will do (assumption)."""

TOLERANCE = 0.15
"""Of a clearance that no fit has: by which it may be smaller or larger (assumption)."""

POCKET_SHARE = 0.8
"""Width of a pocket over that of the bearing. Assumption."""

HOLE_SHARE, LARGEST_HOLE = 0.1, 20e-3
"""Diameter of a hole over that of the bearing, and in m at most. Assumptions."""

METHODS = ("iso7902", "film")
"""What a proposal is found with, and what confirms it."""

REASONS = {
    "lubricant": "viscosity grades of the catalogue (ISO 3448)",
    "clearance": "fits nearest to the recommended clearance, 0.8e-3 U^(1/4) (Vogelpohl); where none is near, that "
    f"±{TOLERANCE:.0%} (assumption)",
    "width": f"B/D of {WIDTH_RATIOS[0]:g} to {WIDTH_RATIOS[1]:g} in whole steps (assumption)",
    "supply_element": f"pockets of {POCKET_SHARE:g} B at both sides, or a hole of {HOLE_SHARE:g} D, "
    f"at most {1e3 * LARGEST_HOLE:g} mm, opposite the load (assumptions)",
    "method": "the procedure finds, the film confirms",
}

ASSUMED = {
    "supply_temperature": "45 degC",
    "supply_pressure": "0.2 MPa",
    "metal": "SnSb8Cu4",
}


def duty(
    diameter: Any,
    load: Any,
    speed: Any,
    supply_temperature: Any = None,
    supply_pressure: Any = None,
    metal: str | None = None,
) -> dict[str, Any]:
    """A case with a duty, and with what is assumed where the duty does not say it.

    Parameters
    ----------
    diameter, load, speed : quantity
        As a case file has them.
    supply_temperature, supply_pressure : quantity, optional
    metal : str, optional
        Of the catalogue.

    Returns
    -------
    dict
        As a case file says it; every assumption is listed under ``assumptions``.
    """
    given = {"supply_temperature": supply_temperature, "supply_pressure": supply_pressure, "metal": metal}
    taken = {name: ASSUMED[name] if value is None else value for name, value in given.items()}
    assumed = [f"{name.replace('_', ' ')} {ASSUMED[name]}" for name, value in given.items() if value is None]
    try:
        size = read(diameter, "m")
    except QuantityError:  # the case says what is wrong with it
        size = 0.1
    return {
        "kind": "journal",
        "name": f"Bearing for {load} at {speed}, D = {diameter}",
        "diameter": diameter,
        "width_ratio": 0.7,
        "clearance": {"kind": "relative", "mean": "1.5 permille"},
        "span": "360 deg",
        "supply_element": _hole(size),
        "lubricant": "ISO VG 46",
        "supply": {"temperature": taken["supply_temperature"], "pressure": taken["supply_pressure"]},
        "materials": {"bearing_metal": taken["metal"], "bearing": "C10", "journal": "42CrMo4"},
        "surfaces": {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"},
        "load": load,
        "speed": speed,
        "assumptions": [
            f"Not given and assumed: {', '.join([*assumed, 'shell of C10, journal of 42CrMo4'])}.",
            "Roughness Rz of 2 µm in the bore and of 1 µm on the journal is assumed; no tilt, no waviness.",
        ],
    }


def choices(case: CaseFile, given: Mapping[str, Vary]) -> dict[str, Vary]:
    """The fields of a first design with the values that are tried; what is given stays."""
    problem = cast(CheckedProblem, case.calculations()[0].problem)
    diameter = problem.bearing.diameter
    made = dict(given)
    made.setdefault("lubricant", _listed(one.name for one in catalogue() if one.name.startswith("ISO VG")))
    made.setdefault(
        "clearance", _listed(_clearances(diameter, recommended_relative_clearance(surface_speed(problem))))
    )
    made.setdefault("width", _listed(_millimetres(one) for one in _widths(diameter)))
    made.setdefault("supply_element", _listed(_feeds(diameter)))
    made["method"] = _listed(METHODS)
    first = ("lubricant", "clearance", "width", "supply_element")
    return {name: made[name] for name in (*first, *(name for name in made if name not in first))}


def _listed(values: Iterator[Any] | Sequence[Any]) -> Vary:
    return Vary(values=tuple(values))


def _clearances(diameter: float, recommended: float) -> tuple[Any, ...]:
    """Fits whose mean relative clearance is nearest to the recommended one, the narrowest first.

    Where none comes near it, as of large bearings, the recommended clearance itself stands at their end.
    """
    means = {}
    for journal in (*JOURNAL_CLASSES, "c8"):
        try:
            means[f"{BORE_CLASS}/{journal}"] = (
                Clearance.from_tolerance_classes(diameter, BORE_CLASS, journal).mean / diameter
            )
        except InputError:  # of a diameter beyond the tables
            continue
    misses = {fit: abs(math.log(mean / recommended)) for fit, mean in means.items()}
    nearest = sorted(misses, key=misses.__getitem__)[:FITS]
    fits = tuple(sorted(nearest, key=means.__getitem__))
    if min(misses.values(), default=math.inf) <= NEAR:
        return fits
    ends = {
        "mean": recommended,
        "minimum": recommended * (1.0 - TOLERANCE),
        "maximum": recommended * (1.0 + TOLERANCE),
    }
    return (*fits, {"kind": "relative", **{name: f"{1e3 * value:.2f} permille" for name, value in ends.items()}})


def _widths(diameter: float) -> tuple[float, ...]:
    """Widths in whole steps between the usual ratios to the diameter."""
    step = min(STEPS, key=lambda one: abs(math.log(one * STEPS_A_DIAMETER / diameter)))
    low, high = (ratio * diameter / step for ratio in WIDTH_RATIOS)
    return tuple(step * count for count in range(math.ceil(low - 1e-9), math.floor(high + 1e-9) + 1))


def _feeds(diameter: float) -> list[dict[str, Any]]:
    """All feeds of all widths, each once."""
    pockets = [_pocket(width) for width in _widths(diameter)]
    return [*(one for place, one in enumerate(pockets) if one not in pockets[:place]), _hole(diameter)]


def _pocket(width: float) -> dict[str, Any]:
    return {"kind": "pocket", "width": _millimetres(round(POCKET_SHARE * width, 3)), "place": "both_sides"}


def _hole(diameter: float) -> dict[str, Any]:
    return {
        "kind": "hole",
        "diameter": _millimetres(min(max(1e-3, round(HOLE_SHARE * diameter, 3)), LARGEST_HOLE)),
        "place": "opposite",
    }


def _millimetres(length: float) -> str:
    return f"{1e3 * length:.6g} mm"


def fit_together(values: Mapping[str, Any]) -> bool:
    """Whether the values of a row belong together: a pocket of these rules goes with its width."""
    feed, width = values.get("supply_element"), values.get("width")
    if not isinstance(feed, Mapping) or width is None or feed != _pocket(_width_of(feed)):
        return True
    return feed == _pocket(float(width))


def _width_of(feed: Mapping[str, Any]) -> float:
    """The width of bearing that a pocket is made for; nothing that is one for other feeds."""
    return (
        read(feed["width"], "m") / POCKET_SHARE if feed.get("kind") == "pocket" and "extent" not in feed else 0.0
    )


def shown(fields: Mapping[str, Any], values: Mapping[str, float]) -> dict[tuple[str, str], str]:
    """The cells of a design in a table, by heading and unit: what was chosen, and what comes of it."""
    film, outlet = (
        values[f"starved_{name}"] if math.isfinite(values[f"starved_{name}"]) else values[name]
        for name in ("minimum_film_thickness", "outlet_temperature")
    )
    feed = str(fields["supply_element"]).replace("_", " ").replace(",", "")
    return {
        ("lubricant", ""): str(fields["lubricant"]),
        ("clearance", ""): str(fields["clearance"]).replace("permille", "‰").replace("imum", "."),
        ("feed", ""): feed.replace("place ", "").replace("width ", "").replace("diameter ", ""),
        ("B", "mm"): f"{1e3 * fields['width']:.4g}",
        ("ψ", "‰"): f"{1e3 * values['relative_clearance']:.2f}",
        ("p̄", "MPa"): number("specific_load", values["specific_load"]),
        ("h_min", "µm"): number("minimum_film_thickness", film),
        ("T_ex", "°C"): number("outlet_temperature", outlet),
    }


def reasons(values: Mapping[str, float], limits: Mapping[str, float]) -> Iterator[str]:
    """Why a proposal is as it is: the usual rules with its numbers and where they come from.

    Parameters
    ----------
    values : mapping
        `OUTPUTS` in SI, each the worst of the clearances.
    limits : mapping
        By the code of a check its limit.
    """
    pressure = values["specific_load"]
    if (most := limits.get("C105", limits.get("C103"))) is not None:
        yield f"p̄ = {written('specific_load', pressure)} of {written('specific_load', most)} that the metal bears"
    mean, wanted = values["relative_clearance"], values["recommended_relative_clearance"]
    sign = "≥" if mean >= wanted else "<"
    rule = "0.8e-3 U^(1/4) (Vogelpohl)"
    yield f"ψ = {1e3 * mean:.2f} ‰ {sign} {1e3 * wanted:.2f} ‰, the {rule}"
    low, high = WIDTH_RATIOS
    yield f"B/D = {values['width_ratio']:.2f}, usual {low:g} to {high:g} (assumption)"
    share = values["supply_capacity"] / values["side_flow"]
    if math.isfinite(share):
        held = "" if share >= 1.0 else "; the limits are held against the hotter film with that flow"
        yield f"the feed gives {share:.1f} of Q₃ (ISO 7902){held}"
