"""Kernels: a journal that is nearly in equilibrium among its pads, on wet sets as they stand."""

from __future__ import annotations

import math

import numpy as np

from babbitt.reynolds._compiling import compiled
from babbitt.reynolds.lands._grids import new_film, new_lines, uniform_lines
from babbitt.reynolds.tilting_pads._pad_heat import heat_pads, prepare_films
from babbitt.reynolds.tilting_pads._pads import journal_step
from babbitt.reynolds.tilting_pads._place import all_found, any_pad_is, longest_step, place_all
from babbitt.reynolds.tilting_pads._tilt import AT_LIMIT, ROOT_MOMENT

MOST_SHORT_STEPS = 5


@compiled
def step_pads(axial, pads, grid, load_x, load_y, x, y, tolerance, places, total):
    """Newton steps without a search along them: x, y, steps, and whether the force vanishes at the end.

    Pads may have bent since the last time; their lines stand. Tilts are tight: loose ones carry beyond folds.
    """
    n, m = grid.step.shape[1], len(axial.size)
    film, lines = new_film(n), new_lines(n, m)
    uniform_lines(pads.bearing, grid)
    floor = tolerance * math.hypot(load_x, load_y) + 1e-13
    for step in range(MOST_SHORT_STEPS):
        if not place_all(axial, pads, grid, film, lines, x, y, ROOT_MOMENT, places, total):
            return x, y, step, False
        rx, ry = total[0] + load_x, total[1] + load_y
        if math.hypot(rx, ry) <= floor:
            return x, y, step, all_found(places) and not any_pad_is(places, AT_LIMIT)
        dx, dy = journal_step(total, rx, ry)
        if longest_step(pads, places, dx, dy) < 1.0:
            return x, y, step, False
        x, y = x + dx, y + dy
    return x, y, MOST_SHORT_STEPS, False


@compiled
def step_heated_pads(
    axial, pads, grid, load_x, load_y, x, y, tolerance, places, total, ring, columns, flows, cells, oil, walls,
    films, totals, fresh, part,
):  # fmt: skip
    """`prepare_films`, `step_pads` and, where the force vanishes, `heat_pads`: handing all over once takes a third
    of the time.

    Returns what viscosities differ by, x, y, steps, whether the force vanishes, and the change of temperature.
    """
    behind = prepare_films(pads, ring, columns, flows, films, fresh, part)
    x, y, steps, found = step_pads(axial, pads, grid, load_x, load_y, x, y, tolerance, places, total)
    change = np.inf
    if found:
        change = heat_pads(axial, pads, grid, places, ring, columns, flows, cells, oil, walls, films, totals)
    return behind, x, y, steps, found, change
