"""The stepped Euler-Bernoulli beam on rigid or elastic supports, in closed form from piece to piece.

Between two stations the bending moment is a polynomial and ``E I w'' = M`` is integrated exactly; there is no
mesh. Unknown are the forces of the supports and the place and slope of the shaft at its left end, which follow
from the equilibrium of forces and moments and from the deflection at each support (force method). The planes z-x
and z-y are solved at once. Shear deformation, axial forces in the bending and stiffness of supports against tilt
are not counted.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from babbitt.kinds.shaft.model import Array, Shaft, in_planes

__all__ = ["Beam", "Deflected", "bent"]

FINEST = 1.0 / 400.0
"""Share of the length between two stations at which curves are given."""

SAME_PLACE = 1e-10
"""Share of the length of the shaft below which two stations are one."""


@dataclass(frozen=True)
class Beam:
    """A stepped beam cut into segments.

    Attributes
    ----------
    nodes : ndarray (n + 1,)
        Ends of the segments, m.
    stiffness, weight : ndarray (n,)
        Bending stiffness in N m² and weight per length in N/m of each segment.
    """

    nodes: Array
    stiffness: Array
    weight: Array

    @classmethod
    def of(cls, shaft: Shaft) -> Beam:
        """The pieces of a shaft, cut where something acts and finely enough to draw its curves."""
        ends = shaft.ends
        evenly = np.linspace(ends[0], ends[-1], int(1.0 / FINEST) + 1)
        nodes: Array = np.unique(np.concatenate([ends, shaft.stations, evenly]))
        nodes = nodes[(nodes >= ends[0]) & (nodes <= ends[-1])]
        apart = np.diff(nodes) > SAME_PLACE * (ends[-1] - ends[0])
        nodes = nodes[np.concatenate([[True], apart])]
        piece = np.searchsorted(ends[1:-1], 0.5 * (nodes[1:] + nodes[:-1]), side="right")
        stiffness = np.array([one.bending_stiffness for one in shaft.pieces])[piece]
        return cls(nodes, stiffness, np.array([one.weight for one in shaft.pieces])[piece])

    def at(self, station: float) -> int:
        """Number of the node at a station."""
        return int(np.argmin(np.abs(self.nodes - station)))

    def integrated(self, forces: Array, couples: Array, weight: Array) -> Deflected:
        """Shear, moment, slope and deflection of a beam that is clamped at its left end, under all that acts.

        ``V`` is the sum of the forces to the left, ``M' = V``, ``E I w'' = M``; a couple lowers ``M`` by its size.

        Parameters
        ----------
        forces, couples : ndarray (n + 1, k)
            At the nodes, for k load cases.
        weight : ndarray (k,)
            How much of the weight of the pieces acts in each load case, negative downward.

        Returns
        -------
        Deflected
            Shear and moment to the right of each node.
        """
        steps, cases = np.diff(self.nodes), forces.shape[1]
        line_load = np.outer(self.weight, weight)
        shear, moment = np.cumsum(forces, axis=0), np.zeros((self.nodes.size, cases))
        shear[1:] += np.cumsum(line_load * steps[:, None], axis=0)
        slope, deflection = np.zeros_like(moment), np.zeros_like(moment)
        moment[0] = -couples[0]
        for n, h in enumerate(steps):
            v, m, q, flexibility = shear[n], moment[n], line_load[n], 1.0 / self.stiffness[n]
            moment[n + 1] = m + h * (v + h * q / 2.0) - couples[n + 1]
            slope[n + 1] = slope[n] + flexibility * h * (m + h * (v / 2.0 + h * q / 6.0))
            bend = flexibility * h**2 * (m / 2.0 + h * (v / 6.0 + h * q / 24.0))
            deflection[n + 1] = deflection[n] + h * slope[n] + bend
        return Deflected(self.nodes, shear, moment, slope, deflection)


@dataclass(frozen=True)
class Deflected:
    """Curves along the shaft, by plane or load case.

    Attributes
    ----------
    stations : ndarray (n,)
        m.
    shear, moment, slope, deflection : ndarray (n, k)
        N, N m, rad and m; at a step of shear or moment the value to the right.
    """

    stations: Array
    shear: Array
    moment: Array
    slope: Array
    deflection: Array


@dataclass(frozen=True)
class Bent:
    """A shaft on its supports.

    Attributes
    ----------
    reactions : ndarray (m, 2)
        Forces of the radial supports on the shaft in x and y, N.
    slopes : ndarray (m, 2)
        dx/dz and dy/dz at them, rad.
    curves : Deflected
        In the planes z-x and z-y.
    """

    reactions: Array
    slopes: Array
    curves: Deflected


def bent(shaft: Shaft) -> Bent:
    """Solve a shaft with two radial supports or more.

    Parameters
    ----------
    shaft : Shaft
        With pieces that reach over all stations.

    Returns
    -------
    Bent
    """
    beam, supports = Beam.of(shaft), shaft.carriers
    places = [beam.at(one.station) for one in supports]
    count = len(supports)
    acting = beam.integrated(*_acting(beam, shaft), weight=np.array([0.0, -1.0]))
    unit_forces = np.zeros((beam.nodes.size, count))
    unit_forces[places, range(count)] = 1.0
    unit = beam.integrated(unit_forces, np.zeros_like(unit_forces), np.zeros(count))

    arms = beam.nodes[places] - beam.nodes[0]
    length = beam.nodes[-1] - beam.nodes[0]
    give = np.array([1.0 / one.stiffness for one in supports])
    offsets = np.array([one.offset for one in supports])
    # Scales that bring all equations to the same size: deflections over that of the whole beam.
    scale = length**3 / float(beam.stiffness.min())
    system = np.zeros((count + 2, count + 2))
    system[:count, :count] = (unit.deflection[places] + np.diag(give)) / scale
    system[:count, count] = 1.0
    system[:count, count + 1] = arms / length
    system[count, :count] = 1.0
    system[count + 1, :count] = arms / length
    right = np.zeros((count + 2, 2))
    right[:count] = (offsets - acting.deflection[places]) / scale
    # The free end at the right: what acts and what carries cancel.
    right[count] = -acting.shear[-1]
    right[count + 1] = -(acting.shear[-1] * length - acting.moment[-1]) / length
    found: Array = np.asarray(np.linalg.solve(system, right), dtype=np.float64)
    reactions, place, slope = found[:count], scale * found[count], scale / length * found[count + 1]
    curves = Deflected(
        beam.nodes,
        acting.shear + unit.shear @ reactions,
        acting.moment + unit.moment @ reactions,
        acting.slope + unit.slope @ reactions + slope,
        acting.deflection + unit.deflection @ reactions + place + np.outer(beam.nodes - beam.nodes[0], slope),
    )
    return Bent(reactions, curves.slope[places], curves)


def _acting(beam: Beam, shaft: Shaft) -> tuple[Array, Array]:
    """Forces and couples at the nodes in both planes."""
    forces, couples = np.zeros((beam.nodes.size, 2)), np.zeros((beam.nodes.size, 2))
    for station, force, couple in zip(*in_planes(shaft.loads), strict=True):
        node = beam.at(station)
        forces[node] += force
        couples[node] += couple
    return forces, couples
