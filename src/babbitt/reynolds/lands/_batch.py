"""Kernels: films of one bearing at many places; they release the interpreter, so chunks run on all cores."""

from __future__ import annotations

import numpy as np

from babbitt.reynolds._compiling import compiled
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands._positions import film_at


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
