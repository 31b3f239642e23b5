"""What the program knows, the documentation tells: a code, quantity, command or field without words fails."""

from __future__ import annotations

import importlib
import json
import pkgutil
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import get_args

import pytest
from babbitt_pages import PARTS, case_file, command_line, facts, lubricants, materials, notices, quantities, units
from example_blocks import DOCS, ROOT, pages

import babbitt
from babbitt import cli
from babbitt.case import KINDS as CASE_KINDS
from babbitt.case import load_case
from babbitt.case.part import Part
from babbitt.cli.app import NO_SOLUTION, NOT_PASSED, SOLVED, UNUSABLE_INPUT
from babbitt.cli.interruption import INTERRUPTED
from babbitt.core.notices import Effect, Subject, explanations
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.quantities.dynamics import DYNAMICS
from babbitt.core.quantities.footstep import FOOTSTEP
from babbitt.core.quantities.hydrostatics import HYDROSTATICS
from babbitt.core.quantities.journal import JOURNAL
from babbitt.core.quantities.one_dimension import ONE_DIMENSION
from babbitt.core.quantities.shaft_lines import SHAFT_LINES
from babbitt.core.quantities.shafts import SHAFTS
from babbitt.core.quantities.thrust import THRUST
from babbitt.core.result import Outcome
from babbitt.core.units import KINDS as UNIT_KINDS
from babbitt.kinds.hydrostatic.report.words import HYDROSTATIC_WORDS
from babbitt.kinds.journal.iso7902.model import Curves, Friction
from babbitt.kinds.shaft.report.words import SHAFT_WORDS
from babbitt.properties.lubricants import catalogue
from babbitt.properties.materials import bearing_metals, structural_materials
from babbitt.report.export import to_json
from babbitt.report.vocabulary import VOCABULARY
from babbitt.solving import solve

NOT_FOR_USERS = {"babbitt.report.outputs", *(f"babbitt.cli.{name}" for name in cli.__all__)}
"""Names of public packages that only the command line needs."""


OF_HEELS = frozenset(
    name
    for name in VOCABULARY
    if name.startswith(("heel_", "groove_", "screw_", "recess_", "bore_", "face_", "rim_", "land_s", "inlet_visc"))
    and name not in QUANTITIES
    and name not in {one.name for one in HYDROSTATIC_WORDS}
    and name != "groove_width"
)
"""What the calculation of a footstep says on its way."""


def page(name: str) -> str:
    return (DOCS / name).read_text(encoding="utf-8")


def all_parts(part: type[Part] = Part) -> Iterator[type[Part]]:
    for one in part.__subclasses__():
        yield one
        yield from all_parts(one)


def reachable_parts() -> set[type[Part]]:
    """Every mapping that a case file can hold, found through the annotations of the fields."""
    found: set[type[Part]] = set()

    def visit(annotation: object) -> None:
        if isinstance(annotation, type) and issubclass(annotation, Part):
            if annotation not in found:
                found.add(annotation)
                for field in annotation.model_fields.values():
                    visit(field.annotation)
            return
        for argument in get_args(annotation):
            visit(argument)

    for kind in CASE_KINDS.values():
        visit(kind)
    return found


# -- what is generated ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("code", explanations())
def test_every_code_is_explained(code: str) -> None:
    assert f"({code.lower()})=\n### {code} " in notices.page()
    explanation = explanations()[code]
    for said in (explanation.title, explanation.meaning, explanation.remedy):
        assert len(said) > 5, f"{code} says too little: {said!r}"


@pytest.mark.parametrize("name", QUANTITIES)
def test_every_quantity_is_listed(name: str) -> None:
    row = next(line for line in quantities.page().splitlines() if line.startswith(f"| `{name}` |"))
    assert QUANTITIES[name].meaning.split("*")[0] in row.replace("\\", "")


ONE_SYMBOL = (
    {"groove_temperature", "groove_temperatures"},  # the highest of them, and all
    {"land_conductance", "pocket_conductance"},  # bearings with recesses; jacking pockets
    {"recess_pressure", "one_recess_pressure"},  # of all recesses, and of one
    {"restrictor_flow", "one_restrictor_flow"},
    {"temperature_rise", "oil_warming"},  # the same, written as a step
    {"total_flow", "duct_flow"},  # all oil, and that of one duct: the same where there is one
)
"""Quantities of one symbol: the same thing, or of kinds of bearing that no report shows together."""

LOCAL = {name: one for name, one in VOCABULARY.items() if name not in QUANTITIES}
RECESSED = {one.name: one for one in HYDROSTATIC_WORDS}
OF_SHAFTS = {one.name for one in SHAFT_WORDS}


