"""Every optional field of a journal bearing changes the answer, is refused, or is told not to be read."""

from functools import cache

import pytest

from babbitt.case import CaseError, case_from_dict
from babbitt.core.notices import InputError
from babbitt.solving import solve

pytestmark = pytest.mark.slow

COMMON = {
    "kind": "journal",
    "name": "Bearing",
    "diameter": "100 mm",
    "width": "60 mm",
    "clearance": {"kind": "relative", "mean": "1.2 permille"},
    "materials": {"bearing": "C10", "journal": "C45", "bearing_metal": "SnSb12Cu6Pb"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.1 MPa"},
    "surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um"},
    "load": "15 kN",
    "speed": "3000 rpm",
}
BUSH = {"outer_diameter": "130 mm", "conductivity": "45 W/(m K)"}
BASES = {
    "iso7902": COMMON | {
        "method": "iso7902", "span": "150 deg",
        "supply_element": {"kind": "hole", "diameter": "5 mm", "place": "opposite"},
    },
    "film": COMMON | {"method": "film", "accuracy": "draft", "grooves": [{"angle": "0 deg", "extent": "20 deg"}]},
    "long_film": COMMON | {
        "method": "long_film", "width": "130 mm",
        "heat_exchange": {"bush": BUSH, "ambient": {"temperature": "20 degC", "coefficient": "50 W/(m2 K)"}},
    },
    "segments": COMMON | {
        "method": "segments",
        "segments": {"groove": {"kind": "through", "angle_from_load": "-20 deg", "width": "5 mm"}},
    },
}  # fmt: skip
CHANGED = {
    "clearance_cases": "all",
    "span": "180 deg",
    "supply_element": {"kind": "hole", "diameter": "8 mm", "place": "opposite"},
    "grooves": [{"angle": "40 deg", "extent": "30 deg"}],
    "pockets": [{"angle": "180 deg", "extent": "30 deg", "width": "30 mm"}],
    "holes": [{"angle": "180 deg", "diameter": "6 mm"}],
    "bore": {"kind": "lobes", "preload": 0.4},
    "misalignment": {"x": "0.1 mrad", "y": "0 mrad"},
    "steps": [{"angle": "180 deg", "extent": "20 deg", "width": "20 mm", "depth": "50 um"}],
    "crowning": {"side": "5 um"},
    "side_pressures": ["20 kPa", "20 kPa"],
    "tilt_coefficients": True,
    "bearing_speed": "300 rpm",
    "load_angle": "-60 deg",
    "rotor_mass": "300 kg",
    "shaft_stiffness": "50 MN/m",
    "effective_temperature": "65 degC",
    "mixed_friction": {"boundary_friction": 0.2},
    "friction": {"model": "arc"},
    "characteristics": "closed_form",
    "cavitation": "reynolds",
    "cavitation_pressure": "-50 kPa",
    "turbulence": "ng_pan",
    "pressure_viscosity": {"coefficient": "20 1/GPa"},
    "thermal": "adiabatic",
    "walls": {"bush": BUSH},
    "axial_temperature": "resolved",
    "carry_over": 0.5,
    "temperature_coefficients": "following",
    "film_start": "widest_gap",
    "accuracy": "reference",
    "error_estimate": True,
    "limiting_speeds": False,
    "equilibria": "all",
    "limits": {"minimum_film_thickness": "90 um"},
    "assumptions": ["The load is steady."],
}
SUPPLY = {
    "temperature": "40 degC",
    "pressure": "0.3 MPa",
    "tubes": [{"length": "2 m", "diameter": "4 mm"}],
    "holes": [{"length": "10 mm", "diameter": "2 mm"}],
}


def told(**fields):
    """What a reader sees, or the refusal."""
    try:
        (result,) = solve(case_from_dict(fields)).results[:1]
    except (CaseError, InputError) as refusal:
        return str(refusal)
    values = {name: value for name, value in result.values.items() if name != "wall_time"}
    notices = (*result.warnings, *result.not_checked)
    words = [f"{one.code} {one.message}" for one in notices] + list(result.assumptions)
    return values, [(one.code, one.value, one.limit) for one in result.checks], words, result.missing


@cache
def told_of_base(method):
    """What the base says; solved once."""
    return told(**BASES[method])


@pytest.mark.parametrize("method", BASES)
def test_the_bases_are_answered(method):
    assert not isinstance(told_of_base(method), str)


@pytest.mark.parametrize("field", CHANGED)
@pytest.mark.parametrize("method", BASES)
def test_a_changed_field_changes_something(method, field):
    base = BASES[method]
    found = told(**base | {field: CHANGED[field]})
    assert field in found if isinstance(found, str) else found != told_of_base(method)


@pytest.mark.parametrize("field", SUPPLY)
@pytest.mark.parametrize("method", BASES)
def test_a_changed_supply_changes_something(method, field):
    base = BASES[method]
    found = told(**base | {"supply": base["supply"] | {field: SUPPLY[field]}})
    if isinstance(found, str):
        assert field in found
    else:
        assert found != told_of_base(method) or any(f"supply.{field}" in words for words in found[2])
