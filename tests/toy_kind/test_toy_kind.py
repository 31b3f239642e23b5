"""A kind of one folder and one registration is read, solved, shown, swept and explained like those that ship."""

from __future__ import annotations

import json
import math
import pickle
from dataclasses import replace

import plane_slider
import pytest
from plane_slider import view
from registration import TABLES, forget_words, registered  # noqa: F401 - a fixture of every test

import babbitt as bb
from babbitt.api.catalogue import explain
from babbitt.case import CaseError, case_schema, kinds, parse_case, template
from babbitt.core import kind as registry
from babbitt.core.quantities.quantity import quantity
from babbitt.report.citations import citations_of
from babbitt.report.content import content
from babbitt.solving import solve


def test_its_closed_form_is_that_of_the_textbook():
    """Load number 0.0267 at the film ratio 2.19 that carries most (Cameron)."""
    from plane_slider.method import load_number

    assert load_number(2.189) == pytest.approx(0.0267, abs=5e-5)
    assert load_number(5.0) < 2.0 / 3.0 * load_number(2.189) < load_number(4.5)
    assert load_number(2.189) > max(load_number(2.0), load_number(2.4))


def test_its_quadrature_comes_to_the_closed_form_by_the_square_of_its_cells():
    from plane_slider.method import load_number, load_number_by_cells

    coarse, fine = (load_number_by_cells(2.0, cells) - load_number(2.0) for cells in (50, 100))
    assert abs(fine) < 1e-3 * load_number(2.0)
    assert coarse / fine == pytest.approx(4.0, rel=0.01)


def test_its_methods_are_compared_with_their_choices():
    """A kind with two methods that takes a `method` needs no function for it: `compare` said that it has one."""
    slider = bb.parse_case(template("plane_slider") + "method: {kind: quadrature, cells: 10}\n")
    (comparison,) = slider.compare()
    assert comparison.labels == ("quadrature", "closed_form")
    exact = slider.replace(method="closed_form").solve().load
    assert comparison["closed_form"].load == exact
    errors = [abs(slider.solve({"method.cells": cells}).load / exact - 1.0) for cells in (10, 20)]
    assert errors[0] == pytest.approx(4.0 * errors[1], rel=0.1)
    assert comparison["quadrature"].load == slider.solve().load


def test_without_a_limit_there_is_no_verdict_and_a_point_of_thousands_is_told():
    text = template("plane_slider").replace("least_film: 20 um", "").replace("length: 50 mm", "length: 0.05 m")
    (result,) = solve(parse_case(text)).results
    assert result.verdict.value == "no verdict"
    assert [notice.message for notice in result.not_checked] == ["no least_film is given"]
    (result,) = solve(parse_case(template("plane_slider").replace("30 mPa s", "1.000 mPa s"))).results
    assert [notice.code for notice in result.warnings] == ["W181"]
    (kept,) = solve(parse_case(template("plane_slider"))).results
    assert [(check.code, check.ok) for check in kept.checks] == [("X102", True)]


def test_it_is_listed_and_its_template_solves():
    assert kinds()["plane_slider"] == plane_slider.KIND.description
    (result,) = solve(parse_case(template("plane_slider"))).results
    expected = 6.0 * 0.03 * 5.0 * 0.2 * (0.05 / 30e-6) ** 2 * (math.log(2.0) - 2.0 / 3.0)
    assert result.load == pytest.approx(expected, rel=1e-12)
    assert result.within_limits


def test_bad_input_is_told_by_field():
    text = template("plane_slider").replace("inlet_film: 60 um", "inlet_film: 20 um")
    with pytest.raises(CaseError, match="inlet_film: the film does not narrow"):
        parse_case(text)


def test_it_stands_in_the_schema_and_cites_the_software():
    assert "plane_slider" in json.dumps(case_schema())
    assert citations_of(parse_case(template("plane_slider")))[0].startswith("The Babbitt developers")


def test_it_is_reported():
    (chapter,) = content(solve(parse_case(template("plane_slider"))))["bearings"]
    assert chapter["method"] == "Closed form of the infinitely wide slider"
    assert {row["label"]: row["value"] for group in chapter["inputs"] for row in group["rows"]} == {
        "Length": "50",
        "Speed of the runner": "5",
    }
    assert "Film thickness at the inlet over that at the outlet" in {row["label"] for row in chapter["results"]}


def test_a_case_of_it_is_an_object_of_the_front_door():
    """`load_case` gave an object of the case language, without `solve`, `replace`, `sweep` and `to_yaml`."""
    slider = bb.parse_case(template("plane_slider"))
    assert type(slider).__name__ == "PlaneSlider"
    load = slider.solve().load
    assert slider.replace(speed="10 m/s").solve().load == pytest.approx(2.0 * load, rel=1e-12)
    assert slider.sweep({"viscosity": ["30 mPa s", 0.06]})["load"].tolist() == pytest.approx([load, 2.0 * load])
    assert slider.gradient("width", of="load")["load"]["width"] == pytest.approx(load / slider.width, rel=1e-6)
    assert bb.parse_case(slider.to_yaml()) == pickle.loads(pickle.dumps(slider)) == slider
    assert pickle.loads(pickle.dumps(type(slider)(speed="1 m/s"))).missing[:1] == ("length",)
    assert bb.OverhungCoupling(**bb.parse_case(template("overhung_coupling")).given).text.count("\n") > 8
    written = type(slider)(**slider.given).to_yaml()
    assert written.splitlines()[:3] == ["kind: plane_slider", "name: Slider", "length: 50 mm"]
    assert slider.replace({"speed": None}).missing == ("speed",)


