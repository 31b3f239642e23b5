"""Stiffness and damping held against the slope of the film's own load, its temperatures as they are.

The exact derivative of a film with its active set frozen leaves out what moves with the journal between the nodes:
the end of the film beside pockets and holes, oil that runs out of a ruptured zone. Central differences of the
force, over steps that take nodes across, see all of it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.film._equilibrium import CONVERGED
from babbitt.film.frame import LoadFrame
from babbitt.film.general import Sample, SettledRing, ring_at
from babbitt.film.model import Cavitation, JournalFilm, Resolution
from babbitt.film.ring_solution import mirrored
from babbitt.film.scales import Scales
from babbitt.film.solution import FilmSolution

__all__ = ["CLOSE", "RestingNodes", "SlopeCheck", "confirmed_coefficients"]

Array = NDArray[np.float64]
Pair = tuple[Array, Array]

STEP = 0.02
"""First step of the journal, over the smallest gap."""

HALVINGS = 3
"""Of the step: close to the centre the force bends within two per cent of the gap."""

CLOSE = 0.01
"""Difference over the matrix (Frobenius) within which stiffness or damping counts as confirmed."""

VELOCITY = 0.5
"""Velocity of the journal for damping, over the step times the angular speed."""

ROUNDS = 60
"""Of the active set at a displaced journal, at most."""


@dataclass(frozen=True)
class SlopeCheck:
    """What the slope of a film's own load tells of its coefficients.

    Attributes
    ----------
    stiffness, damping : float
        Difference of the derivative with a frozen active set from the slope, over the slope.
    settled : bool
        Whether two step sizes agree on the slope; if not, the differences are those measured last.
    """

    stiffness: float
    damping: float
    settled: bool

    @property
    def confirmed(self) -> bool:
        """Whether both are those of the film's own load."""
        return max(self.stiffness, self.damping) <= CLOSE


@dataclass(frozen=True, eq=False)
class RestingNodes:
    """A film at rest as it was solved, node by node with the viscosity that every node has.

    Attributes
    ----------
    ring : SettledRing
    frame : LoadFrame
        From the film as given to that which was solved.
    scales : Scales
    """

    ring: SettledRing
    frame: LoadFrame
    scales: Scales


def can_be_checked(film: JournalFilm) -> bool:
    """Whether coefficients are the slope of the load at standing supplies: not where closed pockets answer."""
    turns = film.angular_speed != 0.0 and film.cavitation is not Cavitation.HALF_SOMMERFELD
    return turns and not any(pocket.closed for pocket in film.pockets)


def confirmed_coefficients(
    found: FilmSolution, resolution: Resolution, nodes: RestingNodes | None = None
) -> tuple[FilmSolution, SlopeCheck | None]:
    """A film with coefficients that are the slope of its own load, within 1 %.

    Parameters
    ----------
    found : FilmSolution
        In equilibrium.
    resolution : Resolution
        Its grid.
    nodes : RestingNodes or None
        Of a film with temperatures of its own; None: the film has one temperature.

    Returns
    -------
    FilmSolution
        The same where its coefficients are confirmed, or nothing better was found; else with central differences,
        D = (F(-s) - F(s)) / 2s at two steps, extrapolated as (4 D(s/2) - D(s)) / 3.
    SlopeCheck or None
        None where no slope can be taken: films that separate into modes of the width (their derivative is exact to
        less than 1 %), closed pockets.
    """
    film = found.film
    if not (found.outcome.solved and can_be_checked(film)):
        return found, None
    if nodes is None and film.is_surface:
        nodes = _nodes_of(found, resolution)
    if nodes is None or nodes.ring.status != CONVERGED:
        return found, None
    ring, scales = nodes.ring, nodes.scales
    frozen = ring.sample.stiffness.copy(), ring.sample.damping.copy()
    slope, check = _slope_beside(ring.sample, ring.position, ring.gap, frozen)
    if slope is None:
        return found, check
    c, s = math.cos(nodes.frame.angle), math.sin(nodes.frame.angle)
    turn = np.array([[c, s], [-s, c]]) @ np.diag(scales.sense)
    unit = scales.force / scales.length
    stiffness, damping = (turn @ one @ turn.T * unit for one in slope)
    return replace(found, stiffness=stiffness, damping=damping / scales.rate), check


def _nodes_of(found: FilmSolution, resolution: Resolution) -> RestingNodes:
    """Nodes of a film of one temperature, solved anew in the frame of its load."""
    film, (x, y) = found.film, found.position
    frame = LoadFrame.of(film, (-float(found.force[0]), -float(found.force[1])))
    scales = Scales.of(frame.film, abs(film.angular_speed))
    seen = mirrored(frame.film) if film.angular_speed < 0.0 else frame.film
    at = np.asarray(frame.place((float(x), float(y)))) * scales.sense / scales.length
    return RestingNodes(ring_at(seen, scales.pressure, at, np.zeros(2), resolution), frame, scales)


def _slope_beside(sample: Sample, at: Array, gap: float, frozen: Pair) -> tuple[Pair | None, SlopeCheck]:
    """Slope that takes the place of the frozen coefficients, None where they are confirmed or none is settled."""
    active = sample.work.wet.copy()
    step, before, last = STEP * gap, _slope(sample, at, STEP * gap, active), None
    check = _check(frozen, before, settled=True)
    if check.confirmed:
        return None, check
    for _ in range(HALVINGS):
        step *= 0.5
        finer = _slope(sample, at, step, active)
        better = (4.0 * finer[0] - before[0]) / 3.0, (4.0 * finer[1] - before[1]) / 3.0
        check = _check(frozen, better, settled=last is not None and _check(last, better, settled=True).confirmed)
        if check.confirmed:
            return None, check
        if check.settled:
            return better, check
        before, last = finer, better
    return None, check


def _check(one: Pair, slope: Pair, *, settled: bool) -> SlopeCheck:
    off = [
        float(np.linalg.norm(mine - own)) / max(float(np.linalg.norm(own)), 1e-300)
        for mine, own in zip(one, slope, strict=True)
    ]
    return SlopeCheck(off[0], off[1], settled)


def _slope(sample: Sample, at: Array, step: float, active: NDArray[np.bool_]) -> Pair:
    """Central differences of the force over steps of the journal and over its velocity."""
    stiffness, damping = np.zeros((2, 2)), np.zeros((2, 2))
    for axis in range(2):
        move = np.zeros(4)
        move[axis] = step
        fore, back = (_force(sample, at + sign * move[:2], np.zeros(4), active) for sign in (1.0, -1.0))
        stiffness[:, axis] = (back - fore) / (2.0 * step)
        fore, back = (_force(sample, at, sign * VELOCITY * move, active) for sign in (1.0, -1.0))
        damping[:, axis] = (back - fore) / (2.0 * VELOCITY * step)
    return stiffness, damping


def _force(sample: Sample, at: Array, rate: Array, active: NDArray[np.bool_]) -> Array:
    sample.work.wet[:] = active
    for _ in range(ROUNDS):
        if sample.evaluate(at, rate) == 0:
            break
    return sample.force.copy()
