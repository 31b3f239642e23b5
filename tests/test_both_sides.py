"""Every check can be kept and can be missed: one case on either side of each of them, by the templates."""

import pytest
import yaml

from babbitt.case import case_from_dict, template
from babbitt.core.notices import explanations
from babbitt.solving import solve

LISTED_ONLY = {"C122", "C305", "C408", "C409", "C503"}
"""Named among the checks not made, and never made: what is found is told by warnings (W135, W136), or there is no
limit (C305) or no film (C503)."""

CLOSES = {"C403"}
"""Heat balances that close in every case; with values of their own in
`tilting_pad_journal.test_heated_pads.test_heat_that_is_missed_is_told`."""

FILM = {
    "kind": "journal", "name": "Film", "method": "film", "diameter": "100 mm", "width": "60 mm",
    "clearance": {"kind": "relative", "mean": "1.2 permille"},
    "grooves": [{"angle": "90 deg", "extent": "20 deg"}],
    "materials": {"bearing": "C10", "journal": "C45"}, "lubricant": "ISO VG 46",
    "effective_temperature": "60 degC", "load": "3 kN", "speed": "3000 rpm",
}  # fmt: skip
HEEL = {"method": "superposition", "wall": None, "variants": "smooth"}
"""The footstep of the template without metal."""

METAL = {"name": "Own", "family": "tin-based", "specific_load": "5 MPa", "sliding_speed": "20 m/s",
         "temperature": "100 degC", "load_times_speed": "60 MPa m/s"}  # fmt: skip
OWN = {"materials": {"bearing_metal": METAL, "bearing": "C10", "journal": "42CrMo4"}}
B83 = {"materials": {"bearing_metal": "B83", "bearing": "C10", "journal": "42CrMo4"}}
HOLE = {"kind": "hole", "diameter": "5 mm", "place": "opposite"}
HEATED = {"method": {"kind": "film", "thermal": "full", "accuracy": "draft"}}
THIN = {"kind": "constant", "dynamic_viscosity": "1 mPa s", "density": "900 kg/m3",
        "volumetric_heat_capacity": "1.8 MJ/(m3 K)"}  # fmt: skip

FED = {
    "kind": "machine", "name": "Machine", "lubricant": "ISO VG 46", "supply": {"temperature": "50 degC"},
    "materials": {"bearing": "C10", "journal": "C45"},
    "bearings": [{
        "kind": "journal", "name": "Wheel", "diameter": "120 mm", "width": "96 mm", "span": "180 deg",
        "clearance": {"kind": "relative", "mean": "1.8 permille"}, "load": "12 kN", "speed": "3000 rpm",
        "supply_element": {"kind": "groove_180", "width": "60 mm"},
    }],
}  # fmt: skip


def pumped(flow):
    """An oil system whose pump gives so much."""
    lines = [{"bearing": "Wheel", "orifice_diameter": "6 mm"}]
    return {"oil_system": {"pump": {"flow": flow, "relief_pressure": "0.3 MPa"}, "lines": lines}}


