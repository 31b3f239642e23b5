"""ISO 286 tables against the formulas behind them, published examples, and their own order."""

import math
import tomllib
from importlib.resources import files
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.properties.fits import Deviations, standard_tolerance, tolerance_limits

STEPS = [3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500, 630]
"""Upper bounds of the main steps of nominal sizes, mm."""

LETTERS = ["d", "e", "f", "g"]

sizes = st.floats(1e-3, 0.63)


def geometric_means():
    """(upper bound, geometric mean) of each step in mm; the first step counts as 1 to 3 mm."""
    return [(upper, math.sqrt(lower * upper)) for lower, upper in zip([1, *STEPS[:-1]], STEPS, strict=True)]


def micrometres(deviations: Deviations) -> tuple[float, float]:
    return round(deviations.lower * 1e6, 3), round(deviations.upper * 1e6, 3)


@pytest.mark.parametrize(
    ("tolerance_class", "nominal", "lower", "upper"),
    [
        ("H7", 50, 0, 25),
        ("f7", 50, -50, -25),
        ("e8", 100, -126, -72),
        ("E8", 100, 72, 126),  # ISO 286-2:1988/Cor.1:2006: 126, not 125
        ("f9", 300, -186, -56),  # the same corrigendum: 186, not 185
        ("H7", 25, 0, 21),
        ("H7", 250, 0, 46),
        ("d8", 250, -242, -170),
        ("f7", 300, -108, -56),
        ("j6", 60, -7, 12),
        ("j5", 3, -2, 2),
        ("j7", 300, -26, 26),
        ("j8", 3, -6, 8),
        ("g6", 10, -14, -5),
        ("h11", 630, -440, 0),
        ("c11", 50, -290, -130),
        ("c11", 500, -880, -480),
        ("F8", 30, 20, 53),
        ("G7", 80, 10, 40),
        ("D10", 18, 50, 120),
        ("js6", 50, -8, 8),
        ("JS7", 50, -12.5, 12.5),
        ("e7", 600, -215, -145),
    ],
)
def test_published_limit_deviations(tolerance_class, nominal, lower, upper):
    assert micrometres(tolerance_limits(tolerance_class, nominal * 1e-3)) == (lower, upper)


@pytest.mark.parametrize(
    ("grade", "units"), [(5, 7), (6, 10), (7, 16), (8, 25), (9, 40), (10, 64), (11, 100), (12, 160)]
)
def test_standard_tolerances_follow_the_tolerance_unit(grade, units):
    """IT = units * i, i = 0.45 D^(1/3) + 0.001 D um up to 500 mm, I = 0.004 D + 2.1 um above (ISO 286-1).

    The standard rounds generously: up to 5.5 %, and in the first step up to 16 %.
    """
    for upper, size in geometric_means():
        unit = 0.45 * size ** (1 / 3) + 0.001 * size if upper <= 500 else 0.004 * size + 2.1
        tabulated = standard_tolerance(grade, upper * 1e-3) * 1e6
        slack = 0.16 if upper == 3 else 0.055
        assert abs(tabulated - units * unit) <= max(0.75, slack * units * unit), (grade, upper)


@pytest.mark.parametrize("upper", STEPS)
def test_five_grades_coarser_is_ten_times_wider(upper):
    """From IT6 on every fifth grade repeats the figures with one more nought (ISO 286-1).

    One entry is rounded: 75 um of IT11 above 3 mm stands against 8 um of IT6.
    """
    size = upper * 1e-3
    rounding = 5e-6 if upper == 6 else 1e-12
    assert standard_tolerance(11, size) == pytest.approx(10 * standard_tolerance(6, size), abs=rounding)
    assert standard_tolerance(12, size) == pytest.approx(10 * standard_tolerance(7, size))


@pytest.mark.parametrize(
    ("letter", "formula"),
    [
        ("d", lambda size: 16 * size**0.44),
        ("e", lambda size: 11 * size**0.41),
        ("f", lambda size: 5.5 * size**0.41),
        ("g", lambda size: 2.5 * size**0.34),
    ],
)
def test_fundamental_deviations_follow_their_formulas(letter, formula):
    for upper, size in geometric_means():
        tabulated = -tolerance_limits(f"{letter}7", upper * 1e-3).upper * 1e6
        assert abs(tabulated - formula(size)) <= max(1.05, 0.035 * formula(size)), (letter, upper)


