"""The calculation of hydrostatic bearings in the report: what it shows is what was computed."""

import numpy as np
import pytest

from babbitt.case import parse_case, template
from babbitt.core.result import Outcome
from babbitt.kinds.hydrostatic.lumped import centred_stiffness, land_interaction, lumped_at
from babbitt.kinds.hydrostatic.lumps import journal_lumps
from babbitt.kinds.hydrostatic.report.calculation import hydrostatic_calculation
from babbitt.report.content import content
from babbitt.report.expression import value
from babbitt.report.labels import label
from babbitt.report.meanings import meaning
from babbitt.report.vocabulary import VOCABULARY
from babbitt.solving import solve

PAD = """
kind: hydrostatic_pad
name: Pad
pad: {kind: circular, diameter: 100 mm, recess_diameter: 50 mm}
recess_oil: {depth: 1 mm}
restrictor: {kind: capillary, diameter: 0.6 mm, length: 60 mm}
supply: {pressure: 5 MPa}
oil: {viscosity: 30 mPa s}
load: 11 kN
speed: 500 rpm
accuracy: draft
"""
RECTANGLE = "pad: {kind: rectangular, length: 200 mm, width: 100 mm, recess_length: 160 mm, recess_width: 60 mm}"
ANNULUS = """pad: {kind: annular, inner_diameter: 100 mm, recess_inner_diameter: 130 mm,
  recess_outer_diameter: 170 mm, outer_diameter: 200 mm}"""


def changed(text, **fields):
    """A case text with some of its fields written anew, or without them."""
    for name, said in fields.items():
        lines, skip = [], False
        for line in text.splitlines():
            skip = line.startswith(f"{name}:") or (skip and line.startswith(" "))
            lines += [] if skip else [line]
        text = "\n".join([*lines, *([] if said is None else [f"{name}: {said}"])])
    return text


def restricted(said, **fields):
    return changed(PAD, restrictor=said, **fields)


