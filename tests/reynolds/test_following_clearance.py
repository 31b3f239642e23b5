"""A clearance that follows its film while it is sought: on the same ring, and to the same film in the end."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from test_thermal_trail import ADIABATIC, BEARING, FULL, LOAD

from babbitt.reynolds.heat.following_clearance import (
    FollowingClearance,
    WarmClearance,
    keeps_its_ring,
    with_clearance,
)
from babbitt.reynolds.heat.heat_model import THERMAL_ENGINEERING
from babbitt.reynolds.heat.thermal_continuation import ThermalTrail
from babbitt.reynolds.heat.thermal_passes import fresh_ring
from babbitt.reynolds.model import Pocket, grooved_bore
from babbitt.reynolds.scales import Scales

PRESSED = replace(
    BEARING, lands=tuple(replace(one, start_pressure=2e5, end_pressure=2e5) for one in BEARING.lands)
)
EXPANSION, CAPACITY = 12e-6, 1.5e3
"""Of the radius against that of the journal, 1/K; of the heat capacity, J/(m3 K) per K."""


def start_of(film, heat):
    return WarmClearance(film.clearance, heat.supply_temperature, heat.volumetric_heat_capacity, heat.conductivity)


def grown(film, heat, bush, journal):
    warmth = 0.5 * (bush + journal) - heat.supply_temperature
    wider = film.clearance + 0.5 * film.diameter * EXPANSION * warmth
    capacity = heat.volumetric_heat_capacity + CAPACITY * warmth
    return WarmClearance(wider, heat.supply_temperature + warmth, capacity, 0.9 * heat.conductivity)


def growth_of(film, heat):
    def law(thermal):
        bush, journal = thermal.wall_temperatures()
        width = thermal.walls.width
        return grown(film, heat, float(bush @ width / width.sum()), journal)

    return FollowingClearance(law, start_of(film, heat))


def ring_of(film, heat):
    scales = Scales.of(film, film.angular_speed)
    return fresh_ring(film, heat, scales, 2 * THERMAL_ENGINEERING.intervals, THERMAL_ENGINEERING, None), scales


@pytest.mark.parametrize("film", [BEARING, PRESSED], ids=["vented", "pressed"])
@pytest.mark.parametrize("heat", [ADIABATIC, FULL], ids=["adiabatic", "full"])
def test_a_ring_that_follows_is_the_ring_drawn_for_the_other_clearance(film, heat):
    """Every number of it, and one pass of Reynolds and energy equation from the same temperatures."""
    warm = WarmClearance(
        1.07 * film.clearance, 350.0, 1.05 * heat.volumetric_heat_capacity, 1.2 * heat.conductivity
    )
    ring, _ = ring_of(film, heat)
    wider = FollowingClearance(lambda _: warm, start_of(film, heat)).follow(ring)
    other = replace(heat, volumetric_heat_capacity=warm.volumetric_heat_capacity, conductivity=warm.conductivity)
    drawn, _ = ring_of(with_clearance(film, warm.clearance), other)
    assert wider == pytest.approx(1.07, rel=1e-12)
    assert ring.rise == pytest.approx(drawn.rise, rel=1e-12)
    for name in ("conduction", "flow_heat", "area"):
        assert getattr(ring.walls, name) == pytest.approx(getattr(drawn.walls, name), rel=1e-12)
    assert ring.heat == other
    one, two = ring.sample.ring.surface, drawn.sample.ring.surface
    for name in ("held_pressure", "gap_a", "gap_b", "step"):
        assert getattr(one, name) == pytest.approx(getattr(two, name), rel=1e-12, abs=1e-15)
    at = np.array([0.2, -0.5])
    for thermal in (ring, drawn):
        thermal.advance(at, 3, 8)
    assert ring.temperature == pytest.approx(drawn.temperature, abs=1e-7)
    assert ring.sample.force == pytest.approx(drawn.sample.force, rel=1e-9)


@pytest.mark.parametrize(
    "film", [BEARING, replace(PRESSED, angular_speed=-PRESSED.angular_speed)], ids=["vented", "pressed"]
)
@pytest.mark.parametrize("heat", [ADIABATIC, FULL], ids=["adiabatic", "full"])
def test_the_film_found_has_the_clearance_of_its_temperatures(film, heat):
    """As films at one clearance after the other settle; the force is the load, and heat closes."""
    load = (2e3, 6.0 * LOAD[1])
    growth = growth_of(film, heat)
    found = ThermalTrail().solve_growing(film, heat, load, THERMAL_ENGINEERING, growth)
    own = grown(film, heat, found.mean_bush_temperature, found.journal_temperature)
    assert found.film.outcome.solved
    assert found.film.film.clearance == growth.now.clearance
    assert found.film.film.clearance == pytest.approx(own.clearance, rel=1e-5)
    assert own.clearance > 1.02 * film.clearance
    assert found.film.force == pytest.approx([-part for part in load], abs=1e-8 * math.hypot(*load))
    assert found.heat.balance_error < 1e-7
    trail, warm = ThermalTrail(), start_of(film, heat)
    for _ in range(6):
        oil = replace(heat, volumetric_heat_capacity=warm.volumetric_heat_capacity, conductivity=warm.conductivity)
        settled = trail.solve(with_clearance(film, warm.clearance), oil, load)
        warm = grown(film, heat, settled.mean_bush_temperature, settled.journal_temperature)
    assert found.film.minimum_film_thickness == pytest.approx(settled.film.minimum_film_thickness, rel=1e-4)
    assert found.maximum_temperature == pytest.approx(settled.maximum_temperature, abs=0.02)
    assert found.film.stiffness == pytest.approx(
        settled.film.stiffness, abs=2e-3 * np.abs(settled.film.stiffness).max()
    )


def test_temperatures_that_make_no_film_leave_the_clearance_as_it_is():
    growth = FollowingClearance(lambda _: None, start_of(BEARING, ADIABATIC))
    ring, _ = ring_of(BEARING, ADIABATIC)
    before = ring.rise
    assert growth.follow(ring) == 1.0
    assert (ring.rise, growth.now) == (before, growth.start)


def test_a_film_that_cannot_follow_is_found_at_the_clearance_given():
    """A load that no film carries: the search at a standing clearance says so."""
    growth = growth_of(BEARING, ADIABATIC)
    lost = ThermalTrail().solve_growing(BEARING, ADIABATIC, (0.0, 1e5 * LOAD[1]), THERMAL_ENGINEERING, growth)
    assert not lost.film.outcome.solved
    assert growth.now is growth.start
    assert lost.film.film.clearance == BEARING.clearance


def test_only_round_bores_without_lengths_of_their_own_keep_their_ring():
    assert keeps_its_ring(BEARING)
    assert keeps_its_ring(PRESSED)
    pocket = Pocket(0.0, 0.3, 0.02, pressure=1e5)
    assert keeps_its_ring(replace(BEARING, pockets=(pocket,)))
    assert not keeps_its_ring(replace(BEARING, misalignment=(1e-4, 0.0)))
    assert not keeps_its_ring(replace(BEARING, crowning=(1e-6, 0.0, 1e-6)))
    assert not keeps_its_ring(replace(BEARING, side_pressures=(1e4, 1e4)))
    assert not keeps_its_ring(replace(BEARING, cavitation_pressure=-5e4))
    lobe = replace(BEARING.lands[0], centre=(1e-5, 0.0))
    assert not keeps_its_ring(replace(BEARING, lands=(lobe, BEARING.lands[1])))


def test_lands_take_the_clearance_of_their_film():
    lands = grooved_bore((0.0, math.pi), 0.3)
    given = tuple(replace(one, clearance=BEARING.clearance) for one in lands)
    film = with_clearance(replace(BEARING, lands=given), 80e-6)
    assert film.is_round
    assert {one.clearance for one in film.lands} == {film.clearance} == {80e-6}
