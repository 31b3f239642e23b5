"""Cases of tilting-pad journal bearings for the tests."""

import copy
import math

from babbitt.case import case_from_dict
from babbitt.solving import solve

FILLON = {
    "kind": "tilting_pad_journal",
    "name": "Pads",
    "diameter": "100 mm",
    "pads": {
        "number": 4,
        "first_pivot": "45 deg",
        "extent": "75 deg",
        "width": "70 mm",
        "thickness": "20 mm",
        "clearance": {"kind": "radial", "mean": "148 um"},
        "preload": 0.47,
    },
    "load": "10 kN",
    "speed": "4000 rpm",
    "lubricant": "ISO VG 32",
    "supply": {"temperature": "40 degC"},
    "accuracy": "draft",
}
"""Four pads of the bearing of Fillon, Bligoud and Frene (1992), load between pads."""

OIL = {
    "kind": "constant",
    "name": "Oil",
    "dynamic_viscosity": "19 mPa s",
    "density": "870 kg/m3",
    "volumetric_heat_capacity": "1.7 MJ/(m3 K)",
}


def pad_case(changes=None, **fields):
    """The bearing with fields changed, and others at paths such as ``pads.extent``; None leaves a field out."""
    given = copy.deepcopy(FILLON | fields)
    for path, value in (changes or {}).items():
        *way, last = path.split(".")
        at = given
        for step in way:
            at = at[int(step)] if step.isdigit() else at.setdefault(step, {})
        if value is None:
            at.pop(last, None)
        else:
            at[last] = value
    return {name: value for name, value in given.items() if value is not None}


def solution_of(changes=None, **fields):
    """The solution of one bearing."""
    (found,) = solve(case_from_dict(pad_case(changes, **fields))).solutions
    return found


def result_of(changes=None, **fields):
    """The result of one bearing."""
    return solution_of(changes, **fields).result


FILLON_OIL = {
    "kind": "exponential",
    "name": "Oil of the prototype",
    "points": [
        {"temperature": "40 degC", "dynamic_viscosity": "27.7 mPa s"},
        {"temperature": "80 degC", "dynamic_viscosity": f"{27.7 * math.exp(-0.0341 * 40.0)} mPa s"},
    ],
    "density": "860 kg/m3",
    "density_slope": "0 kg/(m3 K)",
    "volumetric_heat_capacity": f"{860.0 * 1951.8} J/(m3 K)",
    "conductivity": "0.149 W/(m K)",
}
"""The oil of the reference calculation, 0.0277 Pa s exp(-0.0341 (t - 40))."""

STEEL = {"elastic_modulus": "210 GPa", "thermal_expansion": "12e-6 1/K"}
CONDUCTING = {"pads": {"conductivity": "50 W/(m K)"}}
HEATED = {
    "A": {"thermal": "adiabatic"},
    "B": {"thermal": "full"},
    "C": {"thermal": "full", "walls": CONDUCTING},
    "D": {"thermal": "full", "walls": CONDUCTING, "deformation": ["bending"], "materials": {"pads": STEEL}},
    "E": {
        "thermal": "full",
        "walls": CONDUCTING,
        "deformation": ["growth", "bending"],
        "reference_temperature": "40 degC",
        "materials": {"pads": STEEL},
    },
}
"""Thermal models: insulated, with a journal of one temperature, with pads that conduct, bend, and grow."""


def unloaded_pads(result):
    """What W401 says of each unloaded pad, by its number."""
    (notice,) = [one for one in result.warnings if one.code == "W401"]
    return {one.values["pad"]: one for one in notice.values.get("pads", (notice,))}
