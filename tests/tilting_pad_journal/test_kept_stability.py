"""Stability and clearances that simple films keep and films with temperatures of their own, or growth, may not."""

from dataclasses import replace

import numpy as np
import pytest
from pad_journals import OIL, pad_case, result_of, solution_of

from babbitt.case import case_from_dict
from babbitt.core.result import Verdict
from babbitt.kinds.tilting_pad_journal.coefficients_over_speed import run_over_speed
from babbitt.kinds.tilting_pad_journal.left_out_deformation import left_out_bending, left_out_growth
from babbitt.solving import solve

STABLE = {
    "diameter": "116.87 mm",
    "pads": {
        "number": 5, "first_pivot": "-90 deg", "extent": "58 deg", "width": "59.7 mm", "thickness": "17.5 mm",
        "clearance": {"kind": "radial", "mean": "106.76 um"},
        "assembled_clearance": {"kind": "radial", "mean": "74.62 um"},
        "pivot": {"kind": "rocker", "fraction": 0.55},
    },
    "load": "7.562 kN", "speed": "5079 rpm", "supply": {"temperature": "45 degC"},
    "materials": {"bearing_metal": "SnSb12Cu6Pb", "pads": "C45"},
    "surfaces": {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"},
    "limits": {"minimum_film_thickness": "10 um", "specific_load": "4 MPa"},
    "rotor_mass": "770.9 kg", "shaft_stiffness": "60 MN/m", "anticipated_cross_coupling": "4.2 MN/m",
}  # fmt: skip
WALLS = {"thermal": "full", "walls": {"pads": {}, "housing": {"temperature": "55 degC"}}}
GROWN = WALLS | {"deformation": ["growth", "bending"], "reference_temperature": "20 degC"}
NARROW = {
    "diameter": "77.2 mm",
    "pads": {
        "number": 5, "first_pivot": "-90 deg", "extent": "62 deg", "width": "68.8 mm", "thickness": "11.6 mm",
        "clearance": {"kind": "radial", "mean": "53.8 um"}, "preload": 0.465, "pivot": {"kind": "rocker"},
    },
    "load": "6.753 kN", "speed": "4755 rpm", "lubricant": "ISO VG 46", "supply": {"temperature": "48 degC"},
    "feed": "leading_edge_groove", "materials": {"bearing_metal": "SnSb12Cu6Pb", "pads": "C45"},
    "surfaces": STABLE["surfaces"],
    "limits": {"temperature": "115 degC", "minimum_film_thickness": "12 um", "specific_load": "4 MPa"},
}  # fmt: skip
"""0.75 permille."""
RAMP = {"lubricant": OIL | {"dynamic_viscosity": "5 mPa s"}, "thermal": "isothermal", "turbulence": "ng_pan",
        "speed": "12000 rpm", "load": "3 kN"}  # fmt: skip


def notices(result, code, variant=None):
    return [one for one in result.warnings if one.code == code and variant in (None, one.variant)]


def kept(result, code):
    """Checks that a warning names."""
    return {one.values["check"] for found in notices(result, code) for one in found.values.get("kept", ())}


def test_stability_of_one_temperature_that_full_films_miss_is_questioned():
    """2.23 times the anticipated cross-coupling, 1.9 with temperatures of their own."""
    quick, full = result_of(**STABLE), result_of(**STABLE, **WALLS)
    assert 2.0 < quick.values["cross_coupling_ratio"] < 2.5
    assert full.values["cross_coupling_ratio"] < 2.0
    assert full.verdict is Verdict.FAIL
    assert quick.verdict is Verdict.REMARKS
    assert "C406" in kept(quick, "W416")
    at = quick.values["effective_temperature"]
    still = result_of(**STABLE, thermal="isothermal", effective_temperature=f"{at} K")
    assert "C406" in kept(still, "W416")
    assert not notices(full, "W416")


@pytest.mark.parametrize(("spare", "questioned"), [(1.24, True), (1.26, False)])
def test_stability_must_hold_with_four_fifths_of_it(spare, questioned):
    critical = result_of(**STABLE).values["critical_cross_coupling"]
    near = result_of(**STABLE | {"anticipated_cross_coupling": f"{critical / (2.0 * spare)} N/m"})
    assert ("C406" in kept(near, "W416")) is questioned


def test_stability_that_growth_ends_is_questioned_without_it():
    driven = STABLE | {"anticipated_cross_coupling": "3.6 MN/m"}
    full, grown = result_of(**driven, **WALLS), result_of(**driven, **GROWN)
    assert grown.verdict is Verdict.FAIL
    assert full.verdict is Verdict.REMARKS
    assert {"C406", "C407"} <= kept(full, "W422")
    assert not notices(grown, "W422")


def test_the_estimate_of_growth_is_that_of_the_growth_of_warm_pads():
    """Wide clearances, which growth hardly warms further: its mean share with the housing as warm as the oil."""
    wide = {"pads.clearance.mean": "300 um", "load": "5 kN"}
    housed = WALLS | {"walls": {"pads": {}, "housing": {"temperature": "40 degC"}}, "materials.pads": "C45"}
    grown = result_of(wide | housed | {"deformation": ["growth"], "reference_temperature": "20 degC"})
    (problem,) = case_from_dict(pad_case(wide | housed)).problems()
    narrower = np.mean(grown.arrays["pad_growth"][0]) / grown.values["assembled_clearance"]
    assert left_out_growth(problem, *2 * [grown.values["journal_temperature"]]) == pytest.approx(narrower, rel=0.1)


@pytest.mark.parametrize(("films", "share"), [({}, 0.49), (WALLS, 0.34)], ids=["global", "full, a warm housing"])
def test_a_clearance_that_growth_closes_is_questioned_without_it(films, share):
    plain = result_of(**NARROW, **films)
    assert plain.verdict is Verdict.REMARKS
    (notice,) = notices(plain, "W422", "closes")
    assert notice.values["share"] == pytest.approx(share, abs=0.01)
    assert result_of(**NARROW, **GROWN).verdict is Verdict.NO_SOLUTION


@pytest.mark.parametrize("films", [WALLS, {"thermal": "adiabatic"}], ids=["full", "adiabatic"])
def test_films_of_every_kind_are_asked_what_growth_takes(films):
    """A journal without a temperature of its own, that of insulated films, counts with that of the films."""
    plain = result_of(**STABLE | {"anticipated_cross_coupling": "3.6 MN/m"} | films)
    assert {"C401", "C406"} <= kept(plain, "W422")
    assert notices(result_of(**NARROW, **films), "W422", "closes")


def test_films_and_bores_that_growth_narrows_and_warms_are_questioned_without_it():
    """Limits between what films give without and with growth, and limits far from both."""
    grows = WALLS | {"deformation": ["growth"], "reference_temperature": "20 degC"}
    wider = {"pads.clearance.mean": "70 um", "speed": "3000 rpm"}
    case = {key: value for key, value in NARROW.items() if key not in ("speed", "limits")}
    plain, grown = (result_of(wider, **case, **films) for films in (WALLS, grows))
    assert not notices(plain, "W422")
    film, hot = (
        [one.values[name] for one in (plain, grown)] for name in ("minimum_film_thickness", "maximum_temperature")
    )
    assert film[1] < 0.97 * film[0]
    assert hot[1] > hot[0] + 0.3
    near = {"minimum_film_thickness": f"{0.5 * sum(film)} m", "temperature": f"{0.5 * sum(hot)} K"}
    found = result_of(wider, **case, **WALLS, limits=near)
    assert {"C101", "C104"} <= kept(found, "W422")
    assert {"C104"} <= kept(found, "W415")
    assert found.verdict is Verdict.REMARKS
    assert result_of(wider, **case, **grows, limits=near).verdict is Verdict.FAIL
    far = {"minimum_film_thickness": f"{0.7 * film[0]} m", "temperature": f"{hot[0] + 20.0} K"}
    assert not kept(result_of(wider, **case, **WALLS, limits=far), "W422") & {"C101", "C104"}


def test_a_least_clearance_that_growth_uses_up_ends_with_its_status():
    """Its machined clearance, too: pads without preload, of 12 um, beside a mean clearance of 53.8."""
    own = {"pads.clearance": {"kind": "radial", "minimum": "12 um", "mean": "53.8 um", "maximum": "70 um"}}
    case = pad_case(own | {"pads.preload": 0.0, "clearance_cases": "all"}, **NARROW, **GROWN)
    closed, *others = solve(case_from_dict(case)).results
    assert closed.failure.code == "S003"
    assert len(others) == 2


@pytest.mark.parametrize("housing", [30.0, 35.0])
@pytest.mark.parametrize("films", [WALLS, {}, {"thermal": "adiabatic"}], ids=["full", "global", "adiabatic"])
def test_a_housing_that_is_known_counts(films, housing):
    """A cold one makes less room: what closes in it is questioned without growth, whatever the films."""
    walls = films.get("walls", {}) | {"housing": {"temperature": f"{housing} degC"}}
    cold, warm = result_of(**NARROW | films | {"walls": walls}), result_of(**NARROW | films)
    (of_cold,), (of_warm,) = (notices(found, "W422", "closes") for found in (cold, warm))
    assert of_cold.values["share"] > of_warm.values["share"] + 0.03
    assert not notices(cold, "W183")


def test_films_of_a_given_temperature_know_their_housing():
    """Beside films of 70 degC one of 20 degC closes; one that is not given is as warm as they are."""
    films = {"thermal": "isothermal", "effective_temperature": "70 degC", "supply": None}
    assert not notices(result_of(**NARROW | films), "W422", "closes")
    found = result_of(**NARROW | films | {"walls": {"housing": {"temperature": "20 degC"}}})
    assert notices(found, "W422", "closes")


@pytest.mark.parametrize("thermal", ["global", "adiabatic"])
def test_a_journal_of_a_given_temperature_grows_by_it(thermal):
    """Films of about 60 degC passed cleanly around a journal of 110 degC, whose growth closes them."""
    wide = {"pads.clearance.mean": "80 um", "speed": "2500 rpm", "thermal": thermal}
    assert not notices(result_of(wide, **NARROW), "W422", "closes")
    found = result_of(wide, **NARROW, walls={"journal": {"temperature": "110 degC"}})
    assert notices(found, "W422", "closes")
    assert not notices(found, "W183")


def test_pads_beside_a_journal_that_is_kept_cold_are_as_warm_as_their_films():
    """A clean pass had pads of bronze as cold as the journal, which made room; growth missed its limits."""
    materials = {"pads": {"elastic_modulus": "110 GPa", "thermal_expansion": "18e-6 1/K"}}
    cold = {"walls": {"pads": {}, "journal": {"temperature": "40 degC"}, "housing": {"temperature": "40 degC"}}}
    (problem,) = case_from_dict(pad_case(WALLS | cold | {"materials": materials})).problems()
    warm, cool = (left_out_growth(problem, 313.15, pads) for pads in (333.15, 313.15))
    first = problem.bearing.pads[0]
    assert warm - cool == pytest.approx(18e-6 * 20.0 * first.thickness / first.assembled_clearance, rel=1e-9)


def test_a_journal_that_expands_more_takes_more_of_the_clearance():
    """(alpha_J - alpha_steel) R (T - T_ref)/c more, from the temperature at which clearances were measured."""
    steel = {"materials": NARROW["materials"] | {"journal": {"thermal_expansion": "12e-6 1/K"}}}
    stainless = {"materials": NARROW["materials"] | {"journal": {"thermal_expansion": "16.5e-6 1/K"}}}
    warm, clearance = 350.0, 53.8e-6 * (1.0 - 0.465)
    for given, reference in (({}, 293.15), ({"reference_temperature": "40 degC"}, 313.15)):
        shares = [
            left_out_growth(case_from_dict(pad_case(**NARROW | made | given)).problems()[0], warm, warm)
            for made in (steel, stainless)
        ]
        more = 4.5e-6 * 38.6e-3 * (warm - reference) / clearance
        assert shares[1] - shares[0] == pytest.approx(more, rel=1e-9)
    wide = {"pads.clearance.mean": "80 um", "speed": "2500 rpm"}
    plain, hot = (result_of(wide, **NARROW | made) for made in (steel, stainless))
    assert plain.verdict is Verdict.PASS
    assert notices(hot, "W422", "closes")
    assert not notices(hot, "W183")


ALL_LEFT_OUT = {"growth", "bending", "temperatures"}


def test_clearances_that_a_housing_widens_take_of_the_stability():
    """Aluminium, 23e-6 1/K, around a rigid rotor."""
    aluminium = {"materials": STABLE["materials"] | {"housing": {"thermal_expansion": "23e-6 1/K"}}}
    wide = WALLS | {"walls": {"pads": {}, "housing": {"temperature": "60 degC"}}} | aluminium
    wide |= {"shaft_stiffness": None}
    grown = {"deformation": ["growth"], "reference_temperature": "20 degC"}
    plain, opened = (result_of(**STABLE | wide | more) for more in ({}, grown))
    critical = [one.values["critical_cross_coupling"] for one in (plain, opened)]
    assert critical[1] < 0.95 * critical[0]
    near = {"anticipated_cross_coupling": f"{0.25 * sum(critical)} N/m"}
    (notice,) = notices(result_of(**STABLE | wide | near), "W422", "kept")
    assert {"widening", "bending"} == {one.variant for one in notice.values["left"]}
    assert "C406" in kept(result_of(**STABLE | wide | near), "W422")


THIN = {
    "diameter": "544 mm",
    "pads": {
        "number": 3, "first_pivot": "-90 deg", "extent": "87.7 deg", "width": "508 mm", "thickness": "76 mm",
        "clearance": {"kind": "radial", "mean": "537 um"}, "preload": 0.012,
        "pivot": {"kind": "rocker", "fraction": 0.6},
    },
    "load": "873 kN", "speed": "1057 rpm", "lubricant": "ISO VG 100", "supply": {"temperature": "43.4 degC"},
    "feed": "spray_bar", "carry_over": 0.2, "materials": {"bearing_metal": "SnSb12Cu6Pb", "pads": "C45"},
}  # fmt: skip
"""Pads that are thin and wide."""


@pytest.mark.parametrize(
    "films", [WALLS | {"walls": {"pads": {}}}, {"thermal": "adiabatic"}], ids=["full", "adiabatic"]
)
def test_films_of_thin_wide_pads_are_questioned_without_bending(films):
    bent = {"deformation": ["growth", "bending"], "reference_temperature": "20 degC"}
    plain, fuller = (result_of(**THIN | WALLS | {"walls": {"pads": {}}} | more) for more in ({}, bent))
    films_of = [one.values["minimum_film_thickness"] for one in (plain, fuller)]
    assert films_of[1] < 0.9 * films_of[0]
    limits = {"limits": {"minimum_film_thickness": f"{1.02 * films_of[1]} m", "temperature": "249 degC"}}
    found = result_of(**THIN | films | limits)
    assert "C101" in kept(found, "W422")
    assert found.verdict is not Verdict.PASS
    assert result_of(**THIN | WALLS | {"walls": {"pads": {}}} | bent | limits).verdict is Verdict.FAIL
    thick = result_of({"pads.thickness": "200 mm"}, **THIN | films | limits)
    assert "C101" not in kept(thick, "W422")


def test_pads_that_would_bend_by_the_whole_clearance_are_told():
    found = result_of({"pads.thickness": "50 mm"}, **THIN)
    (notice,) = notices(found, "W422", "folds")
    assert notice.values["bend"] > 1.0
    assert found.verdict is not Verdict.PASS


def test_bending_lets_less_growth_close():
    """Bronze pads of a ninth of the radius, which growth closes where they bend, too."""
    bronze = {"elastic_modulus": "100 GPa", "thermal_expansion": "18e-6 1/K", "conductivity": "250 W/(m K)"}
    small = {
        "diameter": "23.4 mm", "load": "428 N", "speed": "16549 rpm", "lubricant": "ISO VG 32", "carry_over": 0.6,
        "supply": {"temperature": "46.6 degC"}, "feed": "spray_bar",
        "materials": {"pads": bronze, "journal": "42CrMo4", "housing": "C45"},
        "pads": {
            "number": 3, "first_pivot": "-30 deg", "extent": "97.5 deg", "width": "9.35 mm",
            "thickness": "4.63 mm", "clearance": {"kind": "radial", "mean": "35.5 um"}, "preload": 0.369,
            "pivot": {"kind": "point", "fraction": 0.57, "pivot_radius": "14 mm", "housing_radius": "14.7 mm",
                      "yield_strength": "2000 MPa"},
        },
        **WALLS, "walls": {"pads": {}},
    }  # fmt: skip
    (notice,) = notices(result_of(**small), "W422", "closes")
    assert notice.values["share"] < 0.22
    assert "[growth, bending]" in notice.message
    fuller = {"deformation": ["growth", "bending"], "reference_temperature": "20 degC"}
    assert result_of(**small, **fuller).verdict is Verdict.NO_SOLUTION


def test_the_estimate_of_bending_is_that_of_stiff_pads_that_bend():
    """Of pads that hardly bend: half to twice what the pressure where it stands, and the heat, really make."""
    stiff = {"pads.thickness": "30 mm", "load": "10 kN"}
    bending = {"deformation": ["bending"], "materials": {"pads": {"elastic_modulus": "210 GPa"}}}
    bent = result_of(stiff | bending)
    rigid = solution_of(stiff)
    estimate = left_out_bending(rigid.problem, rigid.state.films, rigid.result.values["effective_temperature"])
    heat = left_out_bending(
        replace(rigid.problem, bearing=case_from_dict(pad_case(stiff | bending)).problems()[0].bearing),
        rigid.state.films, rigid.result.values["effective_temperature"],
    )  # fmt: skip
    assert 0.0 < heat < 0.5 * estimate
    assert 0.5 < max(bent.arrays["pad_bending"][0]) / (estimate - heat) < 2.0


@pytest.mark.parametrize(("films", "left", "model"), [
    (WALLS, {"growth", "bending"}, "deformation: [growth, bending]"),
    (WALLS | {"deformation": ["growth"], "reference_temperature": "20 degC"}, {"bending"},
     "deformation: [growth, bending]"),
    (WALLS | {"deformation": ["bending"]}, {"growth"}, "deformation: [growth, bending]"),
    ({"thermal": "adiabatic"}, {"growth", "bending"}, "thermal: full, deformation: [growth, bending]"),
    ({"thermal": "global"}, ALL_LEFT_OUT, "thermal: full, deformation: [growth, bending]"),
    ({"thermal": "global", "turbulence": "ng_pan"}, ALL_LEFT_OUT, "deformation: [bending]"),
    ({"thermal": "global", "turbulence": "ng_pan", "deformation": ["bending"]}, ALL_LEFT_OUT, ""),
])  # fmt: skip
def test_what_is_left_out_is_named_with_the_model_that_counts_it(films, left, model):
    near = {"pads.clearance.mean": "150 um", "limits.log_decrement": None}
    decrement = result_of(near, **STABLE | films).values["log_decrement"]
    (notice,) = notices(
        result_of(near | {"limits.log_decrement": 0.97 * decrement}, **STABLE | films), "W422", "kept"
    )
    assert {one.variant for one in notice.values["left"]} == left
    assert [one.values["model"] for one in notice.values["advice"]] == ([model] if model else [])
    for language in ("en", "de", "ru"):
        assert model in notice.sentence(language)


@pytest.mark.parametrize(("films", "model"), [
    ({}, "thermal: full, deformation: [growth]"),
    (WALLS, "deformation: [growth]"),
    (WALLS | {"deformation": ["bending"]}, "deformation: [growth, bending]"),
])  # fmt: skip
def test_a_clearance_that_may_close_is_told_with_the_model_that_tells(films, model):
    (notice,) = notices(result_of(**NARROW | films), "W422", "closes")
    assert [one.values["model"] for one in notice.values["advice"]] == [model]


def test_usual_clearances_are_not_questioned_for_growth():
    """1.25 permille at 58 degC."""
    usual = result_of({"pads.clearance.mean": "120 um"}, **NARROW | {"speed": "3000 rpm", "diameter": "100 mm"})
    assert usual.values["relative_clearance"] == pytest.approx(1.284e-3, rel=1e-3)
    assert not notices(usual, "W422")


def test_stability_kept_on_the_assumed_ramp_is_questioned():
    bare, stable = result_of(**RAMP), result_of(**RAMP, rotor_mass="100 kg")
    assert notices(bare, "W420")
    assert not notices(bare, "W421")
    (notice,) = notices(stable, "W421")
    assert notice.values["kept"] == ("C401",)
    assert stable.verdict in (Verdict.REMARKS, Verdict.NO_VERDICT)
    missed = result_of(**RAMP, rotor_mass="100 kg", limits={"log_decrement": 9.0})
    assert not notices(missed, "W421")


def test_tables_of_coefficients_name_the_ramp():
    (problem,) = case_from_dict(pad_case(**RAMP)).problems()
    table = run_over_speed(problem, [100.0, 1200.0]).table()
    assert "W420" not in table.warnings[0]
    assert "W420" in table.warnings[1]
