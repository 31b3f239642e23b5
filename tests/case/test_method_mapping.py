"""Choices of a method in its mapping say what they said as fields of the bearing: one case, hash and problem."""

import copy
from functools import cache

import pytest
import yaml

import babbitt as bb
from babbitt.case import KINDS, CaseError, case_from_dict, case_hash, case_schema, parse_case, template
from babbitt.case.method_choices import MethodInput
from babbitt.case.method_mapping import choices_of, every_choice, method_models
from babbitt.case.nested import with_value, without_value
from babbitt.case.variation import variation_of
from babbitt.kinds.journal.case.files import JournalCase

VALUES = {
    "thermal": ["adiabatic"],
    "axial_temperature": ["resolved", "mean"],
    "carry_over": ["80 %", 1],
    "temperature_coefficients": ["following"],
    "cavitation": ["reynolds", "mass_conserving"],
    "film_start": ["groove"],
    "turbulence": ["constantinescu"],
    "accuracy": ["draft", "engineering"],
    "error_estimate": [True, False],
    "limiting_speeds": [False, True],
    "equilibria": ["all", "first"],
    "tilt_coefficients": [True],
    "characteristics": ["closed_form", "computed"],
    "nusselt": [7.54, {"coefficient": 1.55, "exponent": 0.333}],
    "discretisation": ["published_mean"],
    "exchange_zone": ["all_around"],
    "friction_viscosity": ["mixed"],
    "face_outlet": ["printed"],
    "backflow_viscosity": ["groove"],
    "local_loss_coefficient": [1],
    "speed_reduction": [0.5],
    "radial_temperature": ["resolved"],
    "deformation": [["bending"]],
    "pad_bending": ["plate"],
    "assumption_sensitivity": [True, False],
}
"""By the name of a choice, values of it; the first is not what holds where none is given."""

OTHERS = {
    "thermal": "global",
    "axial_temperature": "mean",
    "carry_over": "50 %",
    "temperature_coefficients": "frozen",
    "cavitation": "mass_conserving",
    "film_start": "periodic",
    "turbulence": "ng_pan",
    "accuracy": "reference",
    "error_estimate": False,
    "limiting_speeds": True,
    "equilibria": "first",
    "tilt_coefficients": False,
    "characteristics": "computed",
    "nusselt": 1.55,
    "discretisation": "consistent",
    "exchange_zone": "film",
    "friction_viscosity": "mean",
    "face_outlet": "consistent",
    "backflow_viscosity": "inlet",
    "local_loss_coefficient": 2,
    "speed_reduction": 0.1,
    "radial_temperature": "mean",
    "deformation": ["growth", "bending"],
    "pad_bending": "beam",
    "assumption_sensitivity": False,
}
"""By the name of a choice, a value other than the first above."""

WITH = {
    "axial_temperature": {"thermal": "adiabatic"},
    "carry_over": {"thermal": "adiabatic"},
    "temperature_coefficients": {"thermal": "adiabatic"},
    "radial_temperature": {"thermal": "adiabatic"},
    "deformation": {"thermal": "full"},
    "pad_bending": {"thermal": "full", "deformation": ["bending"]},
    "assumption_sensitivity": {"thermal": "full"},
}
"""By the name of a choice, another without which it says nothing."""

FIELDS = {"deformation": {"walls": {"pads": {}}, "materials": {"pads": "C45"}}}
"""By the name of a choice, fields of the bearing without which it says nothing."""

CHOICES = [
    (kind, method, name, value)
    for kind, model in KINDS.items()
    for method in method_models(model)
    for name in choices_of(model, method)
    for value in VALUES[name]
]


def bearing(kind, method):
    """A bearing of a kind for a method, without choices."""
    given = yaml.safe_load(template(kind)) | {"method": method}
    if method == "narrow_groove":
        return given
    given.pop("wall", None)
    if method in ("long_film", "segments"):
        given.pop("friction")
        given |= {"width": "240 mm", "span": "360 deg"}
        del given["supply_element"]
    return given


def both_forms(kind, method, choices):
    """The same bearing with its choices as fields, and in the mapping of its method."""
    model, given = KINDS[kind], bearing(kind, method)
    for name in choices:
        given |= FIELDS.get(name, {})
    flat = given
    for name, value in choices.items():
        flat = with_value(flat, choices_of(model, method)[name], value)
    return flat, given | {"method": {"kind": method, **choices}}


