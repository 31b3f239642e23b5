"""What makes a study impossible: one clear line each, before anything is computed or written."""

from __future__ import annotations

import numpy as np
import pytest
import yaml
from studied_cases import JOURNAL, block, journal

import babbitt as bb
from babbitt import load_case, parse_case
from babbitt.case.loading import case_from_dict
from babbitt.core.notices import InputError
from babbitt.study.grids import TOLERANCE_SAMPLES, require_bearable
from babbitt.study.inputs import inputs_of

BAD = {
    "unknown path": ({"vary": {"laod": [1.0]}}, "did you mean 'load'"),
    "unknown part": ({"vary": {"supply.temprature": [1.0]}}, "'temprature' is no field of supply"),
    "beyond a value": ({"vary": {"load.x": [1.0]}}, "'load' holds one value"),
    "not numeric": ({"vary": {"lubricant": {"uniform": ["1 kN", "2 kN"]}}}, "not numeric"),
    "another kind of quantity": ({"vary": {"load": {"uniform": ["1 kN", "2 mm"]}}}, "'2 mm' is a length"),
    "no unit": ({"vary": {"load": {"uniform": [1000, "2 kN"]}}}, "1000 has no unit"),
    "empty range": ({"vary": {"load": {"range": ["5 kN", "5 kN", 4]}}}, "is empty"),
    "log of zero": ({"vary": {"load": {"log_range": ["-1 kN", "5 kN", 4]}}}, "above zero"),
    "contradictory limits": ({"vary": {"load": {"uniform": ["5 kN", "2 kN"]}}}, "rising values"),
    "no scatter": ({"vary": {"load": {"normal": ["5 kN", "0 kN"]}}}, "a standard deviation above zero"),
    "below the field": ({"vary": {"load": {"normal": ["5 kN", "2 kN"]}}}, "the smallest value -1 kN"),
    "above a rule": ({"vary": {"width": {"uniform": ["30 mm", "60 mm"]}}}, "the pocket reaches outside"),
    "no value taken": ({"vary": {"load": ["-1 kN", "-2 kN"]}}, "takes none of its values"),
    "no such fit": ({"vary": {"clearance": {"fit": "H7/z9"}}}, "'z9' is not included"),
    "fit of a load": ({"vary": {"load": {"fit": "H7/e8"}}}, "is no clearance"),
    "grade of a load": ({"vary": {"load": {"scatter": "vg"}}}, "is no lubricant"),
    "no such table": ({"vary": {"load": {"table": "missing.csv"}}}, "there is no such file"),
    "twice": ({"vary": {"lubricant": ["ISO VG 32", "ISO VG 32"]}}, "twice"),
}


@pytest.mark.parametrize(("given", "says"), BAD.values(), ids=BAD)
def test_a_field_that_cannot_vary_so_is_told(given, says):
    with pytest.raises(InputError) as refused:
        inputs_of(journal(), block(kind="tolerance", **given))
    assert says in refused.value.message
    assert refused.value.message.startswith("study.vary.")
    assert "\n" not in refused.value.message


@pytest.mark.parametrize("kind", ["radial", "diametral"])
def test_a_clearance_is_read_as_the_kind_that_the_case_has(kind):
    case = journal(clearance={"kind": kind, "mean": "70 um"})
    (one,) = inputs_of(case, block(kind="tolerance", vary={"clearance.mean": {"uniform": ["60 um", "80 um"]}}))
    assert one.unit == "m"
    assert one.law.support == pytest.approx((60e-6, 80e-6))
    assert one.meaning == f"Mean {kind} clearance"
    with pytest.raises(InputError, match="a length"):
        inputs_of(case, block(kind="tolerance", vary={"clearance.mean": ["1.2 permille"]}))


def test_a_fit_that_varies_gives_each_row_one_clearance():
    fit = {"clearance": {"fit": "H7/c8"}}
    (one,) = inputs_of(journal(clearance="H7/c8", clearance_cases="all"), block(kind="tolerance", vary=fit))
    assert "clearance_cases: mean" in one.reason
    film = "minimum_film_thickness"
    of_all, of_mean = (
        bb.parse_case(yaml.safe_dump({**JOURNAL, "clearance": "H7/c8", "clearance_cases": asked}))
        .study("tolerance", fit, samples=30)
        .table[film]
        for asked in ("all", "mean")
    )
    assert np.array_equal(of_all, of_mean)


def test_a_million_million_samples_are_refused_with_their_size():
    with pytest.raises(InputError, match=r"1e\+12 rows, about .* GB"):
        require_bearable(1e12, 20)
    require_bearable(TOLERANCE_SAMPLES, 20)


