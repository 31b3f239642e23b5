"""Inputs that the case does not give are marked in the report, others are not."""

from __future__ import annotations

import datetime
import typing
from collections.abc import Iterator
from pathlib import Path

import pytest

import babbitt
from babbitt.case import load_case, parse_case, template
from babbitt.case.part import Part, given_paths
from babbitt.core.kind import kinds
from babbitt.core.language import LANGUAGES, phrases
from babbitt.core.report_level import Level
from babbitt.report.content import content
from babbitt.report.document import typeset
from babbitt.report.inputs import OIL, inputs
from babbitt.report.title_block import title_content
from babbitt.report.view import find_view
from babbitt.solving import solve

EXAMPLES = Path(babbitt.__file__).parents[2] / "examples"
LEGEND = "not in the case: default, assumption or catalogue"
SAID = """
babbitt: 1
kind: journal
name: Said
diameter: 120 mm
width: 60 mm
span: 180 deg
clearance: {kind: relative, mean: 1.5 permille}
load: 12 kN
speed: 2000 rpm
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 100 kPa}
supply_element: {kind: pocket, width: 40 mm, place: both_sides}
surfaces: {kind: direct, roughness_bearing: 2 um, roughness_journal: 1 um}
materials: {bearing: C10, journal: 42CrMo4, bearing_metal: SnSb8Cu4}
"""
WRITTEN = {
    "wave_factor": ("roughness_journal: 1 um", "roughness_journal: 1 um, wave_factor: 1"),
    "tilt_offset": ("roughness_journal: 1 um", "roughness_journal: 1 um, tilt_offset: 0 um"),
    "Character of the load": ("SnSb8Cu4}", "SnSb8Cu4, load_character: calm}"),
    "Friction": ("kind: journal\n", "kind: journal\nfriction: {model: full}\n"),
    "Characteristics": ("kind: journal\n", "kind: journal\ncharacteristics: computed\n"),
    "Procedure": ("kind: journal\n", "kind: journal\nmethod: iso7902\n"),
    "density": ("lubricant: ISO VG 46", "lubricant: {kind: iso_vg, grade: 46, density: 879 kg/m3}"),
}
"""What is written in the case, by the input that it gives: the number or the choice that holds without it."""


def marked(case, place=0) -> set[str]:
    problem = case.calculations()[place].problem
    view = find_view(problem.kind, case.calculations()[place].method.name)
    given = frozenset(given_paths(case, problem.name))
    groups = inputs(problem, view, getattr(problem, "given", ()))
    rows = [row for group in groups for row in group.rows]
    return {row.name or row.label for row in rows if row.is_left_out(view.left_out, given)}


@pytest.mark.parametrize("name", WRITTEN)
def test_an_input_is_marked_until_the_case_writes_it(name):
    assert name in marked(parse_case(SAID))
    found = marked(parse_case(SAID.replace(*WRITTEN[name])))
    assert found == marked(parse_case(SAID)) - {name}


def test_sizes_load_speed_and_oil_are_given():
    given = {
        "diameter",
        "width",
        "load",
        "angular_speed",
        "supply_temperature",
        "supply_pressure",
        "Bearing metal",
    }
    assert not marked(parse_case(SAID)) & given
    assert "expansion_bearing" not in marked(parse_case(SAID))
    without = marked(load_case(EXAMPLES / "long_film.yaml"))
    assert "Nusselt number of the film" in without or "Discretisation" in without


def test_a_bearing_of_a_machine_has_the_fields_of_its_own_and_the_shared_ones():
    case = parse_case(template("machine"))
    paths = [frozenset(given_paths(case, one.problem.name)) for one in case.calculations()]
    assert "bearings.load" in paths[0] - paths[1]
    assert "bearings.operating_points.span" in paths[2] - paths[1] - paths[0]
    assert "supply.temperature" in paths[0] & paths[1] & paths[2]


def fields_of(model: type, seen: tuple[type, ...] = ()) -> Iterator[str]:
    """Paths of all fields that a part can have."""
    for name, field in model.model_fields.items():
        yield name
        for part in parts_in(field.annotation):
            if part not in seen:
                yield from (f"{name}.{path}" for path in fields_of(part, (*seen, part)))


def parts_in(annotation) -> set[type]:
    if isinstance(annotation, type) and issubclass(annotation, Part):
        return {annotation}
    return {part for one in typing.get_args(annotation) for part in parts_in(one)}


def test_every_field_that_gives_an_input_is_one_of_the_kind():
    known: dict[str, set[str]] = {}
    wanted = {}
    for kind in (one for one in kinds().values() if one.name != "hand_made"):
        fields = set(fields_of(kind.load_model()))
        if kind.name == "journal":  # stands on shafts, too
            fields |= set(fields_of(kinds()["shaft"].load_model()))
        for path in kind.views.values():
            view = kind.load(path)
            wanted |= {(id(view.left_out), name): names for name, names in view.left_out.items()}
            for name, names in view.left_out.items():
                found = {one for one in names if any(f".{path}".endswith(f".{one}") for path in fields)}
                known.setdefault((id(view.left_out), name), set()).update(found)
    for key, names in wanted.items():
        assert known[key] == set(names), key
    assert OIL


