"""Several equilibria: mirror images where symmetry makes them, one and only one where it must be."""

import math
from dataclasses import replace

import numpy as np
import pytest
from film_bearings import answer, film

from babbitt.core.notices import Effect, explanations
from babbitt.kinds.journal.film.bore import Arc, LobedBore
from babbitt.kinds.journal.film.elastic_film import displacement_under
from babbitt.kinds.journal.film.equilibria import EquilibriumPoint, EquilibriumPoints, find_equilibria
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.other_equilibria import (
    equilibrium_points,
    equilibrium_values,
    warnings_about_equilibria,
)
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import (
    DRAFT,
    ENGINEERING,
    Cavitation,
    FilmStart,
    JournalFilm,
    Land,
    Pocket,
    grooved_bore,
)
from babbitt.reynolds.stability.rotor import growth_rates
from babbitt.reynolds.stability.routh import StableMasses

VERTICAL = (-math.pi / 2.0, math.pi / 2.0)
SLOW = JournalFilm(0.2, 0.12, 150e-6, 0.02, 10.0, grooved_bore(VERTICAL, 0.35, 5e5), Cavitation.REYNOLDS)
"""Two opposite grooves under a pressure that outweighs the wedge."""

FAST = replace(SLOW, angular_speed=314.0, lands=grooved_bore((0.0, math.pi), 0.35, 1e5))


def lobes(preload, offset=0.5):
    return tuple(
        LobedBore(preload, offset).shaped(Arc(start + 0.175, start + math.pi - 0.175, 150e-6, (1e5, 1e5), 1.0))
        for start in (0.0, math.pi)
    )


@pytest.mark.parametrize("cavitation", [Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING])
def test_a_bearing_that_is_its_own_image_after_half_a_turn_has_image_equilibria(cavitation):
    # without load nothing tells one place from its image; the centre is a saddle
    found = find_equilibria(replace(SLOW, cavitation=cavitation), (0.0, 0.0), ENGINEERING)
    assert found.complete
    assert sorted(place.index for place in found.places) == [-1, 1, 1]
    (centre,) = [place for place in found.places if place.index < 0]
    assert math.hypot(*centre.position) < 1e-4 * SLOW.clearance
    assert not centre.holds
    one, other = [place for place in found.places if place.index > 0]
    np.testing.assert_allclose(one.position, -np.array(other.position), atol=1e-3 * SLOW.clearance)
    assert one.film.eccentricity_ratio > 0.2


def test_every_place_is_an_equilibrium():
    load, slower = (0.0, -100.0), replace(SLOW, angular_speed=3.0)
    found = find_equilibria(slower, load, ENGINEERING)
    assert found.complete
    assert len(found.places) == 3
    for place in found.places:
        film = film_at_position(slower, place.position)
        gap = np.linalg.solve(film.stiffness, film.force + np.array(load))
        assert math.hypot(*gap) < 1e-3 * SLOW.clearance


def test_the_wedge_outweighs_the_supply_in_a_fast_bearing():
    assert len(find_equilibria(replace(SLOW, angular_speed=314.0), (0.0, 0.0)).places) == 1


@pytest.mark.parametrize(
    "film",
    [
        FAST,
        replace(FAST, cavitation=Cavitation.MASS_CONSERVING),
        replace(FAST, lands=lobes(0.5)),
        replace(FAST, lands=lobes(0.8)),
        replace(FAST, lands=lobes(0.5, 1.0)),
        replace(FAST, lands=(Land(0.0, 2.0 * math.pi),), film_start=FilmStart.WIDEST_GAP),
    ],
    ids=["grooved", "conserving", "lemon", "slender lemon", "offset halves", "widest gap"],
)
@pytest.mark.parametrize("load", [(0.0, -200.0), (0.0, -3e4), (2e4, 0.0)])
def test_ordinary_bearings_have_one_equilibrium(film, load):
    rest = solve_journal(film, load, ENGINEERING)
    found = find_equilibria(film, load, ENGINEERING)
    assert found.complete
    (place,) = found.places
    # found from another side, on lines graded for another coarse film: 3e-5 at most (7e-4 on a draft grid)
    np.testing.assert_allclose(place.position, rest.position, atol=6e-5 * film.clearance)
    again = find_equilibria(film, load, ENGINEERING, (rest,))
    assert [one.film for one in again.places] == [rest]


