"""Random hydrostatic bearings, jacking pockets and footsteps solved: what must hold for every one of them.

No traceback, no more than a minute, balances within their bounds or told, no number that is none, and nothing that
depends on the frame, on the sense in which one looks, on the first recess, or on the units of the file.

    python benchmarks/robustness/pumped_trial.py 300
"""

from __future__ import annotations

import math
import random
import re
import sys
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator
from typing import Any

import yaml
from pumped_cases import (
    footstep_case,
    hydrostatic_journal_case,
    hydrostatic_pad_case,
    hydrostatic_thrust_ring_case,
    jacking_case,
)

from babbitt.case import CaseError, parse_case
from babbitt.core.result import Result
from babbitt.solving import solve

Case = dict[str, Any]
MAKERS: dict[str, Callable[[random.Random], Case]] = {
    "pad": hydrostatic_pad_case,
    "ring": hydrostatic_thrust_ring_case,
    "journal": hydrostatic_journal_case,
    "jacking": jacking_case,
    "footstep": footstep_case,
}
LONGEST = 60.0
"""s, of one case and its views; asked by `main` alone: tests look at no clock."""
SAME, SAME_WARM = 1e-9, 1e-6
"""Relative difference allowed between two views of one bearing: films of one temperature, and those that seek
it."""
BALANCED = 1e-6
OF_THE_FRAME = {"wall_time", "iterations", "load_angle", "tilt_x", "tilt_y", "moment_x", "moment_y",
                "mass_balance_error", "energy_balance_error", "network_stability"}  # fmt: skip
SLOPES = {
    "face_gap_stiffness",
    "load_over_clearance",
    "thermal_loop_gain",
    "whirl_frequency_ratio",
    "critical_mass",
    "threshold_speed",
}
"""By differences of values or of stiffnesses, whose round-off is larger."""
WIDER = {"load_capacity": 2e-4, "edge_inertia": 5e-9}
"""Where a film is lost at once, before its gap is the least one, the last load that keeps it is the one from which
the search still finds it: 7e-5 apart in 1 of 94 rings. The inertia is over the lowest pressure of all recesses, of
which the round-off of the others is a larger part (1.7e-9 in 1 of 94)."""
AXES = re.compile(r"^(stiffness|damping)_")
OF_THE_PLACE = {"total_flow", "pumping_power", "pump_power"}
"""Of jacking pockets, with the place to which the shaft rolls: where the sideward force hardly changes, its
round-off of 1e-11 of the whole force moves that by more than round-off (1.5e-9 of the flow in 1 of 94)."""
ROLLED = 1e-8
SMALL = {
    "grid_error": 1e-9,
    "attitude_angle": 1e-7,
    "eccentricity_ratio": 1e-11,  # of the clearance: what is left where recesses nearly cancel under a light load
    "cavitated_share": 1e-9,
    "compressibility_damping_loss": 1e-8,
    "heel_force_along": 1e-9,
    "heel_force_across": 1e-9,
    "minimum_film_thickness": 1e-14,
    "lift": 1e-14,
}
"""Differences allowed of values that are differences themselves, absolute."""


def solved(case: Case) -> tuple[Result, ...]:
    """Results of a case, through its file."""
    return solve(parse_case(yaml.safe_dump(case, sort_keys=False, allow_unicode=True))).results


def faults(case: Case) -> Iterator[str]:
    """What is wrong with the answer to a case."""
    try:
        results = solved(case)
    except CaseError as error:
        yield f"refused: {str(error)[:200]}"
        return
    except Exception:
        yield "traceback: " + traceback.format_exc().strip().splitlines()[-1] + traceback.format_exc()[-700:]
        return
    for result in results:
        yield from faults_of(result, case)
    for name, other in views(case):
        try:
            again = solved(other)
        except Exception as error:
            yield f"{name}: {type(error).__name__} {str(error)[:150]}"
            continue
        yield from differences(name, results, again, case)


def faults_of(result: Result, case: Case) -> Iterator[str]:
    """Of one result by itself."""
    if not result.outcome.solved:
        if not result.message:
            yield "no solution without a message"
        return
    for name, value in result.values.items():
        if not math.isfinite(value):
            yield f"{name} is {value}"
    codes = {notice.code for notice in result.warnings}
    mass = result.values.get("mass_balance_error", math.inf)
    if not mass < BALANCED and not codes & {"W324", "W177"}:
        yield f"mass_balance_error {mass:.2g} untold"
    if result.kind != "screw_heel" and "load" in case and result.kind != "jacking_pocket":
        asked = float(str(case["load"]).split()[0])
        if abs(result.load / asked - 1.0) > BALANCED:
            yield f"carries {result.load:.8g} N of {asked:.8g} N"


