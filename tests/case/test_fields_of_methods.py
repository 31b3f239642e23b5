"""Fields that a method does not read are refused or told of, so that a form may leave them out."""

import pytest

from babbitt.app.document import CaseDocument
from babbitt.app.form import form_of
from babbitt.case import CaseError, parse_case, template
from babbitt.core.notices import InputError
from babbitt.kinds.journal.case.methods import KNOWN_TO
from babbitt.solving import solve

GIVEN = {
    "attitude_angle": "40 deg",
    "bore": {"kind": "lobes", "preload": 0.5},
    "cavitation_pressure": "-0.05 MPa",
    "compliance": [{"kind": "column", "displacement_per_pressure": "0.05 um/MPa"}],
    "crowning": {"kind": "parabolic", "drop": "5 um"},
    "displacement": {
        "angles": ["0 deg", "180 deg"], "places": ["-30 mm", "30 mm"], "values": [["0 um", "5 um"]] * 2,
    },
    "dynamic_load": {"kind": "rotating", "magnitude": "3 kN", "speed_ratio": 1},
    "grooves": [{"angle": "180 deg", "extent": "20 deg"}],
    "holes": [{"angle": "180 deg", "diameter": "5 mm"}],
    "misalignment": {"x": "0 mrad", "y": "0.1 mrad"},
    "mixed_friction": {"boundary_friction": 0.1},
    "pockets": [{"angle": "180 deg", "extent": "30 deg", "width": "40 mm"}],
    "position": {"x": "20 um", "y": "-30 um"},
    "pressure_viscosity": {"kind": "barus", "coefficient": "20 1/GPa"},
    "shaft_stiffness": "200 MN/m",
    "side_pressures": ["0 MPa", "0.05 MPa"],
    "steps": [{"angle": "180 deg", "extent": "60 deg", "width": "40 mm", "depth": "50 um"}],
    "walls": {"journal": {"temperature": "60 degC"}},
    "bearing_speed": "-500 rpm",
    "effective_temperature": "60 degC",
    "friction": {"model": "arc", "factor": 1.2},
    "rotor_mass": "800 kg",
    "span": "180 deg",
    "supply_element": {"kind": "hole", "diameter": "12 mm", "place": "opposite"},
    "heat_exchange": {"shaft_conductance": "1 W/K"},
    "segments": {"compliance": "1 um/MPa"},
}  # fmt: skip
METHODS = ("iso7902", "film", "long_film", "segments")


def case_of(method):
    """A journal bearing with the fields that all methods read, and those without which one has no answer."""
    document = CaseDocument(template("journal"))
    for name in (*KNOWN_TO, "method"):
        document.change((name,), None)
    document.change(("method",), method)
    if method == "iso7902":
        document.change(("supply_element",), GIVEN["supply_element"])
        document.change(("span",), "360 deg")
    return document


def told(text):
    """Fields that are to blame, or that are not read."""
    try:
        machine = solve(parse_case(text))
    except CaseError as error:
        return [one.field for one in error.problems]
    except InputError as error:
        return [error.message]
    notices = [one for result in machine.results for one in result.warnings if one.code == "W183"]
    return [field for one in notices for field in one.values["fields"]]


@pytest.mark.parametrize(
    ("name", "method"), [(name, one) for name, known in KNOWN_TO.items() for one in METHODS if one not in known]
)
def test_a_method_that_does_not_read_a_field_says_so(name, method):
    document = case_of(method)
    before = told(document.text)
    document.change((name,), GIVEN[name])
    if name == "attitude_angle":
        document.change(("eccentricity_ratio",), 0.6)
        document.change(("load",), None)
    new = [one for one in told(document.text) if one not in before]
    assert any(one.startswith(name) for one in new), new


@pytest.mark.parametrize("method", METHODS)
def test_the_form_has_the_fields_of_the_method_and_those_that_are_given(method):
    document = case_of(method)
    shown = {one.path[0] for one in document.items}
    assert shown & set(KNOWN_TO) == {name for name, known in KNOWN_TO.items() if method in known}
    other = next(name for name in KNOWN_TO if method not in KNOWN_TO[name])
    document.change((other,), GIVEN[other])
    assert other in {one.path[0] for one in document.items}


def test_a_form_without_a_method_is_that_of_the_one_that_is_taken_then():
    given = case_of("iso7902").given
    with_it = {one.path for one in form_of(given)}
    given.pop("method")
    assert {one.path for one in form_of(given)} == with_it
