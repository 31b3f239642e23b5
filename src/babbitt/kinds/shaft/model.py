"""A shaft on its bearings: pieces, loads and supports, in SI.

The frame is that of all bearings: x to the right, y up, z along the shaft, positive rotation from x towards y.
Stations are places along z. A moment is a vector as in mechanics: ``r x F``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.design.screening import STANDARD_GRAVITY

__all__ = ["STANDARD_GRAVITY", "Array", "Piece", "PointLoad", "Shaft", "Support", "in_planes"]

Array = NDArray[np.float64]

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class PointLoad:
    """What acts on the axis of the shaft at one station.

    Attributes
    ----------
    name : str
    station : float
        m.
    force, moment : tuple of float
        x, y, z, in N and N m; the z component of the moment is a torque.
    """

    name: str
    station: float
    force: Vector
    moment: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Piece:
    """A uniform piece of shaft: lengths in m, Young's modulus in Pa, density in kg/m³."""

    length: float
    diameter: float
    inner_diameter: float = 0.0
    modulus: float = 206e9
    density: float = 7850.0

    @property
    def bending_stiffness(self) -> float:
        """``E I`` with ``I = pi (D⁴ - d⁴) / 64``, N m²."""
        return self.modulus * math.pi * (self.diameter**4 - self.inner_diameter**4) / 64.0

    @property
    def weight(self) -> float:
        """Per length, N/m."""
        return STANDARD_GRAVITY * self.density * math.pi * (self.diameter**2 - self.inner_diameter**2) / 4.0


@dataclass(frozen=True)
class Support:
    """A bearing as the shaft feels it.

    Attributes
    ----------
    name : str
    station : float
        m.
    radial, axial : bool
        What it carries.
    stiffness : float
        Radial, alike in all directions, N/m; infinite for a rigid bearing.
    offset : tuple of float
        Of its centre from the line z, x and y, m.
    """

    name: str
    station: float
    radial: bool = True
    axial: bool = False
    stiffness: float = math.inf
    offset: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Shaft:
    """A shaft with all that acts on it.

    Attributes
    ----------
    supports : tuple of Support
    loads : tuple of PointLoad
        Of gears, couplings, masses and forces; the weight of the pieces comes on top.
    pieces : tuple of Piece
        From the station `start` on; none where the bending of the shaft is not asked for.
    start : float
        m.
    """

    supports: tuple[Support, ...]
    loads: tuple[PointLoad, ...]
    pieces: tuple[Piece, ...] = ()
    start: float = 0.0

    @property
    def ends(self) -> Array:
        """Stations of the ends of the pieces, m."""
        return self.start + np.concatenate([[0.0], np.cumsum([piece.length for piece in self.pieces])])

    @property
    def stations(self) -> list[float]:
        """Stations of all that acts on the shaft or carries it, m."""
        return [load.station for load in self.loads] + [support.station for support in self.supports]

    @property
    def carriers(self) -> tuple[Support, ...]:
        """The radial bearings."""
        return tuple(one for one in self.supports if one.radial)

    def weights(self) -> tuple[PointLoad, ...]:
        """The weight of each piece at its middle."""
        middles = 0.5 * (self.ends[1:] + self.ends[:-1])
        return tuple(
            PointLoad("Shaft", float(middle), (0.0, -piece.weight * piece.length, 0.0))
            for middle, piece in zip(middles, self.pieces, strict=True)
        )


def in_planes(loads: Sequence[PointLoad]) -> tuple[Array, Array, Array]:
    """Stations, transverse forces and couples of loads, in the planes z-x and z-y.

    A couple is positive where it raises the slope of the shaft: ``(M_y, -M_x)``, so that ``sum(z F + couple) = 0``
    in either plane is the equilibrium of moments.

    Returns
    -------
    tuple of ndarray
        Stations (n,) in m; forces (n, 2) in N; couples (n, 2) in N m.
    """
    stations = np.array([load.station for load in loads])
    forces = np.array([load.force[:2] for load in loads]).reshape(-1, 2)
    couples = np.array([(load.moment[1], -load.moment[0]) for load in loads]).reshape(-1, 2)
    return stations, forces, couples
