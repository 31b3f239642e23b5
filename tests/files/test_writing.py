"""Every output is written whole, and only over an earlier output of Babbitt."""

import errno
import io
import os
import zipfile
from pathlib import Path

import numpy as np
import pytest

from babbitt.case import parse_case, template
from babbitt.core.files import writing
from babbitt.core.files.marks import is_output
from babbitt.core.files.spreadsheet import workbook
from babbitt.core.files.writing import create_file, require_distinct, require_writable, write_file, write_files
from babbitt.core.notices import InputError
from babbitt.export import FORMATS, CoefficientTable, export
from babbitt.report.document import write_report
from babbitt.report.drawing import FORMATS as IMAGES
from babbitt.report.drawing import rendered, style
from babbitt.report.export import write_json
from babbitt.solving import solve

SPEEDS = np.linspace(100.0, 300.0, 8)
TABLE = CoefficientTable(
    name="=Drive end", speeds=SPEEDS, stiffness=np.ones((8, 2, 2)), damping=np.ones((8, 2, 2)), method="film"
)

OTHERS = {
    "case.json": b'{"babbitt": 1, "kind": "journal"}',
    "case.yaml": b"babbitt: 1\nkind: journal\nnotes: Babbitt\n",
    "bore.csv": b"angle [deg],departure [um]\n0,1\n",
    "bearings.csv": b"bearing,load\nPinion,3\n",
    "limits.toml": b"[babbitt]\nross_version = 3\n",
    "page.html": b"<!DOCTYPE html><html><head><title>Babbitt</title></head></html>",
    "paper.pdf": b"%PDF-1.7\n1 0 obj\n<</Title(Babbitt and others)/Creator(LaTeX)>>\nendobj\n",
    "drawing.svg": b'<?xml version="1.0"?><svg><text>Babbitt</text></svg>',
    "photo.png": b"\x89PNG\r\n\x1a\n" + 40 * b"\0" + b"Babbitt",
    "archive.xlsx": b"PK\x03\x04",
    "field.nc": b"\x89HDF\r\n\x1a\n Babbitt 0.1.0",
    "empty.json": b"",
    "binary": bytes(range(256)),
}


@pytest.mark.parametrize("name", OTHERS)
def test_a_file_of_somebody_else_is_refused_before_and_when_writing(tmp_path, name):
    path = tmp_path / name
    path.write_bytes(OTHERS[name])
    for attempt in (lambda: require_writable(path), lambda: write_file(path, b"new")):
        with pytest.raises(InputError, match="no output of Babbitt") as refused:
            attempt()
        assert refused.value.code == "E007"
    assert path.read_bytes() == OTHERS[name]
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    ("format_name", "suffix"), [(one.name, suffix) for one in FORMATS.values() for suffix in one.suffixes]
)
def test_every_table_for_rotor_programs_is_known_again(tmp_path, format_name, suffix):
    path = tmp_path / f"table{suffix}"
    export(TABLE, path, format_name)
    assert is_output(path)
    export(TABLE, path, format_name)


def test_results_and_reports_are_known_again(tmp_path):
    machine = solve(parse_case(template("journal")))
    write_file(tmp_path / "out.json", write_json(machine).encode())
    for suffix in (".html", ".pdf"):
        write_report(machine, tmp_path / f"out{suffix}")
    assert all(is_output(path) for path in tmp_path.iterdir())


@pytest.mark.parametrize("image_format", IMAGES)
def test_figures_are_known_again(tmp_path, image_format):
    with style():
        from matplotlib.figure import Figure

        write_file(tmp_path / "figure", rendered(Figure(), image_format))
    assert is_output(tmp_path / "figure")


def test_a_workbook_that_somebody_has_saved_since_is_theirs(tmp_path):
    ours, theirs = tmp_path / "ours.xlsx", tmp_path / "theirs.xlsx"
    write_file(ours, workbook({"Sweep": [["a", 1.0]]}, "x"))
    with zipfile.ZipFile(ours) as book, zipfile.ZipFile(theirs, "w") as saved:
        for name in book.namelist():
            content = book.read(name)
            if name == "docProps/core.xml":
                content = content.replace(
                    b"</cp:coreProperties>", b"<cp:lastModifiedBy>A</cp:lastModifiedBy></cp:coreProperties>"
                )
            saved.writestr(name, content)
    assert is_output(ours)
    assert not is_output(theirs)


