"""The tables and their splines: consistency, monotony, limits and answers outside the range."""

import math
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.kinds.journal.iso7902.characteristics import (
    SPANS_DEGREES,
    ClosedFormCurves,
    curves,
    sommerfeld_number,
    table,
)
from babbitt.validation.research.arc_film import solve_arc

QUANTITIES = ("sommerfeld_number", "attitude_angle", "side_flow_number", "pressure_ratio")
spans = st.sampled_from(SPANS_DEGREES)
width_ratios = st.floats(0.1, 1.5)


@given(spans, width_ratios, st.floats(1e-9, 0.99))
def test_inverse_gives_the_eccentricity_back(span, width_ratio, eccentricity_ratio):
    shape = curves(span, width_ratio)
    load = shape.sommerfeld_number(eccentricity_ratio)
    back = shape.eccentricity_ratio(load)
    assert back == pytest.approx(eccentricity_ratio, rel=1e-12)
    assert shape.sommerfeld_number(back) == pytest.approx(load, rel=1e-12)


@given(spans, width_ratios)
def test_arrays_and_numbers_agree(span, width_ratio):
    shape = curves(span, width_ratio)
    eccentricities = np.array([[0.0, 0.004, 0.01], [0.3333, 0.9, 0.99]])
    for name in QUANTITIES:
        many = getattr(shape, name)(eccentricities)
        single = [getattr(shape, name)(float(eps)) for eps in eccentricities.flat]
        assert many.shape == (2, 3)
        assert_allclose(many.ravel(), single, rtol=1e-13)
    loads = shape.sommerfeld_number(eccentricities)
    assert_allclose(shape.eccentricity_ratio(loads), eccentricities, rtol=1e-12)
    scattered = sommerfeld_number(span, eccentricities, np.full((2, 1), width_ratio))
    assert_allclose(scattered, loads, rtol=1e-12)


@pytest.mark.parametrize("span", SPANS_DEGREES)
def test_load_rises_strictly_with_eccentricity(span):
    eccentricities = np.linspace(0.0, 0.99, 4001)
    for width_ratio in np.geomspace(0.1, 1.5, 41):
        assert (np.diff(curves(span, float(width_ratio)).sommerfeld_number(eccentricities)) > 0).all()


@pytest.mark.parametrize("span", SPANS_DEGREES)
def test_load_attitude_and_flow_vary_without_ripples_between_nodes(span):
    # what physics makes monotone stays monotone between the nodes as well
    eccentricities = np.linspace(0.01, 0.99, 1500)
    for width_ratio in np.geomspace(0.1, 1.5, 23):
        shape = curves(span, float(width_ratio))
        assert (np.diff(shape.attitude_angle(eccentricities)) < 0).all()
        assert (np.diff(shape.pressure_ratio(eccentricities[eccentricities > 0.05])) > 0).all()
        flow = shape.side_flow_number(eccentricities)
        assert (np.diff(flow) > 0).all() if span == 360 else (np.diff(flow / eccentricities) < 0).all()
    width_ratios = np.geomspace(0.1, 1.5, 1500)
    for eccentricity_ratio in (0.01, 0.3, 0.8, 0.99):
        assert (np.diff(sommerfeld_number(span, eccentricity_ratio, width_ratios)) > 0).all()


def test_longer_arc_carries_more_and_loses_more():
    eccentricities = np.linspace(0.02, 0.98, 49)
    for width_ratio in (0.1, 0.5, 1.5):
        by_span = [curves(span, width_ratio) for span in sorted(SPANS_DEGREES)]
        # up to 180 deg; pressure more than 90 deg off the load line pushes the wrong way
        assert (np.diff([each.sommerfeld_number(eccentricities) for each in by_span[:4]], axis=0) > 0).all()
        assert (np.diff([each.side_flow_number(eccentricities) for each in by_span], axis=0) > 0).all()


