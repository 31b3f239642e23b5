"""Where the command line writes: only its own outputs are replaced, and tables are what their ending says."""

import csv

import pytest

from babbitt.case import template

FILM = """\
kind: journal
name: Grooved
method: film
diameter: 200 mm
width: 120 mm
clearance: {kind: relative, mean: 1.5 permille}
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.15 MPa}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
load: 30 kN
speed: 3000 rpm
"""


@pytest.mark.parametrize(
    ("arguments", "taken"),
    [
        (("solve", "case.yaml", "--json", "notes.txt"), "notes.txt"),
        (("solve", "case.yaml", "--report", "page.html"), "page.html"),
        (("compare", "case.yaml", "--report", "page.html"), "page.html"),
        (("sweep", "case.yaml", "load", "1 kN", "--csv", "data.csv"), "data.csv"),
        (("sweep", "case.yaml", "load", "1 kN", "--plot", "drawing.svg"), "drawing.svg"),
        (("export", "case.yaml", "--format", "csv", "--speeds", "1000 rpm", "-o", "data.csv"), "data.csv"),
        (("new", "journal", "-o", "data.csv"), "data.csv"),
    ],
)
def test_no_output_replaces_a_file_of_somebody_else(run, tmp_path, arguments, taken):
    (tmp_path / "case.yaml").write_text(FILM)
    (tmp_path / taken).write_text("mine")
    status, out, err = run(*arguments)
    assert (status, out) == (2, "")
    assert taken in err
    assert (tmp_path / taken).read_text() == "mine"
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["case.yaml", taken])


def test_a_second_run_replaces_its_outputs(run, tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"))
    for command in (
        ("solve", "case.yaml", "--json", "a.json", "--plots", "plots"),
        ("sweep", "case.yaml", "load", "1 kN, 2 kN", "--csv", "a.csv"),
        ("sweep", "case.yaml", "load", "1 kN, 2 kN", "--csv", "a.xlsx", "--plot", "a.png"),
    ):
        assert run(*command)[0] == run(*command)[0] == 0


def test_a_table_that_the_case_reads_is_no_place_for_an_output(run, tmp_path):
    text = FILM + "bore: {kind: measured, file: bore.csv}\n"
    (tmp_path / "case.yaml").write_text(text)
    rows = "".join(f"{angle},0\n" for angle in range(0, 360, 30))
    (tmp_path / "bore.csv").write_text(f"angle [deg],departure [um]\n{rows}")
    before = (tmp_path / "bore.csv").read_text()
    status, _, err = run("sweep", "case.yaml", "load", "1 kN, 2 kN", "--csv", "bore.csv")
    assert status == 2
    assert "a file that the case reads" in err
    assert (tmp_path / "bore.csv").read_text() == before


def test_a_new_case_on_standard_output_is_no_file(run, tmp_path):
    status, out, err = run("new", "journal", "-o", "-")
    assert (status, out, err) == (0, template("journal"), "")
    assert list(tmp_path.iterdir()) == []


def test_a_sweep_as_a_workbook_has_numbers_and_words(run, tmp_path):
    from openpyxl import load_workbook

    (tmp_path / "film.yaml").write_text(FILM.replace("name: Grooved", 'name: "=1+1"'))
    assert run("sweep", "film.yaml", "load", "30 kN", "--csv", "a.xlsx")[0] == 0
    assert run("sweep", "film.yaml", "load", "30 kN", "--csv", "a.csv")[0] == 0
    head, row = load_workbook(tmp_path / "a.xlsx").active.iter_rows()
    found = {title.value: cell for title, cell in zip(head, row, strict=True)}
    (lines,) = csv.DictReader((tmp_path / "a.csv").read_text().splitlines())
    assert found["bearing"].value == "=1+1"
    assert found["bearing"].data_type == "s"
    assert lines["bearing"] == "'=1+1"
    assert found["load [kN]"].value == 30.0
    assert head[0].font.bold
    assert head[0].parent.freeze_panes == "B2"
    for title, cell in found.items():
        if title not in ("bearing", "status", "verdict", "governing_check", "codes"):
            assert cell.data_type == "n"
            assert cell.value == pytest.approx(float(lines[title]), rel=1e-15), title


@pytest.mark.parametrize("name", ["out.txt", "out", "out.xls"])
def test_a_table_of_unknown_ending_is_refused(run, tmp_path, name):
    (tmp_path / "case.yaml").write_text(template("journal"))
    status, out, err = run("sweep", "case.yaml", "load", "1 kN", "--csv", name)
    assert (status, out) == (2, "")
    assert ".csv or .xlsx" in err
    assert not (tmp_path / name).exists()


def test_a_sweep_on_standard_output_is_alone_there(run, tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"))
    status, out, _ = run("sweep", "case.yaml", "load", "1 kN, 2 kN", "--csv", "-")
    assert status == 0
    assert [row["load [kN]"] for row in csv.DictReader(out.splitlines())] == ["1.0", "2.0"]
    assert [path.name for path in tmp_path.iterdir()] == ["case.yaml"]


@pytest.mark.usefixtures("no_images")
def test_fields_of_bearings_with_like_names_do_not_replace_each_other(run, tmp_path):
    xarray = pytest.importorskip("xarray")
    h5netcdf = pytest.importorskip("h5netcdf")
    shared, own = FILM.split("diameter")[0], "diameter" + FILM.split("diameter")[1]
    assert shared.startswith("kind: journal")
    bearing = own.replace("load: 30 kN\n", "").replace("\n", "\n    ").rstrip()
    bearings = "".join(
        f"  - name: {name}\n    kind: journal\n    method: film\n    accuracy: draft\n"
        f"    load: {load} kN\n    {bearing}\n"
        for name, load in (("a/b", 10), ("a-b", 20), (".", 30))
    )
    (tmp_path / "case.yaml").write_text(f"kind: machine\nname: Likes\nbearings:\n{bearings}")
    status, _, err = run("solve", "case.yaml", "--fields", "out.nc", "--plots", "plots")
    assert status == 0, err
    with h5netcdf.File(tmp_path / "out.nc", "r") as file:
        groups = {name: file[name].attrs["title"] for name in file.groups}
    assert sorted(groups.values()) == [".", "a-b", "a/b"]
    loads = {}
    for group, title in groups.items():
        with xarray.open_dataset(tmp_path / "out.nc", group=group) as found:
            loads[title] = round(float(found["load"]))
    assert loads == {"a/b": 10000, "a-b": 20000, ".": 30000}
    assert run("solve", "case.yaml", "--fields", "out.nc")[0] == 0
