"""Recess and face gap: radial laminar flow that is heated by nothing but its own loss of pressure.

``dp/dr = -6 mu Q2/(pi r h³)`` and ``rho_c dtheta = -dp``: with an exponential viscosity both integrate in closed
form (specification of the study by A. S. Kirichenko, Problems of Tribology, 2011; its two applications of the
law, to recess and gap, combine exactly). Q2 is positive outwards, from the bore to the rim.

Symbols of the kernels: kappa = Int dr/(r h³) from the bore, mu0 and theta0 of the oil that comes in, alpha
exponent of viscosity, rho_c heat capacity per volume.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.model import BackflowViscosity, FaceOutlet, Footstep, LoadReference

__all__ = ["Face", "log_growth", "number", "quadrature"]

Array = NDArray[np.float64]
POINTS = 40
"""Gauss-Legendre points between recess and rim; eight already give nine digits."""


def log_growth(alpha: float, x: Array) -> Array:
    """ln(1 + alpha x)/alpha, which is x for alpha = 0."""
    return np.log1p(alpha * x) / alpha if alpha else x


def exp_growth(alpha: float, y: Array) -> Array:
    """(exp(alpha y) - 1)/alpha, the inverse of `log_growth`."""
    return np.expm1(alpha * y) / alpha if alpha else y


def number(value: float) -> Array:
    """A number for functions that take arrays."""
    return np.asarray(value)


@lru_cache(maxsize=4)
def quadrature(points: int) -> tuple[Array, Array]:
    """Nodes and weights of Gauss and Legendre on (0, 1)."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    return 0.5 * (nodes + 1.0), 0.5 * weights


@dataclass(frozen=True, eq=False)
class Face:
    """Closed forms of recess and face gap of one footstep."""

    footstep: Footstep

    def flow(self, rim_pressure: Array, rim_viscosity: Array | float = 0.0) -> Array:
        """Q2 in m³/s at a pressure of the rim (F3).

        Parameters
        ----------
        rim_pressure : ndarray
            p1, Pa.
        rim_viscosity : ndarray
            Of the oil at the rim, Pa s; used where the rim feeds the recess and the options say so.
        """
        oil, step = self.footstep.oil, self.footstep
        scale = math.pi * oil.heat_capacity / (6.0 * step.kappa)
        drop = (step.supply_pressure - rim_pressure) / oil.heat_capacity
        out = scale / oil.viscosity * exp_growth(oil.exponent, drop)
        if step.options.backflow_viscosity is BackflowViscosity.INLET:
            return out
        back = scale / np.maximum(rim_viscosity, 1e-300) * exp_growth(oil.exponent, -drop)
        return np.where(drop < 0.0, -back, out)

    def outlet_temperature(self, face_flow: Array, rim_pressure: Array) -> Array:
        """theta1'' in K: where oil leaves the face gap (F4), that of the supply where none does."""
        oil, step = self.footstep.oil, self.footstep
        if step.options.face_outlet is FaceOutlet.PRINTED:
            part = step.geometry
            kappa = math.log(part.radius / part.bore_radius) / step.face_gap**3
            x = 6.0 * oil.viscosity * np.maximum(face_flow, 0.0) * kappa / (math.pi * oil.heat_capacity)
            return oil.temperature + log_growth(oil.exponent, x)
        rise = (step.supply_pressure - rim_pressure) / oil.heat_capacity
        return np.where(face_flow > 0.0, oil.temperature + rise, oil.temperature)

    def resistance_to(self, radius: Array) -> Array:
        """Kappa from the bore to a radius in the face gap, 1/m³."""
        part, step = self.footstep.geometry, self.footstep
        inner = math.log(part.recess_radius / part.bore_radius) / part.recess_depth**3
        return np.log(radius / part.recess_radius) / step.face_gap**3 + inner

    def pressure(self, radius: Array, face_flow: float, rim_pressure: float, rim_viscosity: float) -> Array:
        """Pressure in the face gap (F5), Pa, for radii from the recess to the rim."""
        oil, step = self.footstep.oil, self.footstep
        kappa = self.resistance_to(radius)
        scale = 6.0 * face_flow / (math.pi * oil.heat_capacity)
        if face_flow < 0.0 and step.options.backflow_viscosity is BackflowViscosity.GROOVE:
            from_rim = -scale * rim_viscosity * (step.kappa - kappa)
            return rim_pressure - oil.heat_capacity * log_growth(oil.exponent, from_rim)
        drop = oil.heat_capacity * log_growth(oil.exponent, scale * oil.viscosity * kappa)
        return step.supply_pressure - drop

    def load(self, face_flow: float, rim_pressure: float, rim_viscosity: float) -> float:
        """Axial load T in N (T1, T2): ring between bore and rim, without the bore."""
        part, step = self.footstep.geometry, self.footstep
        nodes, weights = quadrature(POINTS)
        width = part.radius - part.recess_radius
        radius = np.concatenate(([part.recess_radius], part.recess_radius + width * nodes))
        pressure = self.pressure(radius, face_flow, rim_pressure, rim_viscosity)
        gap = 2.0 * math.pi * width * float(weights @ (pressure[1:] * radius[1:]))
        recess = math.pi * (part.recess_radius**2 - part.bore_radius**2)
        load = gap + 0.5 * recess * (step.supply_pressure + float(pressure[0]))
        if step.options.load_reference is LoadReference.GAUGE:
            load -= math.pi * (part.radius**2 - part.bore_radius**2) * step.ambient_pressure
        return load

    def shear_power(self, viscosity: float, angular_speed: float) -> float:
        """Friction power of recess and face gap (P3), W."""
        part, step = self.footstep.geometry, self.footstep
        gap = (part.radius**4 - part.recess_radius**4) / step.face_gap
        recess = (part.recess_radius**4 - part.bore_radius**4) / part.recess_depth
        return 0.5 * math.pi * viscosity * angular_speed**2 * (gap + recess)
