"""Other ways to the rest of a film with its own temperatures: they lead to the same place."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.reynolds.heat.globalisation import accelerated_equilibrium, recovered
from babbitt.reynolds.heat.heat_model import THERMAL_ENGINEERING, BushRing, ConductingWalls, FilmHeat, JournalHeat
from babbitt.reynolds.heat.thermal_equilibrium import CLOSED, CLOSING, OPEN
from babbitt.reynolds.heat.thermal_film_state import GUESSED_SHARE
from babbitt.reynolds.heat.thermal_passes import cold_start, find_thermal_equilibrium, fresh_ring
from babbitt.reynolds.lands._equilibrium import CONVERGED
from babbitt.reynolds.model import FilmStart, JournalFilm, Land, Pocket, grooved_bore
from babbitt.reynolds.scales import Scales

COLD = 323.15


def iso_vg_32(temperature):
    """A Vogel law through 0.0275 Pa s at 40 degC and 0.0046 Pa s at 100 degC."""
    return 4.0e-5 * np.exp(1000.0 / (np.asarray(temperature) - 160.02))


BEARING = JournalFilm(0.1, 0.06, 75e-6, float(iso_vg_32(COLD)), 200.0, grooved_bore((0.0, math.pi), 0.3))
POCKETS = replace(
    BEARING, lands=(Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC,
    pockets=(Pocket(0.0, 0.35, 0.04, pressure=5e4), Pocket(math.pi, 0.35, 0.04, pressure=5e4)),
)  # fmt: skip
ADIABATIC = FilmHeat(iso_vg_32, 1.72e6, 0.13, COLD)
WALLS = ConductingWalls(BushRing((0.05, 0.06, 0.09), (50.0, 45.0), 20.0, 293.15), JournalHeat())
FULL = replace(ADIABATIC, walls=WALLS)
LOAD = (0.0, -6e3)


def ring_for(film, heat, load=LOAD):
    """Fine ring, dimensionless load, and where fresh oil carries it."""
    scales = Scales.of(film, film.angular_speed)
    thermal = fresh_ring(film, heat, scales, 2 * THERMAL_ENGINEERING.intervals, THERMAL_ENGINEERING, None)
    force = np.asarray(load) / scales.force
    return thermal, force, cold_start(thermal.sample, force)


def test_a_film_starts_where_what_leaves_would_carry_its_heat_off():
    thermal, _, at = ring_for(BEARING, FULL)
    thinner = thermal.guess(at)
    risen = thermal.temperature - COLD
    leaving = np.maximum(thermal.flows.leak, 0.0).sum()
    assert np.ptp(risen) == 0.0
    assert risen.max() > 2.0
    assert thinner == pytest.approx(iso_vg_32(COLD + risen.max()) / iso_vg_32(COLD), rel=1e-3)
    assert risen.max() * leaving == pytest.approx(
        GUESSED_SHARE * thermal.dissipation * thermal.rise * thinner, rel=0.01
    )
    walls = thermal.walls
    assert walls.bush == pytest.approx(walls.ambient + walls.synthesis @ walls.harmonics, abs=1e-9)
    assert walls.journal[0] == pytest.approx(thermal.temperature.max(), abs=1e-9)


@pytest.mark.parametrize("film", [BEARING, POCKETS], ids=["grooves", "pockets"])
@pytest.mark.parametrize("heat", [ADIABATIC, FULL], ids=["adiabatic", "full"])
def test_mixed_passes_lead_to_the_same_rest(film, heat):
    plain, load, at = ring_for(film, heat)
    found = find_thermal_equilibrium(plain, load, at, 1e-5, 1e-3)
    other, load, at = ring_for(film, heat)
    mixed = accelerated_equilibrium(other, load, at, 1e-5, 1e-3)
    assert found.status == mixed.status == CONVERGED
    assert mixed.position == pytest.approx(found.position, abs=2e-4)
    assert other.temperature == pytest.approx(plain.temperature, abs=0.05)
    assert mixed.thermal.sample.force == pytest.approx(-load, abs=1e-5 * np.hypot(*load))


def test_mixed_passes_at_a_given_place_do_not_move_the_journal():
    thermal, _, _ = ring_for(BEARING, FULL)
    found = accelerated_equilibrium(thermal, None, np.array([0.2, -0.5]), 1e-5, 1e-3)
    assert found.status == CONVERGED
    assert found.position.tolist() == [0.2, -0.5]


def test_a_film_that_was_lost_is_found_from_the_film_of_one_temperature():
    thermal, load, at = ring_for(BEARING, FULL)
    lost = replace(find_thermal_equilibrium(thermal, load, at, 1e-5, 1e-3), status=2, load=None)
    scales = Scales.of(BEARING, BEARING.angular_speed)
    found = recovered(BEARING, FULL, scales, load, THERMAL_ENGINEERING, lost, 1.0)
    assert found.status == CONVERGED
    assert found.position == pytest.approx(lost.position, abs=5e-3)


@pytest.mark.parametrize("film", [BEARING, POCKETS], ids=["grooves", "pockets"])
def test_walls_come_back_to_their_temperatures_however_far_they_were_thrown(film):
    """A creeping film conducts far more than its oil carries; closing its heat still takes few rounds."""
    film = replace(film, angular_speed=5.0, clearance=40e-6)
    thermal, load, at = ring_for(film, FULL, (0.0, -60e3))
    found = find_thermal_equilibrium(thermal, load, at, 1e-3, 1e-2)
    assert found.status == CONVERGED
    assert thermal.close(CLOSING, CLOSED) < OPEN
    journal, bush = float(thermal.walls.journal[0]), thermal.walls.bush.copy()
    walls, gap = thermal.walls, FULL.conductivity / thermal.walls.conductance.max()
    conducted = FULL.conductivity / gap * math.pi * film.diameter  # W/(m K), over what one turn carries
    assert conducted > 50.0 * FULL.volumetric_heat_capacity * 0.25 * film.angular_speed * film.diameter * gap
    walls.journal[0] += 15.0
    walls.harmonics[:] += np.where(np.arange(walls.harmonics.size) % 2, 6.0, -4.0)
    walls.bush[:] = walls.ambient + walls.synthesis @ walls.harmonics
    assert thermal.close(60, 1e-6) < 1e-6
    assert walls.journal[0] == pytest.approx(journal, abs=1e-4)
    assert walls.bush == pytest.approx(bush, abs=1e-4)
