"""From a duty to proposals: each keeps its limits, the order is that of the criterion."""

from __future__ import annotations

import math

import pytest

import babbitt as bb
from babbitt import parse_case
from babbitt.core.check_text import distance, margin
from babbitt.core.limited_flow import limited
from babbitt.core.notices import Effect, InputError
from babbitt.core.quantities import displayed_in
from babbitt.core.result import Verdict
from babbitt.report.design_figure import design_figures
from babbitt.solving import solve
from babbitt.study.best_designs import texts_of_best
from babbitt.study.design import designs_of
from babbitt.study.study import open_study

DUTY = ("--diameter", "120 mm", "--load", "12 kN", "--speed", "2000 rpm")
OILS = ("ISO VG 22", "ISO VG 46")


def proposed(**changes):
    given = {"diameter": 0.12, "load": 12e3, "speed": "2000 rpm", "lubricants": OILS, "fits": ("H7/d8",)}
    return bb.design_bearing(**{**given, **changes})


@pytest.fixture(scope="module")
def found():
    return proposed(proposals=2)


def test_every_proposal_keeps_its_limits_when_it_is_solved_again_by_either_method(found):
    assert {one.fields["lubricant"] for one, _ in found.answer.proposals} == set(OILS)
    for one, again in found.answer.proposals:
        bearing = found.case(one.row)
        for design, method in ((one, "iso7902"), (again, "film")):
            results = bearing.solve(method=method).results
            assert len(results) == 3  # smallest, mean and largest clearance
            assert all(result.within_limits for result in results)
            assert min(result.governing_check.margin for result in results) == pytest.approx(
                design.margin, abs=1e-6
            )
        for quantity, ranked in (("friction_power", one.power), ("total_flow", one.flow)):
            held = [
                result.values.get(limited(quantity), result.values[quantity]) for result in bearing.solve().results
            ]
            assert max(held) == pytest.approx(ranked, rel=1e-9)


def test_margins_of_temperatures_are_in_kelvin(found):
    said = found.summary()
    (one, _), *_ = found.answer.proposals
    for method in ("iso7902", "film"):
        results = found.case(one.row).solve(method=method).results
        worst = min((result.governing_check for result in results), key=lambda check: check.margin)
        assert f"{margin(worst)} ({worst.code}) by {method}" in said
        assert f"{distance(worst.margin, worst.gap if worst.is_in_kelvin else math.nan, 1)} {worst.code}" in said
    assert " K (C104) by " in said


def test_proposals_have_the_reserve_and_follow_by_the_criterion(found):
    proposals = [one for one, _ in found.answer.proposals]
    assert all(one.margin >= 0.1 for one in proposals)
    order = [
        (bool(by_film.remarks), one.verdict != "pass", len(one.departures), one.short, one.power)
        for one, by_film in found.answer.proposals
    ]
    assert order == sorted(order)
    for best in proposals:
        rivals = [one for one in found.answer.tried if one.fields["lubricant"] == best.fields["lubricant"]]
        rivals = [one for one in rivals if one.verdict == best.verdict and one.margin >= 0.1]
        rivals = [one for one in rivals if len(one.departures) <= len(best.departures) and one.short <= best.short]
        assert all(one.power >= best.power for one in rivals)


def test_the_feed_gives_what_the_film_wants_at_the_smallest_clearance_too():
    study = proposed(lubricants=("ISO VG 32",), fits=("H7/c8",), proposals=1)
    ((one, _),) = study.answer.proposals
    assert any("C117" in other.departures for other in study.answer.tried)  # others do not, and need less power
    for result in study.case(one.row).solve().results:
        assert result.supply_capacity >= result.side_flow
        assert not {"W190", "W196", "W123"} & {warning.code for warning in result.warnings}


def test_the_usual_distance_from_mixed_friction_rules_out_thin_oils_where_others_keep_it():
    study = proposed(lubricants=("ISO VG 10", "ISO VG 32"), fits=("H7/c8",), proposals=2)
    (first, _), (second, _) = study.answer.proposals
    assert (first.fields["lubricant"], second.fields["lubricant"]) == ("ISO VG 32", "ISO VG 10")
    assert second.power < first.power
    assert "n/n_tr" in second.departures
    assert "n/n_tr" not in first.departures
    speed = 2000.0 * math.pi / 30.0
    slowest = max(result.transition_speed for result in study.case(first.row).solve().results)
    assert (
        speed / slowest
        >= speed * 0.06
        > max(3.0, speed / max(result.transition_speed for result in study.case(second.row).solve().results))
    )


