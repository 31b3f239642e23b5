"""Cases of tilting-pad journal bearings for the tests."""

import copy

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
    given = copy.deepcopy(FILLON) | fields
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
