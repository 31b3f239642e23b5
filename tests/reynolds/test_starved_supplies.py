"""Supplies of given flow: flooded with a surplus, or as full as the flow allows."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.equilibrium.starved import PrescribedFlow, feed_film
from babbitt.reynolds.model import ENGINEERING, Cavitation, FilmStart, JournalFilm, Land, Pocket, grooved_bore

LITRE = 1e-3 / 60.0
LOAD = (0.0, -2000.0)
CLOSE = replace(ENGINEERING, tolerance=1e-9)
RING = (Land(-0.5 * math.pi, 1.5 * math.pi),)


def film(lands, **more):
    return JournalFilm(0.1, 0.05, 1e-4, 0.02, 200.0, lands, **more)


ONE_GROOVE = film(grooved_bore((0.5 * math.pi,), 0.35))
TWO_GROOVES = film(grooved_bore((0.0, math.pi), 0.3))
POCKET = film(RING, film_start=FilmStart.PERIODIC, pockets=(Pocket(0.5 * math.pi, 0.5, 0.03),))
TWO_POCKETS = replace(POCKET, pockets=(Pocket(0.0, 0.5, 0.03), Pocket(math.pi, 0.5, 0.03)))
LAYOUTS = {"groove": ONE_GROOVE, "grooves": TWO_GROOVES, "pocket": POCKET, "pockets": TWO_POCKETS}


def settle(one):
    return solve_journal(one, LOAD, CLOSE)


def fed(one, *flows):
    return feed_film(one, [PrescribedFlow((number,), flow * LITRE) for number, flow in enumerate(flows)], settle)


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("flow", [0.3, 0.1, 0.02])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_every_starved_supply_gives_the_film_its_flow(layout, flow, sense):
    one = replace(LAYOUTS[layout], angular_speed=200.0 * sense)
    count = max(len(one.pockets), len(one.lands) if not one.pockets else 0)
    found = fed(one, *(flow / count,) * count)
    assert found.solution.outcome.solved
    assert found.starved
    for number, fill in enumerate(found.fill):
        given = flow / count * LITRE
        if fill < 1.0:
            assert found.solution.supply_flow[number] == pytest.approx(given, rel=1e-8)
        else:
            assert found.solution.supply_flow[number] <= given * (1.0 + 1e-8)
    assert found.solution.side_flow.sum() == pytest.approx(found.solution.supply_flow.sum(), rel=1e-8)
    assert found.solution.mass_balance_error < 1e-10


@pytest.mark.parametrize("layout", LAYOUTS)
def test_what_a_flooded_film_does_not_draw_returns(layout):
    one = LAYOUTS[layout]
    count = max(len(one.pockets), len(one.lands) if not one.pockets else 0)
    found, flooded = fed(one, *(3.0,) * count), settle(one)
    assert not found.starved
    assert found.fill == (1.0,) * count
    assert found.surplus == pytest.approx(3.0 * count * LITRE - flooded.side_flow.sum(), rel=2e-3)
    np.testing.assert_allclose(found.solution.position, flooded.position, rtol=2e-3)


@pytest.mark.parametrize("layout", ["groove", "pocket"])
def test_starved_goes_over_into_flooded(layout):
    """At 99.99 % of what the flooded film draws, the film is within 0.1 % of it; less oil, less film."""
    one = LAYOUTS[layout]
    demand = fed(one, 3.0).drawn[0] / LITRE
    almost, flooded = fed(one, 0.9999 * demand), fed(one, 1.0001 * demand)
    assert almost.starved
    assert not flooded.starved
    assert almost.fill[0] > 0.999
    assert almost.solution.minimum_film_thickness == pytest.approx(
        flooded.solution.minimum_film_thickness, rel=1e-3
    )
    less = [fed(one, share * demand) for share in (0.8, 0.5, 0.2, 0.05)]
    assert np.diff([each.fill[0] for each in less]).max() < 0.0
    assert np.diff([each.solution.minimum_film_thickness for each in less]).max() < 0.0


def test_supplies_of_one_flow_share_one_fill():
    found = feed_film(TWO_GROOVES, [PrescribedFlow((0, 1), 0.3 * LITRE)], settle)
    assert found.fill[0] == found.fill[1] < 1.0
    assert found.solution.supply_flow.sum() == pytest.approx(0.3 * LITRE, rel=1e-8)


def test_flow_beside_pressure():
    """One groove starved, the other held at its pressure: it stays so."""
    lands = (
        replace(TWO_GROOVES.lands[0], end_pressure=5e4),
        replace(TWO_GROOVES.lands[1], start_pressure=5e4),
    )
    found = feed_film(film(lands), [PrescribedFlow((1,), 0.05 * LITRE)], settle)
    assert found.solution.outcome.solved
    assert found.fill[1] < 1.0 == found.fill[0]
    assert found.solution.supply_flow[1] == pytest.approx(0.05 * LITRE, rel=1e-8)
    assert found.solution.supply_flow[0] > 0.0


def test_streamers_that_no_supply_reaches_leave_the_film_solvable():
    """Beside a starved pocket nothing feeds a ring of streamers: without a rule the film has no unique answer."""
    starved = replace(POCKET, pockets=(replace(POCKET.pockets[0], fill=0.3),))
    found = film_at_position(starved, (0.0, 0.0))
    assert found.outcome.solved
    assert found.mass_balance_error < 1e-10
    assert settle(replace(POCKET, pockets=(replace(POCKET.pockets[0], fill=0.02),))).outcome.solved


def test_cavity_below_ambient():
    """Between a full groove at cavity pressure and one at ambient pressure the supply takes more and more."""
    deep = replace(ONE_GROOVE, cavitation_pressure=-3e4)
    flooded = fed(deep, 5.0)
    found = fed(deep, 0.97 * flooded.drawn[0] / LITRE)
    assert found.solution.outcome.solved
    assert found.fill[0] == 1.0
    assert found.solution.supply_flow[0] == pytest.approx(0.97 * flooded.drawn[0], rel=1e-6)
    assert -3e4 < found.solution.film.lands[0].start_pressure < 0.0


def test_a_clockwise_film_is_the_mirror_image_with_cavities_below_ambient():
    """One groove starved at the cavitation pressure, one full above it: the fill belongs to its own groove."""
    ahead = replace(TWO_GROOVES, cavitation_pressure=-5e4)
    here, there = fed(ahead, 8.0, 0.1), fed(replace(ahead, angular_speed=-200.0), 0.1, 8.0)
    assert here.fill[1] < 1.0
    assert there.fill == pytest.approx(here.fill[::-1], rel=1e-6)
    assert there.solution.minimum_film_thickness == pytest.approx(here.solution.minimum_film_thickness, rel=1e-6)


def test_edges_of_one_groove_have_one_pressure():
    unlike = tuple(replace(land, end_pressure=1e5) for land in TWO_GROOVES.lands)
    with pytest.raises(InputError, match="a groove has one pressure"):
        replace(TWO_GROOVES, lands=unlike)


def test_too_little_oil_is_told_with_the_least_that_will_do():
    found = fed(POCKET, 1e-6)
    assert found.solution.outcome is Outcome.OVERLOADED
    assert found.least_flow is not None
    assert found.least_flow > 1e-6 * LITRE
    assert fed(POCKET, 1.5 * found.least_flow / LITRE).solution.outcome.solved


def test_at_a_position_the_fill_alone_decides():
    at = (0.3e-4, -0.4e-4)
    found = feed_film(
        POCKET, [PrescribedFlow((0,), 0.2 * LITRE)], lambda one: film_at_position(one, at, resolution=CLOSE)
    )
    assert found.solution.supply_flow[0] == pytest.approx(0.2 * LITRE, rel=1e-8)
    np.testing.assert_allclose(found.solution.position, at)


@pytest.mark.parametrize(("given", "says"), [
    ([PrescribedFlow((0,), 0.0)], "positive"), ([PrescribedFlow((0,), math.nan)], "positive"),
    ([PrescribedFlow((1,), 1e-6)], "0 to 0"),
    ([PrescribedFlow((0,), 1e-6), PrescribedFlow((0,), 1e-6)], "at most once"),
])  # fmt: skip
def test_flows_that_cannot_be_given(given, says):
    with pytest.raises(InputError, match=says):
        feed_film(POCKET, given, settle)


def test_the_reynolds_condition_counts_no_oil():
    with pytest.raises(InputError, match="MASS_CONSERVING"):
        feed_film(replace(POCKET, cavitation=Cavitation.REYNOLDS), [PrescribedFlow((0,), 1e-6)], settle)


@pytest.mark.parametrize(("change", "says"), [
    ({"fill": 0.0}, "above 0"), ({"fill": 1.1}, "above 0"),
    ({"fill": 0.5, "pressure": 1e4}, "cavitation pressure"),
])  # fmt: skip
def test_fills_that_cannot_be(change, says):
    with pytest.raises(InputError, match=says):
        replace(POCKET, pockets=(replace(POCKET.pockets[0], **change),))
