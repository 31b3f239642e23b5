"""The batch at the front door: the equilibria of single films, and refusals of what would be read wrongly."""

from __future__ import annotations

import math

import numpy as np
import pint
import pytest

import babbitt
from babbitt.api.batch import solve_batch
from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.lands.batch import solve_batch as solve_lands
from babbitt.reynolds.model import DRAFT, JournalFilm, grooved_bore

SPEEDS = np.array([100.0, 200.0, 400.0])
BEARING = {"diameter": 0.2, "width": 0.12, "radial_clearance": 150e-6, "viscosity": 0.02, "speed": SPEEDS}
DOWN = (0.0, -20e3)


def test_a_batch_finds_the_equilibria_of_single_films() -> None:
    found = solve_batch(**BEARING, load=DOWN, accuracy="draft")
    assert found.solved.all()
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    for row, speed in enumerate(SPEEDS):
        one = solve_journal(JournalFilm(0.2, 0.12, 150e-6, 0.02, speed, lands), DOWN, DRAFT)
        assert found.position[row] == pytest.approx(one.position, rel=1e-4, abs=1e-9)
        assert found.stiffness[row] == pytest.approx(
            one.stiffness, rel=1e-3, abs=1e-3 * np.abs(one.stiffness).max()
        )
        assert found.damping[row] == pytest.approx(one.damping, rel=1e-3, abs=1e-3 * np.abs(one.damping).max())


def test_torque_flows_and_pressure_are_those_of_single_films() -> None:
    """Of a load that points down, for which a single film is solved in the same frame."""
    found = solve_batch(**BEARING, load=DOWN)
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    for row, speed in enumerate(SPEEDS):
        one = solve_journal(JournalFilm(0.2, 0.12, 150e-6, 0.02, speed, lands), DOWN)
        assert found.position[row] == pytest.approx(one.position, rel=1e-9, abs=1e-15)
        assert found.maximum_pressure[row] == pytest.approx(one.maximum_pressure, rel=1e-9)
        assert found.friction_torque[row] == pytest.approx(one.friction_torque, rel=1e-9)
        assert found.side_flow[row] == pytest.approx(one.side_flow.sum(), rel=1e-9)
        # a film counts the grooves from that behind its first land, which is the second of these
        assert found.supply_flow[row] == pytest.approx(one.supply_flow[::-1], rel=1e-9)
        assert found.supply_flow[row].sum() == pytest.approx(found.side_flow[row], rel=1e-9)


def test_flows_follow_their_grooves() -> None:
    """Three grooves, turned by a third with the load: the columns change places."""
    angles = np.array([0.2, 0.2 + 2.0 * math.pi / 3.0, 0.2 + 4.0 * math.pi / 3.0])
    turn = 2.0 * math.pi / 3.0
    first = solve_batch(**BEARING, load=20e3, load_angle=-1.3, groove_angles=angles)
    turned = solve_batch(**BEARING, load=20e3, load_angle=-1.3 + turn, groove_angles=angles)
    assert turned.supply_flow == pytest.approx(np.roll(first.supply_flow, 1, axis=1), rel=1e-3)
    assert np.ptp(first.supply_flow, axis=1).min() > 0.1 * first.side_flow.min()
    assert turned.friction_torque == pytest.approx(first.friction_torque, rel=1e-5)


def test_petroff_torque_and_no_side_flow_of_a_light_load() -> None:
    """A centred journal shears full lands by Petroff; its film has no gradient that drives oil out."""
    light = solve_batch(**BEARING, load=(0.0, -1e-3), cavitation="reynolds", groove_extent=math.radians(10.0))
    share = 1.0 - 2.0 * 10.0 / 360.0
    petroff = 2.0 * math.pi * share * 0.02 * SPEEDS * 0.1**3 * 0.12 / 150e-6
    assert light.friction_torque == pytest.approx(petroff, rel=1e-4)
    assert (np.abs(light.side_flow) < 1e-4 * SPEEDS * 0.1 * 150e-6 * 0.12).all()


def test_a_magnitude_with_an_angle_is_a_vector() -> None:
    vector = solve_batch(**BEARING, load=DOWN, accuracy="draft")
    for load, angle in ((20e3, -math.pi / 2.0), (np.full(3, 20e3), np.full(3, -math.pi / 2.0))):
        found = solve_batch(**BEARING, load=load, load_angle=angle, accuracy="draft")
        assert found.position == pytest.approx(vector.position, rel=1e-9)
    swept = solve_batch(**BEARING, load=20e3, load_angle=[-1.6, -1.5, -1.4], accuracy="draft")
    assert swept.position.shape == (3, 2)


def test_turning_bearing_and_load_turns_the_answer() -> None:
    turn = 0.7
    upright = solve_batch(**BEARING, load=20e3, load_angle=-1.5, accuracy="draft")
    turned = solve_batch(
        **BEARING, load=20e3, load_angle=-1.5 + turn, groove_angles=(turn, turn + math.pi), accuracy="draft"
    )
    axes = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    assert turned.position == pytest.approx(upright.position @ axes.T, rel=1e-6, abs=1e-10)
    assert turned.stiffness == pytest.approx(axes @ upright.stiffness @ axes.T, rel=1e-4, abs=1e4)


@pytest.mark.parametrize(
    "load", [-20e3, [-20e3], [-20e3] * 3, [[-20e3]] * 3, [[0.0, -20e3, 0.0]] * 3, [[DOWN]] * 3]
)
def test_a_load_of_one_component_or_another_shape_is_refused(load: object) -> None:
    with pytest.raises(InputError, match="both components"):
        solve_batch(**BEARING, load=load)


