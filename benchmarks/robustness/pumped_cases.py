"""Random plausible hydrostatic bearings, jacking pockets and footsteps, as case files would have them.

Sizes, gaps, pressures and restrictors are drawn in the dimensionless ranges that builders use, then given
units: the
restrictor by the pressure ratio it is to give at the gap, the load by the load that the recesses carry there. One
in five is loaded far beyond or below that. One seed gives one case.
"""

from __future__ import annotations

import math
import random
from typing import Any

__all__ = [
    "footstep_case",
    "hydrostatic_journal_case",
    "hydrostatic_pad_case",
    "hydrostatic_thrust_ring_case",
    "jacking_case",
]

Case = dict[str, Any]


def hydrostatic_pad_case(rng: random.Random) -> Case:
    """One pad with one recess: round, annular or rectangular.

    Parameters
    ----------
    rng : random.Random
    """
    kind = rng.choice(("circular", "annular", "rectangular"))
    size = _log(rng, 0.03, 0.6)
    pad: Case = {"kind": kind}
    if kind == "circular":
        share = rng.uniform(0.3, 0.8)
        pad |= {"diameter": _mm(size), "recess_diameter": _mm(share * size)}
        area = math.pi * size**2 * (1.0 - share**2) / (8.0 * math.log(1.0 / share))
        squares = math.pi / math.log(1.0 / share)
    elif kind == "annular":
        inner = rng.uniform(0.3, 0.7)
        land = 0.5 * (1.0 - inner) * rng.uniform(0.3, 0.8)
        pad |= {
            "outer_diameter": _mm(size),
            "inner_diameter": _mm(inner * size),
            "recess_inner_diameter": _mm((inner + land) * size),
            "recess_outer_diameter": _mm((1.0 - land) * size),
        }
        area = 0.25 * math.pi * size**2 * (1.0 - inner**2) * 0.7
        squares = math.pi * (1.0 / math.log(1.0 / (1.0 - land)) + 1.0 / math.log(1.0 + land / inner))
    else:
        width = size * rng.uniform(0.3, 1.0)
        land = 0.5 * width * rng.uniform(0.2, 0.6)
        aside = land if rng.random() < 0.6 else min(0.45 * size, land * rng.uniform(0.7, 1.6))
        pad |= {
            "length": _mm(size),
            "width": _mm(width),
            "recess_length": _mm(size - 2.0 * aside),
            "recess_width": _mm(width - 2.0 * land),
        }
        area = (size - aside) * (width - land)
        squares = 2.0 * (size + width) / land
    case = _pumped(rng, "hydrostatic_pad", "Random pad", 1, squares * _gap(rng, size) ** 3 / 6.0)
    case["pad"] = pad
    _duty(rng, case, area, size)
    speed = _log(rng, 0.05, 20.0)
    if rng.random() < 0.8:
        if kind == "rectangular":
            case["sliding_speed"] = f"{speed:.4g} m/s"
        else:
            case["speed"] = f"{speed / (0.5 * size) * 30.0 / math.pi:.5g} rpm"
    return case


def hydrostatic_thrust_ring_case(rng: random.Random) -> Case:
    """One ring with several recesses, level or under a moment.

    Parameters
    ----------
    rng : random.Random
    """
    size, inner = _log(rng, 0.06, 2.0), rng.uniform(0.35, 0.75)
    land = 0.5 * (1.0 - inner) * rng.uniform(0.3, 0.7)
    number = rng.choice((3, 4, 4, 6, 8, 12))
    gap = _gap(rng, size)
    squares = math.pi * (1.0 / math.log(1.0 / (1.0 - land)) + 1.0 / math.log(1.0 + land / inner)) / number
    case = _pumped(rng, "hydrostatic_thrust_ring", "Random ring", number, squares * gap**3 / 6.0)
    case |= {
        "outer_diameter": _mm(size),
        "inner_diameter": _mm(inner * size),
        "recess_inner_diameter": _mm((inner + land) * size),
        "recess_outer_diameter": _mm((1.0 - land) * size),
        "recesses": _row(rng, number, 0.0),
    }
    load = _duty(rng, case, 0.6 * 0.25 * math.pi * size**2 * (1.0 - inner**2), size)
    if load and rng.random() < 0.6:
        arm = load * size * 0.5 * _log(rng, 0.002, 0.15)
        turn = rng.uniform(-math.pi, math.pi)
        case["moments"] = [f"{arm * math.cos(turn):.5g} N m", f"{arm * math.sin(turn):.5g} N m"]
    if rng.random() < 0.8:
        case["speed"] = f"{rng.choice((-1, 1)) * _log(rng, 0.05, 20.0) / (0.5 * size) * 30.0 / math.pi:.5g} rpm"
    return case


