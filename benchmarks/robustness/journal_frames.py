"""A journal bearing of the film method in other axes: turned with its load, and in the mirror."""

from __future__ import annotations

import math
import random
from typing import Any

__all__ = ["mirrored", "turned"]

Case = dict[str, Any]
PLACED = ("grooves", "pockets", "holes", "steps")


def turned(case: Case, rng: random.Random) -> Case:
    """The bearing and its load, turned by a random angle of whole and half degrees."""
    angle = 0.5 * rng.randrange(1, 720)
    made = placed(case, lambda given: given + angle)
    if "misalignment" in case:
        x, y = (float(case["misalignment"][axis].split()[0]) for axis in "xy")
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        made["misalignment"] = {"x": f"{c * x - s * y!r} mrad", "y": f"{s * x + c * y!r} mrad"}
    return made


def mirrored(case: Case, _rng: random.Random) -> Case:
    """The mirror image, in which the journal turns the other way round."""
    made = placed(case, lambda given: -given)
    speed = case["speed"]
    made["speed"] = speed[1:] if speed.startswith("-") else f"-{speed}"
    if "misalignment" in case:
        tilt = case["misalignment"]["y"]
        made["misalignment"] = {**case["misalignment"], "y": tilt[1:] if tilt.startswith("-") else f"-{tilt}"}
    return made


def placed(case: Case, move: Any) -> Case:
    """The same with every angle moved."""

    def angle(given: str) -> str:
        return f"{math.remainder(round(move(float(given.split()[0])), 9), 360.0):.12g} deg"

    made = {**case, "load_angle": angle(case.get("load_angle", "-90 deg"))}
    for name in PLACED:
        if name in case:
            made[name] = [{**one, "angle": angle(one["angle"])} for one in case[name]]
    if "displacement" in case:
        made["displacement"] = rows_moved(case["displacement"], move)
    return made


def rows_moved(table: Case, move: Any) -> Case:
    """A table over the bore with every angle moved, its rows rising again."""
    angles = [math.remainder(round(move(float(given.split()[0])), 9), 360.0) for given in table["angles"]]
    order = sorted(range(len(angles)), key=angles.__getitem__)
    return {
        **table,
        "angles": [f"{angles[row]:.12g} deg" for row in order],
        "values": [table["values"][row] for row in order],
    }
