"""The equilibrium of a journal close to a given place, by root finders on the film at prescribed positions."""

from __future__ import annotations

import math
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.model import JournalFilm, Resolution

if TYPE_CHECKING:
    from babbitt.reynolds.solution import FilmSolution

__all__ = ["SAME_PLACE", "equilibrium_near"]

Array = NDArray[np.float64]

CONTACT = 1e3
"""Force that pushes a journal back which touches, over the stiffness times the clearance at the start of a
search."""

CARRIED = 1e-2
"""Share of the load that the film of an equilibrium may miss."""

SAME_PLACE = 1e-3
"""Distance over the clearance below which two equilibria are one."""


def equilibrium_near(
    film: JournalFilm, load: tuple[float, float], start: tuple[float, float], resolution: Resolution
) -> FilmSolution | None:
    """The equilibrium that a root finder reaches from a start in m under a load in N, None where it reaches none.

    Powell's hybrid method is quick, but updates the stiffness by secants and gets lost where it rises steeply;
    least squares with the exact stiffness at every step are tried then.
    """
    frame = LoadFrame.of(film, load)
    found = _in_its_frame(frame.film, frame.load, frame.start(start), resolution)
    return None if found is None else frame.back(found)


def _in_its_frame(
    film: JournalFilm, load: tuple[float, float], start: tuple[float, float], resolution: Resolution
) -> FilmSolution | None:
    """`equilibrium_near` of a film whose load points down."""
    from scipy.optimize import least_squares, root

    c = film.clearance
    begun, wanted = film_at_position(film, start, resolution=resolution), np.asarray(load)
    if not begun.outcome.solved:
        return None
    unit = float(np.linalg.norm(begun.stiffness)) * c or math.hypot(*load) or 1.0  # a dry film has no stiffness

    @cache  # force and stiffness are asked for one after the other
    def film_at(x: float, y: float) -> FilmSolution:
        return film_at_position(film, (x * c, y * c), resolution=resolution)

    def film_there(place: Array) -> FilmSolution | None:
        """None also where a step along a slope that vanishes ended nowhere."""
        found = film_at(float(place[0]), float(place[1])) if np.isfinite(place).all() else None
        return found if found is not None and found.outcome.solved else None

    def residual(place: Array) -> Array:
        found = film_there(place)
        away = np.nan_to_num(place / math.hypot(*place), nan=1.0)
        return -CONTACT * away if found is None else (found.force + wanted) / unit

    def slope(place: Array) -> Array:
        found = film_there(place)
        if found is None:
            return np.asarray(-CONTACT * np.eye(2) * np.nan_to_num(1.0 / math.hypot(*place), nan=1.0))
        return np.asarray(-found.stiffness * c / unit)

    def settled(place: Array) -> FilmSolution | None:
        found = film_there(place)
        if found is None or np.linalg.matrix_rank(found.stiffness) < 2:  # a dry film holds nothing
            return None
        missing = found.force + wanted
        step = np.linalg.solve(found.stiffness, missing)
        carried = float(np.linalg.norm(missing)) <= CARRIED * (math.hypot(*load) or unit)
        return found if carried and float(np.linalg.norm(step)) < 0.1 * SAME_PLACE * c else None

    quick = root(residual, np.asarray(start) / c, jac=slope, method="hybr", options={"xtol": 1e-9, "maxfev": 60})
    return settled(quick.x) or settled(
        least_squares(residual, np.asarray(start) / c, slope, xtol=1e-9, ftol=1e-14, gtol=1e-14, max_nfev=60).x
    )
