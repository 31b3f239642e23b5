"""What a pad carries over the thickness of its film: plane pads by similarity, others by a table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.thrust.equilibrium import leaning_state, pad_state
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.pad_attitude import PARALLEL, PadTilt
from babbitt.kinds.thrust.state import PadState
from babbitt.kinds.thrust.tabulated import TabulatedFilms, require_load, tabulated

__all__ = ["LoadCurve", "SimilarFilms", "carrying"]

Array = NDArray[np.float64]

REFERENCE_SHARE = 1e-4
"""Film at which a plane pad is solved, over its mean radius; by similarity any would do."""


class LoadCurve(Protocol):
    """Load of a pad over its film, and the film at any thickness."""

    def __hash__(self) -> int:
        """By identity: what is found of films is kept with them."""

    @property
    def pad(self) -> ThrustPad:
        """The pad."""

    @property
    def viscosity(self) -> float:
        """Pa s."""

    @property
    def angular_speed(self) -> float:
        """Of the runner, rad/s."""

    def load(self, height: Array) -> Array:
        """Loads, N, at heights of the pivot, m."""

    def slope(self, height: Array) -> Array:
        """Their derivative, N/m, negative."""

    def height_for(self, load: float) -> float:
        """Height of the pivot, m, at which the pad carries a load, N."""

    def state(self, height: float, lean: PadTilt = PARALLEL, near: PadState | None = None) -> PadState:
        """The whole film at a height, with the slopes that the pivot holds; ``near``: one to start from."""

    def at(self, viscosity: float, angular_speed: float) -> LoadCurve:
        """The same pad in another oil and at another speed."""


@dataclass(frozen=True, eq=False)
class SimilarFilms:
    """Films of a plane pad: one solution serves all, W = A/h^2."""

    pad: ThrustPad
    reference: PadState

    @property
    def viscosity(self) -> float:
        """Pa s."""
        return self.reference.viscosity

    @property
    def angular_speed(self) -> float:
        """Of the runner, rad/s."""
        return self.reference.angular_speed

    @property
    def constant(self) -> float:
        """A = W h^2 in N m2."""
        return self.reference.load * self.reference.height**2

    def load(self, height: Array) -> Array:
        """A/h^2."""
        return self.constant / height**2

    def slope(self, height: Array) -> Array:
        """-2 A/h^3."""
        return -2.0 * self.constant / height**3

    def height_for(self, load: float) -> float:
        """sqrt(A/W)."""
        return float(np.sqrt(self.constant / load))

    def state(self, height: float, lean: PadTilt = PARALLEL, near: PadState | None = None) -> PadState:
        """The similar film; one that leans is solved."""
        similar = self.reference.similar(height, self.viscosity, self.angular_speed)
        if not any(lean):
            return similar
        along = similar.slope_y if near is None else near.slope_y
        return leaning_state(self.pad, height, self.viscosity, self.angular_speed, along, lean)

    def at(self, viscosity: float, angular_speed: float) -> SimilarFilms:
        """The similar film in another oil."""
        return SimilarFilms(self.pad, self.reference.similar(self.reference.height, viscosity, angular_speed))


def carrying(pad: ThrustPad, viscosity: float, angular_speed: float) -> SimilarFilms | TabulatedFilms:
    """What a pad carries.

    Parameters
    ----------
    pad : ThrustPad
    viscosity, angular_speed : float
        Pa s and rad/s, positive.

    Raises
    ------
    InputError
        E202 if no tilt balances the pad, or it carries nothing.
    """
    if pad.is_plane:
        height = REFERENCE_SHARE * pad.pivot_radius
        reference = pad_state(pad, height, viscosity, angular_speed)
        require_load(pad, reference.load, height)
        return SimilarFilms(pad, reference)
    return tabulated(pad, viscosity, angular_speed)
