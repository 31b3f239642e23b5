"""The first page: what governs, what the report covers, what its symbols mean, and one film in each row."""

from dataclasses import replace
from pathlib import Path

import gear_cases
import pytest

import babbitt
from babbitt.case import load_case, parse_case
from babbitt.core.language import translated_if_known, written_in
from babbitt.core.limited_flow import is_short_of_oil
from babbitt.core.report_level import Level
from babbitt.core.result_name import ResultName
from babbitt.kinds.journal.iso7902.procedure import check
from babbitt.report.citations import citations_of
from babbitt.report.content import content
from babbitt.report.scope import scope_of
from babbitt.report.text import plain_text
from babbitt.solving import solve

GEAR = Path(babbitt.__file__).parents[2] / "examples" / "marine_reverse_gear.yaml"


@pytest.fixture(scope="module")
def gear():
    return babbitt.load_case(GEAR).solve().machine


@pytest.fixture(scope="module")
def said(gear):
    return content(gear, Level.STANDARD)


def test_the_governing_check_is_the_least_margin_of_the_machine(gear, said):
    governing = said["conclusion"]["governing"]
    least = min(check.margin for result in gear.results for check in result.limits)
    assert governing["margin"] == f"{least:+.0%}"
    assert governing in said["checker"]["governing"]
    assert not governing["advice"]


def test_a_row_of_the_first_table_is_of_one_film(gear):
    """From clearance and eccentricity of a row follows its film thickness, from the clearance its limit of Re."""
    short = [result for result in gear.results if is_short_of_oil(result)]
    assert len(short) >= 5
    for result in short:
        values = result.values
        clearance, eccentricity = (
            values[f"starved_{name}"] for name in ("operating_relative_clearance", "eccentricity_ratio")
        )
        film = clearance * values["diameter"] / 2.0 * (1.0 - eccentricity)
        assert film == pytest.approx(values["starved_minimum_film_thickness"], rel=1e-12)
        limit = next(one.limit for one in result.limits if one.quantity == "starved_film_reynolds_number")
        assert limit == pytest.approx(41.3 / clearance**0.5, rel=1e-12)
        assert limit == pytest.approx(values["starved_critical_reynolds_number"], rel=1e-12)


def test_the_outlet_follows_from_the_row_of_the_first_table(gear, said):
    heads = [
        "".join(part[1] if isinstance(part, list) else part for part in one["heading"]) for one in said["columns"]
    ]
    for result, solution, row in zip(gear.results, gear.solutions, said["rows"], strict=True):
        marked = {cell.endswith("*") for cell in (row["cells"][heads.index(name)] for name in ("T → T", "P"))}
        assert marked == {is_short_of_oil(result)}
        power = float(row["cells"][heads.index("P")].rstrip("*"))
        flow = sum(float(cell.rstrip("*")) for head, cell in zip(heads, row["cells"], strict=True) if head == "Q")
        inlet, outlet = map(float, row["cells"][heads.index("T → T")].rstrip("*").split(" → "))
        oil = solution.problem.lubricant.volumetric_heat_capacity(273.15 + 0.5 * (inlet + outlet))
        assert inlet + 1e3 * power / (oil * flow / 6e4) == pytest.approx(outlet, rel=0.01)


def test_the_page_of_a_bearing_short_of_oil_shows_both_films(gear, said):
    for result, bearing in zip(gear.results, said["bearings"], strict=True):
        rows = {row["label"]: row for row in bearing["results"]}
        film = rows["Minimum film thickness"]
        assert ("limited" in film) is is_short_of_oil(result)
        if "limited" in film:
            held = next(one for one in bearing["checks"] if one["code"] == "C101")
            assert held["value"] == f"{film['limited']} µm" != f"{film['values'][0]} µm"
            assert rows["Specific load"]["limited"] == rows["Specific load"]["values"][0]
            flows = [float(rows[f"{which} flow"]["limited"]) for which in ("Side", "Supply", "Total")]
            assert flows[0] + flows[1] == pytest.approx(flows[2], abs=0.11)


