"""Slopes of results: against closed forms, against the stiffness of the film, and where they cannot be had."""

from __future__ import annotations

import math
import pickle
import warnings
from dataclasses import replace

import numpy as np
import pytest

import babbitt as bb
from babbitt.api import sweeping
from babbitt.api.gradient import Gradient

PAD = {
    "method": "quick",
    "pad": bb.CircularPad(diameter="100 mm", recess_diameter="50 mm"),
    "restrictor": {"kind": "constant_flow", "flow": "1 L/min"},
    "oil": {"viscosity": "20 mPa s", "density": "870 kg/m3", "heat_capacity": "2000 J/(kg K)"},
    "load": "11 kN",
    "speed": "0 rpm",
    "supply": {"pressure": "5 MPa"},
    "recess_oil": {"depth": "1 mm"},
}
FILM = {
    "diameter": "200 mm",
    "width": "120 mm",
    "clearance": bb.relative_clearance("1.5 permille"),
    "grooves": bb.grooves(["0 deg", "180 deg"], extent="20 deg", pressure="0 Pa"),
    "lubricant": {"kind": "constant", "dynamic_viscosity": "20 mPa s", "density": "870 kg/m3"},
    "supply": {"temperature": "45 degC", "pressure": "0 Pa"},
    "materials": {"bearing": "C45", "journal": "C45"},
    "method": bb.Film(accuracy="engineering"),
    "speed": "3000 rpm",
    "effective_temperature": "50 degC",
}


@pytest.fixture(scope="module")
def pad():
    return bb.HydrostaticPad(**PAD)


def film(**given):
    return bb.JournalBearing(**FILM, **given)


def test_the_gap_of_a_pad_under_constant_flow(pad):
    """h³ = Q times a constant over p, and p is proportional to the load."""
    result = pad.solve()
    slopes = result.gradient(["load", "oil.viscosity", "restrictor.flow"], of="gap")
    gap = result.gap
    assert slopes["gap"]["load"] == pytest.approx(-gap / pad.load / 3.0, rel=1e-6)
    assert slopes["gap"]["oil.viscosity"] == pytest.approx(gap / 0.02 / 3.0, rel=1e-6)
    assert slopes["gap"]["restrictor.flow"] == pytest.approx(gap / pad.restrictor.flow / 3.0, rel=1e-6)
    assert slopes.steps["load"] == pytest.approx(110.0)
    assert slopes.errors["gap"]["load"] < 1e-3 * abs(slopes["gap"]["load"])
    assert not slopes.doubtful


def test_slopes_of_the_force_are_the_stiffness_of_the_film():
    at = film(position={"x": "30 um", "y": "-60 um"})
    result = at.solve()
    slopes = result.gradient(["position.x", "position.y"], of=["load", "load_angle"])
    load, angle = result.load, result.load_angle
    stiffness = np.empty((2, 2))
    for column, field in enumerate(("position.x", "position.y")):
        size, turn = slopes["load"][field], slopes["load_angle"][field]
        stiffness[:, column] = (
            size * math.cos(angle) - load * turn * math.sin(angle),
            size * math.sin(angle) + load * turn * math.cos(angle),
        )
    # The load balances the force of the film: moving the journal by dx asks for a load larger by K dx.
    assert np.abs(stiffness - result.stiffness).max() < 5e-3 * np.abs(result.stiffness).max()


def test_slopes_of_matrices_have_their_shape_and_scale():
    """At one Sommerfeld number stiffness is proportional to the load, so that K = W dK/dW + speed dK/dspeed."""
    result = film(load="20 kN").solve()
    slopes = result.gradient(["load", "speed"], of=["stiffness", "eccentricity_ratio"])
    stiffness = slopes["stiffness"]
    assert stiffness["load"].shape == (2, 2)
    euler = 20e3 * stiffness["load"] + result.case.speed * stiffness["speed"]
    assert np.abs(euler - result.stiffness).max() < 0.02 * np.abs(result.stiffness).max()
    ratio = slopes["eccentricity_ratio"]
    assert 20e3 * ratio["load"] == pytest.approx(-result.case.speed * ratio["speed"], rel=0.02)
    with pytest.raises(ValueError, match="read-only"):
        stiffness["load"][0, 0] = 0.0


