"""The pressure of a hydrostatic film on the lines on which it was solved, over the whole bearing."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.answer import Answer
from babbitt.kinds.hydrostatic.geometry import CircularPad, RecessedJournal, RectangularPad
from babbitt.kinds.hydrostatic.model import HydrostaticCase

__all__ = ["pressure_field"]

Array = NDArray[np.float64]

FEWEST = 60
"""Lines around a round pad: one solved on fewer is the same all around."""


def pressure_field(case: HydrostaticCase, found: Answer) -> tuple[Array, Array, Array]:
    """Places and pressures, three arrays of one shape.

    Parameters
    ----------
    case : HydrostaticCase
    found : Answer
        With a film.

    Returns
    -------
    x, y : ndarray
        Of a bore the angle in rad and the distance from mid-plane in m, of all others two lengths in m.
    pressure : ndarray
        Gauge, Pa.
    """
    assert found.film is not None
    of = found.film.film.of
    pressure = found.film.film.pressures()
    lines = of.recess.shape[0]
    if of.surface.cyclic:
        pressure = np.vstack((pressure, pressure[:1]))
    theta = of.theta[: pressure.shape[0]] if of.surface.cyclic else of.theta[:lines]
    nodes = of.mesh.nodes
    shape = case.shape
    if isinstance(shape, RecessedJournal | RectangularPad):
        aside = 0.5 * shape.width * np.concatenate((-nodes[::-1], nodes))
        along = theta if isinstance(shape, RecessedJournal) else shape.length * (theta - 0.5)
        x, y = np.meshgrid(along, aside, indexing="ij")
        return x, y, np.hstack((pressure[:, ::-1], pressure))
    if theta.size < FEWEST:
        theta, pressure = np.linspace(0.0, 2.0 * math.pi, 121), np.repeat(pressure[:1], 121, axis=0)
    if isinstance(shape, CircularPad):
        nodes, pressure = np.append(0.0, nodes), np.hstack((pressure[:, :1], pressure))
    radius = case.reach * nodes
    return np.cos(theta)[:, None] * radius, np.sin(theta)[:, None] * radius, pressure
