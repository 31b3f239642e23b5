"""The catalogue: complete, sourced, and consistent with the standards it quotes."""

import subprocess
import sys
import tomllib
from importlib import resources

import numpy as np
import pytest
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.properties.lubricants import catalogue, lubricant, viscosity_index

CELSIUS = 273.15
VG_CLASSES = (10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460, 680)
SAE_NU100 = {
    "SAE 20": (6.9, 9.3),
    "SAE 30": (9.3, 12.5),
    "SAE 40": (12.5, 16.3),
    "SAE 50": (16.3, 21.9),
    "SAE 10W-30": (9.3, 12.5),
    "SAE 10W-40": (12.5, 16.3),
    "SAE 15W-40": (12.5, 16.3),
}
ENTRIES = pytest.mark.parametrize("entry", catalogue(), ids=lambda entry: entry.name)


def nu(entry, celsius):
    return entry.kinematic_viscosity(celsius + CELSIUS) * 1e6


def index_of(entry):
    return viscosity_index(nu(entry, 40) * 1e-6, nu(entry, 100) * 1e-6)


def test_everything_promised_is_included():
    names = {entry.name for entry in catalogue()}
    assert names == {
        *(f"ISO VG {n}" for n in VG_CLASSES),
        *SAE_NU100,
        *("TP-46", "TP-46 STO upper", "T-22", "T-30", "M14G2TsS", "IPM-10", "water"),
    }
    assert len(catalogue()) == len(names)


@ENTRIES
def test_every_entry_names_its_sources(entry):
    assert entry.source
    assert entry.assumptions
    assert all(text.endswith(".") for text in entry.assumptions)
    if entry.name != "water":  # where one source covers all properties
        assert entry.sources.density
        assert entry.sources.heat_capacity
        assert entry.sources.conductivity


@ENTRIES
def test_every_entry_is_a_liquid_that_thins(entry):
    kelvin = np.linspace(*entry.temperature_range, 101)
    assert np.all(np.diff(entry.kinematic_viscosity(kelvin)) < 0)
    assert np.all(np.diff(entry.density(kelvin)) < 0)
    density, heat = (800, 1000), (1.55e6, 1.85e6) if entry.name != "water" else (4.0e6, 4.25e6)
    celsius_60 = 333.15
    assert density[0] * 0.95 < entry.density(celsius_60) < density[1]
    assert heat[0] < entry.volumetric_heat_capacity(celsius_60) < heat[1]
    assert 0.1 < entry.conductivity(celsius_60) < 0.7


@ENTRIES
def test_short_walther_is_not_used_far_below_its_2_mm2_per_s(entry):
    if entry.name != "water":
        assert entry.kinematic_viscosity(entry.temperature_range[1]) > 1.8e-6


@pytest.mark.parametrize("grade", VG_CLASSES)
def test_iso_vg_has_its_mid_point_and_index_95(grade):
    entry = lubricant(f"ISO VG {grade}")
    assert nu(entry, 40) == pytest.approx(grade, rel=1e-10)
    assert index_of(entry) == pytest.approx(95.0, abs=1e-6)
    computed = [text for text in entry.assumptions if "computed from viscosity index 95" in text]
    assert f"{nu(entry, 100):.4g} mm2/s" in computed[0]


@pytest.mark.parametrize("name", SAE_NU100)
def test_sae_grades_lie_in_their_range_of_j300(name):
    entry = lubricant(name)
    low, high = SAE_NU100[name]
    assert low <= nu(entry, 100) < high
    assert (120 < index_of(entry) < 165) if "W" in name else (90 < index_of(entry) < 105)
    assert any("typical" in text.lower() for text in entry.assumptions)


def test_tp_46_of_the_study_text():
    entry = lubricant("TP-46")
    assert [f"{nu(entry, t):.2f}" for t in (40, 50, 60, 63, 80, 100)] == [
        "63.50",
        "39.80",
        "26.50",
        "23.70",
        "13.56",
        "8.00",
    ]
    assert entry.density(293.15) == pytest.approx(895.0, rel=1e-13)
    assert entry.heat_capacity(323.15) == pytest.approx(1942.0, rel=1e-13)


def test_tp_46_at_its_sto_limit():
    entry = lubricant("TP-46 STO upper")
    assert [f"{nu(entry, t):.2f}" for t in (50, 60, 63, 70)] == ["31.97", "21.66", "19.46", "15.40"]
    assert nu(entry, 100) == pytest.approx(6.873547971255763, rel=1e-12)
    assert entry.volumetric_heat_capacity(330.0) == 1.8e6
    celsius = np.array([20.0, 50.0, 80.0])
    assert_allclose(entry.density(celsius + CELSIUS), 895.0 - 0.63 * (celsius - 20.0), rtol=1e-12)


@pytest.mark.parametrize(("name", "nu50", "index"), [("T-22", 21.5, 70), ("T-30", 30.0, 65)])
def test_gost_turbine_oils_meet_what_they_were_computed_from(name, nu50, index):
    assert nu(lubricant(name), 50) == pytest.approx(nu50, rel=2e-4)
    assert index_of(lubricant(name)) == pytest.approx(index, abs=0.05)


def test_m14g2tss_is_tp_46_without_the_shifts_of_the_study():
    motor, turbine = lubricant("M14G2TsS"), lubricant("TP-46")
    kelvin = np.array([293.15, 323.15, 373.15])
    assert_allclose(motor.density(kelvin) - turbine.density(kelvin), 6.0, rtol=1e-9)
    assert_allclose(motor.heat_capacity(kelvin) - turbine.heat_capacity(kelvin), 46.0, rtol=1e-9)
    assert nu(motor, 100) == pytest.approx(14.0, rel=1e-10)
    assert index_of(motor) == pytest.approx(92.0, abs=1e-6)


