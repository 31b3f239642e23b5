"""Pads with one recess by closed forms: flow, effective area and squeeze of their lands.

All follow from the flow between parallel planes; for a gap h and viscosity mu

    G = q_s h^3/(12 mu),    W = A_e p_r,    C_s = s mu/h^3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, PadShape, RectangularPad

__all__ = ["Lands", "crude_lands", "lands_of", "rectangular_lands"]

CORNER_FLOW = 1.0 - 2.0 * math.log(2.0) / math.pi
"""Squares of a strip that a right-angled corner is worth (conformal map)."""

CORNER_LOAD = 0.144837
"""Load of a corner over a^2 and the recess pressure; computed, converged to the digits shown."""

CORNER_SQUEEZE = 1.217
"""Squeeze of a corner over mu a^4/h^3; computed with the film, good to 1e-3."""


@dataclass(frozen=True)
class Lands:
    """What the lands of a pad with one recess do.

    Attributes
    ----------
    flow_factor : float
        q_s = 12 mu G/h^3.
    effective_area : float
        A_e = W/p_r, m2.
    squeeze_factor : float
        s = C_s h^3/mu, m4, all edges held.
    friction_area : float
        Integral of r^2 over the lands, m4; times mu omega^2/h their friction power.
    """

    flow_factor: float
    effective_area: float
    squeeze_factor: float
    friction_area: float = 0.0

    def conductance(self, gap: float, viscosity: float) -> float:
        """G, m3/(s Pa)."""
        return self.flow_factor * gap**3 / (12.0 * viscosity)

    def squeeze_damping(self, gap: float, viscosity: float) -> float:
        """C_s, N s/m."""
        return self.squeeze_factor * viscosity / gap**3


def ring_squeeze(inner: float, outer: float) -> float:
    """C_s h^3/mu of a ring with both edges held, m4."""
    return 1.5 * math.pi * (outer**4 - inner**4 - (outer**2 - inner**2) ** 2 / math.log(outer / inner))


def ring_friction(inner: float, outer: float) -> float:
    """Integral of r^2 over a ring, m4."""
    return 0.5 * math.pi * (outer**4 - inner**4)


def lands_of(pad: PadShape) -> Lands:
    """Lands of a pad; those of a rectangle with unequal lands by the crude strips.

    Parameters
    ----------
    pad : PadShape

    Returns
    -------
    Lands

    Examples
    --------
    >>> round(lands_of(CircularPad(0.05, 0.025)).effective_area * 1e6, 3)
    4249.088
    """
    if isinstance(pad, CircularPad):
        span = math.log(pad.outer_radius / pad.recess_radius)
        area = 0.5 * math.pi * (pad.outer_radius**2 - pad.recess_radius**2) / span
        return Lands(2.0 * math.pi / span, area, ring_squeeze(pad.recess_radius, pad.outer_radius),
                     ring_friction(pad.recess_radius, pad.outer_radius))  # fmt: skip
    if isinstance(pad, AnnularPad):
        r1, r2, r3, r4 = pad.radii
        inner, outer = math.log(r2 / r1), math.log(r4 / r3)
        area = 0.5 * math.pi * ((r4**2 - r3**2) / outer - (r2**2 - r1**2) / inner)
        return Lands(2.0 * math.pi * (1.0 / inner + 1.0 / outer), area, ring_squeeze(r1, r2) + ring_squeeze(r3,
        r4),
                     ring_friction(r1, r2) + ring_friction(r3, r4))  # fmt: skip
    along, aside = pad.lands
    return rectangular_lands(pad) if math.isclose(along, aside, rel_tol=1e-6) else crude_lands(pad)


def rectangular_lands(pad: RectangularPad) -> Lands:
    """Rectangle whose lands are equally wide on all sides: strips and corners."""
    a, (lx, ly) = pad.lands[0], (pad.recess_length, pad.recess_width)
    return Lands(
        2.0 * (lx + ly) / a + 4.0 * CORNER_FLOW,
        lx * ly + (lx + ly) * a + 4.0 * CORNER_LOAD * a * a,
        2.0 * (lx + ly) * a**3 + 4.0 * CORNER_SQUEEZE * a**4,
    )


def crude_lands(pad: RectangularPad) -> Lands:
    """Hand-sheet rectangle: strips without corners, mean of pad and recess area."""
    (ax, ay), lx, ly = pad.lands, pad.recess_length, pad.recess_width
    return Lands(2.0 * (lx / ay + ly / ax), 0.5 * (pad.area + pad.recess_area), 2.0 * (lx * ay**3 + ly * ax**3))
