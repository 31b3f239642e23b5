"""A mistake in a kind of another package is named, in one line where it stops a run, and hurts no other kind."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Literal

import plane_slider
import pytest
from plane_slider import case as slider_case
from plane_slider import method, view
from plane_slider.case import PlaneSliderCase
from pydantic import Field
from registration import registered, unregistered  # noqa: F401 - fixtures of every test

from babbitt.case import case_schema, parse_case, template
from babbitt.case.case_file import CaseFile
from babbitt.core import kind as registry
from babbitt.core.kind import kinds, register
from babbitt.core.notices import InputError, Notice
from babbitt.core.result import Check, Outcome, Result
from babbitt.core.solution import Calculation
from babbitt.core.units import si
from babbitt.report.columns import column_of
from babbitt.report.content import content
from babbitt.report.vocabulary import VOCABULARY
from babbitt.solving import solve
from babbitt.study.comparison import Comparison, Variant
from babbitt.testing import check_kind, mistakes_of

KIND = plane_slider.KIND
pytestmark = pytest.mark.usefixtures("unregistered")


class BareCase(CaseFile):
    """Without notes, source and assumptions, and with a problem that has no more than its kind and name."""

    kind: Literal["bare"] = Field(description="Bare.")
    name: str = Field("Bare", description="Name.")

    def calculations(self):
        bare = method.Slider(self.name, 0.05, 0.2, 60e-6, 30e-6, 5.0, 0.03, kind="bare")
        return (Calculation(bare, method.ClosedForm()),)


def compare(case):
    one = case.calculations()[0].solve()[0]
    return (Comparison(case.name, (Variant("a", "", one), Variant("a", "", one)), ("laod",)),)


def misspelt_value(*given, **more):
    result = Result(*given, **more)
    return replace(result, values={**result.values, "film_rato": 2.0})


def changed_view(**changes):
    return lambda patch: patch.setattr(view, "CLOSED_FORM", replace(view.CLOSED_FORM, **changes))


SILENT = {
    "result": (lambda patch: patch.setattr(method, "Result", misspelt_value), "'film_rato' is not a quantity"),
    "column": (changed_view(columns=(column_of("film_rato", 0),)), "'film_rato' is not .* has a column"),
    "key result": (changed_view(key_results=("laod",)), "'laod' is not .* key result; did you mean 'load'"),
    "sweep": (changed_view(sweep=("laod",)), "'laod' is not .* sweep of a view"),
    "problem": (
        lambda patch: patch.setattr(slider_case, "Slider", partial(method.Slider, kind="plain_slider")),
        "kind of Slider is 'plain_slider', not 'plane_slider'",
    ),
    "method": (
        lambda patch: patch.setattr(method.ClosedForm, "name", "closed_from"),
        "'closed_from' is not among the views; did you mean 'closed_form'",
    ),
    "assumptions": (
        lambda patch: patch.setattr(slider_case, "Slider", lambda *given, **_: method.Slider(*given)),
        "assumptions of a case do not reach its results(.|\n)*W181 does not reach",
    ),
}


@pytest.mark.parametrize(("spoil", "says"), SILENT.values(), ids=SILENT)
def test_what_was_left_out_without_a_word_is_named(spoil, says, monkeypatch):
    assert mistakes_of(KIND) == ()
    spoil(monkeypatch)
    with pytest.raises(AssertionError, match=says):
        check_kind(KIND)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"views": {"closed_from": KIND.views["closed_form"]}}, "'closed_form' is not among the views"),
        ({"comparison": "test_mistakes_of_kinds:compare"}, "'laod' is not .* compared(.|\n)*'a' stands twice"),
        ({"template": "plane_slider:lost.yaml"}, "plane_slider:lost.yaml: FileNotFoundError"),
        ({"model": "plane_slider.case:Lost"}, "plane_slider.case:Lost: AttributeError"),
        ({"model": "plane_slider.method:Slider"}, "plane_slider.method:Slider is not a class of CaseFile"),
        ({"name": "slider"}, r'the field kind of .*PlaneSliderCase is not Literal\["slider"\]'),
        ({"meanings": "test_mistakes_of_kinds:MEANINGS"}, "'laod' is not a quantity"),
        ({"views": KIND.views | {"quadrature": "plane_slider.view:LOST"}}, "view of quadrature: .*LOST"),
        ({"words": "babbitt.core.notices"}, "registration: ValueError: .* gives another meaning to"),
    ],
)
def test_a_part_that_does_not_fit_is_named(changes, says):
    with pytest.raises(AssertionError, match=says):
        check_kind(replace(KIND, **changes))


MEANINGS = {"laod": "Load"}


def test_a_check_without_words_or_quantity_ends_in_one_line(monkeypatch, run, tmp_path):
    """The report ended in KeyError: 'X999'."""
    register(KIND)
    (tmp_path / "slider.yaml").write_text(template("plane_slider"), encoding="utf-8")
    for swapped, says in (
        (lambda _, *rest: Check("X999", *rest), "no words.en.toml has the code X999"),
        (lambda code, _, *rest: Check(code, "laod", *rest), "check X102 is of 'laod', which is no quantity"),
    ):
        monkeypatch.setattr(method, "Check", swapped)
        code, _, err = run("solve", "slider.yaml")
        assert (code, err.count("Traceback")) == (2, 0)
        assert says in err
        assert "E008" in err


def test_a_case_without_notes_and_a_problem_without_words_of_the_case_are_reported():
    """Both ended in AttributeError."""
    register(replace(KIND, name="bare", model="test_mistakes_of_kinds:BareCase"))
    shown = content(solve(parse_case("kind: bare")))
    assert (shown["notes"], shown["source"]) == ("", "")
    assert shown["bearings"][0]["inputs"][0]["title"] == "Geometry"


def test_a_unit_that_no_field_has_is_named():
    with pytest.raises(ValueError, match="'furlong' is not an SI unit of a field"):
        si("furlong")
    with pytest.raises(ValueError, match="did you mean 'm3/s'"):
        si("m3/sec")


def test_a_lost_template_is_no_matter_of_standard_output(run):
    register(replace(KIND, template="plane_slider:lost.yaml"))
    code, _, err = run("new", "plane_slider")
    assert code == 2
    assert "the bearing kind 'plane_slider' has a mistake: plane_slider:lost.yaml" in err
    assert "standard output" not in err


def test_a_broken_model_or_vocabulary_leaves_other_kinds_usable(monkeypatch):
    """One model that is not there ended `babbitt schema` for all kinds, one such sheet every report."""
    register(replace(KIND, model="plane_slider.case:Lost", vocabulary="plane_slider.view:LOST"))
    with pytest.warns(UserWarning, match="left out: the bearing kind 'plane_slider' has a mistake"):
        kept = case_schema()
    assert {*kept["discriminator"]["mapping"]} == {*kinds()} - {"plane_slider"}
    VOCABULARY._read.pop("plane_slider", None)
    with pytest.warns(UserWarning, match="left out: the bearing kind 'plane_slider'"):
        assert "wedge" not in VOCABULARY
    with pytest.raises(InputError, match=r"plane_slider.case:Lost"):
        parse_case("kind: plane_slider")
    VOCABULARY._read.pop("plane_slider", None)


def test_a_code_of_a_kind_that_is_not_registered_says_how_it_is():
    with pytest.raises(KeyError, match=r"X101; those of another package are known once its kind is registered"):
        Notice("X101", values={"film_ratio": 6.0})
    register(KIND)
    with pytest.raises(ValueError, match="no outcome has the code X101; allowed: S001, "):
        Outcome.of(Notice("X101", values={"film_ratio": 6.0}))


@pytest.mark.parametrize("name", ["overhung_coupling", "jacking_pocket"])
def test_kinds_that_ship_have_no_mistakes(name):
    check_kind(registry.kinds()[name])


def test_what_a_solution_takes_from_its_problem_stands_once():
    register(KIND)
    case = parse_case(template("plane_slider").replace("60 um", "160 um") + "assumptions: [Rigid.]\n")
    assert isinstance(case, PlaneSliderCase)
    (found,) = case.calculations()[0].solve()
    assert found.result.assumptions == replace(found, state=1).result.assumptions == ("Rigid.",)
    case._grouped = (("length", "12.000 N"),)
    (found,) = case.calculations()[0].solve()
    assert [notice.code for notice in found.result.warnings] == ["W181", "X101"]
