"""Tables for the terminal, read as the text that reaches the screen."""

from __future__ import annotations

import io
import re
from dataclasses import replace

import pytest
from rich.cells import cell_len
from rich.console import Console

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.report.machine_table import columns_of
from babbitt.report.table import console, print_machine


def shown(machine, width=140, **settings):
    screen = io.StringIO()
    print_machine(machine, Console(file=screen, width=width, highlight=False, **settings))
    return screen.getvalue()


def test_one_row_a_bearing_in_the_engineers_units(reverse_gear):
    text = shown(reverse_gear)
    row = next(line for line in text.splitlines() if line.startswith("Second-stage pinion (a)"))
    assert " ".join(row.split()) == (
        "Second-stage pinion (a) 2.51 24.00 1.080 50.0 → 88.0 0.710 47.0 / 16.0 28.30 8.5 4.0 226 / 1259 pass"
    )
    assert "all limits kept" in text


@pytest.mark.parametrize("width", [60, 80, 100, 120, 140, 200])
def test_no_line_exceeds_the_terminal_and_no_number_is_cut(reverse_gear, width):
    text = shown(reverse_gear, width)
    assert max(cell_len(line.rstrip()) for line in text.splitlines()) <= width
    assert "…" not in text
    for result in reverse_gear.results:
        film = f"{result.minimum_film_thickness * 1e6:.1f} / 16.0"
        assert film in text
    rows = [line for line in text.splitlines() if " / 16.0" in line]
    assert len(rows) == 11
    assert all(row.rstrip().endswith("pass") for row in rows)


def test_the_film_stays_when_columns_must_go_and_the_table_says_which_went(reverse_gear):
    text = shown(reverse_gear, 80)
    assert "h_min / h_lim" in text
    assert "Left out for want of width" in text
    left_out = text.split("Left out for want of width:")[1].split("\n\n")[0]
    assert "Re / Re_cr" in left_out
    assert "h_min" not in left_out
    assert "Left out" not in shown(reverse_gear, 200)


def test_a_long_name_wraps_and_keeps_the_columns(reverse_gear, good):
    long = replace(good, name="Bearing " * 12 + "W" * 60)
    text = shown(replace(reverse_gear, results=(long, good)), 140)
    assert "Re / Re_cr" in text
    assert text.replace("\n", "").count("W") >= 60


def test_the_verdict_reads_without_colour(reverse_gear, good, violated, unsolved):
    machine = replace(reverse_gear, results=(good, violated, unsolved))
    coloured = shown(machine, no_color=True, force_terminal=True)
    assert not re.search(r"\x1b\[[0-9;]*3[0-7]", coloured)
    text = re.sub(r"\x1b\[[0-9;]*m", "", coloured)
    rows = {line.split("  ")[0].strip(): line.rstrip().split("  ")[-1].strip() for line in text.splitlines()}
    assert rows[good.name] == "pass"
    assert rows["Thin film"] == "fail"
    assert rows["Overloaded"] == "no solution"


def test_an_unsolved_bearing_shows_no_operating_point(reverse_gear, good, unsolved):
    for results in ((good, unsolved), (unsolved,)):
        text = shown(replace(reverse_gear, results=results))
        assert "31.4" not in text
        assert "no film can carry this load" in text
        assert "Try: a wider or larger bearing" in text


def test_a_violated_limit_is_one_line_with_code_and_both_numbers(reverse_gear, good, violated):
    text = shown(replace(reverse_gear, results=(good, violated)))
    line = next(line for line in text.splitlines() if "C101" in line)
    assert "Thin film" in line
    assert "h_min = 12.0 µm < 16.0 µm" in line