def test_the_texts_of_the_proposals_are_the_cases_that_were_computed(found):
    texts = texts_of_best(found._study)
    assert list(texts) == ["proposal-1", "proposal-2"]
    for text, (one, _) in zip(texts.values(), found.answer.proposals, strict=True):
        results = solve(parse_case(text)).results
        assert [result.minimum_film_thickness for result in results] == pytest.approx(
            [line["minimum_film_thickness"] for line in one.lines], rel=1e-9
        )


def test_what_passes_with_remarks_is_shown_with_their_codes_and_its_file_passes_so(run, tmp_path):
    duty = ("--diameter", "200 mm", "--load", "40 kN", "--speed", "6000 rpm", "--lubricant", "ISO VG 32")
    status, out, _ = run("design", *duty, "--fit", "H7/c8", "--proposals", 1, "--workers", 1, "--out-dir", "t",
                         "--name", "Turbine, exciter end")  # fmt: skip
    assert status == 0
    case = bb.load_case("t/proposal-1.yaml")
    assert case.name == "Turbine, exciter end"
    codes = {
        warning.code
        for result in case.solve().results
        if result.verdict is Verdict.REMARKS
        for warning in result.warnings
        if warning.effect is Effect.QUESTIONS_RESULT
    }
    assert codes
    heads = (tmp_path / "t" / "proposal-1.yaml").read_text()
    assert f"pass with remarks {', '.join(sorted(codes))}" in heads
    assert f"no. 1 passes with remarks ({', '.join(sorted(codes))})" in out


def test_a_best_at_the_end_of_what_was_tried_is_said_with_what_sets_the_end(found):
    said = "the narrowest width that was tried (B/D of 0.4 to 1"
    for study, at_the_end in ((found, True), (proposed(load=30e3, lubricants=OILS[1:], proposals=1), False)):
        widths = [one.fields["width"] for one, _ in study.answer.proposals]
        narrowest = min(one.fields["width"] for one in study.answer.tried)
        assert (narrowest in widths) == at_the_end
        assert (said in study.summary()) == at_the_end


def test_a_diameter_in_inches_gives_widths_and_pockets_in_inches_and_us_units_head_the_table(run, tmp_path):
    duty = ("--diameter", "4 in", "--load", "2500 lbf", "--speed", "1800 rpm", "--lubricant", "ISO VG 32")
    status, out, _ = run("design", *duty, "--fit", "H7/d8", "--proposals", 1, "--workers", 1, "--units", "us",
                         "--out-dir", "gear")  # fmt: skip
    assert status == 0
    case = bb.load_case("gear/proposal-1.yaml")
    assert (case.width / 0.0254) % 0.25 == pytest.approx(0.0, abs=1e-9)
    assert case.supply_element.width <= 0.7 * case.width
    assert (case.supply_element.width / 0.0254) % 0.0625 == pytest.approx(0.0, abs=1e-9)
    heads = out[out.index("Proposals") :][:1500]
    for unit in ("psi", "mil", "°F", "hp", "gpm"):
        assert unit in heads
    assert "µm" not in heads
    assert "psi" in (tmp_path / "gear" / "proposal-1.yaml").read_text().partition("kind:")[0]


def test_the_figure_has_the_power_in_the_unit_of_its_axis(found):
    (proposal, _), *_ = found.answer.proposals
    for system, unit, watts in (("si", "kW", 1e3), ("us", "hp", 745.6998716)):
        with displayed_in(system):
            ((_, _, figure),) = design_figures(found._study)
        (panel,) = figure.axes
        assert panel.get_xlabel() == f"friction power in {unit}"
        rings = [line.get_xdata()[0] for line in panel.get_lines() if line.get_markersize() == 8.0]
        assert rings[0] == pytest.approx(proposal.power / watts, rel=1e-6)


def test_an_oil_is_given_the_same_design_whatever_others_are_offered(found):
    alone = proposed(lubricants=OILS[:1], proposals=1).answer.proposals[0][0]
    among = next(one for one, _ in found.answer.proposals if one.fields["lubricant"] == OILS[0])
    assert (alone.fields, alone.margin, alone.power) == (among.fields, among.margin, among.power)


