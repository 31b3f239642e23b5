"""Where lines resonate: peaks of the response and damped modes, films and tilts at their own frequency."""

import math
from dataclasses import replace

import numpy as np
import pytest
from trawler_line import RIPPLE, duty, given_pads
from trawler_pads import PAD, SPEED, VISCOSITY

from babbitt.kinds.shaft_line.damped import damped_modes
from babbitt.kinds.shaft_line.impedance import respond
from babbitt.kinds.shaft_line.line import Rod, Seating, ShaftLine
from babbitt.kinds.shaft_line.model import LineOperation, state_of
from babbitt.kinds.shaft_line.natural import undamped_frequencies
from babbitt.kinds.shaft_line.pads import FilmPads
from babbitt.kinds.shaft_line.resonance import resonances_of
from babbitt.kinds.shaft_line.response import THRUST, pad_forces, response_peaks, static_force
from babbitt.kinds.shaft_line.sweeps import barred_ranges, speed_sweep
from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.state import TiltInertia

FILMS = carrying(PAD, VISCOSITY, SPEED)


@pytest.mark.parametrize("seat", [None, Seating(1e9, 1e4, 12e3)])
@pytest.mark.parametrize("ring", [2e10, math.inf])
@pytest.mark.parametrize("lobes", [THRUST, 1.0, 2.0])
def test_many_frequencies_at_once_are_the_equations_of_one(lobes, ring, seat):
    if seat is not None and math.isinf(ring):
        return
    state = state_of(duty(ring=ring), FILMS)
    pads, of = state.pads, replace(state.duty.line, seating=seat)
    at = np.array([13.0, 52.0, 300.0])
    found = pad_forces(of, pads, lobes, at)
    for nu, forces in zip(at, found, strict=True):
        runout = np.zeros(8, dtype=complex)
        if lobes != THRUST:
            runout = np.exp(-1j * lobes * pads.phases) * (1.0 + (pads.wobble(nu) if lobes == 1.0 else 0.0))
        known = respond(of, pads, float(nu), 1.0 if lobes == THRUST else 0j, runout).forces
        assert forces == pytest.approx(known, rel=1e-10, abs=1e-12 * float(np.abs(known).max()))


def test_a_pad_without_a_film_leaves_those_of_the_others():
    """Of ten pads under a large tilt one carried nothing, and the line was a "Singular matrix"."""
    pads = state_of(duty(), FILMS).pads
    lost, *others = pads.share.states
    nothing = replace(lost, stiffness=np.zeros((3, 3)), damping=np.zeros((3, 3)))
    without = FilmPads(replace(pads.share, states=(nothing, *others)))
    at = np.array([13.0, 300.0])
    for found, known in ((without.films(at), pads.films(at)), (without.wobbles(at), pads.wobbles(at))):
        assert not found[:, 0].any()
        assert found[:, 1:] == pytest.approx(known[:, 1:], rel=1e-12)


def test_one_mass_on_given_pads_peaks_as_the_textbook_says():
    """k and d on a mass, rigid ring: force over static sqrt((1 + a^2)/((1 - r^2)^2 + a^2)), a = 2 zeta r."""
    pads = replace(given_pads(uneven=0.0), ring_stiffness=math.inf, pad_mass=0.0)
    mass, k = 30e3, 8 * 2.5e9
    natural = math.sqrt(k / mass)
    for zeta in (0.02, 0.1, 0.2):
        damped = replace(pads, damping=(2.0 * zeta * math.sqrt(k * mass) / 8,) * 8)
        rigid = ShaftLine(0.5 * mass, 0.0, (), 0.5 * mass)
        [peak] = response_peaks(rigid, damped, THRUST, 0.1 * natural, 3.0 * natural)
        r = np.linspace(0.5, 1.2, 200001)
        a = 2.0 * zeta * r
        known = np.sqrt((1.0 + a**2) / ((1.0 - r**2) ** 2 + a**2))
        assert peak.frequency / natural == pytest.approx(float(r[known.argmax()]), abs=1e-4)
        assert peak.amplification == pytest.approx(float(known.max()), rel=1e-5)
        [mode] = damped_modes(rigid, damped, (), 10.0 * natural)
        assert mode.damping_ratio == pytest.approx(zeta, rel=1e-6)
        assert mode.frequency == pytest.approx(natural * math.sqrt(1.0 - zeta**2), rel=1e-6)
    heavy = replace(pads, damping=(1.2 * math.sqrt(k * mass) / 8,) * 8)
    assert not response_peaks(rigid, heavy, THRUST, 0.1 * natural, 3.0 * natural)
    assert static_force(rigid, heavy, THRUST, natural) == pytest.approx(0.125, rel=1e-6)


