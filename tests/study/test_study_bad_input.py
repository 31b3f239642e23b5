"""What every kind of study refuses, in one clear line each, before anything is solved or written."""

from __future__ import annotations

import pytest
from studied_cases import block, journal

from babbitt.case import CaseError
from babbitt.case.study_file import load_study
from babbitt.core.notices import InputError
from babbitt.study.plan import plan, require_possible

GRIDS = ("sweep", "size", "map")
LAWS = ("tolerance", "sensitivity", "optimise")
KINDS = (*GRIDS, *LAWS, "design", "spectrum")


def study_over(kind, vary):
    """A study of a kind over one field, with what else its kind needs."""
    more = {"optimise": {"minimise": ["friction_power"]}, "map": {}}.get(kind, {})
    if kind == "map":
        vary = {**vary, "speed": ["1000 rpm", "2000 rpm"]}
    if kind == "spectrum":
        cases = [{"share": 1.0, "set": {path: one[0] for path, one in vary.items()}}]
        return block(kind=kind, load_cases=cases)
    return block(kind=kind, vary=vary, **more)


def refusal(kind, vary):
    with pytest.raises(InputError) as refused:
        require_possible(journal(), study_over(kind, vary))
    assert "\n" not in refused.value.message
    return refused.value.message


def test_a_case_named_within_the_study_is_told_its_place(tmp_path):
    path = tmp_path / "study.yaml"
    path.write_text("study:\n  kind: corners\n  case: journal.yaml\n")
    with pytest.raises(CaseError) as refused:
        load_study(path)
    (problem,) = refused.value.problems
    assert (problem.line, problem.field) == (3, "study.case")
    assert "case stands within the study" in str(refused.value)
    assert "put it beside study" in str(refused.value)
    assert "allowed" not in str(refused.value)


@pytest.mark.parametrize("kind", KINDS)
def test_an_unknown_path_is_told_with_the_nearest(kind):
    message = refusal(kind, {"laod": ["1 kN"]})
    assert "'laod' is no field; did you mean 'load'?" in message


@pytest.mark.parametrize("kind", KINDS)
def test_a_value_of_another_quantity_is_told(kind):
    assert "'2 mm' is a length" in refusal(kind, {"load": ["2 mm"]})


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "spectrum"])
def test_a_field_of_words_has_no_range(kind):
    assert "is not numeric, so that 'range' says nothing" in refusal(kind, {"lubricant": {"range": [1, 2, 3]}})


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "spectrum"])
def test_an_empty_range_is_told(kind):
    assert "is empty" in refusal(kind, {"load": {"range": ["5 kN", "5 kN", 3]}})


@pytest.mark.parametrize("kind", [*LAWS, "design", *GRIDS])
def test_ends_in_the_wrong_order_are_told(kind):
    assert "rising values" in refusal(kind, {"load": {"uniform": ["5 kN", "2 kN"]}})


@pytest.mark.parametrize("kind", LAWS)
def test_a_distribution_beyond_the_field_is_told(kind):
    assert "the smallest value -5 kN" in refusal(kind, {"load": {"normal": ["10 kN", "5 kN"]}})


@pytest.mark.parametrize("kind", [*GRIDS, "design"])
def test_a_grid_has_no_distributions(kind):
    assert "a grid needs values" in refusal(kind, {"load": {"uniform": ["5 kN", "9 kN"]}})


@pytest.mark.parametrize("kind", KINDS)
def test_values_of_which_none_is_possible_are_told(kind):
    assert "takes none of its values" in refusal(kind, {"load": ["-1 kN"]})


@pytest.mark.parametrize("kind", ["tolerance", "sensitivity"])
def test_a_million_million_samples_are_refused_with_their_size(kind):
    made = block(kind=kind, vary={"load": {"uniform": ["1 kN", "2 kN"]}}, samples=1e12)
    with pytest.raises(InputError, match=r"study: the study has .*e\+12 rows, about .* GB"):
        require_possible(journal(), made)


def test_a_grid_of_a_million_million_rows_is_refused():
    wide = {"load": {"range": ["1 kN", "2 kN", 10_000]}, "speed": {"range": ["100 rpm", "200 rpm", 10_000]}}
    vary = {**wide, "width": {"range": ["60 mm", "70 mm", 10_000]}}
    with pytest.raises(InputError, match=r"1e\+12 rows, about .* GB"):
        require_possible(journal(), block(kind="sweep", vary=vary))


def test_too_many_designs_are_refused_before_any_is_tried():
    fits = [f"H{bore}/{shaft}{grade}" for bore in (6, 7, 8, 9) for shaft in "cdefgh" for grade in (5, 6, 7, 8, 9)]
    points = {"range": ["10 kN", "20 kN", 4]}
    vary = {"clearance": fits, "load": points, "speed": {"range": ["1000 rpm", "2000 rpm", 4]}}
    with pytest.raises(InputError, match=r"designs are to be tried; allowed: 200000"):
        require_possible(journal(), block(kind="design", vary=vary))


def test_a_choice_in_a_sensitivity_is_told():
    assert "lubricant" in refusal("sensitivity", {"lubricant": ["ISO VG 32", "ISO VG 46"]})


@pytest.mark.parametrize(
    ("study", "says"),
    [
        ({"kind": "size"}, "names 0 fields, and a size is sought of one"),
        ({"kind": "size", "vary": {"load": ["1 kN"], "speed": ["1 rpm"]}}, "names 2 fields"),
        ({"kind": "size", "field": "load", "vary": {"speed": ["1 rpm"]}}, "names 2 fields"),
        (
            {"kind": "sweep", "vary": {"load": ["1 kN"]}, "limits": ["C101"]},
            "is not read by a study of kind sweep",
        ),
        ({"kind": "size", "field": "load", "reserve": 0.1}, "is not read by a study of kind size"),
        ({"kind": "design", "reserve": 2.0}, "allowed: 0 to 1"),
    ],
)
def test_a_block_that_its_kind_does_not_read_is_told(study, says):
    from studied_cases import JOURNAL

    from babbitt.case.loading import case_from_dict

    with pytest.raises(InputError) as refused:
        case_from_dict({**JOURNAL, "study": study})
    assert says in refused.value.message


@pytest.mark.parametrize(
    ("study", "says"),
    [
        ({"kind": "size", "field": "load", "limits": ["C999"]}, "no check 'C999'"),
        ({"kind": "size", "field": "supply.temperature"}, "a decade means nothing"),
        ({"kind": "size", "field": "laod"}, "did you mean 'load'"),
        ({"kind": "size", "field": "materials.bearing_metal"}, "takes no quantity"),
        ({"kind": "design", "vary": {"method": ["film"]}}, "found by iso7902 and confirmed by film"),
    ],
)
def test_what_the_case_does_not_have_is_told(study, says):
    with pytest.raises(InputError) as refused:
        plan(journal(), block(**study))
    assert says in refused.value.message
    assert "\n" not in refused.value.message
