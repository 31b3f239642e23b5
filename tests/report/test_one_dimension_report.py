"""Report, figures and comparison of the films of one dimension."""

from pathlib import Path

import pytest
from film_bearings import case as film_case

from babbitt.case import load_case, parse_case
from babbitt.kinds.journal.report.views import SEGMENTS
from babbitt.properties.materials import bearing_metal
from babbitt.report.citations import citations_of
from babbitt.report.comparison_table import compared_rows
from babbitt.report.content import content
from babbitt.report.export import to_json
from babbitt.report.figures import write_plots
from babbitt.report.inputs import inputs
from babbitt.solving import solve
from babbitt.study.comparison import compare_methods

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module", params=["long_film", "grooved"])
def machine(request):
    return solve(load_case(EXAMPLES / f"{request.param}.yaml"))


@pytest.fixture(scope="module")
def long_film():
    return solve(load_case(EXAMPLES / "long_film.yaml"))


@pytest.fixture(scope="module")
def grooved():
    return solve(load_case(EXAMPLES / "grooved.yaml"))


def test_figures_are_drawn(machine, tmp_path):
    pytest.importorskip("matplotlib")
    written = write_plots(machine, tmp_path, "svg")
    names = {path.stem.partition("-")[2] for path in written}
    method = machine.results[0].method
    own = {"heat-split"} if method == "long_film" else {"groove-beside-none", "temperature-around-bore"}
    assert names == {"along-the-film"} | own
    assert all(path.read_bytes().startswith(b"<?xml") for path in written)


def test_unsolved_films_have_no_figures(tmp_path):
    text = (EXAMPLES / "long_film.yaml").read_text(encoding="utf-8").replace("25 kN", "2500 kN")
    unsolved = solve(parse_case(text))
    assert not unsolved.solved
    assert write_plots(unsolved, tmp_path, "svg") == ()


def test_chapter_names_method_inputs_and_results(long_film):
    (chapter,) = content(long_film)["bearings"]
    assert chapter["method"] == "Long film with heat exchange"
    shown = {row["label"] for row in chapter["results"]}
    assert len(shown) == len(chapter["results"])
    assert {"Hottest place of the film", "Journal temperature", "Oil flow around the film"} <= shown
    rows = {row["label"]: row["value"] for group in chapter["inputs"] for row in group["rows"]}
    assert rows["Bush"] == "outside diameter 100 mm, 45 W/(m K)"
    assert rows["Along the shaft"] == "0.2 W/K"
    assert rows["Nusselt number of the film"] == "1.55 (Pe h/D)^0.3333"
    assert len(chapter["figures"]) == 2


def test_chapter_of_a_groove_shows_both_comparisons(grooved):
    (chapter,) = content(grooved)["bearings"]
    shown = {row["label"] for row in chapter["results"]}
    assert "Outlet without groove at the same gap" in shown
    assert "Outlet without groove under the same load" in shown
    assert any(warning["code"] == "W153" for group in chapter["warnings"] for warning in group["found"])
    (case,) = grooved.problems
    rows = {row.label: row.value for group in inputs(case, SEGMENTS, ()) for row in group.rows}
    assert rows["Groove"] == "at -20° from the load line, 6 mm wide, open at both ends, or fed"


def test_json_holds_the_fields_along_the_film(long_film):
    results = to_json(long_film)["bearings"][0]["results"]
    lengths = {name: len(results[name][0]) for name in ("film_angle", "film_pressure", "film_temperature")}
    assert set(lengths.values()) == {181}
    assert len(results["bush_temperature"][0]) == 180
    split = results["heat_to_oil"] + results["heat_to_surroundings"] + results["heat_to_shaft"]
    assert split == pytest.approx(results["friction_power"], rel=1e-8)


def test_discretisations_side_by_side():
    (found,) = compare_methods(load_case(EXAMPLES / "long_film.yaml"))
    assert [one.label for one in found.variants] == ["long film", "published, mean flow", "published, local flow"]
    consistent, mean, _ = (one.result for one in found.variants)
    assert consistent.flow_inconsistency < 1e-12 < 0.1 < mean.flow_inconsistency


def test_grooves_side_by_side():
    (found,) = compare_methods(load_case(EXAMPLES / "grooved.yaml"))
    by_label = {one.label: one.result for one in found.variants}
    finite = ["film, through groove", "film, blind groove", "film, no groove"]
    assert list(by_label) == ["through groove", "blind groove", "cut in two", "no groove", *finite]
    assert by_label["through groove"].outlet_temperature > by_label["no groove"].outlet_temperature + 30.0
    assert len({round(one.load, 1) for one in by_label.values()}) == 1
    rows = {row.meaning: row.cells for row in compared_rows(found.compared, found.methods)}
    assert set(rows["Groove from the load line with the rotation, θ_gF"]) == {"-20.0", "–"}
    assert len(set(rows["Groove from the widest gap with the rotation, θ_g"])) == 6  # none is alike, two are none


def test_sources_are_cited():
    """Studies that nobody could look up say so."""
    unfound = {
        "long_film": "Long film",
        "grooved": "Heat balance by segments",
        "marine_reverse_gear": "Marine reverse gear",
        "output_wheel_load_share": "Marine reverse gear",
    }
    for name, words in unfound.items():
        cited = citations_of(load_case(EXAMPLES / f"{name}.yaml"))
        assert any(one.startswith(words) and "counts as an assumption" in one for one in cited)
    assert not any("counts as" in one for one in citations_of(load_case(EXAMPLES / "journal.yaml")))


def test_a_limit_of_a_study_that_cannot_be_looked_up_is_an_assumption():
    assert bearing_metal("B83").limiting_temperature.source.startswith("assumption")


def test_the_standard_is_cited_with_its_year():
    assert any("ISO 7902-1:2020" in one for one in citations_of(load_case(EXAMPLES / "journal.yaml")))


@pytest.mark.parametrize(("fields", "source"), [
    ({"turbulence": "ng_pan"}, "Ng, Pan"), ({"turbulence": "constantinescu"}, "Constantinescu"),
    ({"cavitation": "mass_conserving"}, "Jakobsson"),
    ({"thermal": "adiabatic", "cavitation": "mass_conserving", "effective_temperature": None}, "Dowson"),
    ({"bore": {"kind": "wear", "depth": "10 um", "angle": "-90 deg"}}, "Dufrane"),
    ({"pressure_viscosity": {"kind": "barus", "coefficient": "20 1/GPa"}}, "Barus"),
    ({"pressure_viscosity": {"kind": "roelands", "coefficient": "20 1/GPa"}}, "Roelands"),
    ({"compliance": [{"kind": "column", "thickness": "2 mm", "elastic_modulus": "1 GPa", "poisson_ratio": "0.3"}]},
     "Johnson"),
    ({"compliance": [{"kind": "half_space", "elastic_modulus": "200 GPa"}]}, "Johnson"),
    ({"compliance": [{"kind": "ring", "outer_diameter": "260 mm", "elastic_modulus": "200 GPa"}]}, "Timoshenko"),
    ({"mixed_friction": {"composite_roughness": "1 um"}}, "Greenwood"), ({"error_estimate": True}, "Roache"),
])  # fmt: skip
def test_each_law_of_a_film_is_cited_where_it_is_used(fields, source):
    plain = {"cavitation": "reynolds", "effective_temperature": "60 degC"}
    assert not any(source in one for one in citations_of(film_case(**plain)))
    assert any(source in one for one in citations_of(film_case(**plain | fields)))
