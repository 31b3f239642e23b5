"""Materials of the catalogue: every number sourced, in the range of metals, found by the names people write."""

import tomllib
from importlib.resources import files

import pytest

from babbitt.case.parts.materials import Metal
from babbitt.core.notices import InputError
from babbitt.properties.materials import (
    AlloyFamily,
    BearingMetal,
    LoadCharacter,
    SourcedText,
    SourcedValue,
    StructuralMaterial,
    bearing_metal,
    bearing_metals,
    structural_material,
    structural_materials,
)
from babbitt.properties.materials.naming import spelling

METALS = {metal.name: metal for metal in bearing_metals()}
STRUCTURES = {material.name: material for material in structural_materials()}


def sourced_values(metal: BearingMetal) -> list[SourcedValue]:
    """Every number of a bearing metal that is known."""
    limits = [metal.limits(character) for character in LoadCharacter]
    values = [value for limit in limits for value in (limit.specific_load, limit.sliding_speed, limit.pv)]
    values += [
        metal.recommended_temperature,
        metal.limiting_temperature,
        metal.published_outlet_limit,
        metal.thermal_expansion,
        metal.brinell_hardness,
    ]
    return [value for value in values if value is not None]


def test_b83_limits():
    """GOST 1320-74: 15/10 MPa, 50 m/s, 75/50 MPa m/s; advice 70 °C, limit 115 °C."""
    b83 = bearing_metal("B83")
    assert b83.published_outlet_limit.value == pytest.approx(125.0 + 273.15)  # T_lim of the gearbox study
    calm, shock = b83.limits(LoadCharacter.CALM), b83.limits(LoadCharacter.SHOCK)
    assert (calm.specific_load.value, calm.sliding_speed.value, calm.pv.value) == (15e6, 50.0, 75e6)
    assert (shock.specific_load.value, shock.sliding_speed.value, shock.pv.value) == (10e6, 50.0, 50e6)
    assert b83.recommended_temperature.value - 273.15 == pytest.approx(70)
    assert b83.limiting_temperature.value - 273.15 == pytest.approx(115)
    assert "GOST 1320-74" in calm.pv.source
    assert b83.family is AlloyFamily.TIN


COMMON_METALS = """
    SnSb8Cu4 SnSb12Cu6Pb PbSb15SnAs PbSb15Sn10 PbSb10Sn6 CuPb10Sn10 CuPb15Sn8 CuPb20Sn5 CuSn8P CuSn10P
    CuAl10Fe5Ni5 AlSn20Cu AlSn6Cu CuPb24Sn4 CuPb24Sn B83
"""
COMMON_STRUCTURES = """
    C45 42CrMo4 34CrNiMo6 18CrNiMo7-6 S355 EN-GJL-250 EN-GJS-400-15 GE240 AlSi10Mg CuSn12
"""


@pytest.mark.parametrize("name", COMMON_METALS.split())
def test_common_bearing_metals_are_included(name):
    assert bearing_metal(name).name == name


@pytest.mark.parametrize("name", COMMON_STRUCTURES.split())
def test_common_structural_materials_are_included(name):
    assert structural_material(name).name == name


@pytest.mark.parametrize("name", METALS)
def test_every_number_of_a_bearing_metal_names_its_source(name):
    metal = METALS[name]
    values = sourced_values(metal)
    assert values
    for statement in (metal.composition, *values):
        assert len(statement.source) > 10
    assert metal.standard.startswith(("ISO 438", "GOST 1320"))


@pytest.mark.parametrize("name", METALS)
def test_bearing_metals_are_plausible(name):
    metal = METALS[name]
    if metal.thermal_expansion:
        assert 15e-6 <= metal.thermal_expansion.value <= 26e-6
    assert 10 <= metal.brinell_hardness.value <= 200
    for character in LoadCharacter:
        limits = metal.limits(character)
        if limits.pv:
            assert limits.pv.value <= limits.specific_load.value * limits.sliding_speed.value
    if metal.shock.specific_load:
        assert metal.shock.specific_load.value <= metal.calm.specific_load.value
    if metal.limiting_temperature:
        assert metal.recommended_temperature.value < metal.limiting_temperature.value < 423


def test_family_is_the_main_alloying_element():
    """Designations begin with the base metal; copper alloys follow with what gives the family its name."""
    base = {"Pb": "lead-", "Sn": "tin-", "B16": "lead-", "B": "tin-", "Al": "aluminium-", "Cu": "copper-"}
    for name, metal in METALS.items():
        prefix = next(key for key in ("Pb", "Sn", "Al", "Cu", "B16", "B") if name.startswith(key))
        assert metal.family.startswith(base[prefix]), name


@pytest.mark.parametrize("name", STRUCTURES)
def test_structural_materials_are_plausible(name):
    material = STRUCTURES[name]
    assert 10e-6 <= material.thermal_expansion <= 25e-6
    assert 10 <= material.thermal_conductivity <= 250
    assert 60e9 <= material.elastic_modulus <= 220e9
    assert 0.25 <= material.poisson_ratio <= 0.35
    assert 2600 <= material.density <= 9000
    assert len(material.source) > 10


