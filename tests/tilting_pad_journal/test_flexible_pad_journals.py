"""Pads that bend, of their own materials, and probes, from the case to the result."""

import math

import numpy as np
import pytest
from pad_journals import HEATED, pad_case, result_of, solution_of

from babbitt.case import case_from_dict
from babbitt.kinds.tilting_pad_journal.comparison import compare
from babbitt.kinds.tilting_pad_journal.report.inputs import pad_inputs
from babbitt.reynolds.tilting_pads.bending_mode import BendingMode, bending_stiffness

STEEL = {"elastic_modulus": "210 GPa"}
BENDING = {"thermal": "global", "deformation": ["bending"], "materials": {"pads": STEEL}}


@pytest.fixture(scope="module")
def bent():
    return solution_of({"pads.thickness": "10 mm"}, **BENDING)


def test_pads_of_one_temperature_bend_by_their_mode(bent):
    """k_q of the closed form, q from the load on the pad, and edges that open by q psi."""
    case, result = bent.problem, bent.result
    (stiffness,), (bending,) = result.arrays["pad_bending_stiffness"], result.arrays["pad_bending"]
    for number, (pad, state) in enumerate(zip(case.bearing.pads, bent.state.films.solution.pads, strict=True)):
        expected = bending_stiffness(pad, 0.05 + pad.clearance, 0.07, 210e9)
        assert stiffness[number] == pytest.approx(expected, rel=1e-12)
        edge = float(BendingMode.of(pad).shape(np.array([BendingMode.of(pad).trailing]))[0])
        assert bending[number] == pytest.approx(state.bend.deflection * edge, rel=1e-9)
        assert bending[number] > 0.0
    assert any("bend by pressure" in one for one in result.assumptions)
    assert "pad 1 bending" in result.settings["motions"]


def test_thin_pads_bend_more_and_damp_less(bent):
    rigid = result_of({"pads.thickness": "10 mm"}, thermal="global").values
    thick = result_of(**BENDING)
    thin = bent.result
    assert max(thin.arrays["pad_bending"][0]) > 3.0 * max(thick.arrays["pad_bending"][0])
    assert thin.values["damping_yy"] < thick.values["damping_yy"]
    assert thin.values["damping_yy"] < 0.98 * rigid["damping_yy"]


def test_plates_are_stiffer_by_poissons_ratio():
    beam = result_of(**BENDING).arrays["pad_bending_stiffness"][0]
    known = result_of(**BENDING | {"materials": {"pads": STEEL | {"poisson_ratio": 0.4}}}, pad_bending="plate")
    assumed = result_of(**BENDING, pad_bending="plate")
    assert known.arrays["pad_bending_stiffness"][0] == pytest.approx([one / (1.0 - 0.16) for one in beam])
    assert assumed.arrays["pad_bending_stiffness"][0] == pytest.approx([one / 0.91 for one in beam])
    assert "Poisson's ratio of the pads is that of steel, 0.3." in assumed.assumptions


def test_a_pad_of_its_own_material_bends_by_itself():
    own = {"pads.each": [{"material": {"elastic_modulus": "105 GPa"}}, {}, {}, {}]}
    (stiffness,) = result_of(own, **BENDING).arrays["pad_bending_stiffness"]
    assert stiffness[0] == pytest.approx(0.5 * stiffness[1], rel=1e-12)


def test_the_mass_of_pads_that_bend_counts():
    fields = dict(BENDING, whirl_ratios=[1, 2, 5])
    heavy = solution_of({"pads.mass": "1 kg", "pads.thickness": "10 mm"}, **fields)
    light = solution_of({"pads.thickness": "10 mm"}, **fields)
    assert not [one for one in heavy.result.warnings if one.code == "W183"]
    full = heavy.state.dynamics.full
    place = full.labels.index("pad 3 bending")
    pad = heavy.problem.bearing.pads[2]
    assert full.mass[place, place] == pytest.approx(BendingMode.of(pad).mean_square, rel=1e-12)
    assert light.state.dynamics.full.mass[place, place] == 0.0


def test_full_films_bend_plates_less():
    heated = dict(HEATED["D"])
    beam, plate = (result_of(**heated, pad_bending=one).arrays["pad_bending"][0] for one in ("beam", "plate"))
    assert all(one > other > 0.0 for one, other in zip(beam, plate, strict=True))


def test_pads_of_their_own_materials_in_full_films():
    """A pad that conducts badly is the hotter; one that expands more grows more; the others hardly feel it."""
    grown = dict(HEATED["E"])
    plain = result_of(**grown)
    poor = result_of({"pads.each": [{}, {}, {"material": {"conductivity": "1 W/(m K)"}}, {}]}, **grown)
    wide = result_of({"pads.each": [{}, {}, {"material": {"thermal_expansion": "24e-6 1/K"}}, {}]}, **grown)
    assert poor.arrays["pad_maximum_temperature"][0][2] > plain.arrays["pad_maximum_temperature"][0][2] + 1.0
    (usual,), (more,) = plain.arrays["pad_growth"], wide.arrays["pad_growth"]
    assert more[2] - usual[2] > 5.0 * abs(more[0] - usual[0])
    assert abs(poor.values["energy_balance_error"]) < 1e-6


def test_alike_materials_of_their_own_change_nothing():
    heated = dict(HEATED["E"])
    named = {"pads.each": [{"material": heated["materials"]["pads"]}] * 4}
    one, other = result_of(**heated), result_of(named, **heated)
    assert other.values["maximum_temperature"] == pytest.approx(one.values["maximum_temperature"], abs=1e-9)


def test_probes_stand_where_the_case_says():
    """At 0 and 1 the probe reads the edges of the bore; backward it keeps its place in the pad."""
    heated = dict(HEATED["C"])
    solution = solution_of(
        {"pads.probe_fraction": 0.5, "pads.each": [{"probe_fraction": 0.0}, {"probe_fraction": 1.0}, {}, {}]},
        **heated,
    )
    (probes,) = solution.result.arrays["pad_probe_temperature"]
    bores = [pad.bore for pad in solution.state.films.thermal.temperatures]
    middle = bores[2].size // 2
    assert probes == pytest.approx([bores[0][0], bores[1][-1], bores[2][middle], bores[3][middle]], abs=1e-9)
    assert solution.result.values["probe_temperature"] == pytest.approx(max(probes))
    rows = [row for group in pad_inputs(solution.problem) for row in group.rows]
    assert any(row.label.startswith("Probe, from the leading edge") and row.value == "50" for row in rows)
    usual = solution_of(**heated)
    assert usual.problem.bearing.pads[0].probe_fraction == 0.75
    fields = heated | {"operating_points": [{"name": "back", "speed": "-4000 rpm"}]}
    backward = solution_of({"pads.probe_fraction": 0.6}, **fields)
    assert backward.problem.bearing.pads[0].probe_fraction == pytest.approx(0.4)


def test_models_that_heat_the_pads_are_compared_without_their_bending():
    case = case_from_dict(pad_case(**BENDING))
    (comparison,) = compare(case)
    by_label = {one.label: one.result for one in comparison.methods}
    assert "pad_bending_stiffness" in by_label["one temperature"].arrays
    assert "pad_bending_stiffness" in by_label["films at 40 °C"].arrays
    assert "pad_bending_stiffness" not in by_label["full thermal films"].arrays
    assert all(math.isfinite(one.values["stiffness_yy"]) for one in by_label.values())
