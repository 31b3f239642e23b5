"""The checker's page: inputs, verdict and governing check of a bearing at all its clearances."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from babbitt import load_case, parse_case
from babbitt.case import template
from babbitt.core.kind import kinds
from babbitt.core.result import Outcome
from babbitt.report.chapters import Chapter, chapters
from babbitt.report.checker_page import checker_content
from babbitt.report.content import content
from babbitt.report.document import report
from babbitt.solving import solve

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def part():
    text = kinds()["journal"].read_template().replace("clearance_cases: mean", "clearance_cases: all")
    (found,) = chapters(parse_case(text).solve().machine.solutions)
    assert len(found.members) == 3
    return found


def cell(made, symbol):
    place = next(at for at, one in enumerate(made["columns"]) if one["heading"][0][1] == symbol)
    return made["rows"][0]["cells"][place]


def test_all_clearances_of_a_bearing_are_shown_and_what_does_not_vary_once(part):
    made = checker_content([part], [], [[]])
    assert cell(made, "ψ").count(" / ") == 2
    assert cell(made, "D") == "120.00"


def test_a_clearance_without_a_solution_is_not_hidden_by_one_that_passes(part):
    first, *others = part.members
    unsolved = replace(first.result, outcome=Outcome.NOT_CONVERGED)
    lacking = Chapter(part.name, (replace(first, solution=SimpleNamespace(result=unsolved)), *others))
    assert lacking.shown.result.outcome.solved
    assert checker_content([lacking], [], [[]])["rows"][0]["verdict"] == "no solution"


def test_the_governing_check_has_the_least_margin_and_names_its_clearance(part):
    (governing,) = checker_content([part], [], [[]])["governing"]
    worst = min(part.results, key=lambda one: one.governing_check.margin)
    assert governing["bearing"] == worst.name
    assert governing["code"] == worst.governing_check.code


def test_the_page_on_screen_has_it_as_the_paper_has(part):
    pytest.importorskip("typst")
    page = report(solve(parse_case(kinds()["journal"].read_template())), "html").decode()
    _, _, last = page.partition("Checker&#39;s page" if "Checker&#39;s page" in page else "Checker's page")
    assert "Closest approach to each limit" in last
    assert "☐" in last
    assert "Approved:" in last


@pytest.mark.parametrize("kind", ["thrust", "thrust_line"])
def test_pads_are_known_again_by_their_inputs_row_by_row(kind):
    """No diameter, width or clearance is theirs: pads, radii, pivot, tilt, runout and oil stand in rows."""
    page = content(solve(parse_case(template(kind))))["checker"]
    (given,) = page["given"]
    labels = {row["label"] for row in given["rows"]}
    assert {"Pads", "Pivot", "Tilt of the housing", "Runout of the collar", "Thrust", "Name"} <= labels
    assert content(solve(parse_case(template("journal"))))["checker"]["given"] == []


@pytest.mark.usefixtures("no_images")
def test_all_inputs_of_each_bearing_stand_there_and_what_they_share_once():
    """Of a machine it had only diameter, width, clearance, load, speed and supply."""
    made = content(solve(load_case(EXAMPLES / "marine_reverse_gear.yaml")))
    first, *others = made["checker"]["others"]
    assert first["name"] == "All bearings"
    assert [one["name"] for one in others] == [row["name"] for row in made["checker"]["rows"]]

    def rows(one):
        return [(group["title"], row) for group in one["groups"] for row in group["rows"]]

    common = {row["label"]: row["value"] for _, row in rows(first)}
    assert {"Name", "Thermal expansion of the bearing", "Offset of the axis over the width by tilt"} <= set(common)
    assert common["Oil volume over flow"] == "10"
    assert common["Factor on the friction number"] == "1.1"
    shown = [column["heading"][0] for column in made["checker"]["columns"]]
    for one, bearing in zip(others, made["bearings"], strict=True):
        assert {"Angular span", "Supply element"} <= {row["label"] for _, row in rows(one)}
        groups = [group for group in bearing["inputs"] if group["title"] != "As given"]
        wanted = [(it["title"], row) for it in groups for row in it["rows"] if row["symbol"] not in shown]
        told = rows(first) + rows(one)
        assert len(told) == len(wanted)
        assert all(it in told for it in wanted)
