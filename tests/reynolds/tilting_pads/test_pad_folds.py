"""Pads that unload: folds, pads at their limits on rigid and elastic pivots, how a search ends."""

import math

import numpy as np
import pytest
from scaled_pads import FOUR_LOAD, LEVER, bearing, directed, four_pads, one_pad, pad

from babbitt.core.result import Outcome
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads._pads import WORK, find_pads, journal_step
from babbitt.reynolds.tilting_pads._place import new_places
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, MOST_FILMS, NOT_FOUND
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales, kernel_pads
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import LineContact, PointContact, RigidPivot, SpringPivot, stiffness_of
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import (
    fold_of,
    no_total,
    solve_tilting_pads,
    tilting_pads_at,
)

GRID = Resolution(4, 96)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_a_pad_that_would_have_to_carry_less_than_it_can(share):
    chosen = bearing((pad(angle, 70.0, 0.55, 0.0) for angle in (-90, 30, 150)), 0.7)
    last = chosen.pads[2].normal()
    fold = fold_of(chosen, 2, GRID)
    assert fold.load > 0.0
    x = 0.1  # on the line where the last pad is just unloaded
    y = (fold.eccentricity_ratio - 1e-5 - x * last[0]) / last[1]
    others = tilting_pads_at(chosen, (x, y), GRID)
    assert [state.status for state in others.pads] == [PadStatus.LOADED, PadStatus.LOADED, PadStatus.UNLOADED]
    load = -(others.force - share * fold.load * last)
    found = solve_tilting_pads(chosen, tuple(load), GRID)
    assert found.outcome is Outcome.PAD_AT_LIMIT
    assert found.outcome.code == "S401"
    assert found.limit_pad == 2
    assert found.limit_loads == pytest.approx((share * fold.load, fold.load), rel=0.015)
    assert found.pads[2].status is PadStatus.AT_LIMIT
    assert found.position == pytest.approx([x, y], abs=1e-4)


@pytest.mark.parametrize("share", [0.3, 0.7])
def test_two_pads_that_would_have_to_carry_less_than_they_can(share):
    """A load on a pad leaves both upper pads at the same eccentricity, hence at their limit together."""
    chosen = bearing((pad(angle, 70.0, 0.55, 0.0) for angle in (-90, 30, 150)), 0.7)
    fold = fold_of(chosen, 2, GRID)
    y = (fold.eccentricity_ratio - 1e-5) / chosen.pads[1].normal()[1]
    alone = tilting_pads_at(chosen, (0.0, y), GRID)
    assert alone.loaded == (0,)
    load = alone.force[1] - share * fold.load  # both at 30 degrees to the horizontal: one whole of each share
    found = solve_tilting_pads(chosen, (0.0, -load), GRID)
    assert found.outcome is Outcome.PAD_AT_LIMIT
    assert [state.status for state in found.pads] == [PadStatus.LOADED, PadStatus.AT_LIMIT, PadStatus.AT_LIMIT]
    assert found.limit_loads == pytest.approx((share * fold.load, fold.load), rel=0.015)


def test_a_pad_between_its_limit_and_more_is_solved():
    chosen = bearing((pad(angle, 70.0, 0.55, 0.0) for angle in (-90, 30, 150)), 0.7)
    fold = fold_of(chosen, 2, GRID)
    x, last = 0.1, chosen.pads[2].normal()
    for excess, loaded in ((-1e-3, (0, 1)), (1e-3, (0, 1, 2))):
        y = (fold.eccentricity_ratio + excess - x * last[0]) / last[1]
        force = tilting_pads_at(chosen, (x, y), GRID).force
        found = solve_tilting_pads(chosen, tuple(-force), GRID)
        assert found.outcome.solved
        assert found.loaded == loaded
        assert found.position == pytest.approx([x, y], abs=1e-5)


def test_a_pad_that_carries_nowhere_has_no_fold():
    """Its bore is bent so far inwards at both sides of the pivot that it touches the journal everywhere."""
    profile = tuple(-9.0 * np.sin(np.linspace(-0.67, 0.55, 41)) ** 2)
    fold = fold_of(one_pad(0.7, 70.0, 0.55, profile=profile), 0, GRID)
    assert fold.outcome is Outcome.NOT_CONVERGED
    assert math.isnan(fold.eccentricity_ratio)


