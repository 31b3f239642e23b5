"""Changing loads of a case, inline and from a file."""

import math

import pytest

from babbitt.case import CaseError, load_case

BEARING = """\
kind: journal
method: film
name: Rod
diameter: 100 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5 permille}
grooves: [{angle: 90 deg, extent: 20 deg}]
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 32
supply: {temperature: 40 degC, pressure: 0.1 MPa}
load: 8 kN
speed: 3000 rpm
"""

INLINE = """\
dynamic_load:
  kind: table
  cycle: 720 deg
  angle: [0 deg, 180 deg, 540 deg, 720 deg]
  fx: [0 kN, 1 kN, -1 kN, 0 kN]
  fy: [2 kN, -20 kN, 3 kN, 2 kN]
"""

TABLE = "angle [deg],fx [kN],fy [N]\n0,0,2000\n180,1,-20000\n540,-1,3000\n720,0,2000\n"


def load_of(tmp_path, text):
    file = tmp_path / "rod.yaml"
    file.write_text(BEARING + text, encoding="utf-8")
    (film,) = load_case(file).problems()
    return film


def test_a_file_says_the_same_as_the_lists(tmp_path):
    (tmp_path / "load.csv").write_text(TABLE, encoding="utf-8")
    from_file = load_of(tmp_path, "dynamic_load: {kind: table, cycle: 720 deg, file: load.csv}\n")
    inline = load_of(tmp_path, INLINE)
    assert inline.changing_load.cycle == from_file.changing_load.cycle == pytest.approx(4.0 * math.pi)
    for turned in (0.0, 1.0, 5.0, 12.0, 13.0):
        assert from_file.changing_load.at(turned) == pytest.approx(inline.changing_load.at(turned))
    assert inline.changing_load.at(math.pi) == pytest.approx((1e3, -2e4))
    assert len(inline.changing_load.angles) == 3  # the end of the cycle is its beginning


@pytest.mark.parametrize(
    ("table", "words"),
    [("angle,fx,fy\n0,0,0\n", "no heading"), (TABLE.replace("180,1", "180,one"), "line 3")],
)
def test_a_table_that_cannot_be_read_is_told(tmp_path, table, words):
    (tmp_path / "load.csv").write_text(table, encoding="utf-8")
    with pytest.raises(CaseError, match=words):
        load_of(tmp_path, "dynamic_load: {kind: table, file: load.csv}\n")


def test_a_rotating_load_keeps_step_with_the_journal(tmp_path):
    film = load_of(
        tmp_path, "dynamic_load: {kind: rotating, magnitude: 2 kN, phase: 90 deg, moving_mass: 300 kg}\n"
    )
    assert film.changing_load.at(0.0) == pytest.approx((0.0, 2e3), abs=1e-9)
    assert film.changing_load.at(math.pi / 2.0) == pytest.approx((-2e3, 0.0), abs=1e-9)
    assert film.moving_mass == 300.0
