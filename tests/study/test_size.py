"""Permitted intervals of a field: ends, gaps, choices, and what is refused."""

import json
import math
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import babbitt as bb
from babbitt.case import case_from_dict, load_case
from babbitt.core.notices import InputError
from babbitt.core.quantities import displayed_in
from babbitt.report.size_output import size_json
from babbitt.report.size_table import rounded
from babbitt.study.corners import leaves_out_limits
from babbitt.study.permitted import TOLERANCE, Trial, find_permitted
from babbitt.study.size import scan_of
from babbitt.study.size_choices import preferred_numbers, standard_choices

STEPS = [float(value) for value in range(1, 21)]


@pytest.fixture(scope="module")
def bearing():
    return bb.parse_case(bb.template("journal")).replace(clearance="H7/e7")


@pytest.fixture(scope="module")
def by_load(bearing):
    return bearing.size("load", within=("0.5 kN", "100 kN"))


def by_margin(margin):
    def tried(value):
        found = margin(value)
        return Trial(value, found >= 0.0, found, "C1")

    return tried


def scanned(tried):
    """A scan of the steps, and its permitted intervals; every value is tried once."""
    known = {}

    def once(value):
        if value not in known:
            known[value] = tried(value)
        return known[value]

    scan = [once(value) for value in STEPS]
    return scan, find_permitted(scan, once)


@given(st.lists(st.floats(1.2, 19.8), min_size=2, max_size=6, unique=True))
def test_every_end_is_bracketed_between_what_passes_and_what_does_not(roots):
    def margin(value):
        return math.prod(value - root for root in roots) / 20.0 ** len(roots)

    scan, intervals = scanned(by_margin(margin))
    for one in intervals:
        for inside, outside in ((one.lower, one.below), (one.upper, one.above)):
            assert margin(inside.value) >= 0.0
            if outside is None:
                assert inside.value in (STEPS[0], STEPS[-1])
                continue
            assert margin(outside.value) < 0.0
            assert abs(outside.value - inside.value) <= 1.01 * TOLERANCE * outside.value
            assert min(abs(inside.value - root) for root in roots) <= 1.01 * TOLERANCE * outside.value
    passing = {one.value for one in scan if one.permitted}
    assert passing == {
        value for value in STEPS for one in intervals if one.lower.value <= value <= one.upper.value
    }


def test_an_interval_that_ends_where_nothing_has_a_margin_is_halved_to_its_end():
    def tried(value):
        return Trial(value, True, 0.5, "C1") if 3.3 < value < 7.7 else Trial(value, False, math.nan, "S001")

    _, (found,) = scanned(tried)
    assert found.lower.value == pytest.approx(3.3, rel=TOLERANCE)
    assert found.upper.value == pytest.approx(7.7, rel=TOLERANCE)
    assert (found.below.code, found.above.code) == ("S001", "S001")


def test_nothing_is_permitted_where_every_value_fails():
    scan, intervals = scanned(by_margin(lambda value: -1.0 - abs(value - 5.0)))
    assert not intervals
    assert max(scan, key=lambda one: one.margin).value == 5.0


@pytest.mark.parametrize(
    ("first", "last", "points"), [(2.0, 1.0, 4), (1.0, 1.0, 4), (1.0, 2.0, 1), (1.0, 2.0, 5000)]
)
def test_a_scan_that_is_none_is_refused(bearing, first, last, points):
    with pytest.raises(InputError, match=r"range|scan"):
        scan_of(bearing, "load", f"{first} kN", f"{last} kN", points)


def test_wide_scans_have_equal_ratios_and_others_equal_distances(bearing):
    assert scan_of(bearing, "load", "1 kN", "100 kN", 3).log_range is not None
    assert scan_of(bearing, "load", "1 kN", "3 kN", 3).range is not None
    assert scan_of(bearing, "load").log_range == ("1200.0 N", "120000.0 N", 64)


def test_the_load_of_the_specific_load_is_its_algebraic_root(bearing):
    ((found,)) = (bearing.size("load", limits="C103").intervals[0],)
    limit = next(one.limit for one in bearing.solve().result.checks if one.code == "C103")
    exact = limit * bearing.diameter * bearing.width
    assert found.upper.value <= exact * (1.0 + 1e-9)
    assert found.upper.value == pytest.approx(exact, rel=TOLERANCE)


