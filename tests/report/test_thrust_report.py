"""Report, table and figures of thrust bearings and shaft lines hold what was computed."""

import json
import re
from dataclasses import replace

import pytest

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.thrust.report.sentences import answers as thrust_answers
from babbitt.kinds.thrust.report.tables import tables
from babbitt.report.content import content
from babbitt.report.export import to_json
from babbitt.report.figures import write_plots
from babbitt.report.machine_table import columns_of
from babbitt.report.table import render
from babbitt.solving import solve

TEMPLATE = template("thrust_line")
OIL = TEMPLATE[TEMPLATE.index("lubricant:") : TEMPLATE.index("ring_stiffness:")]
GIVEN = TEMPLATE.replace(OIL, "oil: {kind: viscosity, viscosity: 45 mPa s}\n")
LINE = GIVEN.replace("# speeds:", "speeds:").replace("number: 21", "number: 4").replace("3 um", "4 um")


@pytest.fixture(scope="module")
def line():
    return solve(parse_case(LINE))


@pytest.fixture(scope="module")
def warm():
    """With temperatures of its own; four pads take half the time of eight."""
    four = template("thrust").replace("number: 8", "number: 4").replace("load: 500 kN", "load: 250 kN")
    return solve(parse_case(four + "\nthermal: adiabatic\n"))


@pytest.fixture(scope="module")
def bearing():
    return solve(parse_case(template("thrust")))


def test_the_report_answers_and_tabulates(line):
    (chapter,) = content(line)["bearings"]
    assert len(chapter["answers"]) == 8
    assert [table["title"] for table in chapter["tables"]] == [
        "Pads at rest",
        "Oil of the pads",
        "Pads in motion",
        "Films at 2.08 Hz",
        "Films at 8.33 Hz",
        "Damped modes",
        "Peaks of the response",
        "Backing rings",
    ]
    names = [figure["name"] for figure in chapter["figures"]]
    assert names == [
        "pads-polar",
        "pad-pressure",
        "film-history",
        "mode-shapes",
        "frequency-response",
        "ring-sweep",
        "campbell",
        "axial-amplitude",
    ]
    assert all(figure["svg"].lstrip().startswith("<?xml") for figure in chapter["figures"])
    titles = [group["title"] for group in chapter["inputs"]]
    assert titles == ["As given", "Operation", "Lubricant", "Material"]
    thrust, speed = chapter["inputs"][1]["rows"]
    assert (thrust["label"], thrust["value"], thrust["unit"]) == ("Thrust", "500", "kN")
    assert (speed["value"], speed["unit"]) == ("125", "rpm")
    json.dumps(chapter)


def test_where_pads_touch_no_ring_is_advised(line):
    (result,) = line.results
    closed = tuple(replace(one, value=-1e-6) if one.code == "C202" else one for one in result.checks)
    said = thrust_answers(replace(result, checks=closed))
    assert "touches the collar" in said[0]
    assert "halve" in " ".join(thrust_answers(result))
    assert "halve" not in " ".join(said)


def test_tables_have_a_row_a_pad_with_the_loads_of_the_result(bearing):
    at_rest, oil, temperatures = tables(bearing.results[0])
    assert len(oil["rows"]) == len(temperatures["rows"]) == 8
    assert len(at_rest["rows"]) == 8
    assert all(len(row) == len(at_rest["columns"]) for row in at_rest["rows"])
    total = sum(float(row[1]) for row in at_rest["rows"])
    assert total == pytest.approx(500.0, abs=0.5)


def test_figures_are_written_one_file_each(bearing, tmp_path):
    files = write_plots(bearing, tmp_path, "png")
    assert sorted(file.name for file in files) == ["01-pad-pressure.png", "01-pads-polar.png"]
    assert all(file.read_bytes().startswith(b"\x89PNG") for file in files)


def test_the_terminal_shows_the_answers(line):
    from rich.console import Console

    console = Console(width=140, record=True, file=None, quiet=False)
    with console.capture() as caught:
        console.print(render(line.name, line.results, 140))
    assert "What dominates: the runout of the collar" in caught.get()


def test_json_holds_pads_and_rings(line):
    (record,) = to_json(line)["bearings"]
    assert len(record["results"]["pad_load"][0]) == 8
    assert len(record["results"]["ring_sweep"]) == 40
    assert len(record["results"]["campbell"]) == 4


def test_the_report_is_typeset(line, bearing):
    from babbitt.report.document import report

    assert report(line, "pdf").startswith(b"%PDF")
    page = report(bearing, "html").decode()
    assert "Pads at rest" in page


