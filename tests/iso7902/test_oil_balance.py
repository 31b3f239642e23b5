"""Oil balance of a machine: orifice and tube laws, sharing, mass balance, starvation, orifices proposed."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from babbitt.case import CaseError, case_from_dict
from babbitt.case.parts.study import StudyBlock
from babbitt.core.notices import explanations
from babbitt.core.result import Outcome, Verdict
from babbitt.kinds.journal.methods import Iso7902
from babbitt.kinds.journal.oil_balance import network
from babbitt.kinds.journal.oil_balance.model import Line, Pump, orifice_duct
from babbitt.kinds.journal.report.oil_balance import sentences
from babbitt.numerics.roots import Root
from babbitt.properties.lubricants import lubricant
from babbitt.report.totals import totals
from babbitt.solving import solve
from babbitt.study.plan import plan
from babbitt.study.study import run_study

OIL = lubricant("ISO VG 46")
INLET = 323.15
DENSITY, KINEMATIC = OIL.density(INLET), OIL.kinematic_viscosity(INLET)


def bearing(name, **given):
    return {
        "kind": "journal",
        "name": name,
        "diameter": "120 mm",
        "width": "96 mm",
        "clearance": {"kind": "relative", "mean": "1.8 permille"},
        "span": "180 deg",
        "supply_element": {"kind": "groove_180", "width": "60 mm"},
        "load": "12 kN",
        "speed": "3000 rpm",
    } | given


HEAVY = {"diameter": "180 mm", "width": "120 mm", "load": "22 kN", "speed": "1000 rpm"}
PUMP = {"flow": "12 L/min", "relief_pressure": "0.3 MPa"}


def machine(lines, *bearings, pump=PUMP, **given):
    fields = {
        "kind": "machine",
        "name": "Gear",
        "lubricant": "ISO VG 46",
        "supply": {"temperature": "50 degC"},
        "materials": {"bearing_metal": "B83", "bearing": "C10", "journal": "42CrMo4"},
        "oil_system": {"pump": pump, "lines": lines},
        "bearings": list(bearings),
    }
    return case_from_dict(fields | given)


def orifices(**diameters):
    return [{"bearing": name, "orifice_diameter": f"{size} mm"} for name, size in diameters.items()]


def answer(case):
    found = solve(case)
    assert found.solved
    return found


def row(result, name):
    return result.arrays[name][0]


def test_an_orifice_passes_by_the_square_root_law():
    flow = 2e-4
    area = 0.25 * math.pi * 0.004**2
    loss = orifice_duct(0.004, 0.62).pressure_loss(flow, 870.0, 3e-5)
    assert flow == pytest.approx(0.62 * area * math.sqrt(2.0 * loss / 870.0), rel=1e-12)
    assert Line("A", None, None, 0.62).orifice_for(flow, loss, 870.0) == pytest.approx(0.004, rel=1e-12)


def test_a_pump_gives_by_its_curve():
    pump = Pump(((0.0, 1e-3), (1e5, 8e-4), (3e5, 0.0)), 3e5)
    assert pump.delivery(5e4) == pytest.approx(9e-4)
    assert pump.delivery(2e5) == pytest.approx(4e-4)
    assert Pump(((0.0, 1e-3),), 2e5).delivery(1.5e5) == 1e-3


def test_one_bearing_behind_its_orifice():
    result = answer(
        machine(orifices(A=4), bearing("A"), pump={"flow": "5 L/min", "relief_pressure": "0.3 MPa"})
    ).results[0]
    (flow,), (pressure,) = row(result, "line_flow"), row(result, "line_pressure")
    assert flow == pytest.approx(5.0 / 6e4, rel=1e-8)
    area = 0.25 * math.pi * 0.004**2
    assert flow == pytest.approx(
        0.6 * area * math.sqrt(2.0 * (result.header_pressure - pressure) / DENSITY), rel=1e-9
    )
    assert result.relief_flow == 0.0


def test_a_search_that_does_not_end_at_a_balance_is_no_balance(monkeypatch):
    monkeypatch.setattr(network, "find_root", lambda *bracket, **tolerance: Root(1e5, False))
    case = machine(orifices(A=4), bearing("A"), pump={"flow": "5 L/min", "relief_pressure": "0.3 MPa"})
    (system,) = solve(case).results
    assert system.outcome is Outcome.NOT_CONVERGED


def test_the_film_beside_iso7902_is_fed_through_the_line_at_the_pressure_of_the_header():
    (system,) = machine(orifices(A=4), bearing("A")).calculations()
    ((one,), (line,)) = system.problem.calculations, system.problem.system.lines
    design = network.fed(one, line, 0.8e5).solution.problem
    assert (design.oil_supply.pressure, len(design.oil_supply.tubes)) == (0.8e5, 1)
    assert design.fuller_film.oil_supply == design.oil_supply


def test_a_film_that_does_not_tell_what_it_draws_is_not_called_missing(monkeypatch):
    """As full films beside a groove all around, of which only the sum of the flows is known."""
    own = Iso7902.solve

    def without_flow(self, problem):
        (found,) = own(self, problem)
        values = {name: value for name, value in found.result.values.items() if name != "side_flow"}
        return (replace(found, result=replace(found.result, values=values)),)

    monkeypatch.setattr(Iso7902, "solve", without_flow)
    (system, _) = solve(machine(orifices(A=4), bearing("A"))).results
    assert system.outcome is Outcome.NOT_CONVERGED
    assert "does not tell what it draws by its own pressure" in system.failure.message


def test_equal_orifices_to_equal_bearings_share_equally():
    result = answer(machine(orifices(A=4, B=4), bearing("A"), bearing("B"))).results[0]
    assert row(result, "line_share") == pytest.approx((0.5, 0.5), rel=1e-12)
    assert sum(row(result, "line_flow")) == pytest.approx(result.pump_delivery, rel=1e-8)
    assert result.oil_balance_error < 1e-8


def test_a_tube_loses_by_hagen_and_poiseuille():
    tube = {"diameter": "8 mm", "length": "5 m", "loss_coefficient": 0}
    result = answer(
        machine(
            [{"bearing": "A", "tube": tube}], bearing("A"), pump={"flow": "5 L/min", "relief_pressure": "0.3 MPa"}
        )
    ).results[0]
    (flow,), (pressure,) = row(result, "line_flow"), row(result, "line_pressure")
    lost = 128.0 * DENSITY * KINEMATIC * 5.0 * flow / (math.pi * 0.008**4)
    assert result.header_pressure - pressure == pytest.approx(lost, rel=1e-9)
    assert row(result, "line_reynolds_number")[0] == pytest.approx(4.0 * flow / (math.pi * 0.008 * KINEMATIC))
    assert "W601" not in [one.code for one in result.warnings]


def test_two_tubes_in_parallel_are_one_of_twice_the_conductance():
    thin = {"diameter": "8 mm", "length": "5 m", "loss_coefficient": 0, "number": 2}
    wide = {"diameter": f"{8.0 * 2.0**0.25!r} mm", "length": "5 m", "loss_coefficient": 0}
    found = [answer(machine([{"bearing": "A", "tube": tube}], bearing("A"))).results[0] for tube in (thin, wide)]
    assert found[0].header_pressure == pytest.approx(found[1].header_pressure, rel=1e-9)


def test_a_turbulent_tube_is_named():
    tube = {"diameter": "6 mm", "length": "0.1 m"}
    result = answer(
        machine(
            [{"bearing": "A", "tube": tube}],
            bearing("A", **HEAVY),
            pump={"flow": "60 L/min", "relief_pressure": "5 MPa"},
        )
    ).results[0]
    assert row(result, "line_reynolds_number")[0] > 2300.0
    assert "W601" in [one.code for one in result.warnings]


def test_what_the_bearings_do_not_take_returns_over_the_relief_valve():
    result = answer(
        machine(
            orifices(A=3, B=2),
            bearing("A"),
            bearing("B", **HEAVY),
            pump={"flow": "60 L/min", "relief_pressure": "0.2 MPa"},
        )
    ).results[0]
    assert result.header_pressure == pytest.approx(0.2e6)
    assert result.relief_flow + sum(row(result, "line_flow")) == pytest.approx(1e-3, rel=1e-12)


def test_a_falling_curve_is_balanced_on_the_curve():
    curve = [{"pressure": "0 MPa", "flow": "14 L/min"}, {"pressure": "0.4 MPa", "flow": "4 L/min"}]
    result = answer(
        machine(orifices(A=4, B=3), bearing("A"), bearing("B", **HEAVY), pump={"curve": curve})
    ).results[0]
    on_curve = (14.0 - 10.0 * result.header_pressure / 0.4e6) / 6e4
    assert 0.0 < result.header_pressure < 0.4e6
    assert sum(row(result, "line_flow")) == pytest.approx(on_curve, rel=1e-8)


def test_bearings_have_the_results_of_their_pressure():
    found = answer(machine(orifices(A=4, B=3), bearing("A"), bearing("B", **HEAVY)))
    system, *bearings = found.results
    for one, pressure in zip(bearings, row(system, "line_pressure"), strict=True):
        alone = case_from_dict(
            bearing(one.name, **(HEAVY if one.name == "B" else {}))
            | {
                "lubricant": "ISO VG 46",
                "supply": {"temperature": "50 degC", "pressure": f"{pressure!r} Pa"},
                "materials": {"bearing_metal": "B83", "bearing": "C10", "journal": "42CrMo4"},
            }
        )
        (result,) = solve(alone).results
        assert one.minimum_film_thickness == pytest.approx(result.minimum_film_thickness, rel=1e-7)
        assert one.total_flow == pytest.approx(result.total_flow, rel=1e-7)
    assert totals(found.results).values["pump_flow"] == pytest.approx(system.pump_delivery, rel=1e-8)


def test_the_bearing_behind_the_smallest_orifice_starves_first():
    system = answer(machine(orifices(A=4, B=1), bearing("A"), bearing("B"))).results[0]
    ratios = row(system, "line_supply_ratio")
    assert ratios[1] < 1.0 < ratios[0]
    assert system.least_supply_ratio == ratios[1]
    assert system.verdict is Verdict.FAIL
    (said,) = sentences(system)
    assert said.startswith("First to starve: B,")
    assert said.endswith("It starves.")
    assert row(system, "line_pressure")[1] == pytest.approx(0.0, abs=1e-3)


def test_proposed_orifices_give_every_bearing_its_need_and_the_margin():
    tube = {"diameter": "10 mm", "length": "3 m"}
    lines = [
        {"bearing": "A", "orifice_diameter": "4 mm"},
        {"bearing": "B", "tube": tube, "orifice_diameter": "1 mm"},
    ]
    first = answer(machine(lines, bearing("A"), bearing("B", **HEAVY))).results[0]
    sizes = row(first, "line_orifice_proposed")
    mended = [{**line, "orifice_diameter": f"{size!r} m"} for line, size in zip(lines, sizes, strict=True)]
    again = answer(machine(mended, bearing("A"), bearing("B", **HEAVY))).results[0]
    assert row(again, "line_supply_ratio") == pytest.approx((1.2, 1.2), rel=1e-6)
    assert again.header_pressure == pytest.approx(0.3e6)
    assert row(again, "line_orifice_proposed") == pytest.approx(sizes, rel=1e-9)


def test_a_pump_that_gives_too_little_has_no_orifices():
    system = answer(
        machine(
            orifices(A=4, B=4),
            bearing("A"),
            bearing("B", **HEAVY),
            pump={"flow": "5 L/min", "relief_pressure": "0.3 MPa"},
        )
    ).results[0]
    assert [one.variant for one in system.warnings if one.code == "W602"] == ["pump"]
    assert "line_orifice_proposed" not in system.arrays


def test_films_are_balanced_too():
    plain = {
        "method": {"kind": "film", "accuracy": "draft"},
        "supply_element": None,
        "span": None,
        "grooves": [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"}],
    }
    made = [
        {name: value for name, value in bearing(one, **plain, **more).items() if value is not None}
        for one, more in (("A", {}), ("B", {"load": "6 kN"}))
    ]
    system, *bearings = answer(machine(orifices(A=3, B=3), *made)).results
    assert system.oil_balance_error < 1e-8
    assert row(system, "line_flow")[0] > row(system, "line_need")[0]
    assert bearings[0].eccentricity_ratio > bearings[1].eccentricity_ratio


def test_a_balance_at_mean_clearances_is_held_at_their_limits_too():
    """It passed cleanly at 250 kPa in the header; at the largest clearance 8 kPa are left, and A starves."""

    def found(clearance):
        given = {"width": "80 mm", "speed": "2000 rpm", "span": "360 deg", "clearance": clearance,
                 "supply_element": {"kind": "pocket", "width": "56 mm", "place": "opposite"}}  # fmt: skip
        pump = {"flow": "3 L/min", "relief_pressure": "0.25 MPa"}
        supply = {"temperature": "45 degC"}
        case = machine(orifices(A=5), bearing("A", **given), pump=pump, supply=supply, clearance_cases="mean")
        return answer(case).results[0]

    system = found("H7/d8")
    assert system.verdict is Verdict.REMARKS
    ((missed,),) = (one.values["missed"] for one in system.warnings if one.code == "W174")
    (of_line,) = missed.values["told"]
    starved = of_line.values["told"]
    assert (missed.values["at"].variant, of_line.values["bearing"], starved.values["check"]) == (
        "all_greatest", "A", "C601",
    )  # fmt: skip
    largest = found({"kind": "diametral", "mean": "209 um"})  # (35 + 174) um
    assert largest.verdict is Verdict.FAIL
    assert starved.values["value"] == pytest.approx(largest.least_supply_ratio, rel=1e-9)


def two_bearings(of_a=None, **of_b):
    """A groove all around that takes most of the oil at its largest clearance, and a loaded bearing beside it."""
    shared = {"metal": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"}}
    wide = {"width": "80 mm", "span": "360 deg", "load": "9 kN", "speed": "700 rpm",
            "supply_element": {"kind": "groove_360", "width": "8 mm"},
            "clearance": {"kind": "relative", "mean": "1.4 permille", "minimum": "1.3 permille",
                          "maximum": "2.2 permille"}} | (of_a or {})  # fmt: skip
    slow = {"diameter": "180 mm", "width": "156.6 mm", "span": "120 deg", "load": "114.16 kN", "speed": "437 rpm",
            "clearance": {"kind": "relative", "mean": "1.521 permille"},
            "supply_element": {"kind": "pocket", "width": "117.4 mm", "place": "both_sides"}} | of_b  # fmt: skip
    return machine(
        orifices(A=10, B=8), bearing("A", **wide), bearing("B", **slow), clearance_cases="mean",
        pump={"flow": "9 L/min", "relief_pressure": "0.25 MPa"}, lubricant="ISO VG 32",
        supply={"temperature": "55 degC"}, materials=shared["metal"],
    )  # fmt: skip


def test_a_bearing_without_a_verdict_at_the_largest_clearances_is_named():
    """All three kept their limits; with the largest clearance of A 115 kPa are left, and B has ε = 0.952."""
    system, a, b = answer(two_bearings(limits={"minimum_film_thickness": "4 um"})).results
    assert (a.verdict, b.verdict, system.verdict) == (Verdict.PASS, Verdict.REMARKS, Verdict.PASS)
    assert "W129" not in b.questioning_codes
    ((missed,),) = (one.values["missed"] for one in b.warnings if one.code == "W174")
    where = "with the largest clearance of every bearing behind the pump"
    assert missed.message == f"{where}: no verdict by W129 ({explanations()['W129'].title})"


def test_a_bearing_is_held_at_its_smallest_clearance_beside_the_largest_of_the_others():
    """All at their smallest, or largest, keep 67.4 °C; B at its smallest beside A at its largest does not."""
    least, most = 1.2704e-3, 1.7716e-3
    clearance = {"kind": "relative", "mean": "1.521 permille", "minimum": f"{least}", "maximum": f"{most}"}
    case = two_bearings(clearance=clearance, load="31.8 kN", speed="773 rpm", limits={"temperature": "67.4 degC"})
    *others, b = answer(case).results
    assert [one.verdict for one in others] == [Verdict.PASS, Verdict.PASS]
    assert b.verdict is Verdict.REMARKS
    ((missed,),) = (one.values["missed"] for one in b.warnings if one.code == "W174")
    assert missed.values["at"].variant == "own_least"
    (problem,) = (one.problem for one in case.calculations())
    _, b = network.balanced(problem.at_limits((1, 0))).bearings
    (hot,) = missed.values["told"]
    leaves = b.solution.result.starved_outlet_temperature
    assert hot.values["value"] == pytest.approx(leaves, rel=1e-6)
    assert leaves > 273.15 + 67.4
    for limits in ((0, 0), (1, 1)):
        for one in network.balanced(problem.at_limits(limits)).bearings:
            assert all(check.ok for check in one.solution.result.limits)


def test_a_bearing_without_film_is_named_at_those_that_are_not_solved_for_want_of_it():
    """The bore of A closes at its smallest clearance; B was told to have no operating point there."""
    clearance = {"kind": "relative", "mean": "1.5 permille", "minimum": "0.05 permille", "maximum": "2 permille"}
    closing = {"clearance": clearance, "materials": {"bearing": "EN-GJL-250", "journal": "X5CrNi18-10"}}
    case = machine(
        orifices(A=5, B=5), bearing("A", **closing), bearing("B", clearance="F7/e7"), clearance_cases="mean",
        pump={"flow": "30 L/min", "relief_pressure": "0.2 MPa"},
    )  # fmt: skip
    of_system, of_a, of_b = (
        [
            (one.values["at"].variant, clause.values.get("bearing"))
            for notice in result.warnings if notice.code == "W174"
            for one in notice.values["missed"]
            for clause in one.values["told"]
            if "no_film" in (clause.variant, getattr(clause.values.get("told"), "variant", ""))
        ]
        for result in answer(case).results
    )  # fmt: skip
    assert of_a == [("all_least", None), ("own_least", None)]
    assert of_b == [("all_least", "A"), ("own_greatest", "A")]
    assert of_system == [("all_least", "A"), ("one_least", "A"), ("one_greatest", "A")]


@pytest.mark.parametrize("asked", [{}, {"clearance_cases": "mean"}])
def test_limits_that_the_balance_solves_are_not_told_as_unsolved(asked):
    case = machine(orifices(A=6), bearing("A", clearance="H7/e7"), pump=PUMP, **asked)
    told = [one.variant for result in answer(case).results for one in result.warnings if one.code == "W174"]
    assert set(told) <= {"missed"}


def test_rows_of_a_study_have_the_bearings_of_an_oil_system():
    """They had the system alone: a machine passed whose bearing B fails."""
    sure = {"clearance": {"kind": "relative", "mean": "1.4 permille"}}
    case = two_bearings(sure, limits={"minimum_film_thickness": "14 um"})
    vary = {"bearings.B.speed": ["437 rpm", "450 rpm"]}
    found = run_study(plan(case, StudyBlock(kind="sweep", vary=vary))).columns
    assert found["bearing"].tolist() == 2 * ["Oil system of Gear", "A", "B"]
    assert found["verdict"].tolist() == 2 * ["pass", "pass", "fail"]


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"oil_system": {"pump": PUMP, "lines": orifices(A=4)}}, "no line of the oil system leads to B"),
        ({"oil_system": {"pump": PUMP, "lines": orifices(A=4, B=4, C=4)}}, "there is no such bearing"),
        ({"oil_system": {"pump": PUMP, "lines": [*orifices(A=4), {"bearing": "B"}]}}, "nothing is between"),
        ({"oil_system": {"pump": {"flow": "9 L/min"}, "lines": orifices(A=4, B=4)}}, "relief_pressure"),
        ({"supply": {"temperature": "50 degC", "pressure": "0.2 MPa"}}, "follows from the oil system"),
        ({"clearance_cases": "all"}, "one clearance of each bearing"),
        ({"bearings": [bearing("A"), bearing("B", clearance="H7/d8", clearance_cases="all")]},
         r"bearings\[1 'B'\].clearance_cases: an oil system has one clearance"),
        ({"bearings": [bearing("A"), bearing("B", operating_points=[{"name": "x", "load": "5 kN"}], load=None)]},
         "one operating point"),
    ],
)  # fmt: skip
def test_what_an_oil_system_does_not_know_is_refused(changed, words):
    for one in changed.get("bearings", ()):
        if "operating_points" in one:
            del one["load"]
    with pytest.raises(CaseError, match=words):
        machine(orifices(A=4, B=4), bearing("A"), bearing("B"), **changed)


def test_a_pump_curve_falls():
    curve = [{"pressure": "0 MPa", "flow": "5 L/min"}, {"pressure": "0.4 MPa", "flow": "9 L/min"}]
    with pytest.raises(CaseError, match="rises with the pressure"):
        machine(orifices(A=4), bearing("A"), pump={"curve": curve})
