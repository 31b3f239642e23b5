"""Numbers of numpy, quantities of pint and what is not finite, in every field that takes a quantity."""

from __future__ import annotations

import math

import numpy as np
import pint
import pytest

import babbitt as bb
from babbitt.api.gradient import quantities_of
from babbitt.case import kinds, template
from babbitt.case.field_types import field_annotations, quantity_in
from babbitt.core.units.pint_quantity import pint_quantity

REGISTRY = pint.get_application_registry()


@pytest.fixture(params=kinds(), scope="module")
def case(request):
    return bb.parse_case(template(request.param))


@pytest.fixture
def values(case):
    """By the path of each field that takes a quantity and was given, its value in SI."""
    found = {}
    for path in quantities_of(case):
        place, part = case.given, case
        for step in path.split("."):
            place = (
                place[int(step)]
                if isinstance(place, list)
                else place.get(step)
                if isinstance(place, dict)
                else None
            )
            part = part[int(step)] if isinstance(part, tuple) else getattr(part, step)
        if place is not None:
            found[path] = part
    assert found
    return found


def unit_of(case, path):
    return next(
        one.unit for one in map(quantity_in, field_annotations(case.model, path.split("."))) if one is not None
    )


@pytest.mark.parametrize("wrong", [math.nan, -math.inf, np.float32("nan"), np.array(np.inf), "nan m", "inf"])
def test_what_is_not_finite_is_refused_everywhere(case, values, wrong):
    for path in values:
        with pytest.raises(bb.CaseError, match=r"not a finite number|is not a quantity"):
            case.replace({path: wrong})


def test_numbers_of_numpy_are_numbers_everywhere(case, values):
    for path, value in values.items():
        for number in (np.float64(value), np.array(value)):
            assert case.replace({path: number}) == case, path
        short = case.replace({path: np.float32(value) * np.float32(1.0 + 2.0**-20)})
        for step in path.split("."):
            short = short[int(step)] if isinstance(short, tuple) else getattr(short, step)
        assert short == pytest.approx(value, rel=1e-5)


def test_quantities_of_another_registry_are_taken_everywhere(case, values):
    for path, value in values.items():
        unit = unit_of(case, path)
        if unit == "1":
            continue
        ours = pint_quantity(value, unit)
        other = REGISTRY.Quantity(ours.magnitude, str(ours.units))
        made = case.replace({path: other})
        for step in path.split("."):
            made = made[int(step)] if isinstance(made, tuple) else getattr(made, step)
        assert made == pytest.approx(value, rel=1e-12, abs=1e-300), path


def test_lists_of_numpy_and_of_pint_are_lists():
    departures = 1e-6 * np.cos(np.linspace(0.0, 2.0 * np.pi, 36, endpoint=False))
    plain, array, quantities = (
        bb.MeasuredBore(departures=given)
        for given in (departures.tolist(), departures, REGISTRY.Quantity(1e6 * departures, "um"))
    )
    assert plain == array
    assert quantities.departures == pytest.approx(plain.departures, rel=1e-12)
    departures[7] = np.nan
    with pytest.raises(bb.CaseError, match=r"departures\[7\]: nan is not a finite number"):
        bb.MeasuredBore(departures=departures)


@pytest.mark.parametrize("wrong", [math.nan, np.float64("inf"), "nan mm"])
def test_what_is_not_finite_is_refused_by_the_small_functions(wrong):
    for function in (bb.radial_clearance, bb.diametral_clearance, bb.relative_clearance):
        with pytest.raises(bb.CaseError):
            function(wrong)
    with pytest.raises(bb.CaseError):
        bb.grooves([0.0, wrong], extent=0.3)


@pytest.mark.parametrize(
    "changes",
    [
        {"supply.pressure": "-0.2 MPa"},
        {"dynamic_load": {"kind": "rotating", "magnitude": "1 kN", "speed_ratio": 1, "moving_mass": "-5 kg"}},
        {"rotor_mass": np.float64(-1.0)},
        {"side_pressures": ["-2 MPa", "0 MPa"]},
        {"grooves": [{"angle": 0.0, "extent": 0.3, "pressure": "-2 MPa"}]},
        {"load": [0.0, -1e4]},
        {"load": [[0.0, -1e4]]},
        {"load": np.array([1e4])},
        {"load": np.full((2, 2), 1e4)},
    ],
)
def test_what_nature_does_not_allow_is_refused(changes):
    bearing = bb.JournalBearing(
        diameter=0.2, width=0.1, clearance=bb.relative_clearance(1.5e-3), grooves=bb.grooves([0.0], extent=0.3),
        lubricant="ISO VG 46", supply={"temperature": "45 degC", "pressure": "0.1 MPa"}, load=1e4, speed=300.0,
        materials={"bearing": "C10", "journal": "C45"}, method="film",
    )  # fmt: skip
    with pytest.raises(bb.CaseError):
        bearing.replace(changes)
