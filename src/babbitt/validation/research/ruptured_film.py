r"""Pressure in one film of given extent: finite volumes and the rupture condition of Reynolds.

Coordinates: phi from the widest gap, positive with rotation; zb = 2 z/B from mid-plane; H = 1 + eps cos phi
is the gap over the radial clearance; P = p psi^2/(eta omega). Reynolds' equation for a steady isoviscous film
reads

.. math:: (H^3 P_\phi)_\phi + x^{-2} (H^3 P_{zb})_{zb} = 6 H_\phi, \qquad x = B/D,

with P = 0 at both ends, at the rim and wherever the film has ruptured. The film ruptures where P and its
slope vanish together: P >= 0, residual >= 0, P times residual = 0 (Swift 1932, Stieber 1933; as a
complementarity problem Cottle, Pang and Stone 1992). The set of wet nodes is found by the primal-dual
active-set method (Hintermueller, Ito and Kunisch, SIAM J. Optim. 13, 2002): solve, dry what came out
negative, wet what the flow balance would push up, repeat.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.scalar_or_array import Array
from babbitt.validation.research.film_grid import axial_nodes, circumferential_nodes

Wet = NDArray[np.bool_]

_MOST_STEPS = 200


@dataclass(frozen=True)
class FilmBalance:
    """The discrete flow balance of the nodes that may carry pressure, ``balance @ P = source``.

    Rows run over phi (first index) and zb (second); a node couples to its neighbours along phi by `along` and
    along zb by `across`. Symmetric, an M-matrix, banded with the number of axial cells as bandwidth.

    Attributes
    ----------
    angle : ndarray, shape (n + 1,)
        phi of the nodes [rad], edges included.
    width, depth : ndarray, shape (n + 1,) and (m + 1,)
        Extent of the volume around each node along phi [rad] and zb.
    along : ndarray, shape (n, m)
        Conductance of the faces between neighbours in phi.
    across : ndarray, shape (n - 1, m)
        Conductance of the faces between neighbours in zb, the last one towards the rim.
    diagonal, source : ndarray, shape (n - 1, m)
        Sum of conductances around a node; net flow dragged into its volume.
    rim_source : ndarray, shape (n - 1,)
        Net flow dragged into the half volumes on the rim.
    """

    angle: Array
    width: Array
    depth: Array
    along: Array
    across: Array
    diagonal: Array
    source: Array
    rim_source: Array


def flow_balance(
    start: float, end: float, eccentricity_ratio: float, width_ratio: float, cells: tuple[int, int]
) -> FilmBalance:
    """Discretise Reynolds' equation between two angles.

    Parameters
    ----------
    start, end : float
        Edges of the film [rad] from the widest gap.
    eccentricity_ratio, width_ratio : float
        eps and B/D.
    cells : tuple of int
        Cells along phi and across half the width.

    Returns
    -------
    FilmBalance
    """
    angle = circumferential_nodes(start, end, eccentricity_ratio, cells[0])
    position = axial_nodes(cells[1])
    d_angle, d_position = np.diff(angle), np.diff(position)
    width = np.convolve(np.pad(d_angle, 1), [0.5, 0.5], "valid")
    depth = np.convolve(np.pad(d_position, 1), [0.5, 0.5], "valid")

    gap = 1.0 + eccentricity_ratio * np.cos(angle[1:-1])
    face_gap = 1.0 + eccentricity_ratio * np.cos(0.5 * (angle[1:] + angle[:-1]))
    along = np.outer(face_gap**3 / d_angle, depth[:-1])
    across = np.outer(gap**3 * width[1:-1], 1.0 / (width_ratio**2 * d_position))
    diagonal = along[1:] + along[:-1] + across
    diagonal[:, 1:] += across[:, :-1]
    dragged = -6.0 * np.diff(face_gap)
    return FilmBalance(
        angle=angle,
        width=width,
        depth=depth,
        along=along,
        across=across,
        diagonal=diagonal,
        source=np.outer(dragged, depth[:-1]),
        rim_source=dragged * depth[-1],
    )


def ruptured_pressure(balance: FilmBalance, wet: Wet) -> tuple[Array, Wet]:
    """Pressure of a film that ruptures by Reynolds' condition.

    Parameters
    ----------
    balance : FilmBalance
    wet : ndarray of bool, shape (n - 1, m)
        A guess of the nodes that carry pressure; the nearer, the fewer steps.

    Returns
    -------
    pressure : ndarray, shape (n + 1, m + 1)
        P at all nodes, edges included.
    wet : ndarray of bool, shape (n - 1, m)
        The nodes that carry pressure.

    Raises
    ------
    ArithmeticError
        If the active set still changes after 200 steps.
    """
    for _ in range(_MOST_STEPS):
        pressure = _pressure_of_wet_nodes(balance, wet)
        inner = pressure[1:-1, :-1]
        surplus = balance.diagonal * inner - balance.source
        surplus -= balance.along[1:] * pressure[2:, :-1] + balance.along[:-1] * pressure[:-2, :-1]
        surplus -= balance.across * pressure[1:-1, 1:]
        surplus[:, 1:] -= balance.across[:, :-1] * inner[:, :-1]
        following = np.where(wet, inner > 0.0, surplus < 0.0)
        if np.array_equal(following, wet):
            return pressure, wet
        wet = following
    raise ArithmeticError(f"the ruptured region still moves after {_MOST_STEPS} steps")


def _pressure_of_wet_nodes(balance: FilmBalance, wet: Wet) -> Array:
    """Solve the balance of the wet nodes with P = 0 at all others."""
    from scipy.linalg import solveh_banded

    columns, rows = wet.shape
    used = int(np.flatnonzero(wet.any(axis=1)).max(initial=0)) + 1  # beyond, the film is dry over its whole width
    some = wet[:used]
    band = np.zeros((rows + 1, used, rows))  # lower form; dry nodes keep their place as rows of the unit matrix
    band[0] = np.where(some, balance.diagonal[:used], 1.0)
    band[1, :, :-1] = np.where(some[:, 1:] & some[:, :-1], -balance.across[:used, :-1], 0.0)
    band[rows, :-1] = np.where(some[1:] & some[:-1], -balance.along[1:used], 0.0)
    inner = solveh_banded(
        band.reshape(rows + 1, -1),
        np.where(some, balance.source[:used], 0.0).ravel(),
        lower=True,
        check_finite=False,
        overwrite_ab=True,
        overwrite_b=True,
    )
    pressure = np.zeros((columns + 2, rows + 1))
    pressure[1 : used + 1, :-1] = inner.reshape(used, rows)
    return pressure


def force(balance: FilmBalance, pressure: Array) -> tuple[float, float]:
    """Film force along the line of centres and across it, over eta omega B D/psi^2.

    W_x = -1/2 int int P cos(phi), W_y = +1/2 int int P sin(phi), mean over zb. Its magnitude is the
    Sommerfeld number, its direction the attitude angle.
    """
    line_load = balance.width * (pressure @ balance.depth)
    along_centres = -0.5 * float(line_load @ np.cos(balance.angle))
    across_centres = 0.5 * float(line_load @ np.sin(balance.angle))
    return along_centres, across_centres


def side_flow_number(balance: FilmBalance, pressure: Array, wet: Wet, width_ratio: float) -> float:
    """Flow out of both rims, Q3* = Q3/(D^3 psi omega), from the flow balance of the volumes on the rim.

    Equal to 1/(48 x) int H^3 (-dP/dzb) dphi at zb = 1; taken from the balance no flow is lost between film
    and rim.
    """
    outflow = balance.across[:, -1] * pressure[1:-1, -2] + balance.rim_source
    return float(outflow[wet[:, -1]].sum()) * width_ratio / 48.0


def largest_pressure(balance: FilmBalance, pressure: Array) -> float:
    """Largest P, by a parabola through the largest node of the mid-plane and its neighbours."""
    middle = pressure[:, 0]
    peak = int(np.clip(middle.argmax(), 1, len(middle) - 2))
    left, right = balance.angle[[peak - 1, peak + 1]] - balance.angle[peak]
    rise_left, rise_right = middle[[peak - 1, peak + 1]] - middle[peak]
    slope = (rise_left * right**2 - rise_right * left**2) / (left * right * (right - left))
    curvature = (rise_right * left - rise_left * right) / (left * right * (right - left))
    return float(middle[peak] - slope**2 / (4.0 * curvature))


def film_end_angle(balance: FilmBalance, pressure: Array, wet: Wet) -> float:
    """Angle phi at which the film ends in the mid-plane: the rupture, or the edge of the arc [rad]."""
    last = int(np.flatnonzero(wet[:, 0]).max(initial=0)) + 1
    if last == len(wet):
        return float(balance.angle[-1])
    # towards the rupture P falls as the square of the distance (P and its slope vanish together)
    before, at = math.sqrt(pressure[last - 1, 0]), math.sqrt(pressure[last, 0])
    step = float(balance.angle[last] - balance.angle[last - 1])
    return float(balance.angle[last]) + (step * at / (before - at) if before > at else 0.0)
