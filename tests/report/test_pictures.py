"""Every kind has a picture, whose words stay within it and never become markup."""

import math

import numpy as np
import pytest
from drawn import Drawn, changed, drawn

from babbitt.core.kind import kinds
from babbitt.report.picture import Handle, Picture

WIDE = 0.55
"""Of a letter over its height, on average."""


@pytest.fixture(scope="module", params=sorted(kinds()))
def of_template(request):
    return drawn(kinds()[request.param].read_template())


def test_every_template_has_a_picture_with_a_name(of_template):
    for solution, picture in of_template:
        assert picture is not None
        assert picture.said.startswith(solution.result.name)
        assert picture.shapes


def test_shapes_and_words_stay_within_their_picture(of_template):
    for _, picture in of_template:
        for shape in picture.shapes:
            low, high = shape.points.min(axis=0), shape.points.max(axis=0)
            if shape.tag == "circle":
                low, high = low - shape.size, high + shape.size
            if shape.tag == "text":
                wide = WIDE * shape.size * len(shape.words)
                before = {"start": 0.0, "middle": 0.5, "end": 1.0}[shape.given["text-anchor"]]
                low = low - np.array([before * wide, 0.4 * shape.size])
                high = high + np.array([(1.0 - before) * wide, 0.4 * shape.size])
            assert (low >= picture.low - 1e-3).all(), shape
            assert (high <= picture.high + 1e-3).all(), shape


def test_words_are_moved_into_their_picture():
    picture = Picture(1.0, "a")
    picture.text_within(-0.97, 0.99, "8.31 kN")
    picture.text_within(0.2, 0.1, "8.31 kN")
    moved, kept = Drawn(picture.svg()).of("label", "text")
    half = 0.5 * WIDE * moved.size * len("8.31 kN")
    assert moved.points[0][0] - half >= -1.0
    assert moved.points[0][1] + 0.5 * moved.size <= 1.0
    assert kept.points[0] == pytest.approx([0.2, 0.1])


def test_loads_of_pads_lie_within_their_picture():
    """The load of a pad to the left of the bearing stood beyond the edge."""
    ((_, picture),) = drawn(changed("tilting_pad_journal", load="0.5 kN", pads__first_pivot="0 deg"))
    said = picture.of("label", "text")
    assert sum("kN" in shape.words or " N" in shape.words for shape in said) >= 5
    for shape in said:
        assert abs(shape.points[0][0]) + 0.5 * WIDE * shape.size * len(shape.words) <= picture.high[0]


def test_letters_can_be_read_on_a_narrow_page(of_template):
    """390 px less margins for the width of the picture: letters of at least 9 px."""
    for _, picture in of_template:
        wide = picture.high[0] - picture.low[0]
        assert min(shape.size for shape in picture.shapes if shape.tag == "text") > 9.0 / 366.0 * wide


@pytest.mark.parametrize(
    "kind", ["thrust", "hydrostatic_pad", "jacking_pocket", "screw_heel", "overhung_coupling"]
)
def test_names_stay_words(kind):
    name = "<script>alert(1)</script>"
    template = kinds()[kind].read_template()
    own = next(line for line in template.splitlines() if line.startswith("name: "))
    for solution, picture in drawn(template.replace(own, f"name: '{name}'")):
        assert solution.result.name.startswith(name)
        assert picture.said.startswith(name)
        assert not list(picture.root.iter("{http://www.w3.org/2000/svg}script"))


def test_names_of_what_stands_on_a_shaft_stay_words():
    template = kinds()["shaft"].read_template().replace("name: Wheel", "name: '<script>a</script>'")
    picture = drawn(template)[0][1]
    assert any(word.startswith("<script>a</script>") for word in picture.words())
    assert not list(picture.root.iter("{http://www.w3.org/2000/svg}script"))


def test_a_part_has_lengths_and_letters_of_its_own():
    """A part at (1, 2) whose units are 5 of the whole: 0.2 there is 1 here, and letters are equally high."""
    picture = Picture(4.0, "two")
    part = picture.part(1.0, 2.0, 5.0)
    part.circle(0.2, -0.2, 0.1, "pivot")
    part.text(0.0, 0.0, "inside")
    picture.text(0.0, 0.0, "outside")
    found = Drawn(picture.svg())
    circle = found.of("pivot", "circle")[0]
    assert circle.points[0] == pytest.approx((2.0, 1.0))
    assert circle.size == pytest.approx(0.5)
    inside, outside = found.of("label", "text")
    assert inside.points[0] == pytest.approx((1.0, 2.0))
    assert inside.size == pytest.approx(outside.size)


def test_shades_begin_where_a_field_passes_their_share():
    """Of p = x over the unit square, shades above shares of 1 cover rectangles from x = share on."""
    picture = Picture(1.0, "shades")
    x, y = np.meshgrid(np.linspace(0.0, 1.0, 11), np.linspace(0.0, 1.0, 7), indexing="ij")
    picture.bands(x, y, x, 1.0)
    shades = Drawn(picture.svg()).of("shade")
    assert [float(one.points[:, 0].min()) for one in shades] == pytest.approx([0.02, 0.2, 0.4, 0.6, 0.8])
    assert [float(one.points[:, 0].max()) for one in shades] == pytest.approx([1.0] * 5)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_turning_arrow_turns_in_its_sense(sense):
    picture = Picture(1.0, "turn")
    picture.turning(0.1, 0.2, 0.5, 0.7, sense, "rotation")
    (line,) = Drawn(picture.svg()).of("rotation line")
    about = np.unwrap(np.arctan2(line.points[:, 1] - 0.2, line.points[:, 0] - 0.1))
    assert np.sign(np.diff(about)) == pytest.approx(np.full(about.size - 1, sense))
    assert about.mean() == pytest.approx(0.7, abs=1e-4)


@pytest.mark.parametrize("angle", [-1.2, 0.3])
def test_a_load_points_along_its_direction(angle):
    picture = Picture(1.5, "load")
    picture.load(angle, 2e3, 0.0, Handle("load_angle", angle))
    found = Drawn(picture.svg())
    line = next(one for one in found.shapes if one.style == "load line handle")
    x, y = line.points[-1] - line.points[0]
    assert math.atan2(y, x) == pytest.approx(angle, abs=1e-4)
    assert "2.00 kN" in found.words()
    assert not [one for one in found.shapes if one.style.startswith("rotation")]


def test_the_head_of_a_short_arrow_is_no_longer_than_it():
    picture = Picture(1.0, "short")
    picture.arrow((0.0, 0.0), (0.01, 0.0), "flow")
    (head,) = Drawn(picture.svg()).of("flow head")
    assert np.ptp(head.points[:, 0]) < 0.01
