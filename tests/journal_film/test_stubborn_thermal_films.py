"""Bearings whose film, temperatures and journal answer each other with a swing: they rest all the same."""

import math
from dataclasses import replace

import pytest

from babbitt.case import case_from_dict, parse_case
from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.heat_balance import Equilibrium
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.model import Accuracy, FilmCase
from babbitt.kinds.journal.film.thermal_failure import thermal_failure, what_gave_way
from babbitt.kinds.journal.film.thermal_film import SAME_CLEARANCE, film_heat, thermal_operating_film
from babbitt.properties.fits import operating_relative_clearance
from babbitt.reynolds.heat.thermal_equilibrium import thermal_film_at
from babbitt.solving import solve


def bearing(heat, size, clearance, supplies, oil, supply, pressure, speed):
    """A case from its diameter and width in mm, oil grade, supply in °C and MPa, load in MPa, speed in rpm."""
    (case,) = parse_case(f"""
kind: journal
name: Stubborn
method: film
thermal: {heat}
diameter: {size[0]} mm
width: {size[1]} mm
clearance: {{kind: relative, mean: {clearance}}}
{supplies}
lubricant: ISO VG {oil}
supply: {{temperature: {supply[0]} degC, pressure: {supply[1]} MPa}}
materials: {{bearing: EN-GJL-250, journal: C45}}
specific_load: {pressure} MPa
speed: {speed} rpm
""").problems()
    assert isinstance(case, FilmCase)
    return case


HOLE = bearing("full", (65, 64), 1e-3, "holes: [{angle: 90 deg, diameter: 5.2 mm}]", 68, (36, 0.1), 10.4, 186)
CREEPING = bearing(
    "full", (95, 87), 0.75e-3, "grooves: [{angle: 96 deg, extent: 9 deg}]", 22, (59, 0.2), 0.53, 11.5
)
PUSHED = bearing(
    "full", (77, 60), 1.145e-3, "grooves: [{angle: 0 deg, extent: 25.3 deg}, {angle: 180 deg, extent: 20 deg}]",
    22, (54, 0.3), 0.05, 57,
)  # fmt: skip
HOT_INLET = bearing(
    "adiabatic", (396, 356), 0.76e-3,
    "pockets: [{angle: 0 deg, extent: 41.5 deg, width: 217 mm}, "
    "{angle: 180 deg, extent: 41.5 deg, width: 217 mm}]",
    100, (46.6, 0.1), 6.59, 39.2,
)  # fmt: skip
SPINNING = bearing(
    "adiabatic", (70, 50), 2.05e-3,
    "pockets: [{angle: 0 deg, extent: 42 deg, width: 33 mm}, {angle: 180 deg, extent: 42 deg, width: 33 mm}]",
    46, (50, 0.05), 0.05, 6353,
)  # fmt: skip
TILTED = bearing(
    "full", (138, 71), 3.24e-3,
    "pockets: [{angle: 0 deg, extent: 37 deg, width: 52 mm}, {angle: 180 deg, extent: 37 deg, width: 52 mm}]\n"
    "misalignment: {x: 0 mrad, y: 0.75 mrad}",
    100, (31.9, 0.3), 11.6, -6646,
)  # fmt: skip


LOBES = bearing(
    "adiabatic", (219.4, 183.4), 1.205e-3,
    "grooves: [{angle: 0 deg, extent: 16.1 deg}, {angle: 180 deg, extent: 20 deg}]\n"
    "bore: {kind: lobes, preload: 0.55}",
    46, (33.5, 0.1), 3.31, -29.95,
)  # fmt: skip
STREAMERS = bearing(
    "adiabatic", (36.4, 29.6), 3e-3, "holes: [{angle: 90 deg, diameter: 2.9 mm}]", 220, (49.4, 0.1), 6.23, -14890
)


@pytest.mark.parametrize("case", [HOLE, CREEPING], ids=["hole", "creeping"])
def test_a_film_that_conducts_more_than_its_oil_carries_ties_journal_to_bush(case):
    """What the bush gives the journal at one place it takes back at another: its temperature lies between."""
    found = thermal_operating_film(case)
    assert found.outcome.solved
    thermal = found.film.thermal
    assert thermal.heat.balance_error < 1e-7
    assert abs(thermal.heat.journal) < 1e-6 * thermal.heat.dissipation  # nothing takes heat from the shaft
    assert thermal.bush_temperature.min() < thermal.journal_temperature < thermal.bush_temperature.max()
    assert found.film.load == pytest.approx(case.duty.load, rel=1e-8)