SPRING = SpringPivot(0.5)


@pytest.mark.parametrize("law", [SPRING, PointContact(0.3, 0.31, elastic_modulus=10.0)], ids=["spring", "ball"])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_an_elastic_pivot_that_would_carry_less_than_the_film_can(law, share):
    """At the fold the pivot gives way between nothing and what the least load makes it."""
    fold = fold_of(one_pad(0.7, 70.0, 0.55), 0, GRID)
    way = law.curve().at(share * fold.load)[0]
    found = tilting_pads_at(one_pad(0.7, 70.0, 0.55, law=law), (fold.eccentricity_ratio + way, 0.0), GRID)
    assert found.outcome is Outcome.PAD_AT_LIMIT
    assert found.limit_loads == pytest.approx((share * fold.load, fold.load), rel=0.01)
    state = found.pads[0]
    assert state.status is PadStatus.AT_LIMIT
    assert state.position.pivot_displacement == pytest.approx(way, abs=2e-6)
    assert state.radial == pytest.approx(fold.eccentricity_ratio, abs=2e-6)
    assert found.force == pytest.approx(np.zeros(2))


def test_an_elastic_pivot_on_either_side_of_its_limit():
    fold = fold_of(one_pad(0.7, 70.0, 0.55), 0, GRID)
    chosen = one_pad(0.7, 70.0, 0.55, law=SPRING)
    below = tilting_pads_at(chosen, (fold.eccentricity_ratio - 1e-4, 0.0), GRID)
    assert below.outcome.solved
    assert below.pads[0].status is PadStatus.UNLOADED
    assert below.pads[0].radial == pytest.approx(fold.eccentricity_ratio - 1e-4, abs=1e-9)
    above = tilting_pads_at(chosen, (fold.eccentricity_ratio + 1.01 * fold.load / SPRING.stiffness, 0.0), GRID)
    assert above.outcome.solved
    assert above.pads[0].load > fold.load
    assert above.pads[0].position.pivot_displacement == pytest.approx(above.pads[0].load / SPRING.stiffness)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_a_bearing_on_elastic_pivots_with_a_pad_at_its_limit(share):
    laws = RigidPivot(), RigidPivot(), SPRING
    chosen = bearing(
        (pad(angle, 70.0, 0.55, 0.0, law) for angle, law in zip((-90, 30, 150), laws, strict=True)), 0.7
    )
    last = chosen.pads[2].normal()
    fold = fold_of(chosen, 2, GRID)
    x = 0.1
    y = (fold.eccentricity_ratio + share * fold.load / SPRING.stiffness - x * last[0]) / last[1]
    others = tilting_pads_at(chosen, (x, y), GRID)
    assert [state.status for state in others.pads] == [PadStatus.LOADED, PadStatus.LOADED, PadStatus.AT_LIMIT]
    load = -(others.force - share * fold.load * last)
    found = solve_tilting_pads(chosen, tuple(load), GRID)
    assert found.outcome is Outcome.PAD_AT_LIMIT
    assert found.limit_pad == 2
    assert found.limit_loads == pytest.approx((share * fold.load, fold.load), rel=0.01)
    assert found.position == pytest.approx([x, y], abs=1e-4)
    assert found.residual == pytest.approx(share * fold.load, rel=0.01)


def test_a_pad_on_a_stiff_spring_beyond_its_bore_has_no_film():
    assert tilting_pads_at(one_pad(law=SpringPivot(1e6)), (1.1, 0.0), GRID).outcome is Outcome.OUTSIDE_CLEARANCE


SHALLOW = LineContact(0.200, 0.250, 0.06, 2e-3, 2e-3)


def test_a_contact_of_lines_beyond_its_law_is_overloaded():
    """u = P (A - B ln P) falls from ln P = A/B - 1 on."""
    curve = SHALLOW.curve()
    last = math.exp(curve.line / curve.line_slope - 1.0)
    assert stiffness_of(SHALLOW, 0.99 * last) > 0.0
    assert math.isnan(stiffness_of(SHALLOW, 1.01 * last))
    pads = tuple(
        TiltingPad(math.radians(angle), math.radians(60.0), 150e-6, 100e-6, 0.02, pivot=SHALLOW)
        for angle in (54, 126, 198, 270, 342)
    )
    chosen = TiltingPadBearing(0.2, 0.1, 0.02, 300.0, pads)
    within, beyond = (solve_tilting_pads(chosen, (0.0, -share * last), GRID) for share in (0.5, 1.5))
    assert within.outcome.solved
    assert beyond.outcome is Outcome.OVERLOADED