SIDES = {
    "C101": ("journal", {"load": "12 kN"}, {"load": "300 kN"}),
    "C102": ("journal", {"load": "12 kN"}, {"load": "300 kN"}),
    "C103": ("journal", {"load": "12 kN"}, {"load": "80 kN"}),
    "C104": ("journal", {"speed": "2000 rpm"}, {"speed": "12000 rpm"}),
    "C105": ("journal", OWN | {"load": "12 kN"}, OWN | {"load": "40 kN"}),
    "C106": ("journal", OWN | {"speed": "2000 rpm"}, OWN | {"speed": "4000 rpm"}),
    "C107": ("journal", OWN | {"load": "12 kN"}, OWN | {"load": "35 kN"}),
    "C108": ("journal", OWN | {"speed": "2000 rpm"}, OWN | {"speed": "12000 rpm"}),
    "C109": ("journal", B83 | {"speed": "300 rpm"}, B83 | {"speed": "6000 rpm"}),
    "C110": ("journal", {"speed": "2000 rpm"}, {"lubricant": THIN, "speed": "9000 rpm"}),
    "C111": ("journal", {"speed": "2000 rpm"}, {"speed": "50 rpm"}),
    "C112": ("journal", {"load": "60 kN"}, {"load": "2 kN"}),
    "C114": ("journal", {"clearance": {"kind": "relative", "mean": "2 permille"}}, {}),
    "C115": (FILM, {"rotor_mass": "300 kg"}, {"rotor_mass": "100 t"}),
    "C116": (FILM, {"load": "3 kN"}, {"load": "300 kN"}),
    "C117": ("journal", {"supply": {"temperature": "45 degC", "pressure": "3 MPa"}}, {"supply_element": HOLE}),
    "C130": ("screw_heel", HEEL | {"variants": "grooved"}, HEEL | {"variants": "grooved"}),
    "C131": ("screw_heel", HEEL | {"clearance": "60 um"}, HEEL | {"clearance": "10 um"}),
    "C201": ("thrust_line", {}, {"loss_limit": "5 %"}),
    "C202": ("thrust_line", {}, {"limits": {"minimum_film_thickness": "40 um"}}),
    "C203": ("thrust_line", {}, {"runout": [{"amplitude": "40 um"}]}),
    "C204": ("thrust_line", {}, {"seating": {"stiffness": "0.3 GN/m"}, "speed": "160 rpm"}),
    "C205": ("thrust_line", {"limits": {"axial_amplitude": "500 um"}}, {"limits": {"axial_amplitude": "10 um"}}),
    "C501": ("shaft", {"limits": {"slope": "10 mrad"}}, {"limits": {"slope": "0.001 mrad"}}),
    "C502": ("shaft", {"limits": {"deflection": "1 mm"}}, {"limits": {"deflection": "1 um"}}),
    "C301": ("hydrostatic_pad", {}, {"limits": {"minimum_film_thickness": "60 um"}}),
    "C302": ("hydrostatic_pad", {}, {"limits": {"minimum_film_thickness": "60 um"}}),
    "C303": ("hydrostatic_pad", {"supply": {"pump_flow": "0.4 L/min", "highest_pressure": "20 MPa"}},
             {"supply": {"pump_flow": "0.4 L/min", "highest_pressure": "0.5 MPa"}}),
    "C401": ("tilting_pad_journal", {}, {"limits": {"log_decrement": 8}}),
    "C406": ("tilting_pad_journal", {"anticipated_cross_coupling": "4 MN/m"},
             {"anticipated_cross_coupling": "400 MN/m"}),
    "C407": ("tilting_pad_journal", {"anticipated_cross_coupling": "4 MN/m"},
             {"anticipated_cross_coupling": "800 MN/m"}),
    "C402": ("tilting_pad_journal", {}, {"load": "60 kN"}),
    "C404": ("tilting_pad_journal", HEATED | {"limits": {"probe_alarm": "90 degC"}},
             HEATED | {"limits": {"probe_alarm": "50 degC"}}),
    "C405": ("tilting_pad_journal", HEATED | {"limits": {"probe_trip": "90 degC"}},
             HEATED | {"limits": {"probe_trip": "50 degC"}}),
    "C601": (FED, pumped("60 L/min"), pumped("2 L/min")),
    "C304": ("jacking_pocket", {}, {"relief_pressure": "5 MPa"}),
}  # fmt: skip
"""What a check is made of: a kind whose template it is, or a case; then what keeps it and what misses it."""


def outcomes(base, changes, code):
    """Whether the check is kept, in every result and place that it is made for."""
    given = dict(base) if isinstance(base, dict) else yaml.safe_load(template(base))
    given = {name: value for name, value in (given | changes).items() if value is not None}
    return {
        check.ok
        for result in solve(case_from_dict(given)).results
        for check in result.checks
        if check.code == code
    }


@pytest.mark.parametrize("code", SIDES)
def test_a_check_is_kept_on_one_side_and_missed_on_the_other(code):
    base, kept, missed = SIDES[code]
    assert True in outcomes(base, kept, code)
    assert False in outcomes(base, missed, code)
    if kept != missed:
        assert False not in outcomes(base, kept, code)


def test_no_check_is_left_out():
    assert {code for code in explanations() if code.startswith("C")} == set(SIDES) | LISTED_ONLY | CLOSES
