"""What the compiled kernels of tilting pads hand to each other, in the units of ``babbitt.reynolds._structs``.

Every pad has its own frame: the angle phi from its pivot in the sense of rotation, and in it the place (e, eta)
of the journal, e = c_p - c_b + xi, so that the gap is c_p - e cos(phi) - eta sin(phi) + w(phi).
"""

from __future__ import annotations

from typing import NamedTuple

from numpy import bool_, float64, int64
from numpy.typing import NDArray

from babbitt.reynolds._structs import Bearing

Array = NDArray[float64]


class Pads(NamedTuple):
    """Pads around a journal."""

    bearing: Bearing  # its lands in the frames of their pads; kappa stands in an array of its own
    kappa: Array  # (D/B)^2 / 12 of every pad, (pads,)
    weight: Array  # force of a pad over that of the bearing: its viscosity and its width, (pads,)
    cosine: Array  # of the pivot angle, (pads,)
    sine: Array  # of the pivot angle, (pads,)
    offset: Array  # c_p - c_b, (pads,)
    rotational: Array  # spring against eta, of flexure and pivot in series, (pads,)
    neutral: Array  # s of the flexure without moment, (pads,)
    curves: Array  # columns of ``_pivot_curve``, (pads, 5)
    loads: Array  # table of a pivot, (pads, points or 0)
    displacements: Array  # table of a pivot, (pads, points or 0)
    centred: NDArray[bool_]  # whether it unloads exactly where e falls below zero, (pads,)
    plain: NDArray[bool_]  # whether its bore is a circle and no pressure stands at its edges, (pads,)
    fluidity: Array  # of every interval: unit of viscosity over effective viscosity, (pads, intervals or 0)
    drag: Array  # of every interval: flow by shear over half the gap, (pads, intervals or 0)
    turbulence: Array  # law of every pad (``turbulence.FilmTurbulence.kernel_row``), (pads, numbers or 0)


class PadPlaces(NamedTuple):
    """Where the pads stand, and what their films answer there."""

    radial: Array  # e, (pads,)
    along: Array  # eta, (pads,)
    follows: Array  # d eta / d e along the equilibrium of the pad, (pads,)
    status: NDArray[int64]  # LOADED .. of ``_tilt``, (pads,)
    unloaded_below: Array  # largest e known to be without equilibrium, (pads,)
    answers: Array  # force, stiffness and damping of the film in (e, eta), (pads, 10)
    force: Array  # on the journal along n and tau, corrected to vanishing moment, (pads, 2)
    stiffness: Array  # condensed stiffness in (n, tau), row by row, (pads, 4)
    gain: Array  # how far e follows the journal along n, (pads,)
    rigid: Array  # e with a rigid pivot, (pads,)
    fold: Array  # e at which a free pad on an elastic pivot unloads, nan where it is not known, (pads,)
    need: Array  # load that a pad at its limit would have to carry, (pads,)
    least: Array  # the least that it can, (pads,)
    films: NDArray[int64]  # solutions of a film so far, (1,)
