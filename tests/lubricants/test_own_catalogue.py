"""Lubricants and materials of the user's own catalogue: found like those that ship, faults named and left out."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import warnings
from importlib import import_module
from pathlib import Path

import pytest

import babbitt as bb
from babbitt.core.notices import InputError
from babbitt.properties import own_catalogue
from babbitt.properties.materials import bearing_metal, catalogue, structural_material

oils, materials = import_module("babbitt.properties.lubricants.catalogue"), catalogue

OIL = """
[[lubricants]]
name = "House oil"
aliases = ["HO 46"]
family = "iso_vg"
source = "data sheet of 2024"
viscosity = { nu40 = 46.0, viscosity_index = 150.0 }
density.value = 860.0
"""
METAL = """
[sources]
mill = "mill sheet of 2023"

[[bearing_metal]]
name = "House metal"
family = "tin-based"
standard = "works standard 12"
composition = { text = "Sn rest", source = "mill" }
calm.specific_load = { value = 12e6, source = "mill" }

[[structural_material]]
name = "House steel"
kind = "steel"
thermal_expansion = 12.5e-6
thermal_conductivity = 40
elastic_modulus = 210e9
poisson_ratio = 0.3
density = 7850
source = "mill"
"""


def forget():
    for function in (
        own_catalogue.own_tables, oils.catalogue, oils._index, materials._read, materials._metals_by_spelling,
        materials._structures_by_spelling,
    ):  # fmt: skip
        function.cache_clear()


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The user's catalogue, which is read anew."""
    monkeypatch.setenv(own_catalogue.VARIABLE, str(tmp_path))
    forget()
    yield tmp_path
    monkeypatch.undo()
    forget()


def test_entries_are_added_to_those_included(folder):
    (folder / "lubricants.toml").write_text(OIL)
    (folder / "materials.toml").write_text(METAL)
    oil = bb.lubricant("ho-46")
    assert oil.name == "House oil"
    assert oil.kinematic_viscosity(313.15) == pytest.approx(46e-6)
    assert oil.density(288.15) == pytest.approx(860.0)
    assert oil.origin == str(folder / "lubricants.toml")
    assert bb.lubricants()[-1] == "House oil"
    assert bb.lubricant("ISO VG 46").origin == ""
    assert bearing_metal("house metal").calm.specific_load.value == 12e6
    assert structural_material("House steel").thermal_expansion == 12.5e-6
    assert {"House metal", "House steel", "B83"} <= {*bb.materials()}


def test_a_bearing_runs_with_them_and_its_report_says_where_they_are_from(folder):
    (folder / "lubricants.toml").write_text(OIL)
    (folder / "materials.toml").write_text(METAL)
    given = {
        "diameter": "100 mm", "width": "50 mm", "clearance": "H7/e8", "span": "360 deg", "load": "10 kN",
        "speed": "1500 rpm", "supply": {"temperature": "50 degC", "pressure": "0.1 MPa"}, "lubricant": "House oil",
        "materials": {"bearing_metal": "House metal", "bearing": "House steel", "journal": "C45"},
    }  # fmt: skip
    result = bb.JournalBearing(**given).solve()
    assert result.settings["lubricant"] == "House oil"
    from babbitt.report.inputs import oil_rows

    rows = {row.label: row.value for row in oil_rows(bb.lubricant("House oil"))}
    assert rows["From the catalogue of the user"] == "lubricants.toml"
    assert "From the catalogue of the user" not in {row.label for row in oil_rows(bb.lubricant("ISO VG 46"))}


def test_one_file_may_hold_all(folder, monkeypatch):
    (folder / "mine.toml").write_text(OIL + METAL)
    monkeypatch.setenv(own_catalogue.VARIABLE, str(folder / "mine.toml"))
    assert bb.lubricants()[-1] == "House oil"
    assert "House steel" in bb.materials()