JOURNAL = changed(template("hydrostatic_journal"), accuracy="draft", limits=None)
RING = changed(template("hydrostatic_thrust_ring"), accuracy="draft", limits=None)
CASES = {
    "pad, film": PAD,
    "pad": changed(PAD, method="quick"),
    "pad without speed": changed(PAD, method="quick", speed=None),
    "entry loss": restricted(
        "{kind: capillary, diameter: 0.4 mm, length: 60 mm, tubes: 5, entry_loss: 2.24}", method="quick"
    ),
    "tubes": restricted("{kind: capillary, diameter: 0.3 mm, length: 60 mm, tubes: 16}", method="quick"),
    "check valve": restricted(
        "{kind: capillary, diameter: 0.6 mm, length: 60 mm, check_valve: true}", method="quick"
    ),
    "orifice": restricted("{kind: orifice, diameter: 0.4 mm}", method="quick"),
    "slot": restricted("{kind: slot, width: 8 mm, gap: 0.1 mm, length: 20 mm}", method="quick"),
    "constant flow": restricted("{kind: constant_flow, flow: 0.2 L/min}", method="quick"),
    "metered flow": restricted("{kind: metered_flow, flow: 0.2 L/min}", method="quick"),
    "metered flow above the supply": restricted(
        "{kind: metered_flow, flow: 0.2 L/min}", method="quick", supply="{pressure: 2 MPa}"
    ),
    "constant flow, leaking": restricted(
        "{kind: constant_flow, flow: 0.2 L/min, leakage: 0.01 L/(min MPa)}", method="quick"
    ),
    "constant flow above the supply": restricted(
        "{kind: constant_flow, flow: 0.2 L/min}", method="quick", supply="{pressure: 2 MPa}"
    ),
    "flow valve": restricted(
        "{kind: flow_valve, flow: 0.15 L/min, gain: 0.02 L/(min MPa), open_conductance: 5 L/(min MPa)}",
        method="quick",
    ),
    "flow valve, open": restricted(
        "{kind: flow_valve, flow: 0.3 L/min, gain: 0.02 L/(min MPa), open_conductance: 0.06 L/(min MPa)}",
        method="quick", load="8 kN",
    ),
    "membrane valve": restricted(
        "{kind: membrane_valve, conductance: 0.03 L/(min MPa), compliance: 0.2 1/MPa}", method="quick"
    ),
    "pump for all": changed(PAD, supply="{pump_flow: 0.3 L/min, leakage: 0.006 L/(min MPa)}", method="quick"),
    "rectangle": changed(PAD, speed=None, sliding_speed="2 m/s", method="quick").replace(
        "pad: {kind: circular, diameter: 100 mm, recess_diameter: 50 mm}", RECTANGLE
    ),
    "rectangle, unequal lands": changed(PAD, speed=None, sliding_speed="2 m/s", method="quick").replace(
        "pad: {kind: circular, diameter: 100 mm, recess_diameter: 50 mm}",
        RECTANGLE.replace("recess_length: 160", "recess_length: 120"),
    ),
    "rectangle, film": changed(PAD, speed=None, sliding_speed="2 m/s").replace(
        "pad: {kind: circular, diameter: 100 mm, recess_diameter: 50 mm}", RECTANGLE
    ),
    "annulus": changed(PAD, method="quick").replace(
        "pad: {kind: circular, diameter: 100 mm, recess_diameter: 50 mm}", ANNULUS
    ),
    "lubricant": changed(
        PAD, oil="{lubricant: ISO VG 46, supply_temperature: 40 degC}", method="quick"
    ),
    "ring, film": RING,
    "ring": changed(RING, method="quick"),
    "ring, backward": changed(RING, method="quick", speed="-1000 rpm"),
    "ring, pumps": changed(RING, method="quick", restrictor="{kind: constant_flow, flow: 0.7 L/min}"),
    "ring, metered": changed(RING, method="quick", restrictor="{kind: metered_flow, flow: 0.7 L/min}"),
    "journal, film": JOURNAL,
    "journal": changed(JOURNAL, method="quick"),
    "journal, backward": changed(JOURNAL, method="quick", speed="-1500 rpm"),
    "journal, back flow": changed(JOURNAL, method="quick", load="30 kN"),
    "journal, shut valve": changed(
        JOURNAL, method="quick", load="30 kN",
        restrictor="{kind: capillary, diameter: 0.8 mm, length: 100 mm, check_valve: true}",
    ),
    "journal, drained": changed(
        JOURNAL, method="quick", recesses="{number: 4, extent: 60 deg, drain_groove: 6 deg}"
    ),
    "journal, unlike": changed(
        JOURNAL, method="quick", restrictor=None,
        restrictors="[{kind: capillary, diameter: 1 mm, length: 100 mm}, {kind: orifice, diameter: 0.4 mm},"
        " {kind: capillary, diameter: 0.6 mm, length: 100 mm}, {kind: orifice, diameter: 0.4 mm}]",
    ),
    "jacking": changed(template("jacking_pocket"), accuracy="draft"),
    "jacking, strips": changed(template("jacking_pocket"), method="quick"),
}  # fmt: skip


@pytest.fixture(scope="module", params=CASES)
def solved(request):
    machine = solve(parse_case(CASES[request.param]))
    (case,), (result,) = machine.problems, machine.results
    assert result.outcome is Outcome.CONVERGED, result.message
    return case, result


def lines(solved):
    found = [line for section in hydrostatic_calculation(*solved) for line in section.lines]
    return [line for line in found if line.expression]


def test_every_formula_gives_the_result(solved):
    """To the smoothing of an orifice; films are solved to 1e-9."""
    assert len(lines(solved)) >= 6
    for line in lines(solved):
        assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=2e-6), line.name


def test_printed_numbers_give_the_printed_result(solved):
    for line in lines(solved):
        digits = {other: max(line.digits, VOCABULARY[other].digits) for other in line.numbers}
        printed = {other: float(f"{n:.{digits[other]}g}") for other, n in line.numbers.items()}
        assert value(line.expression, printed) == pytest.approx(line.value, rel=5e-4), line.name