def hydrostatic_journal_case(rng: random.Random) -> Case:
    """One journal bearing with recesses, at rest or turning.

    Parameters
    ----------
    rng : random.Random
    """
    diameter, share = _log(rng, 0.03, 0.6), rng.uniform(0.5, 1.3)
    clearance, width = 0.5 * diameter * _log(rng, 3e-4, 1.5e-3), diameter * share
    number, land = rng.choice((3, 4, 4, 4, 6, 8)), rng.uniform(0.08, 0.3)
    conductance = diameter * math.pi * clearance**3 / (6.0 * land * width) / number
    case = _pumped(rng, "hydrostatic_journal", "Random journal bearing", number, conductance)
    case |= {
        "diameter": _mm(diameter),
        "width": _mm(width),
        "radial_clearance": f"{1e6 * clearance:.5g} um",
        "recesses": _row(rng, number, rng.choice((0.0, 0.0, 6.0))),
        "recess_length": _mm((1.0 - 2.0 * land) * width),
    }
    case.pop("gap", None)
    load = _duty(rng, case, 0.5 * diameter * width, diameter, gap="")
    if load:
        case["load_angle"] = f"{rng.uniform(-180.0, 180.0):.5g} deg"
    else:
        case["eccentricity_ratio"] = round(rng.uniform(0.0, 0.9), 3)
        case["attitude_angle"] = f"{rng.uniform(-180.0, 180.0):.5g} deg"
        case["load_angle"] = f"{rng.uniform(-180.0, 180.0):.5g} deg"
    if rng.random() < 0.75:
        surface = rng.choice((-1, 1)) * _log(rng, 0.1, 40.0)
        case["speed"] = f"{surface / (0.5 * diameter) * 30.0 / math.pi:.5g} rpm"
    return case


def jacking_case(rng: random.Random) -> Case:
    """One plain bearing with jacking pockets.

    Parameters
    ----------
    rng : random.Random
    """
    diameter, share = _log(rng, 0.08, 0.9), rng.uniform(0.5, 1.2)
    clearance = 0.5 * diameter * _log(rng, 8e-4, 3e-3)
    number = rng.choice((1, 1, 2, 2, 4))
    middles = {1: (0.0,), 2: (-20.0, 20.0), 4: (-45.0, -15.0, 15.0, 45.0)}[number]
    aside = 0.0 if rng.random() < 0.5 else rng.gauss(0.0, 6.0)
    spread = rng.uniform(0.8, 1.3)
    case: Case = {
        "babbitt": 1,
        "kind": "jacking_pocket",
        "name": "Random jacking",
        "method": rng.choice(("film", "film", "quick")),
        "accuracy": rng.choice(("draft", "engineering")),
        "diameter": _mm(diameter),
        "width": _mm(diameter * share),
        "radial_clearance": f"{1e6 * clearance:.5g} um",
        "pockets": {
            "number": number,
            "angles": [f"{-90.0 + spread * middle + aside:.5g} deg" for middle in middles],
            "extent": f"{rng.uniform(6.0, 18.0):.4g} deg",
        },
        "pocket_length": _mm(diameter * share * rng.uniform(0.1, 0.5)),
        "viscosity": f"{_log(rng, 30.0, 400.0):.4g} mPa s",
        "load": f"{_log(rng, 0.3, 3.0) * 1e3 * diameter**2 * share:.5g} kN",
        "roughness": f"{(roughness := _log(rng, 0.5, 5.0)):.3g} um",
    }
    if number > 1 and rng.random() < 0.3:
        case["own_restrictors"] = False
    if rng.random() < 0.5:
        gap = 1e6 * clearance * _log(rng, 0.06, 0.5)
        case["lift_gap"] = f"{max(gap, 1.1 * roughness):.4g} um"
    else:
        case["pump_flow"] = f"{_log(rng, 1e-3, 1.0) * 3.0 * diameter**2:.4g} L/min"
    if rng.random() < 0.5:
        case["relief_pressure"] = f"{_log(rng, 5.0, 40.0):.4g} MPa"
    return case


