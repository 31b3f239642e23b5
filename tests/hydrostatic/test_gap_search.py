"""The search of the gap, and what it is searched in: closed forms and lumped lands."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hydrostatic_bearings import CIRCULAR, CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE, RING, RING_FEEDING, case, journal
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.result import Outcome
from babbitt.kinds.hydrostatic.answer import answer, answer_at
from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.gap_search import gap_for_load
from babbitt.kinds.hydrostatic.lumps import journal_lumps, ring_lumps
from babbitt.kinds.hydrostatic.model import Oil, OperatingConditions
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.restrictors import ConstantFlow, MembraneValve
from babbitt.kinds.hydrostatic.single_recess import gap_under, pad_at
from babbitt.kinds.hydrostatic.supply import FixedPressure
from babbitt.kinds.hydrostatic.sweeps import over_gap

BOUNDS = (1e-7, 1.0)


def capillary_pad(gap):
    """Load over that of the supply pressure, 1/(1 + (h/30 um)^3), and its stiffness."""
    ratio = (gap / 30e-6) ** 3
    return 1.0 / (1.0 + ratio), 3.0 * ratio / gap / (1.0 + ratio) ** 2


@given(st.floats(1e-6, 1e-3), st.floats(1e-7, 1.0))
def test_capillary_pad_from_everywhere(gap, start):
    load, _ = capillary_pad(gap)
    assert gap_for_load(capillary_pad, load, BOUNDS, start, 1e-12) == pytest.approx(gap, rel=1e-5)


def test_few_steps_from_a_usual_gap():
    for start, most in ((50e-6, 6), (10e-6, 8)):
        gaps = []

        def counted(gap, gaps=gaps):
            gaps.append(gap)
            return capillary_pad(gap)

        gap_for_load(counted, 0.5, BOUNDS, start, 1e-12)
        assert len(gaps) <= most


def test_no_gap_between_the_bounds():
    """Too heavy for the least gap, too light for the widest, and nothing to carry at all."""
    assert gap_for_load(capillary_pad, 2.0, BOUNDS, 30e-6, 1e-12) == 0.0
    for load in (0.5, 0.0, -1.0):
        assert gap_for_load(capillary_pad, load, (1e-7, 20e-6), 10e-6, 1e-12) == math.inf


@pytest.mark.parametrize("method", ["quick", "film"])
@pytest.mark.parametrize("load", [0.05, 0.0])
def test_a_ring_lighter_than_the_widest_gap_carries_is_lifted_off(load, method):
    result = hydrostatic_check(
        case(RING, OperatingConditions(load), method, "hydrostatic_thrust_ring", RING_FEEDING)
    )
    assert result.outcome is Outcome.LIFTED_OFF
    assert result.outcome.code == "S303"
    widest = answer_at(
        case(RING, OperatingConditions(load), "quick", "hydrostatic_thrust_ring", RING_FEEDING), np.zeros(3), 2e-3
    )
    pressed = float(widest.response.force[0])
    assert pressed > load
    assert (
        f"a gap of 2.00 mm, the widest that is searched, the recesses still press with {pressed:.3g} N"
        in result.message
    )
    just = hydrostatic_check(
        case(RING, OperatingConditions(1.1 * pressed), "quick", "hydrostatic_thrust_ring", RING_FEEDING)
    )
    assert just.outcome is Outcome.CONVERGED


def test_a_ring_heavier_than_the_least_gap_carries_is_overloaded():
    result = hydrostatic_check(
        case(RING, OperatingConditions(1e6), "quick", "hydrostatic_thrust_ring", RING_FEEDING)
    )
    assert result.outcome is Outcome.OVERLOADED
    assert "1000 kN" in result.message


@pytest.mark.parametrize("method", ["quick", "film"])
def test_a_pad_without_load_is_lifted_off(method):
    fed = Feeding((CIRCULAR_CAPILLARY,), FixedPressure(5e6))
    result = hydrostatic_check(
        case(CIRCULAR, OperatingConditions(0.0), method, "hydrostatic_pad", fed, Oil(0.03, 870.0, 2000.0))
    )
    assert result.outcome is Outcome.LIFTED_OFF


def test_slopes_that_mislead_are_bisected():
    """A load without slope, and one with a jump: Newton has nothing to go by."""
    falls = gap_for_load(lambda gap: (2.0 if gap < 40e-6 else 0.5, 0.0), 1.0, BOUNDS, 30e-6, 1e-12)
    assert falls == pytest.approx(40e-6, rel=1e-9)
    wrong = gap_for_load(lambda gap: (capillary_pad(gap)[0], -1.0), 0.5, BOUNDS, 1e-3, 1e-10)
    assert wrong == pytest.approx(30e-6, rel=1e-6)


@pytest.mark.parametrize(
    "restrictor", [CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE, ConstantFlow(4e-6), MembraneValve(0.5e-12, 2e-7)]
)
def test_gap_of_a_pad_carries_the_load(restrictor):
    lands, fed = lands_of(CIRCULAR), Feeding((restrictor,), FixedPressure(5e6))
    for load in (500.0, 5e3, 15e3):
        gap = gap_under(lands, fed, 0.03, load, 1e-7)
        assert pad_at(lands, fed, 0.03, gap).load == pytest.approx(load, rel=1e-11)


LUMPS = {
    "journal": journal_lumps(journal(-70.0), 0.02, 157.0),
    "journal with grooves": journal_lumps(journal(groove=6.0), 0.02, -80.0),
    "journal, unlike pitches": journal_lumps(
        type(journal())(0.1, 0.1, 50e-6, (2.4, -1.2, 0.3), 0.9, 0.07), 0.02, 157.0
    ),
    "ring": ring_lumps(RING, 50e-6, 0.02, 105.0),
}
PLACES = {2: np.array([21e-6, -14e-6]), 3: np.array([-6e-6, 1.5e-4, -0.8e-4])}


@pytest.mark.parametrize("name", LUMPS)
def test_opening_is_the_slope_of_the_outflow(name):
    lumps = LUMPS[name]
    at, pressures = PLACES[len(lumps.harmonics)], 1e6 * np.array([1.0, 3.0, 2.0, 0.5])[: len(lumps.angles)]
    opening = lumps.flow(at).opening(pressures)
    for d, way in enumerate(1e-4 * 50e-6 / np.abs(lumps.harmonics).max(axis=1) * np.eye(at.size)):
        ahead, behind = (lumps.flow(at + sign * way).outflow(pressures) for sign in (1.0, -1.0))
        assert opening[:, d] == pytest.approx((ahead - behind) / (2.0 * way[d]), rel=1e-6)


@pytest.mark.parametrize("name", LUMPS)
def test_thinnest_gap_is_the_least_around(name):
    lumps = LUMPS[name]
    at, theta = PLACES[len(lumps.harmonics)], np.linspace(0.0, 2.0 * math.pi, 3601)
    mean, cosine, sine = at @ lumps.harmonics
    around = lumps.gap - mean - lumps.edge * (cosine * np.cos(theta) + sine * np.sin(theta))
    assert lumps.thinnest(at) == pytest.approx(around.min(), rel=1e-6)


def test_what_flows_along_the_lands_leaves_nowhere():
    """Rows of joins sum to zero: at equal pressures only the outer lands let oil out, and dragging none at all."""
    flow = LUMPS["journal"].flow(PLACES[2])
    assert flow.dragged.sum() == pytest.approx(0.0, abs=1e-12 * np.abs(flow.dragged).max())
    assert (flow.joins @ np.ones(4)).max() == 0.0
    assert np.linalg.eigvalsh(flow.conductance).min() > 0.0


def test_films_beside_closed_forms_get_every_motion():
    """The film beside a pad by closed forms stands still: its kernels read a velocity for every motion."""
    duty, fed = OperatingConditions(11e3), Feeding((CIRCULAR_CAPILLARY,), FixedPressure(5e6))
    made = case(CIRCULAR, duty, "quick", "hydrostatic_pad", fed, Oil(0.03, 870.0, 2000.0))
    found = answer(made)
    film, quick = (over_gap(made, found, method) for method in ("film", "quick"))
    assert film.at == pytest.approx(quick.at)
    assert film.load == pytest.approx(quick.load, rel=1e-6)
    with pytest.raises(ValueError, match="1 numbers for 3 motions"):
        answer_at(replace(made, method="film"), np.zeros(1), 40e-6)


def few_recesses(count, moments):
    ring = type(RING)(RING.radii, (0.0, math.pi)[:count], math.radians(100.0))
    fed = Feeding(RING_FEEDING.restrictors[:count], RING_FEEDING.supply)
    return hydrostatic_check(
        case(ring, OperatingConditions(5e3, moments=moments), "quick", "hydrostatic_thrust_ring", fed)
    )


@pytest.mark.parametrize("count", [1, 2])
def test_a_moment_that_no_recess_balances_ends_typed(count):
    assert few_recesses(count, (50.0, 0.0)).outcome is Outcome.OVERLOADED


def test_two_recesses_balance_the_moment_about_the_axis_between_them():
    result = few_recesses(2, (0.0, 50.0))
    assert result.outcome is Outcome.CONVERGED
    assert (result.load, result.moment_y) == pytest.approx((5e3, -50.0), rel=1e-8)