def test_an_excitation_between_undamped_frequencies_may_resonate():
    """Moving films are stiffer than films at rest: the damped mode lies far above every undamped frequency."""
    pad = ThrustPad(36.26e-3, 52.99e-3, math.radians(63.34), 44.95e-3, 0.573)
    bearing = ThrustBearing(pad, 5, math.inf, 0.0392, TiltInertia(5.7e-6, 5.7e-6), HousingTilt(12.3e-6, 0.822))
    shaft = (Rod(8.198, math.pi / 4.0 * (45.06e-3**2 - 18.63e-3**2), 206e9, 7850.0),)
    films, speed = carrying(pad, 0.08, 699.3 * math.pi / 30.0), 699.3 * math.pi / 30.0
    of = LineOperation(ShaftLine(187.8, 675.5, shaft, 34.09), bearing, 1377.0, speed)
    state = state_of(of, films)
    modes = damped_modes(of.line, state.pads, (), 600.0)
    mode = modes[0]
    order = mode.frequency / speed
    shaken = state_of(replace(of, thrusts=(replace(RIPPLE, order=order, amplitude=100.0),)), films)
    undamped = undamped_frequencies(of.line, shaken.pads, highest=4.0 * mode.frequency)
    assert min(abs(mode.frequency / one - 1.0) for one in undamped) > 0.2
    [met] = resonances_of(shaken, ()).encounters
    assert met.separation < 0.05
    quasi = replace(shaken.duty.thrusts[0], order=0.01 * order)
    rest = state_of(replace(of, thrusts=(quasi,)), films)
    assert shaken.forced.bounds().max() > 2.0 * rest.forced.bounds().max()


def test_no_excitation_on_a_peak_goes_without_a_notice():
    """Wherever the largest pad force of a dense sweep has a maximum above twice the static one, it is found."""
    state = state_of(duty(), FILMS)
    at = np.geomspace(2.0, 1300.0, 20001)
    for lobes in (THRUST, 1.0):
        forces = np.abs(pad_forces(state.duty.line, state.pads, lobes, at)).max(axis=1)
        tops = np.flatnonzero((forces[1:-1] > forces[:-2]) & (forces[1:-1] > forces[2:])) + 1
        rest = static_force(state.duty.line, state.pads, lobes, 2.0)
        known = [float(at[top]) for top in tops if forces[top] > 2.0 * rest]
        found = [peak.frequency for peak in response_peaks(state.duty.line, state.pads, lobes, 2.0, 1300.0)]
        assert found == pytest.approx(known, rel=1e-3)


def test_speeds_are_barred_about_the_resonance():
    """Blade frequency meets the first peak at 27.86 Hz/4, 418 rpm: barred from 20 % below it to 20 % above."""
    speeds = [rpm * math.pi / 30.0 for rpm in range(150, 651, 50)]
    fixed = replace(duty(), runouts=())
    points = speed_sweep(fixed, lambda at: carrying(PAD, VISCOSITY, at.speed), speeds)
    [(low, high, order)] = barred_ranges(points)
    peaks = [min(point.resonances.frequencies(THRUST), default=math.nan) for point in points]
    assert order == 4.0
    assert 4.0 * low == pytest.approx(0.8 * np.nanmean(peaks), rel=0.05)
    assert 4.0 * high == pytest.approx(1.2 * np.nanmean(peaks), rel=0.05)