def test_a_set_with_a_gap_gives_both_intervals(by_load):
    first, second = by_load.intervals
    assert first.above.code == second.below.code == "C104"
    assert first.below is not None
    assert second.above.code == "C103"
    assert first.upper.value < second.lower.value


def test_each_end_is_that_of_the_file_with_the_value_in_it(bearing, by_load):
    for one in by_load.intervals:
        for end in (one.lower, one.below, one.upper, one.above):
            result = bearing.solve(load=end.value).result
            assert result.within_limits == end.permitted
            assert result.margin == pytest.approx(end.margin, abs=1e-9)
            assert result.governing_check.code == end.code


def test_a_range_in_which_nothing_passes_names_the_nearest_miss(bearing):
    found = bearing.size("load", within=("40 kN", "60 kN"), points=5)
    assert not found.intervals
    assert found.nearest_miss.value == 40e3
    study = bearing.study("size", {"load": {"range": ["40 kN", "60 kN", 5]}})
    assert "No value of the scan is within all limits" in study.summary()
    assert "C103" in study.summary()


def test_a_size_is_a_study_that_is_kept_and_answers_alike(bearing, by_load, tmp_path):
    vary = {"load": {"log_range": ["0.5 kN", "100 kN", 64]}}
    stored = bearing.study("size", vary, out=tmp_path / "a.study")
    opened = bb.open_study(tmp_path / "a.study")
    assert stored.answer == opened.answer
    assert [one.upper.value for one in opened.answer.intervals] == [one.upper.value for one in by_load.intervals]
    for one in opened.answer.intervals:
        place = (opened.table["load"] == one.lower.value).argmax()
        assert opened.case(int(opened.table["row"][place])).solve().result.within_limits


def test_a_row_of_any_study_and_of_a_size_has_one_verdict_and_margin(bearing):
    over = {"load": {"range": ["1 kN", "60 kN", 6]}}
    plain, sized = bearing.study("sweep", over).table, bearing.study("size", over).table[:6]
    for name in ("margin", "verdict", "governing_check", "failed_checks"):
        assert list(plain[name]) == list(sized[name])


def test_the_worst_clearance_decides_over_the_tolerance(bearing):
    mean = bearing.size("load", limits="C101").intervals[-1]
    band = bearing.size("load", limits="C101", over_tolerance=True).intervals[-1]
    assert band.upper.value < mean.upper.value
    assert "clearance" in band.above.bearing


def test_limits_at_the_mean_of_a_fit_say_so_where_not_all_are_asked_for(bearing):
    """All limits are held at the limits of the clearance, too (W174); a single one is not."""
    fit = bearing.replace(clearance="H7/e8", clearance_cases="mean")
    asked = {"within": ("8 kN", "20 kN"), "points": 3}
    alone, every, over, fixed = (
        fit.size("load", limits="C104", **asked),
        fit.size("load", **asked),
        fit.size("load", limits="C104", over_tolerance=True, **asked),
        bearing.replace(clearance={"kind": "radial", "mean": "60 um"}).size("load", limits="C104", **asked),
    )
    assert [one.at_mean for one in (alone, every, over, fixed)] == [True, False, False, False]


def test_recommendations_count_only_where_asked_for(bearing):
    recommended = bearing.size("width", limits="recommended", points=16)
    every = bearing.size("width", points=16)
    assert len([one for one in recommended.scan if one.permitted]) < len(
        [one for one in every.scan if one.permitted]
    )


def test_a_temperature_needs_its_range_and_a_path_its_field(bearing):
    for path in ("supply.temperature", "span", "nothing", "materials.bearing_metal"):
        with pytest.raises(bb.CaseError):
            bearing.size(path)
    with pytest.raises(InputError, match="C999"):
        bearing.size("load", limits="C999", points=3)


def test_other_units_give_the_same_ends(bearing):
    newtons, kilonewtons = (
        bearing.size("load", within=ends, points=9) for ends in [(2e3, 6e4), ("2 kN", "60 kN")]
    )
    assert [one.upper.value for one in newtons.intervals] == [one.upper.value for one in kilonewtons.intervals]


