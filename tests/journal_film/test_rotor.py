"""Rigid rotors and rotors on an elastic shaft: closed forms, eigenvalues, limits."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from film_bearings import answer, film
from hypothesis import assume, given
from hypothesis import strategies as st
from routh_hurwitz import hurwitz_margins, is_stable

from babbitt.core.notices import explanations
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.whirl import at_speed
from babbitt.reynolds.equilibrium.cavitating_film import coefficients_over_speed
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.model import DRAFT, Cavitation, JournalFilm, grooved_bore
from babbitt.reynolds.stability.rotor import RIGID, critical_mass_of_rotor, growth_rates, stable_masses_of_rotor
from babbitt.reynolds.stability.routh import NO_MASS, StableMasses, stable_masses, whirl_frequency
from babbitt.reynolds.stability.whirl_checks import JUMPS, LOST, STABLE, missing_thresholds
from babbitt.reynolds.stability.whirl_limits import ElasticWhirl, Threshold, Whirl, crossing, stability_excess

entries = st.integers(-100, 100).map(lambda tenths: 0.1 * tenths)
direct = st.integers(2, 100).map(lambda tenths: 0.1 * tenths)
symmetric_share = st.floats(-0.6, 0.6)


@st.composite
def films(draw):
    """Stiffness and damping of a film: damping takes energy out of every motion, stiffness holds the load."""
    k = np.array([[draw(entries), draw(entries)], [draw(entries), draw(entries)]])
    cx, cy = draw(direct), draw(direct)
    aside = draw(symmetric_share) * math.sqrt(cx * cy)
    assume(np.linalg.det(k) > 0.1)
    return k, np.array([[cx, aside], [aside, cy]])


@st.composite
def whirling_films(draw):
    """Cross-coupling of opposite signs, strong beside the difference of the direct stiffnesses: these can
    whirl.
    """
    one, other = draw(direct), draw(direct)
    middle, apart = draw(direct), draw(st.floats(-0.9, 0.9)) * math.sqrt(one * other)
    k = np.array([[middle + 10.0 + apart, one], [-other, middle + 10.0 - apart]])
    return k, np.diag([draw(direct), draw(direct)])


@st.composite
def any_films(draw):
    """Any stiffness and damping, saddles, unsymmetric and negative damping included."""
    k, c = (np.array([[draw(entries) for _ in range(2)] for _ in range(2)]) for _ in range(2))
    assume(abs(np.linalg.det(k)) > 0.05 and abs(np.linalg.det(c)) > 0.05 and abs(np.trace(c)) > 0.05)
    return k, c


@given(films(), st.floats(0.05, 50.0))
def test_routh_hurwitz_agrees_with_the_roots_of_the_characteristic_polynomial(coefficients, mass):
    stiffness, damping = coefficients
    a3, a2, a1, a0, _ = hurwitz_margins(mass, stiffness, damping)
    rate = float(np.roots([1.0, a3, a2, a1, a0]).real.max())
    assume(abs(rate) > 1e-6)
    assert is_stable(mass, stiffness, damping) is (rate < 0.0)


@given(films(), st.floats(0.05, 50.0))
def test_the_growth_rate_is_the_largest_root_of_the_characteristic_polynomial(film, mass):
    a3, a2, a1, a0, _ = hurwitz_margins(mass, *film)
    roots = np.roots([1.0, a3, a2, a1, a0])
    assert growth_rates(mass, *film).item() == pytest.approx(roots.real.max(), abs=1e-5 * np.abs(roots).max())


@given(whirling_films(), st.floats(0.5, 1e4))
def test_at_its_critical_mass_a_rotor_neither_grows_nor_dies_away(film, shaft):
    stiffness, damping = film
    for stiff in (RIGID, shaft):
        critical = critical_mass_of_rotor(stiffness, damping, stiff)
        frequency = whirl_frequency(stiffness, damping)
        assert frequency > 0.0
        below, at, above = growth_rates(np.array([0.95, 1.0, 1.05]) * critical, stiffness, damping, stiff)
        assert abs(at) < 1e-7 * frequency
        assert below < 0.0
        assert above > 0.0


def test_a_shaft_that_bends_whirls_earlier_and_a_stiff_one_as_a_rigid_rotor():
    film = [[2e8, 1e8], [-3e8, 4e8]], [[1e6, 0.0], [0.0, 2e6]]
    masses = [critical_mass_of_rotor(*film, shaft) for shaft in (1e7, 1e8, 1e9, 1e10, RIGID)]
    assert np.all(np.diff(masses) > 0.0)
    assert critical_mass_of_rotor(*film, 1e16) == pytest.approx(masses[-1], rel=1e-6)
    rates = [growth_rates(1500.0, *film, shaft).item() for shaft in (1e14, RIGID)]
    assert rates[0] == pytest.approx(rates[1], rel=1e-3)


def test_many_rotors_at_once_are_each_alone_and_one_without_film_has_no_rate():
    k = np.array([[[2e8, 1e8], [-3e8, 4e8]], [[np.nan, 0.0], [0.0, 1.0]], [[1e8, 2e8], [-2e8, 3e8]]])
    c = np.tile([[1e6, 1e5], [1e5, 2e6]], (3, 1, 1))
    for shaft in (RIGID, 3e8):
        rates = growth_rates([500.0, 500.0, 4000.0], k, c, shaft)
        assert np.isnan(rates[1])
        assert rates[2] == pytest.approx(growth_rates(4000.0, k[2], c[2], shaft).item())


def test_the_threshold_of_a_bearing_on_an_elastic_shaft_is_where_its_critical_mass_meets_the_rotor():
    given_ = {
        "load": "6 kN",
        "rotor_mass": "400 kg",
        "effective_temperature": "60 degC",
        "shaft_stiffness": "20 MN/m",
    }
    found = answer(**given_)
    assert found.shaft_stiffness == 2e7
    assert found.critical_mass_elastic < found.critical_mass
    assert found.threshold_speed_elastic < found.threshold_speed
    there = answer(**given_ | {"speed": f"{found.threshold_speed_elastic!r} rad/s"})
    assert there.critical_mass_elastic == pytest.approx(400.0, rel=1e-3)
    codes = [(check.code, check.quantity) for check in found.checks]
    assert ("C115", "critical_mass_elastic") in codes


def test_without_shaft_stiffness_nothing_is_said_of_an_elastic_shaft():
    assert not [name for name in answer(effective_temperature="60 degC").values if "elastic" in name]


def test_at_another_speed_the_load_keeps_the_direction_that_was_found():
    case = film(load=None, eccentricity_ratio=0.5, attitude_angle="20 deg", effective_temperature="60 degC")
    state = operating_film(case).film
    assert at_speed(case, state, abs(case.journal_speed)).position == pytest.approx(
        state.solution.position, rel=1e-5
    )


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("cavitation", [Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS])
def test_coefficients_at_another_speed_are_those_of_the_whole_film(sense, cavitation):
    lands = grooved_bore((0.0, math.pi), 0.3)
    bearing = JournalFilm(0.2, 0.12, 150e-6, 0.02, sense * 100.0, lands, cavitation=cavitation)
    frame = LoadFrame.of(bearing, (0.0, -sense * 3e4))
    at = coefficients_over_speed(frame.film, frame.load, DRAFT)
    for speed in (60.0, 100.0, 170.0):
        whole = solve_journal(replace(bearing, angular_speed=sense * speed), frame.load, DRAFT)
        stiffness, damping = at(speed)
        assert stiffness == pytest.approx(whole.stiffness, rel=1e-11)
        assert damping == pytest.approx(whole.damping, rel=1e-11)
    assert coefficients_over_speed(frame.film, (0.0, -sense * 1e12), DRAFT)(100.0) is None


def test_films_that_change_with_the_speed_but_for_their_unit_are_solved_whole():
    lands = grooved_bore((0.0, math.pi), 0.3)
    bearing = JournalFilm(0.2, 0.12, 150e-6, 0.02, 100.0, lands)
    pressed = tuple(replace(one, start_pressure=1e5, end_pressure=1e5) for one in lands)
    for other in ({"cavitation_pressure": -5e4}, {"misalignment": (1e-4, 0.0)}, {"lands": pressed}):
        assert coefficients_over_speed(replace(bearing, **other), (0.0, -3e4), DRAFT) is None


def test_a_threshold_is_not_told_where_films_are_missing_beside_it():
    def excess(speed):
        return 115.0 - speed

    def with_a_hole(speed):
        return math.nan if 101.0 < speed < 124.0 else excess(speed)

    assert crossing(excess, 100.0).speed == pytest.approx(115.0, rel=1e-4)
    assert crossing(with_a_hole, 100.0) == Threshold(is_lost=True)
    assert crossing(lambda speed: math.nan, 100.0) == Threshold(is_lost=True)
    assert math.isnan(stability_excess(math.nan))  # a film that is not found is not stable


def test_a_threshold_is_sought_as_finely_as_its_function_is_known():
    """The noise of a function is not followed: what counts as zero ends the search."""
    asked = []

    def noisy(speed):
        asked.append(speed)
        return math.log(115.0 / speed) + 5e-4 * math.sin(1e6 * speed)

    found = crossing(noisy, 100.0, 1e-3)
    assert found.speed == pytest.approx(115.0, rel=1.6e-3)
    assert len(asked) <= 9  # two of them beside the root, to see a jump


def test_a_jump_between_noisy_values_is_no_threshold():
    """In bores that give way a film may be a saddle at one speed and none at the next; elsewhere a jump is one."""

    def leaps(speed):
        return math.copysign(2.0, 115.0 - speed)

    assert crossing(leaps, 100.0).speed == pytest.approx(115.0, rel=1e-4)
    assert crossing(leaps, 100.0, 1e-3) == Threshold(jumps=True)


@pytest.mark.parametrize(("wave", "found"), [(0.0, True), (0.01, True), (0.3, False)])
def test_where_films_that_give_way_go_to_and_fro_there_is_no_threshold(wave, found):
    """Steady to 1e-4 at the crossing, by luck: other frames would find another speed."""

    def excess(speed):
        beside = 103.0 < speed < 114.0 or 116.0 < speed < 124.0
        return (115.0 - speed) / 115.0 + (wave * math.sin(1e3 * speed) if beside else 0.0)

    assert crossing(excess, 100.0, 1e-3).jumps is not found
    assert found == (crossing(excess, 100.0, 1e-3).speed == pytest.approx(115.0, rel=2e-3))
    stable = StableMasses(0.0, 2.0)
    whirl = Whirl(stable, 0.5, 1.0, Threshold(), ElasticWhirl(stable, Threshold(jumps=True)))
    assert missing_thresholds(whirl) == {"threshold_speed": STABLE, "threshold_speed_elastic": JUMPS}
    lost = Whirl(stable, 0.5, 1.0, Threshold(is_lost=True))
    assert missing_thresholds(lost) == {"threshold_speed": LOST}


@pytest.mark.parametrize("last_digits", [1e-15, -3e-15])
def test_round_off_does_not_choose_between_neighbouring_crossings(last_digits):
    """A reserve that jumps between two values in turns, as two sets of wet nodes give it."""

    def excess(speed, off=0.0):
        return math.log(115.0 / speed) + off + 3e-3 * math.copysign(1.0, math.sin(1e13 * speed))

    assert crossing(lambda speed: excess(speed, last_digits), 100.0) == crossing(excess, 100.0)


@given(any_films(), st.floats(0.01, 100.0))
def test_a_rotor_is_stable_within_the_stable_masses_and_nowhere_else(film, mass):
    stable = stable_masses(*film)
    reserve = stable.reserve(mass)
    rate = growth_rates(mass, *film).item()
    assume(abs(rate) > 1e-9 * np.linalg.norm(film[1]) / mass)
    assert (reserve > 1.0) is (rate < 0.0)
    assert is_stable(mass, *film) is (reserve > 1.0)


@given(any_films(), st.floats(0.01, 100.0), st.floats(1.0, 1e3))
def test_a_rotor_on_an_elastic_shaft_is_stable_within_its_stable_masses(film, mass, shaft):
    # a film that pushes more than the shaft holds may be stable by its damping alone, and counts as unstable
    assume(np.linalg.eigvalsh(film[0] + film[0].T + 2.0 * shaft * np.eye(2))[0] > 0.0)
    rate = growth_rates(mass, *film, shaft).item()
    assume(abs(rate) > 1e-6)
    assert (stable_masses_of_rotor(*film, shaft).reserve(mass) > 1.0) is (rate < 0.0)


REVERSED = {  # K in MN/m and C in MN s/m of mass-conserving films with one groove of 20 deg 30 deg behind the load
    "light": ([[25.679, 8.902], [160.486, 139.940]], [[-0.019243, 0.081811], [-0.230518, 1.272328]]),
    "heavy": ([[62.482, 22.519], [335.023, 431.393]], [[-0.064660, 0.267884], [-0.688205, 3.568000]]),
}


def test_light_rotors_whirl_where_the_determinant_of_the_damping_is_negative():
    stiffness, damping = (1e6 * np.array(one) for one in REVERSED["light"])
    stable = stable_masses(stiffness, damping)
    assert stable.least == pytest.approx(802.0, rel=2e-3)
    assert stable.greatest == math.inf
    assert growth_rates(300.0, stiffness, damping) > 0.0
    assert growth_rates(2000.0, stiffness, damping) < 0.0


def test_no_rotor_is_stable_where_the_damping_is_reversed_and_the_frequency_is_none():
    stiffness, damping = (1e6 * np.array(one) for one in REVERSED["heavy"])
    assert stable_masses(stiffness, damping) == NO_MASS
    assert (growth_rates(np.geomspace(1.0, 1e6, 13), stiffness, damping) > 0.0).all()


def test_a_film_that_only_a_heavy_rotor_can_use_is_checked_from_below():
    groove = {"grooves": [{"angle": "300 deg", "extent": "20 deg", "pressure": "0 Pa"}]}
    base = {
        "diameter": "100 mm", "width": "80 mm", "clearance": {"kind": "relative", "mean": "2 permille"},
        "lubricant": "ISO VG 32", "effective_temperature": "48 degC", "speed": "3000 rpm", "load": "1 kN",
    }  # fmt: skip
    light, heavy = (answer(**base | groove | {"rotor_mass": mass}) for mass in ("300 kg", "2000 kg"))
    assert light.least_stable_mass == pytest.approx(802.0, rel=0.01)
    assert light.stable_at_any_mass == 0.0
    assert "critical_mass" not in light.values
    assert [check.ok for check in light.checks if check.code == "C115"] == [False]
    assert [check.ok for check in heavy.checks if check.code == "C115"] == [True]
    (whirling,) = (warning.message for warning in light.warnings if warning.code == "W120")
    assert "a heavier rotor would be stable" in whirling
    assert "W120" not in {warning.code for warning in heavy.warnings}
    never = answer(**base | groove | {"load": "3 kN", "rotor_mass": "300 kg"})
    assert never.critical_mass == 0.0
    assert never.verdict.value == "fail"


def test_at_light_load_a_larger_clearance_invites_whirl_and_a_narrower_bearing_does_not():
    """What the advice of W120 and C115 says."""
    light = {
        "diameter": "100 mm", "load": "3 kN", "speed": "9000 rpm", "effective_temperature": "60 degC",
        "lubricant": {"kind": "constant", "dynamic_viscosity": "10 mPa s", "density": "860 kg/m3",
                      "volumetric_heat_capacity": "1.8 MJ/(m3 K)"},
    }  # fmt: skip

    def critical(width, psi):
        clearance = {"kind": "relative", "mean": f"{psi} permille"}
        return answer(**light | {"width": f"{width} mm", "clearance": clearance}).critical_mass

    by_clearance = [critical(60, psi) for psi in (0.6, 1.2, 1.8, 2.4)]
    assert np.all(np.diff(by_clearance) < 0.0)
    by_width = [critical(width, 1.2) for width in (100, 60, 30)]
    assert np.all(np.diff(by_width) > 0.0)


@pytest.mark.parametrize("code", ["C112", "C115", "W120"])
def test_advice_against_whirl_names_first_what_helps_at_any_load(code):
    """At light load a larger clearance and a thinner oil bring whirl nearer."""
    remedy = explanations()[code].remedy.lower()
    helps = [
        remedy.find(word) for word in ("preload", "tilting pads", "narrower", "`method: film`") if word in remedy
    ]
    misleads = [remedy.find(word) for word in ("larger clearance", "thinner oil") if word in remedy]
    assert all(min(helps) < place for place in misleads)


def test_the_recommended_clearance_warns_of_whirl():
    assert "against whirl it can make things worse" in explanations()["C114"].remedy


@pytest.mark.parametrize(("here", "sought"), [(100.0, 995.0), (100.0, 940.0), (100.0, 11.0)])
def test_a_threshold_is_sought_up_to_ten_times_the_speed_and_down_to_a_tenth(here, sought):
    """The last step of the search ends at the bound, not before it (it ended at 9.31 times)."""
    rises = sought > here
    found = crossing(lambda speed: (sought - speed) / sought, here)
    assert found.speed == pytest.approx(sought, rel=1e-3)
    beyond = 1010.0 if rises else 9.9
    assert crossing(lambda speed: (beyond - speed) / beyond, here) == Threshold()


def test_threshold_speed_and_critical_mass_of_a_thermal_film_agree():
    light = {"thermal": "adiabatic", "accuracy": "draft", "load": "6 kN", "speed": "6000 rpm"}
    critical = answer(**light).values["critical_mass"]
    heavy, calm = (answer(**light, rotor_mass=f"{share * critical} kg").values for share in (1.01, 0.99))
    assert heavy["threshold_speed"] < heavy["angular_speed"] < calm["threshold_speed"]
    assert calm["threshold_speed"] < 1.1 * heavy["threshold_speed"]
