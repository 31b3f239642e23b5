"""Films that follow each other: as if each were sought alone, and as smooth as what they are asked for."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.result import Outcome
from babbitt.reynolds.heat.heat_model import THERMAL_ENGINEERING, BushRing, ConductingWalls, FilmHeat, JournalHeat
from babbitt.reynolds.heat.thermal_continuation import ThermalTrail
from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal
from babbitt.reynolds.heat.thermal_film_state import RELAX
from babbitt.reynolds.heat.thermal_passes import (
    CLOSER,
    cold_start,
    continued,
    find_thermal_equilibrium,
    fresh_ring,
)
from babbitt.reynolds.lands._equilibrium import CONVERGED
from babbitt.reynolds.model import JournalFilm, grooved_bore
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.surface_equilibrium import line_density

COLD = 323.15


def iso_vg_32(temperature):
    """A Vogel law through 0.0275 Pa s at 40 degC and 0.0046 Pa s at 100 degC."""
    return 4.0e-5 * np.exp(1000.0 / (np.asarray(temperature) - 160.02))


BEARING = JournalFilm(0.1, 0.06, 75e-6, float(iso_vg_32(COLD)), 200.0, grooved_bore((0.0, math.pi), 0.3))
ADIABATIC = FilmHeat(iso_vg_32, 1.72e6, 0.13, COLD)
WALLS = ConductingWalls(BushRing((0.05, 0.06, 0.09), (50.0, 45.0), 20.0, 293.15), JournalHeat())
FULL = replace(ADIABATIC, walls=WALLS)
LOAD = (0.0, -6e3)


def settled_ring(heat):
    """A film at rest on uneven lines, and how to make another ring on lines for a journal at a place."""
    scales = Scales.of(BEARING, BEARING.angular_speed)
    force = 8.0 * np.asarray(LOAD) / scales.force

    def ring(density):
        return fresh_ring(BEARING, heat, scales, 2 * THERMAL_ENGINEERING.intervals, THERMAL_ENGINEERING, density)

    even = ring(None)
    at = find_thermal_equilibrium(even, force, cold_start(even.sample, force), 1e-2, 1.0).position
    thermal = ring(line_density(BEARING, at, even.sample.gap(at)))
    found = find_thermal_equilibrium(thermal, force, at, 1e-5, 1e-4)
    assert found.status == CONVERGED
    return found, ring


@pytest.mark.parametrize("heat", [ADIABATIC, FULL], ids=["adiabatic", "full"])
def test_a_film_on_the_same_lines_goes_on_where_the_last_one_rested(heat):
    """Nothing is left to do: neither the wet set nor a temperature changes, those of the walls included."""
    found, ring = settled_ring(heat)
    again = continued(ring(found.thermal.density), found.thermal)
    assert (again.sample.work.wet == found.thermal.sample.work.wet).all()
    assert again.temperature == pytest.approx(found.thermal.temperature, abs=1e-9)
    assert again.walls.bush == pytest.approx(found.thermal.walls.bush, abs=1e-9)
    changed, change = again.advance(found.position, 3, 8)
    assert changed == 0
    assert change < 2e-3
    assert again.sample.force == pytest.approx(-found.load, abs=1e-4 * np.hypot(*found.load))


def test_walls_keep_their_temperature_on_other_lines():
    """Harmonics are the same on any lines: between lines nothing is lost but what a straight line cuts off."""
    found, ring = settled_ring(FULL)
    other = continued(ring(None), found.thermal)
    assert np.ptp(np.diff(found.thermal.sample.ring.theta)) > 0.01
    assert other.walls.harmonics.tolist() == found.thermal.walls.harmonics.tolist()
    lines = found.thermal.walls.bush.size
    between = np.interp(
        other.sample.ring.theta[: other.walls.bush.size],
        found.thermal.sample.ring.theta[:lines],
        found.thermal.walls.bush,
    )
    assert np.ptp(between) > 5.0
    assert other.walls.bush == pytest.approx(between, abs=0.1 * np.ptp(between))


def test_a_change_of_temperature_counts_by_the_share_that_oil_fills():
    found, _ = settled_ring(ADIABATIC)
    thermal = found.thermal
    line = int(np.argmin(np.where(thermal.columns.supply[:, 0] < 0, thermal.flows.fill[:, 0], 1.0)))
    filled, before = float(thermal.flows.fill[line, 0]), thermal.temperature.copy()
    assert 0.0 < filled < 0.6
    thermal.temperature[line] += 5.0
    thermal.relaxation = RELAX
    _, change = thermal.advance(found.position, 3, 8)
    rises = np.abs(thermal.last_rise).max(axis=2)
    assert rises.max() > 4.0
    assert change == pytest.approx(float((rises * thermal.flows.fill).max()), rel=1e-9)
    assert change < 0.9 * rises.max()
    assert thermal.temperature == pytest.approx(before, abs=0.5)


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("heat", [ADIABATIC, FULL], ids=["adiabatic", "full"])
def test_a_film_that_follows_is_the_one_that_is_found_alone(heat, sense):
    film, load = replace(BEARING, angular_speed=sense * BEARING.angular_speed), (0.0, 8.0 * LOAD[1])
    wider, trail = replace(film, clearance=1.005 * film.clearance), ThermalTrail()
    first = trail.solve(film, heat, load)
    assert first.film.minimum_film_thickness == solve_thermal_journal(film, heat, load).film.minimum_film_thickness
    followed, alone = trail.solve(wider, heat, load), solve_thermal_journal(wider, heat, load)
    assert followed.film.outcome.solved
    assert followed.film.force == pytest.approx((0.0, -load[1]), abs=1e-8 * -load[1])
    assert followed.heat.balance_error < 1e-7
    assert followed.film.position == pytest.approx(alone.film.position, abs=5e-4 * film.clearance)
    assert followed.maximum_temperature == pytest.approx(alone.maximum_temperature, abs=0.1)
    assert followed.film.iterations < alone.film.iterations


def test_films_that_follow_change_as_smoothly_as_their_clearance():
    """Second differences of the temperature over the clearance are of second order: no jumps of the grid."""
    trail = ThermalTrail()
    trail.solve(BEARING, FULL, LOAD)
    hot = [
        trail.solve(replace(BEARING, clearance=BEARING.clearance * (1.0 + 1e-2 * step)), FULL, LOAD)
        .bush_temperature.mean()
        for step in (-1, 0, 1)
    ]  # fmt: skip
    first, second = hot[2] - hot[0], hot[2] - 2.0 * hot[1] + hot[0]
    assert abs(first) > 20.0 * CLOSER
    assert abs(second) < 0.05 * abs(first)


def test_a_film_climbs_with_its_load_until_it_is_lost_and_keeps_the_last_one():
    trail = ThermalTrail()
    trail.solve(BEARING, FULL, LOAD)
    heavier = (0.0, 4.0 * LOAD[1])
    climbed, alone = trail.climb(BEARING, FULL, heavier), solve_thermal_journal(BEARING, FULL, heavier)
    assert climbed.film.outcome.solved
    assert climbed.film.minimum_film_thickness == pytest.approx(alone.film.minimum_film_thickness, rel=0.01)
    assert climbed.maximum_temperature == pytest.approx(alone.maximum_temperature, abs=0.5)
    last = trail.last
    lost = trail.climb(BEARING, FULL, (0.0, 1e5 * LOAD[1]))
    assert lost.film.outcome is Outcome.OVERLOADED
    assert trail.last is last


def test_a_film_that_cannot_be_followed_is_sought_anew():
    """From the side where it has no film to the other: the journal would have to cross the bearing."""
    trail = ThermalTrail()
    trail.solve(BEARING, FULL, (0.0, -60e3))
    turned, alone = trail.solve(BEARING, FULL, (0.0, 60e3)), solve_thermal_journal(BEARING, FULL, (0.0, 60e3))
    assert turned.film.outcome.solved
    assert turned.film.minimum_film_thickness == pytest.approx(alone.film.minimum_film_thickness, rel=0.01)
