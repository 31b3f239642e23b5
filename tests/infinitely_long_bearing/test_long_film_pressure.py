"""Pressure of the long film against Reynolds' closed solution and against a sweep with a cut."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, divergence_form, published_form
from babbitt.kinds.journal.infinitely_long_bearing.walls import flow_spread

FORMS = {"divergence": divergence_form, "published": published_form}

# eps: rupture angle in degrees, h_r/c, f_c, f_s, f, friction number of the full film
CLOSED = {
    0.1: (249.222, 0.96453, 0.07863, 0.20516, 0.21971, 4.52905),
    0.2: (241.326, 0.90403, 0.16822, 0.39438, 0.42876, 4.72500),
    0.3: (233.779, 0.82273, 0.27305, 0.57153, 0.63340, 5.07545),
    0.4: (226.577, 0.72505, 0.40071, 0.74230, 0.84355, 5.58772),
    0.5: (219.694, 0.61527, 0.56543, 0.91537, 1.07593, 6.29099),
    0.6: (213.078, 0.49724, 0.79610, 1.10520, 1.36207, 7.25617),
    0.7: (206.634, 0.37428, 1.16059, 1.33970, 1.77251, 8.64954),
    0.8: (200.174, 0.24908, 1.86286, 1.68801, 2.51388, 10.92126),
}


def friction_number(gap, film):
    """Of the full film, over mu u² L R/c."""
    shear = film.full / gap.sectors + 0.5 * gap.sectors * np.diff(film.nodes) / gap.step
    return gap.step * shear.sum()


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("cells", "relative", "degrees"), [(360, 1e-3, 0.2), (90, 5e-3, 0.8)])
@pytest.mark.parametrize("eccentricity", CLOSED)
def test_closed_solution_of_one_viscosity(form, cells, relative, degrees, eccentricity):
    rupture, at_rupture, along, across, both, friction = CLOSED[eccentricity]
    gap = Gap.of(eccentricity, cells)
    film = FORMS[form](gap, np.ones(cells + 1))
    found = np.array(film.load(gap.step)) / 6.0
    assert found == pytest.approx([along, across], rel=relative)
    assert math.hypot(*found) == pytest.approx(both, rel=relative)
    assert math.degrees(film.rupture_angle) == pytest.approx(rupture, abs=degrees)
    assert friction_number(gap, film) == pytest.approx(friction, rel=relative)
    assert 2.0 * float(film.flow[0]) == pytest.approx(at_rupture, rel=5.0 * relative)


@pytest.mark.parametrize("form", FORMS)
def test_rupture_of_a_film_without_load(form):
    gap = Gap.of(1e-4, 360)
    assert math.degrees(FORMS[form](gap, np.ones(361)).rupture_angle) == pytest.approx(257.45, abs=0.05)


def swept(gap, viscosity):
    """Thomas sweep from the widest gap; negative pressure is cut in the back substitution."""
    conductance = gap.sectors**3 / (0.5 * (viscosity[1:] + viscosity[:-1]))
    n = gap.sectors.size
    ahead, known = np.zeros(n), np.zeros(n)
    for i in range(1, n):
        left, right = conductance[i - 1], conductance[i]
        source = 6.0 * gap.step * (gap.sectors[i] - gap.sectors[i - 1])
        pivot = left + right - left * ahead[i - 1]
        ahead[i] = right / pivot
        known[i] = (left * known[i - 1] - source) / pivot
    pressure = np.zeros(n + 1)
    for i in range(n - 1, 0, -1):
        pressure[i] = max(0.0, ahead[i] * pressure[i + 1] + known[i])
    return pressure


@settings(max_examples=40)
@given(
    eccentricity=st.floats(0.02, 0.97),
    heating=st.floats(-2.0, 2.0),
    wave=st.floats(-0.5, 0.5),
    cells=st.sampled_from([60, 90, 181]),
)
def test_cumulative_sums_are_a_sweep_with_a_cut(eccentricity, heating, wave, cells):
    gap = Gap.of(eccentricity, cells)
    angles = np.linspace(0.0, 1.0, cells + 1)
    viscosity = np.exp(-heating * angles + wave * np.sin(7.0 * angles))
    film = divergence_form(gap, viscosity)
    expected = swept(gap, viscosity)
    assert film.nodes == pytest.approx(expected, rel=1e-7, abs=1e-9 * expected.max())
    assert film.nodes.min() >= 0.0


@settings(max_examples=30)
@given(eccentricity=st.floats(0.05, 0.95), heating=st.floats(0.0, 2.0))
def test_only_the_divergence_form_conserves_the_flow(eccentricity, heating):
    gap = Gap.of(eccentricity, 180)
    viscosity = np.exp(-heating * np.linspace(0.0, 1.0, 181))
    film = divergence_form(gap, viscosity)
    local = 0.5 * gap.sectors - gap.sectors**3 / (12.0 * 0.5 * (viscosity[1:] + viscosity[:-1])) * (
        np.diff(film.nodes) / gap.step
    )
    full = film.full >= 1.0
    assert local[full] == pytest.approx(film.flow[full], rel=1e-10)


def test_the_published_form_loses_flow_where_the_film_heats_up():
    gap = Gap.of(0.8, 360)
    viscosity = np.exp(-np.linspace(0.0, 1.5, 361))
    assert flow_spread(published_form(gap, viscosity)) > 0.5
    assert flow_spread(divergence_form(gap, viscosity)) < 1e-12
    assert flow_spread(published_form(gap, np.ones(361))) < 0.01


def test_both_forms_agree_without_change_of_viscosity():
    for eccentricity in (0.1, 0.5, 0.8):
        gap = Gap.of(eccentricity, 720)
        one, other = (form(gap, np.ones(721)).load(gap.step) for form in FORMS.values())
        assert one == pytest.approx(other, rel=2e-4)