def test_a_creeping_film_is_as_warm_as_its_walls_and_thicker_than_with_the_oil_of_the_supply():
    """Friction is next to nothing: the bush loses the heat of the supply to the air, and cool oil carries more."""
    found, fresh = thermal_operating_film(CREEPING).film, operating_film(replace(CREEPING, heat=None)).film
    assert found.thermal.journal_temperature < CREEPING.oil_supply.temperature
    assert found.temperature < fresh.temperature
    assert found.solution.minimum_film_thickness > 1.05 * fresh.solution.minimum_film_thickness


def test_a_journal_pushed_by_its_supplies_rests_where_the_film_of_one_temperature_holds_it():
    """The oil warms by tenths of a kelvin: the place is that of one temperature."""
    found, plain = thermal_operating_film(PUSHED).film, operating_film(replace(PUSHED, heat=None)).film
    same = replace(PUSHED, heat=None, effective_temperature=found.temperature)
    alike = operating_film(same).film
    assert found.thermal.maximum_temperature - PUSHED.oil_supply.temperature < 1.0
    here, there = found.solution.position / found.solution.film.clearance, alike.solution.position
    assert here == pytest.approx(there / alike.solution.film.clearance, abs=0.02)
    assert found.friction_power == pytest.approx(alike.friction_power, rel=0.05)
    assert plain.solution.outcome.solved


def test_hot_oil_that_flows_back_before_the_inlet_comes_to_rest():
    """A little less load is found the ordinary way; film and temperature go on from there without a jump."""
    assert isinstance(HOT_INLET.duty, PrescribedLoad)
    found = thermal_operating_film(HOT_INLET)
    lighter = thermal_operating_film(replace(HOT_INLET, duty=PrescribedLoad(0.93 * HOT_INLET.duty.load)))
    assert found.outcome.solved
    assert lighter.outcome.solved
    assert found.film.thermal.heat.balance_error < 1e-7
    assert found.film.load == pytest.approx(HOT_INLET.duty.load, rel=1e-8)
    hotter = found.film.thermal.maximum_temperature - lighter.film.thermal.maximum_temperature
    assert 5.0 < hotter < 25.0
    thinner = found.film.solution.minimum_film_thickness / lighter.film.solution.minimum_film_thickness
    assert 0.7 < thinner < 0.95


def test_a_prescribed_place_carries_the_load_that_rests_there():
    """As nearly as lines that stand evenly, whatever the place, see a film this thin."""
    found = thermal_operating_film(HOT_INLET).film
    x, y = found.solution.position
    heat = film_heat(HOT_INLET, found.volumetric_heat_capacity, found.temperature)
    held = thermal_film_at(found.thermal.film.film, heat, (float(x), float(y)))
    assert held.film.outcome.solved
    assert held.maximum_temperature == pytest.approx(found.thermal.maximum_temperature, abs=6.0)
    assert held.film.load == pytest.approx(found.load, rel=0.03)


def test_a_clearance_settles_on_lines_that_stay():
    """Oil that goes round many times: the grown clearance belongs to the temperatures, to the digits asked for."""
    found = thermal_operating_film(SPINNING)
    assert found.outcome.solved
    metal, state = SPINNING.bearing, found.film
    assert state.relative_clearance != pytest.approx(metal.relative_clearance, rel=100.0 * SAME_CLEARANCE)
    grown = operating_relative_clearance(
        metal.relative_clearance, metal.expansion_bearing, metal.expansion_journal,
        state.thermal.mean_bush_temperature, state.thermal.journal_temperature,
    )  # fmt: skip
    assert grown == pytest.approx(state.relative_clearance, rel=SAME_CLEARANCE)
    assert state.thermal.heat.balance_error < 1e-7


@pytest.mark.parametrize("case", [LOBES, STREAMERS], ids=["lobes", "streamers"])
def test_oil_in_two_patterns_and_streamers_that_flicker_leave_a_film_at_rest(case):
    """Heat closes where two lands make oil go round in two patterns, and the few streamers behind a hole hold
    up nothing."""
    found = thermal_operating_film(case)
    assert found.outcome.solved
    assert found.film.thermal.heat.balance_error < 1e-7
    assert found.film.load == pytest.approx(case.duty.load, rel=1e-8)
    lighter = thermal_operating_film(replace(case, duty=PrescribedLoad(0.97 * case.duty.load)))
    assert lighter.outcome.solved
    hotter = found.film.thermal.maximum_temperature / lighter.film.thermal.maximum_temperature
    assert 1.001 < hotter < 1.06


def test_a_tilted_journal_that_touches_is_overloaded_and_no_runaway():
    """The last film is far from hot, and under less load it is hardly cooler: it is the edge that gives way."""
    found = thermal_operating_film(TILTED)
    assert found.outcome is Outcome.OVERLOADED
    hottest = found.film.thermal.maximum_temperature
    assert hottest < 450.0
    assert 0.4 * TILTED.duty.load < found.film.load < 0.8 * TILTED.duty.load
    again = thermal_operating_film(replace(TILTED, duty=PrescribedLoad(0.9 * found.film.load)))
    assert again.outcome.solved
    assert again.film.thermal.maximum_temperature < hottest + 5.0
    said = thermal_failure(TILTED, found).message
    assert "its thinnest place closes" in said
    assert "The largest load with a film was about" in said
    assert "less load" in said