def test_clearances_short_of_oil_show_both_films_in_rows():
    """Before, the film with all the oil that it wants alone, beside a verdict of the other."""
    case = parse_case(FAN)
    machine = solve(case)
    (bearing,) = content(machine)["bearings"]
    rows = {row["label"]: row["values"] for row in bearing["results"]}
    shown = rows["Outlet temperature with the limited flow"]
    assert [float(one) for one in shown] == pytest.approx(
        [result.starved_outlet_temperature - 273.15 for result in machine.results], abs=0.051
    )
    assert shown != rows["Outlet temperature"]


FAN = """
kind: journal
name: Fan
diameter: 100 mm
width: 80 mm
span: 360 deg
clearance: {kind: fit, bore: H7, journal: e8}
clearance_cases: all
supply_element: {kind: pocket, width: 56 mm, place: side}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.1 MPa}
materials: {bearing_metal: SnSb8Cu4, bearing: C10, journal: C45}
load: 10 kN
speed: 1500 rpm
"""


def test_every_symbol_of_the_first_table_is_explained(said):
    explained = {tuple(one["symbol"]) for one in said["conclusion"]["legend"]}
    shown = [node for column in said["columns"] for node in column["heading"] if isinstance(node, list)]
    assert {tuple(node) for node in shown if node[2] != "lim"} == explained


def test_references_name_the_edition_of_the_standard(said, gear):
    cited = said["conclusion"]["references"]
    assert any(one.startswith("ISO 7902-1:2020") for one in cited)
    assert any(one.startswith("TP-46 STO upper") for one in cited)
    assert content(gear, Level.SUMMARY)["conclusion"]["references"] == []


def named(*names):
    return [replace(check(gear_cases.EXAMPLE), name=name) for name in names]


def test_the_scope_names_points_and_clearances():
    one = " ".join(scope_of(named("Fan")))
    assert "One operating point" in one
    assert "One clearance" in one
    both = named(
        *(ResultName("Fan", point, which) for point in ("ahead", "astern") for which in ("minimum", "maximum"))
    )
    two = " ".join(scope_of(both))
    assert "Operating points: ahead, astern." in two
    assert "smallest and largest value of each bearing" in two
    mixed = " ".join(scope_of([*both, *named("Pump")]))
    assert "smallest and largest value of Fan; one value of the others" in mixed


def test_notes_on_references_are_in_the_language_of_the_report():
    """Titles of publications stay; what Babbitt says of them, and of its oils, does not stay English."""
    machine = solve(parse_case(babbitt.template("journal")))
    german, russian = (
        ("Entwickler", "Verfahren", "Viskositätsklasse"),
        ("Разработчики", "методика", "класса вязкости"),
    )
    for language_code, says in (("de", german), ("ru", russian)):
        with written_in(language_code):
            found = " ".join(content(machine)["conclusion"]["references"])
        assert all(word in found for word in says)


SHEETS = [
    (
        "journal",
        "ISO 7902-1:2020, mit ISO 7902-2 und ISO 7902-3: ",
        " ISO 7902-2 и ISO 7902-3: ",
    ),
    ("trawler_thrust_line", "Öl von 45 mPa s: im Fall angegeben", "масло 45 mPa s: задано"),
    ("screw_heel", "(Gleichungen, berichtigt; siehe ", "(уравнения, исправленные; см. "),
    ("shaft", "(Kräfte an Stirnrädern", "(силы в прямозубых и косозубых передачах)"),
]


@pytest.mark.parametrize(("kind", "german", "russian"), SHEETS)
def test_notes_on_references_of_every_kind_are_in_the_language(kind, german, russian):
    example = Path(babbitt.__file__).parents[2] / "examples" / f"{kind}.yaml"
    case = load_case(example) if example.exists() else parse_case(babbitt.template(kind))
    for language_code, says in (("de", german), ("ru", russian)):
        with written_in(language_code):
            found = " ".join(translated_if_known(plain_text(said)) for said in citations_of(case))
        assert says in found
