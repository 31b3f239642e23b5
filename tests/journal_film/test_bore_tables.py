"""Measured bores from a CSV table beside the case."""

import math

import pytest
from film_bearings import answer

from babbitt.case import CaseError, case_hash, load_case
from babbitt.solving import solve

CASE = """
kind: journal
name: Measured
method: film
diameter: 200 mm
width: 120 mm
clearance: {kind: relative, mean: 1.5 permille}
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.15 MPa}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
bore: {kind: measured, file: bore.csv}
load: 30 kN
speed: 3000 rpm
"""


def departure(degrees):
    return 20.0 * math.cos(2.0 * math.radians(degrees))


def written(folder, rows, heading="angle [deg],departure [um]"):
    (folder / "bore.csv").write_text("\n".join([heading, *(f"{a},{d}" for a, d in rows)]), encoding="utf-8")
    (folder / "case.yaml").write_text(CASE, encoding="utf-8")
    return folder / "case.yaml"


def test_a_table_is_the_bore(tmp_path):
    case = load_case(written(tmp_path, [(a, departure(a)) for a in range(-180, 181, 5)]))
    (design,) = case.problems()
    for degrees in (-170.0, -90.0, 3.0, 181.0):
        assert design.bearing.bore.at(math.radians(degrees)) == pytest.approx(1e-6 * departure(degrees), abs=1e-7)
    points = [f"{departure(a)} um" for a in range(0, 360, 5)]
    given = answer(bore={"kind": "measured", "departures": points})
    assert solve(case).results[0].eccentricity_ratio == pytest.approx(given.eccentricity_ratio, rel=1e-6)


def test_radians_and_millimetres_are_the_same_bore(tmp_path):
    rows = [(a, departure(a)) for a in range(0, 360, 10)]
    first = load_case(written(tmp_path, rows))
    other = [(math.radians(a), d / 1000.0) for a, d in rows]
    second = load_case(written(tmp_path, other, "angle (rad),departure (mm)"))
    for one, two in zip(first.bore.departures, second.bore.departures, strict=True):
        assert one == pytest.approx(two, abs=1e-15)


def test_the_hash_sees_the_table(tmp_path):
    rows = [(a, departure(a)) for a in range(0, 360, 10)]
    before = case_hash(load_case(written(tmp_path, rows)))
    assert case_hash(load_case(written(tmp_path, [(a, d + 1.0) for a, d in rows]))) != before


FULL = [(a, departure(a)) for a in range(0, 361, 10)]


@pytest.mark.parametrize(
    ("rows", "heading", "words"),
    [
        ([*FULL[:-1], (360, 27.0)], None, "does not close"),
        (FULL[:5], None, "5 points"),
        (FULL[:20], None, "leaves a gap"),
        ([*FULL[:9], (40, 1.0), *FULL[9:]], None, "do not rise"),
        (FULL, "angle,departure", "no heading with units"),
        (FULL, "angle [kg],departure [um]", "line 2"),
        ([*FULL[:9], (95, "nan"), *FULL[10:]], None, "line 11 of bore.csv: 'nan' is not a finite number"),
        ([*FULL[:9], (95, "two"), *FULL[10:]], None, "line 11 of bore.csv: 'two' is not"),
    ],
)
def test_bad_tables_are_named(tmp_path, rows, heading, words):
    path = written(tmp_path, rows, heading or "angle [deg],departure [um]")
    with pytest.raises(CaseError) as caught:
        load_case(path)
    (problem,) = caught.value.problems
    assert problem.field == "bore.file"
    assert problem.line == 12
    assert words in problem.message


def test_a_missing_table_is_named(tmp_path):
    path = written(tmp_path, FULL)
    (tmp_path / "bore.csv").unlink()
    with pytest.raises(CaseError, match=r"there is no such file: .*bore\.csv"):
        load_case(path)
