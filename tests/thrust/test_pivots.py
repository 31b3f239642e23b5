"""Pivots that do not balance are refused when the case is read, with the place at fault; central ones carry."""

import pytest

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.kinds.thrust.thermal_crown import thermal_crown
from babbitt.solving import solve

BASE = template("thrust")
PIVOT = "radius: 290 mm, fraction: 0.60"


def with_pivot(pivot, *changes):
    text = BASE.replace(PIVOT, pivot, 1)
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


@pytest.mark.parametrize(
    ("pivot", "field", "good"),
    [
        ("radius: 340 mm, fraction: 0.60", "radius", "radius: 300 mm, fraction: 0.60"),
        ("radius: 225 mm, fraction: 0.60", "radius", "radius: 275 mm, fraction: 0.60"),
        ("radius: 290 mm, fraction: 0.97", "fraction", "radius: 290 mm, fraction: 0.8"),
    ],
)
def test_a_pivot_that_does_not_balance_is_refused_on_reading_with_the_place_at_fault(pivot, field, good):
    with pytest.raises(InputError, match=rf"pads\.pivot\.{field}: .*no tilt balances.*about .* to ") as refused:
        parse_case(with_pivot(pivot))
    low, high = (float(one) for one in refused.value.message.split("about ")[1].split(" [")[0].replace(
        " mm", "").split(", the")[0].split(" to "))  # fmt: skip
    inside = float(good.split(f"{field}: ")[1].split(",")[0].removesuffix(" mm"))
    assert low < inside < high
    solve(parse_case(with_pivot(good)))


def test_central_pivots_carry_by_the_crown_of_heat():
    """alpha dT B^2/(8 t) with 5 K and B/t = 3: 4 µm for pads of 177.5 mm; a crown that is given is taken."""
    light = (("load: 500 kN", "load: 100 kN"), ("tilt: {offset: 30 um, direction: 0 deg}", "#"))
    found = solve(parse_case(with_pivot("radius: 287 mm, fraction: 0.5", *light))).results[0]
    [notice] = [one for one in found.warnings if one.code == "W214"]
    assert "crown 4.0 µm" in notice.message
    assert found.verdict is Verdict.REMARKS
    assert thermal_crown(0.1775) == pytest.approx(12e-6 * 5.0 * 3.0 * 0.1775 / 8.0)
    given = with_pivot("radius: 287 mm, fraction: 0.5", ("  # crown: 10 um", "  crown: 3.99379 um"), *light)
    same = solve(parse_case(given)).results[0]
    assert "W214" not in [one.code for one in same.warnings]
    assert same.minimum_film_thickness == pytest.approx(found.minimum_film_thickness, rel=1e-4)
    with pytest.raises(InputError, match="no plane pad balances"):
        parse_case(given.replace("crown: 3.99379 um", "crown: 0 um"))
