"""Equilibrium of a rigid shaft on two radial bearings."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from babbitt.kinds.shaft.model import Array, PointLoad, Shaft, in_planes

__all__ = ["balance", "thrust", "two_reactions"]


def two_reactions(shaft: Shaft) -> Array:
    """Forces of two radial bearings on the shaft in x and y, N, shape (2, 2).

    Moments about either bearing vanish: with the distance ``l = z_2 - z_1`` of the bearings,
    ``R_2 = -sum((z - z_1) F + C) / l`` and ``R_1 = -sum((z_2 - z) F - C) / l`` in the planes z-x and z-y.

    Parameters
    ----------
    shaft : Shaft
        With two radial bearings.
    """
    first, second = shaft.carriers
    stations, forces, couples = in_planes((*shaft.loads, *shaft.weights()))
    span = second.station - first.station
    on_second = -((stations - first.station) @ forces + couples.sum(axis=0)) / span
    on_first = -((second.station - stations) @ forces - couples.sum(axis=0)) / span
    return np.array([on_first, on_second])


def thrust(shaft: Shaft) -> float:
    """Axial force of all loads, N, positive along z: what the thrust bearing carries."""
    return float(sum(load.force[2] for load in shaft.loads))


def balance(loads: Sequence[PointLoad]) -> tuple[Array, Array]:
    """Sums of forces and of moments about the origin, N and N m, shape (3,) each."""
    forces = np.array([load.force for load in loads]).reshape(-1, 3)
    places = np.array([(0.0, 0.0, load.station) for load in loads]).reshape(-1, 3)
    moments = np.cross(places, forces) + np.array([load.moment for load in loads]).reshape(-1, 3)
    return forces.sum(axis=0), moments.sum(axis=0)
