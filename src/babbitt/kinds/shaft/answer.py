"""A solved shaft: what each bearing carries, and how the shaft bends."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from babbitt.kinds.shaft.beam import Deflected, bent
from babbitt.kinds.shaft.model import Array, Piece, PointLoad, Shaft
from babbitt.kinds.shaft.statics import balance, thrust, two_reactions

__all__ = ["ShaftAnswer", "answered"]


@dataclass(frozen=True)
class ShaftAnswer:
    """What was found of a shaft.

    Attributes
    ----------
    shaft : Shaft
    bearing_forces : ndarray (m, 3)
        That the shaft puts on each of its supports, N.
    slopes : ndarray (m, 2) or None
        dx/dz and dy/dz of the shaft at each support, rad; None for a shaft without pieces.
    curves : Deflected
        Shear, bending moment, slope and deflection along the shaft in the planes z-x and z-y; slope and deflection
        are NaN without pieces.
    """

    shaft: Shaft
    bearing_forces: Array
    slopes: Array | None
    curves: Deflected

    @property
    def bends(self) -> bool:
        """Whether slope and deflection are known."""
        return self.slopes is not None

    def slope_at(self, bearing: int) -> tuple[float, float] | None:
        """Slope of the shaft in one bearing; None where it is not known."""
        return None if self.slopes is None else (float(self.slopes[bearing, 0]), float(self.slopes[bearing, 1]))

    def reactions(self) -> tuple[PointLoad, ...]:
        """What the bearings do to the shaft."""
        return tuple(
            PointLoad(one.name, one.station, (float(-x), float(-y), float(-z)))
            for one, (x, y, z) in zip(self.shaft.supports, self.bearing_forces, strict=True)
        )

    def equilibrium_error(self) -> float:
        """Largest sum of forces, or of moments over the length, over the sum of the sizes of all forces.

        The torque about z is left out: gears and couplings balance it.
        """
        acting = (*self.shaft.loads, *self.shaft.weights(), *self.reactions())
        forces, moments = balance(acting)
        size = sum(float(np.linalg.norm(load.force)) for load in acting)
        stations = [load.station for load in acting]
        length = max(stations) - min(stations)
        if size == 0.0:
            return 0.0
        return float(max(np.abs(forces).max(), np.abs(moments[:2]).max() / length)) / size

    def torque(self) -> Array:
        """Torque along the shaft at the stations of the curves, N m; to the right of what acts there."""
        torque = np.zeros(self.curves.stations.size)
        for load in self.shaft.loads:
            torque -= np.where(self.curves.stations >= load.station, load.moment[2], 0.0)
        return torque


def answered(shaft: Shaft) -> ShaftAnswer:
    """Solve a shaft: two radial bearings by equilibrium, more by its bending.

    Parameters
    ----------
    shaft : Shaft
        With two radial bearings at least, and with pieces where there are more.

    Returns
    -------
    ShaftAnswer
    """
    found = bent(shaft if shaft.pieces else _line(shaft))
    reactions = two_reactions(shaft) if len(shaft.carriers) == 2 else found.reactions
    forces = np.zeros((len(shaft.supports), 3))
    carriers = [place for place, one in enumerate(shaft.supports) if one.radial]
    forces[carriers, :2] = -reactions
    forces[[place for place, one in enumerate(shaft.supports) if one.axial], 2] = thrust(shaft)
    if not shaft.pieces:
        unknown = np.full_like(found.curves.slope, np.nan)
        return ShaftAnswer(shaft, forces, None, replace(found.curves, slope=unknown, deflection=unknown))
    slopes = np.array(
        [[np.interp(one.station, found.curves.stations, plane) for plane in found.curves.slope.T]
         for one in shaft.supports]
    )  # fmt: skip
    return ShaftAnswer(shaft, forces, slopes, found.curves)


def _line(shaft: Shaft) -> Shaft:
    """The shaft as a massless line between its outermost stations: shear and moments need no more."""
    start, end = min(shaft.stations), max(shaft.stations)
    return replace(shaft, pieces=(Piece(end - start, 1.0, density=0.0),), start=start)
