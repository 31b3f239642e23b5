"""A viscosity law of one's own: the oil that it samples, one path with YAML, its name in reports, refusals."""

from __future__ import annotations

import pickle
import traceback

import numpy as np
import pytest

import babbitt as bb
from babbitt import case as case_language
from babbitt.case import case_hash

GIVEN = {
    "diameter": "100 mm",
    "width": "50 mm",
    "clearance": "H7/e8",
    "span": "360 deg",
    "load": "10 kN",
    "speed": "1500 rpm",
    "supply": {"temperature": "50 degC", "pressure": "0.1 MPa"},
    "supply_element": {"kind": "pocket", "width": "30 mm", "place": "both_sides"},
    "materials": {"bearing": "C10", "journal": "C45"},
}


def made(viscosity, **given):
    return bb.viscosity_law(
        viscosity, **({"coldest": "0 degC", "warmest": "120 degC", "describe": "mine"} | given)
    )


def test_the_oil_of_a_catalogue_by_its_own_function_gives_its_bearing():
    board = bb.lubricant("ISO VG 46")
    given = {"volumetric_heat_capacity": "1.7 MJ/(m3 K)"}
    own = bb.JournalBearing(**GIVEN, lubricant=made(board.dynamic_viscosity, **given)).solve()
    named = bb.JournalBearing(**GIVEN, lubricant={"kind": "catalogue", "name": "ISO VG 46", **given}).solve()
    assert own.minimum_film_thickness == pytest.approx(named.minimum_film_thickness, rel=1e-3)
    assert own.effective_temperature == pytest.approx(named.effective_temperature, abs=0.05)


def test_it_is_sampled_at_once_and_is_one_case_with_its_file():
    calls = []

    def viscosity(kelvin):
        calls.append(kelvin)
        return 6e-5 * np.exp(1000.0 / (kelvin - 175.0))

    bearing = bb.JournalBearing(**GIVEN, lubricant=made(viscosity, warmest=380.0))
    assert len(calls) == 55
    assert np.diff(calls).max() <= 2.0
    assert (calls[0], calls[-1]) == (273.15, 380.0)
    read = case_language.parse_case(bearing.to_yaml())
    assert case_hash(read) == case_hash(bearing)
    result = bearing.solve()
    assert len(calls) == 55
    assert result.settings["lubricant"] == "mine"
    assert hash(pickle.loads(pickle.dumps(bearing))) == hash(bearing)
    law = bearing.lubricant.lubricant().viscosity_law
    assert [law(kelvin) for kelvin in calls[:5]] == [float(viscosity(kelvin)) for kelvin in calls[:5]]


def test_a_table_is_a_part_and_a_dict():
    points = [
        {"temperature": f"{t} degC", "kinematic_viscosity": f"{nu} mm2/s"}
        for t, nu in ((20, 126), (50, 30), (99, 7))
    ]
    as_dict = bb.JournalBearing(lubricant={"kind": "table", "points": points})
    assert as_dict == bb.JournalBearing(lubricant=bb.TableLubricant(points=points))
    assert as_dict.lubricant.lubricant().kinematic_viscosity(323.15) == pytest.approx(30e-6, rel=1e-15)
    mixed = [*points[:2], {"temperature": "99 degC", "dynamic_viscosity": "6 mPa s"}]
    for bad, says in (
        (points[:2], "3"),
        (points[::-1], "must differ|exchanged"),
        (mixed, "some viscosities are dynamic"),
    ):
        with pytest.raises(bb.CaseError, match=says):
            bb.TableLubricant(points=bad)


def test_a_result_outside_the_table_says_so():
    oil = made(lambda kelvin: 6e-5 * np.exp(1000.0 / (kelvin - 175.0)), coldest="70 degC")
    assert "W107" in {one.code for one in bb.JournalBearing(**GIVEN, lubricant=oil).solve().warnings}


@pytest.mark.parametrize(
    ("viscosity", "given", "says"),
    [
        (lambda kelvin: 0.02, {}, "must fall"),
        (lambda kelvin: np.nan, {}, "gives nan at 273.15 K"),
        (lambda kelvin: -kelvin, {}, "gives -273.15"),
        (lambda kelvin: np.array([0.1, 0.2]), {}, "gives a ndarray at 273.15 K"),
        (lambda kelvin: None, {}, "gives a NoneType at 273.15 K"),
        (lambda: 0.02, {}, "TypeError"),
        (lambda kelvin: 1e6 / kelvin, {}, "1000 Pa s"),
        (lambda kelvin: 1 / kelvin, {"warmest": "-10 degC"}, "is not above"),
        (lambda kelvin: 1 / kelvin, {"warmest": "10 kg"}, "is a mass"),
        (lambda kelvin: 1 / kelvin, {"densty": 870.0}, "density"),
    ],
)
def test_what_is_no_law_is_refused(viscosity, given, says):
    with pytest.raises(bb.CaseError, match=says):
        made(viscosity, **given)


def test_a_failing_function_is_named_in_one_message_without_a_chain():
    def thinning(kelvin):
        return 1.0 / (kelvin - 273.15)

    with pytest.raises(bb.CaseError) as caught:
        made(thinning)
    shown = "".join(traceback.format_exception(caught.value))
    assert len(str(caught.value).splitlines()) == 1
    assert shown.count("Traceback") == 1
    for told in ("thinning", "test_own_viscosity.py, line", "273.15 K", "ZeroDivisionError", "viscosity in Pa s"):
        assert told in str(caught.value)
