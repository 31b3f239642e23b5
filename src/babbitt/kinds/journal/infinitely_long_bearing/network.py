"""Temperatures of film, journal and bush ring: all balances in one linear system.

The film is marched with the flow (upwind); journal and ring are tied to it. Without a ring the march is a
bidiagonal system. With a ring, film and ring temperatures alternate in a band of five, and what closes the system,
the temperature of the journal and the two ends of the ring, is found from unit responses.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgbsv, dgtsv

from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilm
from babbitt.kinds.journal.infinitely_long_bearing.walls import Sectors

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Temperatures:
    """Answer of the network, K and W.

    Attributes
    ----------
    film : ndarray
        At the nodes, shape (n + 1,), from the inlet on.
    bush : ndarray or None
        Of the ring sectors, shape (n,); None without a conducting bush.
    journal : float
        Not a number where nothing exchanges heat with the journal.
    to_oil, to_housing, to_shaft : float
        Heat carried by the oil, through the housing (Q1), along the shaft (Q2).
    film_to_bush, film_to_journal : float
        Q3 and Q4.
    """

    film: Array
    bush: Array | None
    journal: float
    to_oil: float
    to_housing: float
    to_shaft: float
    film_to_bush: float
    film_to_journal: float


def temperatures(film: LongFilm, sectors: Sectors) -> Temperatures:
    """Solve the balances of all sectors, of the ring and of the journal.

    Parameters
    ----------
    film : LongFilm
    sectors : Sectors
    """
    bush = film.exchange.bush
    if bush is not None and bush.conductivity > 0.0 and sectors.to_bush.any():
        return _with_ring(film, sectors)
    return _without_ring(film, sectors)


def _without_ring(film: LongFilm, s: Sectors) -> Temperatures:
    n, inlet = s.source.size, film.inlet_temperature
    right = np.empty((n, 2), order="F")
    right[:, 0], right[:, 1] = s.source, s.to_journal
    right[0, 0] += s.capacity_flow[0] * inlet
    found = dgtsv(-s.capacity_flow[1:], s.capacity_flow + s.to_journal, np.zeros(n - 1), right)[3]
    known, unit = found[:, 0], found[:, 1]
    shaft, ambient = film.exchange.shaft_conductance, film.exchange.ambient_temperature or 0.0
    pull = float(s.to_journal @ (1.0 - unit)) + shaft
    if not pull > 0.0:
        return _answer(film, s, known, None, math.nan)
    journal = (float(s.to_journal @ known) + shaft * ambient) / pull
    return _answer(film, s, known + journal * unit, None, journal)


def _with_ring(film: LongFilm, s: Sectors) -> Temperatures:
    n, inlet = s.source.size, film.inlet_temperature
    neighbour, outward = _ring_conductances(film, n)
    ambient = film.exchange.ambient_temperature or 0.0
    band = np.zeros((7, 2 * n))  # two rows of room for the pivots above the five diagonals
    band[4, 0::2] = s.capacity_flow + s.to_journal + s.to_bush
    band[4, 1::2] = s.to_bush + 2.0 * neighbour + outward
    band[3, 1::2] = -s.to_bush  # film to its ring sector
    band[5, 0::2] = -s.to_bush
    band[6, 0 : 2 * n - 2 : 2] = -s.capacity_flow[1:]
    band[6, 1 : 2 * n - 2 : 2] = -neighbour
    band[2, 3::2] = -neighbour
    right = np.zeros((2 * n, 4), order="F")
    right[0::2, 0], right[1::2, 0] = s.source, outward * ambient
    right[0, 0] += s.capacity_flow[0] * inlet
    right[0::2, 1] = s.to_journal
    right[1, 2] = right[-1, 3] = neighbour
    found = dgbsv(2, 2, band, right)[2]
    shaft = film.exchange.shaft_conductance
    closure, known = np.eye(3), np.empty(3)
    closure[0] = -(s.to_journal @ found[0::2, 1:])
    closure[0, 0] += s.to_journal.sum() + shaft
    known[0] = s.to_journal @ found[0::2, 0] + shaft * ambient
    closure[1] -= found[-1, 1:]
    closure[2] -= found[1, 1:]
    known[1], known[2] = found[-1, 0], found[1, 0]
    ends = np.linalg.solve(closure, known)
    both = found[:, 0] + found[:, 1:] @ ends
    return _answer(film, s, both[0::2], both[1::2], float(ends[0]))


def _ring_conductances(film: LongFilm, n: int) -> tuple[float, float]:
    """Conductance in W/K between neighbouring ring sectors (C_B) and from one to the ambient (k2 S2)."""
    bush, step = film.exchange.bush, 2.0 * math.pi / n
    assert bush is not None
    middle = 0.5 * (film.diameter + bush.outer_diameter)
    section = 0.5 * film.width * (bush.outer_diameter - film.diameter)
    neighbour = bush.conductivity * section / (0.5 * middle * step)
    wall = bush.outer_diameter / (2.0 * bush.conductivity) * math.log(bush.outer_diameter / middle)
    alpha = bush.ambient_coefficient
    outward = alpha / (1.0 + alpha * wall) * film.width * 0.5 * bush.outer_diameter * step
    return neighbour, outward


def _answer(film: LongFilm, s: Sectors, found: Array, bush: Array | None, journal: float) -> Temperatures:
    nodes = np.concatenate(([film.inlet_temperature], found))
    ambient, shaft = film.exchange.ambient_temperature or 0.0, film.exchange.shaft_conductance
    outward = 0.0 if bush is None else _ring_conductances(film, found.size)[1] * float((bush - ambient).sum())
    along = shaft * (journal - ambient) if shaft else 0.0
    return Temperatures(
        film=nodes,
        bush=bush,
        journal=journal,
        to_oil=float(s.capacity_flow @ (nodes[1:] - nodes[:-1])),
        to_housing=outward,
        to_shaft=along,
        film_to_bush=0.0 if bush is None else float(s.to_bush @ (found - bush)),
        film_to_journal=0.0 if math.isnan(journal) else float(s.to_journal @ (found - journal)),
    )