def footstep_case(rng: random.Random) -> Case:
    """One footstep of a screw pump, smooth and grooved, by either method.

    Parameters
    ----------
    rng : random.Random
    """
    radius = _log(rng, 0.008, 0.06)
    angle, starts = rng.uniform(5.0, 25.0), rng.choice((3, 4, 5, 5, 6, 8, 12, 20))
    pitch = 2.0 * math.pi * radius * math.sin(math.radians(angle)) / starts
    share = rng.uniform(0.2, 0.6)
    case: Case = {
        "babbitt": 1,
        "kind": "screw_heel",
        "name": "Random footstep",
        "method": rng.choice(("superposition", "narrow_groove")),
        "heel": {
            "length": _mm(radius * rng.uniform(0.8, 2.5)),
            "radius": _mm(radius),
            "recess_radius": _mm(radius * rng.uniform(0.45, 0.75)),
            "bore_radius": _mm(radius * rng.uniform(0.12, 0.35)),
            "recess_depth": _mm(radius * rng.uniform(0.05, 0.3)),
        },
        "groove": {
            "angle": f"{angle:.6g} deg",
            "depth": f"{_log(rng, 0.08, 0.6):.4g} mm",
            "groove_width": f"{1e3 * share * pitch:.6g} mm",
            "land_width": f"{1e3 * (1.0 - share) * pitch:.6g} mm",
            "starts": starts,
        },
        "face_gap": f"{_log(rng, 5.0, 80.0):.4g} um",
        "clearance": f"{_log(rng, 6.0, 60.0):.4g} um",
        "oil": {
            "viscosity": f"{_log(rng, 8.0, 120.0):.4g} mPa s",
            "temperature": f"{rng.uniform(20.0, 60.0):.4g} degC",
            "viscosity_exponent": f"{rng.choice((0.0, 0.02, 0.026, 0.035))} 1/K",
            "volumetric_heat_capacity": "1.76 MJ/(m3 K)",
            "density": "880 kg/m3",
        },
        "speed": f"{_log(rng, 300.0, 6000.0):.5g} rpm",
        "supply_pressure": f"{_log(rng, 0.2, 6.0):.4g} MPa",
        "ambient_pressure": "0.101 MPa",
    }
    if case["method"] == "narrow_groove" and rng.random() < 0.7:
        case["wall"] = {
            "temperature": f"{rng.uniform(20.0, 60.0):.4g} degC",
            "conductance": f"{_log(rng, 0.1, 50.0):.4g} W/K",
        }
    if rng.random() < 0.2:
        case["eccentricity_ratio"] = round(rng.uniform(0.0, 0.8), 3)
    return case


def _pumped(rng: random.Random, kind: str, name: str, number: int, conductance: float) -> Case:
    """What all hydrostatic bearings have; conductance of the lands of one recess times viscosity, m3."""
    viscosity, supply = _log(rng, 5e-3, 0.15), _log(rng, 0.8e6, 15e6)
    case: Case = {
        "babbitt": 1,
        "kind": kind,
        "name": name,
        "method": rng.choice(("film", "quick")),
        "accuracy": rng.choice(("draft", "draft", "engineering")),
        "recess_oil": {"depth": f"{_log(rng, 0.5, 4.0):.3g} mm"},
        "supply": {"pressure": f"{1e-6 * supply:.5g} MPa"},
    }
    if rng.random() < 0.3:
        grade = rng.choice((10, 22, 32, 46, 68))
        case["oil"] = {"lubricant": f"ISO VG {grade}", "supply_temperature": f"{rng.uniform(25.0, 50.0):.3g} degC"}
        viscosity = 0.87e-3 * grade
    else:
        case["oil"] = {"viscosity": f"{1e3 * viscosity:.5g} mPa s"}
    ratio = rng.uniform(0.2, 0.85)
    land = conductance / viscosity
    flow = ratio * supply * land
    case["restrictor"] = _restrictor(rng, flow, (1.0 - ratio) * supply, supply, viscosity)
    if case["restrictor"]["kind"] not in ("constant_flow", "metered_flow") and rng.random() < 0.15:
        case["supply"] = {
            "pump_flow": f"{6e4 * number * flow * rng.uniform(1.0, 1.6):.5g} L/min",
            "relief_pressure": f"{1e-6 * supply:.5g} MPa",
        }
    if rng.random() < 0.2:
        case["frequencies"] = [f"{_log(rng, 5.0, 500.0):.4g} Hz"]
    return case


