"""What every published case must do: fail when it should, tell its story, draw its figure."""

import builtins
import re
import subprocess
import sys
from dataclasses import replace
from functools import cache
from unittest.mock import patch

import pytest
from babbitt_pages import validation

from babbitt.core.notices import InputError
from babbitt.validation import (
    AtMost,
    Evidence,
    Within,
    cases,
    cases_of,
    figure_file,
    figure_of,
    page,
    save_figure,
    summary,
    validation_case,
)
from babbitt.validation.reference_data import reference_data

CASES = pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)


@cache
def rows_of(case):
    """What a case gives, run once and without matplotlib."""
    load = builtins.__import__

    def loaded(name, *given, **options):
        assert name.partition(".")[0] != "matplotlib", "nothing is drawn yet"
        return load(name, *given, **options)

    with patch("builtins.__import__", loaded):
        rows = tuple(case.run())
    vars(case)["rows"] = rows  # what page, figure and scoreboard ask for
    return rows


@cache
def page_of(case):
    rows_of(case)
    return page(case)


@CASES
def test_every_judged_value_can_fail(case):
    for row in rows_of(case):
        if not row.judged:
            continue
        if isinstance(row.tolerance, Within):
            allowed = max(row.tolerance.relative * abs(row.published), row.tolerance.absolute)
            assert allowed > 0.0, row.label
            assert not replace(row, computed=row.published + 1.01 * allowed).ok, row.label
            assert not replace(row, computed=row.published - 1.01 * allowed).ok, row.label
        else:
            factor = 1.01 if isinstance(row.tolerance, AtMost) else 0.99
            assert not replace(row, computed=factor * row.published).ok, row.label
            assert not replace(row, computed=-row.published).ok, row.label


@pytest.mark.parametrize(
    ("case_name", "data", "change"),
    [
        ("butenschoen_1976", "butenschoen_1976", lambda d: d["attitude_angle_degrees"][4].__setitem__(1, 55.993)),
        ("raimondi_boyd_1958", "raimondi_boyd_1958", lambda d: d["width_ratio_1"][3].__setitem__(1, 0.112)),
        (
            "reverse_gear_spans",
            "reverse_gear",
            lambda d: d["published"]["table_2"]["rows"][2].__setitem__("friction_power_kW", 25.98),
        ),
        (
            "reverse_gear",
            "reverse_gear",
            lambda d: d["published"]["tables_4_and_5"]["rows"][6].__setitem__("reynolds_number", 179),
        ),
        ("output_wheel_load_share", "reverse_gear", lambda d: d["published"]["table_3"].update(gear_mass_t=7.19)),
    ],
)
def test_a_wrong_number_in_the_data_makes_its_case_fail(case_name, data, change, monkeypatch):
    import copy
    from importlib import import_module

    case = validation_case(case_name)
    assert summary(rows_of(case)).agrees
    spoilt = copy.deepcopy(reference_data(data))
    change(spoilt)
    users = ("butenschoen_1976", "raimondi_boyd_1958", "reverse_gear_inputs")
    for module in (import_module(f"babbitt.validation.published.{name}") for name in users):
        monkeypatch.setattr(module, "reference_data", lambda name: spoilt)
    assert not summary(case.run()).agrees


def test_what_was_fitted_to_the_values_compared_is_no_validation():
    fitted = {case.name for case in cases_of(Evidence.REPRODUCTION)}
    assert fitted == {
        *("reverse_gear", "reverse_gear_spans", "reverse_gear_clearances", "trawler_stages"),
        *("someya_1989_table5", "fillon_1992"),
    }
    own = {case.name for case in cases_of(Evidence.REGRESSION)}
    assert own == {
        *("procedure_regression", "screw_heel_states", "film_characteristics", "film_groove_pitch"),
        "someya_1989_table3",
        "ross_five_pads",
    }
    assert {case.name for case in cases()} - {case.name for case in cases_of(Evidence.VALIDATION)} == fitted | own
    for case in cases_of(Evidence.REGRESSION):
        assert summary(rows_of(case), case.evidence).sentence.endswith("own values, regression, no validation.")
    for case in cases_of(Evidence.REPRODUCTION):
        said = case.story.assumptions.lower()
        assert any(word in said for word in ("inferred", "fitted to the values", "all inputs are ours")), case.name
        assert summary(rows_of(case), case.evidence).sentence.endswith("no validation.")


@CASES
def test_the_page_holds_every_number_and_the_whole_story(case):
    text, rows = page_of(case), rows_of(case)
    assert text.startswith(f"# {case.title}\n")
    for part in (case.story.what, case.story.source, case.story.assumptions, case.story.tolerances):
        assert len(part) > 40
        assert part in text
    assert case.story.differences in text
    assert summary(rows, case.evidence).sentence in text
    assert ("no validation" in text) is (case.evidence is not Evidence.VALIDATION)
    assert f"```{{figure}} {figure_file(case)}" in text
    for row in rows:
        line = " | ".join(cell.replace("|", "\\|") for cell in (*row.cells(), row.source))
        assert f"| {line} |" in text
        assert row.note in text


@CASES
def test_every_row_says_where_it_comes_from(case):
    rows = rows_of(case)
    assert all(row.source for row in rows)
    labels = [(row.label, row.source) for row in rows]
    assert len(set(labels)) == len(labels)


@CASES
def test_tables_of_the_page_are_rectangular(case):
    for block in re.split(r"\n\n", page_of(case)):
        if block.startswith("| "):
            widths = {len(re.findall(r"(?<!\\)\|", line)) for line in block.splitlines()}
            assert len(widths) == 1


def test_scoreboard_has_every_published_case():
    for case in cases():
        rows_of(case)
    board = validation.scoreboard()
    for case in cases():
        assert f"(/_generated/validation/{case.name}.md)" in board
        assert f"\n/_generated/validation/{case.name}\n" in board
    validations, rest = board.split("## Reproductions")
    reproductions, own = rest.split("## Own values, regression")
    assert own.count("| unchanged |") == len(cases_of(Evidence.REGRESSION))
    assert validations.count("| agrees |") == len(cases_of(Evidence.VALIDATION))
    assert reproductions.count("| reproduced |") == len(cases_of(Evidence.REPRODUCTION))


@CASES
def test_the_figure_is_drawn_with_labelled_axes(case, tmp_path):
    figure = figure_of(case)
    assert figure.axes
    assert any(axes.get_ylabel() for axes in figure.axes) or any(axes.get_yticklabels() for axes in figure.axes)
    for axes in figure.axes:
        assert axes.lines or axes.patches
    assert figure.axes[-1].get_xlabel()
    with patch("babbitt.validation.figure.figure_of", lambda _: figure):
        target = save_figure(case, tmp_path)
    assert target.name == figure_file(case)
    first = target.read_bytes()
    assert b"<svg" in first
    assert save_figure(case, tmp_path).read_bytes() == first  # the documentation does not change by itself


def test_names_are_unique_and_found():
    names = [case.name for case in cases()]
    assert len(set(names)) == len(names) == 40
    assert all(validation_case(name).name == name for name in names)


def test_an_unknown_name_is_answered_with_the_nearest_one():
    with pytest.raises(InputError, match="did you mean 'reverse_gear'") as caught:
        validation_case("reverse_geer")
    assert caught.value.code == "E005"


def test_neither_numba_nor_matplotlib_is_loaded_before_it_is_needed():
    """That no case needs matplotlib when it is run is asked by `rows_of`."""
    code = "import sys, babbitt.validation as v; v.cases(); assert not {'numba', 'matplotlib'} & {*sys.modules}"
    subprocess.run([sys.executable, "-c", code], check=True)
