"""A key that no mapping knows is answered by the field it means, or by none: no far-fetched guess."""

import pytest
import yaml

from babbitt.case import KINDS, CaseError, case_from_dict, template
from babbitt.case.part import Part
from babbitt.case.suggestions import meant_field, synonyms

MEANT = {
    "journal": {
        "length": "width",
        "L": "width",
        "bearing length": "width",
        "axial_length": "width",
        "Width": "width",
        "width_mm": "width",
        "widht": "width",
        "shaft_diameter": "diameter",
        "journal-diameter": "diameter",
        "radius": "diameter",
        "inner_diameter": "diameter",
        "D": "diameter",
        "diamter": "diameter",
        "diameter_mm": "diameter",
        "id": "diameter",
        "L/D": "width_ratio",
        "aspect_ratio": "width_ratio",
        "radial_clearance": "clearance",
        "diametral_clearance": "clearance",
        "play": "clearance",
        "fit": "clearance",
        "psi": "clearance",
        "oil": "lubricant",
        "oil_grade": "lubricant",
        "lubricants": "lubricant",
        "rpm": "speed",
        "n": "speed",
        "speed_rpm": "speed",
        "rotational_speed": "speed",
        "omega": "speed",
        "velocity": "surface_speed",
        "force": "load",
        "weight": "load",
        "load_kN": "load",
        "laod": "load",
        "radial_load": "load",
        "mean_pressure": "specific_load",
        "unbalance": "dynamic_load",
        "eccentricity": "eccentricity_ratio",
        "temp": "supply.temperature",
        "inlet_temperature": "supply.temperature",
        "oil_temperature": "supply.temperature",
        "supply_temperature": "supply.temperature",
        "pressure": "supply.pressure",
        "supply_pressure": "supply.pressure",
        "oil_flow": "supply.flow",
        "ambient_temperature": "cooling.ambient_temperature",
        "film_thickness": "limits.minimum_film_thickness",
        "h_min": "limits.minimum_film_thickness",
        "max_temperature": "limits.temperature",
        "groove": "supply_element",
        "roughness": "surfaces",
        "bearing_metal": "materials.bearing_metal",
        "white_metal": "materials.bearing_metal",
        "shaft_material": "materials.journal",
        "solver": "method",
        "mesh": "accuracy",
        "comment": "notes",
        "title": "name",
        "reference": "source",
        "skew": "misalignment",
    },
    "thrust": {
        "force": "load",
        "axial_load": "load",
        "rpm": "speed",
        "number_of_pads": "pads.number",
        "pivot": "pads.pivot",
        "outer_diameter": "pads.outer_diameter",
        "oil_grade": "lubricant",
        "viscosity": "oil.viscosity",
        "film_thickness": "limits.minimum_film_thickness",
        "least_gap": "limits.minimum_film_thickness",
        "inlet_temperature": "supply.temperature",
        "carry_over": "oil.carry_over",
    },
    "hydrostatic_journal": {
        "length": "width",
        "shaft_diameter": "diameter",
        "viscosity": "oil.viscosity",
        "density": "oil.density",
        "pump_flow": "supply.pump_flow",
        "oil_temperature": "supply.temperature",
        "h_min": "limits.minimum_film_thickness",
        "diametral_clearance": "clearance",
    },
    "hydrostatic_thrust_ring": {"id": "inner_diameter", "od": "outer_diameter", "bore": "inner_diameter"},
    "screw_heel": {"rpm": "speed", "play": "clearance", "inlet_temperature": "supply.temperature"},
}
"""Wrong keys and the fields that they mean, by the kind of file in which they stand."""

MEANINGLESS = (
    *("colour", "price", "customer", "drawing_number", "foo", "lot", "x1", "vibration_class", "bolts", "gearbox"),
    *("date", "version", "seal", "engine", "poles", "serial", "currency", "humidity"),
)


@pytest.mark.parametrize(("kind", "wrong"), [(kind, wrong) for kind, words in MEANT.items() for wrong in words])
def test_a_wrong_key_is_answered_by_the_field_that_it_means(kind, wrong):
    assert meant_field(wrong, KINDS[kind]) == MEANT[kind][wrong]


@pytest.mark.parametrize("wrong", MEANINGLESS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_key_without_a_meaning_here_is_not_guessed_at(kind, wrong):
    assert meant_field(wrong, KINDS[kind]) == ""


def test_the_message_has_the_suggestion_and_nothing_else_is_told():
    """The field that the wrong key means counts as written: it is not called missing, too."""
    given = yaml.safe_load(template("journal"))
    given["length"] = given.pop("width")
    with pytest.raises(CaseError) as refused:
        case_from_dict(given)
    (problem,) = refused.value.problems
    assert (problem.field, problem.hint) == ("length", "did you mean 'width'?")


@pytest.mark.parametrize("wrong", ["temp", "inlet_temperature", "temperatur"])
def test_keys_further_down_are_answered_from_where_they_stand(wrong):
    given = yaml.safe_load(template("journal"))
    given["supply"] = {wrong: "50 degC", "pressure": "0.2 MPa"}
    with pytest.raises(CaseError) as refused:
        case_from_dict(given)
    assert [one.hint for one in refused.value.problems] == ["did you mean 'temperature'?"]


def parts(cls=Part):
    for sub in cls.__subclasses__():
        yield sub
        yield from parts(sub)


def test_every_field_of_the_table_is_one_of_the_case_language():
    assert all(KINDS.values())  # imports every kind
    known = {name for part in parts() for name in part.model_fields}
    named = {step for fields in synonyms().values() for field in fields for step in field.split(".")}
    assert named <= known


def test_no_field_of_the_case_language_is_taken_for_another():
    for model in KINDS.values():
        for name in model.model_fields:
            assert meant_field(name, model) == name
