"""What `solve` refuses is refused by `check`, with file, line and field; the other files of a run are solved."""

import re

import pytest

from babbitt import solving
from babbitt.case import CaseError, parse_case, template
from babbitt.case.loading import located
from babbitt.core.notices import InputError
from babbitt.solving import refusal_of


def unbalanced() -> str:
    """A thrust bearing on pivots so far inside that no tilt balances its pads."""
    return template("thrust").replace("radius: 290 mm, fraction: 0.60}   #", "radius: 250 mm, fraction: 0.60}   #")


def test_pads_that_do_not_balance_are_refused_by_check(run, tmp_path):
    text = unbalanced()
    (tmp_path / "leaning.yaml").write_text(text)
    (tmp_path / "sound.yaml").write_text(template("hydrostatic_pad"))
    line = text.splitlines().index(next(one for one in text.splitlines() if one.startswith("  pivot:"))) + 1
    status, out, err = run("check", "leaning.yaml", "sound.yaml")
    assert status == 2
    assert err.startswith(f"leaning.yaml:{line}: pads.pivot.radius: ")
    assert "sound.yaml: usable" in out


FIT = "tolerance class 'H99' is not included"
FITTED = ("screw_heel", "jacking_pocket", "hydrostatic_journal", "tilting_pad_journal", "journal")


def ill_fitted(kind: str) -> str:
    """The template of a kind with a fit that there is not for its clearance."""
    text, changed = re.subn(r"(?m)^( *)clearance:.*(?:\n\1 +.*)*", r"\1clearance: H99/e8", template(kind))
    assert changed == 1
    return text


def refusals_of(text: str) -> list[tuple[str, str]]:
    with pytest.raises(CaseError) as refused:
        parse_case(text)
    assert all(problem.line > 0 for problem in refused.value.problems)
    return [(problem.field, problem.message.split(";")[0]) for problem in refused.value.problems]


@pytest.mark.parametrize("kind", FITTED)
def test_a_tolerance_class_that_there_is_not_is_told_once_at_its_clearance(kind):
    """Footsteps and jacking pockets told it without file and line; tilting pads at their extent, too."""
    field = "pads.clearance" if kind == "tilting_pad_journal" else "clearance"
    assert refusals_of(ill_fitted(kind)) == [(field, FIT)]


def test_what_a_rule_meets_as_refused_is_told_at_the_field_of_its_own_rule():
    """A tilt asks whether the journal touches at the edges, for which the clearance is wanted."""
    fields = "misalignment: {x: 100 urad, y: 0}\ngrooves: [{angle: 90 deg, extent: 20 deg}]"
    assert refusals_of(re.sub(r"(?m)^method:.*(?:\n +.*)*", f"method: film\n{fields}", ill_fitted("journal"))) == [
        ("clearance", FIT)
    ]


def test_the_other_files_of_a_run_are_solved(run, tmp_path, monkeypatch):
    """A refusal that shows only when a case is solved ends that file, not the run."""
    solve = solving.solve

    def refusing(case, *given):
        if case.name == "Closed":
            raise InputError("E101", "load is beyond reach")
        return solve(case, *given)

    monkeypatch.setattr(solving, "solve", refusing)
    sound = template("hydrostatic_pad")
    (tmp_path / "closed.yaml").write_text(sound.replace("name: Round pad", "name: Closed"))
    (tmp_path / "sound.yaml").write_text(sound)
    (tmp_path / "made").mkdir()
    status, out, err = run("solve", "closed.yaml", "sound.yaml", "--json", "made")
    assert status == 2
    assert err.startswith("closed.yaml:")
    assert "load is beyond reach" in err
    assert "Round pad" in out
    assert [path.name for path in (tmp_path / "made").iterdir()] == ["sound.json"]


@pytest.mark.parametrize(
    ("message", "field"),
    [
        ("side_flow is 3; it must be less.", ""),
        ("diameter is 3; it must be less.", "diameter"),
        ("the load is too large for the supply_pressure", ""),
        ("nothing fits: see load_angle", "load_angle"),
        ("the diameter is wrong", ""),
    ],
)
def test_a_refusal_is_told_at_the_field_that_it_names(message, field):
    text = template("journal")
    problem = located(InputError("E101", message), parse_case(text), "a.yaml").problems[0]
    assert (problem.file, problem.field, problem.code) == ("a.yaml", field, "E101")
    lines = [number for number, line in enumerate(text.splitlines(), 1) if field and line.startswith(f"{field}:")]
    assert problem.line == (lines[0] if lines else problem.line)


@pytest.mark.parametrize(
    "kind",
    ["journal", "machine", "shaft", "overhung_coupling", "screw_heel", "thrust", "jacking_pocket"],
)
def test_templates_are_refused_by_no_one(kind):
    assert refusal_of(parse_case(template(kind))) is None
