"""Many bearings of one layout: those of single solutions, and how they scatter."""

from __future__ import annotations

import math

import numpy as np
import pint
import pytest
from pad_journals import HEATED, OIL, pad_case, result_of

import babbitt
from babbitt.api.pad_batch import solve_pad_batch
from babbitt.case import case_from_dict
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.kinds.tilting_pad_journal.batch import solve_pad_batch as solve_cases
from babbitt.kinds.tilting_pad_journal.case.build import pad_cases

ROTOR = {"rotor_mass": "1020 kg", "shaft_stiffness": "150 MN/m"}
ISOTHERMAL = {"thermal": "isothermal"} | ROTOR


def bearing(changes=None, **fields):
    """The bearing of Fillon as a program reads it."""
    return case_from_dict(pad_case(changes, **fields))


def scatter(count, seed=1):
    """Machined clearances, m, and preloads."""
    rng = np.random.default_rng(seed)
    return rng.uniform(140e-6, 156e-6, count), rng.uniform(0.42, 0.52, count)


@pytest.mark.parametrize("model", ["isothermal", "global", "A", "C", "E"])
def test_a_batch_gives_the_numbers_of_single_bearings(model: str) -> None:
    """To round-off: of the clearance, which a case halves, and of what it moves."""
    fields = HEATED.get(model, {"thermal": model}) | ROTOR
    clearances, preloads = scatter(3)
    found = solve_pad_batch(bearing(**fields), clearance=clearances, preload=preloads)
    assert found.solved.all()
    for row, (clearance, preload) in enumerate(zip(clearances, preloads, strict=True)):
        changes = {
            "pads.clearance": {"kind": "radial", "mean": f"{float(clearance)!r} m"},
            "pads.preload": float(preload),
        }
        one = result_of(changes, **fields)
        for name in ("eccentricity_ratio", "minimum_film_thickness", "maximum_pressure", "friction_power",
                     "total_flow", "effective_temperature", "log_decrement"):  # fmt: skip
            assert getattr(found, name)[row] == pytest.approx(one.values[name], rel=1e-9), name
        for name in ("stiffness", "damping"):
            exact = np.array(one.arrays[name])
            assert getattr(found, name)[row] == pytest.approx(exact, rel=1e-9, abs=1e-9 * np.abs(exact).max())
        assert found.pad_load[row] == pytest.approx(np.array(one.arrays["pad_load"][0]), rel=1e-9)
        hottest = one.values.get("maximum_temperature", math.nan)
        assert found.maximum_temperature[row] == pytest.approx(hottest, rel=1e-9, nan_ok=True)


GIVEN = {
    "pads.clearance": {"kind": "radial", "mean": "148 um"},
    "pads.assembled_clearance": {"kind": "radial", "mean": "78.44 um"},
    "pads.preload": 0.47,
}
OTHER = {"clearance": 151e-6, "assembled_clearance": 80e-6, "preload": 0.45}


@pytest.mark.parametrize("left_out", OTHER)
@pytest.mark.parametrize("varied", OTHER)
def test_one_alone_holds_what_the_case_gives_besides_as_a_sweep_does(varied: str, left_out: str) -> None:
    """Of two that are given the other one stays; the one that follows varied holds the machined clearance."""
    fields = pad_case(GIVEN | {f"pads.{left_out}": None}, **ISOTHERMAL)
    case = case_from_dict(fields)
    found = solve_pad_batch(case, **{varied: [OTHER[varied]]})
    if varied == left_out:
        held = {"clearance": {"preload": 0.47}}.get(varied, {"clearance": 148e-6})
        same = solve_pad_batch(case, **{varied: [OTHER[varied]]}, **held)
        assert found.stiffness == pytest.approx(same.stiffness, rel=1e-9, abs=1.0)
        return
    path = f"pads.{varied}" if varied == "preload" else f"pads.{varied}.mean"
    own = babbitt.TiltingPadBearing(**{key: value for key, value in fields.items() if key != "kind"})
    (swept,) = own.sweep({path: [OTHER[varied]]}).results
    for name in ("minimum_film_thickness", "friction_power", "stiffness_yy"):
        value = found.stiffness[0, 1, 1] if name == "stiffness_yy" else getattr(found, name)[0]
        assert value == pytest.approx(swept.values[name], rel=1e-9), name


