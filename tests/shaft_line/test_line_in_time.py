"""The march in time against the frequency domain (B5), and the nonlinear pads."""

import math
from dataclasses import replace

import numpy as np
import pytest
from trawler_line import RIPPLE, RUNOUT, duty, given_pads, line
from trawler_pads import PAD, SPEED, VISCOSITY

from babbitt.core.notices import InputError
from babbitt.kinds.shaft_line.forced import forced
from babbitt.kinds.shaft_line.line import Seating
from babbitt.kinds.shaft_line.march import march
from babbitt.kinds.shaft_line.model import state_of
from babbitt.kinds.shaft_line.periodic import NoPeriodicMotionError, periodic_motion
from babbitt.kinds.thrust.equilibrium import pad_state
from babbitt.kinds.thrust.film_table import film_table
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import Pivot

FILMS = carrying(PAD, VISCOSITY, SPEED)


def misses(found, state):
    """Largest miss of complex forces and gaps over every pad's own, one number per harmonic."""
    forces, gaps = [], []
    for part in state.forced.parts:
        order = int(part.harmonic.order)
        wave = np.exp(-1j * order * found.angles)
        for said, marched, known in (
            (forces, found.amplitudes(order), part.response.forces),
            (gaps, 2.0 / wave.size * (wave @ found.gaps), part.response.gaps),
        ):
            said.append(float((np.abs(marched - known) / np.abs(known)).max()))
    return forces, gaps


def test_the_march_meets_the_frequency_domain():
    """B5: amplitudes 1e-5, peaks 1e-3, with every tilt of every pad in the march."""
    state = state_of(duty(), FILMS)
    found = march(state.duty.line, state.pads, SPEED, (RIPPLE,), (RUNOUT,))
    forces, gaps = misses(found, state)
    assert max(forces) < 1e-5
    assert max(gaps) < 1e-5
    assert found.peaks == pytest.approx(state.forced.peaks(), rel=1e-3)


def test_the_march_converges_with_the_square_of_its_step():
    """Rods fine enough that only the step is left: 1440 steps of B5 leave 2.0e-5 on the gaps, 2880 a quarter."""
    state = state_of(duty(), FILMS)
    coarse, fine = (
        max(
            misses(march(state.duty.line, state.pads, SPEED, (RIPPLE,), (RUNOUT,), steps=n, elements=96), state)[1]
        )
        for n in (1440, 2880)
    )
    assert coarse / fine == pytest.approx(4.0, rel=0.05)


def test_the_march_on_given_pads():
    found = march(line(), given_pads(), SPEED, (RIPPLE,), (RUNOUT,))
    expected = forced(line(), given_pads(), SPEED, (RIPPLE,), (RUNOUT,))
    assert found.peaks == pytest.approx(expected.peaks(), rel=1e-3)


def test_the_table_holds_the_film_off_its_nodes():
    table = film_table(FILMS)
    height, slopes = 40e-6, np.array([[1.3e-5, -1.9e-4]])
    wedge, squeeze, outside = table.forces(np.array([height]), slopes)
    assert not outside.any()
    from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad, sector_film

    sector = SectorPad(PAD.inner_radius, PAD.outer_radius, PAD.extent, VISCOSITY, SPEED)
    to_film = PAD.from_pivot()
    film = sector_film(sector, PlaneMotion(*(to_film @ np.array([height, *slopes[0]]))), intervals=PAD.intervals)
    forces = to_film.T @ film.forces
    assert wedge[0] * VISCOSITY * SPEED == pytest.approx(forces, rel=1e-3, abs=1e-4 * film.load)
    assert squeeze[0] * VISCOSITY == pytest.approx(to_film.T @ film.damping @ to_film, rel=2e-3)
    assert pad_state(PAD, 50e-6, VISCOSITY, SPEED).load == pytest.approx(FILMS.load(50e-6), rel=1e-9)


@pytest.mark.parametrize("pivot", [Pivot.POINT, Pivot.LINE])
def test_small_nonlinear_motion_is_the_linear_one(pivot):
    """What is left of 1 % of the excitations is of second order: ten times less at a tenth of them.

    Under the tilt of the housing line pivots hold their pads at a slope, which ripple alone does not change.
    """
    of = replace(duty(), bearing=replace(duty().bearing, pad=replace(PAD, pivot=pivot)))
    if pivot is Pivot.LINE:  # a slope beyond the tabulated films would be told
        of = replace(of, runouts=()).with_tilt(10e-6)
    state = state_of(of, carrying(of.bearing.pad, VISCOSITY, SPEED))
    left = []
    for amplitude in (1e-2, 1e-3):
        found = periodic_motion(state, amplitude)
        assert found.residual < 1e-6
        history = amplitude * state.forced.history(state.forced.forces())
        assert found.load_peaks.max() == pytest.approx(history.max(), rel=3e-3)
        assert found.unload_peaks.max() == pytest.approx(-history.min(), rel=3e-3)
        left.append(abs(found.load_peaks.max() / history.max() - 1.0))
        assert [found.outside, found.lifts_off, found.touches] == [False] * 3
    assert left[1] < 0.2 * left[0] + 1e-4


