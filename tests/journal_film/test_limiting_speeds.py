"""Films without the speeds of transition and of whirl: all else is the same, and the verdict, too."""

import film_bearings
import pytest

SPEEDS = {"transition_speed", "threshold_speed"}
SURFACES = {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "1 um"}

BEARINGS = {
    "calm": {},
    "close to mixed friction": {"speed": "60 rpm", "load": "120 kN"},
    "whirling": {"load": "2 kN", "speed": "12000 rpm"},
    "elastic shaft": {"shaft_stiffness": "200 N/um"},
    "adiabatic": {"method": {"kind": "film", "thermal": "adiabatic"}},
}


def both(**given):
    method = given.pop("method", {"kind": "film"})
    return [
        film_bearings.answer(method={**method, "limiting_speeds": asked}, surfaces=SURFACES, **given)
        for asked in (True, False)
    ]


@pytest.mark.parametrize("name", BEARINGS)
def test_nothing_else_changes(name):
    full, quick = both(**BEARINGS[name])
    left_out = full.values.keys() - quick.values.keys()
    assert left_out <= {*SPEEDS, "threshold_speed_elastic"}
    assert quick.missing.keys() >= left_out
    same = quick.values.keys() - {"wall_time"}
    assert {key: quick.values[key] for key in same} == {key: full.values[key] for key in same}
    assert quick.arrays == full.arrays
    assert quick.verdict is full.verdict
    assert [one.code for one in quick.warnings] == [one.code for one in full.warnings]


def test_transition_is_judged_by_the_film_thickness_as_by_the_speed():
    for given in (BEARINGS["calm"], BEARINGS["close to mixed friction"]):
        full, quick = both(**given)
        (by_speed,), (by_film,) = ([one for one in found.checks if one.code == "C111"] for found in (full, quick))
        assert by_speed.quantity == "hydrodynamic_speed"
        assert by_film.quantity == "minimum_film_thickness"
        assert by_speed.ok is by_film.ok


def test_a_threshold_beyond_the_search_is_told():
    light = film_bearings.answer(rotor_mass="1 kg", load="60 kN", speed="1000 rpm")
    assert "threshold_speed" not in light.values
    assert "stable at this speed" in light.missing["threshold_speed"]
    heavy = film_bearings.answer(rotor_mass="100 t", load="1 kN", speed="9000 rpm")
    assert "threshold_speed" not in heavy.values
    assert "whirls at this speed" in heavy.missing["threshold_speed"]
    assert "W120" in {one.code for one in heavy.warnings}
    assert "threshold_speed" not in film_bearings.answer(speed="9000 rpm", load="10 kN").missing
