"""Orbits under changing loads: closed forms, balances, symmetries, and the linear film as their limit."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from film_bearings import answer, solved

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.kinds.journal.film import moving_journal
from babbitt.kinds.journal.film import orbit as orbit_module
from babbitt.kinds.journal.film.changing_load import RotatingLoad, TabulatedLoad
from babbitt.kinds.journal.film.moving_journal import HeavyJournal
from babbitt.kinds.journal.film.orbit import find_orbit
from babbitt.reynolds.equilibrium.many_positions import FilmPositions
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import (
    DRAFT,
    ENGINEERING,
    Cavitation,
    FilmStart,
    JournalFilm,
    Land,
    Resolution,
    grooved_bore,
)

SPEED = 314.0
RING = JournalFilm(
    0.2, 0.12, 150e-6, 0.02, SPEED, (Land(0.0, 2.0 * math.pi),), Cavitation.REYNOLDS, FilmStart.WIDEST_GAP
)
GROOVED = replace(RING, lands=grooved_bore((0.0, math.pi), 0.35, 0.0), film_start=FilmStart.GROOVE)
"""Its films separate into modes of the width: a march costs a tenth of that of a film solved node by node."""
PRESSED = replace(GROOVED, lands=grooved_bore((0.0, math.pi), 0.35, 1e5))
"""Its films are solved node by node."""
STEADY = (0.0, -2e4)
MIXED = RotatingLoad(1e4, phase=0.3)
COARSE = Resolution(4, 24)
"""For what a march does, whatever the grid."""


@pytest.fixture(scope="module")
def mixed():
    return find_orbit(GROOVED, MIXED, STEADY, resolution=COARSE)


@pytest.mark.parametrize("ratio", [1.0, -1.0, 0.25, 0.75])
def test_a_rotating_load_is_a_steady_one_at_the_effective_speed(ratio):
    # seen from the load both surfaces turn by Omega less: omega_eff = omega - 2 Omega
    orbit = find_orbit(RING, RotatingLoad(2e4, ratio), resolution=ENGINEERING)
    steady = solve_journal(replace(RING, angular_speed=SPEED * (1.0 - 2.0 * ratio)), (2e4, 0.0))
    assert orbit.outcome is Outcome.CONVERGED
    eccentricity = np.hypot(*orbit.position.T) / RING.clearance
    np.testing.assert_allclose(eccentricity, steady.eccentricity_ratio, rtol=1.5e-3)
    ahead = np.arctan2(*orbit.position.T[::-1]) - np.arctan2(*orbit.load.T[::-1])
    expected = math.atan2(steady.position[1], steady.position[0])
    np.testing.assert_allclose(np.angle(np.exp(1j * (ahead - expected))), 0.0, atol=math.radians(0.2))
    assert orbit.maximum_pressure.max() == pytest.approx(steady.maximum_pressure, rel=5e-3)


def test_a_closed_ring_agrees_with_the_effective_speed():
    ring = replace(RING, film_start=FilmStart.PERIODIC)
    seen = []
    orbit = find_orbit(ring, RotatingLoad(2e4), watch=lambda cycles: (seen.append(one) or one for one in cycles))
    assert seen == list(range(1, orbit.cycles + 1))  # told cycle by cycle
    steady = solve_journal(replace(ring, angular_speed=-SPEED), (2e4, 0.0), DRAFT)
    assert orbit.largest_eccentricity_ratio == pytest.approx(steady.eccentricity_ratio, rel=5e-3)


def test_the_bearing_counts_in_the_effective_speed_and_the_journal_gives_the_time():
    # journal at rest-frame speed w, bearing at 0.5 w, load with the journal: 1.5 w - 2 w
    both = replace(RING, angular_speed=1.5 * SPEED)
    orbit = find_orbit(both, RotatingLoad(2e4), speed=SPEED, resolution=ENGINEERING)
    steady = solve_journal(replace(RING, angular_speed=-0.5 * SPEED), (2e4, 0.0))
    assert orbit.largest_eccentricity_ratio == pytest.approx(steady.eccentricity_ratio, rel=2e-3)


def test_a_load_at_half_the_speed_squeezes_the_film_out():
    assert find_orbit(RING, RotatingLoad(2e4, 0.5), resolution=COARSE).outcome is Outcome.SQUEEZED_OUT


@pytest.mark.parametrize("ratio", [1.0, -1.0])
@pytest.mark.parametrize("mass", [0.0, 2000.0])
def test_an_unbalance_moves_the_journal_as_stiffness_damping_and_mass_say(mass, ratio):
    """(K + i w C - w² m) r = F: a small force that turns, forward and backward."""
    small = 400.0
    orbit = find_orbit(PRESSED, RotatingLoad(small, ratio), STEADY, mass=mass, resolution=DRAFT)
    assert orbit.outcome is Outcome.CONVERGED
    rest = solve_journal(PRESSED, STEADY, DRAFT)
    dynamic = rest.stiffness + 1j * SPEED * rest.damping - mass * SPEED**2 * np.eye(2)
    force = np.array([small, -1j * ratio * small])  # Re exp(i w t) is (cos, sin), or backward (cos, -sin)
    amplitude = np.linalg.solve(dynamic, force)
    turning = np.exp(-1j * orbit.turned)
    found = 2.0 * (orbit.position * turning[:, None]).mean(axis=0)
    np.testing.assert_allclose(found, amplitude, rtol=0.0, atol=0.01 * np.abs(amplitude).max())
    velocity = 2.0 * (orbit.velocity * turning[:, None]).mean(axis=0)
    np.testing.assert_allclose(velocity, 1j * SPEED * found, rtol=0.0, atol=5e-3 * SPEED * np.abs(found).max())


@pytest.mark.parametrize(("film", "mass"), [(GROOVED, 0.0), (GROOVED, 2000.0), (PRESSED, 0.0)])
def test_the_mean_force_of_a_turn_is_the_static_load(film, mass):
    """A closed orbit changes no momentum, however far its journal moves: here by half the clearance."""
    orbit = find_orbit(film, MIXED, STEADY, mass=mass, resolution=COARSE)
    assert orbit.outcome is Outcome.CONVERGED
    assert np.ptp(orbit.position, axis=0).max() > 0.3 * film.clearance
    thin = replace(film, cavitation=Cavitation.REYNOLDS)
    states = zip(orbit.position, orbit.velocity, strict=True)
    force = np.array([film_at_position(thin, tuple(place), tuple(pace), COARSE).force for place, pace in states])
    np.testing.assert_allclose(force.mean(axis=0), [0.0, -STEADY[1]], atol=1e-3 * MIXED.magnitude)
    np.testing.assert_allclose(orbit.load.mean(axis=0), STEADY, atol=1e-9 * MIXED.magnitude)


def test_an_orbit_with_mass_closes_where_its_velocity_comes_back():
    """A free motion passes by the place of the begin with a velocity of its own; told by a second integrator."""
    from scipy.integrate import solve_ivp

    load, mass = RotatingLoad(400.0, 0.25, 6.1), 1760.0
    orbit = find_orbit(GROOVED, load, STEADY, mass=mass)
    assert orbit.outcome is Outcome.CONVERGED
    thin = replace(GROOVED, cavitation=Cavitation.REYNOLDS)
    journal = HeavyJournal(thin, np.array(STEADY), load, SPEED, DRAFT, mass)
    begin = np.concatenate((orbit.position[0], orbit.velocity[0] / SPEED)) / GROOVED.clearance
    run = solve_ivp(
        journal.slope, (0.0, orbit.cycle), begin, method="Radau", jac=journal.jacobian, rtol=1e-5, atol=1e-7
    )
    for part in (slice(0, 2), slice(2, 4)):
        apart = np.hypot(*(run.y[part, -1] - begin[part]))
        assert apart < 1.5e-3 * np.ptp(run.y[part], axis=1).max()


def test_the_film_carries_the_load_at_every_instant(mixed):
    thin = replace(GROOVED, cavitation=Cavitation.REYNOLDS)
    for instant in range(0, mixed.turned.size, 24):
        film = film_at_position(thin, tuple(mixed.position[instant]), tuple(mixed.velocity[instant]), COARSE)
        np.testing.assert_allclose(film.force, -mixed.load[instant], atol=1e-5 * math.hypot(*STEADY))


def test_the_velocity_is_the_change_of_the_place(mixed):
    count = mixed.turned.size
    orders = np.fft.fftfreq(count, 1.0 / count)
    slope = np.fft.ifft(1j * orders[:, None] * np.fft.fft(mixed.position, axis=0), axis=0).real * SPEED
    np.testing.assert_allclose(slope, mixed.velocity, atol=0.02 * np.abs(mixed.velocity).max())


def test_the_steady_part_of_the_load_does_no_work(mixed):
    steady_work = (mixed.velocity @ np.array(STEADY)).mean()
    assert abs(steady_work) < 0.02 * abs(mixed.velocity @ np.array(STEADY)).max()
    assert mixed.load_power == pytest.approx((mixed.load * mixed.velocity).sum(axis=1).mean())


def test_the_mirror_image_turns_the_other_way(mixed):
    clockwise = replace(GROOVED, angular_speed=-SPEED)  # symmetric about the vertical
    other = find_orbit(clockwise, RotatingLoad(1e4, phase=math.pi - 0.3), STEADY, resolution=COARSE)
    np.testing.assert_allclose(other.position * [-1.0, 1.0], mixed.position, atol=1e-3 * GROOVED.clearance)
    assert other.friction_power == pytest.approx(mixed.friction_power, rel=1e-3)


def test_a_table_of_the_same_load_gives_the_same_orbit(mixed):
    angles = np.arange(144) * (2.0 * math.pi / 144)
    fx, fy = np.array([MIXED.at(angle) for angle in angles]).T
    table = find_orbit(GROOVED, TabulatedLoad(tuple(angles), tuple(fx), tuple(fy)), STEADY, resolution=COARSE)
    np.testing.assert_allclose(table.turned, mixed.turned, rtol=1e-12)
    np.testing.assert_allclose(table.position, mixed.position, atol=2e-3 * GROOVED.clearance)


def test_a_mass_above_the_critical_one_leaves_its_orbit(monkeypatch):
    light = (0.0, -2e3)
    from babbitt.reynolds.stability.routh import critical_mass

    rest = solve_journal(GROOVED, light, COARSE)
    critical = critical_mass(rest.stiffness, rest.damping)
    below = find_orbit(GROOVED, RotatingLoad(50.0), light, mass=0.5 * critical, resolution=COARSE)
    assert below.outcome is Outcome.CONVERGED
    monkeypatch.setattr(orbit_module, "MOST_CYCLES", below.cycles // 2)  # the motion grows from its first cycle on
    above = find_orbit(GROOVED, RotatingLoad(50.0), light, mass=2.0 * critical, resolution=COARSE)
    assert above.outcome is Outcome.NOT_PERIODIC
    assert np.ptp(above.position, axis=0).max() > 2.0 * np.ptp(below.position, axis=0).max()


def test_tables_are_periodic_and_linear():
    load = TabulatedLoad((0.0, 1.0, 3.0), (0.0, 10.0, 30.0), (0.0, 0.0, 6.0), cycle=4.0)
    assert load.at(0.5) == pytest.approx((5.0, 0.0))
    assert load.at(3.5) == pytest.approx((15.0, 3.0))
    assert load.at(-4.5) == load.at(4.5) == pytest.approx((5.0, 0.0))


def test_a_film_without_damping_and_a_journal_at_rest_are_refused():
    half = replace(RING, cavitation=Cavitation.HALF_SOMMERFELD, film_start=FilmStart.PERIODIC)
    with pytest.raises(InputError, match="no damping"):
        find_orbit(half, MIXED)
    with pytest.raises(InputError, match="stands still"):
        find_orbit(replace(RING, angular_speed=0.0), MIXED)


ROTATING = {"kind": "rotating", "magnitude": "10 kN"}
UNPRESSED = {"temperature": "45 degC", "pressure": "0 MPa"}


def test_the_answer_of_a_bearing_tells_of_its_orbit():
    given = {"limits": {"minimum_film_thickness": "40 um"}, "accuracy": "draft"}
    result, calm = answer(**given, dynamic_load=ROTATING), answer(**given)
    assert result.minimum_film_thickness == calm.minimum_film_thickness
    rows = np.array(result.arrays["orbit"])
    assert result.orbit_minimum_film_thickness == rows[:, 5].min() < calm.minimum_film_thickness
    assert result.orbit_maximum_pressure == rows[:, 6].max() > calm.maximum_pressure
    np.testing.assert_allclose(rows[:, 3:5].mean(axis=0), [0.0, -30e3], atol=1.0)
    (check,) = [check for check in result.checks if check.quantity == "orbit_minimum_film_thickness"]
    assert check.code == "C101"
    assert check.ok is (result.orbit_minimum_film_thickness >= 40e-6)
    assert any("without memory" in said for said in result.assumptions)


def test_an_orbit_that_does_not_close_is_no_solution():
    # hardly any steady load, and a load that rotates at half the speed
    (result,) = solved(
        span="360 deg", grooves=None, film_start="widest_gap", cavitation="reynolds", load="100 N",
        effective_temperature="60 degC", dynamic_load=ROTATING | {"speed_ratio": 0.5}, accuracy="draft",
    ).results  # fmt: skip
    assert result.outcome in (Outcome.SQUEEZED_OUT, Outcome.NOT_PERIODIC)
    assert "cycles" in result.message


@pytest.mark.parametrize(("mass", "begun"), [(0.0, (10.0, 150.0, 450.0, 650.0)), (100.0, (10.0, 450.0))])
def test_a_short_pulse_is_seen_wherever_it_lies_in_the_cycle(mass, begun):
    """300 kN for 10 of 720 degrees: a march whose steps grow while the load rests would pass over it."""
    found = []
    for begins in begun:
        angles = tuple(math.radians(one) for one in (0.0, begins, begins + 5.0, begins + 10.0))
        pulse = TabulatedLoad(angles, (0.0,) * 4, (0.0, 0.0, -3e5, 0.0), 4.0 * math.pi)
        found.append(find_orbit(GROOVED, pulse, STEADY, mass=mass, resolution=COARSE))
    thinnest = [float(one.film_thickness.min()) for one in found]
    assert {one.outcome for one in found} == {Outcome.CONVERGED}
    assert thinnest == pytest.approx([thinnest[0]] * len(begun), rel=2e-3)
    for one in found:  # the instants see the whole pulse
        impulse = np.trapezoid(np.vstack([one.load, one.load[:1]]), np.append(one.turned, one.cycle), axis=0)
        assert impulse == pytest.approx([0.0, STEADY[1] * one.cycle - 3e5 * math.radians(5.0)], rel=1e-9)


@pytest.mark.parametrize(
    ("given", "thins", "named", "not_named"),
    [
        (ROTATING, 1.0, "preload", "moving_mass"),
        (ROTATING | {"moving_mass": "100 kg"}, 1.0, "moving_mass", "steady load"),
        (ROTATING, -1.0, "ratio of the speeds", "moving_mass"),
        ({"kind": "table", "cycle": "360 deg", "angle": ["0 deg", "180 deg"], "fx": ["0 N", "0 N"],
          "fy": ["0 N", "-10 kN"]}, -1.0, "steady load", "ratio"),
    ],
)  # fmt: skip
def test_a_remedy_names_only_what_the_case_has(given, thins, named, not_named, monkeypatch):
    monkeypatch.setattr(orbit_module, "MOST_CYCLES", 2)
    monkeypatch.setattr(orbit_module, "_apart", lambda *_: math.inf)  # whatever is thought of the last film
    monkeypatch.setattr(orbit_module, "STILL_THINNING", thins)
    choice = {"effective_temperature": "60 degC", "cavitation": "reynolds", "accuracy": "draft"}
    (found,) = solved(dynamic_load=given, supply=UNPRESSED, **choice).results
    assert found.outcome is (Outcome.NOT_PERIODIC if thins > 0.0 else Outcome.SQUEEZED_OUT)
    assert named in found.message
    assert not_named not in found.message


def test_a_march_is_bounded_in_films(monkeypatch):
    """A load at half the speed sinks the journal ever more slowly: nothing but a bound ends it early."""
    whole = find_orbit(RING, RotatingLoad(1e4, 0.5), (0.0, -100.0), resolution=COARSE)
    asked = []
    coefficients = FilmPositions.coefficients
    monkeypatch.setattr(FilmPositions, "coefficients", lambda *given: asked.append(1) or coefficients(*given))
    for module in (moving_journal, orbit_module):
        monkeypatch.setattr(module, "MOST_FILMS", 500)
    found = find_orbit(RING, RotatingLoad(1e4, 0.5), (0.0, -100.0), resolution=COARSE)
    assert 2 <= found.cycles < whole.cycles
    assert len(asked) < 4 * 500
    assert found.outcome in (Outcome.SQUEEZED_OUT, Outcome.NOT_PERIODIC)
    assert np.isfinite(found.film_thickness).all()


def test_a_march_that_loses_its_film_keeps_its_last_cycle(monkeypatch):
    films, forces = itertools.count(), FilmPositions.forces

    def lost_for_a_while(*given):
        found = forces(*given)
        return replace(found, settled=np.array([False])) if next(films) == 600 else found

    monkeypatch.setattr(FilmPositions, "forces", lost_for_a_while)
    found = find_orbit(GROOVED, MIXED, STEADY, mass=2000.0, resolution=COARSE)
    assert found.outcome is Outcome.NOT_CONVERGED
    assert found.cycles >= 1
    assert np.isfinite(found.film_thickness).all()
    assert 0.2 * GROOVED.clearance < found.film_thickness.min() < GROOVED.clearance


def test_limits_of_load_and_pressure_hold_for_the_worst_instant():
    pulse = {"kind": "table", "cycle": "720 deg", "angle": ["0 deg", "450 deg", "455 deg", "460 deg"],
             "fx": ["0 N"] * 4, "fy": ["0 N", "0 N", "-300 kN", "0 N"]}  # fmt: skip
    found = answer(
        effective_temperature="60 degC", dynamic_load=pulse, cavitation="reynolds",
        limits={"specific_load": "5 MPa"}, accuracy="draft", supply=UNPRESSED,
    )  # fmt: skip
    assert found.orbit_specific_load == pytest.approx(330e3 / (0.2 * 0.12), rel=0.01)
    held = {check.code: check.ok for check in found.checks if check.quantity == "orbit_specific_load"}
    assert held["C103"] is False
    assert found.verdict.value == "fail"


def test_a_film_limit_kept_by_little_on_the_orbit_is_questioned():
    """An unbalance takes most of the margin of the steady film; one temperature cannot show what is left."""
    turning = {"kind": "rotating", "magnitude": "15 kN", "speed_ratio": 1}
    orbit = answer(dynamic_load=turning, cavitation="reynolds", accuracy="draft")
    least = orbit.orbit_minimum_film_thickness
    near, far = (
        answer(
            dynamic_load=turning, cavitation="reynolds", accuracy="draft",
            limits={"minimum_film_thickness": f"{least / margin * 1e6} um", "temperature": "140 degC"},
        )
        for margin in (1.2, 2.5)
    )  # fmt: skip
    assert {one.values["kept"][0].values["check"] for one in near.warnings if one.code == "W191"} == {"C101"}
    assert "W191" not in [one.code for one in far.warnings]


def test_the_peak_of_a_fine_table_is_read():
    """A table of 90 points that has its peak between two of the even instants of a cycle."""
    angles = np.arange(90) * math.radians(8.0)
    pulse = TabulatedLoad(
        tuple(angles), (0.0,) * 90, tuple(np.where(np.arange(90) == 57, -3e5, 0.0)), 4.0 * math.pi
    )
    found = find_orbit(GROOVED, pulse, STEADY, resolution=COARSE)
    assert found.outcome is Outcome.CONVERGED
    assert -found.load[:, 1].min() == pytest.approx(3.2e5, rel=1e-12)


@pytest.mark.thorough
@pytest.mark.parametrize(("ratio", "told"), [(0.52, True), (1.0, False)])
def test_a_film_force_that_the_grid_blurs_is_told(ratio, told):
    """Near half the speed wedge and squeeze nearly cancel; a load that turns with the journal is no such case."""
    result = answer(
        effective_temperature="60 degC", cavitation="reynolds", accuracy="draft", load="5 kN",
        dynamic_load=ROTATING | {"speed_ratio": ratio},
    )  # fmt: skip
    warnings = {notice.code: notice for notice in result.warnings}
    assert (result.orbit_load_error > 0.05) is told
    assert ("W133" in warnings) is told
    if told:
        assert warnings["W133"].values == {"orbit_load_error": result.orbit_load_error}


def shocks_of(magnitude, character):
    """Variants of W200 of a bearing of B83 under 30 kN and a load that turns."""
    materials = {"bearing": "C10", "journal": "C45", "bearing_metal": "B83"}
    result = answer(
        materials=materials if character is None else materials | {"load_character": character},
        dynamic_load={"kind": "rotating", "magnitude": magnitude, "speed_ratio": 1.0},
        method={"kind": "film", "thermal": "isothermal"}, cavitation="reynolds",
        accuracy="draft", effective_temperature="60 degC",
    )  # fmt: skip
    return [one.variant for one in result.warnings if one.code == "W200"]


@pytest.mark.parametrize(("magnitude", "character", "told"), [
    ("250 kN", None, True), ("250 kN", "calm", True), ("250 kN", "shock", False), ("180 kN", None, False),
])  # fmt: skip
def test_a_changing_load_between_the_limits_for_calm_and_for_shocks_is_told(magnitude, character, told):
    """B83 carries 15 MPa calmly and 10 MPa in shocks; 280 and 210 kN on 200 x 120 mm are 11.7 and 8.8 MPa."""
    assert ("load" in shocks_of(magnitude, character)) is told


@pytest.mark.parametrize(("magnitude", "character", "told"), [
    ("15 kN", None, True), ("15 kN", "calm", True), ("15 kN", "shock", False), ("5 kN", None, False),
    ("40 kN", None, False),
])  # fmt: skip
def test_load_times_speed_between_the_limits_for_calm_and_for_shocks_is_told(magnitude, character, told):
    """B83 bears 75 MPa m/s calmly and 50 in shocks; 45, 35 and 70 kN at 31.4 m/s are 58.9, 45.8 and 91.6."""
    assert ("load_times_speed" in shocks_of(magnitude, character)) is told


def test_a_step_to_nowhere_is_a_motion_that_was_not_found():
    """And no refusal of a place that the user never gave."""
    journal = moving_journal.MovingJournal(GROOVED, np.array(STEADY), MIXED, SPEED, COARSE)
    with pytest.raises(moving_journal.NoMotionError):
        journal.force_at(np.array([math.nan, 0.0]), np.zeros(2))
