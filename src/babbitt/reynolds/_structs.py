"""What the compiled kernels hand to each other: named tuples of arrays, and the columns of a land.

Everything is dimensionless: gaps by the radial clearance c, angles in rad, zeta = z / (B/2), pressures above the
cavitation pressure by mu omega (R/c)^2, forces by mu omega (R/c)^2 R B, time by 1/omega.

A land is the part of the bore between two groove edges. It has ``n`` intervals along the angle and ``n + 1``
lines, of which the first and the last lie on groove edges (Dirichlet); each line has ``m`` axial unknowns.
"""

from __future__ import annotations

from typing import NamedTuple

from numpy import bool_, float64, int64
from numpy.typing import NDArray

Array = NDArray[float64]

# columns of a land: h = CLEARANCE - (x - CENTRE_X) cos(theta) - (y - CENTRE_Y) sin(theta) + profile
START, END, CLEARANCE, CENTRE_X, CENTRE_Y, START_PRESSURE, END_PRESSURE = range(7)
LAND_COLUMNS = 7


class Axial(NamedTuple):
    """The axial operator in the symmetric variable u = sqrt(w) p (see ``babbitt.reynolds.lands.axial``)."""

    size: tuple[int, ...] | NDArray[int64]  # m zeros; in a tuple the compiler knows m and unrolls its loops
    root_weights: Array  # sqrt(w_j), (m,)
    stiffness: Array  # K~ = W^-1/2 K W^-1/2, (m, m)
    load: Array  # K~ sqrt(w): what a uniform side pressure does, (m,)
    eigenvalues: Array  # of K~, (m,)
    modes: Array  # orthonormal eigenvectors of K~ in columns, (m, m)
    modes_transposed: Array  # the same in rows, (m, m)
    mode_weights: Array  # modes^T sqrt(w), (m,)
    edge_weight: float  # of the node on the side edge
    edge_stiffness: Array  # row of the unscaled operator for that node, itself last, (m + 1,)


class Bearing(NamedTuple):
    """An arrangement of lands and the conditions they share."""

    lands: Array  # one row per land, columns as above
    profiles: Array  # departure from the circle at equally spaced angles of each land, (lands, samples or 0)
    kappa: float  # (D/B)^2 / 12
    speed: float  # 1, or 0 for a journal at rest
    side_pressure: float  # ambient pressure above the cavitation pressure
    conserving: bool  # mass-conserving condition, or else the Reynolds condition
    smooth: bool  # whether the coefficients are freed from the steps of the grid
    crowding: float  # how many times denser the lines stand where the film ruptures


class Grid(NamedTuple):
    """Lines of all lands and everything that depends on them alone. a and b are the two Gauss points."""

    theta: Array  # (lands, n + 1)
    step: Array  # (lands, n)
    cos_a: Array  # (lands, n)
    sin_a: Array
    cos_b: Array
    sin_b: Array
    gap_a: Array  # gap for a journal in the origin, (lands, n)
    gap_b: Array
    weight_x: Array  # int cos(theta) phi_i d theta, phi_i the hat function of line i, (lands, n + 1)
    weight_y: Array  # int sin(theta) phi_i d theta, (lands, n + 1)
    wet: NDArray[bool_]  # whether a node holds pressure, (lands, n + 1, m)
    value: Array  # last solution: u, or sigma of a dry node, (lands, n + 1, m)


class Film(NamedTuple):
    """Coefficients of the film of one land for one journal position, and their derivatives in x and y."""

    conductance: Array  # T_i = 1 / (12 int h^-3), (n,)
    conductance_x: Array
    conductance_y: Array
    couette: Array  # Q_i = int h^-2 / (2 int h^-3), (n,)
    couette_x: Array
    couette_y: Array
    cubed: Array  # H_i = int h^3 phi_i, (n + 1,)
    cubed_x: Array
    cubed_y: Array
    squeeze: Array  # S_i = int dh/dt phi_i, (n + 1,)
    inlet: Array  # flux behind the start of a ruptured line and its derivatives in x and y, (3,)


class Lines(NamedTuple):
    """Solution on the lines of one land and the workspace of the elimination."""

    wet_count: NDArray[int64]  # wet nodes of a line, as the last solution saw them, (n + 1,)
    before: Array  # how far the film reaches from a node, in intervals (``_endings``), (n + 1, m)
    behind: Array  # the same to the other side, (n + 1, m)
    fill: Array  # part of the interval before a node behind a closing front, 1/2 elsewhere, (n + 1, m)
    solution: Array  # u or sigma = sqrt(w) s, adjoint of F_x, adjoint of F_y: (n + 1, 3, m)
    pivot: Array  # inverse modal pivots, (n + 1, m)
    inverse: Array  # inverse of the block of a line, (n + 1, m, m)
    lower: Array  # diagonal block towards the line before, (n + 1, m)
    upper: Array  # diagonal block of the line before towards this one, (n + 1, m)
    swept: Array  # right-hand sides after the forward sweep, (n + 1, 3, m)
    modal: Array  # the solution in modal coordinates, (n + 1, 3, m)
