"""Film forces of a plane pad at any height and tilt: tabulated once, by similarity good for every film.

With s = (alpha_x, alpha_y) L/h the forces on (h, alpha_x, alpha_y) are mu omega/h^2 f(s) - mu/h^3 g(s) (h', ...).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.balanced_films import BalancedFilms
from babbitt.kinds.thrust.gap import minimum_gap
from babbitt.kinds.thrust.load_curve import LoadCurve, SimilarFilms
from babbitt.kinds.thrust.pad import DEGREE, ThrustPad

__all__ = ["FilmTable", "film_table"]

Array = NDArray[np.float64]

GRID = 27
LEAST_GAP = 0.06
"""Thinnest film over the height at the pivot that the table covers."""


@dataclass(frozen=True, eq=False)
class FilmTable:
    """Bicubic splines of f (3) and g (3 x 3) over the tilts.

    Attributes
    ----------
    pad : ThrustPad
    length : float
        L, m.
    lowest, highest : ndarray, shape (2,)
        Tilts s that the table covers.
    spline : NdBSpline
        Of the twelve functions.
    """

    pad: ThrustPad
    length: float
    lowest: Array
    highest: Array
    spline: Any

    def forces(self, heights: Array, slopes: Array) -> tuple[Array, Array, Array]:
        """f h^-2 and g h^-3 per unit of viscosity and speed, and where the tilts left the table.

        Parameters
        ----------
        heights : ndarray, shape (z,)
            m.
        slopes : ndarray, shape (z, 2)
            alpha_x, alpha_y.

        Returns
        -------
        ndarray, shape (z, 3)
        ndarray, shape (z, 3, 3)
        ndarray of bool, shape (z,)
        """
        s = slopes * (self.length / heights[:, None])
        inside = np.clip(s, self.lowest, self.highest)
        values = self.spline(inside)
        outside = np.any(inside != s, axis=1)
        return (
            values[:, :3] / heights[:, None] ** 2,
            values[:, 3:].reshape(-1, 3, 3) / heights[:, None, None] ** 3,
            outside,
        )


def film_table(films: LoadCurve) -> FilmTable:
    """Tabulate the films of a plane pad about its equilibrium.

    Raises
    ------
    InputError
        E201 for a pad with a face, a crown or turbulence, whose films are not similar.
    """
    from scipy.interpolate import NdBSpline, RectBivariateSpline

    from babbitt.reynolds.sector.sector import STILL, PlaneMotion, SectorPad, sector_film

    pad = films.pad
    films = films.films if isinstance(films, BalancedFilms) else films
    if not isinstance(films, SimilarFilms):
        raise InputError(
            "E201",
            "the nonlinear motion needs plane laminar pads, whose films are similar; "
            "leave out the face, the crown and turbulence, or the nonlinear motion.",
        )
    reference = films.reference
    length, height = pad.outer_radius - pad.inner_radius, reference.height
    middle = np.array([reference.slope_x, reference.slope_y]) * length / height
    low, high = _range(pad, middle, length)
    axes = [np.linspace(low[axis], high[axis], GRID) for axis in (0, 1)]
    sector = SectorPad(pad.inner_radius, pad.outer_radius, pad.extent, 1.0, 1.0)
    values = np.empty((GRID, GRID, 12))
    to_film = pad.from_pivot()
    for i, sx in enumerate(axes[0]):
        for j, sy in enumerate(axes[1]):
            motion = to_film @ np.array([height, sx * height / length, sy * height / length])
            film = sector_film(
                sector, PlaneMotion(*(float(part) for part in motion)), STILL, pad.intervals, DEGREE
            )
            values[i, j, :3] = to_film.T @ film.forces * height**2
            values[i, j, 3:] = (to_film.T @ film.damping @ to_film).ravel() * height**3
    splines = [RectBivariateSpline(*axes, values[:, :, k]) for k in range(12)]
    knots = splines[0].tck[:2]
    coefficients = np.stack([spline.tck[2].reshape(GRID, GRID) for spline in splines], axis=-1)
    return FilmTable(pad, length, low, high, NdBSpline(knots, coefficients, 3))


def _range(pad: ThrustPad, middle: Array, length: float) -> tuple[Array, Array]:
    """Tilts about the equilibrium, drawn in until no place of the pad comes too close."""
    own = float(minimum_gap(pad, np.array([1.0, *middle / length])))
    for factor in np.linspace(1.0, 0.05, 40):
        low = middle + factor * np.array([-0.6, 1.4 * middle[1]])
        high = middle + factor * np.array([0.6, -1.4 * middle[1]])
        ends = [np.array([1.0, sx / length, sy / length]) for sx in (low[0], high[0]) for sy in (low[1], high[1])]
        if float(minimum_gap(pad, np.array(ends)).min()) >= min(LEAST_GAP, 0.5 * own):
            break
    return low, high
