"""Figures and fields of film bearings: true to the film they show, readable, nothing left behind on failure."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from functools import cache
from pathlib import Path

import film_bearings
import numpy as np
import pytest
from scipy.integrate import simpson

from babbitt.case import load_case
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.film.check import film_solution
from babbitt.kinds.journal.film.field import clearance_outline, field_of, supply_patches
from babbitt.kinds.journal.film.model import Accuracy
from babbitt.kinds.journal.study.locus import locus_over_load, locus_over_speed
from babbitt.kinds.journal.study.stability_map import StabilityMap, stability_map
from babbitt.reynolds.model import Cavitation
from babbitt.solving import MachineResult

pytest.importorskip("matplotlib")

from babbitt.kinds.journal.report import film_curves, film_maps, film_polar, film_stability
from babbitt.kinds.journal.report.film_figures import LEFT_OUT, SLOW, all_figures, report_figures
from babbitt.report.bearing_content import figures_content
from babbitt.report.chapters import chapters
from babbitt.report.drawing import style
from babbitt.report.figures import write_plots

GEAR = Path(__file__).parents[2] / "examples" / "reverse_gear_film.yaml"
LOBES = [{"angle": f"{angle} deg", "extent": "15 deg"} for angle in (90, 210, 330)]
POCKETS = [{"angle": f"{angle} deg", "extent": "20 deg", "width": "90 mm"} for angle in (0, 180)]
REPORTED = ["pressure-map", "pressure-polar", "journal-locus", "coefficients", "stability-map"]
RPM = QUANTITIES["angular_speed"].display.scale
NAMES = ("two", "clockwise", "reynolds", "lobes", "pinion", "tilted")


@cache
def solution(name):
    """A bearing with its film."""
    case = {
        "two": lambda: film_bearings.film(),
        "clockwise": lambda: film_bearings.film(speed="-3000 rpm", load_angle="-60 deg"),
        "reynolds": lambda: replace(film_bearings.film(), cavitation=Cavitation.REYNOLDS),
        "lobes": lambda: film_bearings.film(
            grooves=LOBES, bore={"kind": "lobes", "preload": 0.5}, load="5 kN", speed="-6000 rpm"
        ),
        "pinion": lambda: load_case(GEAR).problems()[2],
        "tilted": lambda: film_bearings.film(
            grooves=None, pockets=POCKETS, misalignment={"x": "0.1 mrad", "y": "0.2 mrad"}
        ),
    }[name]()
    found = film_solution(case)
    assert found.result.outcome.solved, found.result.message
    return found


def bearing(name):
    """Case, result and film of a bearing."""
    found = solution(name)
    return found.problem, found.result, found.state


@cache
def field(name):
    case, _, state = bearing(name)
    return field_of(state.solution, case.load_angle - math.pi)


@cache
def drawn(name):
    return all_figures(solution(name))


# -- the field ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_the_pressure_carries_the_load(name):
    _, _, state = bearing(name)
    found = field(name)
    per_angle = simpson(found.pressure, x=found.z, axis=1) * 0.5 * state.solution.film.diameter
    force = [-np.trapezoid(per_angle * part(found.theta), found.theta) for part in (np.cos, np.sin)]
    assert np.hypot(*(force - state.solution.force)) < 1.5e-3 * state.load


@pytest.mark.parametrize("name", NAMES)
def test_the_field_covers_one_turn_and_closes(name):
    case, _, state = bearing(name)
    found = field(name)
    assert found.theta[0] == pytest.approx(case.load_angle - math.pi)
    assert found.theta[-1] - found.theta[0] == pytest.approx(2.0 * math.pi)
    assert np.all(np.diff(found.theta) > 0.0)
    assert np.allclose(found.pressure[0], found.pressure[-1], atol=1e-3)
    assert found.z[[0, -1]] == pytest.approx([-0.5 * case.bearing.width, 0.5 * case.bearing.width])
    assert found.pressure.min() >= state.solution.film.cavitation_pressure
    assert found.liquid_fraction.min() >= 0.0
    assert found.liquid_fraction.max() == 1.0


@pytest.mark.parametrize("name", NAMES)
def test_extremes_of_the_field_are_those_of_the_result(name):
    _, result, _ = bearing(name)
    found = field(name)
    assert found.pressure.max() == pytest.approx(result.values["maximum_pressure"], rel=0.01)
    assert np.nanmin(found.film_thickness) == pytest.approx(result.values["minimum_film_thickness"], rel=1e-3)


def test_an_aligned_film_is_symmetrical_and_a_tilted_one_is_not():
    for name, even in (("two", True), ("pinion", True), ("tilted", False)):
        found = field(name)
        scale = found.pressure.max()
        assert bool(np.abs(found.pressure - found.pressure[:, ::-1]).max() < 1e-9 * scale) is even, name


def test_pockets_are_held_at_their_pressure_and_have_no_film_thickness():
    _, _, state = bearing("pinion")
    found = field("pinion")
    for patch in supply_patches(state.solution.film):
        middle = 0.5 * sum(patch.theta)
        row = int(np.abs(np.remainder(found.theta - middle + math.pi, 2.0 * math.pi) - math.pi).argmin())
        across = np.abs(found.z) < 0.9 * patch.z[1]
        assert found.pressure[row, across] == pytest.approx(patch.pressure)
        assert np.isnan(found.film_thickness[row, across]).all()
        assert np.isfinite(found.film_thickness[row, [0, -1]]).all()


def test_a_full_film_has_no_void_where_there_is_pressure():
    found = field("two")
    assert (found.liquid_fraction[found.pressure > 0.02 * found.pressure.max()] > 0.995).all()
    assert (found.liquid_fraction < 0.9).any()


def test_the_room_of_the_journal_is_the_clearance_of_a_round_bore():
    _, _, state = bearing("pinion")
    room = clearance_outline(state.solution.film, np.linspace(0.0, 6.0, 25))
    assert room == pytest.approx(state.solution.film.clearance, rel=1e-5)


def test_a_lobed_bore_leaves_the_assembled_clearance_towards_the_middle_of_a_lobe_and_more_between():
    film = bearing("lobes")[2].solution.film
    towards, between = clearance_outline(film, np.radians([270.0, 90.0]))
    assert towards == pytest.approx(film.clearance, rel=1e-4)
    assert between > 1.25 * film.clearance


# -- what is drawn -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_every_bearing_has_all_figures_readable_in_grey(name):
    assert [drawing.name for drawing in drawn(name)] == [*REPORTED[:2], "pressure-surface", *REPORTED[2:]]
    for drawing in drawn(name):
        assert ET.fromstring(drawing.image).tag.endswith("svg")
        assert drawing.caption.endswith(".")
        colours = set(re.findall(rb"#([0-9a-f]{6})", drawing.image))
        assert all(colour[0:2] == colour[2:4] == colour[4:6] for colour in colours), drawing.name


@pytest.mark.solves_anew
def test_equal_input_gives_equal_bytes():
    assert [drawing.image for drawing in all_figures(solution("lobes"))] == [
        drawing.image for drawing in drawn("lobes")
    ]


def test_maps_have_names_units_and_ranges():
    case, _, state = bearing("two")
    with style():
        figure = film_maps.unrolled(case, state.solution, field("two"))
    top, bottom = figure.axes
    assert bottom.get_xlabel().startswith("θ in °")
    assert top.get_ylabel() == bottom.get_ylabel() == "$z$ in mm"
    assert bottom.get_xlim() == pytest.approx((-270.0, 90.0))
    assert bottom.get_ylim() == pytest.approx((-60.0, 60.0))
    said = [text.get_text() for panel in figure.axes for text in panel.texts]
    assert {"pressure in MPa", "film thickness in µm", "ruptured", "load", "rotation →"} <= set(said)
    assert f"{1e6 * state.solution.minimum_film_thickness:.1f}" in said
    assert [bottom.xaxis.get_major_formatter()(angle) for angle in (-225.0, -90.0, 45.0)] == ["135", "270", "45"]
    outlines = [patch for patch in top.patches if patch.get_width() == pytest.approx(20.0)]
    assert len(outlines) == 2


def test_a_groove_over_the_seam_is_drawn_on_both_sides():
    case, _, state = bearing("lobes")
    with style():
        figure = film_maps.unrolled(case, state.solution, field("lobes"))
    middles = sorted(patch.get_x() + 7.5 for patch in figure.axes[0].patches if patch.get_width() < 16.0)
    assert middles == pytest.approx([-270.0, -150.0, -30.0, 90.0])
    assert "← rotation" in [text.get_text() for text in figure.axes[0].texts]


def test_the_polar_figure_says_pressure_load_and_position():
    case, result, state = bearing("clockwise")
    with style():
        figure = film_polar.polar(case, state.solution, field("clockwise"))
    said = [text.get_text() for text in figure.axes[0].texts]
    assert f"{1e-6 * field('clockwise').mid_plane_pressure.max():.3g} MPa" in said
    assert "$F$ = 30 kN" in said
    assert f"$ε$ = {result.values['eccentricity_ratio']:.3f}" in said
    assert f"$β$ = {math.degrees(result.values['attitude_angle']):.1f}°" in said


def test_the_locus_ends_inside_the_bore_and_marks_the_operating_point():
    case, _, state = bearing("two")
    with style():
        figure = film_curves.locus(case, state, locus_over_load(case, state), locus_over_speed(case, state))
    (panel,) = figure.axes
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("$x/c$", "$y/c$")
    room, curve, other, point = panel.lines[0], panel.lines[2], panel.lines[3], panel.lines[-1]
    assert np.hypot(*room.get_data()).min() >= 1.0 - 1e-4
    for line in (curve, other):
        assert np.hypot(*line.get_data()).max() < 1.0
    here = state.solution.position / state.solution.film.clearance
    assert np.ravel(point.get_data()) == pytest.approx(here)


def test_coefficients_pass_through_those_of_the_result():
    case, result, state = bearing("two")
    with style():
        figure = film_curves.coefficients(state, result, locus_over_speed(case, state))
    assert [panel.get_xlabel() for panel in figure.axes] == ["$N$ in rpm", "$N$ in rpm", *2 * ["$\\mathrm{So}$"]]
    assert figure.axes[0].get_ylabel().endswith("in MN/m")
    assert figure.axes[1].get_ylabel().endswith("in kN s/m")
    curve = figure.axes[0].lines[1]  # the first line is zero
    speed = RPM * result.values["angular_speed"] if "angular_speed" in result.values else 3000.0
    assert np.interp(speed, *curve.get_data()) == pytest.approx(1e-6 * result.values["stiffness_xx"], rel=1e-3)
    own = result.values["stiffness_xx"] * state.solution.film.clearance / state.load
    curve = figure.axes[2].lines[1]
    assert np.interp(result.values["sommerfeld_number"], *curve.get_data()) == pytest.approx(own, rel=1e-3)
    named = [text.get_text() for text in figure.axes[0].texts]
    assert all(mark in "".join(named) for mark in ("{xx}", "{xy}", "{yx}", "{yy}"))


@cache
def mapped(name, **changes):
    case, _, state = bearing(name)
    changed = replace(case, **changes)
    with style():
        figure = film_stability.stability(
            changed, state, stability_map(changed, state), locus_over_load(changed, state)
        )
    return figure.axes


def words(panel):
    return [text.get_text() for text in panel.texts]


def test_the_stability_map_marks_the_point_and_names_its_regions():
    left, right = mapped("two")
    _, result, state = bearing("two")
    assert left.get_xlabel().endswith("in kN")
    assert left.get_ylabel() == "$N$ in rpm"
    assert np.ravel(left.lines[-1].get_data()) == pytest.approx([30.0, 3000.0], rel=1e-3)
    assert {"stable", "whirls"} <= set(words(left))
    assert any(text.endswith(" m") for text in words(left))
    assert right.get_xlabel() == "$\\mathrm{So}$"
    assert right.get_ylabel() == "$m\\,c\\,ω^2/F$"
    assert words(right) == ["whirls", "stable"]
    curve, point = right.lines
    number, mass = np.ravel(point.get_data())
    assert number == pytest.approx(state.solution.sommerfeld_number)
    critical = np.interp(number, *curve.get_data())
    assert critical / mass == pytest.approx(result.critical_mass / result.rotor_mass, rel=1e-3)


def test_multiples_of_the_mass_stay_on_the_stable_side_of_the_edge_of_whirl():
    """Beside speeds at which no rotor whirls as well, and where there is no film."""
    loads, speeds = np.array([1e3, 2e3]), np.array([100.0, 200.0, 400.0])
    growth = np.array([[-20.0, -0.1, 5.0], [math.nan, -3.0, 0.0]])
    critical = np.array([[math.inf, 400.0, 60.0], [math.nan, math.inf, 100.0]])
    found = StabilityMap(
        loads, speeds, np.full(2, 100.0), math.inf, growth, np.zeros((2, 3)), critical, points=None
    )
    share = film_stability.whirl_share(found)
    assert share[0].tolist() == pytest.approx([0.0, 0.2, 100.0 / 160.0])
    assert share.mask.tolist() == [[False, False, False], [True, False, False]]
    assert (share >= film_stability.EDGE_OF_WHIRL).filled(False).tolist() == (growth >= 0.0).tolist()
    for row, first in ((0, 0), (1, 1)):
        levels = 1.0 / (1.0 + np.array([10.0, 5.0, 2.0, 1.0]))
        at = np.interp(levels, share[row, first:].tolist(), speeds[first:])
        assert all(np.diff(at) > 0.0)


def test_names_of_curves_stay_inside_their_panel():
    left, _ = mapped("two")
    named = [text for text in left.texts if text.get_text().endswith(" m")]
    assert named
    for text in named:
        across, up = left.transAxes.inverted().transform(left.transData.transform(text.get_position()))
        assert 0.04 < across < 0.96
        assert 0.04 < up < 0.96


def test_an_elastic_shaft_shows_the_rigid_rotor_beside_it():
    _, right = mapped("two", shaft_stiffness=1e8)
    elastic, rigid, _ = right.lines
    assert "rigid" in words(right)
    assert np.interp(0.3, *elastic.get_data()) < 0.6 * np.interp(0.3, *rigid.get_data())


def test_a_map_of_a_rotor_that_never_whirls_has_one_word():
    assert words(mapped("two", rotor_mass=1e-3)[0]) == ["stable"]


def test_names_of_levels_keep_off_edges_and_supplies():
    case, _, state = bearing("pinion")
    found = field("pinion")
    with style():
        figure = film_maps.unrolled(case, state.solution, found)
    half = 1e3 * found.z[-1]
    named = [text for panel in figure.axes for text in panel.texts if re.fullmatch(r"[0-9.]+", text.get_text())]
    assert len(named) > 4
    for text in named:
        x, y = text.get_position()
        assert abs(y) < 0.95 * half
        assert figure.axes[0].get_xlim()[0] < x < figure.axes[0].get_xlim()[1]


# -- where they go -----------------------------------------------------------------------------------------------


def test_the_report_has_the_figures_of_a_film():
    (chapter,) = chapters((solution("two"),))
    figures = figures_content(chapter)
    assert [figure["name"] for figure in figures] == REPORTED
    wide = [figure["name"] for figure in figures if figure["wide"]]
    assert wide == [
        "pressure-map",
        "coefficients",
        "stability-map",
    ]


def test_a_slow_film_says_in_the_report_what_is_left_out(monkeypatch):
    assert solution("tilted").state.solution.pressure.size < SLOW
    monkeypatch.setattr("babbitt.kinds.journal.report.film_figures.SLOW", 10)
    drawings = report_figures(solution("tilted"))
    assert [drawing.name for drawing in drawings] == REPORTED[:2]
    assert drawings[0].caption.endswith(LEFT_OUT)


def machine(*names):
    return MachineResult("m", tuple(map(solution, names)), "0" * 64)


@pytest.mark.usefixtures("no_images")
def test_plots_of_a_film_are_written_numbered_as_the_bearings(tmp_path):
    written = write_plots(machine("two", "pinion"), tmp_path / "plots")
    assert len(written) == 12
    assert written[0].name == "01-pressure-map.svg"
    assert sorted((tmp_path / "plots").iterdir()) == sorted(written)


def test_a_thermal_film_fed_along_one_line_is_drawn(tmp_path):
    found = film_solution(film_bearings.film(grooves=None, span="360 deg", thermal="adiabatic", accuracy="draft"))
    assert found.result.outcome.solved, found.result.message
    (line,) = supply_patches(found.state.solution.film)
    assert line.theta[0] == pytest.approx(line.theta[1])
    shown = field_of(found.state.solution, found.problem.load_angle - math.pi)
    assert np.isfinite(shown.pressure).all()
    written = {path.name for path in write_plots(MachineResult("m", (found,), "0" * 64), tmp_path)}
    assert "01-heat-split.svg" in written


def test_an_unsolved_film_has_no_figures(tmp_path):
    found = film_solution(film_bearings.film(load="90 MN"))
    assert not found.result.outcome.solved
    assert report_figures(found) == all_figures(found) == ()
    assert write_plots(MachineResult("m", (found,), "0" * 64), tmp_path) == ()


def test_a_figure_that_fails_leaves_no_file_and_no_folder(tmp_path, monkeypatch):
    def broken(*_):
        raise ZeroDivisionError

    monkeypatch.setattr(film_maps, "surface", broken)
    with pytest.raises(ZeroDivisionError):
        write_plots(machine("two"), tmp_path / "plots")
    assert list(tmp_path.iterdir()) == []


# -- fields in files ---------------------------------------------------------------------------------------------


@pytest.fixture
def dataset():
    pytest.importorskip("xarray")
    from babbitt.report.fields import fields

    return fields(solution("pinion"))


def test_every_variable_has_a_name_and_a_unit(dataset):
    for name in (*dataset.variables,):
        assert dataset[name].attrs["long_name"], name
        assert dataset[name].attrs["units"], name
    assert dataset["pressure"].dims == ("theta", "z")
    assert dataset["pressure"].attrs["units"] == "Pa"
    assert dataset.attrs["rotation"] == "counter_clockwise"


def test_the_dataset_holds_the_field_and_the_values(dataset):
    _, result, _ = bearing("pinion")
    assert np.array_equal(dataset["pressure"], field("pinion").pressure)
    assert float(dataset["stiffness_xx"]) == result.values["stiffness_xx"]
    assert np.all(np.isnan(dataset["film_thickness"].values) <= (dataset["supply"].values == 1))
    assert "wall_time" not in dataset


def test_fields_survive_the_file(dataset, tmp_path):
    pytest.importorskip("h5netcdf")
    pytest.importorskip("h5py")
    import xarray

    from babbitt.report.fields import write_fields

    write_fields(solution("pinion"), tmp_path / "film.nc")
    with xarray.open_dataset(tmp_path / "film.nc", engine="h5netcdf") as read:
        xarray.testing.assert_identical(read.load(), dataset)
    assert [path.name for path in tmp_path.iterdir()] == ["film.nc"]


@pytest.mark.usefixtures("dataset")
def test_fields_that_cannot_be_written_leave_nothing(tmp_path):
    from babbitt.report.fields import write_fields

    with pytest.raises(InputError, match=r"ends in \.nc"):
        write_fields(solution("two"), tmp_path / "film.csv")
    with pytest.raises(InputError, match="does not exist"):
        write_fields(solution("two"), tmp_path / "none" / "film.nc")
    unsolved = film_solution(film_bearings.film(load="90 MN", accuracy=Accuracy.DRAFT.value))
    with pytest.raises(InputError, match="without an operating point"):
        write_fields(unsolved, tmp_path / "film.nc")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("package", ["xarray", "h5netcdf", "h5py"])
def test_a_missing_extra_is_named(package, tmp_path, monkeypatch):
    pytest.importorskip("xarray")
    import sys

    from babbitt.report.fields import write_fields

    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(InputError, match=r"'\.\[files\]' in a clone"):
        write_fields(solution("two"), tmp_path / "film.nc")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.usefixtures("no_images")
def test_the_orbit_is_drawn_where_there_is_one():
    case = film_bearings.film(dynamic_load={"kind": "rotating", "magnitude": "10 kN"})
    found = film_solution(case)
    result = found.result
    drawn = {drawing.name for drawing in report_figures(found)}
    assert drawn == {*REPORTED, "orbit"}
    from babbitt.kinds.journal.report.film_orbit import orbit

    with style():
        figure = orbit(found.state, result)
    rows = np.array(result.arrays["orbit"])
    thickness = 1e6 * rows[:, 5]
    (panel,) = [axes for axes in figure.axes if "µm" in axes.get_ylabel()]
    shown, filled = panel.lines
    assert filled.get_ydata()[0] == pytest.approx(thickness.min())
    np.testing.assert_allclose(shown.get_ydata()[:-1], thickness)


def test_a_film_without_stiffness_has_no_curves():
    case = film_bearings.film(grooves=None, cavitation="half_sommerfeld", effective_temperature="60 degC")
    drawn = [drawing.name for drawing in report_figures(film_solution(case))]
    assert drawn == ["pressure-map", "pressure-polar"]