def test_threads_do_not_change_a_bit() -> None:
    clearances, preloads = scatter(6)
    one, two = (
        solve_pad_batch(bearing(**ISOTHERMAL), clearance=clearances, preload=preloads, workers=count)
        for count in (1, 2)
    )
    for name in ("position", "stiffness", "damping", "log_decrement", "pad_load"):
        assert getattr(one, name).tobytes() == getattr(two, name).tobytes()


def test_films_of_one_shape_follow_their_scales() -> None:
    """Load over mu omega (R/c)^2 kept, c K/W and c omega C/W do not change, whatever load, speed and clearance.

    The radius of the bore, R + c, enters the lever of the tilt alone, which no free pad feels."""
    oil = {"lubricant": OIL, "thermal": "isothermal"}
    clearance = np.array([148e-6, 74e-6, 296e-6])
    speed = np.array([400.0, 200.0, 1600.0])
    load = 10e3 * speed / 400.0 * (148e-6 / clearance) ** 2
    found = solve_pad_batch(bearing(**oil), clearance=clearance, load=load, speed=speed)
    scaled = found.stiffness * (clearance / load)[:, None, None]
    moving = found.damping * (clearance * speed / load)[:, None, None]
    for row in (1, 2):
        assert scaled[row] == pytest.approx(scaled[0], rel=1e-9, abs=1e-9)
        assert moving[row] == pytest.approx(moving[0], rel=1e-9, abs=1e-9)
    assert found.eccentricity_ratio == pytest.approx(found.eccentricity_ratio[0], rel=1e-9)
    assert found.maximum_pressure == pytest.approx(found.maximum_pressure[0] * load / load[0], rel=1e-9)


def test_each_pad_may_have_its_own_clearance() -> None:
    """The wider of two lower pads carries less: the journal moves towards it."""
    assembled = np.array([[78.4e-6] * 4, [78.4e-6, 78.4e-6, 78.4e-6, 90e-6]])
    found = solve_pad_batch(bearing(**ISOTHERMAL), assembled_clearance=assembled)
    assert found.position[0, 0] == pytest.approx(0.0, abs=1e-10)
    assert found.position[1, 0] > 5e-6
    assert found.pad_load[1, 3] < found.pad_load[1, 2]


def test_two_clearances_say_the_third() -> None:
    """Preload and each clearance, and what of the bearing stays with one alone."""
    case = bearing(**ISOTHERMAL)
    gap, own = 80e-6, 80e-6 / 0.5
    by = [
        solve_pad_batch(case, clearance=own, preload=0.5),
        solve_pad_batch(case, assembled_clearance=gap, preload=0.5),
        solve_pad_batch(case, clearance=own, assembled_clearance=gap),
    ]
    for one in by[1:]:
        assert one.stiffness == pytest.approx(by[0].stiffness, rel=1e-9, abs=1.0)
    alone = solve_pad_batch(case, preload=0.47), solve_pad_batch(case, clearance=148e-6), solve_pad_batch(case)
    for one in alone[1:]:
        assert one.stiffness == pytest.approx(alone[0].stiffness, rel=1e-9, abs=1.0)


def test_an_unsolved_bearing_says_why_and_has_no_numbers() -> None:
    """One load in three is more than any film bears."""
    fields = {"thermal": "isothermal", "pads.pivot": {"kind": "spring", "stiffness": "1 MN/m"}}
    case = bearing({"pads.pivot": fields.pop("pads.pivot")}, **fields)
    found = solve_pad_batch(case, load=[10e3, 1e12, 10e3])
    assert list(found.solved) == [True, False, True]
    assert not found.outcomes[1].solved
    assert isinstance(found.outcomes[1], Outcome)
    assert np.isnan(found.stiffness[1]).all()
    assert np.isnan(found.log_decrement).all()
    band = found.band("stiffness")
    assert band.count == 2
    assert np.isfinite(band.mean).all()


def test_pads_that_starve_are_not_solved() -> None:
    """The sides of the pads let more go than is supplied; with twice as much the same films are found."""
    case = bearing(**ISOTHERMAL)
    side = result_of(**ISOTHERMAL).values["side_flow"]
    for share, starved in ((0.9, True), (2.0, False)):
        fed = bearing({"supply.flow": f"{share * side!r} m3/s"}, **ISOTHERMAL)
        found = solve_pad_batch(fed, preload=[0.47])
        assert found.starved[0] == starved
        assert found.solved[0] != starved
        assert found.outcomes[0] is Outcome.CONVERGED
    assert found.stiffness == pytest.approx(solve_pad_batch(case).stiffness, rel=1e-12)