@pytest.mark.parametrize("language", [one for one in LANGUAGES if one != "en"])
def test_the_legend_is_in_every_language(language):
    assert LEGEND in phrases(language)


def test_the_report_marks_them_and_a_machine_made_by_hand_says_nothing():
    machine = solve(parse_case(SAID))
    for one, expected in ((machine, True), (type(machine)(machine.name, machine.solutions, "0" * 64), False)):
        bearing = content(one, Level.STANDARD)["bearings"][0]
        rows = [row for group in bearing["inputs"] for row in group["rows"]]
        assert any("left_out" in row for row in rows) is expected


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.yaml")))
def test_every_example_tells_them_apart(name):
    case = load_case(EXAMPLES / name)
    problem = case.calculations()[0].problem
    view = find_view(problem.kind, case.calculations()[0].method.name)
    rows = [row for group in inputs(problem, view, getattr(problem, "given", ())) for row in group.rows]
    assert not view.left_out or 0 < len(marked(case)) < len(rows)


def test_fields_in_remedies_are_set_as_code():
    made = content(solve(parse_case(SAID)), Level.STANDARD)
    found = [{"code": "W123", "title": "T", "message": "M", "remedy": "Try `method: film` once."}]
    made["bearings"][0]["warnings"] = [{"heading": "Remarks", "found": found}]
    title = title_content(None, datetime.date(2026, 1, 1))
    page = typeset(made | {"title": title}, "report.typ", "html").decode()
    assert "Try <code>method: film</code> once." in page


def test_the_bore_of_a_fit_is_not_the_form_of_the_bore():
    """`clearance.bore` was taken for the `bore` of the bearing."""
    fit = SAID.replace("{kind: relative, mean: 1.5 permille}", "{kind: fit, bore: H7, journal: d8}")
    form = "method: film\ngrooves: [{angle: 90 deg, extent: 20 deg}]\n"
    fit = fit.replace("span: 180 deg\n", form).replace(
        "supply_element: {kind: pocket, width: 40 mm, place: both_sides}\n", "effective_temperature: 60 degC\n"
    )
    assert "Form of the bore" in marked(parse_case(fit))


def test_pads_mark_what_their_case_leaves_out():
    """Tilt, deflection, waviness and a pivot in the middle of a pad stood there as if the case gave them."""
    case = load_case(EXAMPLES / "turbine_tilting_pads.yaml")
    found = marked(case)
    assert {"tilt_offset", "mean_deflection", "waviness", "wave_factor", "Pivot, from the leading edge"} <= found
    assert not {"roughness_bearing", "Pivot"} & found
    text = (EXAMPLES / "turbine_tilting_pads.yaml").read_text()
    written = text.replace("{kind: rocker}", "{kind: rocker, fraction: 0.5}")
    assert marked(parse_case(written)) == found - {"Pivot, from the leading edge"}


@pytest.mark.usefixtures("no_images")
def test_the_direction_of_a_load_that_follows_from_a_shaft_is_neither_given_nor_a_default():
    """It stood twice: as given, and as one that the case leaves out."""
    machine = solve(load_case(EXAMPLES / "helical_gear_shaft.yaml"))
    (bearing, *_) = (one for one in content(machine)["bearings"] if one["name"].startswith("Bearing at stage"))
    told = [(group["title"], row) for group in bearing["inputs"] for row in group["rows"]]
    of_load = [
        (title, row) for title, row in told if "oad angle" in row["label"] or "of the load f" in row["label"]
    ]
    ((title, row),) = of_load
    assert (title, row["label"]) == ("Operation", "Direction of the load from +x")
    assert "left_out" not in row
    assert "Direction of the load from +x" in marked(load_case(EXAMPLES / "pressure_dam.yaml"))


SECOND_PIECE = {
    "shaft": (", modulus: 206 GPa, density: 7850}", ", modulus: 70 GPa}"),
    "thrust_line": ("- {length: 30 m, diameter: 360 mm}", "- {length: 30 m, diameter: 360 mm}\n"
                    "  - {length: 1 m, diameter: 360 mm, modulus: 70 GPa}"),
}  # fmt: skip
"""What makes the second piece of the template of light metal, of which the density is not written."""


@pytest.mark.parametrize("kind", SECOND_PIECE)
def test_the_steel_of_a_shaft_stands_among_its_inputs_and_is_marked_where_it_is_a_default(kind):
    case = parse_case(template(kind).replace(*SECOND_PIECE[kind]))
    calculation = case.calculations()[0]
    problem = calculation.problem
    view = find_view(problem.kind, calculation.method.name)
    steel = {
        row.label: row.value
        for group in inputs(problem, view, problem.given)
        for row in group.rows
        if row.label.startswith(("Young's modulus", "Density of the shaft"))
    }
    density = f"Density of the shaft, pieces 1 to {len(case.shaft)}"
    assert steel["Young's modulus, piece 1"] == "206 GPa"
    assert steel["Young's modulus, piece 2"] == "70 GPa"
    assert steel[density] == "7850 kg/m³"
    assert marked(case) & steel.keys() == steel.keys() - {"Young's modulus, piece 2"}
