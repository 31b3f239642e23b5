"""A shaft line from case to result: values, verdicts, warnings, answers in sentences."""

import math
from dataclasses import replace

import pytest

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Verdict
from babbitt.kinds.shaft_line.admissible_amplitude import limits_of
from babbitt.kinds.shaft_line.answer import line_answer
from babbitt.kinds.shaft_line.values import line_values
from babbitt.kinds.thrust.report.sentences import answers
from babbitt.solving import solve

TEMPLATE = template("thrust_line")
OIL = TEMPLATE[TEMPLATE.index("lubricant:") : TEMPLATE.index("ring_stiffness:")]
GIVEN = TEMPLATE.replace(OIL, "oil: {kind: viscosity, viscosity: 45 mPa s}\n")
BASE = GIVEN.replace("amplitude: 3 um", "amplitude: 5 um")

RIGID_SEATING = "# seating: {stiffness: 2 GN/m, housing_mass: 12 t, damping: 100 kN s/m}   # left out: rigid"
"""The line of the template that leaves the seating out."""


def result(*changes):
    text = BASE
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return solve(parse_case(text)).results[0]


@pytest.fixture(scope="module")
def base():
    return result()


def test_the_base_case(base):
    assert 100.0 * base.loss_mean_bound == pytest.approx(52.8, abs=0.3)
    assert 100.0 * base.loss_mean_peak == pytest.approx(52.4, abs=0.3)
    assert base.dynamic_minimum_film == pytest.approx(19.6e-6, rel=5e-3)
    assert base.natural_frequency_1 / math.tau == pytest.approx(27.24, rel=1e-3)
    assert not base.within_limits
    codes = {check.code: check.ok for check in base.checks}
    assert not codes.pop("C201")
    assert codes == dict.fromkeys(("C202", "C203", "C103", "C105", "C106", "C107", "C204"), True)
    assert not base.warnings


def test_what_a_surveyor_asks_is_answered(base):
    said = " ".join(answers(base))
    for words in (
        "The film survives: thinnest film 19.6 µm",
        "beyond the limit of 50.0 %",
        "What dominates: the runout of the collar",
        "would halve the dynamic load",
        "runout up to 4.5 µm, indicator 9.0 µm (then the dynamic load misses its limit)",
        "tilt up to ",
    ):
        assert words in said


def test_what_is_told_as_admissible_keeps_every_limit_when_it_is_given(base):
    """The film ends the runout here, the load left on a pad the ripple: C201 alone would let both through."""
    loose = (
        ("loss_limit: 50 %", "loss_limit: 500 %"),
        ("minimum_film_thickness: 10 um", "minimum_film_thickness: 17 um"),
    )
    found = result(*loose)
    said = " ".join(answers(found))
    for name, old, new in (
        ("admissible_runout", "amplitude: 5 um", "amplitude: {:.1f} um"),
        ("admissible_tilt", "offset: 30 um", "offset: {:.1f} um"),
        ("admissible_ripple", "share: 10 %", "amplitude: {:.2f} kN"),
    ):
        shown = QUANTITIES[name].format(found.values[name])
        assert f"up to {shown}" in said
        given = float(shown)
        again = result(*loose, (old, new.format(given)))
        assert again.verdict is not Verdict.FAIL, name
        more = given * 1.01 + 0.1
        assert result(*loose, (old, new.format(more))).verdict is Verdict.FAIL, name
    assert found.settings["admissible_runout_ends"] == "C202"
    assert found.settings["admissible_ripple_ends"] in ("C202", "C203")


def test_a_cause_without_a_limit_is_told_as_one():
    """All load on one pad with this oil leaves 5 µm: nothing but the film would end the tilt."""
    found = result(
        ("loss_limit: 50 %", "loss_limit: 500 %"),
        ("minimum_film_thickness: 10 um", "minimum_film_thickness: 1 um"),
        ("share: 10 %", "share: 0.001 %"),
        ("amplitude: 5 um", "amplitude: 0.001 um"),
        ("materials: {bearing_metal: B83}", "# no metal, whose limit of pressure would end it"),
    )
    assert "admissible_tilt" not in found.values
    assert "tilt: no limit below 122880 µm" in " ".join(answers(found))


