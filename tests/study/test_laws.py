"""Distributions against their closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from babbitt.study.laws import Choices, Difference, HalfNormal, Listed, Normal, Triangular, Uniform

SHARES = np.linspace(0.0, 1.0, 101)


def test_a_truncated_normal_law_is_that_of_scipy():
    law, theirs = Normal(10.0, 2.0), stats.truncnorm(-3.0, 3.0, 10.0, 2.0)
    np.testing.assert_allclose(law.quantiles(SHARES), theirs.ppf(SHARES), rtol=1e-9)
    values = np.linspace(*law.support, 31)
    np.testing.assert_allclose(law.share_below(values), theirs.cdf(values), atol=1e-12)
    np.testing.assert_allclose(law.density(values), theirs.pdf(values), rtol=1e-9)


def test_a_triangular_law_is_that_of_scipy():
    law, theirs = Triangular(2.0, 3.0, 7.0), stats.triang(0.2, 2.0, 5.0)
    np.testing.assert_allclose(law.quantiles(SHARES), theirs.ppf(SHARES), rtol=1e-12)


def test_a_half_normal_law_is_the_magnitude_of_a_normal_one():
    law, full = HalfNormal(2.0), Normal(0.0, 2.0)
    np.testing.assert_allclose(law.quantiles(SHARES), full.quantiles(0.5 * (1.0 + SHARES)), atol=1e-12)
    assert law.support == (0.0, 6.0)


def test_the_difference_of_two_uniform_sizes_is_triangular():
    law = Difference(Uniform(3.0, 4.0), Uniform(1.0, 2.0))
    theirs = stats.triang(0.5, 1.0, 2.0)
    np.testing.assert_allclose(law.quantiles(SHARES), theirs.ppf(SHARES), atol=2e-5)
    assert law.quantiles(np.array([0.0, 1.0])).tolist() == [1.0, 3.0]


def test_variances_of_two_normal_sizes_add_up():
    bore, journal = Normal(17.5, 5.8), Normal(-99.0, 9.0)
    law = Difference(bore, journal)
    values = law.quantiles((np.arange(200_000) + 0.5) / 200_000)
    one_sided = stats.truncnorm(-3.0, 3.0).var()
    assert values.mean() == pytest.approx(116.5, abs=1e-4)
    assert values.var() == pytest.approx(one_sided * (5.8**2 + 9.0**2), rel=1e-4)
    assert law.support == pytest.approx((116.5 - 3.0 * 14.8, 116.5 + 3.0 * 14.8))


def test_lists_take_each_value_as_often():
    shares = (np.arange(30) + 0.5) / 30
    assert np.unique(Listed((3.0, 1.0, 2.0)).quantiles(shares), return_counts=True)[1].tolist() == [10, 10, 10]
    assert Choices(("a", "b")).chosen(np.array([0.0, 0.49, 0.5, 1.0])).tolist() == ["a", "a", "b", "b"]
