"""What the published cases of the film engine share: one bearing in numbers, grids, the load's own frame.

The tables are dimensionless, so one diameter, clearance, viscosity and speed serve all of them. Kernels are
loaded when the first film is solved, not when a case is listed.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Resolution
from babbitt.reynolds.solution import FilmSolution

Array = NDArray[np.float64]

DIAMETER, CLEARANCE, VISCOSITY, SPEED = 0.1, 1e-4, 0.02, 100.0
"""m, m, Pa s, rad/s."""

FINE = Resolution(8, 768, 48, 1e-9)
"""Grid of the cases: twice the intervals of the engine's reference grid."""

RING = (Land(0.0, 2.0 * math.pi),)


@lru_cache(maxsize=1024)
def at_position(film: JournalFilm, x: float, y: float, vx: float = 0.0, vy: float = 0.0) -> FilmSolution:
    """The film at a position (m) and velocity (m/s) of the journal."""
    from babbitt.reynolds.equilibrium.position import film_at_position

    return film_at_position(film, (x, y), (vx, vy), FINE)


@lru_cache(maxsize=256)
def at_rest(film: JournalFilm, load: float) -> FilmSolution:
    """The film under a weight (N)."""
    from babbitt.reynolds.equilibrium.solve import solve_journal

    return solve_journal(film, (0.0, -load), FINE)


def round_film(width_ratio: float) -> JournalFilm:
    """An ungrooved bore whose film starts at the widest gap and ends by the Reynolds condition."""
    return film_of(width_ratio, RING, start=FilmStart.WIDEST_GAP)


def film_of(
    width_ratio: float, lands: tuple[Land, ...], clearance: float = CLEARANCE, start: FilmStart = FilmStart.GROOVE
) -> JournalFilm:
    """The bearing of all tables with the given lands; Reynolds condition."""
    return JournalFilm(
        DIAMETER, width_ratio * DIAMETER, clearance, VISCOSITY, SPEED, lands, Cavitation.REYNOLDS, start
    )


def load_of(bearing_number: float, width_ratio: float) -> float:
    """W in N from S = η N L D/W (R/c)² on `CLEARANCE`, N in 1/s."""
    width = width_ratio * DIAMETER
    viscous = VISCOSITY * SPEED / (2.0 * math.pi) * width * DIAMETER
    return viscous * (0.5 * DIAMETER / CLEARANCE) ** 2 / bearing_number


def along_load(matrix: Array) -> Array:
    """A coefficient matrix x along the load, y 90° ahead in the sense of rotation; the load points to -y."""
    turn = np.array([[0.0, -1.0], [1.0, 0.0]])
    return np.asarray(turn @ matrix @ turn.T)


def coefficients(film: FilmSolution, load: float) -> tuple[Array, Array]:
    """K c/W and B c ω/W in the frame of the load, c being `CLEARANCE`."""
    unit = load / CLEARANCE
    return along_load(film.stiffness) / unit, along_load(film.damping) * SPEED / unit


def side_flow_ratio(film: FilmSolution) -> float:
    """Side flow over R c ω L, c being `CLEARANCE`."""
    return float(film.side_flow.sum()) / (0.5 * DIAMETER * CLEARANCE * SPEED * film.film.width)