def test_without_a_cause_the_limit_is_missed_already():
    said = " ".join(answers(result(("minimum_film_thickness: 10 um", "minimum_film_thickness: 40 um"))))
    assert "runout: none, since without any the film misses its limit" in said


def test_a_sweep_without_rings_has_no_best_one(base):
    design = parse_case(BASE).line_design()
    answer = replace(line_answer(design), rings=(), half=None)
    assert answer.best is None
    found = line_values(design, answer)
    assert not {"best_ring_stiffness", "best_ring_loss", "half_load_ring_stiffness"} & found.keys()
    assert line_values(design, line_answer(design))["best_ring_loss"] == base.best_ring_loss
    assert "On no ring of the sweep do the pads find a film" in " ".join(answers(replace(base, values=found)))


def test_a_film_that_does_not_survive_says_so():
    found = result(("amplitude: 5 um", "amplitude: 40 um"))
    assert answers(found)[0].startswith("The film does not survive")
    assert "W202" in [notice.code for notice in found.warnings]
    assert not {check.code: check.ok for check in found.checks}["C203"]


def test_an_excitation_near_a_mode_is_doubted():
    """A softer seating brings the first mode to 11 Hz; blade frequency is 8.3 Hz, at 160 rpm 10.7 Hz."""
    found = result(
        (
            RIGID_SEATING,
            "seating: {stiffness: 0.3 GN/m}",
        ),
        ("speed: 125 rpm", "speed: 160 rpm"),
    )
    assert "W203" in [notice.code for notice in found.warnings]
    assert found.frequency_separation < 0.2


def test_a_resonance_without_damping_is_refused_through_the_front_door():
    """Films always damp, so that the refusal belongs to given pads; here the line answers."""
    found = result(("damping: 80 kN s/m, ", ""))
    assert found.outcome.solved
    with pytest.raises(InputError):
        parse_case(BASE.replace("speed: 125 rpm", "speed: 0 rpm"))


def test_shaft_pieces_in_series_with_a_flange():
    two = "  - {length: 15 m, diameter: 360 mm, end_mass: 300 kg}\n  - {length: 15 m, diameter: 360 mm}\n"
    found = result(("  - {length: 30 m, diameter: 360 mm}\n", two))
    assert found.natural_frequency_1 / math.tau == pytest.approx(27.1, abs=0.15)


def test_the_campbell_map_names_barred_speeds():
    found = result(
        (
            "# speeds: {lowest: 60 rpm, highest: 140 rpm, number: 21}",
            "speeds: {lowest: 100 rpm, highest: 500 rpm, number: 9}",
        )
    )
    (low, high, order), *_ = found.arrays["barred_ranges"]
    assert order == 4.0
    assert 290.0 < low * 30.0 / math.pi < high * 30.0 / math.pi < 500.0
    assert "to be barred" in " ".join(answers(found))


def test_without_excitation_nothing_is_lost():
    found = result(
        ("  - {share: 10 %}                   # blade frequency\n", "  - {share: 0 %}\n"),
        ("amplitude: 5 um", "amplitude: 0 um"),
    )
    assert found.loss_mean_bound == pytest.approx(0.0, abs=1e-12)
    assert found.dynamic_minimum_film == pytest.approx(found.minimum_film_thickness)
    said = " ".join(answers(found))
    assert "Nothing shakes the line" in said
    assert "dominates" not in said
    assert "would halve" not in said


def test_no_harmonic_at_all_is_not_checked():
    start, end = BASE.index("ripple:"), BASE.index("limits:")
    found = solve(parse_case(BASE[:start] + BASE[end:])).results[0]
    assert [notice.code for notice in found.not_checked] == ["C201", "C205", "C104", "C108"]


def test_a_speed_beside_the_map_is_told():
    found = result(
        (
            "# speeds: {lowest: 60 rpm, highest: 140 rpm, number: 21}",
            "speeds: {lowest: 60 rpm, highest: 110 rpm, number: 3}",
        )
    )
    assert "W206" in [notice.code for notice in found.warnings]


