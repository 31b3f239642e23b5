"""Random plausible journal bearings for every method, as case files would have them.

Proportions, surface speeds and specific loads are drawn in the ranges that builders use, then given units. One
seed gives one case.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from typing import Any

__all__ = ["JOURNALS"]

Case = dict[str, Any]
Random = random.Random


def iso7902(rng: Random) -> Case:
    """Bearing of the standard, fed by one of its elements and cooled by oil or by its housing."""
    case = _bearing(rng, "iso7902", (0.3, 8.0))
    width = float(case["width"].split()[0])
    place = rng.choice(("opposite", "side", "both_sides"))
    case["supply_element"] = rng.choice(
        (
            {"kind": "hole", "diameter": f"{rng.uniform(0.06, 0.15) * width:.4g} mm", "place": place},
            {"kind": "pocket", "width": f"{rng.uniform(0.3, 0.65) * width:.4g} mm", "place": place},
        )
    )
    case["span"] = rng.choice(("360 deg", "360 deg", "180 deg"))
    case["surfaces"] = {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um"}
    return case


def film_grooved(rng: Random) -> Case:
    """Grooved bore at one temperature, sometimes tilted or crowned."""
    case = _film(rng, (0.2, 5.0))
    case["grooves"] = _grooves(rng)
    if rng.random() < 0.3:
        slope = 0.3e-3 * rng.random()
        case["misalignment"] = {"x": f"{1e3 * slope:.4g} mrad", "y": f"{-700.0 * slope:.4g} mrad"}
    if rng.random() < 0.2:
        case["cavitation"] = "reynolds"
    if rng.random() < 0.2:
        case["cavitation_pressure"] = "-50 kPa"
    return case


def film_pockets(rng: Random) -> Case:
    """Bore fed by pockets or holes, with or without a groove."""
    case = _film(rng, (0.2, 4.0))
    first, width = rng.uniform(-180.0, 180.0), float(case["width"].split()[0])
    if rng.random() < 0.5:
        case["pockets"] = [
            {"angle": _degrees(first + turn), "extent": f"{rng.uniform(10.0, 50.0):.4g} deg",
             "width": f"{rng.uniform(0.2, 0.8) * width:.4g} mm"}
            for turn in rng.choice(((0.0,), (0.0, 180.0)))
        ]  # fmt: skip
    else:
        case["holes"] = [
            {"angle": _degrees(first + turn), "diameter": f"{rng.uniform(0.06, 0.15) * width:.4g} mm"}
            for turn in rng.choice(((0.0,), (0.0, 180.0), (0.0, 120.0, 240.0)))
        ]
    return case


def film_lobed(rng: Random) -> Case:
    """Two to four lobes with preload."""
    case = _film(rng, (0.1, 2.5))
    count, first = rng.choice((2, 3, 4)), rng.uniform(-180.0, 180.0)
    case["grooves"] = [{"angle": _degrees(first + 360.0 * k / count), "extent": "20 deg"} for k in range(count)]
    case["bore"] = {"kind": "lobes", "preload": round(rng.uniform(0.1, 0.6), 3)}
    return case


def film_turbulent(rng: Random) -> Case:
    """Large and fast grooved bearing whose film may be turbulent."""
    case = _film(rng, (0.5, 3.0), (150.0, 600.0), (30.0, 90.0))
    case["grooves"] = _grooves(rng)
    case["turbulence"] = rng.choice(("ng_pan", "constantinescu"))
    return case


def film_thermal(rng: Random) -> Case:
    """Grooved film with its own temperatures."""
    case = _film(rng, (0.3, 4.0), (60.0, 300.0), (3.0, 40.0))
    case["grooves"] = _grooves(rng)
    case["thermal"] = rng.choice(("adiabatic", "full"))
    if case["thermal"] == "full":
        outer = 1.25 * float(case["diameter"].split()[0])
        case["walls"] = {"bush": {"outer_diameter": f"{outer:.5g} mm", "conductivity": "46 W/(m K)"},
                         "housing": {"outer_diameter": f"{1.5 * outer:.5g} mm", "ambient_temperature": "25 degC",
                                     "heat_transfer_coefficient": "20 W/(m2 K)"}}  # fmt: skip
    return case


def film_elastic(rng: Random) -> Case:
    """Grooved bore that gives way under its pressure, or is displaced by given amounts."""
    case = _film(rng, (0.5, 5.0))
    case["grooves"] = _grooves(rng)
    kind = rng.choice(("ring", "column", "half_space", "displacement"))
    outer = rng.uniform(1.2, 2.0) * float(case["diameter"].split()[0])
    if kind == "displacement":
        clearance = 0.5 * float(case["clearance"]["mean"].split()[0]) * float(case["diameter"].split()[0])
        half, first = 0.5 * float(case["width"].split()[0]), rng.randrange(-180, 180)
        values = [[f"{rng.uniform(-0.1, 0.1) * clearance:.4g} um" for _ in range(3)] for _ in range(12)]
        case["displacement"] = {
            "angles": [f"{first + 30 * row - 360 * (first + 330 > 360)} deg" for row in range(12)],
            "places": [f"{place:.6g} mm" for place in (-half, 0.0, half)],
            "values": values,
        }
    else:
        case["compliance"] = [
            {
                "ring": {"kind": "ring", "outer_diameter": f"{outer:.5g} mm", "elastic_modulus": "200 GPa",
                         "poisson_ratio": 0.3},
                "column": {"kind": "column", "displacement_per_pressure": f"{_log(rng, 0.05, 1.0):.3g} um/MPa"},
                "half_space": {"kind": "half_space", "elastic_modulus": "200 GPa", "poisson_ratio": 0.3},
            }[kind]
        ]  # fmt: skip
    return case


def long_film(rng: Random) -> Case:
    """Infinitely long bearing with heat exchange."""
    case = _bearing(rng, "long_film", (0.5, 4.0), widths=(1.2, 5.0))
    outer = float(case["diameter"].split()[0]) * rng.uniform(1.15, 1.6)
    case["heat_exchange"] = {
        "bush": {"outer_diameter": f"{outer:.5g} mm", "conductivity": "45 W/(m K)"},
        "ambient": {"temperature": "20 degC", "coefficient": f"{rng.uniform(20.0, 400.0):.4g} W/(m2 K)"},
        "shaft_conductance": f"{rng.uniform(0.0, 1.0):.3g} W/K",
    }
    return case


def segments(rng: Random) -> Case:
    """Grooved bearing of the one-dimensional model."""
    case = _bearing(rng, "segments", (1.0, 8.0))
    width = float(case["width"].split()[0])
    case["segments"] = {
        "groove": {
            "kind": rng.choice(("through", "blind")),
            "angle_from_load": f"{rng.uniform(-40.0, -5.0):.4g} deg",
            "width": f"{0.05 * float(case['diameter'].split()[0]):.4g} mm",
            "end_land": f"{0.08 * width:.4g} mm",
        },
        "roughness": {"bearing": "0.63 um", "journal": "0.32 um"},
    }
    if case["segments"]["groove"]["kind"] == "through":
        del case["segments"]["groove"]["end_land"]
    return case


def _film(
    rng: Random, loads: tuple[float, float], diameters: tuple[float, float] = (30.0, 500.0),
    speeds: tuple[float, float] = (1.0, 40.0),
) -> Case:  # fmt: skip
    case = _bearing(rng, "film", loads, diameters, speeds)
    case["accuracy"] = "draft"
    case["load_angle"] = f"{rng.uniform(-180.0, 180.0):.5g} deg"
    if rng.random() < 0.3:
        case["speed"] = "-" + case["speed"]
    return case


def _bearing(
    rng: Random, method: str, loads: tuple[float, float], diameters: tuple[float, float] = (30.0, 500.0),
    speeds: tuple[float, float] = (1.0, 40.0), widths: tuple[float, float] = (0.4, 1.0),
) -> Case:  # fmt: skip
    """Common to all methods: size, clearance by surface speed, oil, load by specific load (MPa)."""
    diameter = _log(rng, *diameters)
    width, surface = diameter * rng.uniform(*widths), _log(rng, *speeds)
    clearance = 0.8 * surface**0.25 * rng.uniform(0.9, 1.5)  # the rule of thumb of ISO 7902-3, per mille
    load = _log(rng, *loads) * diameter * width * 1e-3
    return {
        "babbitt": 1,
        "kind": "journal",
        "name": "Random bearing",
        "method": method,
        "diameter": f"{diameter:.5g} mm",
        "width": f"{width:.5g} mm",
        "clearance": {"kind": "relative", "mean": f"{clearance:.4g} permille"},
        "lubricant": f"ISO VG {rng.choice((32, 46, 68, 100))}",
        "supply": {"temperature": f"{rng.uniform(35.0, 60.0):.3g} degC",
                   "pressure": f"{rng.uniform(0.03, 0.3):.3g} MPa"},
        "materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"},
        "load": f"{load:.5g} kN",
        "speed": f"{surface / (0.5e-3 * diameter) * 30.0 / math.pi:.5g} rpm",
    }  # fmt: skip


def _grooves(rng: Random) -> list[Case]:
    count, first = rng.choice((1, 2, 2, 3)), rng.uniform(-180.0, 180.0)
    extent = rng.uniform(5.0, 30.0)
    return [{"angle": _degrees(first + 360.0 * k / count), "extent": f"{extent:.4g} deg"} for k in range(count)]


def _degrees(angle: float) -> str:
    return f"{math.remainder(angle, 360.0):.5g} deg"


def _log(rng: Random, low: float, high: float) -> float:
    return math.exp(rng.uniform(math.log(low), math.log(high)))


JOURNALS: dict[str, Callable[[Random], Case]] = {
    "iso7902": iso7902,
    "film, grooved": film_grooved,
    "film, pockets": film_pockets,
    "film, lobed": film_lobed,
    "film, turbulent": film_turbulent,
    "film, thermal": film_thermal,
    "film, elastic": film_elastic,
    "long film": long_film,
    "segments": segments,
}
"""Generators by family."""
