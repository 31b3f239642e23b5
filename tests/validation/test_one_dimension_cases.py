"""Published cases of the films of one dimension: they can fail, and they say what they claim."""

import copy
from importlib import import_module

import pytest

from babbitt.kinds.journal.infinitely_long_bearing.model import Discretisation
from babbitt.validation import summary
from babbitt.validation.published import grooved_segments, long_film_isothermal
from babbitt.validation.published.long_film_bearing import solved
from babbitt.validation.reference_data import reference_data


@pytest.mark.parametrize(
    ("module", "data", "change"),
    [
        ("long_film_table", "long_film", lambda d: d["relative_load"]["12000"].__setitem__(4, 33.2)),
        (
            "long_film_figures",
            "long_film",
            lambda d: d.update({"load_over_mean_temperature_load_at_3000_rpm_and_0.8": 0.95}),
        ),
        ("grooved_segments", "grooved", lambda d: d["reference"][2].update(p_MPa=4.40)),
        ("grooved_segments", "grooved", lambda d: d["reference"][5]["T_out_C"].__setitem__(1, 84.7)),
    ],
)
def test_a_wrong_number_in_the_data_makes_its_case_fail(module, data, change, monkeypatch):
    case = import_module(f"babbitt.validation.published.{module}")
    assert summary(case.run()).agrees
    spoilt = copy.deepcopy(reference_data(data))
    change(spoilt)
    monkeypatch.setattr(case, "reference_data", lambda name: spoilt)
    assert not summary(case.run.__wrapped__()).agrees


def test_a_wrong_closed_form_makes_its_case_fail(monkeypatch):
    exact = long_film_isothermal.exact
    monkeypatch.setattr(long_film_isothermal, "exact", lambda e: {k: 1.006 * v for k, v in exact(e).items()})
    assert not summary(long_film_isothermal.run.__wrapped__()).agrees


def test_the_page_of_the_table_says_how_far_the_flow_varies():
    assert solved(Discretisation.PUBLISHED_MEAN, 3000, 0.3).flow_spread == pytest.approx(0.05, abs=0.02)
    assert solved(Discretisation.PUBLISHED_MEAN, 3000, 0.8).flow_spread == pytest.approx(1.6, abs=0.3)


def test_the_page_of_the_groove_says_how_much_colder():
    hot = grooved_segments.solved("none").outlet_temperature
    colder = [hot - grooved_segments.solved("through", angle).outlet_temperature for angle in (135, 150, 165)]
    assert colder == pytest.approx([18.0, 23.5, 33.0], abs=0.5)