def test_near_a_resonance_propeller_damping_is_said_to_help(base):
    near = result(
        (
            RIGID_SEATING,
            "seating: {stiffness: 0.3 GN/m}",
        ),
        ("speed: 125 rpm", "speed: 160 rpm"),
    )
    assert "more damping at the propeller lowers" in answers(near)[2]
    assert "cannot raise" in answers(base)[2]


def test_own_temperatures_reach_the_line():
    found = result(
        ("oil: {kind: viscosity, viscosity: 45 mPa s}", "lubricant: ISO VG 100\n"
         "supply: {temperature: 45 degC}\nthermal: adiabatic"),
        ("number: 8", "number: 4"), ("load: 500 kN", "load: 250 kN"),
    )  # fmt: skip
    assert found.outcome.solved
    assert found.energy_balance_error < 1e-8
    assert "°C in a film" in answers(found)[-1]
    assert len(found.arrays["pad_maximum_temperature"][0]) == 4


def test_a_barred_range_that_the_map_cuts_is_told_to_go_on():
    """Blade frequency meets the first natural one, 27.2 Hz, at 409 rpm: barred from 327 to 490 rpm."""
    slow = (
        "# speeds: {lowest: 60 rpm, highest: 140 rpm, number: 21}",
        "speeds: {lowest: 100 rpm, highest: 400 rpm, number: 7}",
    )
    said = " ".join(answers(result(slow)))
    assert " to the end of the map at 400 rpm (order 4)" in said
    whole = (slow[0], "speeds: {lowest: 100 rpm, highest: 600 rpm, number: 11}")
    assert "end of the map" not in " ".join(answers(result(whole)))


def test_what_swings_alike_is_given_once():
    """Two waves of one high spot are one, the sum of both vectors: 3 and 4 µm at a right angle are 5 µm at 53°."""
    waves = "runout:\n  - {amplitude: 3 um}\n  - {amplitude: 4 um, phase: 90 deg}\n"
    twice = BASE.replace("runout:\n", waves.replace("  - {amplitude: 3 um}", "  - {amplitude: 3 um, lobes: 1}"))
    twice = twice.replace("  - {amplitude: 5 um}", "#")
    with pytest.raises(InputError, match=r"a second wave of 1 lobes.*amplitude 5 um, phase 53.13 deg"):
        parse_case(twice)
    ripple = BASE.replace("  - {share: 10 %}", "  - {share: 10 %}\n  - {share: 10 %, order: 4, phase: 120 deg}")
    with pytest.raises(InputError, match=r"a second harmonic of 4 times.*amplitude 50 kN, phase 60 deg"):
        parse_case(ripple)
    assert parse_case(BASE.replace("  - {share: 10 %}", "  - {share: 10 %}\n  - {share: 10 %, blade_multiple: 2}"))


def test_the_shaft_as_one_mapping_is_shown_a_list():
    one = BASE.replace("  - {length: 30 m, diameter: 360 mm}", "  {length: 30 m, diameter: 360 mm}")
    with pytest.raises(InputError, match=r"shaft: a mapping is not allowed; allowed: a list; put it into"):
        parse_case(one)


def test_on_which_pad_each_cause_is_largest_is_said(base):
    said = " ".join(answers(base))
    for name in ("runout_force", "ripple_force", "dynamic_bound"):
        forces = base.arrays[name][0]
        assert f" (pad {1 + forces.index(max(forces))})" in said


def test_a_nonlinear_motion_that_is_not_found_is_told_and_gives_no_value():
    found = result(
        ("# nonlinear: true", "nonlinear: true"),
        ("  - {share: 10 %}                   # blade frequency\n", "  - {share: 10 %, order: 3.14159}\n"),
    )
    assert "W210" in [notice.code for notice in found.warnings]
    assert not [name for name in found.values if name.startswith("nonlinear")]


def test_the_nonlinear_film_is_held_against_the_limit_where_it_is_thinner(base):
    design = parse_case(BASE).line_design()
    [film] = [check for check in limits_of(design, base.values) if check.code == "C202"]
    assert film.quantity == "dynamic_minimum_film"
    [film] = [
        check
        for check in limits_of(design, {**base.values, "nonlinear_minimum_film": 9e-6})
        if check.code == "C202"
    ]
    assert (film.quantity, film.value, film.ok) == ("nonlinear_minimum_film", 9e-6, False)


