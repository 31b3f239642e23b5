"""Bores that the uneven temperature of their bush distorts, from the case to the answer."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.case import parse_case
from babbitt.core.result import Outcome
from babbitt.kinds.journal.compare.thermal_variants import thermal_variants
from babbitt.kinds.journal.film import thermal_results as thermal_answer_module
from babbitt.kinds.journal.film import values as film_values_module
from babbitt.kinds.journal.film.check import film_check
from babbitt.kinds.journal.film.thermal_film import thermal_operating_film
from babbitt.reynolds.heat import thermal_equilibrium as thermal_module

TEXT = """
kind: journal
name: Two grooves
method: film
thermal: full
accuracy: draft
diameter: 120 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5e-3}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.1 MPa}
materials: {bearing: EN-GJL-250, journal: C45}
walls:
  bush: {outer_diameter: 150 mm, conductivity: 46 W/(m K)}
  housing: {outer_diameter: 220 mm, heat_transfer_coefficient: 30 W/(m2 K), ambient_temperature: 20 degC}
load: 30 kN
speed: 3000 rpm
"""
DISTORTED = TEXT.replace("load:", "  thermal_distortion: true\nload:")
STIFF = "compliance: [{kind: column, displacement_per_pressure: 0.0001 um/MPa}]\n"
SOFT = "compliance: [{kind: ring, outer_diameter: 220 mm, elastic_modulus: 110 GPa}]\n"


def design(text):
    (found,) = parse_case(text).problems()
    return found


def said(result, words):
    return [one for one in result.assumptions if words in one]


@pytest.fixture(scope="module")
def answers():
    texts = {
        "rigid": TEXT,
        "stiff": TEXT + STIFF,
        "distorted": DISTORTED,
        "both": DISTORTED + STIFF,
        "soft": DISTORTED + SOFT,
    }
    return {name: film_check(design(text)) for name, text in texts.items()}


@pytest.mark.thorough
def test_a_bore_is_distorted_where_it_is_asked_for_and_nowhere_else(answers):
    rigid, stiff, distorted, both = (answers[name] for name in ("rigid", "stiff", "distorted", "both"))
    assert stiff.eccentricity_ratio == pytest.approx(rigid.eccentricity_ratio, abs=1e-4)
    assert stiff.maximum_temperature == pytest.approx(rigid.maximum_temperature, abs=0.05)
    assert both.eccentricity_ratio == pytest.approx(distorted.eccentricity_ratio, abs=1e-4)
    assert both.minimum_film_thickness == pytest.approx(distorted.minimum_film_thickness, rel=1e-3)
    assert distorted.eccentricity_ratio < rigid.eccentricity_ratio - 0.02


def test_displacement_counts_pressure_and_heat(answers):
    assert "maximum_displacement" not in answers["rigid"].values
    assert "thermal_distortion" not in answers["stiff"].values
    assert answers["stiff"].maximum_displacement < 3e-9
    alone, soft = answers["distorted"], answers["soft"]
    assert 1e-6 < alone.thermal_distortion == alone.maximum_displacement
    assert soft.maximum_displacement > 1.2 * soft.thermal_distortion


def test_displacement_that_is_told_is_that_of_the_film():
    case = design(DISTORTED + SOFT)
    state = thermal_operating_film(case).film
    told = film_values_module.film_values(case, state)["maximum_displacement"]
    in_the_film = np.abs(np.array(state.solution.film.displacement)).max()
    assert told == pytest.approx(in_the_film, abs=1.1e-3 * state.solution.minimum_film_thickness)


def test_the_bush_is_what_grows_behind_its_liner_and_before_contact_and_housing():
    text = DISTORTED.replace("46 W/(m K)}", "46 W/(m K), liner: {thickness: 1 mm, conductivity: 20 W/(m K)}}")
    text = text.replace("220 mm,", "220 mm, conductivity: 5 W/(m K), contact_coefficient: 3000 W/(m2 K),")
    growth = design(text).heat.growth
    assert growth.walls.conductivities[growth.ring] == pytest.approx(46.0)
    assert growth.walls.radii[growth.ring : growth.ring + 2] == pytest.approx((0.061, 0.075))
    assert growth.expansion == design(text).bearing.expansion_bearing
    assert design(DISTORTED).heat.growth.ring == 0
    assert design(TEXT).heat.growth is None


def test_a_skin_that_hardly_conducts_does_not_throw_the_bore_about(answers):
    skin = DISTORTED.replace("{outer_diameter: 220 mm", "{outer_diameter: 151 mm, conductivity: CC")
    own, insulating = (
        film_check(design(skin.replace("CC", given))).thermal_distortion for given in ("46 W/(m K)", "1 W/(m K)")
    )
    assert insulating == pytest.approx(own, rel=0.05)


def test_assumptions_tell_what_the_case_counts(answers):
    assert said(answers["rigid"], "across the gap; rigid surfaces")
    assert said(answers["stiff"], "a bore that gives way; laminar")
    assert said(answers["distorted"], "a stiff bore that heat distorts")
    assert said(answers["both"], "a bore that gives way and that heat distorts")
    for name, result in answers.items():
        assert bool(said(result, "free ring of one material, up to 150 mm")) is (
            name in ("distorted", "both", "soft")
        )
        assert bool(said(result, "count how the bore gives way")) is (name in ("stiff", "both", "soft"))
        assert bool(said(result, "distortion by heat stays that of the operating point")) is (
            name in ("distorted", "both", "soft")
        )


@pytest.mark.parametrize(
    ("text", "neglects"),
    [(TEXT, "pressure or by uneven heat"), (DISTORTED, "pressure"), (TEXT + STIFF, "uneven heat"),
     (DISTORTED + STIFF, None)],
)  # fmt: skip
def test_comparison_tells_what_the_full_film_neglects(text, neglects):
    case = parse_case(text)
    ((*variants,),) = thermal_variants(case, case)
    (remark,) = [one.remark for one in variants if one.label == "full thermal film"]
    assert "heat along the bush" in remark
    if neglects is None:
        assert "deformation" not in remark
    else:
        assert remark.endswith(f"deformation by {neglects}")


def test_flow_without_pressure_that_is_not_found_is_not_told(monkeypatch):
    found = thermal_module.thermal_film_at

    def lost(*given):
        film = found(*given)
        return replace(film, film=replace(film.film, outcome=Outcome.NOT_CONVERGED))

    monkeypatch.setattr(thermal_module, "thermal_film_at", lost)
    case = design(TEXT)
    state = thermal_operating_film(case).film
    calm = film_values_module.without_pressure(state.solution.film)
    assert math.isnan(thermal_answer_module.flow_without_pressure(case, state, calm))
    result = film_check(case)
    assert result.outcome.solved
    assert result.total_flow > 0.0
    assert not {"side_flow", "supply_flow"} & result.values.keys()
    (rough,) = [one.message for one in result.warnings if one.code == "W121"]
    assert "nan" not in rough