@pytest.mark.parametrize(
    "shown",
    [
        QUANTITIES.values(),
        [*HYDROSTATICS, *RECESSED.values()],
        [*JOURNAL, *(one for name, one in LOCAL.items() if name not in {*RECESSED, *OF_SHAFTS, *OF_HEELS})],
        [*FOOTSTEP, *(LOCAL[name] for name in OF_HEELS)],
        SHAFT_WORDS,
    ],
    ids=["results", "recessed bearings", "journals by the standard", "footsteps", "shafts"],
)
def test_no_symbol_has_two_meanings(shown: Iterable[Quantity]) -> None:
    names: dict[str, set[str]] = {}
    for one in shown:
        names.setdefault(one.symbol, set()).add(one.name.removeprefix("sensitivity_of_"))
    several = {symbol: same for symbol, same in names.items() if len(same) > 1}
    assert not {symbol: same for symbol, same in several.items() if same not in ONE_SYMBOL}


def test_no_quantity_takes_the_name_of_another() -> None:
    every = [*JOURNAL, *DYNAMICS, *ONE_DIMENSION, *FOOTSTEP, *HYDROSTATICS, *SHAFTS, *THRUST, *SHAFT_LINES]
    meanings: dict[str, Quantity] = {}
    for one in every:
        assert meanings.setdefault(one.name, one) == one, one.name


def test_contributors_read_every_command() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = re.search(r"^cli +babbitt (.+)$", text, re.MULTILINE)
    assert named is not None
    assert set(named[1].split(", ")) == set(command_line.commands())


def test_what_the_first_page_says_of_a_margin_stands_in_the_table_above() -> None:
    text = (DOCS / "start.md").read_text(encoding="utf-8")
    row = re.search(r"^C101 .* \+(\d+)%  pass", text, re.MULTILINE)
    said = re.search(r"the film is (\d+) % thicker than experience asks", text)
    assert row is not None
    assert said is not None
    assert said[1] == row[1]


@pytest.mark.parametrize("name", command_line.commands())
def test_every_command_and_option_is_described(name: str) -> None:
    text = command_line.page()
    section = text.split(f"## babbitt {name}\n")[1].split("\n## ")[0]
    command = command_line.commands()[name]
    assert command.help
    for parameter in command.params:
        names = parameter.opts if parameter.param_type_name == "option" else [parameter.metavar]
        assert getattr(parameter, "help", None), f"{name} {names} has no help"
        assert any(f"`{one}`" in section for one in names), f"{name} {names}"


@pytest.mark.parametrize(
    "part", sorted(reachable_parts(), key=lambda part: part.__name__), ids=lambda p: p.__name__
)
def test_every_field_of_a_case_is_described(part: type[Part]) -> None:
    every = {section.name: section for section in case_file.sections()}
    text = case_file.page()
    section = every[part.__name__]
    assert f"({section.label})=" in text
    body = text.split(f"({section.label})=")[1].split("\n(case-")[0]
    family = text.split(f"(case-{section.family.lower()})=")[1] if section.family else ""
    for name, field in part.model_fields.items():
        assert field.description, f"{part.__name__}.{name} has no description"
        row = f"`{name}`" if section.fields.get(name, {}).get("deprecated") else f"| `{name}` |"
        assert row in body + family, f"{part.__name__}.{name}"  # of former places a list
        described = case_file.says(section.fields[name], every)
        assert described, f"{part.__name__}.{name} has an empty cell"


def test_every_kind_of_quantity_and_its_units_are_listed() -> None:
    for kind in UNIT_KINDS.values():
        row = next(line for line in units.page().splitlines() if f"| {kind.phrase} | `{kind.unit}` |" in line)
        assert all(f"`{unit}`" in row for unit in kind.everyday if unit)


def test_every_lubricant_and_material_is_listed_with_its_source() -> None:
    oils, metals = lubricants.page().replace("\\", ""), materials.page().replace("\\", "")
    for oil in catalogue():
        assert f"### {oil.name}\n" in oils
        assert oil.source in oils
        assert all(assumption in oils for assumption in oil.assumptions)
    for metal in bearing_metals():
        assert f"### {metal.name}\n" in metals
        assert metal.composition.source in metals
    assert all(material.name in metals and material.source in metals for material in structural_materials())


def test_every_generated_part_is_shown_on_a_page() -> None:
    included = "".join(page.read_text(encoding="utf-8") for page in pages())
    for name in PARTS:
        assert f"_generated/parts/{name}.md" in included, name


def test_every_fact_is_stated_somewhere() -> None:
    stated = "".join(page.read_text(encoding="utf-8") for page in pages())
    for name in facts.facts():
        assert f"{{{{ {name} }}}}" in stated, name


# -- what is written by hand ----------------------------------------------------------------------------------