def test_choices_are_held_against_the_same_limits(bearing):
    found = bearing.size("lubricant")
    assert tuple(found.choices) == standard_choices("lubricant")
    for oil, one in found.choices.items():
        assert bearing.solve(lubricant=oil).result.within_limits == one.permitted
    assert {one.permitted for one in found.choices.values()} == {True, False}


@pytest.mark.parametrize("within", [None, (3e-4, 5e-3)])
def test_a_number_without_unit_is_scanned(bearing, within):
    relative = bearing.replace(clearance={"kind": "relative", "mean": "1.6 permille"})
    (found,) = relative.size("clearance.mean", within=within, points=9).intervals
    assert found.lower.value < 1.6e-3 < found.upper.value


def test_a_share_of_all_speeds_is_sized_as_the_speed(bearing):
    """`*.speed` scans a decade to each side of what the case has; its ends are those of the speed itself."""
    speed = bearing.speed
    share = bearing.size("*.speed", within=(0.01, 1.0), limits=["C111"])
    alone = bearing.size("speed", within=(0.01 * speed, speed), limits=["C111"])
    assert (share.present, share.unit) == (1.0, "")
    assert scan_of(bearing, "*.speed").log_range[:2] == ("0.1", "10.0")
    (one,), (other,) = share.intervals, alone.intervals
    assert 0.01 < one.lower.value < 1.0
    assert one.lower.value * speed == pytest.approx(other.lower.value, rel=2.0 * TOLERANCE)
    with pytest.raises(InputError, match=r"names nothing that is varied everywhere; there are: \*\.speed"):
        bearing.size("*.width")


@pytest.mark.parametrize("clearance", ["H7/d8", {"kind": "fit", "bore": "H7", "journal": "d8"}])
def test_classes_of_a_fit_are_choices(bearing, clearance):
    fitted = bearing.replace(clearance=clearance)
    found = fitted.size("clearance.journal")
    assert tuple(found.choices) == standard_choices("clearance.journal")
    for journal in ("e6", "d8"):
        assert (
            fitted.solve({"clearance": f"H7/{journal}"}).result.within_limits == found.choices[journal].permitted
        )


def test_preferred_numbers_lie_within(by_load):
    numbers = preferred_numbers(by_load.intervals, "N")
    assert {1000.0, 1120.0, 35500.0} <= set(numbers)
    assert not any(1540.0 < number < 1660.0 or number > 36e3 for number in numbers)


def test_ends_are_rounded_into_the_interval():
    assert (rounded(46.4199, upward=False), rounded(46.4101, upward=True)) == ("46.41", "46.42")


def test_speeds_are_round_in_rpm(bearing):
    found = bearing.study("size", {"speed": {"range": ["1000 rpm", "3000 rpm", 5]}}, preferred=True).answer
    rpm = [one.value * 30.0 / math.pi for one in found.preferred]
    assert rpm == pytest.approx([1000, 1120, 1250, 1400, 1600, 1800, 2000, 2240, 2500, 2800])


def test_the_record_holds_the_intervals(by_load):
    record = json.loads(size_json(by_load))
    assert [one["from"] for one in record["intervals"]] == [one.lower.value for one in by_load.intervals]
    assert len(record["scan"]) == 64


def test_the_command_tells_intervals_and_writes_them(run, tmp_path):
    run("new", "journal", "-o", "pump.yaml")
    status, out, _ = run(
        "size", "pump.yaml", "load", "--points", "20", "--preferred", "--json", "s.json", "--plots", "figures"
    )
    assert status == 0
    assert "C103" in out
    assert "1000 N" in out or "1 kN" in out
    assert (tmp_path / "s.json").is_file()
    assert (tmp_path / "figures" / "size.svg").is_file()
    status, out, _ = run("size", "pump.yaml", "lubricant", "--among", "ISO VG 46, ISO VG 10")
    assert status == 0
    assert "yes" in out


