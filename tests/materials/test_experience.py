"""Experience values: published cells, bounds of the table, order, and tables of the user's own."""

from importlib.resources import files

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.properties.materials import (
    AlloyFamily,
    BearingMetal,
    SourcedText,
    bearing_metals,
    empirical_minimum_film_thickness,
    experience_limits,
    metal_temperature_limit,
    parse_experience_limits,
    pressure_fed_temperature_limit,
    self_cooled_temperature_limit,
    specific_load_limit,
)

SHIPPED = files("babbitt.properties.materials").joinpath("limits.toml").read_text(encoding="utf-8")

diameters = st.floats(0.02401, 2.5)
speeds = st.floats(0.0, 200.0)


@pytest.mark.parametrize(
    ("diameter", "speed", "film"),
    [
        # confirmed by the published marine reverse-gear study
        (250, 45.0, 14),
        (350, 26.1, 11),
        (300, 22.4, 11),
        (550, 6.6, 11),
        # one cell per row and column, with both sides of the bounds
        (24.001, 1.0, 3),
        (63, 1.001, 4),
        (63.001, 3.0, 5),
        (160, 3.001, 7),
        (400, 10.0, 9),
        (400, 10.001, 11),
        (400.001, 30.0, 13),
        (1000, 30.001, 16),
        (1000.001, 0.0, 10),
        (2500, 300.0, 18),
    ],
)
def test_cells_of_the_film_thickness_table(diameter, speed, film):
    assert empirical_minimum_film_thickness(diameter * 1e-3, speed) == pytest.approx(film * 1e-6)


@pytest.mark.parametrize("diameter", [0.0, 0.010, 0.024, 2.501, float("nan"), float("inf"), -0.1])
def test_nothing_is_extrapolated(diameter):
    assert empirical_minimum_film_thickness(diameter, 5.0) is None


@given(diameters, diameters, speeds, speeds)
def test_larger_and_faster_bearings_need_thicker_films(one, other, slow, fast):
    small, large = sorted((one, other))
    slow, fast = sorted((slow, fast))
    assert empirical_minimum_film_thickness(small, slow) <= empirical_minimum_film_thickness(large, fast)


@given(diameters, speeds)
def test_sense_of_rotation_does_not_matter(diameter, speed):
    forward = empirical_minimum_film_thickness(diameter, speed)
    assert forward == empirical_minimum_film_thickness(diameter, -speed)


@pytest.mark.parametrize("bound", [63, 160, 400, 1000])
def test_round_off_stays_in_the_step(bound):
    at = empirical_minimum_film_thickness(bound * 1e-3, 1.0)
    assert empirical_minimum_film_thickness(bound * 1e-3 * (1 + 1e-13), 1.0) == at


@pytest.mark.parametrize(
    ("family", "general", "exceptional"),
    [
        ("tin-based", 5, 15),
        ("lead-based", 5, 15),
        ("copper-lead", 7, 20),
        ("copper-tin", 7, 25),
        ("aluminium-tin", 7, 18),
        ("aluminium-zinc", 7, 20),
    ],
)
def test_specific_loads(family, general, exceptional):
    limit = specific_load_limit(AlloyFamily(family))
    assert (limit.general, limit.exceptional) == (general * 1e6, exceptional * 1e6)
    assert limit.source.startswith("assumption: experience values as in textbooks")


def test_families_without_a_public_value_have_none():
    without = {family for family in AlloyFamily if specific_load_limit(family) is None}
    assert without == {AlloyFamily.OTHER}
    for family in set(AlloyFamily) - without:
        metal = BearingMetal("mine", family, "none", SourcedText("unknown", "test"))
        assert 373.15 <= metal_temperature_limit(metal).value <= 573.15


def test_every_family_has_a_metal():
    assert {metal.family for metal in bearing_metals()} == set(AlloyFamily) - {AlloyFamily.OTHER}


def celsius(limit) -> tuple[float, float]:
    return round(limit.general - 273.15, 9), round(limit.exceptional - 273.15, 9)


def test_temperatures():
    assert celsius(self_cooled_temperature_limit()) == (90, 110)
    assert celsius(pressure_fed_temperature_limit(300.0)) == (100, 115)
    assert celsius(pressure_fed_temperature_limit(300.1)) == (110, 125)
    assert pressure_fed_temperature_limit() == pressure_fed_temperature_limit(1.0), "unknown: the lower limit"


@pytest.mark.parametrize("time", [0.0, -1.0, float("nan")])
def test_circulation_time_is_positive(time):
    with pytest.raises(InputError, match="circulation time"):
        pressure_fed_temperature_limit(time)


def test_own_tables_replace_the_shipped_ones():
    own = SHIPPED.replace("[6, 7, 9, 11, 14]", "[6, 7, 9, 11, 20]").replace("general = 90", "general = 85")
    tables = parse_experience_limits(own)
    assert empirical_minimum_film_thickness(0.25, 45.0, tables) == pytest.approx(20e-6)
    assert empirical_minimum_film_thickness(0.25, 45.0) == pytest.approx(14e-6)
    assert celsius(self_cooled_temperature_limit(tables)) == (85, 110)
    assert specific_load_limit(AlloyFamily.TIN, tables) == specific_load_limit(AlloyFamily.TIN)


def test_the_shipped_file_is_its_own_template():
    assert parse_experience_limits(SHIPPED) == experience_limits()


@pytest.mark.parametrize(
    ("original", "damaged"),
    [
        ("[minimum_film_thickness]", "[film]"),
        ("[6, 7, 9, 11, 14]", "[6, 7, 9, 11]"),
        ("[6, 7, 9, 11, 14]", "[6, 7, 9, 11, -14]"),
        ("[6, 7, 9, 11, 14]", '[6, 7, 9, 11, "x"]'),
        ("[63, 160,", "[160, 63,"),
        ("copper-tin ", "unobtainium"),
        ("general = 5,", "general = 50,"),
        ("general = 5,", "general = nan,"),
        ("general = 5,", ""),
        ("source = ", "source "),
    ],
)
def test_damaged_tables_are_refused(original, damaged):
    assert original in SHIPPED
    with pytest.raises(InputError) as error:
        parse_experience_limits(SHIPPED.replace(original, damaged, 1))
    assert error.value.code == "E003"