@pytest.mark.parametrize("span", SPANS_DEGREES)
def test_small_eccentricities_follow_the_linear_limit(span):
    shape, tiny = curves(span, 0.6), 0.002
    fresh = solve_arc(math.radians(span), 0.6, tiny)
    assert shape.sommerfeld_number(tiny) == pytest.approx(fresh.sommerfeld_number, rel=0.002)
    assert shape.side_flow_number(tiny) == pytest.approx(fresh.side_flow_number, rel=0.02)
    assert shape.attitude_angle(tiny) == pytest.approx(fresh.attitude_angle, abs=math.radians(0.05))
    assert shape.pressure_ratio(tiny) == pytest.approx(fresh.pressure_ratio, rel=0.002)
    assert shape.sommerfeld_number(0.0) == shape.side_flow_number(0.0) == shape.eccentricity_ratio(0.0) == 0.0
    below, above = shape.attitude_angle(0.01 - 1e-9), shape.attitude_angle(0.01 + 1e-9)
    assert below - shape.attitude_angle(0.01) == pytest.approx(shape.attitude_angle(0.01) - above, rel=1e-3)


@pytest.mark.parametrize(
    ("span", "width_ratio", "eccentricity_ratio"),
    [
        (360, 0.107, 0.0123),
        (360, 0.883, 0.9871),
        (180, 1.437, 0.447),
        (150, 0.1171, 0.9889),
        (120, 0.5131, 0.9336),
        (120, 1.463, 0.983),
        (90, 0.3127, 0.0177),
        (90, 1.357, 0.8113),
    ],
)
def test_between_nodes_the_splines_meet_fresh_solutions(span, width_ratio, eccentricity_ratio):
    shape = curves(span, width_ratio)
    fresh = solve_arc(math.radians(span), width_ratio, eccentricity_ratio)
    assert shape.sommerfeld_number(eccentricity_ratio) == pytest.approx(fresh.sommerfeld_number, rel=1e-4)
    assert shape.attitude_angle(eccentricity_ratio) == pytest.approx(fresh.attitude_angle, abs=math.radians(0.005))
    assert shape.side_flow_number(eccentricity_ratio) == pytest.approx(fresh.side_flow_number, rel=1e-4)
    assert shape.pressure_ratio(eccentricity_ratio) == pytest.approx(fresh.pressure_ratio, rel=1e-4)


@pytest.mark.parametrize("span", SPANS_DEGREES)
def test_nodes_are_what_the_solver_computes(span):
    nodes = table(span)
    for row, column in ((0, -1), (25, 12), (-1, 0)):
        x, eps = float(nodes.width_ratios[column]), float(nodes.eccentricity_ratios[row])
        fresh = solve_arc(math.radians(span), x, eps)
        assert nodes.sommerfeld_numbers[row, column] == pytest.approx(fresh.sommerfeld_number, rel=2e-7)
        assert nodes.attitude_angles[row, column] == pytest.approx(fresh.attitude_angle, rel=2e-7)
        assert nodes.side_flow_numbers[row, column] == pytest.approx(fresh.side_flow_number, rel=2e-6)
        assert nodes.pressure_ratios[row, column] == pytest.approx(fresh.pressure_ratio, rel=2e-6)
        assert curves(span, x).sommerfeld_number(eps) == pytest.approx(fresh.sommerfeld_number, rel=2e-7)


def test_tables_cover_the_range_promised():
    for span in SPANS_DEGREES:
        nodes = table(span)
        assert (nodes.width_ratios[0], nodes.width_ratios[-1]) == (0.1, 1.5)
        assert (nodes.eccentricity_ratios[0], nodes.eccentricity_ratios[-1]) == (0.01, 0.99)
        assert nodes.sommerfeld_numbers.shape == (len(nodes.eccentricity_ratios), len(nodes.width_ratios))


def test_same_shape_is_cut_from_the_table_once():
    assert curves(180, 0.604) is curves(180, 0.604)