@pytest.mark.parametrize(
    "arguments",
    [
        ("load", "--from", "10 mm"),
        ("load", "--from", "5 kN", "--to", "1 kN"),
        ("supply.temperature",),
        ("nothing.here",),
        ("load", "--limits", "C999", "--points", "3"),
        ("load", "--points", "1"),
        ("load", "--report", "s.doc"),
    ],
)
def test_bad_input_is_one_message(run, tmp_path, arguments):
    run("new", "journal", "-o", "pump.yaml")
    status, out, err = run("size", "pump.yaml", *arguments)
    assert status == 2
    assert not out
    assert "E0" in err
    assert [path.name for path in tmp_path.iterdir()] == ["pump.yaml"]


def test_reasons_are_told_in_us_units(bearing):
    """They were composed in SI when the rows were solved."""
    study = bearing.study("size", {"load": {"log_range": ["1 kN", "9000 kN", 8]}})
    with displayed_in("us"):
        said = study.summary()
    assert " psi > " in said
    assert "less than the load of" in said
    for unit in (" kN", " MPa", " °C"):
        assert unit not in said


def test_what_is_refused_is_told_in_everyday_units(bearing):
    with pytest.raises(InputError, match=r"begins at 500 kN and ends at 120 kN; give a larger end"):
        bearing.size("load", within=("500 kN", None))
    with pytest.raises(InputError, match=r"with supply.flow: 0.5 L/min: .*given together with pressure"):
        bearing.size("supply.flow", within=("0.5 L/min", "8 L/min"), points=3)
    with pytest.raises(InputError, match=r"there are: babbitt, .* more \(`babbitt schema` lists them\)"):
        bearing.size("qqq")


def test_a_width_that_is_refused_is_told_with_the_digits_that_pass_its_limit(bearing):
    """B/D 1.5 was refused where 0.1 to 1.5 are allowed; the reason began with a colon for want of a bearing."""
    study = bearing.study("size", {"width": {"range": ["60 mm", "180.01 mm", 5]}})
    said = " ".join(study.summary().split())
    assert "for a bearing of B/D 1.5001; allowed" in said
    assert " : " not in said


def test_a_quantity_in_many_places_is_told_by_their_number():
    gear = bb.load_case("examples/marine_reverse_gear.yaml")
    assert (
        "Share of speed in 11 places of the case"
        in gear.study("size", {"*.speed": {"range": [0.9, 1.0, 2]}}).summary()
    )


def test_the_fit_of_the_case_is_among_those_that_are_tried(bearing):
    own = bearing.replace(clearance="H7/c8")
    assert list(own.size("clearance.journal").choices)[:2] == ["c8", "g6"]
    assert "e7" in bearing.size("clearance.journal").choices
    assert list(own.size("clearance.bore").choices).count("H7") == 1


@pytest.mark.parametrize(
    ("shared", "of_a", "of_b", "at_mean"),
    [("mean", None, "H7/e8", True), ("mean", None, None, True), ("all", "mean", "H7/e8", True),
     ("all", None, "H7/e8", False)],
)  # fmt: skip
def test_limits_at_the_mean_are_told_of_a_machine_whose_bearings_differ(bearing, shared, of_a, of_b, at_mean):
    """Of bearings without limits nothing is left out; a bearing may ask for the mean by itself."""
    one = {
        "kind": "journal", "diameter": "120 mm", "width": "80 mm", "load": "12 kN", "speed": "1500 rpm",
        "span": "360 deg", "supply_element": {"kind": "pocket", "width": "56 mm", "place": "opposite"},
    }  # fmt: skip
    bare = {"kind": "diametral", "mean": "110 um"}
    a = one | {"name": "A", "clearance": "H7/e8"} | ({"clearance_cases": of_a} if of_a else {})
    case = case_from_dict({
        "kind": "machine", "name": "Gear", "lubricant": "ISO VG 46", "clearance_cases": shared,
        "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
        "materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"},
        "bearings": [a, one | {"name": "B", "clearance": of_b or bare}],
    })  # fmt: skip
    assert leaves_out_limits(case) is at_mean


def test_supports_of_a_shaft_have_no_clearance_whose_limits_are_left_out():
    case = load_case(Path(__file__).parents[2].joinpath("examples", "helical_gear_shaft.yaml"))
    assert not leaves_out_limits(case)