def test_fundamental_deviation_c_follows_its_formula_above_40_mm():
    """c = 95 + 0.8 D um with the finer steps (ISO 286-1)."""
    table = tomllib.loads(files("babbitt.properties.fits").joinpath("iso286.toml").read_text())[
        "clearance_letters"
    ]["c"]
    steps = list(zip(table["up_to_mm"], table["up_to_mm"][1:], table["distance"][1:], strict=False))
    above_40 = [(lower, upper, c) for lower, upper, c in steps if lower >= 40]
    assert len(above_40) == 17
    for lower, upper, c in above_40:
        assert c == pytest.approx(95 + 0.8 * math.sqrt(lower * upper), rel=0.03)


def test_every_column_of_the_table_has_its_bounds_and_grows():
    table = tomllib.loads(files("babbitt.properties.fits").joinpath("iso286.toml").read_text())
    grades = table["standard_tolerances"]
    columns = [(grades["up_to_mm"], column) for key, column in grades.items() if key != "up_to_mm"]
    columns += [(entry["up_to_mm"], entry["distance"]) for entry in table["clearance_letters"].values()]
    columns += [(entry["up_to_mm"], entry["distance"]) for entry in table["shaft_j"].values()]
    assert len(columns) == 9 + 6 + 4
    for bounds, values in columns:
        assert len(bounds) == len(values)
        assert all(a < b for a, b in pairwise(bounds))
        assert all(a <= b for a, b in pairwise(values))


@pytest.mark.parametrize("upper", STEPS[:-1])
def test_a_step_includes_its_upper_bound_and_nothing_above(upper):
    size = upper * 1e-3
    at, above = standard_tolerance(9, size), standard_tolerance(9, size + 1e-7)
    assert at < above
    assert standard_tolerance(9, size * (1 + 1e-12)) == at, "round-off must not move a size to the next step"


@given(sizes, st.integers(4, 11))
def test_coarser_grades_are_wider(size, grade):
    assert standard_tolerance(grade, size) < standard_tolerance(grade + 1, size)


@given(sizes, sizes, st.integers(4, 12))
def test_tolerances_grow_with_size(one, other, grade):
    small, large = sorted((one, other))
    assert standard_tolerance(grade, small) <= standard_tolerance(grade, large)


@given(sizes, st.sampled_from([*LETTERS, "h"]), st.integers(4, 12))
def test_hole_mirrors_shaft(size, letter, grade):
    hole, shaft = (
        tolerance_limits(f"{letter.upper()}{grade}", size),
        tolerance_limits(f"{letter}{grade}", size),
    )
    assert (hole.lower, hole.upper) == (-shaft.upper, -shaft.lower)
    assert hole.tolerance == pytest.approx(standard_tolerance(grade, size))


@given(sizes, st.integers(4, 12))
def test_letters_stand_in_order(size, grade):
    """From d to h the shaft comes nearer to the nominal size and reaches it."""
    upper = [tolerance_limits(f"{letter}{grade}", size).upper for letter in (*LETTERS, "h")]
    assert upper == sorted(upper)
    assert upper[-1] == 0.0
    assert len(set(upper)) == len(upper)


@given(sizes, st.integers(4, 12))
def test_js_is_symmetrical(size, grade):
    for letter in ("js", "JS"):
        zone = tolerance_limits(f"{letter}{grade}", size)
        assert zone.lower == -zone.upper


@pytest.mark.parametrize(
    "unknown", ["H3", "H13", "k6", "P7", "J7", "j4", "j9", "Js7", "H", "7", "", "H7.5", "H-7"]
)
def test_unknown_class_names_what_is_allowed(unknown):
    with pytest.raises(InputError) as error:
        tolerance_limits(unknown, 0.05)
    assert error.value.code == "E005"
    assert repr(unknown) in error.value.message
    for allowed in ("C D E F G H JS", "c d e f g h j js", "4 to 12", "explicit deviations"):
        assert allowed in error.value.message


@pytest.mark.parametrize(
    ("tolerance_class", "size"),
    [
        ("H7", 0.0),
        ("H7", -0.05),
        ("H7", 0.6301),
        ("H7", 50.0),
        ("H7", math.nan),
        ("H7", math.inf),
        ("c8", 0.55),
        ("j6", 0.55),
        ("j8", 0.05),
    ],
)
def test_size_outside_the_table(tolerance_class, size):
    with pytest.raises(InputError) as error:
        tolerance_limits(tolerance_class, size)
    assert error.value.code == "E006"
    assert "mm" in error.value.message


def test_unknown_grade():
    with pytest.raises(InputError, match="IT4 to IT12") as error:
        standard_tolerance(3, 0.05)
    assert error.value.code == "E005"


def test_spaces_do_not_matter():
    assert tolerance_limits(" H 7 ", 0.05) == tolerance_limits("H7", 0.05)