def test_its_view_says_what_stands_at_the_head_and_in_one_table(monkeypatch):
    """Both went by a result named minimum_film_thickness; without one, key results and the table were left out."""
    monkeypatch.setattr(view, "CLOSED_FORM", replace(view.CLOSED_FORM, key_results=("load",)))
    machine = solve(parse_case(template("plane_slider")))
    (found,) = machine.solutions
    values = {name: value for name, value in found.result.values.items() if name != "minimum_film_thickness"}
    pair = [replace(found, result=replace(found.result, name=name, values=values)) for name in ("One", "Two")]
    shown = content(replace(machine, solutions=tuple(pair)))
    assert [row["label"] for row in shown["bearings"][0]["results"]] == ["Load"]
    assert shown["bearings"][0]["heading"] == "Operating point"
    assert [row["cells"][-1] for row in shown["rows"]] == ["2.000", "2.000"]


def test_the_command_line_knows_it(run, tmp_path):
    (tmp_path / "slider.yaml").write_text(template("plane_slider"), encoding="utf-8")
    code, out, err = run("solve", "slider.yaml", "--report", "slider.html", "--json", "slider.json")
    assert (code, err.count("Traceback")) == (0, 0)
    assert "Slider" in out
    assert json.loads((tmp_path / "slider.json").read_text())["bearings"][0]["results"]["film_ratio"] == 2.0
    code, out, _ = run("sweep", "slider.yaml", "outlet_film", "20 um, 30 um", "--csv", "-")
    assert code == 0
    assert len(out.splitlines()) == 3
    code, out, _ = run("compare", "slider.yaml")
    assert code == 0
    assert "closed_form: Reynolds equation in one dimension, integrated by hand." in out
    assert run("check", "slider.yaml")[0] == 0
    assert "plane_slider" in run("list", "kinds")[1]


def test_a_column_may_show_its_own_quantity(run, tmp_path):
    """Its view module is imported before the quantity is known: registering ended in KeyError."""
    shown = {column.heading: column for column in view.CLOSED_FORM.columns}
    (result,) = solve(parse_case(template("plane_slider"))).results
    assert shown["a"].cells([result]) == ["2.000"]
    (tmp_path / "slider.yaml").write_text(template("plane_slider"), encoding="utf-8")
    heads = run("sweep", "slider.yaml", "outlet_film", "20 um, 30 um", "--csv", "-")[1].splitlines()[0]
    assert "film_ratio" in heads


def test_a_slow_speed_of_its_own_is_shown_in_mm_per_second():
    assert quantity("approach", "v", "m/s", "mm/s", 4, "Speed of approach").with_unit(0.0125) == "12.50 mm/s"


def test_its_code_is_explained_and_questions_a_result(run):
    text = template("plane_slider").replace("inlet_film: 60 um", "inlet_film: 160 um")
    (result,) = solve(parse_case(text)).results
    assert [notice.code for notice in result.warnings] == ["X101"]
    assert result.warnings[0].message == "the film narrows 5.333 times"
    assert result.verdict.value == "pass with remarks"
    assert "Steep wedge" in run("explain", "x101")[1]


def test_a_code_of_another_package_is_explained_though_no_case_named_it(monkeypatch):
    """`explain` read the codes that ship, and none of the registered kinds."""
    entry = type("Entry", (), {"name": "plane_slider", "load": lambda self: plane_slider.KIND})()
    forget_words()
    del registry._REGISTERED["plane_slider"]
    monkeypatch.setattr(registry, "entry_points", lambda group: [entry])
    registry._load_others.cache_clear()
    assert explain("X101").title == "Steep wedge"


ANOTHER_LOAD = (quantity("load", "L", "1", "", 4, "A number of sliders"),)


def test_a_name_or_quantity_that_means_something_else_is_refused_and_nothing_is_added():
    before = [dict(table) for table in TABLES]
    with pytest.raises(ValueError, match="another meaning to journal"):
        registry.register(replace(plane_slider.KIND, name="journal"))
    with pytest.raises(ValueError, match="another meaning to load"):
        registry.register(replace(plane_slider.KIND, name="other", quantities="test_toy_kind:ANOTHER_LOAD"))
    with pytest.raises(ValueError, match="another meaning to E001"):
        registry.register(replace(plane_slider.KIND, name="other", words="babbitt.core.notices"))
    registry.register(plane_slider.KIND)  # once more the same changes nothing
    assert [dict(table) for table in TABLES] == before


def test_a_broken_kind_of_another_package_is_named_and_the_rest_stays_usable(monkeypatch):
    class Entry:
        def __init__(self, name, kind):
            self.name, self.kind = name, kind

        def load(self):
            if self.kind is None:
                raise ImportError("no module named lost")
            return self.kind

    found = [Entry("lost", None), Entry("second", replace(plane_slider.KIND, name="second_slider"))]
    monkeypatch.setattr(registry, "entry_points", lambda group: found)
    registry._load_others.cache_clear()
    with pytest.warns(UserWarning, match="'lost' cannot be used: ImportError: no module named lost"):
        assert registry.find_kind("second_slider") is not None
    assert registry.find_kind("journal") is not None
    assert registry.find_kind("lost") is None
