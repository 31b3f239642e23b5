"""Single pads and whole bearings against tables of an independent program of the same equations.

Dimensionless (``scaled_pads``); that program has Lobatto polynomials across and finite volumes along, as here, and
its own active set and search. Where it was run on the same grid, positions and loads agree to all digits that
were kept; its limits are Richardson's of the two finest grids.
"""

from dataclasses import replace

import numpy as np
import pytest
from scaled_pads import FIVE_LOAD, FOUR_LOAD, LEVER, bearing, five_pads, four_pads, one_pad, pad

from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.dynamics import (
    condensed_at,
    condensed_over,
    fit_virtual_mass,
    full_coefficients,
)
from babbitt.reynolds.tilting_pads.pivots import SpringPivot
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import fold_of, solve_tilting_pads, tilting_pads_at

COARSE, ENGINEERING, FINE = Resolution(4, 48), Resolution(4, 96), Resolution(6, 192)

# xi: eta, W, h_min, k_s, K(1), C(1), K(1/2), C(1/2), grid 4 x 48 and 8 x 192
CENTRED = {
    0.2: ((0.221302, 0.139117, 0.70480, 0.73706, 0.27365, 0.85758, 0.53381, 0.55600),
          (0.221334, 0.139236, 0.70458, 0.73775, 0.27401, 0.85818, 0.53433, 0.55636)),
    0.5: ((0.304249, 0.616206, 0.41471, 3.25838, 2.24062, 2.65537, 2.91445, 2.16424),
          (0.304326, 0.616855, 0.41467, 3.26236, 2.24393, 2.65697, 2.91817, 2.16545)),
    0.8: ((0.303487, 4.871197, 0.14439, 47.3312, 42.9916, 23.0909, 46.0689, 21.6133),
          (0.303407, 4.876914, 0.14440, 47.4750, 43.0734, 23.0379, 46.1926, 21.5311)),
}  # fmt: skip

# xi: eta, W, k_s, K(1), C(1), grid 6 x 192
OFFSET = {
    -0.2: (0.373441, 0.308917, 1.08275, 0.88105, 1.41711),
    0.0: (0.370865, 0.647686, 2.59424, 2.15961, 2.79709),
    0.3: (0.324218, 2.925609, 19.50384, 17.20231, 13.36079),
}


def diagonals(coefficients, *ratios):
    """K and C of the diagonal at whirl ratios, in a row."""
    found = [condensed_at(coefficients, ratio) for ratio in ratios]
    return np.concatenate([np.concatenate([np.diag(one.stiffness), np.diag(one.damping)]) for one in found])


