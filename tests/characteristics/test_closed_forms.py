"""DIN 31652 closed forms: how far from Butenschoen's tables, and a sound inverse."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from published_tables import BUTENSCHOEN

from babbitt.core.notices import InputError, explanations
from babbitt.kinds.journal.iso7902.characteristics import ClosedFormCurves, curves
from babbitt.kinds.journal.iso7902.characteristics.closed_forms import DEVIATIONS, LARGEST_ATTITUDE_DEVIATION


def test_within_the_errors_known_of_butenschoens_tables():
    eps = np.array(BUTENSCHOEN["eccentricity_ratios"])
    for column, width_ratio in enumerate(BUTENSCHOEN["width_ratios"]):
        fit = ClosedFormCurves(width_ratio)
        assert_allclose(fit.sommerfeld_number(eps), BUTENSCHOEN["sommerfeld_number"][:, column], rtol=0.07)
        angles = np.degrees(fit.attitude_angle(eps))
        assert_allclose(angles, BUTENSCHOEN["attitude_angle_degrees"][:, column], atol=2.5)
        assert_allclose(8 * fit.side_flow_number(eps), BUTENSCHOEN["side_flow"][:, column], rtol=0.032)


def test_between_the_widths_of_the_tables_they_are_off_as_told():
    """The statement of W113: reached, and not passed."""
    eps = np.linspace(0.1, 0.99, 90)
    small = np.append(1e-4, eps)  # the side flow is off most at the centre
    off = dict.fromkeys(DEVIATIONS, 0.0)
    low = 0.0
    for ratio in np.linspace(0.125, 1.0, 36):
        fit, ours = ClosedFormCurves(float(ratio)), curves(360, float(ratio))
        misses = {
            "sommerfeld_number": fit.sommerfeld_number(eps) / ours.sommerfeld_number(eps) - 1.0,
            "attitude_angle_degrees": np.degrees(fit.attitude_angle(eps) - ours.attitude_angle(eps)),
            "side_flow": fit.side_flow_number(small) / ours.side_flow_number(small) - 1.0,
        }
        off = {name: max(off[name], float(abs(miss).max())) for name, miss in misses.items()}
        low = max(low, math.degrees(abs(fit.attitude_angle(1e-4) - ours.attitude_angle(1e-4))))
    for name, stated in DEVIATIONS.items():
        assert 0.85 * stated < off[name] < 1.005 * stated, name
    assert 0.9 * LARGEST_ATTITUDE_DEVIATION < low < LARGEST_ATTITUDE_DEVIATION
    assert "11 % in load" in explanations()["W113"].meaning
    assert "4.2 % in side flow" in explanations()["W113"].meaning


@given(st.floats(0.125, 1.0), st.floats(1e-9, 0.99))
def test_inverse_gives_the_eccentricity_back(width_ratio, eccentricity_ratio):
    fit = ClosedFormCurves(width_ratio)
    load = fit.sommerfeld_number(eccentricity_ratio)
    back = fit.eccentricity_ratio(load)
    assert back == pytest.approx(eccentricity_ratio, rel=1e-12)
    assert fit.sommerfeld_number(back) == pytest.approx(load, rel=1e-12)


def test_load_rises_strictly_and_faster_than_eccentricity():
    # the inverse is bracketed by the least and the largest So/eps, near both ends of the range
    eps = np.linspace(1e-6, 0.99, 2001)
    for width_ratio in np.linspace(0.125, 1.0, 29):
        load = ClosedFormCurves(float(width_ratio)).sommerfeld_number(eps)
        assert (np.diff(load) > 0).all()
        ratio = load / eps
        assert ratio.min() > 0.98 * ratio[0]
        assert ratio.max() == ratio[-1]


def test_arrays_and_numbers_agree():
    fit = ClosedFormCurves(0.4)
    eps = np.array([[0.0, 0.2], [0.7, 0.99]])
    for name in ("sommerfeld_number", "attitude_angle", "side_flow_number", "pressure_ratio"):
        single = [getattr(fit, name)(float(e)) for e in eps.flat]
        assert_allclose(getattr(fit, name)(eps).ravel(), single, rtol=1e-13)
    assert_allclose(fit.eccentricity_ratio(fit.sommerfeld_number(eps)), eps, rtol=1e-12)


def test_no_load_is_no_eccentricity():
    fit = ClosedFormCurves(0.6)
    assert fit.eccentricity_ratio(0.0) == 0.0
    tiny = fit.eccentricity_ratio(1e-20)
    assert fit.sommerfeld_number(tiny) == pytest.approx(1e-20, rel=1e-12)


def test_largest_pressure_is_taken_from_the_tables():
    assert ClosedFormCurves(0.5).pressure_ratio(0.8) == curves(360, 0.5).pressure_ratio(0.8)
    assert ClosedFormCurves(0.5).span_degrees == 360


@pytest.mark.parametrize("width_ratio", [0.12, 1.01, math.nan])
def test_width_ratio_outside_the_fit(width_ratio):
    with pytest.raises(InputError, match=r"from 0\.125 to 1; given was") as caught:
        ClosedFormCurves(width_ratio)
    assert caught.value.code == "E006"
