"""Axial stiffness and damping of a footstep: how its load answers to the face gap and to its change.

The face gap lies upstream of the clearance: as it opens, the pressure of the rim and with it the load rise. The
stiffness K = -dT/dh is therefore negative, and the heel finds no place of its own under a constant load: the load
must fall faster with h, or a stop must hold the heel.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.face import Face, number, quadrature
from babbitt.kinds.footstep.model import Footstep

__all__ = ["axial_damping", "centrifugal_pressure", "load_slopes"]

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

    def load_and_residual(self, unknown: float) -> tuple[float, float]:
        """Axial load, N, and defect of the balance."""


def load_slopes(model: FootstepModel, unknown: float) -> tuple[float, float]:
    """dT/dx in N/m by the face gap and by the clearance x along the balance R(q, x) = 0: T_x - T_q R_x/R_q.

    Parameters
    ----------
    model : FootstepModel
        Made of a footstep; its balance is zero at `unknown`.
    unknown : float
        q: groove flow, pressure of the rim or flow of the clearance, as the model has it.
    """
    step = model.footstep
    own = STEP * max(abs(unknown), 1e-11)  # a flow may happen to be zero
    load_own, balance_own = _difference(model, model, unknown - own, unknown + own)

    def along(thinner: Footstep, thicker: Footstep, span: float) -> float:
        load, balance = _difference(model.of(thinner), model.of(thicker), unknown, unknown)
        return (load - load_own * balance / balance_own) / span

    closed, opened = (replace(step, face_gap=one * step.face_gap) for one in (1.0 - STEP, 1.0 + STEP))
    tight, wide = (replace(step, clearance=one * step.clearance) for one in (1.0 - STEP, 1.0 + STEP))
    return along(closed, opened, 2.0 * STEP * step.face_gap), along(tight, wide, 2.0 * STEP * step.clearance)


def _difference(before: FootstepModel, behind: FootstepModel, less: float, more: float) -> tuple[float, float]:
    """What a load, N, and a balance grow by from one model and unknown to others."""
    (load, balance), (load_behind, balance_behind) = before.load_and_residual(less), behind.load_and_residual(more)
    return load_behind - load, balance_behind - balance


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
