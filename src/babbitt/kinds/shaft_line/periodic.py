"""Nonlinear motion of a line: the motion that repeats with the excitations, on film forces of any height and tilt.

The film forces are written as linear ones about the static state and a rest n(h, h') that is of second order. Line
and pads answer to excitations and rest exactly at every harmonic (`babbitt.kinds.shaft_line.compliance`), the rest
is evaluated at the samples of a period, and both are made to agree by a Newton-Krylov method. Small excitations
leave no rest: the motion is then the linear answer. Of large ones the motion is sought with growing amplitude.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError, Notice
from babbitt.core.picklable_error import PicklableError
from babbitt.kinds.shaft_line.compliance import LineCompliance, line_compliance
from babbitt.kinds.shaft_line.excitation import WITHOUT_WOBBLE, WOBBLE_LEFT_OUT
from babbitt.kinds.shaft_line.forced import crests
from babbitt.kinds.shaft_line.model import LineState
from babbitt.kinds.thrust.film_table import FilmTable, film_table
from babbitt.kinds.thrust.gap import minimum_gap
from babbitt.kinds.thrust.state import CONTACT

__all__ = ["NoPeriodicMotionError", "PeriodicMotion", "periodic_motion"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

TOLERANCE = 1e-6
"""Of the harmonics of a motion over the largest change of a film: how well they agree with their forces."""
REPEATS = 2e-3
"""Of a film over the largest change of one: how far the motion, with the harmonics left out, may miss itself."""
SAMPLES, PER_HARMONIC = 256, 24
"""Samples of a revolution at least, and of one period of the fastest excitation."""
MOST_TURNS = 20
"""Revolutions after which the motion must repeat."""
MOST_POINTS = 400_000
"""Samples times pads at most, and..."""
MOST_WORK = 1_200_000
"""film forces of one pad at one time at most, for the sake of time; a quarter of them for one amplitude."""
LEAST_STEP = 0.05
"""Growth of the amplitude from one motion to the next at least; halved from the whole."""
NEAREST = 1e-8
"""Film at a pivot below which forces are no longer followed, m."""


class NoPeriodicMotionError(PicklableError):
    """No motion was found that repeats.

    Attributes
    ----------
    why : Notice
    """

    def __init__(self, why: Notice) -> None:
        super().__init__(why.message)
        self.why = why


@dataclass(frozen=True, eq=False)
class PeriodicMotion:
    """One period of the nonlinear motion.

    Attributes
    ----------
    angles : ndarray, shape (n,)
        Of the shaft, rad.
    loads : ndarray, shape (n, z)
        W_i + N_i, N; 0 or more.
    films : ndarray, shape (n, z)
        At the pivots, m.
    thinnest : ndarray, shape (n, z)
        Thinnest film of each pad, m.
    static_loads, static_films : ndarray, shape (z,)
    outside : bool
        Whether a pad tilted beyond the tabulated films.
    residual : float
        How far films miss themselves after a period, over their largest change.
    """

    angles: Array
    loads: Array
    films: Array
    thinnest: Array
    static_loads: Array
    static_films: Array
    outside: bool
    residual: float

    @property
    def load_peaks(self) -> Array:
        """Largest load above the static one, N."""
        return crests(self.loads.T) - self.static_loads

    @property
    def unload_peaks(self) -> Array:
        """Largest load below the static one, N, positive."""
        return np.minimum(self.static_loads + crests(-self.loads.T), self.static_loads)

    @property
    def peaks(self) -> Array:
        """Largest departure either way, N."""
        return np.maximum(self.load_peaks, self.unload_peaks)

    @property
    def minimum_film(self) -> float:
        """Thinnest film of all pads, m."""
        return float(-crests(-self.thinnest.T).max())

    @property
    def film_shift(self) -> Array:
        """Mean film less the static one, m."""
        return np.asarray(self.films.mean(axis=0) - self.static_films)

    @property
    def lifted(self) -> Array:
        """Fraction of the period during which each pad carries nothing."""
        return np.asarray((self.loads <= 0.0).mean(axis=0))

    @property
    def lifts_off(self) -> bool:
        """Whether a pad loses its load."""
        return bool(self.loads.min() <= 0.0)

    @property
    def touches(self) -> bool:
        """Whether a place of a pad comes as close as surfaces are rough."""
        return self.minimum_film <= CONTACT


def periodic_motion(state: LineState, amplitude: float = 1.0) -> PeriodicMotion:
    """The motion of a line that repeats with its excitations.

    Parameters
    ----------
    state : LineState
        Of plane pads.
    amplitude : float
        Factor on all excitations.

    Raises
    ------
    InputError
        E101 for a collar face that leans over pads with a held tilt; E201 for pads whose films are not similar.
    NoPeriodicMotionError
        If the excitations have no common period of 20 revolutions, or no motion was found that repeats.
    """
    _require_followed(state)
    films = _Films(state, film_table(state.films), _turns(state))
    motion, reached, step = np.zeros(films.shape), 0.0, 1.0
    while reached < 1.0:
        wanted = min(1.0, reached + step)
        # the linear answer grows with the amplitude: so does the first guess
        guess = films.linear(wanted * amplitude) if reached == 0.0 else motion * (wanted / reached)
        found = _repeating(films, wanted * amplitude, guess)
        if found is not None:
            motion, reached = found, wanted
        elif step > LEAST_STEP and films.work < MOST_WORK:
            step *= 0.5
        else:
            raise NoPeriodicMotionError(Notice("W210", "not_found", {"share": float(reached)}))
    loads, outside = films.loads(motion)
    gaps = films.static + motion
    miss = np.abs(films.missed(motion, amplitude)[..., 0]).max() / max(np.abs(motion[..., 0]).max(), 1e-300)
    if not miss < REPEATS:
        raise NoPeriodicMotionError(Notice("W210", "missed", {"miss": float(miss), "bound": REPEATS}))
    pad = state.duty.bearing.pad
    return PeriodicMotion(
        angles=films.angles,
        loads=loads,
        films=gaps[..., 0],
        thinnest=minimum_gap(pad, gaps),
        static_loads=state.share.loads,
        static_films=state.share.heights,
        outside=outside,
        residual=float(miss),
    )


def _require_followed(state: LineState) -> None:
    leans = any(one.leans and one.amplitude > 0.0 for one in state.duty.runouts)
    if leans and len(state.duty.bearing.pad.free_tilts) < 2:
        raise InputError("E101", f"nonlinear motion: {WOBBLE_LEFT_OUT}. Allowed is {WITHOUT_WOBBLE}.")


def _turns(state: LineState) -> int:
    """Revolutions after which all excitations repeat."""
    orders = [part.harmonic.order for part in state.forced.parts]
    near = [Fraction(order).limit_denominator(MOST_TURNS) for order in orders]
    turns = math.lcm(*(one.denominator for one in near))
    if turns > MOST_TURNS or any(abs(float(a) - b) > 1e-9 * b for a, b in zip(near, orders, strict=True)):
        raise NoPeriodicMotionError(Notice("W210", "orders", {"orders": tuple(orders), "turns": MOST_TURNS}))
    return turns


def _repeating(films: _Films, amplitude: float, guess: Array) -> Array | None:
    """Changes of heights and slopes that agree with the forces they cause; None where none were found."""
    from scipy.optimize import NoConvergence, newton_krylov

    largest = max(float(np.abs(guess / films.unit).max()), 1e-12)
    allowed = films.work + MOST_WORK // 4

    def missed(packed: Array) -> Array:
        if films.work > allowed:
            raise NoConvergence(packed)
        return films.packed(films.missed(films.unpacked(packed), amplitude)) / largest

    try:
        with np.errstate(all="ignore"):
            found = newton_krylov(missed, films.packed(guess), method="lgmres", f_tol=TOLERANCE, maxiter=60)
    except (NoConvergence, ValueError, ZeroDivisionError, np.linalg.LinAlgError):
        return None
    return films.unpacked(found)


class _Films:
    """Film forces of a period and the answer of the line to them."""

    def __init__(self, state: LineState, table: FilmTable, turns: int) -> None:
        self.state, self.table = state, table
        duty, share = state.duty, state.share
        fastest = max(part.harmonic.order for part in state.forced.parts)
        count = turns * max(SAMPLES, math.ceil(PER_HARMONIC * fastest))
        if count * share.bearing.number > MOST_POINTS:
            raise NoPeriodicMotionError(Notice("W210", "samples", {
                "order": fastest, "samples": count, "pads": share.bearing.number, "most": MOST_POINTS,
            }))  # fmt: skip
        self.angles = 2.0 * math.pi * turns * np.arange(count) / count
        self.shape = (count, share.bearing.number, 3)
        self.speed, self.work = duty.speed, 0
        self.viscosity = np.array([pad.viscosity for pad in share.states])
        self.static = np.array([pad.motion for pad in share.states])
        width = duty.bearing.pad.outer_radius - duty.bearing.pad.inner_radius
        self.unit = np.array([1.0, 1.0 / width, 1.0 / width]) * float(share.heights.mean())
        self.free = [0, *duty.bearing.pad.free_tilts]
        self.nu = np.asarray(duty.speed / turns * np.arange(count // 2 + 1), dtype=np.float64)
        self.nu[-1] *= 1.0 + 1e-9  # off the frequencies of rods between fixed ends, where nothing moves anyway
        self.line: LineCompliance = line_compliance(duty.line, state.pads, self.nu)
        self.thrust, self.runout = self._excitations(turns)
        self.held, _ = self._forces(np.zeros((1, *self.shape[1:])), np.zeros((1, *self.shape[1:])))
        self.stiffness, self.damping = self._linear()

    def _excitations(self, turns: int) -> tuple[ComplexArray, ComplexArray]:
        """Q and xi at the harmonics, as amplitudes of `numpy.fft.rfft`."""
        half = 0.5 * self.angles.size
        thrust, runout = (
            np.zeros(self.nu.size, dtype=complex),
            np.zeros((self.nu.size, self.shape[1]), dtype=complex),
        )
        for one in self.state.duty.thrusts:
            thrust[round(one.order * turns)] += half * one.amplitude * np.exp(1j * one.phase)
        for part in self.state.forced.parts:
            if part.is_runout:
                runout[round(part.harmonic.order * turns)] += half * part.runout
        return thrust, runout

    def _forces(self, motion: Array, rate: Array) -> tuple[Array, bool]:
        """Force and moments of all films, N and N m, and whether a pad tilts beyond the table."""
        self.work += motion.shape[0] * motion.shape[1]
        gaps = self.static + motion
        heights = np.maximum(gaps[..., 0], NEAREST).ravel()
        wedge, squeeze, outside = self.table.forces(heights, gaps[..., 1:].reshape(-1, 2))
        samples = motion.shape[0]
        viscosity = np.tile(self.viscosity, samples)
        pushed = wedge * (viscosity[:, None] * self.speed)
        pushed -= (squeeze @ rate.reshape(-1, 3, 1))[..., 0] * viscosity[:, None]
        return pushed.reshape(motion.shape), bool(outside.any())

    def _linear(self) -> tuple[Array, Array]:
        """Stiffness and damping of the tabulated films at rest, shape (z, 3, 3), by differences."""
        z = self.shape[1]
        still = np.zeros((1, z, 3))
        stiffness, damping = np.zeros((z, 3, 3)), np.zeros((z, 3, 3))
        for place in range(3):
            step = np.zeros((1, z, 3))
            step[..., place] = 1e-5 * self.unit[place]
            ahead, behind = self._forces(step, still)[0], self._forces(-step, still)[0]
            stiffness[:, :, place] = (behind - ahead)[0] / (2e-5 * self.unit[place])
            damping[:, :, place] = (self.held - self._forces(still, step)[0])[0] / (1e-5 * self.unit[place])
        return stiffness, damping

    def packed(self, motion: Array) -> Array:
        """The lower half of the harmonics of a motion over its unit as real numbers: fewer unknowns, and the rest
        of the films, which has higher ones, is sampled twice as finely."""
        waves = np.fft.rfft(motion / self.unit, axis=0)[: self.nu.size // 2] * (2.0 / self.shape[0])
        return np.concatenate([waves.real.ravel(), waves.imag.ravel()])

    def unpacked(self, packed: Array) -> Array:
        """The motion of packed harmonics."""
        real, imaginary = packed.reshape(2, self.nu.size // 2, *self.shape[1:])
        waves = np.zeros((self.nu.size, *self.shape[1:]), dtype=complex)
        waves[: self.nu.size // 2] = (real + 1j * imaginary) * (0.5 * self.shape[0])
        return np.asarray(np.fft.irfft(waves, self.shape[0], axis=0) * self.unit)

    def rates(self, motion: Array) -> Array:
        """Rates of a motion, by its harmonics."""
        return np.asarray(
            np.fft.irfft(1j * self.nu[:, None, None] * np.fft.rfft(motion, axis=0), self.shape[0], axis=0)
        )

    def loads(self, motion: Array) -> tuple[Array, bool]:
        """Loads of the pads, N, 0 or more: a film pushes and does not pull; and whether a table was left."""
        pushed, outside = self._forces(motion, self.rates(motion))
        return np.maximum(self.state.share.loads + (pushed - self.held)[..., 0], 0.0), outside

    def _nonlinear_part(self, motion: Array) -> Array:
        """What the linear film leaves of forces and moments, N and N m."""
        rate = self.rates(motion)
        change = self._forces(motion, rate)[0] - self.held
        change[..., 0] = np.maximum(change[..., 0], -self.state.share.loads)
        linear = np.einsum("zij,nzj->nzi", self.stiffness, motion) + np.einsum("zij,nzj->nzi", self.damping, rate)
        return np.asarray(change + linear)

    def linear(self, amplitude: float) -> Array:
        """The linear answer to the excitations times a factor."""
        return self._answer(amplitude, np.zeros((self.nu.size, *self.shape[1:]), dtype=complex))

    def missed(self, motion: Array, amplitude: float) -> Array:
        """A motion less the answer of the line to the forces that it causes."""
        return motion - self._answer(amplitude, np.fft.rfft(self._nonlinear_part(motion), axis=0))

    def _answer(self, amplitude: float, rest: ComplexArray) -> Array:
        moved = self.line.motions(amplitude * self.thrust, amplitude * self.runout, rest)
        return np.asarray(np.fft.irfft(moved, self.shape[0], axis=0))
