"""Numbers without unit in bearings with recesses and footsteps are doubted as those of journals are."""

import pytest

from babbitt.cases import case_from_dict, design_cases

PAD = {
    "kind": "hydrostatic_pad",
    "name": "Pad",
    "pad": {"kind": "circular", "diameter": "100 mm", "recess_diameter": "50 mm"},
    "recess_oil": {"depth": "1 mm"},
    "restrictor": {"kind": "capillary", "diameter": "0.6 mm", "length": "60 mm"},
    "supply": {"pressure": "5 MPa"},
    "oil": {"viscosity": "30 mPa s"},
    "load": "11 kN",
    "speed": "500 rpm",
}
HEEL = {
    "kind": "screw_heel",
    "name": "Heel",
    "variants": "smooth",
    "heel": {"length": "30 mm", "radius": "20 mm", "recess_radius": "10 mm", "bore_radius": "3 mm",
             "recess_depth": "1 mm"},
    "face_gap": "20 um",
    "clearance": "20 um",
    "oil": {"viscosity": "30 mPa s", "temperature": "40 degC", "viscosity_exponent": "0.03 1/K"},
    "supply_pressure": "5 MPa",
    "speed": "3000 rpm",
}  # fmt: skip


def told(case, **changes):
    return [[notice.message.split(" without")[0] for notice in one.doubts]
            for one in design_cases(case_from_dict(case | changes))]  # fmt: skip


@pytest.mark.parametrize("case", [PAD, HEEL])
def test_a_whole_speed(case):
    assert told(case, speed=3000) == [["speed: 3000"]]
    assert told(case, speed="3000 rad/s") == [[]]


def test_a_load_of_a_few_newtons():
    assert told(PAD, load=11) == [["load: 11"]]
    assert told(PAD, load=11000) == [[]]


def test_whole_frequencies():
    """100 in a list of frequencies is meant in Hz, not as 15.9 Hz; hydrostatic bearings alone have such a list."""
    (notices,) = (one.doubts for one in design_cases(case_from_dict(PAD | {"frequencies": [10, 100]})))
    assert "100 rad/s = 15.92 Hz; write '100 Hz'" in notices[0].message
    assert told(PAD, frequencies=["10 Hz", "100 Hz"]) == [[]]
    assert told(PAD, frequencies=[62.83, 628.3]) == [[]]
    assert told(PAD, frequencies=[0, 10]) == [["frequencies: 10"]]
    assert told(PAD, frequencies=[0]) == [[]]
    assert told(PAD, frequencies=[]) == [[]]