def test_what_gave_way_is_heat_only_where_the_last_film_is_hot():
    last = thermal_operating_film(HOLE).film
    assert what_gave_way(HOLE, Outcome.THERMAL_RUNAWAY, last) is Outcome.OVERLOADED
    glowing = replace(last, thermal=replace(last.thermal, temperature=last.thermal.temperature + 200.0))
    assert what_gave_way(HOLE, Outcome.THERMAL_RUNAWAY, glowing) is Outcome.THERMAL_RUNAWAY
    for kept in (Outcome.OVERLOADED, Outcome.NOT_CONVERGED, Outcome.NO_CLEARANCE):
        assert what_gave_way(HOLE, kept, last) is kept
    assert what_gave_way(HOLE, Outcome.THERMAL_RUNAWAY, None) is Outcome.THERMAL_RUNAWAY


def test_a_search_without_an_answer_tells_the_last_film_and_what_to_try():
    last = thermal_operating_film(replace(HOLE, duty=PrescribedLoad(0.5 * HOLE.duty.load))).film
    said = thermal_failure(HOLE, Equilibrium(Outcome.NOT_CONVERGED, last, 0, last.temperature)).message
    assert "did not converge together" in said
    assert f"The largest load with a film was about {0.5e-3 * HOLE.duty.load:.2f} kN" in said
    assert f"h_min = {1e6 * last.solution.minimum_film_thickness:.1f} µm" in said
    assert "Try: less load" in said
    assert math.isfinite(last.thermal.maximum_temperature)


def test_less_load_is_no_remedy_where_the_film_carries_all_of_it():
    last = thermal_operating_film(HOLE).film
    said = thermal_failure(HOLE, Equilibrium(Outcome.NOT_CONVERGED, last, 25, last.temperature)).message
    assert "less load" not in said
    assert "Try: another `accuracy`" in said


JUMPING = replace(
    bearing(
        "full", (120, 80), 1.4e-3,
        "pockets: [{angle: 0 deg, extent: 30 deg, width: 56 mm}, {angle: 180 deg, extent: 30 deg, width: 56 mm}]",
        46, (45, 0.2), 20e3 / (120 * 80), 3000,
    ),
    load_angle=math.radians(-45.0),
)  # fmt: skip


@pytest.mark.parametrize("accuracy", [Accuracy.DRAFT, Accuracy.ENGINEERING])
def test_a_clearance_at_which_the_film_jumps_is_found(accuracy):
    """It ended as not converged, with the load carried; a degree to either side its film is found."""
    case = replace(JUMPING, accuracy=accuracy)
    thin = {}
    for aside in (-1.0, 0.0, 1.0):
        found = thermal_operating_film(replace(case, load_angle=math.radians(-45.0 + aside)))
        assert found.outcome.solved
        assert found.film.load == pytest.approx(20e3, rel=1e-4)
        thin[aside] = found.film.solution.minimum_film_thickness
    assert thin[-1.0] > thin[0.0] > thin[1.0]
    assert thin[0.0] == pytest.approx(0.5 * (thin[-1.0] + thin[1.0]), rel=0.02)


@pytest.mark.parametrize("speed", ["-820.89 rpm", "-85.96340 rad/s"])
def test_a_load_into_a_groove_ends_alike_in_every_unit(speed):
    """The last film is nearly as thick as the clearance: nothing has closed, and round-off decides nothing."""
    (result,) = solve(
        case_from_dict(
            {
                "kind": "journal", "name": "Into its groove",
                "method": "film", "accuracy": "draft", "thermal": "full",
                "diameter": "148.65 mm", "width": "85.632 mm", "load": "41.204 kN", "load_angle": "-167.52 deg",
                "clearance": {"kind": "relative", "mean": "1.785 permille"}, "lubricant": "ISO VG 46",
                "supply": {"temperature": "52.4 degC", "pressure": "0.24 MPa"}, "speed": speed,
                "materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"},
                "grooves": [{"angle": "-163.06 deg", "extent": "28.65 deg"}],
                "walls": {
                    "bush": {"outer_diameter": "185.81 mm", "conductivity": "46 W/(m K)"},
                    "housing": {
                        "outer_diameter": "278.72 mm", "ambient_temperature": "25 degC",
                        "heat_transfer_coefficient": "20 W/(m2 K)",
                    },
                },
            }
        )
    ).results  # fmt: skip
    assert result.outcome is Outcome.NOT_CONVERGED
