"""Every optional field of a shaft changes the answer or is refused."""

from copy import deepcopy

import pytest

from babbitt.case import CaseError, case_from_dict
from babbitt.case.parts.shared import SharedInputs
from babbitt.kinds.shaft.case.bearings import OffsetInput, SupportInput
from babbitt.kinds.shaft.case.parts import CouplingInput, ForceInput, GearInput, MassInput
from babbitt.kinds.shaft.case.shaft import ShaftCase, ShaftLimitsInput, UniformPiece
from babbitt.solving import solve

BASE = {
    "kind": "shaft",
    "name": "Shaft",
    "speed": "400 rpm",
    "gears": [
        {"name": "Wheel", "station": "90 mm", "role": "driven", "torque": "700 N m", "pitch_diameter": "300 mm",
         "helix_angle": "12 deg", "helix": "right", "mesh_angle": "90 deg"},
    ],
    "couplings": [{"name": "Coupling", "station": "390 mm"}],
    "masses": [{"name": "Disc", "station": "200 mm", "mass": "5 kg"}],
    "forces": [{"name": "Belt", "station": "250 mm", "x": "1 kN"}],
    "shaft": [{"length": "400 mm", "diameter": "80 mm"}],
    "bearings": [
        {"kind": "radial_axial", "name": "A", "station": "0 mm"},
        {"kind": "radial", "name": "B", "station": "180 mm"},
        {"kind": "radial", "name": "C", "station": "360 mm"},
    ],
    "limits": {"slope": "1 mrad"},
}  # fmt: skip

CHANGES = {
    "gears.0.role": "driver",
    "gears.0.torque": "800 N m",
    "gears.0.power": "20 kW",
    "gears.0.mass": "20 kg",
    "gears.0.pitch_diameter": "310 mm",
    "gears.0.teeth": 40,
    "gears.0.normal_module": "5 mm",
    "gears.0.pressure_angle": "25 deg",
    "gears.0.helix_angle": "10 deg",
    "gears.0.helix": "left",
    "couplings.0.role": "driven",
    "couplings.0.torque": "600 N m",
    "couplings.0.power": "9 kW",
    "couplings.0.mass": "20 kg",
    "forces.0.x": "2 kN",
    "forces.0.y": "2 kN",
    "forces.0.z": "2 kN",
    "forces.0.moment_x": "200 N m",
    "forces.0.moment_y": "200 N m",
    "shaft.0.inner_diameter": "60 mm",
    "shaft.0.modulus": "200 GPa",
    "shaft.0.density": "7000 kg/m3",
    "bearings.1.stiffness": "100 MN/m",
    "bearings.1.offset": {"x": "20 um", "y": "-20 um"},
    "bearings.1.offset.x": "20 um",
    "bearings.1.offset.y": "20 um",
    "limits.slope": "0.9 mrad",
    "limits.deflection": "1 mm",
    "limits": {},
    "gears": [],
    "couplings": [],
    "masses": [],
    "forces": [],
    "shaft": [{"length": "400 mm", "diameter": "90 mm"}],
    "start": "-5 mm",
    "assumptions": ["The couple of the belt is left out."],
}
OF_THE_BEARINGS = {*SharedInputs.model_fields, "clearance_cases"}
"""What journal bearings of the shaft read, as those of a machine do."""
OF_THE_REPORT = {"notes", "source", "babbitt"}


def changed(path, value):
    made = deepcopy(BASE)
    *way, last = (int(one) if one.isdigit() else one for one in path.split("."))
    at = made
    for step in way:
        at = at.setdefault(step, {}) if isinstance(at, dict) else at[step]
    at[last] = value
    return made


def told(fields):
    """What a reader sees."""
    try:
        (result,) = solve(case_from_dict(fields)).results
    except CaseError as refusal:
        return str(refusal)
    notices = [str(one.message) for one in result.not_checked]
    return repr((dict(result.values), dict(result.arrays), result.checks, notices, result.assumptions))


@pytest.mark.parametrize("path", CHANGES)
def test_a_changed_field_changes_something(path):
    before, after = told(BASE), told(changed(path, CHANGES[path]))
    assert after != before
    if "[E0" in after:
        assert path.split(".")[-1] in after or "torque" in after


def test_every_optional_field_is_asked():
    parts = {
        "": ShaftCase,
        "gears.0.": GearInput,
        "couplings.0.": CouplingInput,
        "masses.0.": MassInput,
        "forces.0.": ForceInput,
        "shaft.0.": UniformPiece,
        "bearings.1.": SupportInput,
        "bearings.1.offset.": OffsetInput,
        "limits.": ShaftLimitsInput,
    }
    optional = {
        f"{path}{name}"
        for path, part in parts.items()
        for name, field in part.model_fields.items()
        if not field.is_required() and name not in OF_THE_BEARINGS | OF_THE_REPORT
    }
    assert optional <= CHANGES.keys()