@pytest.mark.parametrize("pivot", [{}, {"law": SpringPivot(5.0), "mass": 0.1}])
def test_many_whirl_ratios_are_condensed_as_one_by_one(pivot):
    coefficients = full_coefficients(solve_tilting_pads(four_pads(**pivot), FOUR_LOAD, COARSE))
    for ratios in ((0.0, 0.4, 1.0, 0.0, 2.0), (0.0,), ()):
        found = condensed_over(coefficients, ratios)
        assert [one.whirl_ratio for one in found] == list(ratios)
        for one in found:
            alone = condensed_at(coefficients, one.whirl_ratio)
            assert one.stiffness == pytest.approx(alone.stiffness, rel=1e-12, abs=1e-12)
            assert one.damping == pytest.approx(alone.damping, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("xi", list(CENTRED))
@pytest.mark.parametrize(("grid", "column"), [(COARSE, 0), (Resolution(8, 192), 1)])
def test_a_centred_pad(xi, grid, column):
    eta, load, gap, static, *moving = CENTRED[xi][column]
    found = tilting_pads_at(one_pad(), (xi, 0.0), grid)
    state = found.pads[0]
    assert state.tangential == pytest.approx(eta, abs=2e-6)
    assert state.load == pytest.approx(load, rel=1e-5)
    assert state.minimum_film_thickness == pytest.approx(gap, abs=1e-5)
    coefficients = full_coefficients(found)
    assert condensed_at(coefficients, 0.0).stiffness[0, 0] == pytest.approx(static, rel=1e-3)
    for ratio, (stiffness, damping) in {1.0: moving[:2], 0.5: moving[2:]}.items():
        condensed = condensed_at(coefficients, ratio)
        assert condensed.stiffness[0, 0] == pytest.approx(stiffness, rel=1e-3)
        assert condensed.damping[0, 0] == pytest.approx(damping, rel=4e-3)


def test_the_film_of_a_pad_answers_in_both_directions():
    state = tilting_pads_at(one_pad(), (0.5, 0.0), Resolution(8, 192)).pads[0]
    assert state.stiffness.ravel() == pytest.approx([2.896947, 2.499329, -0.076445, 0.522868], rel=2e-4)
    assert state.damping.ravel() == pytest.approx([5.082921, 0.626263, 0.626263, 0.381172], rel=1e-4)


@pytest.mark.parametrize("xi", list(OFFSET))
def test_a_pad_with_preload_and_its_pivot_behind_the_middle(xi):
    eta, load, static, stiffness, damping = OFFSET[xi]
    found = tilting_pads_at(one_pad(0.7, 75.0, 0.55, 0.4), (xi, 0.0), FINE)
    assert found.pads[0].tangential == pytest.approx(eta, abs=2e-6)
    assert found.pads[0].load == pytest.approx(load, rel=1e-5)
    assert found.pads[0].eccentricity_ratio == pytest.approx(0.4 + xi)
    coefficients = full_coefficients(found)
    assert condensed_at(coefficients, 0.0).stiffness[0, 0] == pytest.approx(static, rel=5e-4)
    moving = condensed_at(coefficients, 1.0)
    assert moving.stiffness[0, 0] == pytest.approx(stiffness, rel=5e-4)
    assert moving.damping[0, 0] == pytest.approx(damping, rel=1e-3)


FIVE = {
    COARSE: (-0.481800, 0.258453, 1.259686, 0.061832),
    ENGINEERING: (-0.481683, 0.258524, 1.259704, 0.061881),
    FINE: (-0.481658, 0.258539, 1.259709, 0.061893),
}
FIVE_LIMIT = (
    7.295789,
    12.608828,
    5.635393,
    10.333042,
    4.844677,
    7.675873,
    6.731831,
    11.934455,
    4.112476,
    6.868422,
)
FOUR = {
    COARSE: (0.168387, -0.305460, 0.224087, 3.032823, 1.371441, 0.213746, 0.345380),
    ENGINEERING: (0.168325, -0.305376, 0.224157, 3.032772, 1.371450, 0.213694, 0.345389),
    FINE: (0.168309, -0.305357, 0.224175, 3.032756, 1.371452, 0.213678, 0.345391),
}
FOUR_LIMIT = (8.126282, 21.267191, 6.927191, 18.721370, 7.550506, 14.933425)


@pytest.mark.parametrize("grid", list(FIVE))
def test_five_pads_under_a_load_between_two(grid):
    y, gap, bottom, side = FIVE[grid]
    found = solve_tilting_pads(five_pads(), FIVE_LOAD, grid)
    assert found.outcome.solved
    assert found.position == pytest.approx([0.0, y], abs=2e-6)
    assert found.minimum_film_thickness == pytest.approx(gap, abs=2e-6)
    assert [state.load for state in found.pads] == pytest.approx([bottom, bottom, side, 0.0, side], abs=3e-6)
    assert [state.status for state in found.pads].count(PadStatus.UNLOADED) == 1
    coefficients = full_coefficients(found)
    static, moving, half = (condensed_at(coefficients, ratio) for ratio in (0.0, 1.0, 0.5))
    values = [np.diag(static.stiffness), np.diag(moving.stiffness), np.diag(moving.damping),
              np.diag(half.stiffness), np.diag(half.damping)]  # fmt: skip
    assert np.concatenate(values) == pytest.approx(FIVE_LIMIT, rel={48: 5e-4, 96: 2e-4, 192: 8e-5}[grid.intervals])


@pytest.mark.parametrize("grid", list(FOUR))
def test_four_pads_under_a_skew_load(grid):
    x, y, gap, *loads = FOUR[grid]
    found = solve_tilting_pads(four_pads(), FOUR_LOAD, grid)
    assert found.outcome.solved
    assert found.position == pytest.approx([x, y], abs=2e-6)
    assert found.minimum_film_thickness == pytest.approx(gap, abs=2e-6)
    assert [state.load for state in found.pads] == pytest.approx(loads, abs=5e-6)
    coefficients = full_coefficients(found)
    static, moving = condensed_at(coefficients, 0.0), condensed_at(coefficients, 1.0)
    values = [np.diag(static.stiffness), np.diag(moving.stiffness), np.diag(moving.damping)]
    assert np.concatenate(values) == pytest.approx(FOUR_LIMIT, rel={48: 5e-4, 96: 2e-4, 192: 1e-4}[grid.intervals])


def supported(stiffness):
    """The four pads on springs, standing as if rigid: more preload makes up for the way of every pivot."""
    loads = [state.load for state in solve_tilting_pads(four_pads(), FOUR_LOAD, ENGINEERING).pads]
    own = {"law": SpringPivot(stiffness), "mass": 0.02, "inertia": 0.05 * LEVER**2}
    return bearing((
        pad(angle, 75.0, 0.55, 0.4 + load / stiffness, **own)
        for angle, load in zip((-90, 0, 90, 180), loads, strict=True)
    ), 0.7)  # fmt: skip


MOVING = {
    None: ((6.479346, -0.471080, 0.186737, 18.312782), (7.487977, 0.503940, -0.648493, 14.842660)),
    20.0: ((6.034977, -0.364402, 0.037684, 11.087152), (4.842547, 0.497249, -0.628674, 4.416576)),
}


def test_soft_pivots_cost_damping_first():
    """Pivots of 5 would need more preload than the gap has: the films of rigid ones, on springs and masses."""
    stood = solve_tilting_pads(four_pads(), FOUR_LOAD, ENGINEERING)
    own = {"mass": 0.02, "inertia": 0.05 * LEVER**2}
    pads = tuple(replace(one, pivot=SpringPivot(5.0), **own) for one in stood.bearing.pads)
    states = tuple(replace(state, pivot_stiffness=5.0) for state in stood.pads)
    found = replace(stood, bearing=replace(stood.bearing, pads=pads), pads=states)
    condensed = condensed_at(full_coefficients(found), 1.0)
    assert condensed.stiffness.ravel() == pytest.approx([4.091959, -0.188207, -0.082244, 4.677870], abs=2e-5)
    assert condensed.damping.ravel() == pytest.approx([2.088753, 0.440529, -0.529248, 1.359405], abs=2e-5)


@pytest.mark.parametrize("stiffness", list(MOVING))
def test_pads_with_inertia_on_springs(stiffness):
    chosen = four_pads(inertia=0.05 * LEVER**2) if stiffness is None else supported(stiffness)
    found = solve_tilting_pads(chosen, FOUR_LOAD, ENGINEERING)
    assert found.position == pytest.approx(FOUR[ENGINEERING][:2], abs=2e-6)
    condensed = condensed_at(full_coefficients(found), 1.0)
    assert condensed.stiffness.ravel() == pytest.approx(MOVING[stiffness][0], abs=2e-5)
    assert condensed.damping.ravel() == pytest.approx(MOVING[stiffness][1], abs=2e-5)


def test_a_virtual_mass_stands_for_a_range_of_frequencies():
    found = solve_tilting_pads(supported(20.0), FOUR_LOAD, ENGINEERING)
    fit = fit_virtual_mass(full_coefficients(found), np.linspace(0.2, 1.2, 11))
    assert np.diag(fit.stiffness) == pytest.approx([6.211760, 10.757426], abs=2e-5)
    assert np.diag(fit.mass) == pytest.approx([0.130346, -0.384134], abs=2e-5)
    assert np.diag(fit.damping) == pytest.approx([4.795110, 4.356432], abs=2e-5)
    assert np.diag(fit.errors) == pytest.approx([0.0266, 0.0130], abs=1e-4)
    assert fit.error == fit.errors[0, 0]


@pytest.mark.parametrize(
    ("fraction", "ratio", "load", "eta"),
    [(0.51, -0.0054, 0.0144, 0.036), (0.52, -0.0221, 0.0279, 0.074), (0.55, -0.157, 0.0556, 0.216)],
)
def test_a_pivot_behind_the_middle_unloads_at_a_load(fraction, ratio, load, eta):
    fold = fold_of(one_pad(0.7, 70.0, fraction), 0, FINE)
    assert fold.eccentricity_ratio == pytest.approx(ratio, rel=0.01)
    assert fold.load == pytest.approx(load, rel=0.01)
    assert fold.tangential == pytest.approx(eta, rel=0.01)


def test_a_pivot_far_behind_the_middle_carries_at_any_eccentricity():
    fold = fold_of(one_pad(0.7, 70.0, 0.6), 0, FINE)
    assert fold.eccentricity_ratio == -np.inf
    assert fold.load == pytest.approx(0.093, rel=0.01)
