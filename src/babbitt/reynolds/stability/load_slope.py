"""Stiffness and damping held against the slope of the film's own load, its temperatures as they are.

The exact derivative of a film with its active set frozen leaves out what moves with the journal between the nodes:
the end of the film beside pockets and holes, oil that runs out of a ruptured zone; and it leaves the bore where it
is. Central differences of the force, over steps that take nodes across, see all of it. A bore that gives way has
no delay: with K and C so that F = -K x - C v to first order in the velocity v, its displacement u settles beside
the pressure at every position, and moves with du/dt = (du/dx) v, which squeezes the film as the journal does.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from babbitt.numerics.anderson import AndersonOptions, fixed_point
from babbitt.numerics.secants import RecycledSecants
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.lands._equilibrium import CONVERGED
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.surface_equilibrium import SurfaceEquilibrium, ring_at
from babbitt.reynolds.surface.surface_solution import mirrored, true_pressures
from babbitt.reynolds.surface.unwrapped_mesh import field_at, gauss_angles

__all__ = ["CLOSE", "EquilibriumNodes", "SlopeCheck", "confirmed_coefficients"]

Array = NDArray[np.float64]
Pair = tuple[Array, Array]
BoreGain = Callable[[FilmSolution], Array]
"""Gain of the gap by the pressure of a film, m, as a ``babbitt.reynolds.model.Field`` has it."""

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

BORE_CLOSENESS, BORE = 5e-5, AndersonOptions(most_evaluations=40, damping=0.6, astray=5.0)
"""Share of the step to which film and bore agree, and how that is sought."""

FEW = 0.01
"""Share of the nodes that may change sides for ever."""


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
class EquilibriumNodes:
    """A film at rest as it was solved, node by node with the viscosity that every node has.

    Attributes
    ----------
    ring : SurfaceEquilibrium
    frame : LoadFrame
        From the film as given to that which was solved.
    scales : Scales
    """

    ring: SurfaceEquilibrium
    frame: LoadFrame
    scales: Scales


def can_be_checked(film: JournalFilm) -> bool:
    """Whether coefficients are the slope of the load at standing supplies: not where closed pockets answer."""
    turns = film.angular_speed != 0.0 and film.cavitation is not Cavitation.HALF_SOMMERFELD
    return turns and not any(pocket.closed for pocket in film.pockets)


def confirmed_coefficients(
    found: FilmSolution,
    resolution: Resolution,
    nodes: EquilibriumNodes | None = None,
    bore_gain: BoreGain | None = None,
) -> tuple[FilmSolution, SlopeCheck | None]:
    """A film with coefficients that are the slope of its own load, within 1 %.

    Parameters
    ----------
    found : FilmSolution
        In equilibrium.
    resolution : Resolution
        Its grid.
    nodes : EquilibriumNodes or None
        Of a film with temperatures of its own; None: the film has one temperature.
    bore_gain : callable or None
        How the bore gives way under the pressure of a film, beside other displacements; None: it is rigid.

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
    slope, check = _slope_near(_NearbyFilms(found, nodes, bore_gain), frozen)
    if slope is None:
        return found, check
    c, s = math.cos(nodes.frame.angle), math.sin(nodes.frame.angle)
    turn = np.array([[c, s], [-s, c]]) @ np.diag(scales.sense)
    unit = scales.force / scales.length
    stiffness, damping = (turn @ one @ turn.T * unit for one in slope)
    return replace(found, stiffness=stiffness, damping=damping / scales.rate), check


def _nodes_of(found: FilmSolution, resolution: Resolution) -> EquilibriumNodes:
    """Nodes of a film of one temperature, solved anew in the frame of its load."""
    film, (x, y) = found.film, found.position
    frame = LoadFrame.of(film, (-float(found.force[0]), -float(found.force[1])))
    scales = Scales.of(frame.film, abs(film.angular_speed))
    seen = mirrored(frame.film) if film.angular_speed < 0.0 else frame.film
    at = np.asarray(frame.place((float(x), float(y)))) * scales.sense / scales.length
    return EquilibriumNodes(ring_at(seen, scales.pressure, at, np.zeros(2), resolution), frame, scales)


def _slope_near(beside: _NearbyFilms, frozen: Pair) -> tuple[Pair | None, SlopeCheck]:
    """Slope that takes the place of the frozen coefficients, None where they are confirmed or none is settled."""
    step = STEP * beside.nodes.ring.gap
    before, last = _slope(beside, step, None), None
    check = _check(frozen, before.both, settled=True)
    if check.confirmed:
        return None, check
    for _ in range(HALVINGS):
        step *= 0.5
        finer = _slope(beside, step, before)
        pairs = zip(finer.both, before.both, strict=True)
        stiffness, damping = ((4.0 * fine - coarse) / 3.0 for fine, coarse in pairs)
        better = stiffness, damping
        agree = last is not None and _check(last, better, settled=True).confirmed
        check = _check(frozen, better, settled=agree and beside.settled)
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


@dataclass(frozen=True, eq=False)
class _Slope:
    """Central differences of the force over steps of the journal and over its velocity, (2, 2), and what the bore
    gives way for them, (x, y, their velocities) both ways."""

    both: Pair
    gains: tuple[Pair, ...]


