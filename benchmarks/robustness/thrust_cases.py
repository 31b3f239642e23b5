"""Random plausible thrust bearings and shaft lines, as case files would have them.

Sizes, speeds and loads are drawn in the dimensionless ranges that builders use, then given units. One seed gives
one case.
"""

from __future__ import annotations

import copy
import math
import random
from typing import Any

__all__ = ["on_other_pads", "thrust_case", "thrust_line_case"]

Case = dict[str, Any]


def thrust_case(rng: random.Random) -> Case:
    """One thrust bearing.

    Parameters
    ----------
    rng : random.Random
    """
    case: Case = {"babbitt": 1, "kind": "thrust", "name": "Random thrust bearing", **_bearing(rng)}
    if rng.random() < 0.2:
        case["film"] = _written(_log(rng, 20.0, 150.0), "um")
    else:
        case["thrust"] = _thrust(rng, case)
    if rng.random() < 0.3:
        case["runout"] = _runout(rng)
    return case


def thrust_line_case(rng: random.Random) -> Case:
    """One shaft line on its thrust bearing.

    Parameters
    ----------
    rng : random.Random
    """
    case: Case = {"babbitt": 1, "kind": "thrust_line", "name": "Random shaft line", **_bearing(rng)}
    case["thrust"] = _thrust(rng, case)
    outer = float(case["pads"]["outer_radius"].split()[0])
    diameter = 2.0 * rng.uniform(0.55, 0.95) * float(case["pads"]["inner_radius"].split()[0])
    pieces = rng.choice((1, 1, 2, 3))
    case["shaft"] = [
        {
            "length": _written(_log(rng, 1.0, 40.0), "m"),
            "diameter": _written(diameter * rng.uniform(0.8, 1.0), "mm"),
        }
        for _ in range(pieces)
    ]
    for piece in case["shaft"]:
        if rng.random() < 0.3:
            piece["bore"] = _written(0.4 * diameter, "mm")
    mass = 7850.0 * (1e-3 * diameter) ** 2 * 20.0
    case["collar_mass"] = _written(_log(rng, 0.05, 1.0) * mass, "kg")
    case["propeller"] = {"mass": _written(_log(rng, 0.1, 3.0) * mass, "kg"), "blades": rng.choice((3, 4, 5, 6))}
    if rng.random() < 0.7:
        case["propeller"]["damping"] = _written(_log(rng, 1.0, 100.0) * (outer / 375.0) ** 2, "kN s/m")
    case["pads"]["mass"] = _written(_log(rng, 0.3, 3.0) * 18.0 * (outer / 375.0) ** 3, "kg")
    if rng.random() < 0.5:
        inertia = 0.05 * _log(rng, 0.3, 3.0) * (outer / 375.0) ** 5
        case["pads"] |= {"inertia_radial": _written(inertia, "kg m2"), "inertia_along": _written(inertia, "kg m2")}
    if rng.random() < 0.9:
        case["ripple"] = [{"share": f"{100.0 * _log(rng, 0.01, 0.15):.3g} %"}]
        if rng.random() < 0.3:
            case["ripple"].append({"share": f"{_log(rng, 0.3, 4.0):.3g} %", "blade_multiple": 2})
    if rng.random() < 0.7:
        case["runout"] = _runout(rng)
    if "ring_stiffness" in case and rng.random() < 0.4:
        case["seating"] = {
            "stiffness": _written(_log(rng, 0.3, 5.0), "GN/m"),
            "housing_mass": _written(mass, "kg"),
        }
    return case