def test_one_loaded_pad_leaves_a_direction_indifferent():
    chosen = bearing((pad(-90.0, 80.0), pad(90.0, 80.0)), 0.5)
    found = solve_tilting_pads(chosen, (0.0, -1.0), GRID)
    assert found.outcome.solved
    assert found.indifferent
    assert found.loaded == (0,)
    assert not solve_tilting_pads(four_pads(), FOUR_LOAD, GRID).indifferent


def test_a_search_from_its_own_answer_knows_what_is_indifferent():
    chosen = bearing((pad(-90.0, 80.0), pad(90.0, 80.0)), 0.5)
    found = solve_tilting_pads(chosen, (0.0, -1.0), GRID)
    assert solve_tilting_pads(chosen, (0.0, -1.0), GRID, start=tuple(found.position)).indifferent


@pytest.mark.parametrize("stiffness", [(1.0, 4.0, 0.0, 1.0), (1.0, -8.0, 1.0, 1.0), (-1.0, 0.0, 0.0, -2.0)])
def test_a_step_of_the_journal_never_leads_against_the_force(stiffness):
    for angle in np.linspace(0.0, 2.0 * math.pi, 25):
        r = math.cos(angle), math.sin(angle)
        step = journal_step.py_func(np.array([0.0, 0.0, *stiffness]), *r)
        assert np.dot(step, r) > 0.0


def test_a_search_that_used_up_its_work_says_so():
    chosen = four_pads()
    pads, axial = kernel_pads(chosen, PadScales(chosen)), kernel_operator(4)
    places = new_places(pads)
    places.films[0] = MOST_FILMS - 10
    ended = find_pads(axial, pads, 48, *FOUR_LOAD, 0.0, 0.0, 1e-6, 100, places, no_total())
    assert ended[2] == WORK
    assert NOT_FOUND in places.status  # which is no pad at its limit
    assert AT_LIMIT not in places.status


def random_bearing(rng, flexed):
    """As in ``benchmarks/tilting_pad_robustness.py``."""
    count, fraction = int(rng.integers(3, 7)), rng.choice([0.5, rng.uniform(0.5, 0.6)])
    extent, preload = min(rng.uniform(0.6, 0.92) * 360.0 / count, 100.0), rng.uniform(0.0, 0.6)
    first = 360.0 * rng.random()
    law = SpringPivot(10.0 ** rng.uniform(0.5, 3.0)) if rng.random() < 0.5 else RigidPivot()
    more = {"rotational_stiffness": 10.0 ** rng.uniform(-2.0, 2.0) * LEVER**2} if flexed else {}
    pads = [pad(first + 360.0 * k / count, extent, fraction, preload, law, **more) for k in range(count)]
    load = directed(10.0 ** rng.uniform(-1.5, 1.5), 360.0 * rng.random())
    return bearing(pads, rng.uniform(0.3, 1.2)), load


@pytest.mark.parametrize(("flexed", "number"), [(False, 40), (True, 20)], ids=["free", "on flexures"])
def test_random_bearings_are_solved_or_at_a_limit(flexed, number):
    """Of pads on flexures one in 25 bearings is overloaded: an edge of a pad is pressed on the journal."""
    rng, solved = np.random.default_rng(8), 0
    for _ in range(number):
        chosen, load = random_bearing(rng, flexed)
        found = solve_tilting_pads(chosen, load, Resolution(4, 48))
        if found.outcome is Outcome.PAD_AT_LIMIT:
            need, least = found.limit_loads
            assert 0.0 < need < least
        elif found.outcome.solved:
            solved += 1
            assert found.force == pytest.approx(-np.asarray(load), abs=2e-6 * math.hypot(*load))
            for own, state in zip(chosen.pads, found.pads, strict=True):
                if state.status is PadStatus.LOADED:
                    spring = own.rotational_stiffness * state.position.tilt / LEVER
                    assert state.force[1] == pytest.approx(spring, abs=2e-6 * state.load + 1e-11 * spring)
        else:
            assert flexed
            assert found.outcome is Outcome.OVERLOADED
    assert solved >= 0.9 * number