def refusals(given):
    with pytest.raises(CaseError) as refused:
        parse_case(yaml.safe_dump(given, sort_keys=False))
    return refused.value.problems


@pytest.mark.parametrize(("kind", "method", "name", "value"), CHOICES)
def test_both_forms_are_one_case_with_one_hash_and_one_problem(kind, method, name, value):
    flat, mapped = (case_from_dict(one) for one in both_forms(kind, method, {**WITH.get(name, {}), name: value}))
    assert flat == mapped
    assert case_hash(flat) == case_hash(mapped)
    assert repr(flat.calculations()) == repr(mapped.calculations())
    bare = case_from_dict(bearing(kind, method) | {"method": method})
    if value is VALUES[name][0]:
        assert case_hash(mapped) != case_hash(bare)


@cache
def definitions():
    return case_schema()["$defs"]


@pytest.mark.parametrize("kind", [kind for kind in KINDS if method_models(KINDS[kind])])
def test_every_method_has_a_mapping_and_every_choice_is_of_one_method(kind):
    model = KINDS[kind]
    drawn = definitions()[model.__name__]["properties"]["method"]["anyOf"]
    names = drawn[0].get("enum") or [drawn[0]["const"]]
    assert list(method_models(model)) == names
    assert len(every_choice(model)) == sum(len(choices_of(model, method)) for method in names)


@pytest.mark.parametrize(("kind", "method"), dict.fromkeys((one[0], one[1]) for one in CHOICES))
def test_a_name_alone_and_a_mapping_of_the_name_are_one(kind, method):
    short, long = (case_from_dict(bearing(kind, method) | {"method": one}) for one in (method, {"kind": method}))
    assert short == long


@pytest.mark.parametrize(("kind", "method", "name"), dict.fromkeys(one[:3] for one in CHOICES))
def test_forms_that_contradict_each_other_are_refused_in_one_message(kind, method, name):
    path = choices_of(KINDS[kind], method)[name]
    _, mapped = both_forms(kind, method, {**WITH.get(name, {}), name: VALUES[name][0]})
    assert case_from_dict(with_value(mapped, path, VALUES[name][0])) == case_from_dict(mapped)
    (told,) = refusals(with_value(mapped, path, OTHERS[name]))
    assert told.field == ".".join(path)
    assert f"method.{name}" in told.message


@pytest.mark.parametrize(
    ("method", "field", "words"),
    [
        ({"kind": "film", "acuracy": "draft"}, "method.acuracy", "did you mean 'accuracy'?"),
        ({"kind": "film", "characteristics": "computed"}, "method.characteristics", "kind: iso7902"),
        ({"kind": "film", "walls": {}}, "method.walls", "next to method"),
        ({"kind": "segments", "colour": "red"}, "method.colour", "kind alone"),
        ({"kind": "flim"}, "method.kind", "did you mean 'film'?"),
        ({"kind": ["film"]}, "method.kind", "a list of 1 is not allowed"),
        ({"accuracy": "draft"}, "method", "kind is missing; allowed: iso7902, film"),
        ({"kind": "film", "accuracy": "fine"}, "method.accuracy", "draft, engineering, reference"),
        ({"kind": "film", "thermal": "adiabatic", "carry_over": "120 %"}, "method.carry_over", "too large"),
        ({"kind": "film", "axial_temperature": "resolved"}, "method.axial_temperature", "one temperature"),
    ],
)
def test_what_is_wrong_in_a_mapping_is_told_there(method, field, words):
    given = bearing("journal", "film")
    (told,) = refusals(given | {"method": method})
    assert told.field == field
    assert words in told.message
    text = yaml.safe_dump(given | {"method": method}, sort_keys=False).splitlines()
    assert text[told.line - 1].strip().startswith(field.rpartition(".")[2])


def test_a_choice_that_is_no_field_of_the_bearing_is_named_in_its_mapping():
    (told,) = refusals(bearing("journal", "film") | {"acuracy": "draft"})
    assert "did you mean 'method.accuracy'?" in told.message


def test_choices_of_another_method_stay_on_the_bearing_for_a_comparison():
    case = case_from_dict(bearing("journal", "iso7902") | {"accuracy": "draft", "cavitation": "reynolds"})
    assert (case.accuracy, case.cavitation) == ("draft", "reynolds")


