"""The march in time against the frequency domain (B5), and the nonlinear pads."""

import math
from dataclasses import replace

import numpy as np
import pytest
from trawler_line import RIPPLE, RUNOUT, duty, given_pads, line
from trawler_pads import INERTIA, PAD, SPEED, VISCOSITY

from babbitt.notices import InputError
from babbitt.shaft_line.forced import forced
from babbitt.shaft_line.march import march
from babbitt.shaft_line.model import state_of
from babbitt.shaft_line.transient import transient
from babbitt.thrust.carrying import carrying
from babbitt.thrust.equilibrium import pad_state
from babbitt.thrust.film_table import film_table
from babbitt.thrust.pad import Pivot

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
    from babbitt.film.sector import PlaneMotion, SectorPad, sector_film

    sector = SectorPad(PAD.inner_radius, PAD.outer_radius, PAD.extent, VISCOSITY, SPEED)
    to_film = PAD.from_pivot()
    film = sector_film(sector, PlaneMotion(*(to_film @ np.array([height, *slopes[0]]))), intervals=PAD.intervals)
    forces = to_film.T @ film.forces
    assert wedge[0] * VISCOSITY * SPEED == pytest.approx(forces, rel=1e-3, abs=1e-4 * film.load)
    assert squeeze[0] * VISCOSITY == pytest.approx(to_film.T @ film.damping @ to_film, rel=2e-3)
    assert pad_state(PAD, 50e-6, VISCOSITY, SPEED).load == pytest.approx(FILMS.load(50e-6), rel=1e-9)


@pytest.mark.parametrize("pivot", [Pivot.POINT, Pivot.LINE])
def test_small_nonlinear_motion_is_the_linear_one(pivot):
    """Massless pads in both; the load peak within 0.5 %, what is left of second order in the unloading 1 %.

    Under the tilt of the housing line pivots hold their pads at a slope, which ripple alone does not change.
    """
    pad = replace(PAD, pivot=pivot)
    light = replace(duty(), bearing=replace(duty().bearing, pad=pad, pad_mass=0.0, inertia=type(INERTIA)()))
    if pivot is Pivot.LINE:  # a slope beyond the tabulated films would be told
        light = replace(light, runouts=()).with_tilt(10e-6)
    state = state_of(light, carrying(pad, VISCOSITY, SPEED))
    found = transient(state, 0.05)
    assert found.steady < 5e-3
    history = 0.05 * state.forced.force_history()
    assert found.load_peaks.max() == pytest.approx(history.max(), rel=5e-3)
    assert found.unload_peaks.max() == pytest.approx(-history.min(), rel=1e-2)
    assert not found.outside
    assert not found.lifts_off
    assert not found.touches


def test_pads_that_cannot_follow_a_leaning_collar_have_no_nonlinear_motion():
    """Runout of two lobes, whose height alone counts, is marched; of one lobe it would be wrong."""
    of = replace(duty(), bearing=replace(duty().bearing, pad=replace(PAD, pivot=Pivot.LINE))).with_tilt(10e-6)
    films = carrying(of.bearing.pad, VISCOSITY, SPEED)
    with pytest.raises(InputError, match="line pivot holds the tilt") as told:
        transient(state_of(of, films))
    assert told.value.code == "E101"
    waves = state_of(replace(of, runouts=(replace(RUNOUT, order=2.0),)), films)
    assert transient(waves, 0.05, revolutions=1).loads.max() > waves.share.loads.max()


def test_golden_nonlinear_motion():
    """Load peak over the linear one 1.005 at once, and the films grow on the mean (rectification)."""
    state = state_of(duty(), FILMS)
    found = transient(state)
    assert found.load_peaks.max() / state.forced.peaks().max() == pytest.approx(1.005, abs=0.005)
    assert found.thinnest.min() == pytest.approx(19.77e-6, rel=0.01)
    assert np.all(found.film_shift > 0.0)
    assert np.all(found.load_peaks > 0.0)
    assert np.all(found.unload_peaks > 0.0)


@pytest.mark.parametrize("ring", [2e10, math.inf])
def test_no_film_pulls(ring):
    """Runout of six times the base case, where linear forces pull: pads lift off, and the mean thrust stays."""
    shaken = duty().with_runout(6.0)
    state = state_of(replace(shaken, bearing=replace(shaken.bearing, ring_stiffness=ring)), FILMS)
    assert (state.share.loads - state.forced.peaks()).min() < 0.0
    found = transient(state)
    assert found.loads.min() == 0.0
    assert found.lifts_off
    assert 0.0 < found.lifted.max() < 0.5
    assert found.loads[:-1].sum(axis=1).mean() == pytest.approx(state.share.thrust, rel=0.02)


def test_crowned_pads_have_no_similar_films_to_march():
    from babbitt.notices import InputError

    crowned = replace(PAD, crown=10e-6)
    with pytest.raises(InputError, match="similar"):
        film_table(carrying(crowned, VISCOSITY, SPEED))
