"""A groove that keeps its place in the bush, and the temperature of the oil on its way past it."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.grooved_long_bearing.model import AngleOrigin
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.grooved_long_bearing.ungrooved_reference import ungrooved_films
from babbitt.validation.published.grooved_segments import film

LOAD = 6.5e6 * 0.1 * 0.07


def in_bush(kind, degrees, **more):
    """The published bearing with its groove at an angle from the load line."""
    own = film(kind, cells=720, **more)
    return replace(own, groove=replace(own.groove, angle=math.radians(degrees), origin=AngleOrigin.LOAD_LINE))


@pytest.mark.parametrize("kind", ["through", "blind"])
@pytest.mark.parametrize("degrees", [-90.0, -60.0, -20.0, 0.0, 20.0, 60.0, 90.0])
def test_groove_lies_where_the_bush_has_it(kind, degrees):
    state = film_under_load(in_bush(kind, degrees), LOAD)
    assert math.degrees(state.groove_angle_from_load) == pytest.approx(degrees, abs=1e-4)
    assert state.load == pytest.approx(LOAD, rel=1e-4)
    # the same film found with that angle from the widest gap
    moved = film_at_eccentricity(state.film, state.eccentricity_ratio)
    assert moved.load == pytest.approx(state.load, rel=1e-5)
    assert moved.outlet_temperature == pytest.approx(state.outlet_temperature, abs=2e-3)


@pytest.mark.parametrize("kind", ["through", "blind"])
def test_angle_from_the_widest_gap_and_from_the_load_line_are_one_groove(kind):
    for angle in (120.0, 150.0):
        published = film_at_eccentricity(film(kind, angle, cells=720), 0.8)
        place = math.degrees(published.groove_angle_from_load)
        again = film_at_eccentricity(in_bush(kind, place), 0.8)
        assert math.degrees(again.film.groove.angle) == pytest.approx(angle, abs=1e-3)
        assert again.load == pytest.approx(published.load, rel=1e-5)


def test_published_angle_lies_behind_the_load_line_at_the_published_load():
    state = film_under_load(film("through", 150.0), LOAD)
    assert math.degrees(state.groove_angle_from_load) == pytest.approx(17.0, abs=1.0)


def test_ungrooved_films_under_load_are_cut_at_the_place_in_the_bush():
    asked = in_bush("through", -20.0)
    found = ungrooved_films(asked, film_under_load(asked, LOAD))
    assert math.degrees(found.cut_same_load.groove_angle_from_load) == pytest.approx(-20.0, abs=1e-4)
    assert found.cut_same_gap.film.groove.angle == film_under_load(asked, LOAD).film.groove.angle


def test_yielding_wall_and_place_in_the_bush_are_found_together():
    state = film_under_load(in_bush("blind", -20.0, compliance=1e-12), LOAD)
    assert math.degrees(state.groove_angle_from_load) == pytest.approx(-20.0, abs=1e-4)
    displaced = 1e-12 * state.film_pressure
    rigid = state.film.clearance * (1.0 + state.eccentricity_ratio * state.grid.cosine)
    assert state.film_thickness - rigid == pytest.approx(displaced, abs=1e-5 * state.film.clearance)


def test_groove_across_the_start_of_the_film_has_no_answer():
    """Opposite the load the widest gap, where the film begins, falls into a wide groove."""
    own = in_bush("through", -110.0, width=0.08)
    with pytest.raises(NoFilmError) as caught:
        film_under_load(own, LOAD)
    assert caught.value.outcome is Outcome.NOT_CONVERGED


@pytest.mark.parametrize("kind", ["none", "through", "blind"])
def test_oil_takes_up_heat_on_its_way(kind):
    """The temperature rises along each segment from its inlet to its outlet, and carries the heat of the shear."""
    state = film_at_eccentricity(film(kind, cells=2000), 0.8)
    for one in state.segments:
        angles = state.grid.angles[one.segment.first : one.segment.last + 1]
        inside = angles <= one.segment.end
        h = state.film_thickness[one.segment.first : one.segment.last + 1][inside]
        local = state.film_temperature[one.segment.first : one.segment.last + 1][inside]
        assert local[0] == pytest.approx(one.inlet_temperature, abs=1e-9)
        assert np.all(np.diff(local) > 0.0)
        behind = state.film_temperature[one.segment.first : one.segment.last + 1][~inside]
        assert behind == pytest.approx(np.full(behind.size, one.outlet_temperature), abs=1e-9)
        # dissipation mu v^2/h + h^3/(12 mu r^2) (dp/dtheta)^2 of each interval, from the pressure itself
        own = state.film
        slope = np.gradient(state.film_pressure, state.grid.angles)[one.segment.first : one.segment.last + 1][
            inside
        ]
        made = one.viscosity * own.surface_speed**2 / h + h**3 / (12.0 * one.viscosity * own.radius**2) * slope**2
        made *= own.radius * own.width
        heat = np.trapezoid(made[5:-5], angles[inside][5:-5])
        capacity = float(own.lubricant.volumetric_heat_capacity(one.mean_temperature)) * one.flow
        assert capacity * (local[-6] - local[5]) == pytest.approx(heat, rel=2e-3)


def test_ends_of_the_segments_have_their_outlet_temperatures():
    state = film_at_eccentricity(film("blind", cells=2000), 0.8)
    first = state.segments[0]
    assert state.film_temperature[first.segment.last] == pytest.approx(first.outlet_temperature, abs=1e-9)
    assert state.film_temperature[-1] == pytest.approx(state.outlet_temperature, abs=1e-9)