def test_the_folder_of_the_settings_is_read_without_a_variable(folder, monkeypatch):
    monkeypatch.delenv(own_catalogue.VARIABLE)
    monkeypatch.setattr(own_catalogue, "_settings_folder", lambda: folder / "none")
    assert bb.lubricants()[-1] != "House oil"
    forget()
    (folder / "lubricants.toml").write_text(OIL)
    monkeypatch.setattr(own_catalogue, "_settings_folder", lambda: folder)
    assert bb.lubricants()[-1] == "House oil"


FAULTS = {
    'name = "ISO VG-46"\nfamily = "iso_vg"\nviscosity.nu40 = 46.0\ndensity.value = 860.0':
        "name: .*in the catalogue already",
    'name = "Other"\naliases = ["HO46"]\nfamily = "iso_vg"\nviscosity.nu40 = 46.0\ndensity.value = 860.0':
        "'HO46' is in the catalogue",
    'name = "Typo"\nfamily = "iso_vg"\ndensty.value = 860.0': "densty: .* did you mean density",
    'name = "Thick"\nfamily = "mineral_oil"\nsource = "x"\nviscosity = {nu40 = 5.0, nu100 = 46.0}':
        "viscosity: .* must fall",
    'name = "Text"\nfamily = "iso_vg"\nviscosity.nu40 = "46"\ndensity.value = 860.0': "viscosity: .*another type",
    'name = "NaN"\nfamily = "iso_vg"\nviscosity.nu40 = nan\ndensity.value = 860.0': r"viscosity\.nu40: nan",
    'name = "None"\nfamily = "iso_vgg"': "family: 'iso_vgg'",
    'name = "Bare"\nfamily = "mineral_oil"\nviscosity.nu40 = 46.0': "viscosity: 'nu100' is missing",
    'name = "Unsaid"\nfamily = "mineral_oil"\nviscosity = {nu40 = 46.0, nu100 = 7.0}': "source: ",
    'name = "Range"\nfamily = "iso_vg"\nviscosity.nu40 = 46.0\ndensity.value = 860.0\ntemperature_range = [9, 2]':
        "temperature_range: ",
    'name = "Gas"\nfamily = "iso_vg"\nviscosity.nu40 = 46.0\ndensity = {value = 100.0, at = 15.0, slope = -5.0}':
        "viscosity: is -",
    'name = "List"\nfamily = "iso_vg"\nviscosity.nu40 = 46.0\ndensity.value = 860.0\naliases = "H"': "aliases: ",
    'name = "Heat"\nfamily = "iso_vg"\nviscosity.nu40 = 46.0\ndensity.value = 860.0\n'
    'fixed_volumetric_heat_capacity = {value = "1.8", assumption = "a"}': "fixed_volumetric_heat_capacity: ",
    'family = "iso_vg"': "2 of lubricants is left out: name: ",
    'name = "a\\u001b[31m"': "name: must be one line",
    'name = 5': "name: must be one line",
}  # fmt: skip


@pytest.mark.parametrize(("entry", "says"), FAULTS.items())
def test_a_faulty_entry_is_named_once_and_leaves_the_rest(folder, entry, says):
    later = OIL.replace("House oil", "Later oil").replace("HO 46", "LO 46")
    (folder / "lubricants.toml").write_text(f"{OIL}\n[[lubricants]]\n{entry}\n{later}")
    with pytest.warns(UserWarning, match=f"lubricants.toml: entry .*{says}") as told:
        names = bb.lubricants()
    assert len(told) == 1
    assert "\n" not in str(told[0].message)
    assert "\x1b" not in str(told[0].message)
    assert names[-2:] == ("House oil", "Later oil")
    assert bb.lubricant("ISO VG 46").density(288.15) == pytest.approx(876.0)