def test_axial_vibration_is_a_result_and_held_against_the_limit_of_the_case(base):
    """The propeller swings with Q_m l/(E A) and more: 79 µm on the published line, the collar hardly at all."""
    assert base.far_end_axial_amplitude == pytest.approx(base.axial_amplitude, rel=0.01)
    assert 70e-6 < base.far_end_axial_amplitude < 90e-6
    assert base.collar_axial_amplitude < 5e-6
    assert "C205" in [notice.code for notice in base.not_checked]
    for limit, ok in (("200 um", True), ("50 um", False)):
        found = result(("thickness: 10 um", f"thickness: 10 um, axial_amplitude: {limit}"))
        [check] = [check for check in found.checks if check.code == "C205"]
        assert check.ok is ok
        assert "C205" not in [notice.code for notice in found.not_checked]
    assert "Axial vibration at the worst phases" in " ".join(answers(base))


def test_loads_over_a_revolution_and_films_at_each_excitation_are_in_the_file(base):
    history = base.arrays["pad_load_history"]
    own = base.arrays["pad_load"][0]
    for pad, load in enumerate(own, start=1):
        assert sum(row[pad] for row in history) / len(history) == pytest.approx(load, rel=1e-9)
    swing = max(abs(row[1] - own[0]) for row in history)
    assert swing == pytest.approx(base.arrays["dynamic_peak"][0][0], rel=1e-3)
    stiffness, damping = (base.arrays[f"pad_{one}_over_frequency"] for one in ("stiffness", "damping"))
    assert [row[0] / base.angular_speed for row in stiffness] == pytest.approx([1.0, 4.0])
    assert stiffness[1][1] > stiffness[0][1] > base.arrays["pad_stiffness"][0][0]
    assert damping[0][1] == pytest.approx(base.arrays["pad_damping"][0][0], rel=1e-9)


def test_a_feed_pump_has_no_propeller():
    """Its shaft ends free; vanes give the order of the ripple."""
    start, end = BASE.index("propeller:"), BASE.index("shaft:")
    pump = BASE[:start] + BASE[end:]
    with pytest.raises(InputError, match=r"ripple\[0\]\.order: without a propeller there is no blade frequency"):
        parse_case(pump)
    found = solve(parse_case(pump.replace("- {share: 10 %}", "- {share: 10 %, order: 7}"))).results[0]
    assert found.outcome.solved
    assert found.natural_frequency_1 > solve(parse_case(BASE)).results[0].natural_frequency_1


NONLINEAR = ("# nonlinear: true", "nonlinear: true")
LINE_PIVOT = ("pivot: {kind: point, radius: 290 mm", "pivot: {kind: line, radius: 290 mm")


@pytest.mark.parametrize(("share", "told"), [(10, False), (80, True)])
def test_a_pad_that_the_collar_leaves_is_told(share, told):
    found = result(NONLINEAR, ("share: 10 %", f"share: {share} %"))
    warnings = {notice.code: notice.message for notice in found.warnings}
    assert "nonlinear_minimum_film" in found.values
    assert ("W205" in warnings) is told
    if told:
        assert "carries nothing during" in warnings["W205"]
        assert found.verdict not in (Verdict.PASS, Verdict.REMARKS)


@pytest.mark.parametrize(("offset", "told"), [(30, False), (100, True)])
def test_points_of_a_sweep_without_a_film_are_told(offset, told):
    """Pads held along the radius lean with the housing, and those on the stiffest rings touch the collar."""
    found = result(LINE_PIVOT, ("offset: 30 um", f"offset: {offset} um"))
    warnings = {notice.code: notice.message for notice in found.warnings}
    assert ("W208" in warnings) is told
    if told:
        wanted = int(warnings["W208"].split()[2])
        assert warnings["W208"] == f"{wanted - len(found.arrays['ring_sweep'])} of {wanted} backing rings"
