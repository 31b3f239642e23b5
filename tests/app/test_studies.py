"""Studies of the page are those of the command, and what hinders one is said."""

from dataclasses import replace

import pytest
import yaml

from babbitt.app.answer import read, solved
from babbitt.app.document import CaseDocument
from babbitt.app.progress import FileWatch, Progress, followed, progress_in
from babbitt.app.studies import (
    Axis,
    asked_text,
    axes_of,
    block_of,
    first_axis,
    kinds_of,
    replaces_fit,
    sizes_of,
    studied,
    study_file,
    with_value,
)
from babbitt.case import parse_case
from babbitt.case.with_units import case_text
from babbitt.core.kind import kinds
from babbitt.core.result import Verdict
from babbitt.core.units import KINDS
from babbitt.report.study_content import study_tables
from babbitt.study.fields import annotations_of, numeric_field
from babbitt.study.plan import plan
from babbitt.study.size import size_of
from babbitt.study.study import run_study

TEMPLATES = {name: kind.read_template() for name, kind in kinds().items()}
LOADS = Axis("load", "8 kN", "16 kN", 3)


def asked(block, kind="journal"):
    return asked_text(CaseDocument(TEMPLATES[kind]).given, block)


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    """A sweep of the load, and where its progress stands."""
    file = str(tmp_path_factory.mktemp("sweep") / "progress")
    return studied(asked(block_of("sweep", [LOADS])), file), file


def test_a_sweep_is_that_of_the_command(sweep):
    text, (found, file) = asked(block_of("sweep", [LOADS])), sweep
    case = parse_case(text)
    study = run_study(plan(case, case.study_block))
    assert found.faults == ()
    assert [table.rows for table in found.tables] == [one.rows for one in study_tables(study)]
    assert len(found.tables[0].heads) == len(found.tables[0].rows[0])
    assert [figure.name for figure in found.figures] == ["sweep"]
    assert progress_in(file) == Progress(3, 3)
    film = found.study.columns["minimum_film_thickness"]
    assert (film[1:] < film[:-1]).all()  # more load, thinner film


def test_a_clearance_is_sought_where_the_case_has_a_fit(tmp_path):
    """What a designer asks first: at the smallest clearance a limit is met, and below it no longer."""
    axis = axes_of(CaseDocument(TEMPLATES["journal"]), "size")["clearance.mean"]
    text = asked(block_of("size", [Axis(axis.path, "0.6 permille", "3 permille", 5)]))
    found = studied(text, str(tmp_path / "progress"))
    assert found.faults == ()
    (interval,) = size_of(found.study).intervals
    assert 0.6e-3 < interval.lower.value < interval.upper.value
    assert interval.lower.permitted
    assert interval.lower.margin == pytest.approx(0.0, abs=2e-3)
    assert not interval.below.permitted


@pytest.mark.parametrize("kind", TEMPLATES)
def test_fields_on_offer_are_those_that_studies_take(kind):
    """Every number on offer has a unit of its field, and every kind of study has fields enough."""
    document = CaseDocument(TEMPLATES[kind])
    case = read(TEMPLATES[kind])
    assert {"sweep", "size", "tolerance", "map", "corners"} <= set(kinds_of(document.given))
    known = axes_of(document, "sweep")
    assert len(known) >= 2
    for axis in known.values():
        if axis.choices or axis.path == "clearance.mean":
            continue
        form, quantity = numeric_field(annotations_of(case, axis.path))
        assert form == "quantity", axis.path
        if quantity.kind is not KINDS["1"]:
            low, high = (one.partition(" ")[::2] for one in (axis.first, axis.last))
            assert float(low[0]) < float(high[0])
            assert low[1] in quantity.kind.everyday, axis


def test_ranges_are_in_the_units_of_the_page():
    """Where the page shows US units; values that a study finds are then offered in these, too."""
    document = CaseDocument(TEMPLATES["journal"])
    metric, inches = (axes_of(document, "size", system)["diameter"] for system in ("si", "us"))
    (low, unit), (first, mm) = (one.first.split() for one in (inches, metric))
    assert (unit, mm) == ("in", "mm")
    assert 25.4 * float(low) == pytest.approx(float(first), rel=1e-5)
    assert axes_of(document, "size", "us")["load"].first.endswith(" lbf")


def test_a_study_begins_with_the_load():
    document = CaseDocument(TEMPLATES["journal"])
    assert first_axis(document.given, axes_of(document, "sweep")) == "load"


def test_a_study_of_the_case_comes_first():
    document = CaseDocument(asked(block_of("corners", [])))
    assert kinds_of(document.given)[0] == "own"
    assert kinds_of(CaseDocument("").given) == ("sweep", "size", "tolerance", "map", "corners")


def test_tolerances_take_the_fit_and_the_grade():
    axes = axes_of(CaseDocument(TEMPLATES["journal"]), "tolerance")
    load = Axis("load", "1 kN", "3 kN", law="triangular")
    block = block_of("tolerance", [axes["clearance"], axes["lubricant"], load], 20)
    assert block["vary"] == {
        "clearance": {"fit": "H7/d8"},
        "lubricant": {"scatter": "vg"},
        "load": {"triangular": ["1 kN", "2 kN", "3 kN"]},
    }
    assert read(asked(block)).study_block.samples == 20


