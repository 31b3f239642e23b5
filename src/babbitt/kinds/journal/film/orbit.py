"""The orbit of a journal under a load that changes: where it goes, how thin the film becomes, what it costs.

Equation of motion ``m r'' = F(r, r') + W(t)``. Without mass the film force balances the load at every instant,
``F(r, r') + W(t) = 0``, and Newton's method with the exact damping solves it for the velocity; with mass it is an
equation of second order. Either is integrated by LSODA with the Jacobian of the film, ``-C^-1 K`` or
``[[0, 1], [-K/m, -C/m]]``, for near contact the film is stiff.

The film has no memory here: its void is that of the Reynolds condition at every instant, and the history of the
oil in the ruptured zone is left out. Lengths in clearances, times in radians that the journal has turned.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Outcome
from babbitt.kinds.journal.film.changing_load import ChangingLoad
from babbitt.kinds.journal.film.moving_journal import (
    MOST_FILMS,
    HeavyJournal,
    MasslessJournal,
    MovingJournal,
    NoMotionError,
)
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import DRAFT, Cavitation, JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution

__all__ = ["Orbit", "find_orbit"]

Array = NDArray[np.float64]

POINTS, WITHIN = 144, 8
"""Instants of a cycle at which the film is read, and how many more from one corner of the load to the next."""

FEW = 72
"""Corners of the load up to which the march stops at each; beyond, no step is longer than the least distance
between two."""

MOST_STEPS = 5000
"""Steps of a cycle to which the corners of a load may hold the march, and corners at which it is read."""

MOST_CYCLES = 40
"""Cycles after which the march ends."""

CLOSED = 1e-3
"""Distance between begin and end of a cycle that counts as closed, over the thinnest film and the size of the
orbit: a journal that sinks slowly moves little, but loses a share of its film in each cycle. With mass
the velocity must come back, too: a free motion that dies out may pass by the place where the cycle began."""

FAR = 0.05
"""Distance over the clearance between begin and end of a cycle, above which the journal wanders rather than
sinks."""

ACCURACY = 3e-5
"""Of a step of the march, relative; a tenth of it, over the clearance, absolute."""

THINNEST = 1e-3
"""Film thickness over clearance at which the film counts as squeezed out."""

GRID_DOUBT = 0.3
"""Share of the load that a grid twice as fine does not confirm, from which the film is taken for squeezed out:
where wedge and squeeze cancel, as for a load at half the speed, what is left to carry is the error of the grid."""

STILL_THINNING = 2e-3
"""Relative loss of film from one cycle to the next, at the end of the march, that tells squeezing from
wandering."""


@dataclass(frozen=True, eq=False)
class Orbit:
    """One cycle of the journal, or the last one reached.

    Attributes
    ----------
    outcome : Outcome
        `CONVERGED`: the orbit closes. Otherwise the numbers are those of the last cycle.
    turned : ndarray, shape (n,)
        Angle that the journal has turned since the cycle began, rad, in its own sense; the end is left out.
    position, velocity : ndarray, shape (n, 2)
        Of the journal centre, m and m/s.
    load : ndarray, shape (n, 2)
        N.
    film_thickness, maximum_pressure, friction_torque : ndarray, shape (n,)
        Smallest film thickness in m, gauge pressure in Pa, torque on the journal in N m.
    clearance, speed : float
        Radial, m; of the journal, rad/s.
    cycle : float
        Angle that the journal turns in a cycle, rad.
    load_error : float
        Share of the load that a grid twice as fine does not confirm, at the thinnest film.
    cycles : int
        Marched until the orbit closed.
    wall_time : float
        s.
    """

    outcome: Outcome
    turned: Array
    position: Array
    velocity: Array
    load: Array
    film_thickness: Array
    maximum_pressure: Array
    friction_torque: Array
    clearance: float
    speed: float
    cycle: float
    load_error: float
    cycles: int
    wall_time: float

    @property
    def largest_eccentricity_ratio(self) -> float:
        """Of the cycle."""
        return float(np.hypot(*self.position.T).max() / self.clearance)

    @property
    def thinnest(self) -> int:
        """Which instant has the thinnest film."""
        return int(np.argmin(self.film_thickness))

    @property
    def thinnest_direction(self) -> float:
        """Direction of the journal centre when the film is thinnest, rad."""
        x, y = self.position[self.thinnest]
        return math.atan2(y, x)

    @property
    def friction_power(self) -> float:
        """Mean of friction torque times speed, W."""
        return self._mean(self.friction_torque) * abs(self.speed)

    @property
    def load_power(self) -> float:
        """Mean power with which the moving load drives the film, W."""
        return self._mean((self.load * self.velocity).sum(axis=1))

    def _mean(self, values: Array) -> float:
        """Mean over the cycle by the trapezoidal rule."""
        closed = np.append(self.turned, self.turned[0] + self.cycle)
        return float(np.trapezoid(np.append(values, values[0]), closed) / self.cycle)


def find_orbit(
    film: JournalFilm,
    changing: ChangingLoad,
    steady: tuple[float, float] = (0.0, 0.0),
    speed: float | None = None,
    mass: float = 0.0,
    resolution: Resolution = DRAFT,
    watch: ProgressCallback = no_progress,
) -> Orbit:
    """March a journal under a changing load until its orbit closes.

    Parameters
    ----------
    film : JournalFilm
        A mass-conserving film is taken with the Reynolds condition.
    changing : ChangingLoad
    steady : tuple of float
        Added to it, N.
    speed : float, optional
        Of the journal, with which the load keeps step, rad/s; that of the film if the bearing stands still.
    mass : float
        Of the rotor that moves with the journal, kg.
    resolution : Resolution
    watch : ProgressCallback
        Follows the cycles, of which most orbits need few.

    Returns
    -------
    Orbit
        Always; ``outcome`` says whether it closes, the film is squeezed out, or it does neither in `MOST_CYCLES`.

    Raises
    ------
    InputError
        E101 for a half-Sommerfeld film, which has no damping, or a journal at rest.
    """
    begun = time.perf_counter()
    if film.cavitation is Cavitation.HALF_SOMMERFELD:
        raise InputError(
            "E101", "a half-Sommerfeld film has no damping and makes no orbit; choose Cavitation.REYNOLDS"
        )
    speed = film.angular_speed if speed is None else speed
    if speed == 0.0:
        raise InputError("E101", "the journal stands still; an orbit keeps step with a journal that turns")
    thin = replace(film, cavitation=Cavitation.REYNOLDS)
    moving = thin, np.asarray(steady), changing, speed, resolution
    journal = HeavyJournal(*moving, mass) if mass > 0.0 else MasslessJournal(*moving)
    return _marched(journal, begun, watch)


def _marched(journal: MasslessJournal | HeavyJournal, begun: float, watch: ProgressCallback) -> Orbit:
    instants = _instants(journal.changing)
    try:
        states, outcome, moved, cycles = _last_cycle(journal, instants, watch)
        journal.films = 0
        return _read(journal, instants[:-1], states, outcome, moved > FAR, cycles, begun)
    except NoMotionError:
        nothing = np.full(1, np.nan)
        two = np.full((1, 2), np.nan)
        return Orbit(
            Outcome.NOT_CONVERGED, nothing, two, two, two, nothing, nothing, nothing, journal.c, journal.speed,
            journal.changing.cycle, math.nan, 0, time.perf_counter() - begun,
        )  # fmt: skip


def _last_cycle(
    journal: MasslessJournal | HeavyJournal, instants: Array, watch: ProgressCallback
) -> tuple[Array, Outcome, float, int]:
    """States of the cycle in which the orbit closes or the march ends, outcome, distance moved, and cycles."""
    state = journal.start(_begin(journal, instants))
    known: Array | None = None
    thinnest: list[float] = []
    moved, cycles = 0.0, 0
    for cycles in watch(range(1, MOST_CYCLES + 1)):
        try:
            passed = _cycle(journal, instants, state)
        except NoMotionError:
            passed = None
        if passed is None:
            if known is None:
                raise NoMotionError
            return known, Outcome.NOT_CONVERGED, moved, cycles - 1
        known, after = passed[:, :-1], passed[:, -1]
        moved, apart = float(np.hypot(*(after - state)[:2])), _apart(state, after, known)
        state = after
        thinnest.append(_thinnest(journal, known))
        if thinnest[-1] < THINNEST:
            return known, Outcome.SQUEEZED_OUT, moved, cycles
        if cycles > 1 and apart < max(CLOSED * min(thinnest[-1], _size(known[:2])), ACCURACY):
            return known, Outcome.CONVERGED, moved, cycles
        if journal.films > MOST_FILMS and cycles > 1:
            break
    thins = thinnest[-1] < (1.0 - STILL_THINNING) * thinnest[-2]
    assert known is not None
    return known, Outcome.SQUEEZED_OUT if thins and moved < FAR else Outcome.NOT_PERIODIC, moved, cycles


def _instants(changing: ChangingLoad) -> Array:
    """Angles turned at which a cycle is read, its end included: evenly, at the corners of the load and between.

    Between the corners of a fine table the load is too short to be read once more.
    """
    even, own = np.linspace(0.0, changing.cycle, POINTS + 1), np.asarray(changing.corners)
    if own.size > FEW:
        own = own[:: math.ceil(own.size / MOST_STEPS)]
    elif own.size:
        edges = _edges(changing)
        own = np.linspace(edges[:-1], edges[1:], WITHIN + 1).ravel()
    both = np.unique(np.concatenate((even, own)))
    apart = np.append(True, np.diff(both) > 1e-9 * changing.cycle)
    return np.asarray(both[apart])


def _edges(changing: ChangingLoad) -> Array:
    """Begin and end of a cycle and the corners of the load at which the march stops."""
    few = changing.corners if len(changing.corners) <= FEW else ()
    inner = [corner for corner in few if 1e-9 < corner / changing.cycle < 1.0 - 1e-9]
    return np.array([0.0, *inner, changing.cycle])


def _cycle(journal: MasslessJournal | HeavyJournal, instants: Array, state: Array) -> Array | None:
    """March through a cycle from corner to corner of its load; states at the instants, None where a march ends.

    Steps that are free to grow while the load rests would pass over a short pulse without seeing it.
    """
    from scipy.integrate import solve_ivp

    changing = journal.changing
    edges, longest, states = _edges(changing), math.inf, [state[:, None]]
    if len(changing.corners) > FEW:
        longest = max(float(np.diff(changing.corners).min()), changing.cycle / MOST_STEPS)
    for begin, end in pairwise(edges):
        read = instants[(instants > begin + 1e-9 * changing.cycle) & (instants < end - 1e-9 * changing.cycle)]
        run = solve_ivp(
            journal.slope, (begin, end), state, method="LSODA", t_eval=np.append(read, end), jac=journal.jacobian,
            rtol=ACCURACY, atol=0.1 * ACCURACY, max_step=longest,
        )  # fmt: skip
        if not run.success:
            return None
        state = run.y[:, -1]
        states.append(run.y)
    return np.concatenate(states, axis=1)


def _apart(begin: Array, end: Array, states: Array) -> float:
    """Distance between begin and end of a cycle: of the places or, with mass, of the velocities if that is larger.

    Velocities count by the time in which the journal passes its orbit, so that a share of the largest velocity
    counts as that share of the size. A cycle whose velocity comes back changes no momentum: its mean film force is
    the mean load.
    """
    place, velocity = np.hypot(*(end - begin)[:2]), (end - begin)[2:]
    quickest = _size(states[2:]) if velocity.size else 0.0
    return float(max(place, np.hypot(*velocity) * _size(states[:2]) / quickest) if quickest > 0.0 else place)


def _size(path: Array) -> float:
    """Larger extent of a path in the plane."""
    return float(np.ptp(path, axis=1).max())


def _begin(journal: MovingJournal, instants: Array) -> Array:
    """Equilibrium position under the mean load, else a little below the centre."""
    loads = np.array([journal.load(turned) for turned in instants])
    mean = np.trapezoid(loads, instants, axis=0) / journal.changing.cycle
    if math.hypot(*mean) > 1e-3 * np.hypot(*loads.T).max() and journal.film.angular_speed:
        rest = solve_journal(journal.film, (float(mean[0]), float(mean[1])), journal.resolution)
        if rest.outcome.solved:
            return np.asarray(rest.position / journal.c)
    return np.asarray(0.1 * loads[0] / max(math.hypot(*loads[0]), 1e-300))


def _thinnest(journal: MovingJournal, states: Array) -> float:
    """Smallest film thickness of a cycle over the clearance."""
    from babbitt.kinds.journal.film.field import bore_outline

    angles = np.linspace(0.0, 2.0 * math.pi, 361)
    bore = bore_outline(journal.film, angles) / journal.c
    gap = bore[None, :] - np.outer(states[0], np.cos(angles)) - np.outer(states[1], np.sin(angles))
    return float(gap.min())


def _read(
    journal: MasslessJournal | HeavyJournal,
    instants: Array,
    states: Array,
    outcome: Outcome,
    wanders: bool,
    cycles: int,
    begun: float,
) -> Orbit:
    """Film at every instant of a cycle."""
    found = [journal.film_of(turned, state) for turned, state in zip(instants, states.T, strict=True)]
    velocity = np.array([one for one, _ in found]) * (journal.c * journal.rate)
    films = [film for _, film in found]
    thickness = np.array([film.minimum_film_thickness for film in films])
    error = _load_error(journal, int(np.argmin(thickness)), films, velocity)
    if not wanders and error > GRID_DOUBT:
        outcome = Outcome.SQUEEZED_OUT
    return Orbit(
        outcome=outcome,
        turned=instants,
        position=states[:2].T * journal.c,
        velocity=velocity,
        load=np.array([journal.load(turned) for turned in instants]),
        film_thickness=thickness,
        maximum_pressure=np.array([film.maximum_pressure for film in films]),
        friction_torque=np.array([film.friction_torque for film in films]),
        clearance=journal.c,
        speed=journal.speed,
        cycle=journal.changing.cycle,
        load_error=error,
        cycles=cycles,
        wall_time=time.perf_counter() - begun,
    )


def _load_error(journal: MovingJournal, instant: int, films: list[FilmSolution], velocity: Array) -> float:
    """Change of the film force at one instant on a grid twice as fine, over the force."""
    film, grid = films[instant], journal.resolution
    x, y = film.position
    finer = film_at_position(
        journal.film, (float(x), float(y)), (float(velocity[instant, 0]), float(velocity[instant, 1])),
        replace(grid, intervals=2 * grid.intervals),
    )  # fmt: skip
    return math.hypot(*(finer.force - film.force)) / film.load if finer.outcome.solved else math.inf
