"""Axial operators: how a film pressure varies across the width, in a handful of numbers.

The width is scaled to zeta = z / (B/2), from -1 to 1. Pressures are Lagrange polynomials through
Gauss-Lobatto-Legendre (GLL) nodes and the weak form is integrated at the same nodes, so that mass and
circumferential coupling are diagonal and only the axial flow couples the nodes of a line.

An aligned bearing needs even polynomials only: the m + 1 non-negative nodes of degree 2 m carry them.
Four unknowns then reach about 1e-4 in load, for which a three-point scheme takes some thirty cells.

Source: Canuto, Hussaini, Quarteroni, Zang, Spectral Methods: Fundamentals in Single Domains (2006), 2.3 and 3.8.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

__all__ = [
    "AxialMesh",
    "EvenAxialOperator",
    "differentiation_matrix",
    "element_axial_mesh",
    "even_axial_mesh",
    "even_axial_operator",
    "lobatto_rule",
]

Array = NDArray[np.float64]


@lru_cache(maxsize=64)
def lobatto_rule(degree: int) -> tuple[Array, Array]:
    """Nodes and weights of the Gauss-Lobatto-Legendre rule on [-1, 1].

    Parameters
    ----------
    degree : int
        Polynomial degree N of the interpolant, at least 1; the rule has N + 1 nodes and is exact to
        degree 2 N - 1.

    Returns
    -------
    nodes, weights : ndarray, shape (degree + 1,)
        Ascending nodes, the ends included; weights sum to 2.

    Examples
    --------
    >>> nodes, weights = lobatto_rule(2)
    >>> nodes.tolist(), (3 * weights).round(12).tolist()
    ([-1.0, 0.0, 1.0], [1.0, 4.0, 1.0])
    """
    series = np.zeros(degree + 1)
    series[degree] = 1.0
    slope = legendre.legder(series)
    inner = np.sort(legendre.legroots(slope).real) if degree > 1 else np.empty(0)
    curvature = legendre.legder(slope)
    for _ in range(3 if degree > 1 else 0):  # polish the roots of the companion matrix
        inner = inner - legendre.legval(inner, slope) / legendre.legval(inner, curvature)
    nodes = np.concatenate(([-1.0], inner, [1.0]))
    nodes = 0.5 * (nodes - nodes[::-1])  # exactly antisymmetric
    weights = np.asarray(2.0 / (degree * (degree + 1) * legendre.legval(nodes, series) ** 2), dtype=np.float64)
    for array in (nodes, weights):
        array.setflags(write=False)
    return nodes, weights


def differentiation_matrix(nodes: Array) -> Array:
    """Matrix D with (D f)_k = derivative at node k of the polynomial through f (barycentric form).

    Parameters
    ----------
    nodes : ndarray, shape (n,)
        Distinct nodes.

    Returns
    -------
    ndarray, shape (n, n)
    """
    gaps = nodes[:, None] - nodes[None, :]
    np.fill_diagonal(gaps, 1.0)
    barycentric = 1.0 / gaps.prod(axis=1)
    matrix = (barycentric[None, :] / barycentric[:, None]) / gaps
    np.fill_diagonal(matrix, 0.0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    return np.asarray(matrix)


@dataclass(frozen=True, eq=False)
class EvenAxialOperator:
    """Axial operator for pressures that are even in zeta, with the side edge as the last node.

    Attributes
    ----------
    nodes : ndarray, shape (m + 1,)
        zeta of the nodes, from the mid-plane (0) to the edge (1).
    weights : ndarray, shape (m + 1,)
        Weights of the mean over the width; they sum to 1.
    stiffness : ndarray, shape (m + 1, m + 1)
        K with p^T K p = mean over the width of (dp/dzeta)^2.
    eigenvalues : ndarray, shape (m,)
        Of W^-1/2 K W^-1/2 over the interior nodes.
    modes : ndarray, shape (m, m)
        Orthonormal eigenvectors of the same, one per column.
    """

    nodes: Array
    weights: Array
    stiffness: Array
    eigenvalues: Array
    modes: Array

    @property
    def unknowns(self) -> int:
        """Interior nodes per line, m."""
        return self.nodes.size - 1


@lru_cache(maxsize=32)
def even_axial_operator(unknowns: int) -> EvenAxialOperator:
    """Even GLL operator with the given number of interior nodes per line.

    Parameters
    ----------
    unknowns : int
        m, at least 1. The polynomials are even and of degree 2 m.

    Returns
    -------
    EvenAxialOperator

    Examples
    --------
    The parabola 1 - zeta^2 has a mean squared slope of 4/3:

    >>> axial = even_axial_operator(2)
    >>> p = 1.0 - axial.nodes**2
    >>> round(float(p @ axial.stiffness @ p), 12)
    1.333333333333
    """
    degree = 2 * unknowns
    nodes, weights = lobatto_rule(degree)
    slope = differentiation_matrix(nodes)
    # fold: the value at -zeta is the value at +zeta
    fold = np.zeros((degree + 1, unknowns + 1))
    for row in range(degree + 1):
        fold[row, abs(row - unknowns)] = 1.0
    half_weights = 0.5 * fold.T @ weights
    stiffness = 0.5 * fold.T @ (slope.T @ (weights[:, None] * slope)) @ fold
    stiffness = 0.5 * (stiffness + stiffness.T)
    root = np.sqrt(half_weights[:-1])
    eigenvalues, modes = np.linalg.eigh(stiffness[:-1, :-1] / np.outer(root, root))
    return EvenAxialOperator(nodes[unknowns:].copy(), half_weights, stiffness, eigenvalues, modes)


@dataclass(frozen=True, eq=False)
class AxialMesh:
    """Spectral elements across the width, with boundaries where pockets end.

    Attributes
    ----------
    nodes : ndarray, shape (nodes,)
        zeta of the nodes, ascending.
    points : ndarray, shape (points,)
        zeta of the quadrature points: the GLL nodes of every element, so a node between elements occurs twice.
    share : ndarray, shape (points,)
        Part of the width that a point stands for; they sum to 1.
    node_of_point : ndarray of int, shape (points,)
    slope : ndarray, shape (points, nodes)
        Derivative with respect to zeta at the points.
    side_nodes : tuple of int
        Nodes on the side edges.
    """

    nodes: Array
    points: Array
    share: Array
    node_of_point: NDArray[np.int64]
    slope: Array
    side_nodes: tuple[int, ...]

    @property
    def between_sides(self) -> slice:
        """All nodes but those on the side edges."""
        return slice(len(self.side_nodes) - 1, -1)

    @cached_property
    def element_starts(self) -> NDArray[np.int64]:
        """First point of every element, shape (elements,)."""
        return np.flatnonzero(np.concatenate(([True], np.diff(self.points) < 1e-9)))

    @cached_property
    def breaks(self) -> tuple[int, ...]:
        """Nodes at the ends of the elements; none where the only element is half of an even polynomial."""
        starts = self.element_starts
        if starts.size == 1 and self.nodes[0] == 0.0:
            return ()
        return (*(int(node) for node in self.node_of_point[starts]), self.nodes.size - 1)

    @cached_property
    def element_centres(self) -> Array:
        """Middle of the element that a point belongs to, shape (points,)."""
        starts = self.element_starts
        ends = np.append(starts[1:], self.points.size)
        middles = 0.5 * (self.points[starts] + self.points[ends - 1])
        return np.repeat(middles, ends - starts)


@lru_cache(maxsize=32)
def even_axial_mesh(unknowns: int) -> AxialMesh:
    """The even operator as a mesh of one element from the mid-plane to the edge."""
    degree = 2 * unknowns
    nodes, weights = lobatto_rule(degree)
    slope = differentiation_matrix(nodes)[unknowns:]
    folded = slope[:, unknowns:].copy()
    folded[:, 1:] += slope[:, :unknowns][:, ::-1]
    share = weights[unknowns:].copy()
    share[0] *= 0.5
    points = nodes[unknowns:].copy()
    return AxialMesh(points, points, share, np.arange(unknowns + 1), folded, (unknowns,))


@lru_cache(maxsize=64)
def element_axial_mesh(boundaries: tuple[float, ...], degrees: tuple[int, ...]) -> AxialMesh:
    """Spectral elements between given boundaries.

    Parameters
    ----------
    boundaries : tuple of float
        Ascending zeta, from -1 (whole width) or 0 (symmetric bearing, no flow across the mid-plane) to 1.
    degrees : tuple of int
        Polynomial degree of each element.

    Returns
    -------
    AxialMesh

    Examples
    --------
    >>> mesh = element_axial_mesh((0.0, 0.5, 1.0), (3, 4))
    >>> float((mesh.share * (mesh.slope @ mesh.nodes**3)).sum())  # mean of 3 zeta^2 over [0, 1]
    1.0
    """
    nodes: list[float] = [boundaries[0]]
    points, share, node_of_point = [], [], []
    blocks: list[tuple[int, Array]] = []
    width = boundaries[-1] - boundaries[0]
    for left, right, degree in zip(boundaries[:-1], boundaries[1:], degrees, strict=True):
        reference, weights = lobatto_rule(degree)
        half = 0.5 * (right - left)
        own = left + half * (reference + 1.0)
        first = len(nodes) - 1
        nodes.extend(own[1:])
        points.append(own)
        share.append(weights * half / width)
        node_of_point.append(first + np.arange(degree + 1))
        blocks.append((first, differentiation_matrix(reference) / half))
    slope = np.zeros((sum(block.shape[0] for _, block in blocks), len(nodes)))
    row = 0
    for first, block in blocks:
        size = block.shape[0]
        slope[row : row + size, first : first + size] = block
        row += size
    sides = (len(nodes) - 1,) if boundaries[0] == 0.0 else (0, len(nodes) - 1)
    return AxialMesh(
        np.array(nodes), np.concatenate(points), np.concatenate(share), np.concatenate(node_of_point), slope, sides
    )
