"""The grooved bearing in two dimensions beside the model of one dimension."""

import math
from pathlib import Path

import pytest

from babbitt.case import load_case, parse_case
from babbitt.kinds.journal.case.build import bearings_of
from babbitt.kinds.journal.compare.grooved_films import unknown_to_grooved_films
from babbitt.report.figures import write_plots
from babbitt.solving import solve
from babbitt.study.comparison import compare_methods

EXAMPLE = Path(__file__).parents[2] / "examples" / "grooved.yaml"
TEXT = EXAMPLE.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def compared():
    (found,) = compare_methods(load_case(EXAMPLE))
    return {one.label: one for one in found.variants}


def test_films_of_finite_width(compared):
    """Tried by hand with `method: film` at 6.5 MPa, fed along a line opposite the load: 8.65, 5.7 and 7.6 um."""
    none, through, blind = (compared[f"film, {name} groove"].result for name in ("no", "through", "blind"))
    assert 1e6 * none.minimum_film_thickness == pytest.approx(8.65, abs=0.1)
    assert 1e6 * through.minimum_film_thickness == pytest.approx(5.7, abs=0.1)
    assert through.minimum_film_thickness < blind.minimum_film_thickness < none.minimum_film_thickness
    # a film of finite width neither heats nor cools by the groove as the infinitely long one does
    assert abs(through.maximum_temperature - none.maximum_temperature) < 2.0
    assert compared["through groove"].result.outlet_temperature > through.maximum_temperature + 30.0
    assert through.groove_pressure == 0.0
    assert 0.0 < blind.groove_pressure < blind.maximum_pressure


def test_groove_has_one_place_in_the_bush(compared):
    for label in ("through groove", "blind groove", "cut in two", "film, through groove", "film, blind groove"):
        result = compared[label].result
        assert math.degrees(result.groove_angle_from_load) == pytest.approx(-20.0, abs=1e-3), label
    for label in ("film, through groove", "film, blind groove"):
        result = compared[label].result  # without tilt the narrowest gap lies on the line of centres
        expected = math.pi + result.groove_angle_from_load - result.attitude_angle
        assert result.groove_angle_from_gap == pytest.approx(expected, abs=math.radians(0.5))


def test_films_are_those_of_the_film_method(compared):
    """The same film written by hand has the same answer; turned to the other side it is its mirror image."""
    by_hand = TEXT.replace("method: segments", "method: film\nthermal: full\ngrooves: GROOVES")
    by_hand = "\n".join(line for line in by_hand.splitlines() if line.split(":")[0] not in SEGMENTS_BLOCK)
    by_hand = by_hand.replace("supply: {", "supply: {pressure: 1 kPa, ")
    feed = "{angle: 90 deg, extent: 0 deg, pressure: 0 Pa}"
    extent = math.degrees(0.12)
    for sense, angle in ((1.0, -110.0), (-1.0, -70.0)):
        groove = f"{{angle: {angle} deg, extent: {extent} deg, pressure: 0 Pa}}"
        text = by_hand.replace("GROOVES", f"[{feed}, {groove}]").replace("10 m/s", f"{10.0 * sense:g} m/s")
        result = solve(parse_case(text)).results[0]
        expected = compared["film, through groove"].result
        assert result.minimum_film_thickness == pytest.approx(expected.minimum_film_thickness, rel=2e-3)
        assert result.maximum_temperature == pytest.approx(expected.maximum_temperature, abs=0.3)


SEGMENTS_BLOCK = ("segments", "  groove", "  roughness")


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("materials: {bearing: C10, journal: C45}", "", "needs the materials"),
        ("specific_load: 6.5 MPa", "eccentricity_ratio: 0.8", "under the same load"),
        ("  roughness:", "  compliance: 0.1 um/MPa\n  roughness:", "walls that yield"),
        ("supply: {", "supply: {flow: 3 L/min, ", "fed by pressure"),
    ],
)
def test_films_that_do_not_apply_are_left_out_with_the_reason(old, new, reason):
    case = parse_case(TEXT.replace(old, new))
    ((bearing,), (design,)) = bearings_of(case), case.problems()
    assert reason in unknown_to_grooved_films(bearing, design, case)


def test_full_bearing_fed_along_a_line_is_drawn(tmp_path):
    """Its one line of supply was not counted among the supplies, and every plot of its temperature failed."""
    pytest.importorskip("matplotlib")
    text = TEXT.replace("method: segments", "method: film\nthermal: adiabatic\nspan: 360 deg\naccuracy: draft")
    text = "\n".join(line for line in text.splitlines() if line.split(":")[0] not in SEGMENTS_BLOCK)
    machine = solve(parse_case(text.replace("supply: {", "supply: {pressure: 50 kPa, ")))
    assert any("temperature" in path.stem for path in write_plots(machine, tmp_path, "svg"))
