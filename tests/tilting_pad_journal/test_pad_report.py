"""The report of a tilting-pad bearing: formulas, tables, figures and fields are those of the answer."""

import numpy as np
import pytest
from pad_journals import HEATED, OIL, pad_case, solution_of

from babbitt.case import case_from_dict
from babbitt.kinds.tilting_pad_journal.report.calculation import pad_calculation
from babbitt.kinds.tilting_pad_journal.report.maps import over_width
from babbitt.report.content import content
from babbitt.report.expression import value
from babbitt.report.view import view_of
from babbitt.report.vocabulary import VOCABULARY
from babbitt.solving import solve

ISOTHERMAL = {"thermal": "isothermal", "lubricant": OIL}
CASES = {
    "global": ({}, {}),
    "with a rotor": ({"pads.first_pivot": "-90 deg"}, {"rotor_mass": "2 t"}),
    "backward": ({"pads.pivot": {"kind": "rigid", "fraction": 0.55}}, {"speed": "-4000 rpm", "carry_over": 0.7}),
    "isothermal on springs": ({"pads.pivot": {"kind": "spring", "stiffness": "500 MN/m"}}, ISOTHERMAL),
    "on flexures": (
        {"pads.pivot": {"kind": "flexure", "rotational_stiffness": "2 kN m/rad"}},
        {"rotor_mass": "1 t"},
    ),
    "driven on a pedestal": (
        {},
        {
            "rotor_mass": "1 t",
            "shaft_stiffness": "150 MN/m",
            "anticipated_cross_coupling": "4 MN/m",
            "pedestal": {"stiffness_x": "600 MN/m", "stiffness_y": "1 GN/m", "mass": "300 kg"},
            "load_angle": "-70 deg",
        },
    ),
    "much oil": ({"supply.flow": "40 L/min"}, {}),
    "adiabatic": ({}, HEATED["A"]),
    "grown and bent": ({"supply.flow": "40 L/min"}, HEATED["E"] | {"rotor_mass": "1 t"}),
    "grown backward": ({}, HEATED["E"] | {"speed": "-4000 rpm", "load_angle": "-80 deg"}),
    "placed": ({"load": None}, {"position": {"x": "9 um", "y": "-30 um"}, "load": None}),
}


@pytest.fixture(scope="module", params=CASES)
def solution(request):
    changes, fields = CASES[request.param]
    found = solution_of(changes, **fields)
    assert found.result.outcome.solved
    return found


def lines(solution):
    return [line for section in pad_calculation(solution) for line in section.lines if line.expression]


def test_every_formula_gives_the_result(solution):
    assert len(lines(solution)) >= 10
    for line in lines(solution):
        assert value(line.expression, line.numbers) == pytest.approx(line.value, rel=1e-7, abs=1e-12), line.name


def test_printed_numbers_give_the_printed_result(solution):
    for line in lines(solution):
        digits = {other: max(line.digits, VOCABULARY[other].digits) for other in line.numbers}
        printed = {other: float(f"{n:.{digits[other]}g}") for other, n in line.numbers.items()}
        assert value(line.expression, printed) == pytest.approx(line.value, rel=1e-3, abs=1e-9), line.name


def test_the_pad_of_the_calculation_is_the_one_that_carries_most(solution):
    films = solution.state.films.solution
    most = films.pads[films.most_loaded]
    numbers = {line.name: line.value for section in pad_calculation(solution) for line in section.lines}
    assert numbers["this_ratio"] == pytest.approx(most.eccentricity_ratio, rel=1e-6)
    assert numbers["largest_pad_load"] == most.load
    assert most.load == pytest.approx(max(pad.load for pad in films.pads), rel=1e-6)
    assert all(pad.load < most.load * (1.0 - 1e-7) for pad in films.pads[: films.most_loaded])


def test_an_unsolved_bearing_has_no_calculation_and_no_figures():
    offset = {"pads.preload": 0.0, "pads.pivot": {"kind": "rigid", "fraction": 0.52}}
    loads = np.linspace(1.0, 6.0, 26)
    found = (solution_of(offset, load=f"{load} kN", load_angle="-40 deg", **ISOTHERMAL) for load in loads)
    unsolved = next(one for one in found if not one.result.outcome.solved)
    view = view_of(unsolved.result)
    assert tuple(view.sections(unsolved)) == tuple(view.figures(unsolved, "svg")) == ()
    assert list(view.tables(unsolved.result)) == []


def test_the_report_echoes_clearances_and_preload_of_every_pad():
    each = [{"preload": 0.4}, {}, {}, {}]
    whole = str(content(solve(case_from_dict(pad_case({"pads.each": each})))))
    assert "Preload, 1 − assembled/machined clearance, pad 1" in whole
    assert "Preload, 1 − assembled/machined clearance, pad 2, 3, 4" in whole
    assert "Machined clearance" in whole
    assert "Carry-over 1 of flooded grooves." in whole


