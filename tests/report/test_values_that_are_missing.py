"""What a film could not tell, and what it was computed with, stand in table, report and JSON."""

from __future__ import annotations

import io
from functools import cache
from types import SimpleNamespace

import pytest
from drawn import Drawn
from rich.console import Console

from babbitt.case import parse_case
from babbitt.core.result import Outcome
from babbitt.report.bearing_content import bearing_content
from babbitt.report.chapters import chapters
from babbitt.report.export import to_json
from babbitt.report.table import print_machine
from babbitt.report.view import view_of
from babbitt.solving import MachineResult, solve

pytestmark = pytest.mark.usefixtures("no_images")

CASE = """
kind: journal
name: Two pockets
method: film
accuracy: draft
diameter: 100 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5 permille}
pockets: [{angle: 0 deg, extent: 20 deg, width: 40 mm}, {angle: 180 deg, extent: 20 deg, width: 40 mm}]
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.3 MPa}
materials: {bearing_metal: SnSb8Cu4, bearing: C10, journal: C45}
load: 5 kN
load_angle: -57.9 deg
speed: 2000 rpm
"""


@cache
def plain() -> MachineResult:
    """The case as it stands, solved once."""
    return solve(parse_case(CASE))


def printed(machine: MachineResult) -> str:
    told = io.StringIO()
    print_machine(machine, Console(file=told, width=140))
    return told.getvalue()


def input_rows(machine: MachineResult) -> dict[str, str]:
    (chapter,) = chapters(machine.solutions)
    groups = bearing_content(chapter)["inputs"]
    return {row["label"]: row["value"] for group in groups for row in group["rows"]}


def test_flows_that_are_not_found_are_told_with_the_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    """Q3 and Q_p vanished without a word where the film without supply pressure is not found."""
    known = plain()
    assert set(known.results[0].missing) == {"critical_mass"}
    assert known.results[0].stable_at_any_mass == 1.0
    assert {"side_flow", "supply_flow"} <= set(known.results[0].values)
    lost = SimpleNamespace(outcome=Outcome.NOT_CONVERGED)
    monkeypatch.setattr("babbitt.reynolds.equilibrium.position.film_at_position", lambda *_, **__: lost)
    machine = solve(parse_case(CASE))
    (result,) = machine.results
    assert set(result.missing) == {"side_flow", "supply_flow", "critical_mass"}
    assert result.total_flow == pytest.approx(known.results[0].total_flow, rel=1e-12)
    text = printed(machine)
    rows, below = text.split("Values not found")
    assert "without" not in next(line for line in rows.splitlines() if "Oil flow due to the film pressure" in line)
    assert "Q₃, Q_p: no film was found" in " ".join(below.split())
    (chapter,) = chapters(machine.solutions)
    labels = " ".join(row["label"] for row in bearing_content(chapter)["results"])
    assert labels.count("without the supply pressure") == 2
    (bearing,) = to_json(machine)["bearings"]
    assert set(bearing["missing"]) == {"side_flow", "supply_flow", "critical_mass"}
    assert "side_flow" not in bearing["results"]


def test_a_turbulent_film_is_not_called_laminar() -> None:
    laminar = input_rows(plain())
    turbulent = input_rows(solve(parse_case(CASE + "turbulence: ng_pan\n")))
    assert laminar["Flow"] == "laminar"
    assert laminar["Viscosity under pressure"] == "constant"
    assert "turbulent" in turbulent["Flow"]
    assert "laminar" not in " ".join(map(str, turbulent.values()))


def test_pressure_and_viscosity_stand_in_an_input_row() -> None:
    rows = input_rows(solve(parse_case(CASE + "pressure_viscosity: {kind: barus, coefficient: 20 1/GPa}\n")))
    assert rows["Viscosity under pressure"].startswith("after Barus, 20 1/GPa")


def test_misalignment_is_among_the_results() -> None:
    machine = solve(parse_case(CASE + "misalignment: {x: 0.1 mm/m, y: -0.2 mm/m}\n"))
    (bearing,) = to_json(machine)["bearings"]
    assert bearing["results"]["misalignment_x"] == pytest.approx(1e-4)
    assert bearing["results"]["misalignment_y"] == pytest.approx(-2e-4)
    assert "dx/dz" in printed(machine)
    label = "Misalignment of the journal axis in"
    assert f"{label} y" in printed(machine)
    rows = input_rows(machine)
    assert (float(rows[f"{label} x"]), rows[f"{label} y"]) == (0.1, "−0.2")
    assert "misalignment_x" not in to_json(plain())["bearings"][0]["results"]


def test_a_film_of_an_inclined_journal_says_where_its_values_hold() -> None:
    """The pressure of the drawing was less than that of the table, without a word."""
    said = "The journal is inclined: ε and β are those of the middle of the width"
    for text, inclined in ((CASE, False), (CASE + "misalignment: {x: 0.1 mm/m, y: -0.2 mm/m}\n", True)):
        (solution,) = solve(parse_case(text)).solutions
        assert any(one.startswith(said) for one in solution.result.assumptions) is inclined
        words = Drawn(view_of(solution.result).picture(solution).svg()).words()
        assert any(one.endswith("MPa (z = 0)") for one in words) is inclined
