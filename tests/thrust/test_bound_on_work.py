"""Every thrust case ends after a bounded number of films, in a status or a warning that says so."""

import pytest

import babbitt.kinds.shaft_line.check
import babbitt.kinds.thrust.check
from babbitt.case import parse_case, template
from babbitt.core.result import Outcome, Verdict
from babbitt.kinds.thrust.work import WorkBoundError, bounded_work, spend
from babbitt.solving import solve

CHOICE = ("# method:", "method: {kind: film, thermal: adiabatic}\n# method:")
ADIABATIC = template("thrust").replace(*CHOICE)
LINE = template("thrust_line").replace(*CHOICE)


def test_work_is_counted_inside_the_bound_alone():
    spend(1e9)
    with bounded_work(10.0):
        spend(6.0)
        spend(4.0)
        with pytest.raises(WorkBoundError):
            spend(0.1)
    spend(1e9)


@pytest.fixture
def allow(monkeypatch):
    def to(units):
        monkeypatch.setattr(babbitt.kinds.thrust.check, "MOST_WORK", units)
        monkeypatch.setattr(babbitt.kinds.shaft_line.check, "MOST_WORK", units)

    return to


@pytest.mark.parametrize("text", [ADIABATIC, LINE], ids=["bearing", "line"])
def test_a_search_that_uses_up_its_work_says_so(text, allow):
    allow(50)
    (result,) = solve(parse_case(text)).results
    assert result.outcome is Outcome.WORK_BOUND
    assert result.outcome.code == "S009"
    assert result.verdict is Verdict.NO_SOLUTION
    assert "less thrust or a straighter housing" in result.message


def test_a_runout_whose_positions_use_up_the_work_leaves_the_film_at_rest(allow):
    """At rest the example takes about 4000 units; each of its 24 positions more than 1000."""
    allow(6000)
    (result,) = solve(parse_case(ADIABATIC)).results
    assert result.outcome.solved
    warnings = {notice.code: notice.message for notice in result.warnings}
    assert "quasi_static_load_ratio" not in result.values
    assert "again and again" in warnings["W209"]
    assert "C202" not in {check.code for check in result.checks}  # a film that was not found is no film of 0 um
    (not_made,) = (notice.message for notice in result.not_checked if notice.code == "C202")
    assert "again and again" in not_made
    assert result.verdict is Verdict.NO_VERDICT


def test_next_to_no_runout_gives_the_film_without_one():
    """Temperatures that vary across the pads cost most: a search closer than they settle ended without a film."""
    resolved = ADIABATIC.replace("thermal: adiabatic", "thermal: adiabatic, radial_temperature: resolved")
    assert resolved != ADIABATIC
    (result,) = solve(parse_case(resolved.replace("runout: 5 um", "runout: 0.01 um"))).results
    assert "W209" not in {notice.code for notice in result.warnings}
    at_rest, turning = (result.values[f"{of}minimum_film_thickness"] for of in ("", "quasi_static_"))
    assert turning == pytest.approx(at_rest, abs=0.01e-6)


def test_warnings_need_no_work_that_a_runout_has_used_up(monkeypatch):
    """Some ask for one more film, which a runout without an end must not leave them without."""
    monkeypatch.setattr(babbitt.kinds.thrust.check, "_turned", lambda *_: spend(1e12))
    monkeypatch.setattr(babbitt.kinds.thrust.check, "sharing_warnings", lambda *_: spend(1.0) or ())
    (result,) = solve(parse_case(ADIABATIC)).results
    assert result.outcome.solved
    assert "W209" in {notice.code for notice in result.warnings}


@pytest.mark.thorough
def test_ordinary_bearings_stay_far_below_the_bound(allow):
    allow(60_000)
    (result,) = solve(parse_case(ADIABATIC)).results
    assert result.outcome.solved
    assert "W209" not in {notice.code for notice in result.warnings}


def test_sweeps_of_a_line_that_use_up_the_work_leave_its_answer(allow):
    """Pads that lean are solved one by one: 1000 units at rest, 11 000 for what is admissible, 400 for a ring."""
    allow(15_000)
    text = template("thrust_line").replace("kind: point, radius: 290 mm", "kind: line, radius: 290 mm")
    (result,) = solve(parse_case(text)).results
    assert result.outcome.solved
    assert "loss_mean_bound" in result.values
    assert "half_load_ring_stiffness" not in result.values
    (left_out,) = (notice.message for notice in result.warnings if notice.code == "W208")
    assert left_out.endswith("backing rings")
