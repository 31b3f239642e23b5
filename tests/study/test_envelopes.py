"""The operating envelope of every template: a map over the fields that its kind names, every status read."""

from __future__ import annotations

import math

import numpy as np
import pytest
from studied_cases import block, journal

from babbitt.case import parse_case, template
from babbitt.case.with_units import with_units
from babbitt.core.kind import kinds
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.report.study_content import study_tables
from babbitt.solving import solve
from babbitt.study.plan import plan
from babbitt.study.study import case_of, run_study
from babbitt.study.yields import WITHIN

POINTS = {"hydrostatic_thrust_ring": 3, "hydrostatic_journal": 3, "thrust_line": 3}
"""Along each axis, of kinds that take a second a row or so; 4 of all others."""

AXES = {
    "machine": ("*.speed", "*.load"),
    "shaft": ("speed", "gears.0.power"),
    "overhung_coupling": ("coupling_mass", "mesh_force"),
    "screw_heel": ("speed", "face_gap"),
    "hydrostatic_pad": ("supply.pressure", "load"),
    "hydrostatic_thrust_ring": ("supply.pressure", "load"),
    "jacking_pocket": ("relief_pressure", "load"),
}
"""Other axes than speed and load."""

LIGHTER = {
    "thrust": ("ring_stiffness:", "tilt:", "runout:"),
    "thrust_line": ("ring_stiffness:", "tilt:", "runout:", "  - {amplitude"),
}
"""Lines of templates without which all pads are alike, so that one of them is solved."""

SHIPPED = [name for name, kind in kinds().items() if kind.model.startswith("babbitt.")]


@pytest.fixture(scope="module")
def envelopes():
    """The coarse envelope of each template, computed once."""
    found = {}

    def of(kind):
        if kind not in found:
            lines = template(kind).replace("method: film", "method: {kind: film, accuracy: draft}").splitlines()
            kept = [line for line in lines if not line.startswith(LIGHTER.get(kind, ("\0",)))]
            found[kind] = run_study(
                plan(parse_case("\n".join(kept)), block(kind="map", points=POINTS.get(kind, 4)))
            )
        return found[kind]

    return of


def grid(study, name, bearing):
    """A column over the axes: across, then up."""
    own = study.columns[name][study.columns["bearing"] == bearing]
    return own.reshape(math.isqrt(own.size), -1)


def bearings(study):
    return [str(one) for one in dict.fromkeys(study.columns["bearing"])]


@pytest.mark.parametrize("kind", SHIPPED)
def test_every_template_has_an_envelope(kind, envelopes):
    """Every point is answered or says why not; an empty region says why."""
    study = envelopes(kind)
    assert tuple(one["path"] for one in study.inputs) == AXES.get(kind, ("speed", "load"))
    columns = study.columns
    known = {outcome.name.lower() for outcome in Outcome}
    assert set(columns["status"]) <= known | {"refused"}
    solved = columns["status"] == "converged"
    assert solved.any()
    assert all(bool(said) is not done for said, done in zip(columns["message"], solved, strict=True))
    checks = [table for table in study_tables(study) if table.title.startswith("Checks over")]
    assert len(checks) == len(bearings(study))
    for bearing, table in zip(bearings(study), checks, strict=True):
        verdicts = grid(study, "verdict", bearing)
        assert verdicts.shape == (POINTS.get(kind, 4),) * 2
        within = np.isin(verdicts, WITHIN).sum()
        assert table.notes[0].startswith(f"{within} of {verdicts.size} points")
        if not within:
            assert kind in ("overhung_coupling", "screw_heel"), "kinds without limits"
            assert "no limit" in table.notes[1]


@pytest.mark.parametrize("kind", SHIPPED)
def test_a_point_of_an_envelope_is_the_case_that_says_so(kind, envelopes):
    study = envelopes(kind)
    place = int(np.flatnonzero(study.columns["status"] == "converged")[-1])
    row = study.columns["row"][place]
    case = case_of(study, int(row))
    one = list(study.columns["bearing"][study.columns["row"] == row]).index(study.columns["bearing"][place])
    result = case.calculations()[one].solve()[0].result
    for name in study.outputs:
        assert result.values.get(name, np.nan) == pytest.approx(study.columns[name][place], rel=1e-6, nan_ok=True)


@pytest.mark.parametrize("kind", ["journal", "machine", "hydrostatic_journal", "tilting_pad_journal", "thrust"])
def test_more_load_presses_the_film_thinner_and_does_not_make_less_pressure(kind, envelopes):
    study = envelopes(kind)
    for bearing in bearings(study):
        assert (np.diff(grid(study, "minimum_film_thickness", bearing), axis=1) < 0.0).all()
        assert (np.diff(grid(study, "maximum_pressure", bearing), axis=1) > 0.0).all()


def test_a_pad_film_of_one_temperature_is_as_warm_at_any_speed(envelopes):
    """Similarity of tilting pads: power over flow goes as eta U / h^2, which the load alone sets."""
    study = envelopes("thrust")
    (bearing,) = bearings(study)
    outlet = grid(study, "outlet_temperature", bearing)
    np.testing.assert_allclose(outlet, np.broadcast_to(outlet[:1], outlet.shape), rtol=1e-9)
    assert (np.diff(outlet, axis=1) > 0.0).all()
    power = grid(study, "friction_power", bearing)
    assert (np.diff(power, axis=0) > 0.0).all()


