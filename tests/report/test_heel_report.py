"""Table, figures and report of a footstep."""

import itertools
from io import StringIO

import pytest
from heels import STUDY
from rich.console import Console

from babbitt.case import parse_case
from babbitt.report.content import content
from babbitt.report.figures import write_plots
from babbitt.report.table import print_machine
from babbitt.solving import solve

TEXT = STUDY
WITHOUT = TEXT.replace("face_gap: 20 um", "face_gap: 12 um").replace("mean: 20 um", "mean: 10 um")


@pytest.fixture(scope="module")
def machine():
    return solve(parse_case(TEXT))


def printed(machine):
    to = Console(file=StringIO(), width=140, highlight=False)
    print_machine(machine, to)
    return to.file.getvalue()


def test_states_stand_side_by_side(machine):
    text = printed(machine)
    row = next(line for line in text.splitlines() if line.startswith("Pressure at the rim"))
    assert row.split()[-3:] == ["0.5156", "0.5067", "0.9226"]
    assert next(line for line in text.splitlines() if line.startswith("steady state")).split()[-4:] == [
        "stable", "not", "stable", "stable",
    ]  # fmt: skip
    assert "W160" in text


def test_no_steady_state_is_told_on_the_terminal():
    text = printed(solve(parse_case(WITHOUT)))
    assert "no solution" in text
    assert "no steady state" in text
    assert "0.8979" not in text  # no state of the grooved heel is shown as one


def test_the_report_has_one_chapter_with_all_states(machine):
    data = content(machine)
    (chapter,) = data["bearings"]
    assert chapter["clearances"] == ["smooth heel", "hot state", "cold state"]
    by_label = {row["label"]: row["values"] for row in chapter["results"]}
    assert by_label["Flow of the groove towards the rim"] == ["–", "14.94", "238.1"]
    assert [figure["name"] for figure in chapter["figures"]] == ["steady-states", "load-over-gap"]
    said = {row["label"]: row["value"] for group in chapter["inputs"] for row in group["rows"]}
    assert said["Starts"] == "5"
    assert said["Pressure in the recess, absolute"] == "0.63"
    assert any("β" in assumption for assumption in chapter["assumptions"])


def test_figures_are_written_once_and_also_without_a_steady_state(machine, tmp_path):
    for number, one in enumerate((machine, solve(parse_case(WITHOUT)))):
        paths = write_plots(one, tmp_path / str(number))
        assert [path.name[3:] for path in paths] == ["steady-states.svg", "load-over-gap.svg"]


def test_stable_branches_are_full_and_unstable_ones_broken():
    import numpy as np

    from babbitt.kinds.footstep.report import figures as heel_figures

    case = solve(parse_case(TEXT)).problems[1]
    with heel_figures.style():
        figure = heel_figures._over_clearance(case)
    load = figure.axes[4]
    curves = [line for line in load.lines if len(line.get_xdata()) > 50 and np.isfinite(line.get_ydata()).any()]
    full = [line for line in curves if line.get_linestyle() == "-"]
    broken = [line for line in curves if line.get_linestyle() == "--"]
    assert len(broken) == 1  # the hot branch, all of it
    assert len(full) == 2  # smooth and cold
    hot, cold = (np.isfinite(line.get_ydata()) for line in (broken[0], full[1]))
    assert (hot == cold).all()  # both end at the fold


def test_curves_of_the_study_are_drawn_over_gap_and_clearance():
    """Temperature of the mixed oil and leakage, its Figs. 2 and 3; golden values at 20/20 um as marks."""
    from babbitt.kinds.footstep.report import figures as heel_figures

    case = solve(parse_case(TEXT)).problems[1]
    with heel_figures.style():
        figures = heel_figures._over_clearance(case), heel_figures._over_gap(case)
    for figure, names in zip(figures, (heel_figures.OVER_CLEARANCE, heel_figures.OVER_GAP), strict=True):
        panels = dict(zip(names, figure.axes, strict=True))
        for name, states in (("rim_temperature", (38.51, 32.37)), ("heel_leakage", (66.84, 115.39))):
            marks = [line for line in panels[name].lines if line.get_marker() == "o"]
            assert sorted(float(mark.get_ydata()[0]) for mark in marks) == pytest.approx(sorted(states), rel=1e-3)
            curves = [line for line in panels[name].lines if len(line.get_xdata()) > 50]
            assert len(curves) >= 3


def test_names_stand_beside_their_own_curves():
    """At the right edge of the load over the gap the hot curve's name stood beside the cold curve."""
    from babbitt.kinds.footstep.report import figures as heel_figures

    case = solve(parse_case(TEXT)).problems[1]
    with heel_figures.style():
        panel = heel_figures._over_gap(case).axes[heel_figures.OVER_GAP.index("load")]
    low, high = panel.get_ylim()
    levels = {text.get_text(): text.xy[1] for text in panel.texts}
    ends = {"cold": 0.9359, "hot": 0.8894, "smooth": 0.8893}
    for name, level in levels.items():
        distances = {other: abs(level - value) for other, value in ends.items()}
        assert distances[name] <= min(distances.values()) + 0.01 * (high - low)


@pytest.mark.parametrize("values", [[0.0, 0.1, 5.0], [1.0, 1.0, 1.0], [0.0, 0.9, 1.0, 1.1, 9.0], [3.0]])
def test_levels_keep_their_distance_and_their_mean(values):
    from babbitt.report.drawing import spread_levels

    levels = spread_levels(values, 1.0)
    assert all(late - early >= 1.0 - 1e-12 for early, late in itertools.pairwise(levels))
    assert sum(levels) == pytest.approx(sum(values))  # nothing is pushed up or down as a whole
    far = [0.0, 10.0, 20.0]
    assert spread_levels(far, 1.0) == far


def test_the_report_is_typeset(machine):
    from babbitt.report.document import report

    assert report(machine, "pdf")[:4] == b"%PDF"
    page = report(machine, "html").decode()
    assert "Screw groove" in page
    assert "not stable" in page


def lines(machine):
    from babbitt.kinds.footstep.report.calculation import heel_calculation

    for case, result in zip(machine.problems, machine.results, strict=True):
        for section in heel_calculation(case, result):
            for line in section.lines:
                yield result.name, line


def test_every_formula_gives_the_result(machine):
    from babbitt.report.expression import value

    found = [(name, line) for name, line in lines(machine) if line.expression]
    assert len(found) > 45
    for name, line in found:
        assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=1e-8), (name, line.name)


def test_printed_numbers_give_the_printed_result(machine):
    from babbitt.report.expression import value
    from babbitt.report.vocabulary import VOCABULARY

    for name, line in lines(machine):
        if line.expression:
            digits = {other: max(line.digits, VOCABULARY[other].digits) for other in line.numbers}
            printed = {other: float(f"{n:.{digits[other]}g}") for other, n in line.numbers.items()}
            assert value(line.expression, printed) == pytest.approx(line.value, rel=5e-4), (name, line.name)


def test_the_map_shows_where_no_state_exists(tmp_path):
    text = TEXT.replace(
        "\nspeed:", "\nfigures: {map_points: 8, clearance_from: 8 um, clearance_to: 30 um}\nspeed:"
    )
    machine = solve(parse_case(text))
    assert [path.name[3:] for path in write_plots(machine, tmp_path)][-1] == "state-map.svg"
    from babbitt.kinds.footstep.report import figures as heel_figures

    with heel_figures.style():
        figure = heel_figures._map(machine.problems[1])
    hatched = [part for part in figure.axes[0].collections if getattr(part, "hatches", None)]
    assert hatched
