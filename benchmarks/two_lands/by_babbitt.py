"""Babbitt's side: import, first call, and warm calls of the compiled kernel and of the public function."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import pi
from time import perf_counter

begun = perf_counter()

import numpy as np  # noqa: E402

import babbitt  # noqa: E402
from babbitt.reynolds.equilibrium.cavitating_film import kernel_bearing  # noqa: E402
from babbitt.reynolds.equilibrium.solve import solve_journal  # noqa: E402
from babbitt.reynolds.lands._equilibrium import find_equilibrium  # noqa: E402
from babbitt.reynolds.lands._forces import RESULT_SIZE  # noqa: E402
from babbitt.reynolds.lands.operators import kernel_operator  # noqa: E402
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution, grooved_bore  # noqa: E402
from babbitt.reynolds.scales import Scales  # noqa: E402

imported = perf_counter()

from case import CLEARANCE, DIAMETER, LAND, LOAD, SPEED, VISCOSITY, WIDTH, answer, row, timed  # noqa: E402

GRIDS = {"4 x 48": Resolution(4, 48, 12), "4 x 96": Resolution(4, 96, 24), "6 x 192": Resolution(6, 192, 24)}
MODELS = {"reynolds": Cavitation.REYNOLDS, "mass-conserving": Cavitation.MASS_CONSERVING}


def film_of(cavitation: Cavitation) -> JournalFilm:
    lands = grooved_bore((0.0, pi), pi - LAND)
    return JournalFilm(DIAMETER, WIDTH, CLEARANCE, VISCOSITY, SPEED, lands, cavitation=cavitation)


def kernel_call(film: JournalFilm, resolution: Resolution) -> Callable[[], object]:
    """The compiled equilibrium with its eight coefficients, from the centre, without a result object."""
    scales = Scales.of(film, SPEED)
    arguments = (
        kernel_operator(resolution.axial_unknowns),
        kernel_bearing(film, scales),
        resolution.coarse_intervals,
        resolution.intervals,
        0.0,
        -LOAD / scales.force,
        0.0,
        0.0,
        resolution.tolerance,
        80,
        np.zeros(RESULT_SIZE),
    )
    return partial(find_equilibrium, *arguments)


def main() -> None:
    begun_first = perf_counter()
    solve_journal(film_of(Cavitation.MASS_CONSERVING), (0.0, -LOAD))
    first = perf_counter() - begun_first
    rows = []
    for model, cavitation in MODELS.items():
        film = film_of(cavitation)
        for mesh, resolution in GRIDS.items():
            solved = solve_journal(film, (0.0, -LOAD), resolution)
            found = {
                "position": (solved.position / CLEARANCE).tolist(),
                "stiffness": solved.stiffness.tolist(),
                "damping": solved.damping.tolist(),
            }
            kernel = timed(kernel_call(film, resolution), 0.4)
            public = timed(partial(solve_journal, film, (0.0, -LOAD), resolution), 0.4)
            rows.append(row("Babbitt kernel", model, mesh, kernel, **found))
            rows.append(row("Babbitt solve_journal", model, mesh, public, **found))
    answer({"version": babbitt.__version__, "import": imported - begun, "first": first, "rows": rows})


if __name__ == "__main__":
    main()
