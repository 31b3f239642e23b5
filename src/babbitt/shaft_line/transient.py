"""Nonlinear motion of a line marched by a stiff solver from its linear answer, and what came of it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.notices import InputError
from babbitt.shaft_line.excitation import WITHOUT_WOBBLE, WOBBLE_LEFT_OUT
from babbitt.shaft_line.model import LineState
from babbitt.shaft_line.motion import Motion
from babbitt.thrust.film_table import film_table
from babbitt.thrust.gap import minimum_gap
from babbitt.thrust.state import CONTACT, tilt_answer

__all__ = ["Transient", "transient"]

Array = NDArray[np.float64]

SAMPLES = 360
"""Kept per revolution."""


@dataclass(frozen=True, eq=False)
class Transient:
    """The last revolution of the nonlinear motion.

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
    steady : float
        Difference of the loads at both ends of the revolution over the largest dynamic load: how far the motion
        repeats.
    """

    angles: Array
    loads: Array
    films: Array
    thinnest: Array
    static_loads: Array
    static_films: Array
    outside: bool
    steady: float

    @property
    def load_peaks(self) -> Array:
        """Largest load above the static one, N."""
        return np.asarray(self.loads.max(axis=0) - self.static_loads)

    @property
    def unload_peaks(self) -> Array:
        """Largest load below the static one, N, positive."""
        return np.asarray(self.static_loads - self.loads.min(axis=0))

    @property
    def peaks(self) -> Array:
        """Largest departure either way, N."""
        return np.maximum(self.load_peaks, self.unload_peaks)

    @property
    def film_shift(self) -> Array:
        """Mean film less the static one, m."""
        return np.asarray(self.films[:-1].mean(axis=0) - self.static_films)

    @property
    def lifted(self) -> Array:
        """Share of the revolution during which each pad carries nothing."""
        return np.asarray((self.loads[:-1] <= 0.0).mean(axis=0))

    @property
    def lifts_off(self) -> bool:
        """Whether a pad loses its load."""
        return bool(self.loads.min() <= 0.0)

    @property
    def touches(self) -> bool:
        """Whether a place of a pad comes as close as surfaces are rough."""
        return bool(self.thinnest.min() <= CONTACT)


def transient(state: LineState, amplitude: float = 1.0, revolutions: int = 2) -> Transient:
    """March the line from its linear answer until the motion repeats.

    Pads are massless here; their inertia counts far above the excitations only.

    Parameters
    ----------
    state : LineState
        Of plane pads.
    amplitude : float
        Factor on all excitations.
    revolutions : int
        Of which the last is kept.

    Raises
    ------
    InputError
        E101 for a collar face that leans over pads with a held tilt; E201 for pads whose films are not similar.
    """
    from scipy.integrate import solve_ivp

    _require_followed(state)
    shaken = replace(state, duty=state.duty.with_runout(amplitude).with_ripple(amplitude))
    motion = Motion(shaken, film_table(state.films))
    speed = state.duty.speed
    turn = 2.0 * math.pi / speed
    times = turn * (revolutions - 1 + np.arange(SAMPLES + 1) / SAMPLES)
    solved = solve_ivp(
        motion,
        (0.0, revolutions * turn),
        _linear_start(state, motion, amplitude),
        method="BDF",
        t_eval=times,
        rtol=1e-6,
        atol=_tolerances(state, motion),
        max_step=turn / 60.0,
    )
    loads, films, thinnest = [], [], []
    for time, y in zip(solved.t, solved.y.T, strict=True):
        gaps, _, load, _ = motion.pads(time, y)
        slopes = motion.split(y)[4]
        loads.append(load)
        films.append(gaps)
        thinnest.append(minimum_gap(state.duty.bearing.pad, np.column_stack([gaps, slopes])))
    array = np.array(loads)
    moved = np.abs(array - state.share.loads).max()
    return Transient(
        angles=solved.t * speed - 2.0 * math.pi * (revolutions - 1),
        loads=array,
        films=np.array(films),
        thinnest=np.array(thinnest),
        static_loads=state.share.loads,
        static_films=state.share.heights,
        outside=motion.outside,
        steady=float(np.abs(array[-1] - array[0]).max() / max(moved, 1e-300)),
    )


def _require_followed(state: LineState) -> None:
    leans = any(one.leans and one.amplitude > 0.0 for one in state.duty.runouts)
    if leans and len(state.duty.bearing.pad.free_tilts) < 2:
        raise InputError("E101", f"nonlinear motion: {WOBBLE_LEFT_OUT}. Allowed is {WITHOUT_WOBBLE}.")


def _linear_start(state: LineState, motion: Motion, amplitude: float) -> Array:
    """State at time 0 of the linear answer; along the shaft straight between its joints."""
    line, parts = state.duty.line, state.forced.parts
    n, z = motion.n, motion.z
    u, v = np.zeros(n), np.zeros(n)
    x = np.zeros(z) if motion.rigid else state.share.loads / motion.c
    slopes = np.array([(pad.slope_x, pad.slope_y) for pad in state.share.states])
    housing = np.zeros(2)
    along = (
        np.concatenate([[0.0], np.cumsum([rod.transit_time for rod in line.rods])]) if line.rods else np.zeros(1)
    )
    inner = np.linspace(0.0, along[-1], n)
    for part in parts:
        answer, nu = part.response, part.response.frequency
        wave = np.interp(inner, along, answer.shaft.real) + 1j * np.interp(inner, along, answer.shaft.imag)
        u += amplitude * wave.real
        v += amplitude * (1j * nu * wave).real
        x += amplitude * answer.pads.real
        housing += amplitude * np.array([answer.housing.real, (1j * nu * answer.housing).real])
        for i, pad in enumerate(state.share.states):
            slopes[i] += amplitude * (answer.gaps[i] * tilt_answer(pad, nu, state.duty.bearing.inertia)).real
    x = np.maximum(x, housing[0]) if not motion.rigid else x
    parts_of_state = [u, v, *([housing] if motion.seat is not None else []), x, slopes.T.ravel()]
    return np.concatenate(parts_of_state)


def _tolerances(state: LineState, motion: Motion) -> Array:
    """Absolute tolerances: a ten-millionth of the film, and of the tilts and speeds that go with it."""
    film = 1e-6 * float(state.share.heights.min()) * 0.1
    n, z = motion.n, motion.z
    seat = [film, film * state.duty.speed] if motion.seat is not None else []
    return np.concatenate(
        [
            np.full(n, film),
            np.full(n, film * state.duty.speed),
            seat,
            np.full(z, film),
            np.full(2 * z, film),
        ]
    )