def test_a_machine_shows_the_film_that_its_limits_are_held_against(reverse_gear, good):
    """ISO 7902 with all the oil that the film wants, and marked that with what the supply delivers."""
    assert "*" not in shown(replace(reverse_gear, results=(good, replace(good, name="other"))))
    checks = (
        Check("C101", "starved_minimum_film_thickness", 24.1e-6, 9e-6, Bound.AT_LEAST, "experience"),
        Check("C104", "starved_outlet_temperature", 350.15, 373.15, Bound.AT_MOST, "experience"),
    )
    values = {**good.values, **{check.quantity: check.value for check in checks}, "starved_friction_power": 21e3}
    short = replace(good, name="Short of oil", checks=checks, values=values)
    text = shown(replace(reverse_gear, results=(good, short)))
    lines = text.splitlines()
    full, lacking = (next(line for line in lines if line.startswith(name)) for name in (good.name, short.name))
    assert "24.1* / 9.0" in lacking
    assert "→ 77.0*" in lacking
    assert "21.00*" in lacking  # no limit of its own: of the film that the others are held against
    assert "*" not in full
    assert "* with the flow that the supply delivers: the limits are held against this film" in lines


def test_eleven_equal_misses_do_not_flood(reverse_gear):
    hot = Check("C103", "outlet_temperature", 390.0, 383.15, Bound.AT_MOST, "experience")
    results = tuple(replace(result, checks=(*result.checks, hot)) for result in reverse_gear.results)
    lines = [line for line in shown(replace(reverse_gear, results=results)).splitlines() if "C103" in line]
    assert len(lines) == 1
    assert "all 11 bearings" in lines[0]


def test_messages_of_one_code_stand_beside_the_bearings_that_they_are_of(reverse_gear):
    """Few are all told; of many one, with the bearing that it is of. An oil system counts as no bearing."""
    said = [Notice("W141", values={"side_inflow": litres / 6e4}) for litres in (1.0, 2.0, 3.0, 4.0)]
    warned = [replace(one, warnings=(notice,)) for one, notice in zip(reverse_gear.results, said, strict=False)]
    lines = [
        line for line in shown(replace(reverse_gear, results=tuple(warned[:3]))).splitlines() if "W141" in line
    ]
    assert [line.strip().split("[")[1] for line in lines] == [f"{one.name}]" for one in warned[:3]]
    whole = shown(replace(reverse_gear, results=(*warned, replace(warned[0], name="Oil system of gear"))), 300)
    (line,) = (line for line in whole.splitlines() if "W141" in line)
    assert f"{warned[0].name}, for example: " in line
    assert line.strip().endswith("[all 4 bearings; Oil system of gear]")


def test_a_missed_recommendation_is_listed_and_changes_no_verdict(reverse_gear, good):
    advice = Check("C109", "outlet_temperature", 350.0, 343.15, Bound.AT_MOST, "advice", advisory=True)
    advised = replace(good, checks=(*good.checks, advice))
    assert advised.verdict is good.verdict
    text = shown(replace(reverse_gear, results=(advised, good)))
    assert "Recommendations and screening indicators missed" in text
    assert "Limits violated" not in text


def test_a_critical_mass_of_zero_says_that_no_rotor_is_stable(reverse_gear, good):
    source = "rotor_mass of the case"
    whirls = Check("C115", "critical_mass", 0.0, 300.0, Bound.AT_LEAST, source)
    values = {**good.values, "critical_mass": 0.0}
    text = shown(replace(reverse_gear, results=(replace(good, values=values, checks=(whirls,)),)))
    # among the results, and as a limit violated
    assert text.count("rigid rotor whirls; 0: no rotor is stable") == 2
    held = replace(whirls, value=500.0)
    kept = replace(good, values={**values, "critical_mass": 500.0}, checks=(held,))
    assert "no rotor is stable" not in shown(replace(reverse_gear, results=(kept,)))


def test_one_bearing_is_written_in_full(reverse_gear, good):
    text = shown(replace(reverse_gear, results=(good,)))
    assert "Minimum film thickness" in text
    assert "h_min = 89.0 µm ≥ 16.0 µm" in text
    assert "wall" not in text.lower()


