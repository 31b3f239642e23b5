"""Templates run as they stand; the shipped schema is that of the models and every field says what it is."""

import json
import re
import tomllib
from importlib.resources import files
from pathlib import Path
from typing import get_args

import jsonschema
import pytest
import yaml
from pydantic import TypeAdapter

from babbitt.case import KINDS, case_schema, kinds, parse_case, template
from babbitt.case.document import read_document
from babbitt.case.error_messages import metadata_of
from babbitt.case.method_choices import MethodInput
from babbitt.case.method_mapping import METHOD, method_models
from babbitt.case.part import Part
from babbitt.case.schema import shipped_schema, written_schema
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.core.units import AS_WRITTEN, read
from babbitt.core.units.fields import SiField
from babbitt.solving import solve

BAD = Path(__file__).parent / "bad"
SCHEMA = case_schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def parts(cls=Part):
    for sub in cls.__subclasses__():
        yield sub
        yield from parts(sub)


def test_kinds_are_those_that_can_be_loaded():
    assert set(kinds()) == set(KINDS)
    with pytest.raises(InputError, match="journal, machine"):
        template("jurnal")


def test_the_list_of_kinds_names_the_films_of_a_journal():
    """It called journal and machine bearings those of ISO 7902 alone."""
    assert "film" in kinds()["journal"]
    assert "ISO 7902 only" not in " ".join(kinds().values())


@pytest.mark.parametrize("kind", KINDS)
def test_template_runs_as_it_stands(kind):
    case = parse_case(template(kind))
    assert case.kind == kind
    solved = solve(case)
    assert len(solved.results) >= len(case.problems())
    assert solved.solved
    assert all(result.verdict is not Verdict.FAIL for result in solved.results)


@pytest.mark.parametrize("kind", KINDS)
def test_a_template_asks_for_units_as_the_language_does(kind):
    """Three said that numbers in SI would do: `load: 11000` is refused."""
    assert " SI " not in template(kind)


@pytest.mark.parametrize("kind", KINDS)
def test_template_suits_the_schema(kind):
    VALIDATOR.validate(read_document(template(kind)).plain())


COMMENTED = re.compile(r"^(\s*)# (\s*(?:- )?(?:\w+:(?: |$)|\{).*)$")
"""A comment that is a field to uncomment; any other is prose."""


FORMER_PLACES = {"options"}
"""Fields that held choices of a method and nothing else."""


def written_out(kind):
    """The nodes of a template with every comment that is a field uncommented; keys may be there several times."""
    return yaml.compose("\n".join(COMMENTED.sub(r"\1\2", line) for line in template(kind).splitlines()))


def parts_of(annotation):
    if isinstance(annotation, type) and issubclass(annotation, Part):
        yield annotation
    for inner in get_args(annotation):
        yield from parts_of(inner)


def parts_in(part, name):
    """Parts that a field may hold; the mappings of the methods are not in the annotation of `method`."""
    return [
        *parts_of(part.model_fields[name].annotation),
        *(method_models(part).values() if name == METHOD else ()),
    ]


def reachable(part, found):
    if part not in found:
        found.add(part)
        for name in part.model_fields:
            for inner in parts_in(part, name):
                reachable(inner, found)
    return found


def home(part, name):
    """The class that brings a field in, and the field: what a family shares is shown once."""
    return next(base for base in reversed(part.__mro__) if name in getattr(base, "model_fields", {})), name


def shown_in(node, candidates):
    """Fields that a node writes, each by the part that it belongs to."""
    if isinstance(node, yaml.SequenceNode):
        for one in node.value:
            yield from shown_in(one, candidates)
    if not isinstance(node, yaml.MappingNode):
        return
    kind = {value.value for key, value in node.value if key.value == "kind"}
    suit = [
        part
        for part in candidates
        if "kind" not in part.model_fields
        or not kind
        or kind & set(get_args(part.model_fields["kind"].annotation))
    ]
    for key, value in node.value:
        owners = [part for part in suit if key.value in part.model_fields]
        assert owners, f"{key.value} in line {key.start_mark.line + 1} is no field of {suit}"
        for part in owners:
            yield home(part, key.value)
            yield from shown_in(value, parts_in(part, key.value))


@pytest.mark.parametrize("kind", KINDS)
def test_a_template_shows_every_field_of_its_kind(kind):
    shown = set(shown_in(written_out(kind), [KINDS[kind]]))
    missing = {name for name in KINDS[kind].model_fields if home(KINDS[kind], name) not in shown}
    assert not missing - FORMER_PLACES


def test_every_field_of_the_case_language_is_in_a_template():
    shown = {one for kind, model in KINDS.items() for one in shown_in(written_out(kind), [model])}
    every = {
        home(part, name)
        for model in KINDS.values()
        for part in reachable(model, set())
        for name in part.model_fields
        if name not in FORMER_PLACES and not (issubclass(part, MethodInput) and name == "kind")
    }
    assert not {f"{part.__name__}.{name}" for part, name in every - shown}


@pytest.mark.parametrize("kind", KINDS)
def test_alternatives_in_the_comments_of_a_template_can_be_used(kind):
    for key, value in written_out(kind).value:
        given = yaml.SafeLoader("").construct_document(value)
        if key.value == METHOD and isinstance(given, dict):
            method_models(KINDS[kind])[given["kind"]].model_validate(given, context=AS_WRITTEN)
            continue
        if key.value == "limits" and "tables" in given:
            given["tables"] = (
                files("babbitt.properties.materials").joinpath("limits.toml").read_text(encoding="utf-8")
            )
        field = TypeAdapter(KINDS[kind].model_fields[key.value].rebuild_annotation())
        field.validate_python(given, context=AS_WRITTEN)


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
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert json.loads(shipped_schema())["$schema"].endswith("2020-12/schema")


def test_every_example_of_a_quantity_lies_in_its_range():
    found = [
        (cls, name, field)
        for cls in parts()
        for name in cls.model_fields
        for field in metadata_of(cls, name, SiField)
    ]
    outside = [(cls.__name__, name) for cls, name, field in found if field.unit != "1" and not inside(field)]
    assert len(found) > 300
    assert outside == []


def inside(field):
    return field.bounds is None or field.holds(read(field.example, field.unit))


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
    found = list(quantities(SCHEMA))
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