@pytest.mark.parametrize(
    ("before", "after", "says"),
    [
        ('name = "House metal"', 'name = "B83"', "'B83' is in the catalogue"),
        ('family = "tin-based"', 'family = "tin"', "'House metal' of bearing_metal .*family: "),
        ("value = 12e6", "value = -12e6", "calm: .*positive"),
        ('source = "mill" }\n\n', 'source = "mil" }\n\n', "calm: 'mil' is missing"),
        ("poisson_ratio = 0.3", "poisson_ratio = 0.6", "'House steel' of structural_material .*poisson_ratio"),
        ("elastic_modulus = 210e9", "elastic_modulus = true", "elastic_modulus: "),
        ("density = 7850", "", "density: 'density' is missing"),
        ("density = 7850", "density = 7850\ncolour = 'grey'", "colour: is no field"),
    ],
)
def test_a_faulty_material_is_named(folder, before, after, says):
    assert before in METAL
    (folder / "materials.toml").write_text(METAL.replace(before, after))
    with pytest.warns(UserWarning, match=says) as told:
        names = bb.materials()
    assert len(told) == 1
    assert sum(name.startswith("House") for name in names) == 1
    assert "C45" in names


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"[[lubricants]\n", "is no TOML"),
        (b"\xff\xfe", "UTF-8"),
        (b"lubricants = 5", "is no list of tables"),
        (b"lubricants = [5]", "entry 1 .*is no table"),
        (b"a = " + b"[" * 5000, "nested too deeply"),
        (b"#" * (own_catalogue.LARGEST + 1), "is larger than 1 MB"),
        (b"families = 5\n" + OIL.encode(), "families: "),
    ],
)
def test_a_file_that_is_none_is_named(folder, content, says):
    (folder / "lubricants.toml").write_bytes(content)
    with pytest.warns(UserWarning, match=says):
        assert "ISO VG 46" in bb.lubricants()


def test_a_pipe_is_not_waited_for(folder):
    os.mkfifo(folder / "lubricants.toml")
    with pytest.warns(UserWarning, match="is not a regular file"):
        assert "ISO VG 46" in bb.lubricants()


def test_what_the_variable_names_must_be_there(folder, monkeypatch):
    monkeypatch.setenv(own_catalogue.VARIABLE, str(folder / "nowhere"))
    with pytest.warns(UserWarning, match="nowhere: there is no such file"):
        bb.lubricants()
    forget()
    monkeypatch.setenv(own_catalogue.VARIABLE, str(folder))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert "ISO VG 46" in bb.lubricants()


def test_a_name_that_is_left_out_is_not_included(folder):
    (folder / "lubricants.toml").write_text(OIL.replace("46.0", "-46.0"))
    with pytest.warns(UserWarning, match="is left out"), pytest.raises(InputError, match="House oil"):
        bb.lubricant("House oil")


def listed(what):
    """What the program lists on a wide terminal."""
    command = [sys.executable, "-m", "babbitt", "list", what]
    wide = os.environ | {"COLUMNS": "1000"}
    return subprocess.run(command, capture_output=True, text=True, check=True, env=wide)


def test_the_lists_show_them_with_their_file(folder):
    (folder / "lubricants.toml").write_text(OIL)
    (folder / "materials.toml").write_text(METAL)
    (line,) = (line for line in listed("lubricants").stdout.splitlines() if "House oil" in line)
    assert f"data sheet of 2024 ({folder / 'lubricants.toml'})" in line
    shown = re.sub(r"[│\s]", "", listed("materials").stdout)  # cells are broken where they are long
    assert "Housemetal" in shown
    assert "Housesteel" in shown
    assert shown.count("millsheetof2023") == shown.count(f"({folder / 'materials.toml'})") == 2


def test_the_entries_of_the_documentation_can_be_used(folder):
    page = (Path(__file__).parents[2] / "docs" / "theory" / "lubricants.md").read_text(encoding="utf-8")
    lubricants, metals = re.findall(r"```text\n(\[.*?)```", page, re.DOTALL)
    (folder / "lubricants.toml").write_text(lubricants)
    (folder / "materials.toml").write_text(metals)
    assert bb.lubricants()[-1] == "House oil 46"
    assert {"House metal", "House steel"} <= {*bb.materials()}


def test_the_program_warns_in_one_line(folder):
    (folder / "lubricants.toml").write_text(OIL.replace("46.0", "-46.0"))
    found = listed("lubricants")
    assert found.stderr.count("\n") == 1
    assert found.stderr.startswith("babbitt: ")
    assert "'House oil'" in found.stderr