def test_widths_and_pockets_go_together(found):
    for one in found.answer.tried:
        feed, width = one.fields["supply_element"], 1e3 * one.fields["width"]
        assert width % 5.0 == pytest.approx(0.0, abs=1e-9) or width % 5.0 == pytest.approx(5.0, abs=1e-9)
        assert 0.4 <= one.fields["width"] / 0.12 <= 1.0
        assert "hole" in feed or f"{math.floor(0.7 * width + 1e-9)} mm" in feed


def test_the_fits_are_those_next_to_the_recommended_clearance():
    case = bb.parse_case(bb.template("journal"))
    from babbitt.kinds.journal.study.first_design import choices

    fits = choices(case, {})["clearance"].values
    wanted = 0.8e-3 * (0.06 * 2000.0 * math.pi / 30.0) ** 0.25
    means = [case.solve(clearance=fit).relative_clearance for fit in fits]
    assert means == sorted(means)
    assert max(abs(math.log(mean / wanted)) for mean in means) < abs(
        math.log(case.solve(clearance="H7/e8").relative_clearance / wanted)
    )


def test_large_bearings_without_a_fit_get_the_recommended_clearance():
    (one, _), *_ = proposed(
        diameter=1.2, load=500e3, speed="300 rpm", lubricants=("ISO VG 46",), fits=(), proposals=1
    ).answer.proposals
    wanted = 0.8e-3 * (0.6 * 300.0 * math.pi / 30.0) ** 0.25
    assert one.values["relative_clearance"] == pytest.approx(wanted, rel=3e-3)


def test_what_cannot_be_kept_is_told_with_the_nearest_miss():
    study = proposed(load=250e3, lubricants=("ISO VG 68",))
    answer = study.answer
    assert not answer.proposals
    assert answer.nearest[0].margin == max(one.margin for one in answer.tried if math.isfinite(one.margin))
    assert answer.nearest[0].margin < 0.0
    text = study.summary()
    assert "the nearest misses" in text
    assert answer.nearest[0].code in text
    # The specific load alone ends it: 250 kN on 120 x 120 mm are more than the 5 MPa of the metal.
    assert answer.nearest[0].margin <= 1.0 - 250e3 / (0.12 * 0.12) / 5e6 + 1e-9


def test_assumptions_and_rules_are_named(found):
    text = found.summary()
    for said in ("supply temperature 45 degC", "Vogelpohl", "of Q₃", "(assumption", "Ranked:", "SnSb8Cu4"):
        assert said in text
    stated = bb.design_bearing(
        "120 mm", "12 kN", "2000 rpm", lubricants=OILS[:1], fits=("H7/d8",), proposals=1,
        supply_temperature="40 degC", supply_pressure="0.3 MPa", metal="B83",
    )  # fmt: skip
    assert "Not given and assumed: shell of C10" in stated.summary()


def test_the_command_proposes_writes_and_reports(run, tmp_path):
    options = ["--lubricant", "ISO VG 32", "--fit", "H7/d8", "--proposals", 1, "--workers", 1]
    status, out, err = run(
        "design", *DUTY, *options, "--out", "fan.study", "--out-dir", "fan",
        "--report", "fan.html", "--plots", "p", "--xlsx", "fan.xlsx",
    )  # fmt: skip
    assert (status, err) == (0, "")
    assert "Proposals" in out
    assert (tmp_path / "p" / "designs.svg").is_file()
    assert (tmp_path / "fan.xlsx").is_file()
    assert "Proposals" in (tmp_path / "fan.html").read_text()
    status, _, _ = run("solve", "fan/proposal-1.yaml", "--strict")
    assert status == 0
    assert run("study", "show", "fan.study")[1].strip() in out
    ((one, _),) = designs_of(open_study("fan.study")).proposals
    assert bb.load_case("fan/proposal-1.yaml").width == one.fields["width"]

    proposal, own = tmp_path / "fan" / "proposal-1.yaml", tmp_path / "fan" / "proposal-10-final.yaml"
    written = proposal.read_bytes()
    (tmp_path / "fan" / "proposal-7.yaml").write_bytes(written)  # as an earlier run with more proposals left it
    own.write_text("mine")
    assert run("design", *DUTY, *options, "--out-dir", "fan")[0] == 0
    assert proposal.read_bytes() == written
    assert [path.name for path in sorted((tmp_path / "fan").iterdir())] == [proposal.name, own.name]
    for stored in (proposal, tmp_path / "fan.study" / "designs" / "proposal-1.yaml"):
        stored.write_bytes(written.replace(b"12 kN\n", b"13 kN\n"))
    for where in ("--out-dir", "fan"), ("--out", "fan.study"):
        status, out, err = run("design", *DUTY, *options, *where)
        assert (status, out) == (2, "")
        assert f"proposal-1.yaml there was edited or is no output of Babbitt; nothing was written. Name another folder for {where[0]}" in err  # fmt: skip # noqa: E501
    assert "13 kN" in proposal.read_text()


