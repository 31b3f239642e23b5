"""Forced vibration of the line: the golden set with given films (B1) and the closed forms T1 to T10 (B3)."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from trawler_line import ANGLES, RIPPLE, ROD, RUNOUT, given_pads, line
from trawler_pads import SPEED

from babbitt.core.notices import InputError
from babbitt.kinds.shaft_line.excitation import RunoutHarmonic, ThrustHarmonic
from babbitt.kinds.shaft_line.forced import crests, forced
from babbitt.kinds.shaft_line.impedance import dynamic_stiffness, respond
from babbitt.kinds.shaft_line.line import Rod, Seating, ShaftLine
from babbitt.kinds.shaft_line.natural import root_count, undamped_frequencies
from babbitt.kinds.shaft_line.pads import PrescribedPads

BLADE = 4.0 * SPEED
GOLDEN_RIPPLE_POINT = [
    8067.5889 - 833.2753j,
    7634.5955 - 547.5975j,
    6399.9315 + 76.8984j,
    4878.8105 + 528.7131j,
    4165.6032 + 635.9528j,
]
GOLDEN_RIPPLE_ROD = [
    8965.0574 - 986.5101j,
    8485.6851 - 665.6186j,
    7117.3624 + 37.9944j,
    5429.2144 + 551.7110j,
    4636.9166 + 676.2580j,
]
GOLDEN_RUNOUT_ROD = [
    13396.7471 + 9916.4174j,
    15691.0382 - 4684.2408j,
    6902.5718 - 13505.0555j,
    -2885.1320 - 12313.6841j,
    -8793.3217 - 7046.5288j,
    -12888.3004 + 96.6169j,
    -11512.3308 + 10645.5707j,
    81.7909 + 16892.5255j,
]
GOLDEN_PEAKS = [25577.8, 24354.5, 21627.3, 17745.2, 15850.0, 18339.8, 22787.6, 25402.8]


def mirrored(half):
    return np.array([*half, *half[3:0:-1]])


def ripple(of, pads, frequency=BLADE):
    return respond(of, pads, frequency, 50e3, np.zeros(8, dtype=complex))


def runout(of, pads):
    return respond(of, pads, SPEED, 0j, 5e-6 * np.exp(-1j * ANGLES))


def test_golden_forces_of_the_point_mass():
    found = ripple(line().rigid(), given_pads()).forces
    assert found == pytest.approx(mirrored(GOLDEN_RIPPLE_POINT), rel=1e-5)


def test_golden_forces_of_the_rod():
    answer = ripple(line(), given_pads())
    assert answer.forces == pytest.approx(mirrored(GOLDEN_RIPPLE_ROD), rel=1e-5)
    assert runout(line(), given_pads()).forces == pytest.approx(np.array(GOLDEN_RUNOUT_ROD), rel=1e-5)
    assert answer.shaft * 1e6 == pytest.approx(np.array([78.9062 - 1.2990j, 0.5468 - 0.7026j]), abs=1e-4)
    assert answer.residual < 1e-10


def test_golden_peaks_of_the_rod():
    both = forced(line(), given_pads(), SPEED, (RIPPLE,), (RUNOUT,))
    assert both.peaks() == pytest.approx(np.array(GOLDEN_PEAKS), rel=4e-6)  # printed to 0.1 N
    assert np.all(both.peaks() <= both.bounds() * (1.0 + 1e-12))


def test_crests_between_samples_are_found():
    """Orders 1 and 4, as runout and blades, and 12: a sampled crest would be up to 3e-4 too low."""
    angles = 2.0 * math.pi * np.arange(1440) / 1440
    for order in (1, 4, 12):
        for phase in np.linspace(0.0, 0.1, 7):
            assert crests(3.0 * np.cos(order * angles + phase)) == pytest.approx(3.0, rel=5e-7)
    assert crests(np.full((2, 5), 7.0)) == pytest.approx([7.0, 7.0])
    assert crests(np.array([0.0, 1.0, 3.0, 1.0, 0.0, -5.0])) == pytest.approx(3.0)


@pytest.mark.parametrize(
    ("of", "frequencies"),
    [
        (line().rigid(), [98.5787]),
        (line(), [27.2146, 93.5616, 166.0544, 225.9031, 281.6099]),
        (line(seating=Seating(1e9, 0.0, 12e3)), [17.5678, 47.7634, 104.6108]),
    ],
)
def test_golden_natural_frequencies(of, frequencies):
    found = undamped_frequencies(of, given_pads(), len(frequencies))
    assert np.array(found) / math.tau == pytest.approx(np.array(frequencies), rel=1e-5)


def eliminated(of, pads, frequency, thrust, xi):
    """One complex equation for the collar: Z_i = kt (c - nu^2 m4)/(kt + c - nu^2 m4), N_i = Z_i (U2 + xi_i)."""
    kt = pads.film(frequency)
    under = pads.ring_stiffness - frequency**2 * pads.pad_mass
    z = kt * under / (kt + under)
    (rod,) = of.rods
    angle = frequency * rod.transit_time
    factor = rod.stiffness * angle
    far = factor / math.tan(angle) - frequency**2 * of.propeller_mass + 1j * frequency * of.propeller_damping
    near = factor / math.tan(angle) - frequency**2 * of.collar_mass + z.sum()
    cross = -factor / math.sin(angle)
    collar = (-(z @ xi) - cross * thrust / far) / (near - cross**2 / far)
    return z * (collar + xi)


def test_the_whole_matrix_and_elimination_agree():
    pads = given_pads()
    for frequency, thrust, xi in ((BLADE, 50e3, np.zeros(8)), (SPEED, 0.0, 5e-6 * np.exp(-1j * ANGLES))):
        whole = respond(line(), pads, frequency, thrust, xi).forces
        assert whole == pytest.approx(eliminated(line(), pads, frequency, thrust, xi), rel=1e-10)


def even(ring=2e10, pad_mass=18.0):
    return given_pads(ring, pad_mass, uneven=0.0)


def support(pads, frequency):
    kt, under = pads.film(frequency)[0], pads.ring_stiffness - frequency**2 * pads.pad_mass
    return kt if math.isinf(under) else kt * under / (kt + under)


def test_t1_without_tilt_runout_moves_no_collar():
    answer = runout(line(), even())
    assert abs(answer.shaft[-1]) < 1e-6 * 5e-6
    assert np.abs(answer.forces) == pytest.approx(np.full(8, abs(support(even(), SPEED)) * 5e-6), rel=1e-6)


def test_t2_without_tilt_a_point_mass_shares_the_ripple():
    of = replace(line(damping=0.0)).rigid()
    z = support(even(), BLADE)
    expected = 50e3 * abs(z) / abs(8.0 * z - of.masses[0] * BLADE**2)
    assert np.abs(ripple(of, even()).forces) == pytest.approx(np.full(8, expected), rel=1e-6)


def test_t3_a_stiff_ring_is_a_rigid_one():
    for of in (line(), line().rigid()):
        rigid, stiff = (ripple(of, given_pads(ring)).forces for ring in (math.inf, 1e15))
        assert stiff == pytest.approx(rigid, rel=1e-5)


@settings(max_examples=20)
@given(uneven=st.floats(0.0, 0.95), ring=st.floats(8.0, 12.0))
def test_t4_slow_ripple_goes_through_the_pads_whole(uneven, ring):
    pads = given_pads(10.0**ring, uneven=uneven)
    total = ripple(line(damping=0.0), pads, 1e-4).total_force
    assert total.real == pytest.approx(50e3, rel=1e-6)


def hard(damping=0.0):
    return PrescribedPads((1e16,) * 8, (damping,) * 8)


def test_t5_a_rod_on_a_rigid_bearing_magnifies_the_ripple():
    of = line(damping=0.0)
    total = ripple(of, hard()).total_force.real / 50e3
    angle = BLADE * ROD.transit_time
    closed = 1.0 / (math.cos(angle) - of.propeller_mass / ROD.mass * angle * math.sin(angle))
    assert total == pytest.approx(closed, rel=1e-5)
    assert closed == pytest.approx(1.1119795, rel=1e-6)


def test_t6_first_frequency_on_a_rigid_bearing():
    first = undamped_frequencies(line(), hard(), 1)[0]
    angle = first * ROD.transit_time
    assert angle * math.tan(angle) == pytest.approx(ROD.mass / 14e3, rel=1e-4)
    assert first / math.tau == pytest.approx(27.9774, rel=1e-5)


def test_t7_a_very_stiff_rod_is_a_point_mass():
    stiff = replace(line(), rods=(replace(ROD, modulus=206e17),))
    assert ripple(stiff, given_pads()).forces == pytest.approx(
        ripple(line().rigid(), given_pads()).forces, rel=1e-6
    )


def test_t8_without_damping_all_forces_swing_together():
    answer = ripple(line(damping=0.0), given_pads(damped=0.0))
    assert np.abs(answer.forces.imag).max() < 1e-12 * np.abs(answer.forces).max()


@settings(max_examples=25)
@given(
    first=st.floats(3.0, 7.0),
    second=st.floats(3.0, 7.0),
    frequency=st.floats(1.0, 300.0),
    uneven=st.floats(0.0, 0.9),
    rigid=st.booleans(),
)
def test_t9_propeller_damping_never_raises_a_pad_force(first, second, frequency, uneven, rigid):
    """U1 = Q/(D + j nu b0) with Im D >= 0: more damping, less motion, less force on every pad."""
    low, high = sorted((10.0**first, 10.0**second))
    of = [line(damping=b).rigid() if rigid else line(damping=b) for b in (low, high)]
    pads = given_pads(uneven=uneven)
    weak, strong = (np.abs(ripple(one, pads, frequency).forces) for one in of)
    assert np.all(strong <= weak * (1.0 + 1e-9))


def test_t10_a_soft_ring_alone_feels_the_runout():
    pads = even(ring=1e5)
    expected = abs(1e5 - 18.0 * SPEED**2) * 5e-6
    assert np.abs(runout(line(), pads).forces) == pytest.approx(np.full(8, expected), rel=1e-4)


def test_two_half_rods_are_one():
    half = replace(ROD, length=15.0)
    split = ShaftLine(14e3, 8e4, (half, half), 8e3)
    assert ripple(split, given_pads()).forces == pytest.approx(ripple(line(), given_pads()).forces, rel=1e-9)
    found = undamped_frequencies(split, given_pads(), 5)
    assert found == pytest.approx(undamped_frequencies(line(), given_pads(), 5), rel=1e-8)


def test_a_thin_shaft_behind_a_thick_one_matters():
    thin = replace(ROD, length=15.0, area=ROD.area / 4.0)
    stepped = ShaftLine(14e3, 8e4, (replace(ROD, length=15.0), thin), 8e3)
    assert undamped_frequencies(stepped, given_pads(), 1)[0] < undamped_frequencies(line(), given_pads(), 1)[0]


def test_the_count_misses_no_root_at_the_poles_of_the_rod():
    """Counts at many frequencies never fall, and grow by one at each root found."""
    pads = given_pads()
    counts = [root_count(line(), pads, frequency) for frequency in np.linspace(1.0, 3000.0, 400)]
    assert counts == sorted(counts)
    found = undamped_frequencies(line(), pads, highest=3000.0)
    assert len(found) == counts[-1]
    for frequency in found:
        assert (
            root_count(line(), pads, frequency * (1.0 + 1e-9)) - root_count(line(), pads, frequency * (1.0 - 1e-9))
            == 1
        )


def test_seating_as_stiff_as_rock_is_none():
    hard_seat = line(seating=Seating(1e16, 0.0, 12e3))
    assert ripple(hard_seat, given_pads()).forces == pytest.approx(ripple(line(), given_pads()).forces, rel=1e-5)


def test_any_list_of_harmonics_adds_up():
    """Blade and twice blade: the history is the sum, a gear's broken order leaves only the bound."""
    both = forced(line(), given_pads(), SPEED, (RIPPLE, ThrustHarmonic(8.0, 10e3, 0.3)), (RUNOUT,))
    single = [forced(line(), given_pads(), SPEED, (one,), ()) for one in (RIPPLE, ThrustHarmonic(8.0, 10e3, 0.3))]
    third = forced(line(), given_pads(), SPEED, (), (RUNOUT,))
    summed = sum(one.force_history() for one in (*single, third))
    assert both.force_history() == pytest.approx(summed, abs=1e-6)
    broken = forced(line(), given_pads(), SPEED, (RIPPLE, ThrustHarmonic(17.3, 1e3)), (RUNOUT,))
    assert not broken.commensurate
    assert broken.peaks() == pytest.approx(broken.bounds())