def test_bands_hold_the_shares_that_they_name() -> None:
    clearances, preloads = scatter(40)
    found = solve_pad_batch(bearing(**ISOTHERMAL), clearance=clearances, preload=preloads)
    band = found.band("log_decrement")
    below, above = (found.log_decrement < band.low).sum(), (found.log_decrement > band.high).sum()
    assert (below, above, band.count) == (2, 2, 40)
    assert band.mean == pytest.approx(found.log_decrement.mean())
    matrix = found.band("stiffness", 0.0, 1.0)
    assert (matrix.low <= matrix.mean).all()
    assert (matrix.high == found.stiffness.max(axis=0)).all()


def test_a_clockwise_journal_is_the_mirror_image() -> None:
    """Of this symmetric bearing: x turns over, and with it the cross terms."""
    fields = ISOTHERMAL | {"load_angle": "-80 deg"}
    forth = solve_pad_batch(bearing(**fields), speed=[300.0, 419.0])
    back = solve_pad_batch(
        bearing(**fields | {"speed": "-4000 rpm", "load_angle": "-100 deg"}), speed=[300.0, 419.0]
    )
    mirror = np.array([-1.0, 1.0])
    assert back.position == pytest.approx(forth.position * mirror, rel=1e-8, abs=1e-12)
    assert back.stiffness == pytest.approx(forth.stiffness * np.outer(mirror, mirror), rel=1e-6, abs=1e2)
    assert back.log_decrement == pytest.approx(forth.log_decrement, rel=1e-8)


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"clearance": -1e-6}, "clearance must be positive"),
        ({"clearance": "150 um"}, "clearance: a batch takes numbers in m"),
        ({"clearance": pint.Quantity(150e-6, "m")}, "not quantities"),
        ({"clearance": [[1e-4, 1e-4]]}, "second axis are the 4 pads"),
        ({"clearance": 1e-4, "preload": 0.1, "assembled_clearance": 9e-5}, "third follows"),
        ({"preload": 1.0}, "preload must be -0.5 to below 1"),
        ({"preload": math.nan}, "preload must be"),
        ({"assembled_clearance": 1e-3}, "preload below -0.5"),
        ({"load": -1.0}, "load must be positive"),
        ({"speed": [1.0, -1.0]}, "sense of rotation is that of the case"),
        ({"speed": [1.0, 2.0], "preload": [0.1, 0.2, 0.3]}, "numbers of bearings differ"),
        ({"workers": 0}, "workers"),
    ],
)
def test_what_a_batch_cannot_do_is_refused(given: dict[str, object], says: str) -> None:
    with pytest.raises(InputError, match=says):
        solve_pad_batch(bearing(**ISOTHERMAL), **given)


def test_a_load_where_the_position_is_given_is_refused() -> None:
    placed = bearing({"load": None}, **ISOTHERMAL, position={"x": "0 um", "y": "-30 um"})
    with pytest.raises(InputError, match="prescribes the position"):
        solve_pad_batch(placed, load=1e3)


def test_several_points_and_other_things_are_refused() -> None:
    points = bearing(**ISOTHERMAL, operating_points=[{"name": "a"}, {"name": "b", "load": "5 kN"}])
    with pytest.raises(InputError, match="2 operating points"):
        solve_pad_batch(points)
    with pytest.raises(InputError, match="give a TiltingPadBearing"):
        solve_pad_batch(0.1)
    with pytest.raises(InputError, match="no band"):
        solve_pad_batch(bearing(**ISOTHERMAL)).band("outcomes")
    with pytest.raises(InputError, match="low < high"):
        solve_pad_batch(bearing(**ISOTHERMAL)).band("stiffness", 0.5, 0.5)


def test_the_door_takes_problems_without_the_case_language() -> None:
    case = bearing(**ISOTHERMAL)
    (problem,) = pad_cases(case)
    told: list[tuple[int, int]] = []
    direct = solve_cases(problem, preload=[0.4, 0.5], progress=lambda *done: told.append(done))
    assert told == [(1, 2), (2, 2)]
    for given in (problem, case):
        assert solve_pad_batch(given, preload=[0.4, 0.5]).stiffness.tobytes() == direct.stiffness.tobytes()
    assert babbitt.solve_pad_batch is solve_pad_batch
    assert "2 bearings, 2 solved" in repr(direct)
