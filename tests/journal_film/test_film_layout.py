"""Where the film is fed: what a case says, and the rule for bearings described for the standard."""

import math

import pytest
from film_bearings import answer, case, film

from babbitt.case import CaseError
from babbitt.kinds.journal.film.layout import film_of
from babbitt.reynolds.model import FilmStart


def angles(case):
    return [round(math.degrees(math.remainder(feed.angle, 2.0 * math.pi)), 9) for feed in case.bearing.feeds]


def by_rule(**given):
    return film(grooves=None, **given)


@pytest.mark.parametrize(("speed", "sense"), [("3000 rpm", 1.0), ("-3000 rpm", -1.0)])
def test_uneven_pockets_stand_where_they_are(speed, sense):
    element = {
        "kind": "uneven_pockets",
        "width": "80 mm",
        "entry_angle": "75 deg",
        "exit_angle": "104 deg",
        "extent": "20 deg",
    }
    case = by_rule(supply_element=element, load_angle="0 deg", speed=speed)
    assert angles(case) == [-75.0 * sense, 104.0 * sense]  # the entry side lies before the load
    assert all(feed.width == pytest.approx(0.08) for feed in case.bearing.feeds)
    assert any("true angles" in said for said in case.assumptions)


def test_pockets_begin_where_the_arc_ends():
    element = {"kind": "pocket", "width": "80 mm", "place": "both_sides"}
    case = by_rule(supply_element=element, span="150 deg")
    first, second = case.bearing.feeds
    assert first.angle + first.extent / 2.0 == pytest.approx(math.radians(-90.0 - 75.0))
    assert second.angle - second.extent / 2.0 == pytest.approx(math.radians(-90.0 + 75.0))
    assert math.degrees(first.extent) == pytest.approx(20.0)
    wide = by_rule(supply_element=element | {"extent": "30 deg"}, span="150 deg")
    assert math.degrees(wide.bearing.feeds[0].extent) == pytest.approx(30.0)


@pytest.mark.parametrize(("kind", "around"), [("groove_180", 180.0), ("groove_360", 360.0)])
def test_circumferential_grooves_are_pockets(kind, around):
    (groove,) = by_rule(supply_element={"kind": kind, "width": "8 mm"}, span="180 deg").bearing.feeds
    assert math.degrees(groove.extent) == pytest.approx(around)
    assert math.degrees(groove.angle) == pytest.approx(90.0)
    assert groove.width == pytest.approx(0.008)


def test_holes_share_the_width_and_keep_their_area():
    element = {"kind": "hole", "diameter": "10 mm", "place": "opposite", "number": 3}
    holes = by_rule(supply_element=element, span="360 deg").bearing.feeds
    assert [round(1e3 * hole.axial_position, 9) for hole in holes] == [-40.0, 0.0, 40.0]
    assert all(hole.width * hole.extent * 0.1 == pytest.approx(math.pi / 4.0 * 0.01**2) for hole in holes)


@pytest.mark.parametrize(
    ("place", "where"), [("opposite", [90.0]), ("side", [180.0]), ("both_sides", [180.0, 0.0])]
)
def test_places_are_seen_from_the_load(place, where):
    element = {"kind": "pocket", "width": "80 mm", "place": place}
    assert [abs(angle) for angle in angles(by_rule(supply_element=element, span="360 deg"))] == where


HOLE = {"kind": "hole", "diameter": "10 mm", "place": "opposite"}
SLOT = {"kind": "slot", "length": "60 mm", "width": "8 mm", "place": "opposite"}
POCKET = {"kind": "pocket", "width": "80 mm", "place": "opposite"}


def codes(case):
    return [warning.code for warning in case.warnings]


@pytest.mark.parametrize("element", [HOLE, SLOT, POCKET, HOLE | {"place": "side"}])
@pytest.mark.parametrize("span", ["90 deg", "180 deg"])
def test_an_element_stands_at_its_place_whatever_the_span(element, span):
    around, arc = (by_rule(supply_element=element, span=one) for one in ("360 deg", span))
    assert arc.bearing.feeds == around.bearing.feeds
    assert "W183" in codes(arc)
    assert "W183" not in codes(around)


def test_holes_at_both_sides_begin_where_the_arc_ends():
    case = by_rule(supply_element=HOLE | {"place": "both_sides"}, span="150 deg")
    first, second = case.bearing.feeds
    assert first.angle + first.extent / 2.0 == pytest.approx(math.radians(-90.0 - 75.0))
    assert second.angle - second.extent / 2.0 == pytest.approx(math.radians(-90.0 + 75.0))
    assert codes(case) == []


