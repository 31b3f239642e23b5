"""Tables of limits of the user's own, beside the case."""

from importlib.resources import files

import pytest

from babbitt.case import CaseError, case_hash, load_case
from babbitt.solving import solve

SHIPPED = files("babbitt.properties.materials").joinpath("limits.toml").read_text(encoding="utf-8")
OWN = (
    SHIPPED.replace(
        'source = "assumption: experience values as in textbooks, arranged as in ISO 7902-3, '
        'not the text of a standard"',
        'source = "works standard 17"',
    )
    .replace("[4, 5, 7, 9, 12]", "[40, 50, 70, 90, 120]")
    .replace("pressure_fed_little_oil = { general = 100", "pressure_fed_little_oil = { general = 51")
)


def written(folder, tables=OWN, kind="journal"):
    """A case of 120 mm diameter that names its tables; other fields as in the template."""
    (folder / "own.toml").write_text(tables, encoding="utf-8")
    fields = {
        "kind": "journal",
        "name": "Test",
        "diameter": "120 mm",
        "width": "60 mm",
        "clearance": "{kind: relative, mean: 1.5 permille}",
        "span": "360 deg",
        "lubricant": "ISO VG 46",
        "supply": "{temperature: 45 degC, pressure: 0.2 MPa}",
        "materials": "{bearing_metal: B83, bearing: C10, journal: C45}",
        "load": "12 kN",
        "speed": "2000 rpm",
        "limits": "{tables: own.toml}",
    }
    if kind == "film":
        fields |= {"method": "film", "effective_temperature": "60 degC"}
    (folder / "case.yaml").write_text("".join(f"{name}: {value}\n" for name, value in fields.items()))
    return folder / "case.yaml"


@pytest.mark.parametrize("kind", ["journal", "film"])
def test_the_checks_use_them(tmp_path, kind):
    (result,) = solve(load_case(written(tmp_path, kind=kind))).results
    checks = {check.code: check for check in result.checks}
    assert checks["C101"].limit == pytest.approx(120e-6 if result.surface_speed > 30.0 else 90e-6)
    assert checks["C101"].source == checks["C103"].source.split(";")[0] == "works standard 17"
    assert checks["C104"].limit == pytest.approx(51.0 + 273.15)
    assert not checks["C104"].ok
    assert any("works standard 17" in text for text in result.assumptions)


def test_the_hash_sees_their_content(tmp_path):
    before = case_hash(load_case(written(tmp_path)))
    assert case_hash(load_case(written(tmp_path))) == before
    assert case_hash(load_case(written(tmp_path, OWN.replace("[40,", "[41,")))) != before


@pytest.mark.parametrize(
    ("tables", "words"),
    [
        ("no toml at all", "is not valid TOML"),
        ("source = 'x'", "does not have the form"),
        (OWN.replace("[40, 50,", "[-40, 50,"), "must be positive"),
        ("\x00\xff", "TOML"),
        ("# " + "x" * 100_001, "larger than 100 kB"),
    ],
)
def test_tables_that_cannot_be_used(tmp_path, tables, words):
    with pytest.raises(CaseError, match=words) as caught:
        load_case(written(tmp_path, tables))
    (problem,) = caught.value.problems
    assert problem.field == "limits.tables"
    assert problem.line == 12


def test_a_file_that_is_not_there(tmp_path):
    path = written(tmp_path)
    (tmp_path / "own.toml").unlink()
    with pytest.raises(CaseError, match="there is no such file"):
        load_case(path)


@pytest.mark.parametrize(
    ("time", "limit", "why"),
    [
        ("", 100, "oil volume over flow not given: taken as up to 5 min"),
        (", circulation_time: 4 min", 100, "oil volume over flow 4 min ≤ 5 min"),
        (", circulation_time: 6 min", 110, "oil volume over flow 6 min > 5 min"),
    ],
)
def test_the_limit_of_the_outlet_says_why_it_is_the_lower_or_the_higher_one(tmp_path, time, limit, why):
    file = written(tmp_path, SHIPPED)
    file.write_text(file.read_text().replace("pressure: 0.2 MPa", f"pressure: 0.2 MPa{time}"))
    checks = {check.code: check for check in solve(load_case(file)).results[0].checks}
    assert checks["C104"].limit == pytest.approx(limit + 273.15)
    assert checks["C104"].source.endswith(f"; {why}")
    assert checks["C109"].source.endswith("C104 and C108 are the limits (an assumption of this program)")
