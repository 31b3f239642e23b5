"""The calculation of a thrust bearing, line by line, against its result and by hand."""

import math

import pytest

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.report_level import Level
from babbitt.report.content import content
from babbitt.report.expression import value
from babbitt.report.view import view_of
from babbitt.report.vocabulary import VOCABULARY, calculated
from babbitt.solving import solve

THRUST = template("thrust").replace("number: 8", "number: 4").replace("load: 500 kN", "load: 250 kN")
OIL = THRUST[THRUST.index("lubricant:") : THRUST.index("ring_stiffness:")]
EVEN = THRUST.replace(THRUST[THRUST.index("tilt:") : THRUST.index("materials:")], "")
CASES = {
    "leaning, heat balance of every pad": THRUST,
    "even": EVEN,
    "backward": EVEN.replace("speed: 125 rpm", "speed: -125 rpm").replace("fraction: 0.6", "fraction: 0.4"),
    "adiabatic": EVEN + "\nthermal: adiabatic\n",
    "given viscosity": THRUST.replace(OIL, "oil: {kind: viscosity, viscosity: 45 mPa s}\n"),
    "given temperature": EVEN.replace(
        OIL, "lubricant: ISO VG 100\noil: {kind: temperature, temperature: 60 degC}\n"
    ),
}


@pytest.fixture(scope="module", params=CASES)
def solution(request):
    (found,) = solve(parse_case(CASES[request.param])).solutions
    assert found.result.outcome.solved
    return found


def lines(solution):
    return [line for section in view_of(solution.result).sections(solution) for line in section.lines]


def test_every_formula_gives_the_result(solution):
    followed = [line for line in lines(solution) if line.expression]
    assert len(followed) >= 9
    for line in followed:
        assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=1e-6, abs=1e-12), line.name


def test_printed_numbers_give_the_printed_result(solution):
    for line in lines(solution):
        if line.expression:
            digits = {other: max(line.digits, VOCABULARY[other].digits) for other in line.numbers}
            printed = {other: float(f"{n:.{digits[other]}g}") for other, n in line.numbers.items()}
            assert value(line.expression, printed) == pytest.approx(line.value, rel=1e-3, abs=1e-9), line.name


def test_lines_have_the_numbers_of_the_table(solution):
    found, values = {line.name: line.value for line in lines(solution)}, solution.result.values
    shared = found.keys() & values.keys()
    assert shared >= {"specific_load", "surface_speed", "friction_power", "pivot_film_thickness", "side_flow"}
    for name in shared:
        assert found[name] == pytest.approx(calculated(VOCABULARY[name], values[name]), rel=1e-12), name


def test_a_heat_balance_is_followed_where_there_is_one(solution):
    found = {line.name: line for line in lines(solution)}
    balanced = "outlet_temperature" in solution.result.values
    assert balanced == ("outlet_temperature" in found)
    own = solution.problem.oil.own_temperatures
    assert ("pad_warming" in found) == (balanced and not own)
    if balanced and not own:
        pad = found["this_temperature"].value
        oil = solution.problem.lubricant.dynamic_viscosity(pad + 273.15)
        assert found["this_viscosity"].value == pytest.approx(oil, rel=1e-5)


def test_the_geometry_by_hand():
    (solution,) = solve(parse_case(EVEN)).solutions
    found, pad = {line.name: line.value for line in lines(solution)}, solution.problem.bearing.pad
    assert found["mean_radius"] == pytest.approx(0.5 * (pad.inner_radius + pad.outer_radius))
    sector = pad.extent / (2.0 * math.pi) * math.pi * (pad.outer_radius**2 - pad.inner_radius**2)
    assert found["specific_load"] == pytest.approx(250e3 / (4.0 * sector))
    assert found["film_thickness_ratio"] < 1.0


def test_the_full_report_alone_has_the_calculation_in_the_words_of_thrust_bearings():
    machine = solve(parse_case(EVEN))
    (full,), (standard,) = (content(machine, level)["bearings"] for level in (Level.FULL, Level.STANDARD))
    assert standard["sections"] == []
    said = [line["meaning"] for section in full["sections"] for line in section["lines"]]
    assert "Surface speed of the collar at the mean radius" in said
    assert not [one for one in said if "journal" in one]


def test_a_shaft_line_has_the_calculation_of_its_thrust_bearing():
    case = template("thrust_line").replace("number: 21", "number: 4")
    (solution,) = solve(parse_case(case)).solutions
    found = lines(solution)
    assert {"mean_radius", "friction_power", "film_thickness_ratio"} <= {line.name for line in found}
    for line in found:
        if line.expression:
            assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=1e-6, abs=1e-12), (
                line.name
            )
