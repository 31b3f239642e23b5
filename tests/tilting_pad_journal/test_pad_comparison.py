"""Tilting pads by every thermal model, and what is assumed of their heat, side by side."""

import re
from dataclasses import replace

import pytest
from pad_journals import HEATED, pad_case, result_of

from babbitt.case import case_from_dict, load_case
from babbitt.core.quantities import QUANTITIES, displayed_in
from babbitt.report.comparison_page import comparison_page
from babbitt.report.comparison_plots import write_comparison_plots
from babbitt.report.comparison_table import print_comparison
from babbitt.study.comparison import compare_methods

GROWING = dict(HEATED["E"], feed="leading_edge_groove", limits={"probe_alarm": "90 degC"})


def comparison_of(**fields):
    """The comparison of one bearing."""
    (found,) = compare_methods(case_from_dict(pad_case(**fields)))
    return found


@pytest.fixture(scope="module")
def growing():
    return comparison_of(**GROWING)


def test_every_thermal_model_is_what_the_case_with_it_finds(growing):
    assert [one.label for one in growing.methods] == [
        "films at 40 °C", "one temperature", "adiabatic films", "full thermal films"
    ]  # fmt: skip
    assert growing.asked.label == "full thermal films"
    plain = {"feed": "leading_edge_groove"}
    for thermal, found in zip(("isothermal", "global", "adiabatic"), growing.methods, strict=False):
        assert found.result.values["minimum_film_thickness"] == pytest.approx(
            result_of(thermal=thermal, **plain).values["minimum_film_thickness"], rel=1e-12
        )
    assert growing.asked.result.values["maximum_temperature"] == pytest.approx(
        result_of(**GROWING).values["maximum_temperature"], abs=1e-9
    )


def test_a_film_takes_the_thinner_the_hotter_its_model_has_it(growing):
    cold, one, *_ = (found.result.values for found in growing.methods)
    assert cold["minimum_film_thickness"] > one["minimum_film_thickness"]
    assert cold["friction_power"] > one["friction_power"]


def test_assumptions_stand_low_base_and_high(growing):
    labels = [one.label for one in growing.choices]
    assert labels == [
        "Carry-over 0.5", "Carry-over 0.9", "Heat transfer on the backs 33.3 W/(m² K)",
        "Heat transfer on the backs 300 W/(m² K)", "Housing 30 °C", "Housing 50 °C",
    ]  # fmt: skip
    base = growing.asked.result.values
    values = {one.label: one.result.values for one in growing.choices}
    hottest = "maximum_temperature"
    assert values["Carry-over 0.5"][hottest] < base[hottest] < values["Carry-over 0.9"][hottest]
    backs = [values[one] for one in labels[2:4]]
    assert backs[0][hottest] > base[hottest] > backs[1][hottest]
    assert backs[0]["heat_to_pads"] < base["heat_to_pads"] < backs[1]["heat_to_pads"]
    clearances = [values["Housing 30 °C"], base, values["Housing 50 °C"]]
    cold, own, warm = (one["running_clearance"] for one in clearances)
    assert own - cold == pytest.approx(12e-6 * 0.070148 * 10.0, rel=0.25)  # warmer pads take some of it back
    assert cold < own < warm
    given = dict(GROWING, walls={"pads": {"conductivity": "50 W/(m K)"}, "housing": {"temperature": "50 degC"}})
    assert warm == pytest.approx(result_of(**given).values["running_clearance"], rel=1e-9)


def test_a_sentence_has_the_numbers_of_the_columns(growing):
    carried, backs, housing = growing.sentences
    assert carried.startswith("Carry-over 0.5, 0.7, 0.9: ")
    assert backs.startswith("Heat transfer on the backs 33.3, 100, 300 W/(m² K): ")
    assert housing.startswith("Housing 30, 40, 50 °C: ")
    low, base, high = map(float, re.search(r"([\d.]+), ([\d.]+), ([\d.]+) °C;", carried).groups())
    runs = (growing.choices[0], growing.asked, growing.choices[1])
    for told, one in zip((low, base, high), runs, strict=True):
        assert told == pytest.approx(one.result.values["maximum_temperature"] - 273.15, abs=0.06)
    page = comparison_page((growing,))
    assert "What assumptions move" in page
    assert carried in page


