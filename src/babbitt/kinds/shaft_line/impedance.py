r"""Forced vibration of line and pads at one frequency: the block-arrow system.

With kl = nu l/a and Z = E A nu/a a rod between two joints adds Z cot kl to both diagonals and -Z/sin kl between
them, from U = B1 cos(nu x/a) + B2 sin(nu x/a) and the compressive force P = -E A U'. The collar carries all
pads, each pad its ring (c) and its film kt_i:

    collar: [.. + sum kt_i] U2 - sum kt_i x_i = -sum kt_i xi_i,
    pad:    -kt_i U2 + (c - nu^2 m4 + kt_i) x_i [- c U_h] = kt_i xi_i,
    housing: (k_f + j nu d_f - nu^2 m_h + z c) U_h - c sum x_i = 0.

Axial displacements are positive towards the pads, x_i away from the collar, gaps h_i = x_i - xi_i - U2, and
N_i = -kt_i h_i is the load that pad i gets in addition.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.pads import DynamicPads

__all__ = ["Response", "dynamic_stiffness", "respond"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

POLE = 1e-12
"""``|sin kl|`` below which the joints of a rod do not fix its motion."""


@dataclass(frozen=True, eq=False)
class Response:
    """Complex amplitudes at one frequency; each quantity is Re(amplitude e^(j nu t)).

    Attributes
    ----------
    frequency : float
        nu, rad/s.
    shaft : ndarray
        Displacements of the joints from the propeller to the collar, m.
    pads : ndarray, shape (z,)
        Displacements x_i, m; zero on a rigid ring.
    gaps : ndarray, shape (z,)
        Changes h_i of the film at the pivots, m.
    forces : ndarray, shape (z,)
        N_i, N, positive for more load.
    housing : complex
        Displacement of the housing, m.
    residual : float
        Of the equations, relative.
    """

    frequency: float
    shaft: ComplexArray
    pads: ComplexArray
    gaps: ComplexArray
    forces: ComplexArray
    housing: complex
    residual: float

    @property
    def total_force(self) -> complex:
        """Force on the housing, N."""
        return complex(self.forces.sum())


def shaft_stiffness(line: ShaftLine, frequency: float) -> Array:
    """Real dynamic stiffness of rods and masses, N/m, without propeller damping.

    Raises
    ------
    InputError
        E203 at a frequency at which a rod swings between fixed ends.
    """
    masses = np.array(line.masses)
    matrix = np.diag(-(frequency**2) * masses)
    for place, rod in enumerate(line.rods):
        angle = frequency * rod.transit_time
        if angle == 0.0:
            own, cross = rod.stiffness, -rod.stiffness
        else:
            if abs(math.sin(angle)) < POLE:
                raise InputError(
                    "E203",
                    f"{frequency / math.tau:.6g} Hz is a frequency of rod {place + 1} between "
                    "fixed ends; its ends do not tell how it moves. Choose another frequency.",
                )
            own, cross = rod.stiffness * angle / math.tan(angle), -rod.stiffness * angle / math.sin(angle)
        matrix[place, place] += own
        matrix[place + 1, place + 1] += own
        matrix[place, place + 1] += cross
        matrix[place + 1, place] += cross
    return matrix


def dynamic_stiffness(
    line: ShaftLine, pads: DynamicPads, frequency: float, films: ComplexArray | Array
) -> ComplexArray | Array:
    """Matrix of the unknowns: joints, pads unless the ring is rigid, housing unless the seat is.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    frequency : float
        rad/s.
    films : ndarray, shape (z,)
        Complex stiffness of the films; real ones leave propeller damping and seating damping out.

    Raises
    ------
    InputError
        E203 for a seating under a rigid ring, and at the poles of `shaft_stiffness`.
    """
    c, damped = pads.ring_stiffness, np.iscomplexobj(films)
    joints, z = len(line.masses), films.size
    if line.seating is not None and math.isinf(c):
        raise InputError(
            "E203",
            "a seating needs a ring of finite stiffness between pads and housing; give "
            "ring_stiffness, 1e12 N/m for a ring that hardly gives way.",
        )
    size = joints + (0 if math.isinf(c) else z) + (0 if line.seating is None else 1)
    matrix = np.zeros((size, size), dtype=complex if damped else float)
    matrix[:joints, :joints] = shaft_stiffness(line, frequency)
    collar = joints - 1
    matrix[collar, collar] += films.sum()
    if damped:
        matrix[0, 0] += 1j * frequency * line.propeller_damping
    if math.isinf(c):
        return matrix
    rows = np.arange(joints, joints + z)
    matrix[collar, rows] = matrix[rows, collar] = -films
    matrix[rows, rows] = c - frequency**2 * pads.pad_mass + films
    if line.seating is not None:
        seat = line.seating
        matrix[rows, -1] = matrix[-1, rows] = -c
        matrix[-1, -1] = seat.stiffness - frequency**2 * seat.housing_mass + z * c
        if damped:
            matrix[-1, -1] += 1j * frequency * seat.damping
    return matrix


def respond(
    line: ShaftLine, pads: DynamicPads, frequency: float, thrust: complex, runout: ComplexArray
) -> Response:
    """Solve the line at one frequency.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    frequency : float
        nu, rad/s, positive.
    thrust : complex
        Amplitude of the force on the propeller, N.
    runout : ndarray, shape (z,)
        Amplitudes xi_i under the pads, m.

    Raises
    ------
    InputError
        E203 at a pole of a rod; E204 at a resonance without damping.
    """
    films = pads.film(frequency)
    matrix = dynamic_stiffness(line, pads, frequency, films)
    joints, z = len(line.masses), films.size
    right = np.zeros(matrix.shape[0], dtype=complex)
    right[0] += thrust
    right[joints - 1] -= films @ runout
    rigid = math.isinf(pads.ring_stiffness)
    if not rigid:
        right[joints : joints + z] = films * runout
    solution: ComplexArray = np.asarray(np.linalg.solve(matrix, right), dtype=np.complex128)
    scale = np.abs(matrix) @ np.abs(solution) + np.abs(right)
    residual = float((np.abs(matrix @ solution - right) / np.where(scale > 0.0, scale, 1.0)).max())
    displaced = np.zeros(z, dtype=complex) if rigid else solution[joints : joints + z]
    gaps = np.asarray(displaced - runout - solution[joints - 1], dtype=np.complex128)
    housing = complex(solution[-1]) if line.seating is not None else 0j
    return Response(frequency, solution[:joints], displaced, gaps, -films * gaps, housing, residual)