def test_waves_of_the_face_pass_the_pads_in_their_order():
    two = forced(line(), even(), SPEED, (), (RunoutHarmonic(2.0, 5e-6),)).parts[0].response.forces
    assert two[4] == pytest.approx(two[0], rel=1e-9)
    assert two[2] == pytest.approx(-two[0], rel=1e-9)


@pytest.mark.parametrize(
    "make",
    [
        lambda: Rod(0.0, 0.1, 2e11, 7850.0),
        lambda: Rod(30.0, -0.1, 2e11, 7850.0),
        lambda: Rod(30.0, 0.1, 0.0, 7850.0),
        lambda: Rod(30.0, 0.1, 2e11, float("nan")),
        lambda: ShaftLine(-1.0, 0.0, (ROD,), 8e3),
        lambda: ShaftLine(1.0, -1.0, (ROD,), 8e3),
        lambda: ShaftLine(1.0, 0.0, (ROD,), 0.0),
        lambda: ShaftLine(1.0, 0.0, (ROD, ROD, ROD), 8e3, joint_masses=(1.0,)),
        lambda: Seating(0.0),
        lambda: Seating(1e9, -1.0),
        lambda: ThrustHarmonic(4.0, -1.0),
        lambda: ThrustHarmonic(0.0, 1.0),
        lambda: RunoutHarmonic(1.0, -1e-6),
        lambda: RunoutHarmonic(1.5, 1e-6),
        lambda: PrescribedPads((1e9, 1e9), (1e8,)),
        lambda: PrescribedPads((1e9, 0.0), (1e8, 1e8)),
        lambda: PrescribedPads((1e9, 1e9), (1e8, -1e8)),
        lambda: PrescribedPads((1e9,), (1e8,)),
        lambda: PrescribedPads((1e9, 1e9), (1e8, 1e8), 0.0),
        lambda: forced(line(), given_pads(), 0.0, (RIPPLE,), ()),
        lambda: dynamic_stiffness(
            line(seating=Seating(1e9)), given_pads(math.inf), SPEED, given_pads().film(SPEED)
        ),
    ],
)
def test_unusable_input_is_refused_by_name(make):
    with pytest.raises(InputError) as refused:
        make()
    assert refused.value.code == "E203"


def test_a_frequency_of_the_rod_between_fixed_ends_is_refused():
    with pytest.raises(InputError, match="fixed ends"):
        ripple(line(), given_pads(), math.pi / ROD.transit_time)


def test_a_resonance_without_damping_is_refused():
    quiet = given_pads(damped=0.0)
    first = undamped_frequencies(line(damping=0.0), quiet, 1)[0]
    with pytest.raises(InputError) as refused:
        forced(line(damping=0.0), quiet, 1.01 * first / 4.0, (RIPPLE,), ())
    assert refused.value.code == "E204"
    assert forced(line(), quiet, 1.01 * first / 4.0, (RIPPLE,), ()).peaks().max() > 0.0