@pytest.mark.parametrize("form", [0, 1], ids=["fields", "mapping"])
@pytest.mark.parametrize(
    ("kind", "method", "name"),
    [
        ("journal", "film", "accuracy"),
        ("journal", "long_film", "nusselt"),
        ("screw_heel", "superposition", "local_loss_coefficient"),
        ("hydrostatic_pad", "film", "accuracy"),
        ("thrust", "film", "turbulence"),
        ("tilting_pad_journal", "film", "thermal"),
    ],
)
def test_a_sweep_takes_paths_in_both_forms(kind, method, name, form):
    first, second = VALUES[name][0], OTHERS[name]
    case = case_from_dict(both_forms(kind, method, {name: first})[form])
    flat = ".".join(choices_of(KINDS[kind], method)[name])
    old, new = (variation_of(case, path) for path in (flat, f"method.{name}"))
    assert old.present == new.present == first
    assert old.case(second) == new.case(second) == case_from_dict(both_forms(kind, method, {name: second})[1])
    assert old.given_with(second)["method"] == {"kind": method, name: second}


def test_a_sweep_goes_through_methods_and_mappings():
    case = case_from_dict(both_forms("journal", "film", {"accuracy": "draft"})[1])
    by_name = variation_of(case, "method.kind").case("iso7902")
    assert (by_name.method, by_name.accuracy) == ("iso7902", "draft")
    anew = variation_of(case, "method").case({"kind": "film", "cavitation": "reynolds"})
    assert (anew.accuracy, anew.cavitation) == ("engineering", "reynolds")
    with pytest.raises(CaseError, match=r"method\.accuracy: 'fine'"):
        variation_of(case, "accuracy").case("fine")


def test_a_bearing_of_a_machine_has_a_mapping_of_its_own():
    given = yaml.safe_load(template("machine"))
    flat, mapped = copy.deepcopy(given), copy.deepcopy(given)
    flat["bearings"][0] |= {"method": "film", "accuracy": "draft"}
    mapped["bearings"][0]["method"] = {"kind": "film", "accuracy": "draft"}
    one, other_form = case_from_dict(flat), case_from_dict(mapped)
    assert one == other_form
    assert case_hash(one) == case_hash(other_form)
    for path in ("bearings.0.accuracy", "bearings.0.method.accuracy"):
        varied = variation_of(other_form, path).case("reference")
        assert [bearing.accuracy for bearing in varied.bearings] == ["reference", "engineering"]
    mapped["bearings"][0]["method"]["accuracy"] = "fine"
    (told,) = refusals(mapped)
    assert told.field == "bearings[0 'Pinion'].method.accuracy"


def test_the_schema_knows_both_forms_and_marks_the_former():
    drawn = definitions()
    for name, marked in (("JournalCase", "accuracy"), ("HeatExchangeInput", "nusselt"), ("ThrustCase", "thermal"),
                         ("TiltingPadJournalCase", "deformation")):  # fmt: skip
        assert drawn[name]["properties"][marked]["deprecated"] is True
    assert "deprecated" not in drawn["JournalCase"]["properties"]["walls"]
    assert "deprecated" not in drawn["FilmMethod"]["properties"]["accuracy"]


def test_python_and_file_have_one_mapping():
    made = bb.JournalBearing.of(case_from_dict(bearing("journal", "film"))).replace(
        method=bb.Film(thermal="adiabatic", accuracy="draft", carry_over=0.8)
    )
    assert made.given["method"] == {
        "kind": "film", "thermal": "adiabatic", "accuracy": "draft", "carry_over": 0.8
    }  # fmt: skip
    read = parse_case(made.to_yaml())
    assert yaml.safe_load(made.to_yaml())["method"]["thermal"] == "adiabatic"
    assert case_hash(read) == case_hash(made)
    assert made.replace({"method.thermal": None, "method.carry_over": None}).thermal is None
    assert made.replace(method={"kind": "film", "cavitation": "reynolds"}).accuracy == "engineering"


def test_objects_of_python_are_the_mappings_of_a_journal():
    for one in (bb.Film, bb.Iso7902, bb.LongFilm, bb.Segments):
        assert issubclass(one, method_models(JournalCase)[one().kind])
        assert issubclass(one, MethodInput)


def test_taking_a_choice_away_leaves_no_empty_mapping():
    flat, _ = both_forms("screw_heel", "superposition", {"speed_reduction": 0.5})
    assert "options" not in without_value(flat, ("options", "speed_reduction"))
