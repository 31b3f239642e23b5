"""Kernels: bearings or places one after the other; they release the interpreter, so chunks run on all cores."""

from __future__ import annotations

import numpy as np

from babbitt.reynolds._compiling import compiled
from babbitt.reynolds._structs import Bearing
from babbitt.reynolds.lands._equilibrium import CONVERGED, find_equilibrium
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._grids import new_film
from babbitt.reynolds.lands._integrals import integrate
from babbitt.reynolds.lands._positions import film_at

HEAD = 6  # x, y, status, steps, smallest gap, highest pressure; the result vector follows


@compiled
def find_equilibria(
    axial,
    lands,
    kappa,
    side_pressure,
    conserving,
    n_coarse,
    n_fine,
    load,
    tolerance,
    max_steps,
    first,
    last,
    found,
    totals,
):
    """Equilibria of bearings first..last - 1; lands (bearings, lands, columns), found (bearings, HEAD + 10).

    Pressures, flows and torques (``totals``, (bearings, lands, TOTALS)) of those that settle only.
    """
    profiles = np.zeros((lands.shape[1], 0))
    result = np.zeros(RESULT_SIZE)
    film, pressure = new_film(0), np.zeros((0, 0, 0))
    void = pressure
    for b in range(first, last):
        bearing = Bearing(lands[b], profiles, kappa[b], 1.0, side_pressure[b], conserving, True, 1.0)
        x, y, status, steps, gap, grid = find_equilibrium(
            axial, bearing, n_coarse, n_fine, load[b, 0], load[b, 1], 0.0, 0.0, tolerance, max_steps, result
        )
        found[b, 0], found[b, 1], found[b, 2], found[b, 3], found[b, 4] = x, y, status, steps, gap
        found[b, HEAD:] = result
        if status == CONVERGED:
            n = grid.step.shape[1]
            if pressure.size == 0:
                film, pressure = new_film(n), np.zeros((lands.shape[1], n + 1, len(axial.size) + 1))
                void = np.zeros_like(pressure)
            integrate(axial, bearing, grid, film, x, y, 0.0, 0.0, pressure, void, totals[b])
            found[b, 5] = pressure.max()


@compiled
def films_at(axial, bearing, n_coarse, n_fine, places, max_steps, statuses, results):
    """Film of one bearing at many places: rows x, y and their rates in, status and the vector of results out."""
    result = np.zeros(RESULT_SIZE)
    for row in range(places.shape[0]):
        status, _, _, _ = film_at(
            axial, bearing, n_coarse, n_fine, places[row, 0], places[row, 1], places[row, 2], places[row, 3],
            max_steps, result,
        )  # fmt: skip
        statuses[row] = status
        results[row] = result
