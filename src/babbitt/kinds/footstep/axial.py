"""Axial stiffness and damping of a footstep: how its load answers to the face gap and to its change.

The face gap lies upstream of the clearance: as it opens, the pressure of the rim and with it the load rise. The
stiffness K = -dT/dh is therefore negative, and the heel finds no place of its own under a constant load: the load
must fall faster with h, or a stop must hold the heel.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.face import Face, number, quadrature
from babbitt.kinds.footstep.model import Footstep

__all__ = ["axial_damping", "centrifugal_pressure", "load_slope"]

Array = NDArray[np.float64]
STEP = 1e-4
"""Relative step of the central differences: their error is its square, far above round-off."""


class FootstepModel(Protocol):
    """A footstep whose balance has one unknown."""

    @property
    def footstep(self) -> Footstep:
        """What it is made for."""

    def of(self, footstep: Footstep) -> FootstepModel:
        """The same model of another footstep."""

    def residual(self, unknown: Array) -> Array:
        """Defect of the balance."""

    def load_at(self, unknown: float) -> float:
        """Axial load, N."""


def _changed(footstep: Footstep, length: Literal["face_gap", "clearance"], factor: float) -> Footstep:
    if length == "face_gap":
        return replace(footstep, face_gap=factor * footstep.face_gap)
    return replace(footstep, clearance=factor * footstep.clearance)


def load_slope(model: FootstepModel, unknown: float, length: Literal["face_gap", "clearance"]) -> float:
    """dT/d(length) in N/m along the balance R(x, h) = 0: T_h - T_x R_h/R_x.

    Parameters
    ----------
    model : FootstepModel
        Made of a footstep; its balance is zero at `unknown`.
    unknown : float
        Groove flow, pressure of the rim or flow of the clearance, as the model has it.
    length : {"face_gap", "clearance"}
        The field of the footstep that changes.
    """
    size = model.footstep.face_gap if length == "face_gap" else model.footstep.clearance
    thinner, thicker = (model.of(_changed(model.footstep, length, 1.0 + sign * STEP)) for sign in (-1.0, 1.0))
    step = STEP * max(abs(unknown), 1e-11)  # a flow may happen to be zero
    less, more = unknown - step, unknown + step
    span_h, span_x = 2.0 * STEP * size, more - less

    def residual(of: FootstepModel, at: float) -> float:
        return float(of.residual(number(at)))

    load_length = (thicker.load_at(unknown) - thinner.load_at(unknown)) / span_h
    load_unknown = (model.load_at(more) - model.load_at(less)) / span_x
    balance_length = (residual(thicker, unknown) - residual(thinner, unknown)) / span_h
    balance_unknown = (residual(model, more) - residual(model, less)) / span_x
    return load_length - load_unknown * balance_length / balance_unknown


def axial_damping(footstep: Footstep, viscosity: float, outflow_slope: float) -> float:
    """D = -dT/dh' in N s/m of recess and face gap, one viscosity, oil incompressible.

    Opening at h' the gap takes in ``pi (r² - r2²) h'``: ``dp/dr = -(6 mu/(pi r h³)) (Q2 - pi (r² - r2²) h')``. The
    pressure at the bore stays, and what arrives at the rim leaves through the clearance with the slope given. The
    temperatures are those of the steady state.

    Parameters
    ----------
    footstep : Footstep
    viscosity : float
        Of the oil in the face gap, Pa s.
    outflow_slope : float
        d(outflow of the clearance)/dp1, m³/(s Pa).
    """
    part, face = footstep.geometry, Face(footstep)
    nodes, weights = quadrature(24)
    width = part.radius - part.recess_radius
    radius = part.recess_radius + width * nodes

    def taken(inner: float, outer: Array, gap: float) -> Array:
        """Int (r² - r2²)/(r gap³) dr."""
        square = 0.5 * (outer**2 - inner**2) - part.bore_radius**2 * np.log(outer / inner)
        return np.asarray(square / gap**3)

    recess = taken(part.bore_radius, number(part.recess_radius), part.recess_depth)
    filled = recess + taken(part.recess_radius, np.append(radius, part.radius), footstep.face_gap)
    kappa = np.append(face.resistance_to(radius), footstep.kappa)
    scale = 6.0 * viscosity / math.pi
    area = math.pi * (part.radius**2 - part.bore_radius**2)
    # p1' = -scale (Q2' kappa1 - pi filled1) and Q2' - area = slope p1', all per h'.
    rim = -scale * (area * kappa[-1] - math.pi * filled[-1]) / (1.0 + scale * kappa[-1] * outflow_slope)
    flow = area + outflow_slope * rim
    pressure = -scale * (flow * kappa - math.pi * filled)
    edge = -scale * (flow * face.resistance_to(number(part.recess_radius)) - math.pi * recess)
    load = 2.0 * math.pi * width * float(weights @ (pressure[:-1] * radius))
    load += 0.5 * math.pi * (part.recess_radius**2 - part.bore_radius**2) * float(edge)
    return -load


def centrifugal_pressure(footstep: Footstep) -> float:
    """0.15 rho omega² (r1² - r3²), Pa: what rotation adds from recess to rim (inertia of a laminar film)."""
    part = footstep.geometry
    square = part.radius**2 - part.recess_radius**2
    return 0.15 * footstep.oil.density * footstep.angular_speed**2 * square
