"""A slow and simple film to measure the fast ones by: five-point finite volumes, sparse LU, active set.

It shares no line with the engine. Reynolds equation of one land, dimensionless (h by c, p by mu omega (R/c)^2),
    d/dtheta(h^3/12 dp/dtheta) + (D/B)^2 d/dzeta(h^3/12 dp/dzeta) = dh/dtheta / 2 + dh/dt,   p >= 0,
on a uniform grid of half the width, p = 0 at grooves and sides, second order in both directions. Two grids and one
extrapolation give the position; derivatives of the force are central differences.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import diags_array
from scipy.sparse.linalg import splu

Array = NDArray[np.float64]


class SimpleLand:
    """One land of a round bore between two grooves; keeps the wet set from one position to the next."""

    def __init__(self, start: float, end: float, width_ratio: float, intervals: int, cells: int) -> None:
        self.theta = np.linspace(start, end, intervals + 1)
        self.step, self.kappa = (end - start) / intervals, 1.0 / width_ratio**2
        self.cells = cells  # over half the width: zeta from 0 at mid-plane to 1 at the side
        self.wet = np.ones((intervals - 1, cells), dtype=bool)

    def force(self, x: float, y: float, x_rate: float = 0.0, y_rate: float = 0.0) -> Array:
        """Force of the film over mu omega (R/c)^2 R B."""
        pressure = self._pressure(x, y, x_rate, y_rate).mean(axis=1)
        inner = self.theta[1:-1]
        return -self.step * np.array([pressure @ np.cos(inner), pressure @ np.sin(inner)])

    def _pressure(self, x: float, y: float, x_rate: float, y_rate: float) -> Array:
        """Complementarity by the primal-dual active set, from the wet set of the last call."""
        n, m, dz = self.theta.size - 2, self.cells, 1.0 / self.cells

        def gap(angle: Array) -> Array:
            return 1.0 - x * np.cos(angle) - y * np.sin(angle)

        faces = 0.5 * (self.theta[1:] + self.theta[:-1])
        along = gap(faces) ** 3 / 12.0 * dz / self.step
        across = self.kappa * gap(self.theta[1:-1]) ** 3 / 12.0 * self.step / dz
        squeeze = -(x_rate * np.cos(self.theta[1:-1]) + y_rate * np.sin(self.theta[1:-1])) * self.step
        source = np.repeat((0.5 * np.diff(gap(faces)) + squeeze)[:, None] * dz, m, axis=1)
        couple_z = np.repeat(across[:, None], m, axis=1)
        couple_z[:, -1] = 0.0
        centre = (along[1:] + along[:-1])[:, None] + couple_z + np.roll(couple_z, 1, axis=1)
        centre[:, -1] += 2.0 * across  # half a cell to the side edge, where p = 0
        east, north = np.repeat(along[1:-1], m), couple_z.ravel()[:-1]
        matrix = diags_array([centre.ravel(), -east, -east, -north, -north], offsets=[0, m, -m, 1, -1]).tocsr()
        right = -source.ravel()
        wet = self.wet.ravel().copy()
        for _ in range(400):
            pressure = np.zeros(n * m)
            part = np.flatnonzero(wet)
            pressure[part] = splu(matrix[part][:, part].tocsc()).solve(right[part])
            slack = matrix @ pressure - right
            new = np.where(wet, pressure > 0.0, slack < 0.0)
            if np.array_equal(new, wet):
                break
            wet = new
        self.wet = wet.reshape(n, m)
        return pressure.reshape(n, m)


def equilibrium(lands: list[SimpleLand], load: Array, start: Array, stiffness: Array) -> Array:
    """Journal position over c for a dimensionless load; the stiffness steers the iteration and may be rough."""
    at = start.copy()
    for _ in range(30):
        residual = sum((land.force(*at) for land in lands), load.copy())
        if np.hypot(*residual) < 1e-9 * np.hypot(*load):
            return at
        at = at + np.linalg.solve(stiffness, residual)
    raise RuntimeError("the reference did not settle")


def coefficients(lands: list[SimpleLand], at: Array, step: float) -> tuple[Array, Array]:
    """K and C, dimensionless, by central differences of the force."""
    columns = []
    state = np.array([*at, 0.0, 0.0])
    for change in np.eye(4) * step:
        rise = sum((land.force(*(state + change)) - land.force(*(state - change)) for land in lands), np.zeros(2))
        columns.append(-rise / (2.0 * step))
    return np.array(columns[:2]).T, np.array(columns[2:]).T