def _slope(beside: _NearbyFilms, step: float, twice: _Slope | None) -> _Slope:
    """Slope over a step; ``twice`` is that over twice the step, if known."""
    stiffness, damping, still = np.zeros((2, 2)), np.zeros((2, 2)), np.zeros(2)
    beside.settled, beside.closeness = True, BORE_CLOSENESS * step
    half = [None] * 4 if twice is None else [(0.5 * fore, 0.5 * back) for fore, back in twice.gains]
    gains: list[Pair] = []
    for axis in range(2):
        move = np.zeros(2)
        move[axis] = step
        fore, back = beside.pair(move, still, 0.0, half[len(gains)])
        stiffness[:, axis] = (back.force - fore.force) / (2.0 * step)
        gains.append((fore.gain, back.gain))
        opening = VELOCITY * 0.5 * (fore.gain - back.gain)  # the bore moves as it does from place to place
        fore, back = beside.pair(still, VELOCITY * move, opening, half[len(gains)])
        damping[:, axis] = (back.force - fore.force) / (2.0 * VELOCITY * step)
        gains.append((fore.gain, back.gain))
    return _Slope((stiffness, damping), tuple(gains))


@dataclass(frozen=True, eq=False)
class _Displaced:
    """Force of the film at a displaced journal, and what the bore gives way there, (2, n, points)."""

    force: Array
    gain: Array


class _NearbyFilms:
    """Films near one in equilibrium, on its nodes; `settled` says whether all since it was set converged, film and
    bore to `closeness`, in clearances."""

    def __init__(self, found: FilmSolution, nodes: EquilibriumNodes, bore_gain: BoreGain | None) -> None:
        ring = nodes.ring.sample.ring
        self.nodes, self.settled, self.closeness = nodes, True, 0.0
        self._sample, self._bore_gain = nodes.ring.sample, bore_gain
        self._wet = self._sample.work.wet.copy()
        self._gaps = np.array([ring.surface.gap_a, ring.surface.gap_b])
        sense, angle = float(nodes.scales.sense[1]), nodes.frame.angle
        self._angles = [sense * at - angle for at in gauss_angles(ring.theta)]
        self._seen = replace(
            found,
            angles=sense * ring.theta[None, : self._wet.shape[0]] - angle,
            axial_positions=ring.mesh.nodes * (0.5 * found.film.width),
            axial_breaks=ring.mesh.breaks,
        )
        self._at_rest = self._own_gain()
        self._secants = RecycledSecants(BORE.damping, BORE.astray)
        self._last_converged = True

    def pair(
        self, move: Array, rate: Array, opening: Array | float, guess: Pair | None
    ) -> tuple[_Displaced, _Displaced]:
        """Films with the journal displaced and moving, and the bore opening by itself, to both sides.

        ``guess`` is what the bore gives way, if known.
        """
        fore = self._film(move, rate, opening, np.zeros(self._gaps.shape) if guess is None else guess[0])
        back = self._film(-move, -rate, -opening, -fore.gain if guess is None else guess[1])
        return fore, back

    def _film(self, move: Array, rate: Array, opening: Array | float, guess: Array) -> _Displaced:
        sample, at = self._sample, self.nodes.ring.position + move
        surface, shape = sample.ring.surface, self._gaps.shape
        sample.work.wet[:] = self._wet
        if self._bore_gain is None:
            self.settled = self._settle(at, rate) and self.settled
            return _Displaced(sample.force.copy(), np.zeros(shape))
        surface.opening_a[:], surface.opening_b[:] = np.broadcast_to(opening, shape)

        def mismatch(solve: Callable[[Array, Array], bool], gain: Array) -> Array:
            surface.gap_a[:], surface.gap_b[:] = self._gaps + gain.reshape(shape)
            self._last_converged = solve(at, rate)
            return (self._own_gain() - self._at_rest).ravel() - gain

        def close(_: Array, off: Array) -> bool:
            return float(np.abs(off).max()) <= self.closeness

        found = fixed_point(partial(mismatch, self._settle), close, guess.ravel(), BORE, secants=self._secants)
        if not found.converged:
            solve = partial(self._solve_on, sample.work.wet.copy())
            found = fixed_point(partial(mismatch, solve), close, found.state, BORE)
        self.settled = self.settled and found.converged and self._last_converged
        surface.gap_a[:], surface.gap_b[:] = self._gaps
        surface.opening_a[:], surface.opening_b[:] = 0.0, 0.0
        return _Displaced(sample.force.copy(), found.state.reshape(shape))

    def _settle(self, at: Array, rate: Array) -> bool:
        """Rounds of the active set; whether it converged."""
        return any(self._sample.evaluate(at, rate) == 0 for _ in range(ROUNDS))

    def _solve_on(self, wet: NDArray[np.bool_], at: Array, rate: Array) -> bool:
        """Film on an active set; whether it is that of the film but for `FEW` nodes.

        Where a node that changes sides moves the bore so that it changes back, no film and bore agree with both.
        """
        self._sample.work.wet[:] = wet
        return self._sample.evaluate(at, rate) <= FEW * wet.size

    def _own_gain(self) -> Array:
        """What the bore gives way under the pressure of the last film, in clearances, (2, n, points)."""
        if self._bore_gain is None:
            return np.zeros(self._gaps.shape)
        film, ring = self._seen.film, self._sample.ring
        pressure = true_pressures(ring.surface, self._sample.work.pressure) * self.nodes.scales.pressure
        void = np.where(self._sample.work.holds, 0.0, 1.0)
        seen = replace(self._seen, pressure=pressure[None] + film.cavitation_pressure, void=void[None])
        field = self._bore_gain(seen)
        z = ring.mesh.points * (0.5 * film.width)
        return np.array([field_at(film, field, at, z) for at in self._angles]) / film.clearance