def test_exit_statuses_are_those_of_the_program() -> None:
    text = page("conventions.md")
    for status in (SOLVED, NOT_PASSED, UNUSABLE_INPUT, NO_SOLUTION, INTERRUPTED):
        assert re.search(rf"^\| {status} \|", text, re.MULTILINE)


@pytest.mark.parametrize("model", Friction)
def test_every_friction_model_is_weighed_and_explained(model: Friction) -> None:
    assert f"`{model.value}`" in page("choose.md")
    assert f"`{model.value}`" in page("theory/procedure.md")


@pytest.mark.parametrize("source", Curves)
def test_every_source_of_characteristics_is_weighed(source: Curves) -> None:
    assert f"`{source.value}`" in page("choose.md")


@pytest.mark.parametrize("outcome", Outcome)
def test_every_outcome_is_explained(outcome: Outcome) -> None:
    assert f"`{outcome.name.lower()}`" in page("reference/json.md")
    assert not outcome.code or f"[{outcome.code}]" in page("theory/procedure.md")


def kinds_of(field: str) -> list[str]:
    sections = (section for section in case_file.sections() if field in section.reached_by)
    return [
        kind
        for section in sections
        if "kind" in section.fields
        for kind in case_file._constants(section.fields["kind"])
    ]


@pytest.mark.parametrize("kind", kinds_of("supply_element"))
def test_every_supply_element_has_its_theory(kind: str) -> None:
    words = {"slot": "**Slots**", "uneven_pockets": "Uneven pockets"}
    assert words.get(kind, f"`{kind}`") in page("theory/supply.md")


@pytest.mark.parametrize("kind", [kind for kind in kinds_of("lubricant") if kind != "catalogue"])
def test_every_viscosity_law_has_its_theory(kind: str) -> None:
    assert f"`{kind}`" in page("theory/lubricants.md")


@pytest.mark.parametrize("kind", kinds_of("housing"))
def test_every_housing_has_its_theory(kind: str) -> None:
    assert f"| {kind.replace('in_machine', 'in a machine')} |" in page("theory/procedure.md")


def keys(value: object) -> Iterator[str]:
    if isinstance(value, dict):
        for key, one in value.items():
            yield key
            if key not in ("results", "last_state", "settings", "values"):
                yield from keys(one)
    elif isinstance(value, list):
        for one in value:
            yield from keys(one)


def test_every_key_of_the_json_is_described(overloaded: Path) -> None:
    text = page("reference/json.md")
    for file in (ROOT / "examples" / "journal.yaml", ROOT / "examples" / "marine_reverse_gear.yaml", overloaded):
        record = to_json(solve(load_case(file)))
        for key in set(keys(json.loads(json.dumps(record)))):
            assert f"`{key}`" in text or f'"{key}"' in text, f"{file.name}: {key}"


@pytest.fixture
def overloaded(tmp_path: Path) -> Path:
    """A case without solution: it has keys of its own in the JSON."""
    text = (ROOT / "examples" / "journal.yaml").read_text(encoding="utf-8")
    file = tmp_path / "overloaded.yaml"
    file.write_text(text.replace("load: 24 kN", "load: 900 kN"), encoding="utf-8")
    assert not solve(load_case(file)).solved
    return file


def public_modules() -> list[str]:
    """Packages and modules that name what is public."""
    found = []
    for module in pkgutil.walk_packages(babbitt.__path__, "babbitt."):
        private = any(part.startswith("_") for part in module.name.split("."))
        if not private and module.ispkg and getattr(importlib.import_module(module.name), "__all__", None):
            found.append(module.name)
    return found


@pytest.mark.parametrize("name", public_modules())
def test_every_public_package_is_in_the_reference_of_python(name: str) -> None:
    reference = "".join(file.read_text(encoding="utf-8") for file in (DOCS / "api").glob("*.md"))
    module = importlib.import_module(name)
    whole = f".. automodule:: {name}\n" in reference
    for public in module.__all__:
        if f"{name}.{public}" in NOT_FOR_USERS:
            continue
        home = getattr(getattr(module, public), "__module__", name)
        single = any(f":: {path}.{public}\n" in reference for path in (name, home))
        assert whole or single, f"{name}.{public}"
        documented = getattr(module, public).__doc__ if not public.isupper() else "a constant"
        assert documented, f"{name}.{public} has no docstring"


def test_the_first_paragraph_of_case_files_names_every_kind():
    first = (DOCS / "reference" / "case-file.md").read_text(encoding="utf-8").split("\n\n")[1]
    assert [kind for kind in CASE_KINDS if f"`kind: {kind}`" not in first and f"`{kind}`" not in first] == []


def test_the_page_on_extension_points_names_every_subject_and_effect() -> None:
    page = (DOCS / "api" / "extension.md").read_text(encoding="utf-8")
    for word in (*Subject, *Effect):
        assert f"`{word.name.lower()}`" in page
