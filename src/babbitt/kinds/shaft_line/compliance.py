"""How line and pads answer to the nonlinear part of the film forces, at all harmonics of a period at once.

With the film of pad i linear about its static state and n_i what is added to its force and moments,

    t_i = S_i (n_t - (K + j nu C)_t1 h_i),   S_i = (K_tt + j nu C_tt - nu^2 J)^-1,
    N_i = -kt_i h_i + n_1 - (K + j nu C)_1t S_i n_t,   h_i = x_i - xi_i - U2,
    (c - nu^2 m4) x_i = N_i + c U_h,   D U2 = -sum N_i + tau Q,

where D and tau follow from the rods between propeller and collar. Every pad is eliminated by itself, so that two
unknowns are left, the collar and the housing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.pads import FilmPads

__all__ = ["LineCompliance", "line_compliance"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class LineCompliance:
    """Line and pads at the harmonics of a period.

    Attributes
    ----------
    frequencies : ndarray, shape (n,)
        From 0, rad/s.
    line : ShaftLine
    pads : FilmPads
    at_collar : ndarray, shape (n,)
        D, N/m.
    passed_on : ndarray, shape (n,)
        tau: thrust at the collar over that at the propeller.
    film : ndarray, shape (n, z, 3, 3)
        K + j nu C.
    freed : ndarray, shape (n, z, f, f)
        S of the free tilts.
    """

    frequencies: Array
    line: ShaftLine
    pads: FilmPads
    at_collar: ComplexArray
    passed_on: ComplexArray
    film: ComplexArray
    freed: ComplexArray

    def motions(self, thrust: ComplexArray, runout: ComplexArray, added: ComplexArray) -> ComplexArray:
        """Changes of height and slopes of every gap.

        Parameters
        ----------
        thrust : ndarray, shape (n,)
            Q, N.
        runout : ndarray, shape (n, z)
            xi_i, m.
        added : ndarray, shape (n, z, 3)
            n_i: nonlinear part of force and moments, N and N m.

        Returns
        -------
        ndarray, shape (n, z, 3)
        """
        free = list(self.pads.bearing.pad.free_tilts)
        own, force = self.film[..., 0, 0], added[..., 0]
        if free:
            follow = (self.freed @ self.film[..., free, 0][..., None])[..., 0]
            answer = (self.freed @ added[..., free][..., None])[..., 0]
            own = own - (self.film[..., 0, free] * follow).sum(axis=-1)
            force = force - (self.film[..., 0, free] * answer).sum(axis=-1)
        gap = self._gaps(thrust, runout, own, force)
        motions = np.zeros(added.shape, dtype=np.complex128)
        motions[..., 0] = gap
        if free:
            motions[..., free] = answer - follow * gap[..., None]
        return motions

    def _gaps(
        self, thrust: ComplexArray, runout: ComplexArray, own: ComplexArray, force: ComplexArray
    ) -> ComplexArray:
        """Changes of the gaps at the pivots, m, shape (n, z)."""
        c, nu, z = self.pads.ring_stiffness, self.frequencies, runout.shape[1]
        if math.isinf(c):
            collar = (self.passed_on * thrust - (own * runout + force).sum(axis=1)) / (
                self.at_collar + own.sum(axis=1)
            )
            return np.asarray(-runout - collar[:, None])
        support = (c - nu**2 * self.pads.pad_mass)[:, None]
        shared = 1.0 + own / support
        # N_i = a (U2 + xi_i - (c / support) U_h) + b
        a, b = own / shared, force / shared
        at_rest = a * runout + b
        right = self.passed_on * thrust - at_rest.sum(axis=1)
        collar_row, ratio = self.at_collar + a.sum(axis=1), c / support[:, 0]
        if self.line.seating is None:
            collar, housing = right / collar_row, np.zeros(nu.size, dtype=complex)
        else:
            seat = self.line.seating
            stiff = seat.stiffness + 1j * nu * seat.damping - nu**2 * seat.housing_mass + z * c
            # stiff U_h = c sum x_i, x_i = (N_i + c U_h) / support
            housing_row = stiff - z * c * ratio + ratio**2 * a.sum(axis=1)
            cross = ratio * a.sum(axis=1)
            pushed = ratio * at_rest.sum(axis=1)
            determinant = collar_row * housing_row - cross**2
            collar = (right * housing_row + cross * pushed) / determinant
            housing = (collar_row * pushed + cross * right) / determinant
        loads = a * (collar[:, None] + runout - ratio[:, None] * housing[:, None]) + b
        displaced = (loads + c * housing[:, None]) / support
        return np.asarray(displaced - runout - collar[:, None])


def line_compliance(line: ShaftLine, pads: FilmPads, frequencies: Array) -> LineCompliance:
    """Line and pads at frequencies from 0, rad/s; none that of a rod between fixed ends.

    Parameters
    ----------
    line : ShaftLine
    pads : FilmPads
    frequencies : ndarray, shape (n,)
    """
    nu = np.asarray(frequencies, dtype=np.float64)
    at_collar = -(nu**2) * line.masses[0] + 1j * nu * line.propeller_damping
    passed_on = np.ones(nu.size, dtype=complex)
    for rod, mass in zip(line.rods, line.masses[1:], strict=True):
        angle = np.maximum(nu * rod.transit_time, 1e-12)
        own, cross = rod.stiffness * angle / np.tan(angle), -rod.stiffness * angle / np.sin(angle)
        passed_on = passed_on * -cross / (at_collar + own)
        at_collar = own - cross**2 / (at_collar + own) - nu**2 * mass
    film, moving, free = pads.moving(nu)
    freed = np.asarray(np.linalg.inv(moving) if free else moving, dtype=np.complex128)
    return LineCompliance(nu, line, pads, at_collar, passed_on, film, freed)