def test_stiff_metals_expand_little():
    """E alpha varies less than either factor among metals (Grüneisen): a slipped digit would show."""
    products = {m.name: m.elastic_modulus * m.thermal_expansion for m in STRUCTURES.values()}
    steels = [products[m.name] for m in STRUCTURES.values() if "steel" in m.kind]
    assert max(steels) / min(steels) < 1.5
    assert max(products.values()) / min(products.values()) < 2.6


@pytest.mark.parametrize(
    ("written", "name"),
    [
        ("b83", "B83"),
        ("B 83", "B83"),
        ("Б83", "B83"),
        ("Б-83", "B83"),
        ("SnSb11Cu6", "B83"),
        ("snsb8cu4", "SnSb8Cu4"),
        (" Cu Pb 10 Sn 10 ", "CuPb10Sn10"),
        ("cu_sn8_p", "CuSn8P"),
    ],
)
def test_spelling_of_bearing_metals(written, name):
    assert bearing_metal(written).name == name


@pytest.mark.parametrize(
    ("written", "name"),
    [
        ("42 crmo4", "42CrMo4"),
        ("18CrNiMo7 6", "18CrNiMo7-6"),
        ("GJL250", "EN-GJL-250"),
        ("en-gjs-400", "EN-GJS-400-15"),
        ("1.4462", "X2CrNiMoN22-5-3"),
        ("Cast Steel", "GE240"),
    ],
)
def test_spelling_of_structural_materials(written, name):
    assert structural_material(written).name == name


@pytest.mark.parametrize(
    ("find", "written", "nearest"),
    [
        (bearing_metal, "SnSb8Cu5", "SnSb8Cu4"),
        (bearing_metal, "B38", "B83"),
        (structural_material, "42CrMo5", "42CrMo4"),
        (structural_material, "GJL-200", "EN-GJL-250"),
    ],
)
def test_unknown_name_suggests_the_nearest(find, written, nearest):
    with pytest.raises(InputError) as error:
        find(written)
    assert error.value.code == "E005"
    assert repr(written) in error.value.message
    assert nearest in error.value.message
    assert "babbitt list materials" in error.value.message


def test_unknown_name_without_a_neighbour_and_very_long():
    with pytest.raises(InputError, match="no similar name") as error:
        bearing_metal("?" * 10_000)
    assert len(error.value.message) < 300


def test_no_two_entries_share_a_name():
    for entries in (bearing_metals(), structural_materials()):
        names = [spelling(name) for entry in entries for name in (entry.name, *entry.aliases)]
        assert len(names) == len(set(names))


def test_every_source_of_the_catalogue_is_used():
    text = files("babbitt.properties.materials").joinpath("catalogue.toml").read_text(encoding="utf-8")
    used = {statement.source for metal in bearing_metals() for statement in sourced_values(metal)}
    used |= {metal.composition.source for metal in bearing_metals()}
    used |= {material.source for material in structural_materials()}
    assert used == set(tomllib.loads(text)["sources"].values())


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
def test_own_metals_are_checked(value):
    with pytest.raises(InputError) as error:
        SourcedValue(value, "maker's certificate")
    assert error.value.code == "E003"


def test_a_value_without_source_is_refused():
    with pytest.raises(InputError, match="names no source"):
        SourcedValue(1.0, "  ")


@pytest.mark.parametrize(
    ("field", "value"), [("poisson_ratio", 0.5), ("density", -1.0), ("elastic_modulus", float("nan"))]
)
def test_own_structural_materials_are_checked(field, value):
    steel = {
        "name": "mine",
        "kind": "steel",
        "thermal_expansion": 11e-6,
        "thermal_conductivity": 40.0,
        "elastic_modulus": 210e9,
        "poisson_ratio": 0.3,
        "density": 7850.0,
        "source": "certificate",
    }
    assert StructuralMaterial(**steel).density == 7850.0
    with pytest.raises(InputError, match=field) as error:
        StructuralMaterial(**{**steel, field: value})
    assert error.value.code == "E003"


def test_an_own_metal_has_no_limits_unless_given():
    mine = BearingMetal("mine", AlloyFamily.COPPER_TIN, "none", SourcedText("CuSn9", "certificate"))
    assert mine.limits(LoadCharacter.SHOCK).specific_load is None
    assert mine.limiting_temperature is None


def test_own_limits_beside_a_name_of_the_catalogue_leave_its_others():
    known, given = bearing_metal("B83"), Metal.model_validate({"name": "b83", "specific_load": "100 MPa"}).metal()
    assert given.calm.specific_load.value == given.shock.specific_load.value == 100e6
    assert given.calm.specific_load.source == "metal of the case"
    assert (given.name, given.family) == (known.name, known.family)
    assert (given.calm.sliding_speed, given.calm.pv) == (known.calm.sliding_speed, known.calm.pv)
    assert given.limiting_temperature == known.limiting_temperature
    cooler = Metal.model_validate({"name": "B83", "temperature": "90 degC"}).metal()
    assert cooler.limiting_temperature.value == pytest.approx(363.15)
    assert cooler.calm == known.calm
    own = Metal.model_validate({"name": "mine", "load_times_speed": "30 MPa m/s"}).metal()
    assert (own.family, own.calm.pv.value, own.calm.specific_load) == (AlloyFamily.OTHER, 30e6, None)
    with_product = Metal.model_validate({"name": "B83", "load_times_speed": "30 MPa m/s"}).metal()
    assert with_product.calm.pv.value == 30e6