def test_the_tables_hold_every_pad_and_ratio(solution):
    tables = view_of(solution.result).tables(solution.result)
    by_title = {one["title"]: one for one in tables}
    for title in ("Clearances of the pads", "Pads at rest", "Oil of the pads"):
        assert [row[0] for row in by_title[title]["rows"]] == ["1", "2", "3", "4"]
    ratios = [row[0] for row in by_title["Coefficients over the whirl ratio"]["rows"]]
    assert ratios == ["at rest", "0.2", "0.4", "0.6", "0.8", "1", "1.2", "fitted"]


@pytest.mark.parametrize("changes", [{}, {"pads.preload": 0.0}], ids=["loaded", "two unloaded"])
def test_figures_are_drawn(changes):
    found = solution_of(changes, rotor_mass="800 kg")
    drawings = view_of(found.result).figures(found, "svg")
    names = [one.name for one in drawings]
    assert names == ["bearing", "pad-curve", "pad-pressure", "pad-loads", "whirl-ratio", "root-locus"]
    assert all(one.image.startswith(b"<?xml") and one.caption.endswith(".") for one in drawings)
    again = view_of(found.result).figures(found, "svg")
    assert [one.image for one in again] == [one.image for one in drawings]


@pytest.mark.parametrize("model", ["A", "E"])
def test_temperatures_are_drawn_and_tabulated(model):
    found = solution_of({"pads.preload": 0.0} if model == "A" else {}, **HEATED[model])
    view = view_of(found.result)
    (drawn,) = (one for one in view.figures(found, "svg") if one.name == "pad-temperatures")
    assert drawn.image.startswith(b"<?xml")
    (table,) = (one for one in view.tables(found.result) if one["title"] == "Temperatures of the pads")
    assert len(table["columns"]) == (5 if model == "A" else 10)
    assert [row[0] for row in table["rows"]] == ["1", "2", "3", "4"]


@pytest.mark.parametrize("fields", [{}, {"speed": "-4000 rpm", "load_angle": "-70 deg"}])
def test_fields_have_the_gap_and_temperatures_of_pads_that_grow_and_bend(fields):
    pytest.importorskip("xarray")
    found = solution_of(**HEATED["E"] | fields)
    data, films = view_of(found.result).fields(found), found.state.films.thermal
    for number, state in enumerate(films.pads):
        gap = data["film_thickness"].values[number]
        assert gap.min() == pytest.approx(state.minimum_film_thickness, rel=2e-3)
    assert data["bore_temperature"].values.max() <= found.result.values["maximum_temperature"]
    assert data["film_temperature"].values.min() > found.result.values["supply_temperature"]


def test_pressure_over_the_width_passes_through_the_film(solution):
    for state in solution.state.films.solution.pads:
        places, pressure = over_width(state)
        half = float(state.axial_positions[-1])
        assert pressure.shape == (state.angles.size, places.size)
        assert pressure[:, places.size // 2] == pytest.approx(
            np.maximum(state.pressure[:, 0], 0.0), abs=1e-6 * 1e6
        )
        assert np.abs(pressure[:, 0]).max() < 1e-6 * max(float(state.pressure.max()), 1.0)
        assert places[0] == -half


def test_fields_carry_the_load():
    pytest.importorskip("xarray")
    found = solution_of()
    data = view_of(found.result).fields(found)
    assert dict(data.sizes) == {"pad": 4, "line": 49, "place": 5}
    assert float(data["pressure"].max()) == pytest.approx(found.result.values["maximum_pressure"])
    assert float(data["film_thickness"].min()) == pytest.approx(
        found.result.values["minimum_film_thickness"], rel=1e-2
    )
    assert data["pad_load"].values == pytest.approx(found.result.arrays["pad_load"][0])
    assert all({"units", "long_name"} <= set(one.attrs) for one in data.variables.values())


def chapter_of(fields):
    """What the report says of the one bearing of a case."""
    (chapter,) = content(solve(case_from_dict(fields)))["bearings"]
    return chapter


def test_the_inputs_have_load_and_its_direction_and_the_roughness():
    surfaces = {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"}
    said = str(chapter_of(pad_case(load_angle="-70 deg", surfaces=surfaces))["inputs"])
    assert "'Direction of the load, counter-clockwise from +x', 'value': '-70'" in said.replace("−", "-")
    assert "'Load', 'value': '10'" in said
    assert "Roughness of the bearing" in said
    assert "Roughness of the journal" in said


def test_the_inputs_have_the_place_that_is_given():
    said = str(chapter_of(pad_case(load=None, position={"x": "9 um", "y": "-30 um"}))["inputs"])
    assert "Given, journal centre, above the bearing centre" in said
    assert "Direction of the load" not in said


def test_the_report_tells_pad_loads_at_every_clearance():
    limits = {"kind": "radial", "mean": "148 um", "minimum": "140 um", "maximum": "160 um"}
    case = case_from_dict(pad_case({"pads.clearance": limits}, clearance_cases="all"))
    (chapter,) = content(solve(case))["bearings"]
    rows = {row["label"]: row["values"] for row in chapter["results"]}
    loads = [one.arrays["pad_load"][0] for one in solve(case).results]
    for pad in range(4):
        shown = [float(value) for value in rows[f"Load of pad {pad + 1}"]]
        assert shown == pytest.approx([1e-3 * one[pad] for one in loads], rel=5e-3)
    assert not any("of pad" in row["label"] for row in chapter_of(pad_case())["results"])