@pytest.mark.parametrize("kind", ["journal", "machine", "tilting_pad_journal"])
def test_more_speed_takes_more_power_and_heats_the_oil(kind, envelopes):
    study = envelopes(kind)
    for bearing in bearings(study):
        assert (np.diff(grid(study, "friction_power", bearing), axis=0) > 0.0).all()
        assert (np.diff(grid(study, "outlet_temperature", bearing), axis=0) > 0.0).all()


@pytest.mark.parametrize("kind", ["hydrostatic_pad", "hydrostatic_thrust_ring"])
def test_a_recess_carries_no_more_than_its_supply_pressure_times_its_area(kind, envelopes):
    """What is carried at a pressure is carried at a larger one, with a thicker film."""
    study = envelopes(kind)
    (bearing,) = bearings(study)
    film = grid(study, "minimum_film_thickness", bearing)
    carried = np.isfinite(film)
    assert not carried.all()
    assert (np.diff(carried.astype(int), axis=0) >= 0).all()
    assert (np.diff(carried.astype(int), axis=1) <= 0).all()
    assert (np.diff(film, axis=0)[carried[:-1]] > 0.0).all()


def test_jacking_lifts_where_the_relief_valve_bears_the_breakaway_pressure(envelopes):
    """The margin of C304 is 1 - p_b/p_r, with p_b proportional to the load and independent of p_r."""
    study = envelopes("jacking_pocket")
    (bearing,) = bearings(study)
    margin = grid(study, "margin_C304", bearing)
    relief, load = (grid(study, one, bearing) for one in ("relief_pressure", "load"))
    breakaway = (1.0 - margin) * relief
    np.testing.assert_allclose(breakaway, np.broadcast_to(breakaway[:1], breakaway.shape), rtol=1e-9)
    assert (np.diff(breakaway, axis=1) > 0.0).all()
    assert ((margin >= 0.0) == np.isin(grid(study, "verdict", bearing), WITHIN)).all()
    assert (np.diff(load, axis=1) > 0.0).all()


def test_slopes_of_a_shaft_grow_with_the_torque(envelopes):
    """The tooth force is P/(omega r): more slope with more power, less with more speed."""
    study = envelopes("shaft")
    margin = grid(study, "margin_C501", "Intermediate shaft")
    assert (np.diff(margin, axis=1) < 0.0).all()
    assert (np.diff(margin, axis=0) > 0.0).all()


def test_transition_and_whirl_have_their_lines(envelopes):
    """Slow and heavy: mixed friction (C111); fast and light: the screening of whirl (C112) is missed."""
    study = envelopes("journal")
    (bearing,) = bearings(study)
    transition, whirl = (grid(study, name, bearing) for name in ("margin_C111", "advisory_C112"))
    assert (np.diff(transition, axis=0) > 0.0).all()
    assert (np.diff(transition, axis=1) < 0.0).all()
    assert (np.diff(whirl, axis=1) > 0.0).all()
    assert whirl[-1, 0] < 0.0 < whirl[0, -1]
    assert "advisory_C115" in envelopes("hydrostatic_journal").columns
    assert "margin_C401" in envelopes("tilting_pad_journal").columns


def test_the_line_of_the_critical_mass_is_the_whirl_threshold():
    """Margin of C115 with a rotor mass: m_cr/m - 1, zero where the threshold speed is the speed."""
    film = journal(
        method={"kind": "film", "accuracy": "draft"},
        supply_element=None,
        grooves=[{"angle": "90 deg", "extent": "20 deg"}],
        materials=None,
        surfaces=None,
        effective_temperature="60 degC",
        load="4 kN",
        rotor_mass="400 kg",
    )
    vary = {"speed": {"range": ["1000 rpm", "6000 rpm", 3]}, "load": ["4 kN", "8 kN"]}
    outputs = ["critical_mass", "minimum_film_thickness"]
    study = run_study(plan(film, block(kind="map", vary=vary, outputs=outputs)))
    margin, mass = study.columns["margin_C115"], study.columns["critical_mass"]
    known = np.isfinite(mass)
    assert known.any()
    np.testing.assert_allclose(margin[known], mass[known] / 400.0 - 1.0, rtol=1e-9)


def test_shares_scale_every_place_and_keep_directions():
    """Components of a load keep their direction; operating points count in place of their bearing."""
    points = [{"name": "slow", "speed": "500 rpm"}, {"name": "fast", "surface_speed": "12 m/s"}]
    case = journal(load={"x": "3 kN", "y": "-4 kN"}, operating_points=points)
    made = plan(case, block(kind="map", points=2, outputs=["minimum_film_thickness"]))
    speed, load = made.task.inputs
    assert list(speed.given) == ["operating_points.0.speed", "operating_points.1.surface_speed"]
    assert list(load.given) == ["load"]
    half = made.task.case({"*.speed": 0.5, "*.load": 0.5})
    whole, less = solve(case).results, solve(half).results
    for one, other in zip(whole, less, strict=True):
        assert other.load == pytest.approx(0.5 * one.load)
        assert other.load_angle == pytest.approx(one.load_angle)
        assert other.angular_speed == pytest.approx(0.5 * one.angular_speed)
    assert with_units(half.origin.given, half)["operating_points"][0]["speed"] == "250 rpm"


def test_what_is_not_given_is_no_axis():
    with pytest.raises(InputError, match="gives no load"):
        plan(journal(load=None, eccentricity_ratio=0.6), block(kind="map"))
    with pytest.raises(InputError, match=r"there are: \*\.speed, \*\.load, \*\.power"):
        plan(journal(), block(kind="sweep", vary={"*.width": [1, 2]}))
    with pytest.raises(InputError, match="gives no power or torque"):
        plan(journal(), block(kind="sweep", vary={"*.power": [1, 2]}))
