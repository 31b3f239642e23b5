"""Smallest, mean and largest clearance by cold and hot oil, for every kind with a tolerance band."""

from __future__ import annotations

import numpy as np
import pytest
from studied_cases import block, journal

from babbitt.case import parse_case, template
from babbitt.core.notices import InputError
from babbitt.report.study_content import study_tables
from babbitt.report.study_figures import _sweep
from babbitt.solving import solve
from babbitt.study.plan import plan
from babbitt.study.study import case_of, run_study

FIT = {"kind": "fit", "bore": "H7", "journal": "e8"}
OIL = (48.0, 58.0, 68.0)
"""degC, of the textbook bearing."""


def corners(case, **given):
    return run_study(plan(case, block(kind="corners", **given)))


def column(study, name, bearings=3):
    """A column by oil, cold first, and clearance, smallest first."""
    return study.columns[name].reshape(-1, bearings)


def judged(result, name):
    """A result; of a film that its supply does not limit, the limited one is itself."""
    return result.values.get(name, result.values.get(name.removeprefix("starved_")))


def test_each_corner_is_the_case_that_says_so():
    study = corners(journal(clearance=FIT))
    assert study.columns["supply.temperature"][::3] - 273.15 == pytest.approx(OIL)
    for place, oil in enumerate(OIL):
        supply = {"temperature": f"{oil} degC", "pressure": "0.5 MPa"}
        results = solve(journal(clearance=FIT, clearance_cases="all", supply=supply)).results
        assert [str(result.name) for result in results] == list(column(study, "bearing")[place])
        for name in study.outputs:
            found = column(study, name)[place]
            assert found == pytest.approx([judged(result, name) for result in results], rel=1e-12)
    assert len(case_of(study, 0).calculations()) == 3


def test_more_clearance_takes_more_oil_and_cold_oil_makes_thicker_films():
    study = corners(journal(clearance=FIT))
    flow, film, warm = (
        column(study, name) for name in ("total_flow", "minimum_film_thickness", "effective_temperature")
    )
    assert (np.diff(flow, axis=1) > 0.0).all()
    assert (np.diff(film, axis=0) < 0.0).all()
    assert (np.diff(warm, axis=0) > 0.0).all()
    assert (np.diff(warm, axis=1) < 0.0).all()
    (table, varied) = study_tables(study)
    assert table.title == "Corners"
    assert len(table.rows) == 9
    assert "assumption" in varied.rows[0][3]


def test_films_have_stiffness_damping_and_threshold_at_every_corner():
    film = journal(
        method={"kind": "film", "accuracy": "draft"},
        clearance=FIT,
        supply_element=None,
        grooves=[{"angle": "90 deg", "extent": "20 deg"}],
        surfaces=None,
        rotor_mass="800 kg",
    )
    study = corners(film, vary={"supply.temperature": ["58 degC"]})
    results = solve(case_of(study, 0)).results
    wanted = [[result.stiffness[0][0], result.damping[0][1], result.threshold_speed] for result in results]
    found = [study.columns[name] for name in ("stiffness_xx", "damping_xy", "threshold_speed")]
    np.testing.assert_allclose(np.transpose(found), wanted, rtol=1e-6)
    assert (np.diff(study.columns["total_flow"]) > 0.0).all()


def test_a_kind_that_computes_one_clearance_has_all_three():
    """Recesses behind capillaries: a wider gap lets more oil through, and its size is that of the tolerances."""
    lines = template("hydrostatic_journal").replace(
        "clearance: {kind: radial, mean: 50 um}",
        "clearance: {kind: radial, minimum: 40 um, mean: 50 um, maximum: 60 um}",
    )
    kept = [line for line in lines.splitlines() if not line.startswith(("oil:", "supply:", "frequencies:"))]
    kept += ["lubricant: ISO VG 22", "supply: {pressure: 5 MPa, temperature: 40 degC}"]
    text = "\n".join(kept).replace("method: film", "method: {kind: film, accuracy: draft}")
    study = corners(parse_case(text), vary={"supply.temperature": ["30 degC", "40 degC"]})
    assert list(study.columns["clearance"]) == [one for one in ("smallest", "mean", "largest") for _ in range(2)]
    flow = study.columns["total_flow"].reshape(3, 2)
    assert (np.diff(flow, axis=0) > 0.0).all()
    assert (np.diff(flow, axis=1) > 0.0).all(), "warm oil is thinner"
    assert np.isfinite(study.columns["stiffness_xx"]).all()
    largest = case_of(study, int(study.columns["row"][-1]))
    assert largest.radial_clearance() == pytest.approx(60e-6)


@pytest.mark.parametrize("kind", ["machine", "shaft", "tilting_pad_journal"])
def test_kinds_that_compute_all_clearances(kind):
    text = template(kind)
    band = {
        "machine": ("{kind: relative, mean: 1.2 permille}", "{kind: fit, bore: H7, journal: e7}"),
        "shaft": ("{kind: relative, mean: 1.5 permille}", "{kind: fit, bore: H7, journal: e7}"),
        "tilting_pad_journal": ("mean: 148 um", "minimum: 138 um, mean: 148 um, maximum: 158 um"),
    }[kind]
    assert band[0] in text
    study = corners(parse_case(text.replace(*band)), vary={"supply.temperature": ["40 degC", "50 degC"]})
    names = [str(one) for one in dict.fromkeys(study.columns["bearing"])]
    three = [[name for name in names if f"({which} clearance)" in name] for which in ("minimum", "maximum")]
    assert len(three[0]) == len(three[1]) > 0
    for least, most in zip(*three, strict=True):
        flows = [study.columns["total_flow"][study.columns["bearing"] == name] for name in (least, most)]
        assert (flows[0] < flows[1]).all()


def test_what_has_no_band_or_no_temperature_is_refused():
    with pytest.raises(InputError, match="clearance_cases: all needs the limits"):
        plan(journal(), block(kind="corners"))
    with pytest.raises(InputError, match="no clearance with a smallest"):
        plan(parse_case(template("thrust")), block(kind="corners"))
    without = {"supply": None, "effective_temperature": "50 degC", "supply_element": None, "surfaces": None}
    constant = {"kind": "constant", "dynamic_viscosity": "20 mPa s"}
    dry = journal(method="film", clearance=FIT, lubricant=constant, **without)
    with pytest.raises(InputError, match="no oil is cold or hot"):
        plan(dry, block(kind="corners"))


def test_panels_and_curves_say_what_they_show():
    """A legend had bare numbers, a figure no clearance, the panel above an empty place no numbers."""
    case = journal(clearance=FIT, clearance_cases="all")
    outputs = ("minimum_film_thickness", "friction_power")  # each with that of the film short of oil
    vary = {"load": ["10 kN", "20 kN"], "speed": ["1000 rpm", "1500 rpm"]}
    study = run_study(plan(case, block(kind="sweep", vary=vary, outputs=outputs)))
    titles = []
    for _, _, figure in _sweep(study):
        (legend,) = figure.legends
        assert [one.get_text() for one in legend.get_texts()] == ["speed 1000 rpm", "speed 1500 rpm"]
        titles.append(legend.get_title().get_text())
        shown = [one.xaxis.get_tick_params()["labelbottom"] for one in figure.axes if one.axison]
        assert shown == [False, True, True, True]
    assert titles == [f"Textbook bearing ({one} clearance)" for one in ("minimum", "mean", "maximum")]