@pytest.mark.parametrize("option", ["--out-dir", "--plots"])
def test_a_file_where_a_folder_is_named_is_refused_before_anything_is_computed(run, tmp_path, option):
    (tmp_path / "taken").write_text("mine")
    status, out, err = run("design", *DUTY, option, "taken")
    assert (status, out) == (2, "")
    assert f"cannot write taken: it is a file; {option} names a folder" in err
    status, out, err = run("design", *DUTY, option, "taken/sub")
    assert (status, out) == (2, "")
    assert f"cannot write taken/sub: taken is a file; {option} names a folder" in err


def test_a_design_is_a_study_of_a_case(run, tmp_path):
    case = {
        "kind": "journal", "name": "Duty", "diameter": "120 mm", "width": "60 mm",
        "clearance": {"kind": "relative", "mean": "1.2 permille"},
        "span": "360 deg", "supply_element": {"kind": "hole", "diameter": "12 mm", "place": "opposite"},
        "lubricant": "ISO VG 32", "supply": {"temperature": "45 degC", "pressure": "0.2 MPa"},
        "materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "42CrMo4"},
        "load": "12 kN", "speed": "2000 rpm",
        "study": {"kind": "design", "proposals": 1,
                  "vary": {"lubricant": ["ISO VG 32"], "clearance": ["H7/d8"], "width": ["60 mm", "80 mm"]}},
    }  # fmt: skip
    import yaml

    (tmp_path / "duty.yaml").write_text(yaml.safe_dump(case))
    status, out, _ = run("study", "duty.yaml", "--out", "d.study", "--workers", 1)
    assert status == 0
    assert "stated in the study" in out
    assert [path.name for path in (tmp_path / "d.study" / "designs").iterdir()] == ["proposal-1.yaml"]
    ((one, _),) = designs_of(open_study("d.study")).proposals
    assert one.fields["width"] in (0.06, 0.08)


BAD = {
    "no unit": (("--load", "12"), "load: 12 has no unit"),
    "no quantity": (("--speed", "fast"), "speed"),
    "beyond the field": (("--diameter", "30 m"), "diameter"),
    "no such oil": (("--lubricant", "ISO VG 47"), "ISO VG 46"),
    "no such fit": (("--fit", "H7/z9"), "z9"),
    "no such metal": (("--metal", "Unobtainium"), "Unobtainium"),
    "no rules": (("--kind", "hydrostatic_pad"), "allowed: journal"),
    "no kind": (("--kind", "jurnal"), "allowed: journal"),
    "reserve": (("--reserve", "200 %"), "allowed: 0 to 100 %"),
    "report": (("--report", "a.txt"), "ends in .pdf or .html"),
}


@pytest.mark.parametrize("what", BAD)
def test_bad_input_is_one_clear_line(run, tmp_path, what):
    changes, says = BAD[what]
    status, out, err = run("design", *DUTY, *changes, "--out-dir", "fan")
    assert (status, out) == (2, "")
    line, code = err.strip().splitlines()
    assert says in line
    assert code.startswith("(E00")
    assert not list(tmp_path.iterdir())


def test_kinds_without_rules_are_refused_in_a_study():
    case = bb.parse_case(bb.template("hydrostatic_pad"))
    with pytest.raises(
        InputError, match="no rules for a first design of kind 'hydrostatic_pad'; allowed: journal"
    ):
        case.study("design")
