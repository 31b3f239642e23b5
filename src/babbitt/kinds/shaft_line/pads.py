"""What the line feels of its pads: a complex stiffness each, from films or as given."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.sharing import Share
from babbitt.kinds.thrust.state import condensed, face_runout_response

__all__ = ["DynamicPads", "FilmPads", "PrescribedPads"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]


class DynamicPads(Protocol):
    """Pads that answer to the collar."""

    @property
    def phases(self) -> Array:
        """Angles by which the collar passes each pad, rad, shape (z,)."""

    @property
    def ring_stiffness(self) -> float:
        """c of the support under each pad, N/m; infinite for a rigid ring."""

    @property
    def pad_mass(self) -> float:
        """kg."""

    @property
    def static_stiffness(self) -> Array:
        """Stiffness at frequency zero, N/m: 2 W/h of plane pads."""

    def film(self, frequency: float) -> ComplexArray:
        """k + j nu d of each pad, N/m."""

    def wobble(self, frequency: float) -> ComplexArray:
        """What the tilt of a face with one high spot adds to the runout that each pad feels, over it."""

    def films(self, frequencies: Array) -> ComplexArray:
        """`film` at many frequencies, shape (n, z)."""

    def wobbles(self, frequencies: Array) -> ComplexArray:
        """`wobble` at many frequencies, shape (n, z)."""


@dataclass(frozen=True)
class PrescribedPads:
    """Pads with stiffness (N/m) and damping (N s/m) given, the same at every frequency.

    Attributes
    ----------
    stiffness, damping : tuple of float
        One per pad.
    ring_stiffness : float
    pad_mass : float
    sense : float
        1: the collar passes the pads in their order.
    """

    stiffness: tuple[float, ...]
    damping: tuple[float, ...]
    ring_stiffness: float = math.inf
    pad_mass: float = 0.0
    sense: float = 1.0

    def __post_init__(self) -> None:
        if len(self.stiffness) != len(self.damping):
            raise InputError(
                "E203",
                f"{len(self.stiffness)} pad stiffnesses and {len(self.damping)} dampings are "
                "given; allowed: one of each per pad.",
            )
        if len(self.stiffness) < 2:
            raise InputError("E203", f"{len(self.stiffness)} pads are given; allowed: 2 or more.")
        for place, value in enumerate(self.stiffness, start=1):
            if not (math.isfinite(value) and value > 0.0):
                raise InputError("E203", f"stiffness of pad {place} is {value:g} N/m; it must be positive.")
        for place, value in enumerate(self.damping, start=1):
            if not (math.isfinite(value) and value >= 0.0):
                raise InputError("E203", f"damping of pad {place} is {value:g} N s/m; it must be 0 or more.")
        if not self.ring_stiffness > 0.0:
            raise InputError("E203", f"stiffness of the ring is {self.ring_stiffness:g} N/m; it must be positive.")

    @property
    def phases(self) -> Array:
        """Evenly spaced."""
        z = len(self.stiffness)
        return self.sense * 2.0 * math.pi * np.arange(z) / z

    @property
    def static_stiffness(self) -> Array:
        """As given."""
        return np.array(self.stiffness)

    def film(self, frequency: float) -> ComplexArray:
        """k + j nu d."""
        return np.array(self.stiffness) + 1j * frequency * np.array(self.damping)

    def wobble(self, frequency: float) -> ComplexArray:
        """Nothing: such pads feel the runout at their pivots only."""
        return np.zeros(len(self.stiffness), dtype=complex)

    def films(self, frequencies: Array) -> ComplexArray:
        """`film` at many frequencies."""
        return np.asarray(np.array(self.stiffness) + 1j * np.outer(frequencies, self.damping), dtype=np.complex128)

    def wobbles(self, frequencies: Array) -> ComplexArray:
        """`wobble` at many frequencies."""
        return np.zeros((len(frequencies), len(self.stiffness)), dtype=complex)


@dataclass(frozen=True, eq=False)
class FilmPads:
    """Pads on their static films.

    Attributes
    ----------
    share : Share
    """

    share: Share

    @property
    def bearing(self) -> ThrustBearing:
        """The bearing."""
        return self.share.bearing

    @property
    def phases(self) -> Array:
        """Of the bearing."""
        return self.bearing.phases()

    @property
    def ring_stiffness(self) -> float:
        """Of the bearing."""
        return self.bearing.ring_stiffness

    @property
    def pad_mass(self) -> float:
        """Of the bearing."""
        return self.bearing.pad_mass

    @cached_property
    def static_stiffness(self) -> Array:
        """Condensed at frequency zero."""
        return np.array([condensed(state, 0.0).real for state in self.share.states])

    def film(self, frequency: float) -> ComplexArray:
        """Condensed with the tilts free (R3)."""
        return np.array([condensed(state, frequency, self.bearing.inertia) for state in self.share.states])

    def wobble(self, frequency: float) -> ComplexArray:
        """-(K + j nu C)_1t g / (k + j nu d), see `face_runout_response`."""
        inertia = self.bearing.inertia
        added = np.zeros(self.bearing.number, dtype=complex)
        for place, (state, film) in enumerate(zip(self.share.states, self.film(frequency), strict=True)):
            if film != 0.0:  # a face that leans away with the housing may carry nothing
                row = (state.stiffness + 1j * frequency * state.damping)[0, 1:]
                added[place] = -row @ face_runout_response(state, frequency, inertia) / film
        return added

    def films(self, frequencies: Array) -> ComplexArray:
        """`film` at many frequencies."""
        film, moving, free = self.moving(frequencies)
        found = film[..., 0, 0]
        if free:
            tilts = np.linalg.solve(moving, -film[..., free, 0][..., None])[..., 0]
            found = found + (film[..., 0, free] * tilts).sum(axis=-1)
        return np.asarray(found)

    def wobbles(self, frequencies: Array) -> ComplexArray:
        """`wobble` at many frequencies."""
        film, moving, free = self.moving(frequencies)
        driven = np.array([-1.0, 1.0j]) / self.bearing.pad.pivot_radius
        answer = np.broadcast_to(driven, (*film.shape[:2], 2)).copy()
        if free:
            felt = film[..., free, 1:] @ driven
            places = [tilt - 1 for tilt in free]
            answer[..., places] = answer[..., places] - np.linalg.solve(moving, felt[..., None])[..., 0]
        added = -(film[..., 0, 1:] * answer).sum(axis=-1)
        whole = self.films(frequencies)
        return np.asarray(np.where(whole == 0.0, 0.0, added / np.where(whole == 0.0, 1.0, whole)))

    def moving(self, frequencies: Array) -> tuple[ComplexArray, ComplexArray, list[int]]:
        """K + j nu C, shape (n, z, 3, 3), its free tilts with their inertia, and which those are."""
        nu = np.asarray(frequencies)[:, None, None, None]
        states, inertia = self.share.states, self.bearing.inertia
        film = np.array([one.stiffness for one in states]) + 1j * nu * np.array([one.damping for one in states])
        free = list(self.bearing.pad.free_tilts)
        moving = (film - nu**2 * np.diag([0.0, inertia.radial, inertia.along]))[..., free, :][..., free]
        lost = ~film.any(axis=(0, 2, 3))  # pads without a film carry nothing as they tilt
        moving[:, lost] = np.eye(len(free))
        return film, moving, free