def _restrictor(rng: random.Random, flow: float, drop: float, supply: float, viscosity: float) -> Case:
    kind = rng.choice(
        (
            "capillary",
            "capillary",
            "orifice",
            "slot",
            "constant_flow",
            "metered_flow",
            "flow_valve",
            "membrane_valve",
        )
    )
    litres = 6e4 * flow
    per_drop = 6e10 * flow / drop
    if kind == "capillary":
        length = _log(rng, 0.03, 0.3)
        bore = (128.0 * viscosity * length * flow / (math.pi * drop)) ** 0.25
        allowed = min(max(1e3 * bore, 0.06), 20.0)
        made: Case = {"kind": kind, "diameter": f"{allowed:.4g} mm", "length": _mm(length)}
        if rng.random() < 0.2:
            made["check_valve"] = True
        return made
    if kind == "orifice":
        bore = math.sqrt(flow / (0.6 * 0.25 * math.pi * math.sqrt(2.0 * drop / 870.0)))
        return {"kind": kind, "diameter": f"{min(max(1e3 * bore, 0.06), 20.0):.4g} mm"}
    if kind == "slot":
        gap = _log(rng, 0.05e-3, 0.3e-3)
        length = _log(rng, 0.005, 0.05)
        width = flow * 12.0 * viscosity * length / (gap**3 * drop)
        return {
            "kind": kind,
            "width": f"{min(max(1e3 * width, 0.12), 9e3):.4g} mm",
            "gap": f"{1e3 * gap:.4g} mm",
            "length": _mm(length),
        }
    if kind in ("constant_flow", "metered_flow"):
        return {"kind": kind, "flow": f"{litres:.5g} L/min"}
    if kind == "flow_valve":
        gain = litres / (1e-6 * supply) * _log(rng, 0.02, 1.0)
        return {
            "kind": kind,
            "flow": f"{litres * rng.uniform(0.4, 1.0):.5g} L/min",
            "gain": f"{gain:.5g} L/(min MPa)",
            "open_conductance": f"{per_drop * _log(rng, 2.0, 40.0):.5g} L/(min MPa)",
        }
    return {
        "kind": kind,
        "conductance": f"{per_drop / rng.uniform(1.5, 4.0):.5g} L/(min MPa)",
        "compliance": f"{_log(rng, 0.05, 0.6) / (1e-6 * supply):.4g} 1/MPa",
    }


def _row(rng: random.Random, number: int, groove: float) -> Case:
    pitch = 360.0 / number
    row: Case = {"number": number, "extent": f"{rng.uniform(0.4, 0.8) * (pitch - groove):.5g} deg"}
    if groove:
        row["drain_groove"] = f"{groove:g} deg"
    row["first"] = f"{rng.choice((-90.0, round(rng.uniform(-180.0, 180.0), 2)))} deg"
    return row


def _duty(rng: random.Random, case: Case, area: float, size: float, gap: str = "gap") -> float:
    """Load in N, zero where the case gives a position."""
    if rng.random() < 0.15:
        if gap:
            case[gap] = f"{1e6 * _gap(rng, size):.4g} um"
        return 0.0
    pressure = 1e6 * float((case["supply"].get("pressure") or case["supply"]["relief_pressure"]).split()[0])
    share = rng.uniform(0.1, 0.75) if rng.random() < 0.8 else _log(rng, 1e-4, 1e3)
    load = min(max(share * area * pressure, 2.0), 1e9)
    case["load"] = f"{load:.6g} N"
    if rng.random() < 0.4:
        case["least_gap"] = f"{1e6 * 0.3 * _gap(rng, size):.4g} um"
    return load


def _gap(rng: random.Random, size: float) -> float:
    """Gap that builders take for a size, m."""
    return min(max(2e-4 * math.sqrt(size), 10e-6), 150e-6) * rng.uniform(0.5, 1.5)


def _mm(length: float) -> str:
    return f"{1e3 * length:.6g} mm"


def _log(rng: random.Random, low: float, high: float) -> float:
    return low * (high / low) ** rng.random()