@pytest.mark.parametrize(
    ("axis", "says"),
    [
        (Axis("load", "8 kg", "16 kN"), "study.vary.load"),
        (Axis("load", "", "16 kN"), "study.vary.load"),
        (Axis("colour", "1", "2"), "'colour' is no field"),
        (Axis("load", "8 kN", "16 kN", 10**6), "study.vary.load"),
    ],
)
def test_what_hinders_a_study_is_said(axis, says, tmp_path):
    found = studied(asked(block_of("sweep", [axis])), str(tmp_path / "progress"))
    assert found.study is None
    assert any(says in f"{fault.field}: {fault.message}" for fault in found.faults), found.faults


def test_a_study_names_no_files(tmp_path):
    """Neither a table of rows nor samples of a field are read from the machine of the server."""
    (tmp_path / "rows.csv").write_text("load [kN]\n1\n2\n")
    for block in (
        {"kind": "table", "rows": str(tmp_path / "rows.csv")},
        {"kind": "tolerance", "samples": 10, "vary": {"load": {"table": str(tmp_path / "rows.csv")}}},
    ):
        found = studied(asked(block), str(tmp_path / "progress"))
        assert found.study is None
        assert any("no files" in fault.message for fault in found.faults), found.faults


def test_files_of_a_study(sweep):
    study = sweep[0].study
    csv = study_file(study, ".csv").decode().splitlines()
    assert len(csv) == 4
    assert study_file(study, ".xlsx").startswith(b"PK")


def test_progress_is_read_while_it_is_written(tmp_path):
    file = str(tmp_path / "progress")
    assert progress_in(file) == Progress()
    watch = FileWatch(file)
    watch.begins(10)
    watch.advances(4, 1)
    assert progress_in(file) == Progress(4, 10, 1)
    assert progress_in(file).share == pytest.approx(0.4)
    seen = []
    for item in followed("ab", file):
        seen.append((item, progress_in(file).done))
    assert seen == [("a", 0), ("b", 1)]
    assert progress_in(file).share == 1.0


def test_the_sizes_that_a_study_found_keep_all_limits(tmp_path):
    """The ends of the clearance that the page offers, and the best within, pass; below the lower end one fails."""
    document = CaseDocument(TEMPLATES["journal"])
    axis = replace(axes_of(document, "size")["clearance.mean"], points=5)
    found = studied(asked_text(document.given, block_of("size", [axis])), str(tmp_path / "progress"))
    sizes = sizes_of(found.study)
    assert 2 <= len(sizes) <= 3
    for text in sizes:
        (result,) = solved(case_text(with_value(document.given, axis.path, text))).results
        assert all(check.ok for check in result.limits), text
    lower = min(float(text.split()[0]) for text in sizes)
    (result,) = solved(case_text(with_value(document.given, axis.path, f"{0.99 * lower} permille"))).results
    assert not all(check.ok for check in result.limits)


def test_the_size_says_how_its_scan_steps_and_offers_a_value_without_remarks(tmp_path):
    """A wide range at equal distances; its end passes with the largest margin, and with remarks."""
    document = CaseDocument(TEMPLATES["journal"])
    axis = replace(axes_of(document, "size")["clearance.mean"], first="0.5 permille", last="12 permille")
    found = studied(asked_text(document.given, block_of("size", [axis])), str(tmp_path / "progress"))
    assert any("at equal distances" in note for table in found.tables for note in table.remarks)
    roles = {role: text for text, said in sizes_of(found.study).items() for role in said.split(", ")}
    text = roles["largest margin without remarks"]
    assert text != roles["largest margin"]
    offered = next(said for said in sizes_of(found.study).values() if "largest margin" in said.split(", "))
    assert offered.endswith("with remarks")
    (result,) = solved(case_text(with_value(document.given, axis.path, text))).results
    assert result.verdict is Verdict.PASS


def test_sizes_are_offered_only_in_the_unit_in_which_they_were_asked_for(tmp_path):
    """A case with a size of its own may list plain numbers; then nothing says how a case file would have them."""
    given = CaseDocument(TEMPLATES["journal"]).given
    listed = {"kind": "size", "vary": {"load": ["6 kN", "12 kN", "20 kN"]}}
    found = studied(asked_text(given, listed), str(tmp_path / "progress"))
    assert sizes_of(found.study) is None
    assert any("at uneven steps" in note for table in found.tables for note in table.remarks)


def test_a_number_takes_the_place_of_a_fit_and_says_so():
    fit, number = {"clearance": "H7/d8"}, {"clearance": {"kind": "relative", "mean": "1.5 permille"}}
    assert replaces_fit(fit, "clearance.mean")
    assert not replaces_fit(fit, "load")
    assert not replaces_fit(number, "clearance.mean")


def test_a_study_of_a_fit_begins_with_its_mean_clearance():
    document = CaseDocument(TEMPLATES["journal"])
    axis = axes_of(document, "size")["clearance.mean"]
    asked = yaml.safe_load(asked_text(document.given, block_of("size", [axis])))["clearance"]
    (result,) = solved(TEMPLATES["journal"]).results
    assert asked["kind"] == "relative"
    assert float(asked["mean"].split()[0]) == pytest.approx(1e3 * result.values["relative_clearance"], rel=1e-5)
