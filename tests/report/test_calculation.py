"""The calculation on paper: what is printed gives, worked out again, what the result says."""

from __future__ import annotations

import math
from dataclasses import replace

import gear_cases
import pytest

from babbitt.core.limited_flow import is_limited, limited
from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.iso7902.model import DesignCase, PrescribedLoad
from babbitt.kinds.journal.iso7902.procedure import check
from babbitt.kinds.journal.report.calculation import calculation
from babbitt.report.expression import number_node, text, tree, value
from babbitt.report.vocabulary import VOCABULARY

CASES = gear_cases.varied_cases()


def lines_of(case: DesignCase):
    return [line for section in calculation(case, check(case)) for line in section.lines]


@pytest.mark.parametrize("name", CASES)
def test_every_formula_gives_the_result_of_the_procedure(name):
    lines = lines_of(CASES[name])
    assert len([line for line in lines if line.expression]) > 15
    for line in lines:
        if line.expression:
            assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=1e-9), line.name


@pytest.mark.parametrize("name", CASES)
def test_the_printed_numbers_give_the_printed_result(name):
    for line in lines_of(CASES[name]):
        if line.expression:
            digits = {other: max(line.digits, VOCABULARY[other].digits) for other in line.numbers}
            printed = {other: float(f"{n:.{digits[other]}g}") for other, n in line.numbers.items()}
            assert value(line.expression, printed) == pytest.approx(line.value, rel=5e-4), line.name


def test_the_order_is_that_of_the_standard():
    case = CASES["losses"]
    titles = [section.title for section in calculation(case, check(case))]
    assert titles == [
        "Operating clearance",
        "Load and speed",
        "Oil at the effective temperature",
        "Validity: laminar film",
        "Load number and position of the journal",
        "Friction",
        "Oil flow",
        "Heat balance",
        "Supply capacity",
        "The film with the flow that the supply delivers",
        "Permissible values",
        "Screening for whirl and clearance",
        "Pressure losses in the supply",
    ]


def test_a_prescribed_temperature_leaves_the_heat_balance_out():
    case = replace(CASES["losses"], effective_temperature=330.0)
    titles = [section.title for section in calculation(case, check(case))]
    assert "Heat balance" not in titles
    assert "Oil flow" in titles
    told = {name for line in lines_of(case) for name in (line.name, *line.numbers)}
    assert "friction_power" in told
    assert not told & {"outlet_temperature", "heat_to_oil"}


def test_the_film_that_the_limits_are_held_against_can_be_followed():
    """Every reading of the film with limited flow that a check holds has a line."""
    case = CASES["losses"]
    result = check(case)
    held = {check.quantity for check in result.limits if is_limited(check.quantity)}
    read = ("film_reynolds_number", "maximum_pressure", "minimum_film_thickness", "outlet_temperature")
    assert held == set(map(limited, read))
    assert held <= {line.name for line in lines_of(case)}
    bounded = replace(case, limits=replace(case.limits, transition_film_thickness=8e-6))
    steps = {line.name: line for line in lines_of(bounded)}
    for name in ("friction_coefficient", "total_flow", "transition_speed"):
        line = steps[f"starved_{name}"]
        assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=1e-9), name


def test_a_line_reads_formula_numbers_result_unit():
    line = next(line for line in lines_of(CASES["full"]) if line.name == "minimum_film_thickness")
    assert text(line.symbol) == "h_min"
    assert text(line.formula) == "(ψ_eff D)/(2) (1 − ε)"
    assert text(line.substituted) == "(1.6254e−3 × 0.12)/(2) × (1 − 0.88028)"
    (si, metre), (shown, micrometre) = line.results
    assert (text(si), metre) == ("1.1675e−5", "m")
    assert (text(shown), micrometre) == ("11.68", "µm")


def test_all_results_are_finite_and_named():
    for case in CASES.values():
        for line in lines_of(case):
            assert math.isfinite(line.value)
            assert line.meaning


def test_an_unsolved_bearing_has_nothing_to_follow():
    case = gear_cases.EXAMPLE
    overloaded = DesignCase(
        "too much", case.bearing, PrescribedLoad(9e7), case.journal_speed, case.lubricant, case.oil_supply
    )
    assert calculation(overloaded, check(overloaded)) == ()


@pytest.mark.parametrize(
    ("number", "printed"),
    [
        (0.0, "0"),
        (46500.0, "46500"),
        (46_500_000.0, "4.65e7"),
        (0.25, "0.25"),
        (-0.63, "−0.63"),
        (9.99999e-3, "0.01"),
        (1.5796e-3, "1.5796e−3"),
        (999999.9, "1e6"),
        (99999.96, "100000"),
    ],
)
def test_numbers_are_written_with_five_digits(number, printed):
    assert text(number_node(number)) == printed


@pytest.mark.parametrize(
    ("expression", "printed"),
    [
        ("a - (b - c)", "a − (b − c)"),
        ("a - (b + c) * a", "a − (b + c) a"),
        ("(a * b)**2", "(a b)^2"),
        ("a**(1 / 4)", "a^1/4"),
        ("a / (b / c)", "(a)/((b)/(c))"),
        ("-(a + b)", "−(a + b)"),
        ("sqrt(a + b) * c", "sqrt(a + b) c"),
        ("a * 2", "a × 2"),
    ],
)
def test_brackets_stand_where_the_order_needs_them(expression, printed):
    shown = text(tree(expression, lambda name: ["sym", name, "", "", False]))
    assert shown.replace(" − ", "−").lstrip() == printed.replace(" − ", "−")


def test_a_number_that_needs_brackets_has_them():
    shown = tree("a**2 + b", lambda name: number_node({"a": 1.5e-5, "b": -2.0}[name]))
    assert text(shown) == "(1.5e−5)^2 + (−2)"


def test_what_is_no_formula_is_refused():
    for hostile in ("__import__('os')", "a.b", "[1]", "lambda: 1"):
        with pytest.raises((ValueError, KeyError)):
            value(hostile, {"a": 1.0})


def test_what_occurs_on_the_way_takes_no_name_from_the_results():
    assert all(VOCABULARY[name] is quantity for name, quantity in QUANTITIES.items())
