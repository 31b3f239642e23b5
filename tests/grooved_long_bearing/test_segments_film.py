"""Film by segments: identities, reference numbers, published trends, and what holds under equal load."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.grooved_long_bearing.model import Groove, GrooveKind
from babbitt.kinds.journal.grooved_long_bearing.pressure import Gap, Grid
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.grooved_long_bearing.ungrooved_reference import ungrooved_films
from babbitt.validation.published.grooved_segments import film, loaded, oil, solved

ZERO = 273.15
LOAD = 6.5e6 * 0.1 * 0.07

OILS = {"published class": (19.5, 2.2), "thin": (12.0, 1.9), "medium": (28.0, 2.5), "thick": (45.0, 2.6)}
"""Viscosity at 50 degC in mPa s and exponent, within the published classes."""


def test_closed_form_without_groove():
    only = solved("none").segments[0]
    assert math.degrees(only.segment.end) == pytest.approx(200.17, abs=0.01)
    assert math.degrees(solved("none").attitude_angle) == pytest.approx(42.18, abs=0.01)
    assert only.segment.friction == pytest.approx(10.9213, rel=1e-4)


@pytest.mark.parametrize("kind", ["none", "through", "blind"])
def test_identities(kind):
    state = solved(kind)
    own = state.film
    gap = Gap.of(state.grid, state.film_thickness / own.clearance)
    for one in state.segments:
        segment = one.segment
        angles = state.grid.angles[segment.first : segment.last + 1]
        inside = angles < segment.end
        h = state.film_thickness[segment.first : segment.last + 1]
        unit = one.viscosity * own.surface_speed * own.radius / own.clearance**2
        slope = unit * (6.0 / (h / own.clearance) ** 2 + segment.constant / (h / own.clearance) ** 3)
        local = own.width * (own.surface_speed * h / 2.0 - h**3 / (12.0 * one.viscosity * own.radius) * slope)
        assert local[inside] == pytest.approx(one.flow, rel=1e-9)
        shear = one.viscosity * own.surface_speed / h + h / (2.0 * own.radius) * slope
        rest = (
            0.5 * (segment.end - angles[inside][-1]) * (shear[inside][-1] + np.interp(segment.end, angles, shear))
        )
        drag = np.trapezoid(shear[inside], angles[inside]) + rest
        power = own.surface_speed * own.radius * own.width * drag
        assert power == pytest.approx(one.friction_power, rel=1e-4)
        capacity = own.lubricant.volumetric_heat_capacity(one.mean_temperature)
        rise = one.outlet_temperature - one.inlet_temperature
        assert capacity * one.flow * rise == pytest.approx(one.heat, rel=1e-12)
        work = one.flow * (one.pressure_end - one.pressure_start)
        assert one.heat == pytest.approx(one.friction_power - work, rel=1e-12)
    last = state.segments[-1]
    at_rupture = np.interp(last.segment.end, state.grid.angles, gap.thickness)
    half = 0.5 * own.surface_speed * own.clearance * own.width
    assert last.flow == pytest.approx(half * at_rupture, rel=1e-6)


def test_blind_groove_passes_on_what_enters():
    state = solved("blind")
    assert state.groove_side_flow == pytest.approx(0.0, abs=1e-9 * state.segments[0].flow)
    assert state.groove_pressure > 0.0
    assert state.segments[1].inlet_temperature == state.segments[0].outlet_temperature


# kind, angle, mixing factor: p_m, p_g, p_max MPa, Q cm3/s, A W, t_m and t_out degC of each segment
REFERENCE = [
    ("none", 150, 1.0, 7.28, 0.0, 14.6, (6.67,), (565,), (64.1,), (88.1,)),
    ("through", 135, 1.0, 3.74, 0.0, 8.4, (20.32, 6.06), (353, 319), (44.9, 55.0), (49.9, 70.0)),
    ("through", 150, 1.0, 4.33, 0.0, 7.6, (14.45, 5.76), (435, 249), (48.6, 52.3), (57.1, 64.6)),
    ("through", 165, 1.0, 5.41, 0.0, 10.9, (10.08, 5.46), (493, 146), (53.9, 47.6), (67.8, 55.2)),
    ("through", 150, 0.0, 4.20, 0.0, 7.6, (14.45, 5.76), (435, 156), (48.6, 64.8), (57.1, 72.5)),
    ("blind", 150, 1.0, 8.52, 15.4, 15.5, (7.28, 7.28), (535, 42), (56.5, 79.0), (73.0, 85.1)),
]


@pytest.mark.parametrize("row", REFERENCE, ids=lambda row: "-".join(map(str, row[:3])))
def test_reference_numbers(row):
    kind, angle, factor, mean, groove, highest, flows, powers, middles, outlets = row
    state = solved(kind, angle, factor)
    assert 1e-6 * state.specific_load == pytest.approx(mean, rel=5e-3)
    assert 1e-6 * state.groove_pressure == pytest.approx(groove, rel=5e-3)
    assert 1e-6 * state.film_pressure.max() == pytest.approx(highest, rel=5e-3, abs=0.05)
    assert [1e6 * one.flow for one in state.segments] == pytest.approx(flows, rel=5e-3)
    assert [one.friction_power for one in state.segments] == pytest.approx(powers, rel=5e-3, abs=0.5)
    assert [one.mean_temperature - ZERO for one in state.segments] == pytest.approx(middles, abs=0.2)
    assert [one.outlet_temperature - ZERO for one in state.segments] == pytest.approx(outlets, abs=0.2)


# -- published trends ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", OILS)
@pytest.mark.parametrize("angle", [135, 150, 165])
def test_a_through_groove_cools_and_a_blind_one_does_not_at_equal_gap(name, angle):
    own = oil(*OILS[name])
    outlet = {
        kind: film_at_eccentricity(film(kind, angle, lubricant=own, cells=720), 0.8).outlet_temperature
        for kind in ("none", "through", "blind")
    }
    assert outlet["none"] - outlet["through"] >= 15.0
    assert abs(outlet["none"] - outlet["blind"]) <= 6.0


@pytest.mark.parametrize("angle", [120, 135, 150, 165])
def test_a_through_groove_cuts_the_load_at_equal_gap(angle):
    assert 0.50 <= solved("through", angle).load / solved("none").load <= 0.75


def test_cutting_the_film_is_most_of_what_a_blind_groove_does():
    cut = film_at_eccentricity(film("blind", width=0.0), 0.8)
    assert cut.outlet_temperature - ZERO == pytest.approx(85.9, abs=0.2)
    assert 1e-6 * cut.specific_load == pytest.approx(8.6, abs=0.05)
    assert solved("blind").load < cut.load


@pytest.mark.parametrize(
    ("angle", "eccentricity", "outlet"), [(135, 0.915, 109.6), (150, 0.925, 107.8), (165, 0.955, 120.6)]
)
def test_under_equal_load_the_groove_heats(angle, eccentricity, outlet):
    plain, grooved = loaded("none"), loaded("through", angle)
    assert plain.eccentricity_ratio == pytest.approx(0.66, abs=0.005)
    assert plain.outlet_temperature - ZERO == pytest.approx(69.4, abs=0.3)
    assert grooved.eccentricity_ratio == pytest.approx(eccentricity, abs=0.005)
    assert grooved.outlet_temperature - ZERO == pytest.approx(outlet, abs=1.0)


def test_both_comparisons_are_made():
    found = ungrooved_films(film("through", 150), loaded("through", 150))
    assert found.same_gap.eccentricity_ratio == loaded("through", 150).eccentricity_ratio
    assert found.same_load.load == pytest.approx(LOAD, rel=1e-4)
    assert found.cut_same_load.outlet_temperature < found.same_load.outlet_temperature
    assert found.same_gap.outlet_temperature > loaded("through", 150).outlet_temperature


def test_yielding_wall_raises_the_thinnest_film():
    """Contrary to the source: a wall that yields to the local pressure keeps the oil in."""
    zones, films, flows = [], [], []
    for compliance in (0.0, 1e-12, 2e-12, 4e-12):
        state = film_under_load(film(compliance=compliance, cells=720), LOAD)
        zones.append(math.degrees(state.width_of_narrow_zone()))
        films.append(1e6 * state.film_thickness.min())
        flows.append(1e6 * state.segments[0].flow)
    assert zones == pytest.approx([36.5, 40.5, 41.5, 44.0], abs=0.8)
    assert films[0] == pytest.approx(26.0, abs=0.2)
    assert all(30.0 <= thin <= 31.5 for thin in films[1:])
    assert flows[0] == pytest.approx(11.4, abs=0.1)
    assert all(13.1 <= flow <= 13.7 for flow in flows[1:])


def test_yielding_wall_does_not_save_the_grooved_film():
    grooved = film("through", 150, compliance=4e-12, cells=180)
    with pytest.raises(NoFilmError) as caught:
        film_under_load(grooved, LOAD)
    assert caught.value.outcome is Outcome.OVERLOADED
    assert caught.value.capacity / (0.1 * 0.07) == pytest.approx(3.5e6, rel=0.05)


@pytest.mark.parametrize(("eccentricity", "ratio", "outlet"), [(0.98, 50.0, 271.0), (0.995, 200.0, 529.0)])
def test_claimed_eccentricities_are_not_those_of_a_rigid_film(eccentricity, ratio, outlet):
    state = film_at_eccentricity(film(), eccentricity)
    assert state.film.clearance / state.film_thickness.min() == pytest.approx(ratio, rel=1e-9)
    assert state.outlet_temperature - ZERO == pytest.approx(outlet, abs=2.0)


# -- closures and limits ---------------------------------------------------------------------------------------


def test_missing_oil_can_only_be_fresh():
    """Before a groove in the thin film less enters it than the film behind takes: κ cannot fall to 0."""
    own = replace(
        film("through", 150, 0.0, cells=720), groove=Groove(math.radians(40.0), 6e-3, GrooveKind.THROUGH, 0.0)
    )
    state = film_at_eccentricity(own, 0.3)
    first, second = state.segments
    share = max(0.0, 1.0 - first.flow / second.flow)
    expected = share * own.supply_temperature + (1.0 - share) * first.outlet_temperature
    assert second.inlet_temperature == pytest.approx(expected, abs=1e-9)


def test_groove_behind_the_rupture_leaves_the_film_alone():
    own = replace(film(cells=720), groove=Groove(math.radians(280.0), 6e-3, GrooveKind.THROUGH))
    state, plain = film_at_eccentricity(own, 0.8), film_at_eccentricity(film(cells=720), 0.8)
    assert state.segments[0].segment.ruptures
    assert state.segments[1].friction_power == 0.0
    assert state.load == pytest.approx(plain.load, rel=1e-4)


def test_fed_groove_carries_load_of_its_own():
    own = film("through", 150, cells=720)
    fed = replace(own, groove=replace(own.groove, pressure=5e6))
    assert film_at_eccentricity(fed, 0.8).load > film_at_eccentricity(own, 0.8).load


def test_profile_of_a_rigid_film_is_that_film():
    own = film(cells=720)
    angles = np.linspace(0.0, 2.0 * math.pi, 720, endpoint=False)
    points = tuple((float(a), own.clearance * (1.0 + 0.8 * math.cos(a))) for a in angles)
    given_film = film_at_eccentricity(replace(own, profile=points), 0.0)
    rigid = film_at_eccentricity(own, 0.8)
    assert given_film.load == pytest.approx(rigid.load, rel=1e-6)
    assert given_film.outlet_temperature == pytest.approx(rigid.outlet_temperature, abs=1e-3)


def test_a_wall_that_hardly_yields_is_rigid():
    soft, rigid = (film_at_eccentricity(film(compliance=k, cells=720), 0.7) for k in (1e-18, 0.0))
    assert soft.load == pytest.approx(rigid.load, rel=1e-5)


@settings(max_examples=25)
@given(
    eccentricity=st.floats(0.05, 0.95),
    angle=st.floats(60.0, 200.0),
    kind=st.sampled_from(["through", "blind"]),
    factor=st.floats(0.0, 1.0),
)
def test_any_groove_has_a_finite_answer(eccentricity, angle, kind, factor):
    state = film_at_eccentricity(film(kind, angle, factor, cells=360), eccentricity)
    assert state.converged
    assert np.isfinite(state.film_pressure).all()
    assert state.film_pressure.min() >= -1e-6 * state.film_pressure.max()
    assert all(one.flow > 0.0 and one.outlet_temperature >= one.inlet_temperature - 1e-9 for one in state.segments)


def test_intervals_converge():
    loads = [film_at_eccentricity(film("through", cells=n), 0.8).load for n in (360, 720, 1440)]
    assert abs(loads[2] - loads[1]) < abs(loads[1] - loads[0])
    assert loads[2] == pytest.approx(loads[1], rel=1e-3)


def test_edges_of_the_groove_are_nodes():
    own = film("through", 143.3, cells=720)
    grid = Grid.of(own)
    assert (grid.angles[grid.before], grid.angles[grid.behind]) == own.groove_edges()
