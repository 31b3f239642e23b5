"""Figures: drawn for every case, equal for equal input, and true to the numbers they show."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import gear_cases
import numpy as np
import pytest
from hand_made import HandMadeMachine

from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.iso7902 import check
from babbitt.kinds.journal.iso7902.model import Curves, PrescribedEccentricity, PrescribedLoad

pytest.importorskip("matplotlib")

from matplotlib.backends.backend_agg import FigureCanvasAgg

from babbitt.kinds.journal.report import plots as painters
from babbitt.kinds.journal.report.iso7902_figures import ClearanceRange, clearance_range, draw
from babbitt.report.drawing import Drawing, mathematics, style
from babbitt.report.figures import write_plots

CASES = gear_cases.varied_cases()
SUPPOSED = ClearanceRange(0.8e-3, 1.4e-3, given=False)
NAMES = ["speed-and-load", "load-capacity", "clearance", "spans"]


@pytest.mark.parametrize("name", CASES)
def test_every_case_has_its_four_figures(name):
    case = CASES[name]
    drawings = draw(case, check(case), clearance_range(case))
    assert [drawing.name for drawing in drawings] == NAMES
    for drawing in drawings:
        assert isinstance(drawing, Drawing)
        assert ET.fromstring(drawing.image).tag.endswith("svg")
        assert drawing.caption.endswith(".")


def test_figures_of_a_prescribed_temperature_speak_of_no_heat_balance():
    case = replace(CASES["full"], effective_temperature=330.0)
    drawings = draw(case, check(case), clearance_range(case))
    assert [drawing.name for drawing in drawings] == NAMES
    assert "effective temperature prescribed" in drawings[0].caption
    assert "own heat balance" in draw(CASES["full"], check(CASES["full"]), SUPPOSED)[0].caption
    assert not any("heat balance" in drawing.caption for drawing in drawings)


@pytest.mark.solves_anew
def test_equal_input_gives_equal_bytes_in_every_format():
    case = CASES["full"]
    for image_format, magic in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG")):
        first, second = (draw(case, check(case), SUPPOSED, image_format) for _ in range(2))
        assert [d.image for d in first] == [d.image for d in second]
        assert all(d.image.startswith(magic) for d in first)


def test_no_colour_is_used():
    case = CASES["surfaces"]
    for drawing in draw(case, check(case), SUPPOSED, "svg"):
        colours = set(re.findall(rb"#([0-9a-f]{6})", drawing.image))
        assert all(colour[0:2] == colour[2:4] == colour[4:6] for colour in colours), drawing.name


def test_the_curves_pass_through_the_operating_point():
    case = CASES["surfaces"]
    result = check(case)
    with style():
        figure = painters.speed_and_load(case, result)
    friction, film = figure.axes[0], figure.axes[2]
    for panel, name in ((friction, "friction_coefficient"), (film, "minimum_film_thickness")):
        curve, point = panel.lines[0], panel.lines[1]
        x, y = float(point.get_xdata()[0]), float(point.get_ydata()[0])
        assert y == pytest.approx(QUANTITIES[name].shown(result.values[name]))
        on_curve = np.interp(np.log(x), np.log(curve.get_xdata()), np.log(curve.get_ydata()))
        assert np.exp(on_curve) == pytest.approx(y, rel=1e-9)


def test_every_axis_has_a_name_and_a_unit_where_it_needs_one():
    case = CASES["surfaces"]
    result = check(case)
    with style():
        figure = painters.clearance(case, result, SUPPOSED.smallest, SUPPOSED.largest)
    lower = figure.axes[1]
    assert lower.get_xlabel().endswith("in ‰")
    assert lower.get_ylabel().endswith("in µm")
    assert figure.axes[0].get_ylabel().endswith("in °C")


@pytest.mark.parametrize("eccentricity", [0.1, 0.5, 0.708, 0.9, 0.97])
@pytest.mark.parametrize("name", ["full", "arc", "pockets"])
def test_the_label_of_the_load_number_stays_within_the_axes(name, eccentricity):
    case = replace(CASES[name], duty=PrescribedEccentricity(eccentricity))
    result = check(case)
    assert result.outcome.solved
    with style():
        figure = painters.load_capacity(case, result)
        (panel,) = figure.axes
        frame, drawn = panel.get_window_extent(), panel.texts[-1]
        label = drawn.get_window_extent(FigureCanvasAgg(figure).get_renderer())
    assert "ε = " in drawn.get_text()
    assert frame.x0 <= label.x0
    assert label.x1 <= frame.x1
    assert frame.y0 <= label.y0
    assert label.y1 <= frame.y1


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("share", [-0.5, 0.25])
def test_speeds_are_varied_in_the_sense_of_journal_and_bearing(sense, share):
    speed = abs(CASES["full"].journal_speed)
    case = replace(CASES["full"], journal_speed=sense * speed, bearing_speed=share * sense * speed)
    result = check(case)
    swept = painters.speed_sweep(case, result)
    here = int(np.argmin(np.abs(np.abs(swept.points) - speed)))
    assert swept["minimum_film_thickness"][here] == pytest.approx(result.minimum_film_thickness)
    assert np.all(np.sign(swept.points) == sense)
    assert np.all((swept.points + case.bearing_speed) * sense > 0.0)


def test_a_load_beyond_the_film_is_a_gap_and_no_error():
    case = replace(CASES["full"], duty=PrescribedLoad(60e3))
    result = check(case)
    assert result.outcome.solved
    assert len(draw(case, result, SUPPOSED)) == 4


def test_closed_forms_show_the_full_bearing_only():
    case = replace(CASES["full"], curves=Curves.CLOSED_FORM)
    result = check(case)
    with style():
        figure = painters.spans(replace(case, duty=PrescribedLoad(result.load)), result)
    assert [label.get_text() for label in figure.axes[0].get_xticklabels()] == ["360"]
    assert len(draw(case, result, SUPPOSED)) == 4


def test_an_unsolved_bearing_has_no_figures():
    case = replace(CASES["full"], duty=PrescribedLoad(9e7))
    assert draw(case, check(case), SUPPOSED) == ()


def test_the_clearance_range_is_the_tolerance_or_a_supposed_one():
    case = CASES["full"]
    fitted = replace(case, bearing=replace(case.bearing, clearance_tolerance=(0.9e-3, 1.4e-3)))
    assert clearance_range(fitted) == ClearanceRange(0.9e-3, 1.4e-3, given=True)
    supposed = clearance_range(case)
    assert not supposed.given
    assert supposed.smallest == pytest.approx(0.7 * 1.12e-3)
    assert supposed.largest == pytest.approx(1.3 * 1.12e-3)
    assert "±30%" in draw(case, check(case), supposed)[2].caption
    assert "±30%" not in draw(fitted, check(fitted), clearance_range(fitted))[2].caption


def test_matplotlib_is_left_as_it_was():
    import matplotlib

    before = dict(matplotlib.rcParams)
    case = CASES["full"]
    draw(case, check(case), SUPPOSED)
    assert dict(matplotlib.rcParams) == before


@pytest.mark.parametrize("symbol", sorted({quantity.symbol for quantity in QUANTITIES.values()}))
def test_every_symbol_of_the_vocabulary_can_be_drawn(symbol):
    from matplotlib.mathtext import MathTextParser

    MathTextParser("path").parse(mathematics(symbol))


# -- into a folder ------------------------------------------------------------------------------------------------


def machine(*cases):
    return HandMadeMachine("m", tuple(check(case) for case in cases), cases)


def test_plots_are_written_numbered_as_the_bearings(tmp_path):
    folder = tmp_path / "new" / "plots"
    written = write_plots(machine(CASES["full"], CASES["surfaces"]), folder)
    assert [path.name for path in written] == [f"{n:02d}-{name}.svg" for n in (1, 2) for name in NAMES]
    assert sorted(folder.iterdir()) == sorted(written)


def test_a_folder_that_cannot_be_made_is_an_error(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot make the folder") as refused:
        write_plots(machine(CASES["full"]), tmp_path / "file" / "plots")
    assert refused.value.code == "E007"


def test_an_unknown_format_is_refused(tmp_path):
    with pytest.raises(InputError, match="svg, pdf, png"):
        write_plots(machine(CASES["full"]), tmp_path, "jpeg")