def test_the_film_of_an_arc_fed_by_a_hole_is_as_hot_as_that_hole_leaves_it():
    fed = {"cavitation": "mass_conserving", "accuracy": "draft", "load": "15 kN"}
    around, arc = (answer(grooves=None, supply_element=HOLE, span=one, **fed) for one in ("360 deg", "180 deg"))
    assert arc.values["outlet_temperature"] == pytest.approx(around.values["outlet_temperature"])
    flooded = answer(grooves=None, span="180 deg", **fed)
    assert flooded.values["outlet_temperature"] < arc.values["outlet_temperature"] - 5.0
    assert "W184" in [warning.code for warning in flooded.warnings]


@pytest.mark.parametrize("span", ["360 deg", "150 deg"])
def test_lines_of_supply_that_stand_for_nothing_given_are_told(span):
    assert codes(by_rule(span=span)) == ["W184"]


def test_a_film_that_starts_where_nothing_feeds_it_is_questioned():
    started = film(film_start="widest_gap", cavitation="reynolds", grooves=None, supply_element=HOLE)
    assert codes(started) == ["W183", "W184"]
    assert "film_start: widest_gap" in started.warnings[1].message


def test_what_the_film_does_not_read_beside_its_hollows_is_told():
    (warning,) = film(supply_element=HOLE, span="180 deg").warnings
    assert warning.code == "W183"
    assert warning.message.startswith("supply_element, span: ")
    points = [{"name": "a"}, {"name": "b", "supply_element": SLOT, "span": "120 deg"}]
    first, second = case(operating_points=points).problems()
    assert first.warnings == ()
    assert second.warnings[0].message.startswith("operating_points[1].supply_element, operating_points[1].span: ")
    assert codes(film()) == []


def test_the_standard_tells_what_it_does_not_read():
    (design,) = case(method="iso7902", span="360 deg", supply_element=HOLE).problems()
    (warning,) = design.warnings
    assert (warning.code, warning.message.split(":")[0]) == ("W183", "grooves")


def test_an_arc_without_element_ends_at_lines_of_supply():
    case = by_rule(span="120 deg")
    assert sorted(angles(case)) == [-150.0, -30.0]
    made = film_of(case, 1.5e-3, 0.02, 2e5)
    assert made.film_start is FilmStart.GROOVE
    extents = sorted(round(math.degrees(land.end_angle - land.start_angle), 6) for land in made.lands)
    assert extents == [120.0, 240.0]
    assert all(land.start_pressure == land.end_pressure == 2e5 for land in made.lands)


def test_own_pressures_replace_that_of_the_supply():
    vented = {"angle": "0 deg", "extent": "20 deg", "pressure": "0 Pa"}
    fed = {"angle": "180 deg", "extent": "20 deg"}
    made = film_of(film(grooves=[vented, fed]), 1.5e-3, 0.02, 2e5)
    upper, lower = made.lands
    assert (upper.start_pressure, upper.end_pressure) == (0.0, 2e5)
    assert (lower.start_pressure, lower.end_pressure) == (2e5, 0.0)


def test_pockets_without_grooves_close_the_ring():
    case = film(grooves=None, pockets=[{"angle": "90 deg", "extent": "30 deg", "width": "60 mm"}])
    made = film_of(case, 1.5e-3, 0.02, 2e5)
    assert made.film_start is FilmStart.PERIODIC
    assert made.pockets[0].pressure == 2e5
    assert made.angular_speed > 0.0
    assert film_of(film(speed="-3000 rpm"), 1.5e-3, 0.02, 0.0).angular_speed < 0.0


def test_own_hollows_replace_the_element():
    element = {"kind": "hole", "diameter": "10 mm", "place": "opposite"}
    assert film(supply_element=element, span="360 deg").bearing.feeds == film().bearing.feeds


def test_a_slot_lies_along_the_shaft():
    (feed,) = by_rule(supply_element=SLOT, span="360 deg").bearing.feeds
    assert feed.width == pytest.approx(0.060)
    for length, width in (("96 mm", "80 mm"), ("80 mm", "80 mm")):
        with pytest.raises(CaseError, match="one around the bore is a pocket"):
            by_rule(supply_element=SLOT | {"length": length}, width=width, span="360 deg")