def differences(name: str, one: tuple[Result, ...], other: tuple[Result, ...], case: Case) -> Iterator[str]:
    """Between two views of one bearing."""
    if len(one) != len(other):
        yield f"{name}: {len(one)} and {len(other)} results"
        return
    warm = "lubricant" in case.get("oil", {})
    for first, second in zip(one, other, strict=True):
        if first.outcome is not second.outcome:
            yield f"{name}: {first.outcome.name} and {second.outcome.name}"
            continue
        if not first.outcome.solved:
            continue
        for key in first.values:
            if key in OF_THE_FRAME or AXES.match(key):
                continue
            a, b = first.values[key], second.values.get(key, math.nan)
            if key == "attitude_angle" and name == "mirrored":  # counted from the load in one sense of rotation
                a, b = abs(a), abs(b)
            rolled = first.kind == "jacking_pocket" and key in OF_THE_PLACE
            same = SAME_WARM if warm or key in SLOPES else ROLLED if rolled else SAME
            allowed = max(max(same, WIDER.get(key, 0.0)) * abs(a), SMALL.get(key, 0.0))
            if not abs(a - b) <= allowed:
                yield f"{name}: {key} {a!r} and {b!r}"


def views(case: Case) -> Iterator[tuple[str, Case]]:
    """The same bearing seen otherwise."""
    yield "units", in_other_units(case)
    kind = case["kind"]
    if kind == "hydrostatic_journal":
        yield "turned", {**case, "load_angle": turned(case["load_angle"], 37.31), "recesses": row(case, 37.31)}
        yield "mirrored", mirrored(case)
        yield "next recess first", {**case, "recesses": row(case, 360.0 / case["recesses"]["number"])}
    elif kind == "hydrostatic_thrust_ring":
        yield "turned", {**case, "recesses": row(case, 37.31)} | moments(case, 37.31)
        yield "next recess first", {**case, "recesses": row(case, 360.0 / case["recesses"]["number"])}
    elif kind == "jacking_pocket":
        pockets = case["pockets"]
        angles = [f"{-180.0 - degrees(angle)!r} deg" for angle in pockets["angles"]]
        yield "mirrored", {**case, "pockets": {**pockets, "angles": angles}}
        yield "other order", {**case, "pockets": {**pockets, "angles": pockets["angles"][::-1]}}


def degrees(text: str) -> float:
    """Number before the unit."""
    return float(text.split()[0])


def turned(text: str, by: float) -> str:
    """An angle, turned."""
    return f"{math.remainder(degrees(text) + by, 360.0)!r} deg"


def row(case: Case, by: float) -> Case:
    """Recesses, turned."""
    return {**case["recesses"], "first": turned(case["recesses"]["first"], by)}


def moments(case: Case, by: float) -> Case:
    """Moments of a load, turned."""
    if "moments" not in case:
        return {}
    x, y = (degrees(one) for one in case["moments"])
    c, s = math.cos(math.radians(by)), math.sin(math.radians(by))
    return {"moments": [f"{c * x - s * y!r} N m", f"{s * x + c * y!r} N m"]}


def mirrored(case: Case) -> Case:
    """A journal bearing seen from its other end: x turns round, and with it the sense of rotation."""
    other = {**case, "load_angle": f"{math.remainder(180.0 - degrees(case['load_angle']), 360.0)!r} deg"}
    first = math.remainder(180.0 - degrees(case["recesses"]["first"]), 360.0)
    other["recesses"] = {**case["recesses"], "first": f"{first!r} deg"}
    if "speed" in case:
        other["speed"] = f"{-degrees(case['speed'])!r} rpm"
    elif "attitude_angle" in case:
        other["attitude_angle"] = f"{-degrees(case['attitude_angle'])!r} deg"
    return other


FACTORS = {
    "mm": ("m", 1e-3),
    "um": ("mm", 1e-3),
    "MPa": ("bar", 10.0),
    "N": ("kN", 1e-3),
    "L/min": ("m3/s", 1 / 6e4),
}


def in_other_units(case: Any) -> Any:
    """Every length, pressure, force and flow of a case in another unit."""
    if isinstance(case, dict):
        return {key: in_other_units(value) for key, value in case.items()}
    if isinstance(case, list):
        return [in_other_units(value) for value in case]
    if isinstance(case, str) and len(case.split()) == 2 and case.split()[1] in FACTORS:
        number, unit = case.split()
        other, factor = FACTORS[unit]
        return f"{float(number) * factor!r} {other}"
    return case


def main() -> None:
    """Solve as many cases of every kind as asked for."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    kinds = sys.argv[2:] or list(MAKERS)
    for kind in kinds:
        begun, found, outcomes = time.perf_counter(), 0, Counter[str]()
        for seed in range(count):
            case = MAKERS[kind](random.Random(f"{kind} {seed}"))
            start = time.perf_counter()
            said = list(faults(case))
            took = time.perf_counter() - start
            if took > LONGEST:
                said.append(f"took {took:.0f} s")
            outcomes["faulty" if said else "sound"] += 1
            for one in said[:4]:
                found += 1
                print(f"{kind} {seed}: {one}", flush=True)
        print(f"{kind}: {count} cases, {dict(outcomes)}, {time.perf_counter() - begun:.0f} s", flush=True)


if __name__ == "__main__":
    main()
