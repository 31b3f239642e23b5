"""The pages hold together: links lead somewhere, drawings are sound, generated Markdown says what it should."""

from __future__ import annotations

import doctest
import re
import tomllib
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from babbitt_pages import case_file, command_line, drawings, markdown
from babbitt_pages.files import write
from babbitt_pages.markdown import table, text
from babbitt_pages.svg import polar
from example_blocks import DOCS, ROOT, pages

from babbitt.validation import cases

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_links_between_files_lead_somewhere(page: Path) -> None:
    for target in LINK.findall(page.read_text(encoding="utf-8")):
        if re.match(r"https?://|#", target):
            continue
        path = target.split("#")[0]
        if "_generated/" in path:
            name = Path(path).stem
            assert name in {case.name for case in cases()}, f"{page.name}: {target}"
            continue
        assert (page.parent / path).exists(), f"{page.name}: {target}"


def test_links_of_the_package_page_are_absolute() -> None:
    """What an index shows of README has no repository around it."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    hook = project["tool"]["hatch"]["metadata"]["hooks"]["fancy-pypi-readme"]
    assert "readme" in project["project"]["dynamic"]
    shown = "".join((ROOT / one["path"]).read_text(encoding="utf-8") for one in hook["fragments"])
    assert LINK.search(shown)
    for one in hook["substitutions"]:
        shown, count = re.subn(one["pattern"], one["replacement"], shown)
        assert count, f"{one['pattern']} matches nothing"
    assert all(target.startswith("https://") for target in LINK.findall(shown))
    assert "Two pages of the report" not in shown
    assert "how to choose" in shown


def test_every_page_is_reached_from_a_tree() -> None:
    trees = re.compile(r"```\{toctree\}\n(.*?)```", re.DOTALL)
    reached = {"index"}
    for page in DOCS.rglob("*.md"):
        folder = page.parent
        for tree in trees.findall(page.read_text(encoding="utf-8")):
            entries = [line.strip() for line in tree.splitlines() if line.strip() and not line.startswith(":")]
            reached |= {str((folder / entry).resolve().relative_to(DOCS)) for entry in entries if entry[0] != "/"}
    written = {str(page.relative_to(DOCS).with_suffix("")) for page in pages() if page.is_relative_to(DOCS)}
    assert written == reached


@pytest.mark.parametrize("name", drawings.DRAWINGS)
def test_drawings_are_sound_and_stay_on_the_sheet(name: str) -> None:
    root = ElementTree.fromstring(drawings.DRAWINGS[name]())
    width, height = float(root.attrib["width"]), float(root.attrib["height"])
    assert root.find(f"{SVG}title") is not None
    for line in root.iter(f"{SVG}polyline"):
        for point in line.attrib["points"].split():
            x, y = map(float, point.split(","))
            assert 0.0 <= x <= width
            assert 0.0 <= y <= height
    for word in root.iter(f"{SVG}text"):
        assert 0.0 <= float(word.attrib["x"]) <= width
        assert 8.0 <= float(word.attrib["y"]) <= height


def test_the_frame_has_the_attitude_angle_downstream_of_the_load() -> None:
    """Counter-clockwise rotation and a load downward bring the journal to the right and down."""
    root = ElementTree.fromstring(drawings.frame())
    circles = [
        (float(c.attrib["cx"]), float(c.attrib["cy"]), float(c.attrib["r"])) for c in root.iter(f"{SVG}circle")
    ]
    journal = next(circle for circle in circles if 100.0 < circle[2] < 140.0)
    bearing = next(circle for circle in circles if circle[2] == 150.0)
    assert journal[0] > bearing[0]
    assert journal[1] > bearing[1]  # y of SVG points down
    assert polar((0.0, 0.0), 2.0, -90.0) == pytest.approx((0.0, -2.0))


def test_markdown_does_not_take_words_for_markup() -> None:
    assert text("Q_3* < [1] | $x$ `a_b`") == r"Q\_3\* &lt; \[1\] \| \$x\$ `a_b`"
    assert table(["a"], [["x\ny"]]).splitlines()[-1] == "| x y |"


def test_examples_in_the_generators_run() -> None:
    found = doctest.testmod(markdown)
    assert found.attempted > 0
    assert found.failed == 0


def test_generated_tables_have_equal_rows() -> None:
    for page in (case_file.page(), command_line.page()):
        for block in re.findall(r"(?:^\|.*\n)+", page, re.MULTILINE):
            counts = {len(re.findall(r"(?<!\\)\|", line)) for line in block.splitlines()}
            assert len(counts) == 1, block


def test_case_reference_shows_units_ranges_and_defaults_as_an_engineer_writes_them() -> None:
    lines = case_file.page().splitlines()
    diameter = next(line for line in lines if line.startswith("| `diameter` | length"))
    assert "1 mm to 3 m" in diameter
    assert "**required**" in diameter
    load_angle = next(line for line in lines if line.startswith("| `load_angle` |"))
    assert "`-90 deg`" in load_angle


def test_links_inside_the_case_reference_lead_to_its_sections() -> None:
    page = case_file.page()
    targets = set(re.findall(r"^\((case-[a-z0-9]+)\)=$", page, re.MULTILINE))
    assert set(re.findall(r"\]\(#(case-[a-z0-9]+)\)", page)) <= targets


def test_files_are_written_only_when_new(tmp_path: Path) -> None:
    file = tmp_path / "new" / "page.md"
    write(file, "one")
    before = file.stat().st_mtime_ns
    write(file, "one")
    assert file.stat().st_mtime_ns == before
    write(file, "two")
    assert file.read_text() == "two"


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_files_that_a_page_names_exist(page: Path) -> None:
    named = re.findall(r"`((?:benchmarks|docs|examples|scripts|src|validation)/[^`\s]*)`", page.read_text("utf-8"))
    for path in named:
        assert any(ROOT.glob(path)) or "_build" in path, f"{page.name} names {path}"


def test_no_page_tells_of_places_that_a_reader_has_not() -> None:
    for page in pages():
        assert not re.search(r"/work/|/tmp/|/home/", page.read_text(encoding="utf-8")), page.name