def test_pockets_under_pressure_are_like_grooves():
    pockets = tuple(Pocket(angle, 0.6, 0.08, pressure=5e5) for angle in VERTICAL)
    ring = replace(
        SLOW, lands=(Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC, pockets=pockets, angular_speed=10.0
    )
    found = find_equilibria(ring, (0.0, 0.0))
    assert found.complete
    assert len(found.places) == 3


SLOW_CASE = {
    "grooves": [{"angle": "90 deg", "extent": "20 deg"}, {"angle": "-90 deg", "extent": "20 deg"}],
    "supply": {"temperature": "45 degC", "pressure": "0.5 MPa"},
    "load": "150 N",
    "speed": "60 rpm",
    "effective_temperature": "50 degC",
}


def test_places_of_which_one_is_missing_have_no_verdict():
    """The indices of all places sum to one: two that hold leave out the one between them."""
    found = find_equilibria(SLOW, (0.0, 0.0))
    held = tuple(place for place in found.places if place.index == 1)
    assert found.complete
    assert len(held) == 2
    shown = held[0].film
    assert "W134" not in {notice.code for notice in warnings_about_equilibria(shown, found)}
    assert "W134" in {notice.code for notice in warnings_about_equilibria(shown, EquilibriumPoints(held))}
    assert explanations()["W134"].effect is Effect.NO_VERDICT


def test_a_thinner_film_where_only_a_heavy_journal_stays_is_held_against_the_limits():
    shown, other = (place.film for place in find_equilibria(SLOW, (0.0, 0.0)).places if place.index == 1)
    k, c = np.diag([2e8, 4e8]), np.array([[1e6, 2e6], [2e6, 1e6]])
    thin = 0.5 * shown.minimum_film_thickness
    heavy = EquilibriumPoint(replace(other, stiffness=k, damping=c, minimum_film_thickness=thin))
    assert heavy.stable_masses == StableMasses(pytest.approx(9e4), math.inf)
    assert growth_rates([8e4, 1e5], k, c)[1] < 0.0 < growth_rates([8e4, 1e5], k, c)[0]
    assert equilibrium_values(EquilibriumPoints((EquilibriumPoint(shown), heavy)))["least_resting_film"] == thin
    never = EquilibriumPoint(replace(heavy.film, damping=-c))
    assert "least_resting_film" not in equilibrium_values(EquilibriumPoints((EquilibriumPoint(shown), never)))


def test_a_saddle_is_not_shown_and_the_other_places_are_named():
    result = answer(**SLOW_CASE)
    (told,) = [notice for notice in result.warnings if notice.code == "W131"]
    assert result.equilibria == 3
    assert told.message.startswith("2 in addition to the one shown")
    assert told.message.count("e/c =") == 2
    assert not any(notice.code == "W132" for notice in result.warnings)
    assert np.linalg.det(result.arrays["stiffness"]) > 0.0
    assert "it never stays" in told.message
    first = answer(**SLOW_CASE, equilibria="first")
    assert "equilibria" not in first.values
    assert np.linalg.det(first.arrays["stiffness"]) < 0.0
    assert [notice.code for notice in first.warnings if notice.code.startswith("W13")] == ["W132"]
    assert first.eccentricity_ratio == pytest.approx(float(told.message.split("e/c = ")[1][:5]), abs=5e-4)
    assert answer(bore={"kind": "lobes", "preload": 0.5}).equilibria == 1
    assert "equilibria" not in answer().values  # a fast bearing with little supply pressure
    assert answer(equilibria="all").equilibria == 1


def test_the_heat_balance_closes_where_the_journal_stays():
    given = SLOW_CASE | {"effective_temperature": None, "speed": "30 rpm"}
    result = answer(**given)
    assert result.equilibria == 3
    assert np.linalg.det(result.arrays["stiffness"]) > 0.0
    assert abs(result.energy_balance_error) < 1e-6


SADDLE = {
    "diameter": "100 mm",
    "width": "60 mm",
    "clearance": {"kind": "relative", "mean": "1.2 permille"},
    "grooves": None,
    "pockets": [
        {"angle": "0 deg", "extent": "20 deg", "width": "50 mm"},
        {"angle": "180 deg", "extent": "20 deg", "width": "50 mm"},
    ],
    "supply": {"temperature": "45 degC", "pressure": "3 MPa"},
    "effective_temperature": "60 degC",
    "load": "0.3 kN",
    "load_angle": "90 deg",
    "speed": "200 rpm",
}
"""Two pockets whose pressure outweighs load and wedge."""


@pytest.mark.parametrize("sought", ["auto", "all"])
def test_the_thinnest_of_the_places_of_rest_is_judged(sought):
    result = answer(**SADDLE, equilibria=sought)
    assert result.equilibria == 3
    assert result.minimum_film_thickness == pytest.approx(4.47e-6, rel=0.02)
    (check,) = [check for check in result.checks if check.code == "C101"]
    assert not check.ok


def test_a_saddle_keeps_no_limit_of_the_film():
    result = answer(**SADDLE, equilibria="first")
    assert np.linalg.det(result.arrays["stiffness"]) < 0.0
    assert "C101" not in {check.code for check in result.checks}
    assert "C101" in {notice.code for notice in result.not_checked}
    assert result.verdict.value == "no verdict"


def test_a_thinner_film_elsewhere_is_held_against_the_limit():
    # turned by half a turn the bearing is its own image: a little load makes one of two places the thinner
    found = [
        answer(**SADDLE | {"load_angle": angle}, equilibria="all") for angle in ("90 deg", "0 deg", "-30 deg")
    ]
    for result in found:
        films = [result.minimum_film_thickness, result.values.get("least_resting_film", math.inf)]
        assert all(check.value == min(films) for check in result.checks if check.code == "C101" and not check.ok)


@pytest.mark.parametrize(
    "answers",
    [
        {
            "compliance": [
                {"kind": "column", "thickness": "2 mm", "elastic_modulus": "3 GPa", "poisson_ratio": 0.35}
            ]
        },
        {"holes": [{"angle": "-60 deg", "diameter": "6 mm", "flow": "0 L/min"}]},
    ],
    ids=["soft", "closed"],
)
def test_every_place_settles_beside_its_own_bore_and_supplies(answers):
    one = film(**SADDLE | answers, equilibria="all")
    state = operating_film(one).film
    places = equilibrium_points(one, state).places
    assert len(places) > 1
    load = np.array([0.0, 300.0])
    for place in places:
        found = place.film
        assert math.hypot(*(found.force + load)) < 0.02 * 300.0
        if one.bearing.compliance:
            own = displacement_under(one.bearing.compliance, found)
            given = np.asarray(found.film.displacement)
            assert np.abs(own - given).max() < 1e-4 * found.minimum_film_thickness
        else:
            assert abs(found.supply_flow[-1]) < 1e-6 * found.leaving_flow


def random_film(rng):
    """A bearing with one to three grooves or pockets whose pressure rivals that of the wedge, and a load."""
    angles = rng.uniform(0.0, math.tau) + np.arange(count := int(rng.integers(1, 4))) * math.tau / count
    pressure, speed = 10.0 ** rng.uniform(5.0, 6.8), 10.0 ** rng.uniform(0.5, 2.5)
    cavitation = rng.choice([Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS])
    one = JournalFilm(
        0.1, 0.06, 60e-6, 0.017, speed, grooved_bore(tuple(map(float, angles)), 0.35, pressure), cavitation
    )
    if rng.random() < 0.5:
        pockets = tuple(Pocket(float(angle % math.tau), 0.35, 0.05, pressure=pressure) for angle in angles)
        one = replace(one, lands=(Land(0.0, math.tau),), film_start=FilmStart.PERIODIC, pockets=pockets)
    size, direction = 10.0 ** rng.uniform(1.5, 4.0), rng.uniform(0.0, math.tau)
    return one, (float(size * math.cos(direction)), float(size * math.sin(direction)))


@pytest.mark.thorough
def test_the_indices_of_random_pressurised_films_sum_to_one():
    """All but one of sixteen: beside a groove in which the journal would sink the last place is nearer to contact
    than the search looks."""
    rng = np.random.default_rng(4)
    several = missed = 0
    for _ in range(16):
        one, load = random_film(rng)
        rest = solve_journal(one, load, DRAFT)
        if not rest.outcome.solved:
            continue
        found = find_equilibria(one, load, DRAFT, (rest,))
        missed += not found.complete
        several += len(found.places) > 1
        for place in found.places:
            assert math.hypot(*(place.film.force + load)) < 0.02 * math.hypot(*load)
    assert missed <= 1
    assert several >= 2
