"""The films of the pads at the front door: arrays that carry the load of every pad, and pictures."""

import json
import math

import numpy as np
import pytest
from pad_journals import FILLON_OIL, HEATED, pad_case

import babbitt as bb
from babbitt.core.notices import InputError


def solved(**fields):
    return bb.parse_case(json.dumps(pad_case(**fields))).solve()


@pytest.fixture(scope="module")
def plain():
    return solved(thermal="global")


@pytest.fixture(scope="module")
def heated():
    return solved(lubricant=FILLON_OIL, **HEATED["C"])


def test_pressure_of_every_pad_integrates_to_its_load(plain):
    """W = 2 int int p cos(theta - theta_p) R dtheta dz over half the width."""
    film, loads, pivots = plain.film, plain.pad_load, plain.pad_pivot_angle
    assert film.pressure.shape == (*film.angle.shape, film.z.shape[1])
    for angle, z, pressure, load, pivot in zip(film.angle, film.z, film.pressure, loads, pivots, strict=True):
        along = (z / z.max()) ** 2
        fitted = [np.polynomial.Polynomial.fit(along, row, z.size - 1, domain=[0, 1]) for row in pressure]
        places = np.linspace(0.0, 1.0, 101)
        over_width = [2.0 * z.max() * np.trapezoid(one(places**2), places) for one in fitted]
        found = 0.05 * np.trapezoid(np.array(over_width) * np.cos(angle - pivot), angle)
        assert found == pytest.approx(load, rel=0.01, abs=20.0)


def test_the_thinnest_film_is_that_of_the_result(plain):
    film = plain.film
    assert film.film_thickness.min() == pytest.approx(plain.minimum_film_thickness, rel=1e-3)
    assert film.gap is film.film_thickness
    assert film.pressure.max() == pytest.approx(plain.maximum_pressure)
    assert ((film.liquid_fraction >= 0.0) & (film.liquid_fraction <= 1.0)).all()
    assert film.position == pytest.approx([plain.journal_x, plain.journal_y])
    assert not film.pressure.flags.writeable
    with pytest.raises(AttributeError, match="effective_temperature"):
        _ = film.temperature


def test_lines_are_those_of_the_dataset(heated):
    film, fields = heated.film, heated.fields
    assert np.array_equal(film.pressure, fields["pressure"])
    assert np.array_equal(film.temperature, fields["film_temperature"])
    assert film.bore_temperature.max() <= heated.maximum_temperature + 1e-9
    assert film.bore_temperature.max() == pytest.approx(heated.maximum_temperature, abs=1.0)
    assert "temperature" in repr(film)


def test_pictures_are_drawn_on_the_axes_given(plain, heated):
    from matplotlib.figure import Figure

    panel = Figure().subplots()
    assert plain.plot(panel) is panel
    assert panel.get_xlabel().startswith("θ")
    drawn = Figure().subplots()
    plain.plot.gap(drawn)
    lowest = min(float(line.get_ydata().min()) for line in drawn.lines if len(line.get_ydata()) > 2)
    assert lowest == pytest.approx(1e6 * plain.minimum_film_thickness, rel=1e-3)
    assert heated.plot.polar(Figure().subplots()).patches
    warm = heated.plot.temperature(Figure().subplots())
    highest = max(float(line.get_ydata().max()) for line in warm.lines if len(line.get_ydata()) > 2)
    assert highest == pytest.approx(float(heated.film.bore_temperature.max()) - 273.15, abs=1.0)
    with pytest.raises(InputError, match="one temperature"):
        plain.plot.temperature()


def test_an_unsolved_bearing_says_why_it_has_no_film():
    lost = solved(thermal="isothermal", load="100 MN")
    assert not lost.solved
    for ask in (lambda: lost.film, lost.plot):
        with pytest.raises(AttributeError, match="no film without an operating point"):
            ask()
    assert math.isfinite(lost.result.values["wall_time"])


def test_numbers_of_pads_and_frequencies_have_one_axis(plain):
    assert plain.pad_load.shape == plain.pad_clearance.shape == (4,)
    assert plain.whirl_ratio.shape == plain.dynamic_frequency.shape == (6,)
    assert plain.dynamic_stiffness.shape == (6, 4)
    assert plain.stiffness.shape == (2, 2)
    assert plain.to_xarray()["pad_load"].dims == ("pad",)
    lighter = bb.parse_case(json.dumps(pad_case(thermal="global"))).solve(load=np.array([5e3, 10e3]))
    assert lighter["pad_load"].shape == (2, 4)
