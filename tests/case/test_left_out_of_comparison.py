"""What `method: iso7902` is refused for is left out of a comparison, with the same reason."""

import pytest

from babbitt.case import CaseError, case_from_dict
from babbitt.kinds.journal.case.build import iso7902_cases, unknown_to_iso7902

FILM = {
    "kind": "journal",
    "name": "Test",
    "method": "film",
    "diameter": "80 mm",
    "width": "40 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "span": "180 deg",
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
    "load": "6 kN",
    "speed": "2000 rpm",
}

UNKNOWN = [
    ({"turbulence": "ng_pan"}, "laminar films only"),
    ({"pressure_viscosity": {"kind": "barus", "coefficient": "20 1/GPa"}}, "no viscosity under pressure"),
    (
        {"steps": [{"angle": "-90 deg", "extent": "20 deg", "width": "10 mm", "depth": "20 um"}]},
        "no steps",
    ),
    ({"crowning": {"kind": "parabolic", "drop": "5 um"}}, "no crowning"),
    ({"misalignment": {"x": "0.1 mrad", "y": "0 mrad"}}, "no misaligned journal"),
    ({"side_pressures": ["0 kPa", "20 kPa"]}, "no side pressures"),
    ({"dynamic_load": {"kind": "rotating", "magnitude": "1 kN"}}, "steady loads only"),
    ({"supply": {"temperature": "50 degC", "flow": "2 L/min"}}, "takes a supply pressure, not a flow"),
]


@pytest.mark.parametrize(
    ("feature", "words"), UNKNOWN, ids=lambda one: next(iter(one)) if isinstance(one, dict) else ""
)
def test_the_standard_is_left_out_where_it_would_be_refused(feature, words):
    with pytest.raises(CaseError, match=words):
        case_from_dict(FILM | feature | {"method": "iso7902"})
    case = case_from_dict(FILM | feature)
    assert words in unknown_to_iso7902(case, case)
    assert iso7902_cases(case, case) == ()


def test_the_standard_stands_beside_a_film_that_it_knows():
    for choice in (
        {},
        {"thermal": "full"},
        {"accuracy": "draft"},
        {"cavitation": "reynolds"},
        {"rotor_mass": "1 t"},
    ):
        case = case_from_dict(FILM | choice)
        assert unknown_to_iso7902(case, case) == ""
        assert len(iso7902_cases(case, case)) == 1