def _bearing(rng: random.Random) -> Case:
    outer = _log(rng, 40.0, 900.0)
    inner = outer * rng.uniform(0.38, 0.7)
    number = rng.choice((3, 4, 5, 6, 6, 8, 8, 8, 10, 12, 16))
    extent = 360.0 / number * rng.uniform(0.6, 0.88)
    surface = _log(rng, 1.0, 50.0)
    rpm = surface / (0.5e-3 * (outer + inner)) * 30.0 / math.pi
    pads: Case = {
        "number": number,
        "inner_radius": _written(inner, "mm"),
        "outer_radius": _written(outer, "mm"),
        "extent": _written(extent, "deg"),
    }
    kind = rng.choice(("point", "point", "point", "line", "fixed"))
    backward = False
    if kind == "fixed":
        pads["pivot"] = {"kind": "fixed"}
        pads["face"] = {
            "kind": rng.choice(("taper", "step")),
            "depth": _written(outer * _log(rng, 6e-5, 2.5e-4) * 1e3, "um"),
            "fraction": round(rng.uniform(0.4, 0.85), 3),
        }
    else:
        centre = rng.random() < 0.15
        fraction = 0.5 if centre else round(rng.uniform(0.54, 0.65), 3)
        centroid = 2.0 / 3.0 * (outer**3 - inner**3) / (outer**2 - inner**2)
        pads["pivot"] = {
            "kind": kind,
            "radius": _written(centroid * rng.uniform(0.985, 1.015), "mm"),
            "fraction": fraction,
        }
        if rng.random() < 0.2:
            pads["crown"] = _written(outer * _log(rng, 1e-5, 1e-4) * 1e3, "um")
            backward = rng.random() < 0.5
    if rng.random() < 0.3:
        pads["heights"] = [f"{rng.uniform(-5.0, 5.0):.3g} um" for _ in range(number)]
    case: Case = {"pads": pads, "speed": _written(-rpm if backward else rpm, "rpm")}
    grade = rng.choice((32, 46, 68, 100))
    of_oil = rng.choice(("viscosity", "temperature", "heat_balance", "heat_balance"))
    if of_oil == "viscosity":
        case["oil"] = {"kind": "viscosity", "viscosity": _written(_log(rng, 8.0, 80.0), "mPa s")}
    elif of_oil == "temperature":
        at = f"{rng.uniform(40.0, 75.0):.3g} degC"
        case["oil"] = {"kind": "temperature", "lubricant": f"ISO VG {grade}", "temperature": at}
    else:
        at = f"{rng.uniform(35.0, 50.0):.3g} degC"
        case["oil"] = {"kind": "heat_balance", "lubricant": f"ISO VG {grade}", "supply_temperature": at}
        if rng.random() < 0.3:
            case["thermal"] = "adiabatic"
    if rng.random() < 0.5:
        case["ring_stiffness"] = _written(_log(rng, 0.3, 50.0), "GN/m")
    if rng.random() < 0.5:
        case["tilt"] = {
            "offset": f"{_log(rng, 2.0, 60.0):.3g} um",
            "direction": f"{rng.uniform(-180, 180):.3g} deg",
        }
    if case.get("thermal") != "adiabatic" and rng.random() < 0.15:
        case["turbulence"] = rng.choice(("ng_pan", "constantinescu"))
    return case


def _thrust(rng: random.Random, case: Case) -> str:
    pads = case["pads"]
    inner, outer = (1e-3 * float(pads[f"{end}_radius"].split()[0]) for end in ("inner", "outer"))
    extent = math.radians(float(pads["extent"].split()[0]))
    area = 0.5 * pads["number"] * extent * (outer**2 - inner**2)
    return _written(_log(rng, 0.3, 4.0) * area * 1e3, "kN")


def _runout(rng: random.Random) -> list[Case]:
    waves: list[Case] = [{"amplitude": f"{_log(rng, 0.5, 10.0):.3g} um"}]
    if rng.random() < 0.3:
        waves.append({"amplitude": f"{_log(rng, 0.2, 3.0):.3g} um", "lobes": rng.choice((2, 3, 4))})
    return waves


def on_other_pads(case: Case, rng: random.Random) -> Case:
    """The same bearing with its pads numbered from another one: heights, tilt and runout turn with it."""
    turned = copy.deepcopy(case)
    pads = turned["pads"]
    steps = rng.randrange(1, pads["number"])
    pitch = 360.0 * steps / pads["number"]
    if "heights" in pads:
        pads["heights"] = pads["heights"][-steps:] + pads["heights"][:-steps]
    if "tilt" in turned:
        at = float(turned["tilt"]["direction"].split()[0]) + pitch
        turned["tilt"]["direction"] = f"{at - 360.0 * round(at / 360.0)!r} deg"
    sense = -1.0 if case["speed"].startswith("-") else 1.0
    for wave in turned.get("runout", []):
        later = sense * wave.get("lobes", 1) * pitch
        wave["phase"] = f"{later - 360.0 * round(later / 360.0)!r} deg"
    return turned


def _written(value: float, unit: str) -> str:
    """Four digits, and never three of them after the point, which would read as thousands."""
    digits = f"{value:.4g}"
    return f"{digits}{'0' if len(digits.partition('.')[2]) == 3 else ''} {unit}"


def _log(rng: random.Random, low: float, high: float) -> float:
    return low * (high / low) ** rng.random()