def test_a_full_disk_leaves_nothing_and_what_was_there(tmp_path, monkeypatch):
    path = tmp_path / "table.csv"
    export(TABLE, path, "csv")
    before = path.read_bytes()

    class Full:
        def __init__(self, handle, mode):
            os.close(handle)

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def write(self, content):
            raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(writing.os, "fdopen", Full)
    for attempt in (lambda: write_file(path, b"x"), lambda: create_file(tmp_path / "case.yaml", b"x")):
        with pytest.raises(InputError, match="No space left"):
            attempt()
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_a_new_file_replaces_nothing_not_even_an_output_or_a_loose_link(tmp_path):
    export(TABLE, tmp_path / "table.csv", "csv")
    (tmp_path / "link").symlink_to("nowhere")
    for name in ("table.csv", "link"):
        with pytest.raises(InputError, match="exists already"):
            create_file(tmp_path / name, b"x")
    assert not (tmp_path / "nowhere").exists()
    create_file(tmp_path / "new", b"x")
    assert (tmp_path / "new").read_bytes() == b"x"
    assert {path.name for path in tmp_path.iterdir()} == {"table.csv", "link", "new"}


def test_a_new_file_where_the_file_system_has_no_links(tmp_path, monkeypatch):
    def without(*_):
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(writing.os, "link", without)
    create_file(tmp_path / "new", b"x")
    assert [path.name for path in tmp_path.iterdir()] == ["new"]
    with pytest.raises(InputError, match="exists already"):
        create_file(tmp_path / "new", b"y")
    assert (tmp_path / "new").read_bytes() == b"x"


def test_half_a_file_is_closed_before_it_is_removed(tmp_path, monkeypatch):
    """Without links and on a full disk: Windows removes no file that is open."""
    path, usual_open, usual_unlink = tmp_path / "new", Path.open, Path.unlink
    opened = []

    class Full(io.BytesIO):
        def __init__(self, name):
            super().__init__()
            usual_open(name, "xb").close()

        def write(self, _content):
            raise OSError(errno.ENOSPC, "No space left on device")

    def without(*_):
        raise OSError(errno.EPERM, "Operation not permitted")

    def open_full(name, mode="r", **how):
        if mode != "xb":
            return usual_open(name, mode, **how)
        opened.append(Full(name))
        return opened[-1]

    def unlink_closed(name, **how):
        if name == path and not all(file.closed for file in opened):
            raise PermissionError(errno.EACCES, "The process cannot access the file because it is being used")
        usual_unlink(name, **how)

    monkeypatch.setattr(writing.os, "link", without)
    monkeypatch.setattr(Path, "open", open_full)
    monkeypatch.setattr(Path, "unlink", unlink_closed)
    with pytest.raises(InputError, match="No space left"):
        create_file(path, b"x")
    assert opened
    assert list(tmp_path.iterdir()) == []


def test_an_input_is_refused_by_whatever_name_it_is_called(tmp_path):
    case = tmp_path / "case.yaml"
    case.write_text("kind: journal")
    (tmp_path / "soft.json").symlink_to(case)
    os.link(case, tmp_path / "hard.json")
    for name in ("case.yaml", "soft.json", "hard.json", "./case.yaml"):
        with pytest.raises(InputError, match="it is a case file"):
            require_distinct([tmp_path / name], {case: "a case file"})
    with pytest.raises(InputError, match="another output"):
        require_distinct([tmp_path / "a.svg", tmp_path / "." / "a.svg"], {})


def test_of_several_files_none_is_written_where_one_may_not_be(tmp_path):
    (tmp_path / "b.svg").write_bytes(OTHERS["drawing.svg"])
    with pytest.raises(InputError, match="no output of Babbitt"):
        write_files(tmp_path, {"a.svg": b"x", "b.svg": b"x"})
    assert [path.name for path in tmp_path.iterdir()] == ["b.svg"]


def test_names_are_printed_with_their_escapes(tmp_path):
    with pytest.raises(InputError) as refused:
        write_file(tmp_path / "no\x1b[31m" / "a.json", b"x")
    assert "\x1b" not in refused.value.message
    assert "no\\x1b[31m" in refused.value.message
    with pytest.raises(InputError, match="null character"):
        write_file(tmp_path / "a\0b", b"x")
