"""Temperature in the film: closed forms, balances, symmetries and limits."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.heat.heat_model import (
    BushRing,
    ConductingWalls,
    FilmHeat,
    HeatGrid,
    JournalHeat,
    mean_over_layers,
)
from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal, thermal_film_at
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Pocket, Resolution, grooved_bore
from babbitt.reynolds.oil.piezoviscosity import Barus
from babbitt.reynolds.oil.turbulence import NG_PAN, FilmTurbulence

COLD = 323.15


def iso_vg_32(temperature):
    """A Vogel law through 0.0275 Pa s at 40 degC and 0.0046 Pa s at 100 degC."""
    return 4.0e-5 * np.exp(1000.0 / (np.asarray(temperature) - 160.02))


BEARING = JournalFilm(0.4, 0.263, 195e-6, float(iso_vg_32(COLD)), 94.2478, grooved_bore((0.0, math.pi), 0.07))
WEIGHT = (0.0, -112.8e3)
WALLS = ConductingWalls(BushRing((0.2, 0.23, 0.3), (50.0, 45.0), 50.0, 293.15), JournalHeat())
ADIABATIC = FilmHeat(iso_vg_32, 1.72e6, 0.13, COLD)
FULL = replace(ADIABATIC, walls=WALLS)
RESOLVED = HeatGrid(resolved=True)
POCKETS = replace(
    BEARING, lands=(Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC,
    pockets=(Pocket(0.0, 0.35, 0.2, pressure=5e4), Pocket(math.pi, 0.35, 0.2, pressure=5e4)),
)  # fmt: skip


@pytest.mark.parametrize(
    ("film", "heat"),
    [
        (BEARING, ADIABATIC),
        (BEARING, FULL),
        (BEARING, replace(FULL, grid=RESOLVED)),
        (POCKETS, ADIABATIC),
        (POCKETS, FULL),
        (replace(BEARING, misalignment=(2e-4, 1e-4)), FULL),
        (replace(BEARING, lands=grooved_bore((0.0, math.pi), 0.2, 2e5)), FULL),
    ],
    ids=["adiabatic", "full", "resolved", "pockets", "pockets-full", "tilted", "pressure"],
)
def test_mass_and_energy_are_conserved(film, heat):
    found = solve_thermal_journal(film, heat, WEIGHT)
    assert found.film.outcome.solved
    assert found.film.mass_balance_error < 1e-10
    assert found.heat.balance_error < 1e-8
    assert found.film.force == pytest.approx((0.0, 112.8e3), abs=112.8e3 * 1e-8)


@pytest.mark.parametrize("layers", [4, 8, 13])
def test_mean_over_the_gap_weighs_the_layers(layers):
    thick = HeatGrid(layers=layers).thicknesses()
    edges = np.concatenate(([0.0], np.cumsum(thick)))
    middle = 0.5 * (edges[1:] + edges[:-1])
    for k in range(layers):
        assert mean_over_layers(np.eye(layers)[k], middle) == pytest.approx(thick[k], abs=1e-12)


def test_friction_power_is_what_is_dissipated_where_nothing_is_pumped():
    found = solve_thermal_journal(BEARING, FULL, WEIGHT)
    power = found.film.friction_torque * BEARING.angular_speed
    assert found.heat.dissipation == pytest.approx(power, rel=1e-12)


def test_dissipation_is_friction_power_and_pumping_power():
    pressure = 2e5
    film = replace(BEARING, lands=grooved_bore((0.0, math.pi), 0.2, pressure))
    found = thermal_film_at(film, ADIABATIC, (3e-5, -9e-5))
    friction = found.film.friction_torque * film.angular_speed
    # the edges of the grooves fall to ambient pressure over their dams: a little less than p Q
    assert friction < found.heat.dissipation < friction + pressure * found.film.supply_flow.sum()


def test_a_concentric_film_between_walls_is_the_couette_flow_with_dissipation():
    """T = T_b + (T_j - T_b) eta + mu U^2/(2 k) eta (1 - eta) with one viscosity and the walls held."""
    ring = JournalFilm(0.1, 0.05, 50e-6, 0.02, 300.0, (Land(0.0, 2.0 * math.pi),),
                       cavitation=Cavitation.REYNOLDS, film_start=FilmStart.PERIODIC)  # fmt: skip
    held = ConductingWalls(BushRing((0.05, 0.0500001), (1e9,), 1e9, 330.0), JournalHeat(temperature=340.0))
    errors = []
    for layers in (8, 16):
        heat = FilmHeat(lambda t: 0.02 + 0.0 * t, 1.7e6, 0.13, 300.0, held, HeatGrid(layers))
        found = thermal_film_at(ring, heat, (0.0, 0.0))
        eta = found.layers
        closed = 330.0 + 10.0 * eta + 0.02 * 15.0**2 / (2.0 * 0.13) * eta * (1.0 - eta)
        errors.append(np.abs(found.temperature - closed).max())
    assert errors[0] < 0.15
    assert errors[1] < 0.3 * errors[0]  # second order across the gap
    assert found.heat.dissipation == pytest.approx(0.02 * 15.0**2 / 50e-6 * math.pi * 0.1 * 0.05, rel=1e-9)


def test_an_adiabatic_film_of_one_viscosity_warms_its_oil_by_friction_over_flow():
    heat = replace(ADIABATIC, viscosity=lambda t: BEARING.viscosity + 0.0 * t)
    found = solve_thermal_journal(BEARING, heat, WEIGHT)
    plain = solve_journal(replace(BEARING, axial_viscosity=(1.0, 1.0)), WEIGHT, Resolution(4, 48, 24, 1e-8))
    assert found.film.eccentricity_ratio == pytest.approx(plain.eccentricity_ratio, rel=2e-3)
    rise = found.film.friction_torque * BEARING.angular_speed / (1.72e6 * found.film.side_flow.sum())
    assert found.side_temperature - COLD == pytest.approx(rise, rel=0.02)


@pytest.mark.parametrize("speed", [94.2478, -94.2478])
def test_torque_on_the_bearing_of_one_viscosity_is_that_of_shear_and_pressure_on_its_bore(speed):
    film = replace(BEARING, angular_speed=speed)
    constant = replace(FULL, viscosity=lambda temperature: np.full_like(temperature, film.viscosity))
    warm = solve_thermal_journal(film, constant, WEIGHT, Resolution(4, 96, 24, 1e-3)).film
    bore = solve_journal(replace(film, axial_viscosity=(1.0, 1.0)), WEIGHT, Resolution(4, 96, 24, 1e-7))
    assert warm.bearing_torque == pytest.approx(bore.bearing_torque, rel=1e-3)
    assert warm.friction_torque == pytest.approx(bore.friction_torque, rel=1e-3)


@pytest.mark.parametrize("speed", [94.2478, -94.2478])
def test_torque_on_the_bore_of_a_lemon_is_that_of_its_shear_by_both_films(speed):
    """Its arcs have other centres than the bearing: the couple of load and reaction is not all that differs."""
    clearance = BEARING.clearance
    arcs = ((0.035, math.pi - 0.035, -clearance), (math.pi + 0.035, 2.0 * math.pi - 0.035, clearance))
    lands = tuple(Land(a, b, clearance=2.0 * clearance, centre=(0.0, y)) for a, b, y in arcs)
    film, grid = replace(BEARING, angular_speed=speed, lands=lands), Resolution(4, 96, 24, 1e-3)
    constant = replace(ADIABATIC, viscosity=lambda temperature: np.full_like(temperature, film.viscosity))
    warm = solve_thermal_journal(film, constant, WEIGHT, grid).film
    bore = film_at_position(replace(film, axial_viscosity=(1.0, 1.0)), tuple(warm.position), resolution=grid)
    assert warm.friction_torque == pytest.approx(bore.friction_torque, rel=1e-3)
    assert warm.bearing_torque == pytest.approx(bore.bearing_torque, rel=1e-3)
    whole = bore.friction_torque - 2.0 * bore.pressure_torque
    assert abs(bore.bearing_torque / whole - 1.0) > 0.005


def test_reversal_mirrors_the_temperatures():
    here = solve_thermal_journal(BEARING, FULL, (20e3, -100e3))
    there = solve_thermal_journal(replace(BEARING, angular_speed=-BEARING.angular_speed), FULL, (20e3, 100e3))
    assert there.film.position == pytest.approx(here.film.position * (1.0, -1.0), rel=1e-9)
    assert there.maximum_temperature == pytest.approx(here.maximum_temperature, abs=1e-7)
    assert there.hot_spot[0] % (2 * math.pi) == pytest.approx(-here.hot_spot[0] % (2 * math.pi))


def test_turning_everything_turns_the_answer():
    by = 0.7
    turned = replace(BEARING, lands=grooved_bore((by, math.pi + by), 0.07))
    load = 112.8e3
    here = solve_thermal_journal(BEARING, FULL, WEIGHT)
    there = solve_thermal_journal(turned, FULL, (load * math.sin(by), -load * math.cos(by)))
    assert there.maximum_temperature == pytest.approx(here.maximum_temperature, abs=1e-4)
    assert there.film.minimum_film_thickness == pytest.approx(here.film.minimum_film_thickness, rel=1e-6)


def test_walls_that_conduct_and_lose_heat_cool_the_film():
    adiabatic, full = (solve_thermal_journal(BEARING, heat, WEIGHT) for heat in (ADIABATIC, FULL))
    assert full.maximum_temperature < adiabatic.maximum_temperature
    assert full.heat.bush > 0.0
    assert abs(full.heat.journal) < 1e-6 * full.heat.dissipation  # nothing takes heat from the shaft


def test_a_bush_that_conducts_without_bound_has_one_temperature():
    copper = ConductingWalls(BushRing((0.2, 0.3), (1e7,), 50.0, 293.15), JournalHeat())
    found = solve_thermal_journal(BEARING, replace(ADIABATIC, walls=copper), WEIGHT)
    assert np.ptp(found.bush_temperature) < 0.01
    outside = 2.0 * math.pi * 0.3 * 0.263 * 50.0 * (found.bush_temperature.mean() - 293.15)
    assert found.heat.bush == pytest.approx(outside, rel=1e-3)


def test_an_insulated_bush_takes_no_heat_but_evens_it_out():
    walls = ConductingWalls(BushRing((0.2, 0.3), (50.0,), 0.0, 293.15), JournalHeat())
    found = solve_thermal_journal(BEARING, replace(ADIABATIC, walls=walls), WEIGHT)
    assert abs(found.heat.bush) < 1e-6 * found.heat.dissipation
    assert np.abs(found.bush_flux).max() > 100.0


def test_heat_lost_along_the_shaft_is_what_the_journal_takes():
    shaft = JournalHeat(shaft_conductance=30.0, ambient_temperature=303.15)
    found = solve_thermal_journal(BEARING, replace(FULL, walls=replace(WALLS, journal=shaft)), WEIGHT)
    assert found.heat.journal == pytest.approx(30.0 * (found.journal_temperature - 303.15), rel=1e-6)


@pytest.mark.parametrize("heat", [ADIABATIC, FULL], ids=["adiabatic", "full"])
def test_the_default_grid_is_close_to_a_fine_one(heat):
    """1 % of the film thickness and 1 K are wanted; along the film the temperature moves less than 0.2 K."""
    usual = solve_thermal_journal(BEARING, heat, WEIGHT)
    along = Resolution(4, 192, 96, 1e-7)
    in_layers = solve_thermal_journal(BEARING, replace(heat, grid=HeatGrid(20)), WEIGHT, along)
    across = solve_thermal_journal(BEARING, heat, WEIGHT, Resolution(8, 192, 96, 1e-7))
    for fine in (in_layers, across):
        assert usual.film.minimum_film_thickness == pytest.approx(fine.film.minimum_film_thickness, rel=0.005)
        assert usual.maximum_temperature == pytest.approx(fine.maximum_temperature, abs=0.2)
    plain = solve_thermal_journal(BEARING, heat, WEIGHT, along)
    assert usual.maximum_temperature == pytest.approx(plain.maximum_temperature, abs=0.2)


def test_temperature_converges_with_the_first_power_of_the_step():
    at, heat = (4e-5, -1.1e-4), replace(FULL, grid=HeatGrid(10))
    values = [
        thermal_film_at(BEARING, heat, at, Resolution(4, n, n // 2, 1e-8)).side_temperature for n in (32, 64, 128)
    ]
    assert 1.5 < (values[1] - values[0]) / (values[2] - values[1]) < 4.5


@pytest.mark.parametrize(
    ("film", "heat"),
    [
        (BEARING, ADIABATIC),
        (BEARING, FULL),
        (replace(BEARING, lands=grooved_bore((0.0, math.pi), 0.35, 3e5)), FULL),
    ],
    ids=["adiabatic", "full", "pressure"],
)
def test_the_hottest_place_converges_with_the_first_power_of_the_step(film, heat):
    values = [
        solve_thermal_journal(film, heat, WEIGHT, Resolution(4, n, n // 2, 1e-9)).maximum_temperature
        for n in (48, 96, 192)
    ]
    assert 1.4 < (values[1] - values[0]) / (values[2] - values[1]) < 2.6


def test_a_line_of_supply_of_no_width_at_the_widest_gap_changes_little():
    """One groove at the top, 0 and 2 degrees wide: the film between has the same temperatures."""
    results = []
    for extent in (0.0, math.radians(2.0)):
        film = replace(BEARING, lands=grooved_bore((math.pi / 2.0,), extent))
        results.append(solve_thermal_journal(film, ADIABATIC, WEIGHT))
    assert results[1].maximum_temperature == pytest.approx(results[0].maximum_temperature, abs=0.5)


def test_fresh_oil_in_place_of_hot_oil_cools_the_film_and_the_balance_still_closes():
    full, washed = (
        solve_thermal_journal(BEARING, replace(FULL, carry_over=share), WEIGHT) for share in (1.0, 0.5)
    )
    assert washed.maximum_temperature < full.maximum_temperature - 1.0
    assert washed.heat.balance_error < 1e-7


def test_turbulence_heats_more_and_still_closes_the_balance():
    fast = replace(BEARING, angular_speed=400.0, viscosity=float(iso_vg_32(COLD)))
    stirred = replace(fast, turbulence=FilmTurbulence(NG_PAN, 860.0, 200.0, 400.0))
    laminar, turbulent = (solve_thermal_journal(film, FULL, WEIGHT) for film in (fast, stirred))
    assert turbulent.film.outcome.solved
    assert turbulent.heat.balance_error < 1e-8
    assert turbulent.film.friction_torque > 1.1 * laminar.film.friction_torque


def test_the_unit_of_viscosity_changes_no_turbulent_film():
    """The Prandtl number that stirs the heat is that of the oil where it is, not of the unit."""
    law = FilmTurbulence(NG_PAN, 860.0, 100.0, 200.0)
    fast = replace(BEARING, clearance=2.0 * BEARING.clearance, angular_speed=400.0, turbulence=law)
    one, other = (
        solve_thermal_journal(replace(fast, viscosity=unit * fast.viscosity), FULL, WEIGHT) for unit in (1.0, 0.1)
    )
    assert other.film.minimum_film_thickness == pytest.approx(one.film.minimum_film_thickness, rel=2e-4)
    assert other.film.friction_torque == pytest.approx(one.film.friction_torque, rel=2e-4)
    assert other.temperature.max() == pytest.approx(one.temperature.max(), abs=0.05)


def test_a_turbulent_film_below_its_onset_is_the_laminar_one():
    far = replace(BEARING, turbulence=FilmTurbulence(NG_PAN, 860.0, 2e4, 4e4))
    laminar, asked = (solve_thermal_journal(film, FULL, WEIGHT) for film in (BEARING, far))
    assert asked.film.position == pytest.approx(laminar.film.position, rel=1e-6)
    assert asked.maximum_temperature == pytest.approx(laminar.maximum_temperature, abs=1e-3)


def test_a_film_that_makes_oil_is_refused():
    with pytest.raises(InputError, match="from nowhere"):
        solve_thermal_journal(replace(BEARING, cavitation=Cavitation.REYNOLDS), FULL, WEIGHT)


BACK = replace(BEARING, lands=grooved_bore((0.5 * math.pi, 4.2), 0.2, 1e5))  # the second groove carries load
TWINS = replace(POCKETS, pockets=(Pocket(0.0, 0.35, 0.06, 0.06, pressure=5e4),
                                  Pocket(0.0, 0.35, 0.06, -0.06, pressure=5e4),
                                  Pocket(math.pi, 0.35, 0.2, pressure=5e4)))  # fmt: skip


@pytest.mark.parametrize("share", [1.0, 0.5])
@pytest.mark.parametrize("film", [
    BEARING, POCKETS, TWINS, BACK, replace(BACK, angular_speed=-94.2478),
    replace(BEARING, lands=grooved_bore((0.5 * math.pi,), 0.2, 2e5)),
], ids=["dry", "pockets", "twins", "back", "reversed", "fed"])  # fmt: skip
def test_oil_takes_what_leaves_by_the_sides_and_what_goes_back_into_supplies(film, share):
    found = solve_thermal_journal(film, replace(ADIABATIC, carry_over=share), WEIGHT)
    assert found.fresh_flow - found.returned_flow == pytest.approx(found.film.supply_flow, abs=1e-12)
    assert (found.returned_flow >= 0.0).all()
    by_sides = 1.72e6 * (found.film.end_flows.sum() + found.film.side_inflow) * (found.side_temperature - COLD)
    assert by_sides + found.heat.returned == pytest.approx(found.heat.oil, rel=1e-10)
    assert (found.heat.returned > 0.0) == (found.returned_flow.sum() > 0.0)
    if film in (BACK, replace(BACK, angular_speed=-94.2478)):
        assert found.returned_flow[found.film.supply_flow < 0.0].sum() > 1e-5


def test_oil_that_goes_back_is_as_warm_as_its_groove():
    found = solve_thermal_journal(BACK, ADIABATIC, WEIGHT)
    (into,) = np.flatnonzero(found.film.supply_flow < 0.0)
    heat = 1.72e6 * found.returned_flow[into] * (found.groove_temperatures[into] - COLD)
    assert found.heat.returned == pytest.approx(heat, rel=1e-9)


def test_both_of_two_holes_alike_are_told_warm():
    found = solve_thermal_journal(TWINS, ADIABATIC, WEIGHT)
    assert found.groove_temperatures[0] == found.groove_temperatures[1] > COLD + 5.0


@pytest.mark.parametrize(
    ("film", "says"),
    [(replace(BEARING, angular_speed=0.0), "angular_speed is zero"),
     (replace(BEARING, pressure_viscosity=Barus(2e-8)), "pressure_viscosity")],
)  # fmt: skip
def test_films_without_an_answer_are_refused_under_a_load_and_at_a_position(film, says):
    with pytest.raises(InputError, match=says):
        solve_thermal_journal(film, FULL, WEIGHT)
    with pytest.raises(InputError, match=says):
        thermal_film_at(film, FULL, (3e-5, -9e-5))


def test_a_film_without_load_is_refused():
    with pytest.raises(InputError, match="without load"):
        solve_thermal_journal(BEARING, FULL, (0.0, -0.0))


def test_one_viscosity_is_its_own_effective_viscosity():
    """Friction of the flow by pressure, much of all under a high load, is no sign of thicker oil."""
    heat = replace(FULL, viscosity=lambda temperature: np.full_like(temperature, BEARING.viscosity))
    for load in (20e3, 300e3):
        found = solve_thermal_journal(BEARING, heat, (0.0, -load))
        assert found.effective_viscosity == pytest.approx(BEARING.viscosity, rel=1e-9)


def test_tilt_mirrored_across_the_middle_mirrors_a_turbulent_film():
    law = FilmTurbulence(NG_PAN, density=860.0, onset=600.0, end=1200.0)
    fast = replace(BEARING, angular_speed=600.0, turbulence=law)
    here, there = (
        solve_thermal_journal(replace(fast, misalignment=tilt), ADIABATIC, WEIGHT, Resolution(4, 48, 24, 1e-9))
        for tilt in ((4e-4, 3e-4), (-4e-4, -3e-4))
    )
    assert there.film.position == pytest.approx(here.film.position, rel=1e-6)
    assert there.maximum_temperature == pytest.approx(here.maximum_temperature, abs=1e-3)


def test_grooves_under_pressure_have_one_film_whatever_the_grid():
    """A line behind a fed groove that is dry once must not stay dry because it is."""
    fed = replace(BEARING, lands=grooved_bore((0.0, math.pi), 0.35, 3e5))
    found = [solve_thermal_journal(fed, FULL, (0.0, -30e3), Resolution(4, n, n // 2, 1e-6)) for n in (48, 96, 192)]
    flows = np.array([one.fresh_flow for one in found])
    assert np.abs(flows[1] / flows[2] - 1.0).max() < 0.04
    assert np.abs(flows[0] / flows[2] - 1.0).max() < 0.08
    assert abs(found[1].maximum_temperature - found[2].maximum_temperature) < 0.4
    assert abs(found[0].maximum_temperature - found[2].maximum_temperature) < 0.8


def test_a_full_film_whose_oil_does_not_conduct_is_the_adiabatic_one():
    tight = Resolution(4, 96, 24, 1e-8)
    poor = replace(ADIABATIC, conductivity=1e-7)
    adiabatic, full = (
        solve_thermal_journal(BEARING, one, WEIGHT, tight) for one in (poor, replace(poor, walls=WALLS))
    )
    assert full.heat.bush + abs(full.heat.journal) < 1e-4 * full.heat.dissipation
    assert full.film.position == pytest.approx(adiabatic.film.position, rel=1e-3)
    assert full.side_temperature == pytest.approx(adiabatic.side_temperature, abs=0.02)


def test_a_film_that_hardly_moves_is_as_warm_as_its_oil():
    slow = replace(BEARING, angular_speed=1e-3 * BEARING.angular_speed)
    found = solve_thermal_journal(slow, ADIABATIC, (0.0, -112.8))
    assert found.film.outcome.solved
    assert np.ptp(found.temperature) < 0.1
    with pytest.raises(InputError, match="angular_speed is zero"):
        solve_thermal_journal(replace(BEARING, angular_speed=0.0), ADIABATIC, WEIGHT)
