"""Templates run as they stand; the shipped schema is that of the models and every field says what it is."""

import json
import tomllib
from pathlib import Path

import jsonschema
import pytest
import yaml

from babbitt.cases import KINDS, case_schema, design_cases, kinds, parse_case, template
from babbitt.cases.document import read_document
from babbitt.cases.part import Part
from babbitt.cases.schema import shipped_schema, written_schema
from babbitt.notices import InputError
from babbitt.results import Verdict
from babbitt.solving import solve

BAD = Path(__file__).parent / "bad"
VALIDATOR = jsonschema.Draft202012Validator(case_schema())


def parts(cls=Part):
    for sub in cls.__subclasses__():
        yield sub
        yield from parts(sub)


def test_kinds_are_those_that_can_be_loaded():
    assert set(kinds()) == set(KINDS)
    with pytest.raises(InputError, match="journal, machine"):
        template("jurnal")


@pytest.mark.parametrize("kind", KINDS)
def test_template_runs_as_it_stands(kind):
    case = parse_case(template(kind))
    assert case.kind == kind
    solved = solve(case)
    assert len(solved.results) >= len(design_cases(case))
    assert solved.solved
    assert all(result.verdict is not Verdict.FAIL for result in solved.results)


@pytest.mark.parametrize("kind", KINDS)
def test_template_suits_the_schema(kind):
    VALIDATOR.validate(read_document(template(kind)).plain())


def test_alternatives_in_the_comments_of_a_template_can_be_used():
    lines = template("journal").splitlines()
    alternatives = [
        line.removeprefix("# ") for line in lines if line.startswith(("# clearance:", "# supply_element:"))
    ]
    alternatives += [line.removeprefix("# ") for line in lines if line.startswith(("# lubricant:", "# cooling:"))]
    alternatives += [line.removeprefix("# ") for line in lines if line.startswith(("# limits:", "# assumptions:"))]
    assert len(alternatives) >= 14
    given = yaml.safe_load(template("journal"))
    for line in alternatives:
        field, value = next(iter(yaml.safe_load(line).items()))
        assert parse_case(json.dumps(given | {field: value})).kind == "journal"


def test_a_speed_of_either_sense_suits_the_schema():
    given = yaml.safe_load(template("journal"))
    for speed, suits in (("-2000 rpm", True), ("209.4 rad/s", True), (209.4, False), (0.0, False)):
        assert VALIDATOR.is_valid(given | {"speed": speed}) is suits


def test_a_fit_in_short_suits_the_schema():
    assert VALIDATOR.is_valid(yaml.safe_load(template("journal")) | {"clearance": "H7/e7"})


def test_example_suits_the_schema(request):
    text = (request.config.rootpath / "examples" / "marine_reverse_gear.yaml").read_text(encoding="utf-8")
    VALIDATOR.validate(read_document(text).plain())


def test_shipped_schema_is_in_step():
    assert shipped_schema() == written_schema(), "run scripts/write_case_schema.py"


def test_schema_is_a_schema():
    jsonschema.Draft202012Validator.check_schema(case_schema())
    assert json.loads(shipped_schema())["$schema"].endswith("2020-12/schema")


def test_every_field_says_what_it_is():
    for part in parts():
        for name, field in part.model_fields.items():
            if not part.__name__.startswith("_"):
                assert field.description, f"{part.__name__}.{name}"
                assert field.description.rstrip().endswith("."), f"{part.__name__}.{name}"


def quantities(node):
    if isinstance(node, dict):
        if "x-unit" in node:
            yield node
        for inner in node.values():
            yield from quantities(inner)
    if isinstance(node, list):
        for inner in node:
            yield from quantities(inner)


def test_every_quantity_has_a_range():
    found = list(quantities(case_schema()))
    assert len(found) > 80
    assert all(node.get("x-allowed") for node in found)


@pytest.mark.parametrize(
    "name",
    [
        "unknown_key",
        "missing_diameter",
        "unknown_method",
        "unknown_kind_of_clearance",
        "list_for_diameter",
        "true_for_diameter",
        "bearings_as_mapping",
        "machine_without_bearings",
        "wrong_version",
        "unknown_place",
        "empty_name",
        "bare_millimetres",
        "span_200",
    ],
)
def test_an_editor_sees_what_is_wrong(name):
    assert name in tomllib.loads((BAD / "manifest.toml").read_text(encoding="utf-8"))
    given = read_document((BAD / f"{name}.yaml").read_text(encoding="utf-8")).plain()
    assert not VALIDATOR.is_valid(given)
