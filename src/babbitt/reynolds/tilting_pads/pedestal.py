"""A pedestal that gives way under a bearing of tilting pads.

Films and pivots feel the journal relative to the housing. With the motions (x, y | pads | X, Y), X and Y those of
the housing and x, y those of the journal in space, the relative journal is x - X, and the forces on it act back on
the housing. A pad moves with the housing and by its own motions: with the way of its centre of gravity g per own
motion its mass m couples both by m g.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.tilting_pads.dynamics import PadCoefficients
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing

__all__ = ["Pedestal", "on_pedestal"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Pedestal:
    """What carries the housing of a bearing, along x and along y.

    Attributes
    ----------
    stiffness : tuple of float
        N/m.
    damping : tuple of float
        N s/m.
    mass : float
        That moves with the housing, without the pads, kg.
    """

    stiffness: tuple[float, float]
    damping: tuple[float, float] = (0.0, 0.0)
    mass: float = 0.0

    def __post_init__(self) -> None:
        if not min(self.stiffness) > 0.0:
            raise InputError("E101", f"stiffness of the pedestal is {self.stiffness} N/m; it must be positive.")
        if not min(*self.damping, self.mass) >= 0.0:
            raise InputError("E101", "damping and mass of the pedestal must not be negative.")

    def deflection(self, load: Sequence[float]) -> tuple[float, float]:
        """Way of the housing along x and y, m, under the load on the journal, N."""
        return load[0] / self.stiffness[0], load[1] / self.stiffness[1]


def on_pedestal(coefficients: PadCoefficients, bearing: TiltingPadBearing, pedestal: Pedestal) -> PadCoefficients:
    """Journal and pads in a housing that moves on a pedestal; x and y are the journal in space.

    Parameters
    ----------
    coefficients : PadCoefficients
        Of journal and pads in a housing at rest.
    bearing : TiltingPadBearing
        To which they belong.
    pedestal : Pedestal
    """
    size = len(coefficients.labels)
    relative = np.hstack([np.eye(size), np.zeros((size, 2))])
    relative[:2, size:] = -np.eye(2)
    mass, damping, stiffness = (
        relative.T @ part @ relative for part in (coefficients.mass, coefficients.damping, coefficients.stiffness)
    )
    housing = slice(size, size + 2)
    momenta = pad_momenta(coefficients, bearing)
    mass[housing, :size] += momenta
    mass[:size, housing] += momenta.T
    mass[housing, housing] += (pedestal.mass + sum(pad.mass for pad in bearing.pads)) * np.eye(2)
    damping[housing, housing] += np.diag(pedestal.damping)
    stiffness[housing, housing] += np.diag(pedestal.stiffness)
    return replace(
        coefficients,
        labels=(*coefficients.labels, "pedestal x", "pedestal y"),
        mass=mass,
        damping=damping,
        stiffness=stiffness,
        levers=np.concatenate((coefficients.levers, (1.0, 1.0))),
    )


def pad_momenta(coefficients: PadCoefficients, bearing: TiltingPadBearing) -> Array:
    """Momentum of the pads along x and y per speed of every motion, kg, shape (2, n)."""
    momenta = np.zeros((2, len(coefficients.labels)))
    for place, label in enumerate(coefficients.labels[2:], 2):
        _, number, name = label.split(" ")
        pad = bearing.pads[int(number) - 1]
        momenta[:, place] = pad.mass * way_of_gravity(bearing, pad, name)
    return momenta


def way_of_gravity(bearing: TiltingPadBearing, pad: TiltingPad, motion: str) -> Array:
    """Way of the centre of gravity of a pad per own motion, shape (2,); the signs are those of `fill_pad`."""
    outward, along = np.array(pad.normal()), np.array(pad.tangent())
    if motion == "pivot":
        return outward
    if motion == "tangential":
        return along
    if motion == "bending":  # not coupled with the ways of the pad as a whole
        return np.zeros(2)
    return -(bearing.sense * pad.mass_offset * outward + pad.mass_inset * along) / bearing.lever(pad)