@pytest.mark.parametrize("name", ["[bold]loud[/bold]", "[/]", "a\x1b[2Jb", "x\u202ey", "[link=http://x]y"])
def test_a_name_is_shown_as_it_stands_and_moves_no_cursor(reverse_gear, good, name):
    for results in ((replace(good, name=name), good), (replace(good, name=name),)):
        text = shown(replace(reverse_gear, name=name, results=results), 200, force_terminal=True)
        assert "\x1b[2J" not in text
        assert "\x1b]8" not in text
        assert "\u202e" not in text
        visible = name.replace("\x1b", "").replace("\u202e", "")
        assert visible in text


def test_a_pipe_is_wide_enough_for_every_column(reverse_gear, monkeypatch, capsys):
    monkeypatch.delenv("COLUMNS", raising=False)
    print_machine(reverse_gear, console())
    text = capsys.readouterr().out
    assert all(column.heading in text for column in columns_of(reverse_gear.results))


def test_a_pipe_keeps_the_last_column_of_a_wide_table(reverse_gear, monkeypatch, capsys):
    monkeypatch.delenv("COLUMNS", raising=False)
    named = [replace(one, name=f"{one.name} [at its highest speed]") for one in reverse_gear.results]
    results = tuple(lacking(one, "C105", "C106", "C107") for one in named)
    print_machine(replace(reverse_gear, results=results))
    text = capsys.readouterr().out
    assert "not made" in text
    assert "Left out" not in text
    assert all(column.heading in text for column in columns_of(results))
    assert "Second-stage pinion (a) [at its highest speed]" in text


# -- what is not there ----------------------------------------------------------------------------------------


def lacking(result, *codes):
    return replace(result, not_checked=tuple(Notice(code, "no_metal") for code in codes))


def test_checks_that_could_not_be_made_are_told_once_with_their_codes(reverse_gear):
    results = tuple(lacking(result, "C105", "C106", "C107") for result in reverse_gear.results)
    text = " ".join(shown(replace(reverse_gear, results=results)).split())
    assert text.count("no bearing metal is given") == 1
    assert "C105, C106, C107" in text.split("Not checked")[1]
    assert "[all 11 bearings]" in text


def test_less_input_does_not_look_like_a_better_verdict(reverse_gear, good):
    incomplete = lacking(good, "C106", "C107")
    alone = shown(replace(reverse_gear, results=(incomplete,)))
    assert "2 checks not made" in alone.splitlines()[0]
    assert "all limits kept" not in alone
    row = next(
        line for line in shown(replace(reverse_gear, results=(incomplete, good))).splitlines() if " pass" in line
    )
    assert row.split()[-2:] == ["pass", "2"]


def test_where_everything_was_checked_nothing_is_said_of_it(reverse_gear):
    assert "not made" not in shown(reverse_gear)
    assert "Not checked" not in shown(reverse_gear)


@pytest.fixture
def self_cooled(good):
    """Cooled by its housing: no oil comes in and none goes out."""
    gone = ("supply_temperature", "outlet_temperature")
    values = {name: value for name, value in good.values.items() if name not in gone}
    temperatures = {"ambient_temperature": 293.15, "bearing_temperature": 329.55}
    return replace(good, name="Self-cooled", values={**values, **temperatures})


def test_a_bearing_temperature_never_stands_under_those_of_the_oil(reverse_gear, good, self_cooled):
    for results in ((self_cooled, good), (self_cooled, replace(self_cooled, name="b"))):
        columns = {column.heading: column.cells(results) for column in columns_of(results)}
        assert columns["T_B"][0] == "56.4"
        assert columns.get("T_en → T_ex", ["–"])[0] == "–"
        assert columns.get("Q_p", ["–"])[0] == "–"
    assert "T_en" not in shown(replace(reverse_gear, results=(self_cooled, replace(self_cooled, name="b"))))


def test_a_total_stands_below_a_machine_and_not_below_a_bearing(reverse_gear, good):
    assert "Total of 11 bearings: friction power P_f = 311.3 kW" in shown(reverse_gear)
    assert "Total" not in shown(replace(reverse_gear, results=(good,)))
