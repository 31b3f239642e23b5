"""What a film gives to warmer walls, found for all of them at once: as when each is warmed alone."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.reynolds.heat._heat_cells import sweep_energy
from babbitt.reynolds.heat.heat_model import (
    THERMAL_DRAFT,
    BushRing,
    ConductingWalls,
    FilmHeat,
    HeatGrid,
    JournalHeat,
)
from babbitt.reynolds.heat.thermal_equilibrium import search
from babbitt.reynolds.model import FilmStart, JournalFilm, Land, Pocket, grooved_bore
from babbitt.reynolds.scales import Scales

COLD = 323.15


def oil(temperature):
    """A Vogel law like that of an ISO VG 32."""
    return 4.0e-5 * np.exp(1000.0 / (np.asarray(temperature) - 160.02))


GROOVES = JournalFilm(0.4, 0.263, 195e-6, float(oil(COLD)), 94.2478, grooved_bore((0.0, math.pi), 0.07))
POCKETS = replace(
    GROOVES, lands=(Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC,
    pockets=(Pocket(0.0, 0.35, 0.2, pressure=5e4), Pocket(math.pi, 0.35, 0.2, pressure=5e4)),
)  # fmt: skip
WALLS = ConductingWalls(BushRing((0.2, 0.3), (50.0,), 50.0, 293.15), JournalHeat(shaft_conductance=3.0))
HEAT = FilmHeat(oil, 1.72e6, 0.13, COLD, WALLS)


def given_to_walls(thermal):
    """Harmonics of the flux into the bush and the heat into the journal, with the energy equation solved."""
    walls, cells = thermal.walls, thermal.cells
    surface = thermal.sample.ring.surface
    sweep_energy(
        surface, thermal.columns, thermal.flows, cells, walls, thermal.temperature, thermal.groove, 600, 1e-12
    )
    bush = (cells.bush * (thermal.temperature[:, :, 0] - walls.bush[:, None])).sum(axis=1)
    journal = (cells.journal * (thermal.temperature[:, :, -1] - walls.journal[0])).sum()
    flux = bush * walls.flow_heat / (walls.area * walls.width)
    return np.append(walls.analysis @ flux, journal * walls.flow_heat)


@pytest.mark.parametrize(
    ("film", "grid"),
    [(GROOVES, HeatGrid()), (POCKETS, HeatGrid()), (GROOVES, HeatGrid(resolved=True))],
    ids=["grooves", "pockets", "resolved"],
)
@pytest.mark.parametrize("mode", [0, 1, 5, 11, 15, -1])
def test_every_wall_warmed_alone_gets_what_is_foretold(film, grid, mode):
    scales = Scales.of(film, film.angular_speed)
    thermal = search(
        film, replace(HEAT, grid=grid), scales, np.array([0.0, -112.8e3]) / scales.force, THERMAL_DRAFT
    ).thermal
    thermal.fill(thermal.viscosity)
    thermal.prepare_walls()
    walls = thermal.walls
    modes, foretold = walls.admittance.size, np.linalg.inv(walls.inverse)
    foretold[np.diag_indices(modes + 1)] -= np.append(walls.admittance, walls.journal[2])
    before = given_to_walls(thermal)
    if mode >= 0:
        walls.bush[:] += walls.synthesis[:, mode]
    else:
        walls.journal[0] += 1.0
    change = given_to_walls(thermal) - before
    for part in (slice(0, modes), slice(modes, None)):  # W/m2 and W
        largest = np.abs(foretold[part]).max()
        assert -change[part] == pytest.approx(foretold[part, mode], abs=2e-3 * largest)
