"""Heat of the long film: balances, reference numbers, published statements, limits and trends."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.kinds.journal.infinitely_long_bearing.mean_temperature import mean_temperature_film
from babbitt.kinds.journal.infinitely_long_bearing.model import (
    BushRing,
    Discretisation,
    ExchangeZone,
    HeatExchange,
    NusseltLaw,
)
from babbitt.kinds.journal.infinitely_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.properties.lubricants import LinearProperty
from babbitt.validation.published.long_film_bearing import conducting_bush_ratio, film, relative_load, solved
from babbitt.validation.published.long_film_table import root_mean_square

ZERO = 273.15
CONSISTENT, MEAN, LITERAL = Discretisation
NO_EXCHANGE = HeatExchange(NusseltLaw(0.0))
C = 56.33e-6


def exchanging(outer=0.1, conductivity=45.0, coefficient=200.0, shaft=0.2):
    return HeatExchange(
        bush=BushRing(outer, conductivity, coefficient), shaft_conductance=shaft, ambient_temperature=20.0 + ZERO
    )


def columns(state):
    t = state.temperatures
    return (
        relative_load(state),
        state.load / 1e3,
        math.degrees(state.attitude_angle),
        state.heat_source,
        state.flow * 1e6,
        state.rupture_temperature - ZERO,
        t.film[-1] - ZERO,
        t.film.max() - ZERO,
        t.journal - ZERO,
        state.film_pressure.max() / 1e6,
    )


# mode, Nusselt, eps, rpm: W_pr, W kN, attitude, P W, Q cm3/s, T_r, T_2pi, T_max, T_J, p_max MPa
REFERENCE = [
    (MEAN, 1.55, 0.3, 3000, 5.151, 10.22, 64.58, 330, 30.91, 76.50, 76.57, 76.61, 75.15, 1.530),
    (MEAN, 1.55, 0.8, 3000, 23.310, 27.05, 42.81, 460, 12.77, 94.44, 91.96, 94.57, 91.00, 6.392),
    (MEAN, 1.55, 0.8, 12000, 68.313, 81.02, 44.14, 5176, 61.35, 124.72, 120.58, 124.91, 112.24, 18.562),
    (CONSISTENT, 1.55, 0.3, 3000, 5.163, 10.50, 65.27, 312, 30.77, 76.19, 76.25, 76.28, 74.79, 1.568),
    (CONSISTENT, 1.55, 0.8, 3000, 22.013, 26.44, 44.88, 387, 9.32, 96.68, 95.27, 96.82, 93.72, 6.129),
    (CONSISTENT, 1.55, 0.8, 12000, 55.293, 71.99, 49.18, 3997, 38.16, 135.20, 132.40, 135.20, 121.99, 15.599),
    (CONSISTENT, 0.0, 0.3, 3000, 5.398, 10.90, 65.07, 324, 30.74, 75.07, 76.48, 76.48, None, 1.632),
    (CONSISTENT, 0.0, 0.8, 3000, 27.796, 33.80, 45.57, 463, 9.52, 96.57, 99.52, 99.52, None, 7.609),
]


@pytest.mark.parametrize("row", REFERENCE, ids=lambda row: f"{row[0].value}-{row[1]}-{row[2]}-{row[3]}")
def test_reference_numbers(row):
    mode, nusselt, eccentricity, speed, *expected = row
    state = film_at_eccentricity(film(mode, speed, C, HeatExchange(NusseltLaw(nusselt))), eccentricity)
    tolerances = (0.01, 0.01, 0.01, 0.01, 0.01, None, None, None, None, 0.01)
    for found, wanted, relative in zip(columns(state), expected, tolerances, strict=True):
        if wanted is None:
            assert math.isnan(found)  # the temperature of a journal that nothing touches
        elif relative is None:
            assert found == pytest.approx(wanted, abs=0.5)
        else:
            assert found == pytest.approx(wanted, rel=relative)
    assert state.converged


def test_conducting_bush_reference():
    loads = {}
    for conductivity in (0.0, 0.1, 1.0, 10.0, 100.0, 400.0):
        ring = HeatExchange(bush=BushRing(0.09, conductivity))
        loads[conductivity] = film_at_eccentricity(film(CONSISTENT, 3000, C, ring, 180), 0.8).load_along
    found = [loads[one] / loads[0.0] for one in (0.1, 1.0, 10.0, 100.0, 400.0)]
    assert found == pytest.approx([0.9999, 0.9994, 0.9954, 0.9855, 0.9825], abs=2e-4)


@pytest.mark.parametrize(
    ("coefficient", "load", "housing", "shaft", "journal"),
    [(50, 23.91, 109, 14.0, 89.8), (200, 28.71, 350, 12.4, 81.8), (1000, 43.93, 893, 9.2, 65.9)],
)
def test_cooled_bush_reference(coefficient, load, housing, shaft, journal):
    state = film_at_eccentricity(film(CONSISTENT, 3000, C, exchanging(coefficient=coefficient), 180), 0.8)
    assert relative_load(state) == pytest.approx(load, rel=0.01)
    assert state.temperatures.to_housing == pytest.approx(housing, rel=0.01)
    assert state.temperatures.to_shaft == pytest.approx(shaft, rel=0.01)
    assert state.temperatures.journal - ZERO == pytest.approx(journal, abs=0.5)


# -- balances --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mode", Discretisation)
@pytest.mark.parametrize("exchange", [HeatExchange(), NO_EXCHANGE, exchanging()], ids=["journal", "none", "all"])
@pytest.mark.parametrize("eccentricity", [0.2, 0.8])
def test_every_balance_closes(mode, exchange, eccentricity):
    state = film_at_eccentricity(film(mode, 6000, exchange=exchange, cells=180), eccentricity)
    t, heat = state.temperatures, state.heat_source
    assert abs(state.energy_balance_error) < 1e-8
    assert t.film_to_bush == pytest.approx(t.to_housing, abs=1e-8 * heat)
    assert t.film_to_journal == pytest.approx(t.to_shaft, abs=1e-8 * heat)
    assert np.isfinite(t.film).all()


def test_adiabatic_rise_is_heat_over_capacity():
    state = film_at_eccentricity(film(CONSISTENT, 3000, exchange=NO_EXCHANGE), 0.6)
    rise = np.diff(state.temperatures.film)
    assert float(state.sectors.capacity_flow @ rise) == pytest.approx(state.heat_source, rel=1e-6)
    mean = float(state.sectors.capacity_flow.mean())
    assert rise.sum() == pytest.approx(state.heat_source / mean, rel=0.01)


def test_heat_is_dissipation_in_the_full_film():
    state = film_at_eccentricity(film(CONSISTENT, 3000), 0.6)
    own, gap = state.film, state.gap
    eta = 0.5 * (state.viscosity[1:] + state.viscosity[:-1])
    h, slope = own.clearance * gap.sectors, np.diff(state.film_pressure) / gap.step
    area = own.radius * gap.step * own.width
    made = area * (eta * own.surface_speed**2 / h + h**3 / (12.0 * eta * own.radius**2) * slope**2)
    full = state.pressure.full >= 1.0
    assert state.sectors.source[full] == pytest.approx(made[full], rel=0.01)
    assert state.sectors.source.min() > 0.0


def test_friction_power_is_dissipation_plus_flow_work():
    state = film_at_eccentricity(film(CONSISTENT, 3000), 0.6)
    assert state.friction_torque * state.film.angular_speed == pytest.approx(state.heat_source, rel=1e-3)


# -- what was published ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("mode", "bound"), [(MEAN, 1.2), (LITERAL, 1.5), (CONSISTENT, 6.0)])
def test_published_table(mode, bound):
    assert root_mean_square(mode) <= bound


def test_relative_load_of_the_default_mode_is_monotone():
    eccentricities, speeds = np.linspace(0.1, 0.8, 8), (3000, 6000, 12000)
    loads = np.array([[relative_load(solved(CONSISTENT, n, float(e))) for n in speeds] for e in eccentricities])
    assert (np.diff(loads, axis=0) > 0.0).all()
    assert (np.diff(loads, axis=1) > 0.0).all()
    per_speed = loads / np.array(speeds)
    assert (np.diff(per_speed, axis=1) < 0.0).all()
    assert (np.diff(per_speed[:, -1] / per_speed[:, 0]) < 0.0).all()


@pytest.mark.parametrize("mode", Discretisation)
def test_a_conducting_bush_lowers_the_load_a_little(mode):
    at_end = []
    for speed in (3000, 12000):
        ratios = [conducting_bush_ratio_180(mode, speed, e) for e in (0.1, 0.3, 0.5, 0.7, 0.8)]
        assert (np.diff(ratios) < 0.0).all()
        assert 0.975 <= ratios[-1] <= 0.992
        at_end.append(ratios[-1])
    assert abs(at_end[0] - at_end[1]) < 0.01
    assert at_end[0] == pytest.approx(conducting_bush_ratio(mode, 3000, 0.8), abs=1e-3)


def conducting_bush_ratio_180(mode, speed, eccentricity):
    """On the published number of sectors."""
    bush = film(mode, speed, exchange=HeatExchange(bush=BushRing(0.09, 100.0)), cells=180)
    plain = film(mode, speed, cells=180)
    return (
        film_at_eccentricity(bush, eccentricity).load_along / film_at_eccentricity(plain, eccentricity).load_along
    )


@pytest.mark.parametrize("mode", [MEAN, LITERAL])
def test_one_mean_temperature_flatters_at_high_eccentricity(mode):
    def ratio(speed, eccentricity):
        own = film(mode, speed)
        return solved(mode, speed, eccentricity).load_along / mean_temperature_film(own, eccentricity).load_along

    slow, fast = ratio(3000, 0.8), ratio(12000, 0.8)
    assert 0.82 <= slow <= 0.90
    assert fast > slow
    assert all(abs(ratio(speed, 0.2) - 1.0) < 0.04 for speed in (3000, 12000))


def test_one_mean_temperature_flatters_faster_bearings_more_where_flow_is_conserved():
    ratios = []
    for speed in (3000, 12000):
        alone = mean_temperature_film(film(CONSISTENT, speed, C), 0.8)
        ratios.append(film_at_eccentricity(film(CONSISTENT, speed, C), 0.8).load_along / alone.load_along)
    assert ratios == pytest.approx([0.781, 0.751], abs=0.005)


def test_mean_temperature_is_found_below_where_the_data_of_the_oil_end():
    own = film(CONSISTENT, 3000)
    usual = mean_temperature_film(own, 0.6)
    density = LinearProperty(820.0, usual.temperature, -8.2)  # none is left 100 K above, at less than 300 degC
    assert usual.temperature + 100.0 < 573.0
    thin = replace(own, lubricant=replace(own.lubricant, density_law=density))
    found = mean_temperature_film(thin, 0.6)
    assert found.outlet_temperature - 2.0 * found.temperature == pytest.approx(-own.inlet_temperature)
    assert found.temperature < usual.temperature + 100.0


def test_mean_temperature_closes_its_own_balance():
    own = film(CONSISTENT, 3000)
    alone = mean_temperature_film(own, 0.6, ExchangeZone.ALL_AROUND)
    assert alone.temperature == pytest.approx(0.5 * (alone.outlet_temperature + own.inlet_temperature))
    isoviscous = replace(own, exchange=NO_EXCHANGE, exchange_zone=ExchangeZone.ALL_AROUND)
    assert alone.friction_power > mean_temperature_film(isoviscous, 0.6, ExchangeZone.FILM).friction_power


# -- limits and trends -----------------------------------------------------------------------------------------


def test_more_cooling_carries_more_and_rubs_more():
    states = [
        film_at_eccentricity(film(CONSISTENT, 3000, exchange=exchanging(coefficient=a), cells=180), 0.7)
        for a in (10.0, 100.0, 1000.0)
    ]
    assert (np.diff([one.load for one in states]) > 0.0).all()
    assert (np.diff([one.heat_source for one in states]) > 0.0).all()
    assert (np.diff([one.temperatures.journal for one in states]) < 0.0).all()


def test_a_bush_that_gives_off_nothing_only_redistributes():
    closed = HeatExchange(bush=BushRing(0.1, 100.0))
    state = film_at_eccentricity(film(CONSISTENT, 3000, exchange=closed, cells=180), 0.7)
    assert state.temperatures.to_oil == pytest.approx(state.heat_source, rel=1e-9)
    assert state.temperatures.film_to_bush == pytest.approx(0.0, abs=1e-8 * state.heat_source)
    assert np.ptp(state.temperatures.bush) < np.ptp(state.temperatures.film)


def test_without_resistance_film_and_journal_are_of_one_temperature():
    state = film_at_eccentricity(film(CONSISTENT, 3000, exchange=HeatExchange(NusseltLaw(1e5)), cells=180), 0.5)
    assert state.temperatures.film[5:] == pytest.approx(state.temperatures.journal, abs=0.05)


def test_a_film_without_friction_keeps_its_temperature():
    slow = replace(film(CONSISTENT, 3000, cells=180), angular_speed=1e-3)
    state = film_at_eccentricity(slow, 0.5)
    assert state.temperatures.film == pytest.approx(slow.inlet_temperature, abs=1e-3)


def test_sectors_converge():
    loads = [film_at_eccentricity(film(CONSISTENT, 3000, cells=n), 0.7).load for n in (90, 180, 360, 720)]
    steps = np.abs(np.diff(loads))
    assert (steps[1:] < 0.6 * steps[:-1]).all()
    assert steps[-1] < 1e-3 * loads[-1]


def test_an_own_nusselt_law_is_as_good_as_ours():
    law = NusseltLaw()

    def own(peclet, gap_ratio):
        return 1.55 * (peclet * gap_ratio) ** (1.0 / 3.0)

    given, ours = (
        film_at_eccentricity(film(CONSISTENT, 3000, exchange=HeatExchange(n), cells=180), 0.6) for n in (own, law)
    )
    assert given.load == pytest.approx(ours.load, rel=1e-12)


def test_a_constant_nusselt_number():
    law = NusseltLaw(3.77, 0.0)
    assert law(np.array([10.0, 1000.0]), np.array([1e-3, 1e-3])) == pytest.approx([3.77, 3.77])


@pytest.mark.parametrize("zone", ExchangeZone)
def test_the_ruptured_zone_matters_less_where_less_of_it_rubs(zone):
    state = film_at_eccentricity(replace(film(CONSISTENT, 3000), exchange_zone=zone), 0.6)
    powers = {
        one: film_at_eccentricity(replace(film(CONSISTENT, 3000), exchange_zone=one), 0.6).heat_source
        for one in ExchangeZone
    }
    assert powers[ExchangeZone.FILM] < powers[ExchangeZone.LIQUID_FRACTION] < powers[ExchangeZone.ALL_AROUND]
    assert state.heat_source == powers[zone]


# -- under a load ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("load", [200.0, 5e3, 20e3, 45e3])
@pytest.mark.parametrize("exchange", [HeatExchange(), exchanging()], ids=["journal", "all"])
def test_the_film_carries_what_it_is_asked_to(load, exchange):
    own = film(CONSISTENT, 3000, exchange=exchange, cells=180)
    state = film_under_load(own, load)
    assert state.load == pytest.approx(load, rel=1e-5)
    prescribed = film_at_eccentricity(own, state.eccentricity_ratio)
    assert prescribed.load == pytest.approx(load, rel=1e-4)
    assert prescribed.attitude_angle == pytest.approx(state.attitude_angle, abs=1e-4)


@pytest.mark.parametrize("load", [1e3, 20e3, 45e3])
def test_the_short_cut_finds_what_the_scan_finds(load):
    from babbitt.kinds.journal.infinitely_long_bearing import solve

    own = film(CONSISTENT, 3000, cells=90)
    assert film_under_load(own, load).eccentricity_ratio == pytest.approx(
        solve._scanned(own, load).eccentricity_ratio, abs=1e-5
    )


@pytest.mark.parametrize("zone", ExchangeZone)
@pytest.mark.parametrize("eccentricity", [0.3, 0.8])
def test_friction_power_is_torque_times_speed_and_all_of_it_becomes_heat_where_the_flow_is_one(zone, eccentricity):
    state = film_at_eccentricity(replace(film(CONSISTENT, 3000), exchange_zone=zone), eccentricity)
    assert state.friction_torque * state.film.angular_speed == pytest.approx(state.friction_power, rel=1e-12)
    assert state.heat_source == pytest.approx(state.friction_power, rel=1e-9)


def test_the_published_form_loses_flow_work_and_names_heat_and_power_apart():
    state = film_at_eccentricity(film(LITERAL, 3000), 0.8)
    assert state.friction_torque * state.film.angular_speed == pytest.approx(state.friction_power, rel=1e-12)
    work = state.sectors.friction - state.sectors.source
    assert state.friction_power - state.heat_source == pytest.approx(float(work.sum()), rel=1e-9)
    assert abs(work.sum()) > 0.01 * state.friction_power  # the local flow differs from section to section
    t = state.temperatures
    assert t.to_oil + t.to_housing + t.to_shaft == pytest.approx(state.heat_source, rel=1e-8)
