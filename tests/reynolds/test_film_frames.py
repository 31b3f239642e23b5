"""A film knows no axes: turned with its load, mirrored with its speed or in another order it is the same."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.kinds.journal.film.elastic_film import ElasticFilm, elastic_film
from babbitt.reynolds.deformation.elastic_ring import ElasticRing
from babbitt.reynolds.deformation.half_space import HalfSpace
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.heat.heat_model import FilmHeat, HeatGrid
from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal
from babbitt.reynolds.model import DRAFT, FilmStart, JournalFilm, Land, Pocket, Step, grooved_bore
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.surface_solution import mirrored

TURN = 2.0 * math.pi
KINDS = ("plain", "pressure", "tilt", "pocket", "ring", "lobes", "step", "crown", "displaced")
SAME, SAME_WARM = 1e-9, 1e-6
FRESH = 318.15


def random_film(kind: str, seed: int) -> tuple[JournalFilm, tuple[float, float]]:
    """A plausible film of a kind under a load in any direction."""
    rng = np.random.default_rng([seed, KINDS.index(kind)])
    diameter = 10.0 ** rng.uniform(-1.5, -0.3)
    width, clearance = diameter * rng.uniform(0.3, 1.2), 0.5 * diameter * 10.0 ** rng.uniform(-3.2, -2.6)
    viscosity, speed = 10.0 ** rng.uniform(-2.3, -1.0), rng.choice([-1.0, 1.0]) * 10.0 ** rng.uniform(1.0, 3.0)
    wedge = viscosity * abs(speed) * (0.5 * diameter / clearance) ** 2
    first, count = rng.uniform(-3.0, 3.0), int(rng.integers(1, 4))
    angles = tuple(first + 2.0 * math.pi * k / count for k in range(count))
    pressure = wedge * 10.0 ** rng.uniform(-2.5, -1.0) if kind == "pressure" else 0.0
    film = JournalFilm(
        diameter, width, clearance, viscosity, float(speed), grooved_bore(angles, rng.uniform(0.05, 0.5), pressure)
    )
    if kind == "tilt":
        film = replace(film, misalignment=tuple(rng.uniform(-0.2, 0.2, 2) * clearance / width))
    if kind in ("pocket", "ring"):
        places = zip(
            first + 0.4 + 2.0 * np.arange(2), rng.uniform(0.1, 0.4, 2), rng.uniform(-0.2, 0.2, 2), strict=True
        )
        film = replace(film, pockets=tuple(
            Pocket(at, extent, 0.3 * width, off * width, 0.05 * wedge) for at, extent, off in places
        ))  # fmt: skip
    if kind == "ring":
        film = replace(film, lands=(Land(first, first + 2.0 * math.pi),), film_start=FilmStart.PERIODIC)
    if kind == "lobes":
        lands = tuple(
            replace(land, clearance=1.4 * clearance, centre=(-0.4 * clearance * math.cos(middle),
                                                             -0.4 * clearance * math.sin(middle)))
            for land in film.lands
            for middle in [0.5 * (land.start_angle + land.end_angle)]
        )  # fmt: skip
        film = replace(film, lands=lands)
    if kind == "step":
        film = replace(film, steps=(Step(first + 1.5, 0.6, 0.5 * width, 0.5 * clearance),))
    if kind == "crown":
        film = replace(film, crowning=tuple(rng.uniform(0.0, 0.2, 3) * clearance))
    if kind == "displaced":
        field = tuple(map(tuple, (rng.uniform(-0.1, 0.1, (12, 3)) * clearance).tolist()))
        film = replace(film, displacement=field, field_start=first)
    load, towards = 10.0 ** rng.uniform(-1.5, 0.5) * wedge * width * 0.5 * diameter, rng.uniform(-3.0, 3.0)
    return film, (load * math.cos(towards), load * math.sin(towards))


def turned(film: JournalFilm, load: tuple[float, float], angle: float) -> tuple[JournalFilm, tuple[float, float]]:
    """The bearing and its load, turned."""
    c, s = math.cos(angle), math.sin(angle)

    def vector(one: tuple[float, float]) -> tuple[float, float]:
        return c * one[0] - s * one[1], s * one[0] + c * one[1]

    lands = tuple(
        replace(
            one, start_angle=one.start_angle + angle, end_angle=one.end_angle + angle, centre=vector(one.centre)
        )
        for one in film.lands
    )
    return replace(
        film,
        lands=lands,
        pockets=tuple(replace(one, centre_angle=one.centre_angle + angle) for one in film.pockets),
        steps=tuple(replace(one, centre_angle=one.centre_angle + angle) for one in film.steps),
        misalignment=vector(film.misalignment),
        field_start=film.field_start + angle,
    ), vector(load)


def differences(one: FilmSolution, other: FilmSolution, turn: np.ndarray) -> dict[str, float]:
    """Of everything but angles, each over its own size; ``other`` is seen through ``turn``."""

    def off(there: np.ndarray | float, here: np.ndarray | float) -> float:
        return float(np.linalg.norm(np.asarray(there) - here) / max(np.linalg.norm(here), 1e-300))

    def supplies(film: FilmSolution) -> np.ndarray:
        return np.sort(film.supply_flow)

    return {
        "position": float(np.linalg.norm(turn.T @ other.position - one.position) / one.film.clearance),
        "gap": off(other.minimum_film_thickness, one.minimum_film_thickness),
        "stiffness": off(turn.T @ other.stiffness @ turn, one.stiffness),
        "damping": off(turn.T @ other.damping @ turn, one.damping),
        "torque": off(other.friction_torque, one.friction_torque),
        "sides": off(other.end_flows.sum(), one.end_flows.sum()),
        "supplies": off(supplies(other), supplies(one)),
        "pressure": off(other.maximum_pressure, one.maximum_pressure),
    }


def rotation(angle: float) -> np.ndarray:
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


@pytest.mark.parametrize("kind", KINDS)
def test_a_turned_bearing_is_the_same(kind: str) -> None:
    for seed in range(4):
        film, load = random_film(kind, seed)
        found = solve_journal(film, load, DRAFT)
        for angle in (-0.5 * math.pi, 0.3 + 0.7 * seed):
            other = solve_journal(*turned(film, load, angle), DRAFT)
            assert other.outcome is found.outcome
            off = differences(found, other, rotation(angle))
            assert max(off.values()) < SAME, (kind, seed, angle, off)


@pytest.mark.parametrize("kind", KINDS)
def test_a_bearing_in_the_mirror_is_the_same(kind: str) -> None:
    """theta -> -theta turns the journal the other way round."""
    for seed in range(4):
        film, load = random_film(kind, seed)
        found, other = solve_journal(film, load, DRAFT), solve_journal(mirrored(film), (load[0], -load[1]), DRAFT)
        assert other.outcome is found.outcome
        off = differences(found, other, np.diag([1.0, -1.0]))
        assert max(off.values()) < SAME, (kind, seed, off)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(8))
def test_images_are_solved_as_one_film(kind: str, seed: int) -> None:
    """What is solved has the same digits: no search takes another way for the last of them."""
    film, load = random_film(kind, seed)
    frame, image = LoadFrame.of(film, load), LoadFrame.of(mirrored(film), (load[0], -load[1]))
    ahead, behind = (frame, image) if film.angular_speed > 0.0 else (image, frame)
    assert mirrored(behind.film) == ahead.film
    assert behind.load == (ahead.load[0], -ahead.load[1])


@pytest.mark.parametrize("rows", [1, 5, 11])
@pytest.mark.parametrize("seed", range(4))
def test_a_table_of_the_bore_may_begin_at_any_of_its_rows(rows: int, seed: int) -> None:
    film, load = random_film("displaced", seed)
    other = replace(
        film,
        displacement=(*film.displacement[rows:], *film.displacement[:rows]),
        field_start=film.field_start + rows * TURN / len(film.displacement),
    )
    assert LoadFrame.of(other, load).film == LoadFrame.of(film, load).film


@pytest.mark.parametrize("turns", [-2, 1])
def test_a_whole_turn_more_is_the_same_film(turns: int) -> None:
    film, load = random_film("pressure", 3)
    lands = tuple(
        replace(land, start_angle=land.start_angle + turns * TURN, end_angle=land.end_angle + turns * TURN)
        for land in film.lands
    )
    assert LoadFrame.of(replace(film, lands=lands), load).film == LoadFrame.of(film, load).film


@pytest.mark.parametrize("kind", KINDS)
def test_the_order_of_lands_and_pockets_does_not_matter(kind: str) -> None:
    for seed in range(3):
        film, load = random_film(kind, seed)
        other = solve_journal(replace(film, lands=film.lands[::-1], pockets=film.pockets[::-1]), load, DRAFT)
        found = solve_journal(film, load, DRAFT)
        assert other.outcome is found.outcome
        off = differences(found, other, np.eye(2))
        assert max(off.values()) < SAME, (kind, seed, off)


@pytest.mark.parametrize("housing", ["ring", "half-space"])
def test_a_turned_elastic_bore_is_the_same(housing: str) -> None:
    """Film and displacement settle beside each other on places that are laid from the load."""
    film, load = random_film("plain", 1)
    inner = 0.5 * film.diameter
    thin = 5.0 * load_pressure(film, load) * inner / film.clearance  # the bore gives way by part of the clearance
    house = ElasticRing(inner, 1.5 * inner, 5.0 * thin, 0.3) if housing == "ring" else HalfSpace(thin, 0.3)

    def settled(film: JournalFilm, load: tuple[float, float]) -> ElasticFilm[FilmSolution]:
        laid = replace(film, field_start=math.atan2(load[1], load[0]))
        return elastic_film(laid, [house], lambda one: solve_journal(one, load, DRAFT), 1e-5)

    found = settled(film, load)
    assert found.outcome.solved
    assert np.abs(found.displacement).max() > 0.05 * film.clearance
    seen = {
        "turned": (turned(film, load, 1.1), rotation(1.1)),
        "mirrored": ((mirrored(film), (load[0], -load[1])), np.diag([1.0, -1.0])),
    }
    for name, (given, turn) in seen.items():
        other = settled(*given)
        off = differences(found.solution, other.solution, turn)
        assert max(off.values()) < SAME, (name, off)
        assert np.abs(other.displacement).max() == pytest.approx(np.abs(found.displacement).max(), rel=SAME), name


def load_pressure(film: JournalFilm, load: tuple[float, float]) -> float:
    return math.hypot(*load) / (film.diameter * film.width)


def viscosity_of(ambient: float):
    return lambda temperature: ambient * np.exp(-0.03 * (np.asarray(temperature) - FRESH))


@pytest.mark.parametrize("kind", ["plain", "pocket", "tilt"])
def test_a_turned_thermal_film_is_the_same(kind: str) -> None:
    film, load = random_film(kind, 0)
    heat = FilmHeat(viscosity_of(film.viscosity), 1.7e6, 0.13, FRESH, None, HeatGrid())
    found = solve_thermal_journal(film, heat, load, DRAFT)
    angle = 1.1
    other = solve_thermal_journal(*turned(film, load, angle)[:1], heat, turned(film, load, angle)[1], DRAFT)
    assert other.film.outcome is found.film.outcome
    off = differences(found.film, other.film, rotation(angle))
    assert max(off.values()) < SAME_WARM, off
    warmth = found.maximum_temperature - FRESH
    assert other.maximum_temperature - FRESH == pytest.approx(warmth, rel=SAME_WARM)
    assert np.sort(other.groove_temperatures) == pytest.approx(np.sort(found.groove_temperatures), rel=SAME_WARM)


def test_supplies_keep_their_places() -> None:
    """Flows come in the order of the bearing as given, whatever land comes first after the turn."""
    film, load = random_film("pressure", 1)
    pressures = [1.0, 2.0, 3.0][: len(film.lands)]
    grooves = len(film.lands)
    order = film.land_order
    lands = list(film.lands)
    for place, number in enumerate(order):  # every groove its own pressure
        before = order[(place - 1) % grooves]
        lands[number] = replace(lands[number], start_pressure=pressures[place] * lands[number].start_pressure)
        lands[before] = replace(lands[before], end_pressure=lands[number].start_pressure)
    film = replace(film, lands=tuple(lands))
    found = solve_journal(film, load, DRAFT)
    for angle in (1.0, 2.5, -2.0):
        other, push = turned(film, load, angle)
        flows = solve_journal(other, push, DRAFT).supply_flow
        shift = [other.land_order.index(number) for number in film.land_order]
        assert flows[shift] == pytest.approx(found.supply_flow, rel=SAME)


def test_a_round_bore_stays_round_in_its_frame() -> None:
    """Lands that have the clearance of the film, whose digits are cut, have the cut one."""
    clearance = 0.0001547941399812180323
    lands = tuple(replace(land, clearance=clearance) for land in grooved_bore((0.3, 3.4), 0.2))
    film = JournalFilm(0.2, 0.12, clearance, 0.02, 100.0, lands)
    framed = LoadFrame.of(film, (1e3, -2e4)).film
    assert framed.clearance != clearance
    assert framed.is_round


def test_a_frame_points_the_load_down() -> None:
    film, load = random_film("tilt", 2)
    frame = LoadFrame.of(film, load)
    seen = mirrored(frame.film) if film.angular_speed < 0.0 else frame.film
    down = math.copysign(1.0, film.angular_speed)
    assert frame.load == pytest.approx((0.0, -down * math.hypot(*load)))
    assert seen.angular_speed > 0.0