def test_ipm_10_of_the_heat_exchange_study():
    entry = lubricant("IPM-10")
    kelvin = np.array([50, 70, 90, 130.0]) + CELSIUS
    assert_allclose(entry.dynamic_viscosity(kelvin) * 1e3, [8.3775, 4.5094, 2.7915, 1.3970], atol=6e-5)
    assert any("assumed by the study" in said for said in entry.assumptions)
    assert not entry.covers(CELSIUS - 40.0)
    assert_allclose(entry.heat_capacity(kelvin), [1974.1, 2066.2, 2158.3, 2342.5], atol=0.1)


@pytest.mark.parametrize("name", ["ISO VG 46", "IPM-10", "TP-46 STO upper"])
def test_a_given_volumetric_heat_capacity_takes_its_assumptions_with_it(name):
    entry = lubricant(name)
    given = entry.with_volumetric_heat_capacity(1.7e6)
    kelvin = np.array([300.0, 330.0, 370.0])
    assert_allclose(given.volumetric_heat_capacity(kelvin), 1.7e6, rtol=0)
    assert_allclose(given.dynamic_viscosity(kelvin), entry.dynamic_viscosity(kelvin), rtol=0)
    left = [said for said in entry.assumptions if said not in given.assumptions]
    assert left
    assert all("heat capacity" in said.lower() for said in left)
    assert not any("heat capacity" in said.lower() for said in given.assumptions)


def test_water_meets_the_iapws_table_within_what_it_states():
    water = lubricant("water")
    kelvin = np.array([280, 290, 300, 310, 320, 330, 340, 350, 360.0])
    molar_mass = 18.015268e-3
    density = np.array([55.501, 55.440, 55.315, 55.139, 54.919, 54.662, 54.371, 54.049, 53.698]) * 1e3 * molar_mass
    viscosity = np.array([1433.7, 1084.0, 853.84, 693.54, 577.02, 489.49, 421.97, 368.77, 326.10]) * 1e-6
    heat = np.array([75.669, 75.435, 75.320, 75.294, 75.317, 75.373, 75.456, 75.567, 75.708]) / molar_mass
    conductivity = np.array([574.04, 592.73, 610.28, 626.05, 639.71, 651.18, 660.55, 668.00, 673.76]) * 1e-3
    assert_allclose(water.dynamic_viscosity(kelvin), viscosity, rtol=5e-3)
    assert_allclose(water.density(kelvin), density, rtol=5e-3)
    assert_allclose(water.heat_capacity(kelvin), heat, rtol=7e-3)
    assert_allclose(water.conductivity(kelvin), conductivity, rtol=2e-2)


@pytest.mark.parametrize(
    ("asked", "found"),
    [
        ("iso vg 46", "ISO VG 46"),
        ("ISO-VG_46", "ISO VG 46"),
        ("vg46", "ISO VG 46"),
        ("tp46", "TP-46"),
        ("TP46_STO_upper", "TP-46 STO upper"),
        ("ТП-46", "TP-46"),
        ("м-14г2цс", "M14G2TsS"),  # noqa: RUF001
        ("15w40", "SAE 15W-40"),
        ("Water", "water"),
    ],
)
def test_names_are_found_however_they_are_written(asked, found):
    assert lubricant(asked).name == found


def test_no_two_entries_share_a_name():
    keys = [
        "".join(letter for letter in name.casefold() if letter.isalnum())
        for entry in catalogue()
        for name in (entry.name, *entry.aliases)
    ]
    assert len(keys) == len(set(keys))


@pytest.mark.parametrize(
    ("asked", "hint"),
    [
        ("ISO VG 47", "nearest is 'ISO VG 46'"),
        ("watr", "nearest is 'water'"),
        ("TP-46 STO lower", "'TP-46 STO upper'"),
        ("zzzz", "No name in the catalogue is near it"),
        ("", "No name in the catalogue is near it"),
    ],
)
def test_an_unknown_name_is_answered_with_the_nearest(asked, hint):
    with pytest.raises(InputError, match=hint) as caught:
        lubricant(asked)
    assert caught.value.code == "E005"
    assert repr(asked) in caught.value.message


def test_the_file_has_no_field_that_nothing_reads():
    text = resources.files("babbitt.properties.lubricants").joinpath("catalogue.toml").read_text(encoding="utf-8")
    file = tomllib.loads(text)
    tables = {
        "viscosity": {"nu40", "nu100", "viscosity_index", "form", "additive", "points", "source"},
        "density": {"law", "at", "value", "slope", "source", "assumption"},
        "fixed_volumetric_heat_capacity": {"value", "assumption"},
    }
    tables["heat_capacity"] = tables["conductivity"] = tables["density"]
    plain = {"name", "aliases", "family", "extends", "source", "assumptions", "temperature_range"}
    for entry in [*file["lubricants"], *file["families"].values()]:
        assert set(entry) <= plain | set(tables)
        for name, fields in tables.items():
            assert set(entry.get(name, {})) <= fields, (entry.get("name"), name)


def test_the_whole_catalogue_is_read_without_scipy():
    code = "import sys, babbitt.properties.lubricants as b; b.catalogue(); "
    code += "print({'scipy', 'pandas'} & set(sys.modules))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "set()"
