"""How much of the static load the shaking takes: three losses, each with the peak and with the bound.

L1 over the mean static load of a pad, L2 over the pad's own, L3 what is left on the pad that is unloaded most.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.shaft_line.forced import Forced, Part, crests
from babbitt.kinds.thrust.gap import gap_samples, minimum_gap
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import face_runout_response, tilt_answer

__all__ = ["FilmCheck", "Losses", "film_check", "gap_motions", "losses_of", "moment_amplitude"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

LINEAR_UP_TO = 0.2
"""Dynamic over static film up to which the linear film holds: the error of a peak is about 5 % there."""


@dataclass(frozen=True)
class Losses:
    """Shares of static load; ``_peak`` over one revolution with the phases given, ``_bound`` for any phases.

    Attributes
    ----------
    mean_peak, mean_bound : float
        L1: largest dynamic pad force over F0/z, the one that published percentages and the 50 % limit mean.
    own_peak, own_bound : float
        L2: largest ratio of dynamic force to the pad's own static load.
    margin_peak, margin_bound : float
        L3: least of static plus dynamic load over F0/z; 0 or less means that a pad leaves the collar.
    worst_pad : int
        Pad of the largest force, from 0.
    """

    mean_peak: float
    mean_bound: float
    own_peak: float
    own_bound: float
    margin_peak: float
    margin_bound: float
    worst_pad: int


def losses_of(share: Share, forced: Forced) -> Losses:
    """Losses of a bearing under all harmonics."""
    mean, own = share.mean_load, share.loads
    bounds = forced.bounds()
    if forced.commensurate:
        peaks, lowest = forced.peaks(), -crests(-forced.force_history())
    else:
        peaks, lowest = bounds, -bounds
    bears = own > 0.0  # a face that leans away with the housing may carry nothing
    return Losses(
        mean_peak=float(peaks.max() / mean),
        mean_bound=float(bounds.max() / mean),
        own_peak=float((peaks[bears] / own[bears]).max()),
        own_bound=float((bounds[bears] / own[bears]).max()),
        margin_peak=float((own + lowest).min() / mean),
        margin_bound=float((own - bounds).min() / mean),
        worst_pad=int(peaks.argmax()),
    )


@dataclass(frozen=True, eq=False)
class FilmCheck:
    """Thinnest dynamic films.

    Attributes
    ----------
    share : Share
    forced : Forced
    thinnest_bound : ndarray, shape (z,)
        Least film of each pad for any phases, m.
    relative : ndarray, shape (z,)
        Sum of the film amplitudes at the pivot over the static film: above 0.2 the linear film is off by more
        than 5 %.
    """

    share: Share
    forced: Forced
    thinnest_bound: Array
    relative: Array

    @property
    def linear(self) -> bool:
        """Whether the linear film holds."""
        return bool(self.relative.max() <= LINEAR_UP_TO)

    @property
    def thinnest(self) -> Array:
        """Least film of each pad over a revolution, m, shape (z,); the bound where it does not repeat."""
        return self.histories.min(axis=1) if self.forced.commensurate else self.thinnest_bound

    @cached_property
    def histories(self) -> Array:
        """Thinnest film over each pad at the angles of the shaft, m; empty where harmonics do not repeat."""
        if not self.forced.commensurate:
            return np.zeros((len(self.share.states), 0))
        moving = [gap_motions(self.share, part) for part in self.forced.parts]
        return np.array(
            [
                minimum_gap(state.pad, state.motion + self.forced.history([move[pad] for move in moving]).T)
                for pad, state in enumerate(self.share.states)
            ]
        )


def film_check(share: Share, forced: Forced) -> FilmCheck:
    """Films over the edges and the face of all pads, static plus dynamic."""
    basis, face = gap_samples(share.bearing.pad)
    statics = np.array([state.motion for state in share.states]) @ basis.T + face
    moving = [gap_motions(share, part) @ basis.T for part in forced.parts]
    relative = np.asarray(sum(np.abs(part.response.gaps) for part in forced.parts)) / share.heights
    bound = statics - np.asarray(sum(np.abs(move) for move in moving))
    return FilmCheck(share, forced, bound.min(axis=1), relative)


def gap_motions(share: Share, part: Part) -> ComplexArray:
    """Complex amplitudes of height, slope_x and slope_y of every gap, m and 1, shape (z, 3)."""
    frequency, inertia = part.response.frequency, share.bearing.inertia
    rows = []
    for state, gap, under in zip(share.states, part.response.gaps, part.runout, strict=True):
        tilts = gap * tilt_answer(state, frequency, inertia)
        if part.leans:
            tilts = tilts + under * face_runout_response(state, frequency, inertia)
        rows.append([gap, *tilts])
    return np.array(rows)


def moment_amplitude(share: Share, part: Part) -> float:
    """Longest semi-axis of the ellipse that the moment of the pads on the collar runs through, N m.

    Levers as of `Share.moment`, forces and moments of the pads -(K + j nu C) g.
    """
    bearing, frequency = share.bearing, part.response.frequency
    films = np.array([state.stiffness + 1j * frequency * state.damping for state in share.states])
    force, radial, along = -np.einsum("zij,zj->iz", films, gap_motions(share, part))
    outward, onward = force * bearing.pad.pivot_radius + radial, bearing.sense * along
    cos, sin = np.cos(bearing.angles), np.sin(bearing.angles)
    first, second = complex((outward * cos - onward * sin).sum()), complex((outward * sin + onward * cos).sum())
    return math.sqrt(0.5 * (abs(first) ** 2 + abs(second) ** 2 + abs(first**2 + second**2)))


def separation(frequency: float, natural: float) -> float:
    """Relative distance of an excitation from a natural frequency."""
    return abs(frequency / natural - 1.0) if natural > 0.0 else math.inf