def test_a_temperature_steps_by_a_kelvin():
    bearing = film(load="20 kN").replace(lubricant="ISO VG 46")
    slopes = bearing.gradient("effective_temperature", of="minimum_film_thickness")
    assert slopes.steps == {"effective_temperature": 1.0}
    warm, cold = (bearing.solve(effective_temperature=t).minimum_film_thickness for t in ("53 degC", "47 degC"))
    slope = slopes["minimum_film_thickness"]["effective_temperature"]
    assert slope == pytest.approx((warm - cold) / 6.0, rel=0.02)
    assert slope < 0.0


def test_a_step_lost_in_the_digits_is_refused(pad):
    with pytest.raises(bb.CaseError, match="is lost beside"):
        pad.gradient("load", of="gap", steps={"load": 1e-9})


def test_a_slope_lost_in_what_a_search_leaves_open_is_told(pad, monkeypatch):
    """A gap that is found to a millionth, by a search that ends elsewhere for every load."""
    exact, ends = sweeping.over_points, np.random.default_rng(7)

    def over_points(*given):
        for one in exact(*given):
            values = {**one.result.values, "gap": one.gap * (1.0 + 1e-6 * ends.uniform(-1.0, 1.0))}
            yield replace(one, solution=replace(one.solution, result=replace(one.result, values=values)))

    monkeypatch.setattr(sweeping, "over_points", over_points)
    usual = pad.gradient("load", of="gap")
    assert not usual.doubtful
    assert usual["gap"]["load"] == pytest.approx(-pad.solve().gap / pad.load / 3.0, rel=2e-3)
    with pytest.warns(UserWarning, match="gap over load"):
        lost = pad.gradient("load", of="gap", steps={"load": "0.1 N"})
    assert lost.doubtful == (("gap", "load"),)
    assert lost.errors["gap"]["load"] > 0.05 * abs(lost["gap"]["load"])


def test_a_zero_needs_a_step(pad):
    turned = film(load="20 kN", misalignment={"x": "0 mrad", "y": "0.1 mrad"})
    with pytest.raises(bb.CaseError, match=r"is zero.*steps="):
        turned.gradient("misalignment.x", of="minimum_film_thickness")


@pytest.mark.parametrize(
    ("field", "says"),
    [
        ("restrictor.flows", "did you mean 'restrictor.flow'"),
        ("lod", "did you mean 'load'"),
        ("method", "is not a field with a quantity"),
        ("name", "is not a field with a quantity"),
        ("supply.flow", "is not a field with a quantity|did you mean"),
    ],
)
def test_a_field_that_is_none_is_refused_with_the_nearest(pad, field, says):
    with pytest.raises(bb.CaseError, match=says):
        pad.gradient(["load", field], of="gap")


def test_a_quantity_that_is_none_is_refused_with_the_nearest(pad):
    with pytest.raises(bb.InputError, match="did you mean 'gap'"):
        pad.gradient("load", of=["gpa"])
    with pytest.raises(bb.InputError, match="workers"):
        pad.gradient("load", of=["gap"], workers=0)


def test_neighbours_that_are_refused_are_told_before_any_is_solved(pad):
    with pytest.raises(bb.CaseError, match="load"):
        pad.gradient("load", of="gap", steps={"load": "20 kN"})


def test_neighbours_without_an_operating_point_give_no_number():
    """A position beside the bore: half a step further the journal stands outside."""
    near = film(position={"x": "0 um", "y": "-148 um"})
    slopes = near.gradient("position.y", of=["load"], steps={"position.y": "4 um"})
    assert math.isnan(slopes["load"]["position.y"])
    assert slopes.reasons["load", "position.y"]
    assert not slopes.doubtful
    assert slopes.reasons["load", "position.y"] in repr(slopes)


def test_one_of_several_results_has_no_case_to_change():
    bearings = [film(load="20 kN"), film(load="10 kN")]
    result = bb.solve(bb.Machine(bearings=bearings)).results[0]
    with pytest.raises(bb.InputError, match="does not know its case"):
        result.gradient("load", of="eccentricity_ratio")
    with pytest.raises(bb.CaseError, match="2 bearings"):
        bb.Machine(bearings=bearings).gradient("bearings.0.load", of="eccentricity_ratio")


def test_a_result_keeps_its_case_through_a_pickle_and_out_of_comparisons(pad):
    result = pad.solve()
    copied = pickle.loads(pickle.dumps(result))
    assert copied.case == pad
    assert copied == result == bb.solve(pad).results[0]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        slopes = copied.gradient("load", of="gap")
    assert isinstance(pickle.loads(pickle.dumps(slopes)), Gradient)
    assert len(repr(slopes).splitlines()) == 1
    assert dict(slopes).keys() == {"gap"}