@pytest.mark.parametrize(
    ("order", "seat", "ring"), [(13.0, None, 2e10), (13.0, None, math.inf), (8.0, Seating(1e9, 0.0, 12e3), 2e10)]
)
def test_lines_that_hardly_damp_have_their_linear_motion_at_small_excitations(order, seat, ring):
    """On the resonance at 27.9 Hz: marched for two revolutions from the linear answer such lines were off."""
    thrust = (replace(RIPPLE, order=order),)
    of = replace(duty(ring=ring), line=replace(line(damping=2e3), seating=seat), thrusts=thrust)
    state = state_of(of, FILMS)
    found = periodic_motion(state, 1e-3)
    history = 1e-3 * state.forced.force_history()
    assert found.load_peaks.max() == pytest.approx(history.max(), rel=3e-3)
    assert found.unload_peaks.max() == pytest.approx(-history.min(), rel=3e-3)


def test_excitations_without_a_common_period_have_no_motion_that_repeats():
    state = state_of(replace(duty(), thrusts=(replace(RIPPLE, order=math.pi),)), FILMS)
    with pytest.raises(NoPeriodicMotionError, match=r"3\.142.* do not repeat together within 20 revolutions"):
        periodic_motion(state)
    twice = state_of(replace(duty(), thrusts=(replace(RIPPLE, order=2.5),)), FILMS)
    assert periodic_motion(twice, 0.01).angles[-1] > 2.0 * math.pi * 1.99


def test_a_motion_that_is_not_found_is_told():
    """Forty times the runout: every pad loses its load in turn."""
    state = state_of(duty().with_runout(40.0), FILMS)
    with pytest.raises(NoPeriodicMotionError, match="no motion that repeats was found beyond"):
        periodic_motion(state)


def test_pads_that_cannot_follow_a_leaning_collar_have_no_nonlinear_motion():
    """Runout of two lobes, whose height alone counts, is followed; of one lobe it would be wrong."""
    of = replace(duty(), bearing=replace(duty().bearing, pad=replace(PAD, pivot=Pivot.LINE))).with_tilt(10e-6)
    films = carrying(of.bearing.pad, VISCOSITY, SPEED)
    with pytest.raises(InputError, match="line pivot holds the tilt") as told:
        periodic_motion(state_of(of, films))
    assert told.value.code == "E101"
    waves = state_of(replace(of, runouts=(replace(RUNOUT, order=2.0),)), films)
    assert periodic_motion(waves, 0.05).loads.max() > waves.share.loads.max()


@pytest.mark.parametrize(("times", "ratio"), [(1.0, 1.005), (2.0, 1.052), (3.0, 1.093)])
def test_golden_nonlinear_motion(times, ratio):
    """Load peak over the linear one of a prototype that marches with a stiff solver; the mean film grows."""
    state = state_of(duty(), FILMS)
    found = periodic_motion(state, times)
    assert found.load_peaks.max() / (times * state.forced.peaks().max()) == pytest.approx(ratio, abs=0.003)
    if times == 1.0:
        assert found.minimum_film == pytest.approx(19.77e-6, rel=0.01)
    assert np.all(found.film_shift > 0.0)
    assert np.all(found.load_peaks > 0.0)
    assert np.all(found.unload_peaks > 0.0)


@pytest.mark.parametrize(("ring", "times"), [(2e10, 4.5), (math.inf, 4.0)])
def test_no_film_pulls(ring, times):
    """Runout at which linear forces pull: pads lift off, and the mean thrust stays."""
    shaken = duty().with_runout(times)
    state = state_of(replace(shaken, bearing=replace(shaken.bearing, ring_stiffness=ring)), FILMS)
    assert (state.share.loads - state.forced.peaks()).min() < 0.0
    found = periodic_motion(state)
    assert found.loads.min() == 0.0
    assert found.lifts_off
    assert 0.0 < found.lifted.max() < 0.5
    assert found.loads.sum(axis=1).mean() == pytest.approx(state.share.thrust, rel=1e-4)


def test_crowned_pads_have_no_similar_films_to_march():
    from babbitt.core.notices import InputError

    crowned = replace(PAD, crown=10e-6)
    with pytest.raises(InputError, match="similar"):
        film_table(carrying(crowned, VISCOSITY, SPEED))