IMPOSSIBLE = {
    "typo in a law": ({"kind": "tolerance", "vary": {"load": {"unifrm": [1, 2]}}}, "did you mean 'uniform'"),
    "two laws": (
        {"kind": "tolerance", "vary": {"load": {"uniform": ["1 kN", "2 kN"], "fit": "H7/e8"}}},
        "given together with uniform",
    ),
    "nothing varies": ({"kind": "tolerance"}, "varies at least one"),
    "one axis": ({"kind": "map", "vary": {"load": ["1 kN"]}}, "a map has two axes"),
    "no objective": ({"kind": "optimise", "vary": {"load": ["1 kN"]}}, "needs an objective"),
    "contradicting objectives": (
        {"kind": "optimise", "vary": {"load": ["1 kN"]}, "minimise": ["load"], "maximise": ["load"]},
        "contradict each other",
    ),
    "shares": (
        {"kind": "spectrum", "load_cases": [{"share": 0.4, "set": {"load": "1 kN"}}]},
        "the shares sum up to 0.4",
    ),
    "samples of a sweep": ({"kind": "sweep", "vary": {"load": ["1 kN"]}, "samples": 10}, "is not read"),
    "unknown kind": ({"kind": "tolerence", "vary": {"load": ["1 kN"]}}, "did you mean 'tolerance'"),
}


@pytest.mark.parametrize(("study", "says"), IMPOSSIBLE.values(), ids=IMPOSSIBLE)
def test_a_block_that_contradicts_itself_is_told(study, says):
    with pytest.raises(InputError) as refused:
        case_from_dict({**JOURNAL, "study": study})
    assert says in refused.value.message
    assert "study" in refused.value.message


def test_a_study_beside_a_case_changes_nothing_of_it():
    from babbitt.case.case_hash import case_hash

    study = {"kind": "tolerance", "vary": {"load": {"uniform": ["1 kN", "2 kN"]}}}
    plain, studied = case_from_dict(JOURNAL), case_from_dict({**JOURNAL, "study": study})
    assert case_hash(plain) == case_hash(studied)
    assert plain == studied
    assert studied.study_block.kind == "tolerance"
    assert "study" not in studied.origin.given


def test_a_file_tells_the_line_of_its_study(tmp_path):
    import yaml

    text = yaml.safe_dump(JOURNAL, sort_keys=False)
    line = text.count("\n") + 4
    text += "study:\n  kind: tolerance\n  vary:\n    load: {unifrm: [1 kN, 2 kN]}\n"
    (tmp_path / "case.yaml").write_text(text)
    with pytest.raises(InputError, match=f"case.yaml:{line}: study.vary.load.unifrm"):
        load_case(tmp_path / "case.yaml")


def test_bearings_of_a_machine_are_named():
    case = parse_case(MACHINE)
    vary = {"bearings.Second.load": ["1 kN", "2 kN"], "lubricant": {"scatter": "vg"}}
    load, oil = inputs_of(case, block(kind="tolerance", vary=vary))
    assert load.field == "bearings.1.load"
    assert oil.law.support == pytest.approx((41.4e-6, 50.6e-6), rel=1e-9)


MACHINE = """
kind: machine
name: Two bearings
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.2 MPa}
materials: {bearing: {thermal_expansion: 11e-6 1/K}, journal: {thermal_expansion: 11e-6 1/K}}
bearings:
  - {kind: journal, name: First, diameter: 100 mm, width: 50 mm, clearance: H7/e8,
    span: 360 deg, load: 5 kN, speed: 1000 rpm, supply_element: {kind: hole, diameter: 6 mm, place: opposite}}
  - {kind: journal, name: Second, diameter: 80 mm, width: 40 mm, clearance: H7/e8,
    span: 360 deg, load: 4 kN, speed: 1000 rpm, supply_element: {kind: hole, diameter: 6 mm, place: opposite}}
"""


def test_the_oil_of_a_grade_keeps_its_viscosity_index():
    from babbitt.properties.lubricants import viscosity_index

    case = journal()
    (oil,) = inputs_of(case, block(kind="tolerance", vary={"lubricant": {"scatter": "vg"}}))
    nominal = case.lubricant.lubricant()
    thin = case_from_dict({**JOURNAL, "lubricant": oil.in_case(oil.law.support[0])}).lubricant.lubricant()
    middle = case_from_dict({**JOURNAL, "lubricant": oil.in_case(46e-6)}).lubricant.lubricant()
    nu40, nu100 = (thin.kinematic_viscosity(kelvin) for kelvin in (313.15, 373.15))
    assert nu40 == pytest.approx(0.9 * 46e-6, rel=1e-9)
    index = viscosity_index(*(nominal.kinematic_viscosity(kelvin) for kelvin in (313.15, 373.15)))
    assert viscosity_index(nu40, nu100) == pytest.approx(index, abs=0.01)
    for kelvin in np.linspace(300.0, 380.0, 5):
        assert middle.dynamic_viscosity(kelvin) == pytest.approx(nominal.dynamic_viscosity(kelvin), rel=2e-3)
        assert middle.density(kelvin) == pytest.approx(nominal.density(kelvin), rel=1e-3)