def test_the_figure_has_film_power_flow_and_temperatures_of_every_model(growing, tmp_path):
    (path,) = write_comparison_plots((growing,), tmp_path)
    assert path.name == "01-methods.svg"
    with displayed_in("us"):
        figure = growing.draw(growing)
    bars = [[bar.get_width() for bar in panel.patches] for panel in figure.axes]
    for lengths, name in zip(bars, ("minimum_film_thickness", "friction_power", "total_flow"), strict=False):
        with displayed_in("us"):
            shown = [QUANTITIES[name].shown(one.result.values[name]) for one in growing.methods]
        assert lengths == pytest.approx(shown)
    names = [tick.get_text() for tick in figure.axes[0].get_yticklabels()]
    assert names == ["films at 104 °F", "one temperature", "adiabatic films", "full thermal films"]
    page = comparison_page((growing,))
    assert "below the figure." in page
    assert "around the bore" not in page
    bare = comparison_page((replace(growing, draw=None),))
    assert "see the notes on each below.</p>" in bare
    assert "figure" not in bare.partition("<body>")[2]


def three_temperatures(said):
    """Of the hottest place: low, base and high."""
    return [*map(float, re.search(r"T_max ([\d.]+), ([\d.]+), ([\d.]+) °", said).groups())]


def test_what_was_told_in_the_si_is_printed_in_us_units(growing, capsys):
    """Each number of a sentence is that of the SI turned, and no unit of the SI is left on screen or page."""
    hottest = three_temperatures(growing.sentences[2])
    with displayed_in("us"):
        print_comparison((growing,))
        page = comparison_page((growing,))
    said = capsys.readouterr().out
    (housing,) = re.findall(r"Housing 86, 104, 122 °F: .*", said)
    assert three_temperatures(housing) == pytest.approx([1.8 * one + 32.0 for one in hottest], abs=0.051)
    assert "films at 104 °F" in said
    for text in (said, re.sub(r"<figure>.*?</figure>", "", page)):
        assert not re.search(r"\d [µk]?(°C|µm|kW|MN/m|kN s/m|W/\(m² K\))", text)


def test_films_of_one_temperature_tell_of_that():
    (carried,) = comparison_of(feed="spray_bar").sentences
    assert carried.startswith("Carry-over 0.6, 0.8, 1: T_eff ")
    assert "–" not in carried


def test_what_does_not_apply_is_not_varied():
    flooded = comparison_of(**HEATED["B"])
    assert [one.label for one in flooded.choices] == ["Carry-over 0.8"]  # no more than all
    assert not comparison_of(thermal="isothermal").choices


def test_films_without_the_temperature_of_fresh_oil_have_one_model():
    alone = comparison_of(supply=None, effective_temperature="50 degC")
    assert [one.label for one in alone.variants] == ["films at 50 °C"]
    assert alone.left_out.count("the temperature of the fresh oil is not given") == 3


def test_a_supply_that_starves_one_model_leaves_that_out():
    """Cold films are thicker and lose more oil by their sides."""
    cold = result_of(thermal="isothermal").values["side_flow"]
    warm = result_of(thermal="global").values["side_flow"]
    assert cold > warm
    between = {"temperature": "40 degC", "flow": f"{6e4 * 0.5 * (cold + warm)} L/min"}
    found = comparison_of(thermal="global", supply=between)
    assert "films at 40 °C" not in [one.label for one in found.variants]
    assert "isothermal is left out: " in found.left_out


def test_every_operating_point_is_compared():
    points = [{"name": "slow", "speed": "1000 rpm"}, {"name": "hot", "supply_temperature": "50 degC"}]
    slow, hot = compare_methods(case_from_dict(pad_case(**HEATED["E"], operating_points=points)))
    assert slow.choices[-1].label == "Housing 50 °C"
    assert hot.choices[-1].label == "Housing 60 °C"
    assert hot.asked.result.values["maximum_temperature"] > slow.asked.result.values["maximum_temperature"]


def test_what_the_theory_tells_of_the_compressor_bearing(request):
    root = request.config.rootpath
    *_, found = compare_methods(load_case(root / "examples" / "compressor_tilting_pads.yaml"))
    hot = [one.result.values["maximum_temperature"] - 273.15 for one in (found.asked, *found.choices)]
    assert [f"{one:.1f}" for one in hot] == ["70.7", "68.2", "71.2", "69.5", "74.0", "68.7"]
    runs = (found.asked, found.choices[0], *found.choices[3:])
    assert [f"{one.result.values['stiffness_yy'] / 1e6:.0f}" for one in runs] == ["428", "408", "532", "374"]