def test_the_engine_refuses_a_load_of_one_component() -> None:
    """Broadcasting would have made both components of it."""
    with pytest.raises(InputError, match="both components"):
        solve_lands(0.2, 0.12, 150e-6, 0.02, SPEEDS, [[-20e3]] * 3, grooved_bore((0.0, math.pi), 0.3))


@pytest.mark.parametrize("name", ["diameter", "width", "radial_clearance", "viscosity", "speed"])
@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_sizes_that_are_no_sizes_are_refused(name: str, bad: float) -> None:
    with pytest.raises(InputError, match=f"{name} must be positive and finite"):
        solve_batch(**(BEARING | {name: [bad, 1.0, 1.0]}), load=DOWN)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"load": (math.nan, 0.0)}, "finite"),
        ({"load": -20e3, "load_angle": 0.0}, "magnitude"),
        ({"load": 20e3, "load_angle": math.nan}, "finite"),
        ({"load": [DOWN] * 3, "load_angle": 0.0}, "magnitude"),
        ({"load": [DOWN] * 2}, "speed 3, load 2"),
        ({"load": DOWN, "width": [0.1, 0.2]}, "width 2, speed 3"),
        ({"load": DOWN, "width": [[0.1, 0.1, 0.1]]}, "one axis"),
        ({"load": DOWN, "cavitation": "jfo"}, "mass_conserving, reynolds"),
        ({"load": DOWN, "cavitation": "half_sommerfeld"}, "half-Sommerfeld"),
        ({"load": DOWN, "accuracy": "fine"}, "draft, engineering, reference"),
        ({"load": DOWN, "groove_angles": ()}, "groove_angles is empty"),
        ({"load": DOWN, "groove_extent": math.nan}, "finite"),
        ({"load": DOWN, "groove_extent": 4.0}, "land"),
        ({"load": DOWN, "workers": 0}, "workers"),
    ],
)
def test_what_a_batch_cannot_do_is_refused(given: dict[str, object], says: str) -> None:
    with pytest.raises(InputError, match=says):
        solve_batch(**(BEARING | given))


def test_words_and_members_mean_the_same() -> None:
    """As text the condition was once taken for that of Reynolds."""
    from babbitt.reynolds.model import Cavitation

    named, member, other = (
        solve_batch(**BEARING, load=DOWN, accuracy="draft", cavitation=one)
        for one in ("mass_conserving", Cavitation.MASS_CONSERVING, "reynolds")
    )
    assert np.array_equal(named.stiffness, member.stiffness)
    assert not np.array_equal(named.stiffness, other.stiffness)


def test_an_unsolved_bearing_has_no_numbers() -> None:
    found = solve_batch(**BEARING, load=[DOWN, (0.0, -1e12), DOWN], accuracy="draft")
    assert found.solved.tolist() == [True, False, True]
    numbers = (found.position, found.stiffness, found.damping, found.minimum_film_thickness,
               found.maximum_pressure, found.friction_torque, found.side_flow, found.supply_flow)  # fmt: skip
    for values in numbers:
        assert np.isnan(values[1]).all()
        assert np.isfinite(values[[0, 2]]).all()


def test_workers_change_nothing_and_progress_is_told() -> None:
    told: list[tuple[int, int]] = []
    many = BEARING | {"speed": np.linspace(100.0, 400.0, 40)}
    one = solve_batch(**many, load=DOWN, accuracy="draft", workers=1, progress=lambda *done: told.append(done))
    two = solve_batch(**many, load=DOWN, accuracy="draft", workers=2)
    assert np.array_equal(one.stiffness, two.stiffness)
    assert told[-1] == (40, 40)
    assert [done for done, _ in told] == sorted(done for done, _ in told)


def test_the_batch_stands_at_the_front_door() -> None:
    assert babbitt.solve_batch is solve_batch
    assert "solve_batch" in dir(babbitt)


@pytest.mark.parametrize(
    ("argument", "given", "says"),
    [
        ("viscosity", "20 mPa s", "viscosity: a batch takes numbers in Pa s.*'20 mPa s'"),
        ("diameter", ["0.2 m", "0.3 m"], "diameter: .* in m .*'0.2 m'"),
        ("load", "10 kN", "load: .* in N "),
        ("load_angle", "-90 deg", "load_angle: .* in rad"),
        ("groove_angles", ["0 deg"], "groove_angles: .* in rad"),
        ("groove_extent", "20 deg", "groove_extent: .* in rad"),
        ("width", None, "width: .*None"),
        ("width", True, "width: .*True"),
        ("speed", [[100.0], [200.0, 300.0]], "speed: .* differ in length"),
        ("speed", pint.Quantity([1.0, 2.0], "Hz"), r"speed: .*\.to\('rad/s'\)"),
        ("load", 1j, "load: .*complex"),
        ("workers", "2", "workers is '2'"),
    ],
)
def test_what_is_no_number_is_refused_by_the_name_of_its_argument(argument, given, says) -> None:
    angled = {"load": 20e3, "load_angle": -1.3} if argument == "load_angle" else {"load": DOWN}
    with pytest.raises(InputError, match=says) as refused:
        solve_batch(**{**BEARING, **angled, argument: given})
    assert len(str(refused.value).splitlines()) == 1


def test_a_batch_is_shown_in_few_lines() -> None:
    found = solve_batch(**{**BEARING, "speed": np.linspace(100.0, 400.0, 40)}, load=DOWN, accuracy="draft")
    text = repr(found)
    assert len(text.splitlines()) == 3
    assert text.startswith("40 bearings, 40 solved")
    assert "stiffness (40, 2, 2)" in text