@pytest.mark.parametrize("shape", [curves(180, 0.5), ClosedFormCurves(0.5)], ids=["table", "closed form"])
class TestOutsideTheRange:
    def test_load_beyond_the_largest(self, shape):
        largest = shape.largest_sommerfeld_number
        assert shape.eccentricity_ratio(largest) == pytest.approx(0.99, rel=1e-12)
        for load in (1.000001 * largest, math.inf, math.nan, -1e-9):
            with pytest.raises(ValueError, match=f"from 0 to {largest:.6g}.*given was"):
                shape.eccentricity_ratio(load)
        with pytest.raises(ValueError, match="given was 500"):
            shape.eccentricity_ratio(np.array([0.1, 500.0]))

    @pytest.mark.parametrize("eccentricity_ratio", [-0.01, 0.9901, math.nan])
    @pytest.mark.parametrize("name", QUANTITIES)
    def test_eccentricity_beyond_the_nodes(self, shape, name, eccentricity_ratio):
        with pytest.raises(ValueError, match=r"from 0 to 0\.99"):
            getattr(shape, name)(eccentricity_ratio)
        with pytest.raises(ValueError, match=r"from 0 to 0\.99"):
            getattr(shape, name)(np.array([0.5, eccentricity_ratio]))


@pytest.mark.parametrize("width_ratio", [0.0999, 1.5001, math.nan, -1.0])
def test_width_ratio_outside_the_tables(width_ratio):
    with pytest.raises(InputError, match=r"from 0\.1 to 1\.5; given was") as caught:
        curves(360, width_ratio)
    assert caught.value.code == "E006"
    with pytest.raises(InputError, match=r"from 0\.1 to 1\.5"):
        sommerfeld_number(360, 0.5, [0.5, width_ratio])


def test_scattered_eccentricities_outside_the_tables():
    with pytest.raises(ValueError, match=r"from 0 to 0\.99"):
        sommerfeld_number(360, [0.5, 0.995], 0.5)


def test_span_between_the_tables():
    with pytest.raises(InputError, match="360, 180, 150, 120, 90 deg; given was 130") as caught:
        curves(130, 0.5)
    assert caught.value.code == "E006"


def test_looking_up_a_characteristic_does_not_load_scipy():
    # half a second at the start of every check
    script = (
        "import sys; from babbitt.kinds.journal.iso7902.characteristics import curves, ClosedFormCurves, friction;"
        "curves(120, 0.7).eccentricity_ratio(1.0); ClosedFormCurves(0.7).eccentricity_ratio(1.0);"
        "sys.exit(any(name.split('.')[0] == 'scipy' for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0


@given(spans, width_ratios)
def test_largest_load_is_accepted_to_the_last_bit(span, width_ratio):
    shape = curves(span, width_ratio)
    largest = shape.largest_sommerfeld_number
    for load in (math.nextafter(largest, math.inf), math.nextafter(largest, 0.0)):
        assert shape.eccentricity_ratio(load) == pytest.approx(0.99, rel=1e-12)
        assert shape.eccentricity_ratio(load) <= 0.99
        assert shape.eccentricity_ratio(np.array([load]))[0] <= 0.99


@pytest.mark.parametrize(
    ("width_ratio", "degrees", "orlov"), [(0.125, 89.9, 0.83), (0.5, 88.4, 0.72), (1.0, 85.0, 0.69)]
)
def test_what_the_documentation_says_of_light_loads_and_of_orlov(width_ratio, degrees, orlov):
    """The angle that the full bearing tends to without load, and the eccentricity at So = 1.95 B/D."""
    full = curves(360, width_ratio)
    assert math.degrees(full.attitude_angle(1e-5)) == pytest.approx(degrees, abs=0.06)
    assert full.eccentricity_ratio(1.95 * width_ratio) == pytest.approx(orlov, abs=0.006)