def test_a_bearing_with_its_own_temperatures_draws_and_tabulates_them(warm, tmp_path):
    assert [table["title"] for table in tables(warm.results[0])][-1] == "Temperatures of the pads"
    names = sorted(file.name for file in write_plots(warm, tmp_path, "png"))
    assert names == ["01-pad-pressure.png", "01-pad-temperature.png", "01-pads-polar.png"]
    (chapter,) = content(warm)["bearings"]
    assert any("adiabatic" in str(row) for group in chapter["inputs"] for row in group["rows"])
    assert "°C in a film" in chapter["answers"][-1]


def first_page(machine):
    """Cells of the only bearing under their headings, as text."""
    columns = columns_of(machine.results)
    return {column.heading: column.cells(machine.results)[0] for column in columns}


def test_the_first_page_shows_what_is_judged_with_its_limit(line, bearing, warm):
    """Every limit stands beside the value that its check compares; the static film of a line has none."""
    for machine in (line, bearing, warm):
        (result,) = machine.results
        shown = first_page(machine)
        judged = {QUANTITIES[check.quantity].symbol for check in result.checks if not check.advisory}
        assert {heading.split(" / ")[0] for heading in shown if " / " in heading} == judged - {"T_ex"}
        assert "–" not in " ".join(shown.values())
        tightest = {}
        for check in sorted(result.limits, key=lambda one: -one.margin):
            tightest[check.quantity] = check
        for check in tightest.values():
            quantity = QUANTITIES[check.quantity]
            for heading, cell in shown.items():
                if heading.startswith(f"{quantity.symbol} / "):
                    assert cell == f"{quantity.format(check.value)} / {quantity.format(check.limit)}"
    assert {"h_min", "h_dyn / h_lim", "L_1 / L_lim"} <= first_page(line).keys()
    assert "h_min / h_lim" not in first_page(line)


def test_the_pressure_on_a_pad_stands_beside_the_limit_of_a_metal_that_is_named():
    named = first_page(solve(parse_case(template("thrust"))))
    assert named["p̄_max / p_lim"].endswith(" / 5.00")


def test_a_film_that_is_judged_itself_stands_beside_its_limit():
    still = solve(parse_case(template("thrust").replace("runout: 5 um", "runout: 0 um")))
    assert first_page(still)["h_min / h_lim"].endswith(" / 10.0")
    assert "h_min" not in first_page(still)


def given(machine):
    (chapter,) = content(machine)["bearings"]
    return {row["label"]: row["value"] for group in chapter["inputs"] for row in group["rows"]}


def test_no_runout_and_no_ripple_are_told():
    start, end = LINE.index("ripple:"), LINE.index("limits:")
    none = solve(parse_case(LINE[:start] + "ripple: []\nrunout: []\n" + LINE[end:]))
    assert given(none)["Runout of the collar"] == given(none)["Thrust ripple"] == "none"
    assert none.results[0].loss_mean_bound == 0.0


def test_a_constant_viscosity_is_told_once_and_does_not_rise(line, bearing):
    said = given(line)
    assert said["Dynamic viscosity"] == "45"
    assert not [label for label in said if "Kinematic" in label]
    cold, warm = (float(given(bearing)[f"Kinematic viscosity at {t} °C"]) for t in (40, 100))
    assert cold > warm


def test_the_metal_of_the_pads_is_told(bearing):
    named = solve(parse_case(template("thrust")))
    assert given(named)["Bearing metal"] == "B83"
    unnamed = solve(parse_case(template("thrust").replace("materials: {bearing_metal: B83}", "#")))
    assert "Bearing metal" not in given(unnamed)
    assert "at the hottest trailing edge, within the limit of 115.0 °C" in thrust_answers(bearing.results[0])[-1]


def test_no_journal_is_spoken_of():
    solved = solve(parse_case(template("thrust")))
    (chapter,) = content(solved)["bearings"]
    labels = [row["label"] for row in chapter["results"]]
    assert "Rotational speed of the collar" in labels
    assert not [said for said in labels if "journal" in said]


def test_what_is_held_against_an_assumed_metal_is_not_listed_as_unchecked():
    """In the table of checks, as recommendations, and with the reason why they leave no verdict."""
    machine = solve(parse_case(re.sub(r"(?m)^materials:.*$", "", GIVEN)))
    bearing = content(machine)["bearings"][0]
    made = {check["code"] for check in bearing["checks"]}
    unchecked = {code for one in bearing["not_checked"] for code in one["code"].split(", ")}
    assert "C103" in made
    assert not made & unchecked
    (load,) = (one for one in bearing["lacking"] if "C103" in one["code"])
    assert "recommendation" in load["title"]
    assert "assumed" in load["message"]