def test_lines_of_the_middle_are_the_closed_form():
    machine = solve(parse_case(CASES["journal, film"]))
    (case,), (result,) = machine.problems, machine.results
    (middle,) = (s for s in hydrostatic_calculation(case, result) if s.title == "The centred journal")
    found = {line.name: line.value for line in middle.lines}
    lumps = journal_lumps(case.shape, 0.02, 0.0)
    centred = lumped_at(lumps, case.feeding, np.zeros(2))
    assert found["centred_ratio"] == pytest.approx(centred.network.pressures[0] / 5e6, rel=1e-9)
    assert found["centred_flow"] == pytest.approx(centred.network.flows.sum(), rel=1e-9)
    assert found["land_interaction"] == pytest.approx(land_interaction(case.shape), rel=1e-12)
    closed = centred_stiffness(case.shape, 5e6, found["centred_ratio"])
    assert found["centred_stiffness"] == pytest.approx(closed, rel=1e-12)


def test_an_unsolved_bearing_has_no_calculation():
    machine = solve(parse_case(changed(PAD, load="30 kN", method="quick")))
    assert hydrostatic_calculation(machine.problems[0], machine.results[0]) == ()


@pytest.mark.usefixtures("no_images")
@pytest.mark.parametrize("name", ["pad", "journal, film", "ring", "jacking, strips"])
def test_the_calculation_is_in_the_report(name):
    machine = solve(parse_case(CASES[name]))
    (chapter,) = content(machine)["bearings"]
    titles = [section["title"] for section in chapter["sections"]]
    assert titles[0] == {"pad": "Lands", "jacking, strips": "Breakaway"}.get(name, "Restrictor")
    assert titles[-1] == ("Lift" if "jacking" in name else "Power and warming")
    said = {line["meaning"] for section in chapter["sections"] for line in section["lines"]}
    assert "Pumping power" in said


def test_the_report_is_typeset():
    from babbitt.core.report_level import Level
    from babbitt.report.document import report

    machine = solve(parse_case(CASES["journal"]))
    assert report(machine, "pdf")[:4] == b"%PDF"
    assert "The centred journal" in report(machine, "html", Level.FULL).decode()


def test_where_nothing_turns_no_speed_is_told():
    circle = "pad: {kind: circular, diameter: 100 mm, recess_diameter: 50 mm}"
    text = PAD.replace(circle, RECTANGLE).replace("speed: 500 rpm", "method: quick")
    (chapter,) = content(solve(parse_case(text.replace("accuracy: draft", ""))))["bearings"]
    assert "Speed" not in {row["label"] for group in chapter["inputs"] for row in group["rows"]}


def test_pads_and_rings_have_a_runner_and_no_journal():
    for kind in ("hydrostatic_pad", "hydrostatic_thrust_ring"):
        assert label("angular_speed", kind) == meaning("angular_speed", kind) == "Rotational speed of the runner"
        assert "journal" not in meaning("friction_torque", kind)
    assert "journal" in meaning("friction_torque", "hydrostatic_journal")


def test_the_oil_of_a_supply_has_one_name_on_screen_and_paper():
    for kind in ("hydrostatic_pad", "hydrostatic_thrust_ring", "hydrostatic_journal"):
        names = {label("supply_temperature", kind), meaning("supply_temperature", kind)}
        assert names == {"Temperature before the restrictors"}
    assert label("load", "journal") == meaning("load", "journal") == "Load"


def test_the_line_behind_a_restrictor_is_printed_and_no_limit_of_temperature_is_hidden():
    text = PAD.replace("{depth: 1 mm}", "{depth: 1 mm, line_volume: 3 mL}")
    chapter = content(solve(parse_case(text)))["bearings"][0]
    rows = {row["label"]: row["value"] for group in chapter["inputs"] for row in group["rows"]}
    assert rows["Of it in line and ports"] == "3"
    assert float(rows["Oil behind one restrictor"]) > 3.0
    assert "C305" in {one["code"] for one in chapter["not_checked"]}
