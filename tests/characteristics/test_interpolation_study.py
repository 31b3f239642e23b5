"""The study of linear against logarithmic interpolation of So comes out as published and as computed elsewhere."""

import numpy as np
import pytest

from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.validation.research.interpolation_study import coarse_tables, interpolation_study

# mean and largest |round trip| in per cent, largest X, eps of it; independent computation
EXPECTED = {
    (360, (0.25, 0.5, 0.75, 1.0)): ((5.01, 11.68), (1.94, 5.94), 1.2287, 0.678),
    (180, (0.25, 0.5, 0.75, 1.0)): ((4.86, 11.50), (1.82, 5.64), 1.2283, 0.678),
    (360, (0.25, 0.5, 1.0)): ((7.1, 13.2), (3.7, 8.5), 1.27, None),
    (360, (0.5, 2 / 3, 1.0)): ((3.1, 7.5), (1.0, 3.6), 1.21, None),
}


@pytest.mark.parametrize(("span", "columns"), EXPECTED)
def test_round_trip_errors(span, columns):
    linear, logarithmic, ratio, place = EXPECTED[span, columns]
    study = interpolation_study(span, column_width_ratios=columns)
    for errors, (mean, largest) in (
        (study.round_trip_linear, linear),
        (study.round_trip_logarithmic, logarithmic),
    ):
        assert 100 * np.abs(errors).mean() == pytest.approx(mean, abs=0.1)
        assert 100 * np.abs(errors).max() == pytest.approx(largest, abs=0.1)
    assert study.largest_ratio == pytest.approx(ratio, abs=0.006)
    if place is not None:
        assert study.eccentricity_ratio_of_largest_ratio == pytest.approx(place, abs=0.005)


@pytest.mark.parametrize(("span", "linear", "logarithmic"), [(360, 26.19, 3.78), (180, 25.99, 3.70)])
def test_forward_errors(span, linear, logarithmic):
    study = interpolation_study(span)
    working = (study.eccentricity_ratios >= 0.2) & (study.eccentricity_ratios <= 0.9)
    assert 100 * study.forward_error_linear[working].max() == pytest.approx(linear, abs=0.1)
    assert 100 * study.forward_error_linear[working].min() == pytest.approx(-1.8, abs=0.1)
    assert 100 * study.forward_error_logarithmic[working].max() == pytest.approx(logarithmic, abs=0.1)
    assert 100 * study.forward_error_logarithmic[working].min() == pytest.approx(-7.84, abs=0.1)


def test_what_the_study_published():
    # linear: more than 8 %; logarithmic: clearly less; X up to about 1.2
    study = interpolation_study()
    largest_linear = np.abs(study.round_trip_linear).max()
    assert largest_linear > 0.08
    assert np.abs(study.round_trip_logarithmic).mean() < 0.03
    assert np.abs(study.round_trip_logarithmic).max() < largest_linear - 0.03
    assert 1.15 < study.largest_ratio < 1.25


@pytest.mark.parametrize("eccentricity", [0.1, 0.4, 0.6])
def test_between_the_columns_a_row_is_bent_and_lines_lie_on_either_side(eccentricity):
    """Up to ε = 0.6 So is convex over B/D and ln So concave: a chord lies above, one in ln So below."""
    at = np.array([eccentricity])
    linear, logarithmic = coarse_tables()
    for ratio in (0.25, 0.5, 0.75, 1.0):
        exact = curves(360, ratio).sommerfeld_number(eccentricity)
        assert linear.level(at, ratio)[0] == pytest.approx(exact, rel=1e-12)
        assert np.exp(logarithmic.level(at, ratio)[0]) == pytest.approx(exact, rel=1e-12)
    between = linear.level(at, 0.375)[0], np.exp(logarithmic.level(at, 0.375)[0])
    assert between[1] < curves(360, 0.375).sommerfeld_number(eccentricity) < between[0]


def test_our_round_trip_closes():
    assert np.abs(interpolation_study(120, 0.33).round_trip_spline).max() < 1e-12


def test_at_the_nodes_of_the_coarse_table_nothing_is_lost():
    study = interpolation_study(360, 0.75)
    at_nodes = np.isin(study.eccentricity_ratios.round(6), [0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95])
    assert at_nodes.sum() == 7
    assert np.abs(study.forward_error_linear[at_nodes]).max() < 1e-12
    assert np.abs(study.forward_error_logarithmic[at_nodes]).max() < 1e-12
