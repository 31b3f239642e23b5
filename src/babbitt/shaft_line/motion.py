"""Rates of the nonlinear motion: pads on the film forces of any height and tilt, the shaft as rods."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.shaft_line.elements import shaft_elements
from babbitt.shaft_line.model import LineState
from babbitt.thrust.film_table import FilmTable

__all__ = ["Motion"]

Array = NDArray[np.float64]

RODS = 3


class Motion:
    """Rates of (U, V, [U_h, V_h,] x, alpha_x, alpha_y); massless pads follow their films.

    A film pushes and does not pull: where the sum of wedge and squeeze would be below zero the film ruptures and
    the pad carries nothing. Until then the film counts whole.
    """

    def __init__(self, state: LineState, table: FilmTable) -> None:
        duty, bearing = state.duty, state.duty.bearing
        self.duty, self.bearing, self.table = duty, bearing, table
        self.viscosity, self.c = state.films.viscosity, bearing.ring_stiffness
        self.rigid = math.isinf(self.c)
        shaft = shaft_elements(duty.line, RODS)
        self.n, self.z = shaft.mass.shape[0], bearing.number
        self.inverse_mass = np.linalg.inv(shaft.mass)
        self.shaft, self.base = shaft, state.share.approach + bearing.departures()
        self.mean_thrust = state.share.thrust
        self.seat = duty.line.seating
        self.held = [tilt for tilt in (1, 2) if tilt not in bearing.pad.free_tilts]
        self.outside = False

    def split(self, y: Array) -> tuple[Array, Array, Array, Array, Array]:
        """U, V, housing (2,), x, slopes (z, 2)."""
        n, z = self.n, self.z
        housing = y[2 * n : 2 * n + 2] if self.seat is not None else np.zeros(2)
        at = 2 * n + (2 if self.seat is not None else 0)
        return y[:n], y[n : 2 * n], housing, y[at : at + z], y[at + z :].reshape(2, z).T

    def runout(self, time: float) -> tuple[Array, Array]:
        """xi_i and its rate."""
        xi, rate = np.zeros(self.z), np.zeros(self.z)
        speed = self.duty.speed
        for part in self.duty.runouts:
            phase = part.order * (speed * time - self.bearing.phases()) + part.phase
            xi += part.amplitude * np.cos(phase)
            rate -= part.amplitude * part.order * speed * np.sin(phase)
        return xi, rate

    def pads(self, time: float, y: Array) -> tuple[Array, Array, Array, Array]:
        """Gaps, rates (z, 3) of gap and tilts, loads on the collar, and rates of x."""
        u, v, housing, x, slopes = self.split(y)
        xi, xi_rate = self.runout(time)
        gaps = np.maximum(self.base + x - u[-1] - xi, 1e-9)
        wedge, squeeze, outside = self.table.forces(gaps, slopes)
        self.outside = self.outside or bool(outside.any())
        right = wedge * (self.viscosity * self.duty.speed)
        matrix = squeeze * self.viscosity
        for tilt in self.held:
            matrix = matrix.copy()
            matrix[:, tilt, :], matrix[:, :, tilt] = 0.0, 0.0
            matrix[:, tilt, tilt], right[:, tilt] = 1.0, 0.0
        if self.rigid:
            closing = -v[-1] - xi_rate
            tilts = np.linalg.solve(
                matrix[:, 1:, 1:], (right[:, 1:] - matrix[:, 1:, 0] * closing[:, None])[..., None]
            )
            rates = np.asarray(np.concatenate([closing[:, None], tilts[..., 0]], axis=1), dtype=np.float64)
            loads = np.maximum(right[:, 0] - (matrix[:, 0, :] * rates).sum(axis=1), 0.0)
            return gaps, rates, loads, np.zeros(self.z)
        loads = self.c * np.maximum(x - housing[0], 0.0)
        right[:, 0] -= loads
        rates = np.asarray(np.linalg.solve(matrix, right[..., None])[..., 0], dtype=np.float64)
        x_rate = rates[:, 0] + v[-1] + xi_rate
        # an unloaded ring is not pulled by the film: the pad stays on it while the collar goes away
        x_rate = np.where(x <= housing[0], np.maximum(x_rate, housing[1]), x_rate)
        return gaps, rates, loads, x_rate

    def __call__(self, time: float, y: Array) -> Array:
        """Rates of the state."""
        u, v, housing, _, _ = self.split(y)
        _, rates, loads, x_rate = self.pads(time, y)
        force = -self.shaft.stiffness @ u - self.shaft.damping @ v
        for part in self.duty.thrusts:
            force[0] += part.amplitude * math.cos(part.order * self.duty.speed * time + part.phase)
        force[-1] -= loads.sum() - self.mean_thrust
        parts = [v, self.inverse_mass @ force]
        if self.seat is not None:
            seat = self.seat
            pull = loads.sum() - self.mean_thrust - seat.stiffness * housing[0] - seat.damping * housing[1]
            parts.append(np.array([housing[1], pull / max(seat.housing_mass, 1.0)]))
        return np.concatenate([*parts, x_rate, rates[:, 1], rates[:, 2]])
