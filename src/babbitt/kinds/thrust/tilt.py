"""Pads whose faces are held at a slope: every pad has a film of its own, and they settle with the share.

Under a slope that is held no table and no similarity serves all pads. Each is solved at its height; about it the
load follows W (h/h_i)^-n, n = k h_i/W from the stiffness of the film, exact for its value and slope. The share on
these laws gives the next heights: Newton's method, which lands at once where W falls with a power of the film.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.failures import (
    ThermalRunawayError,
    TiltedPadError,
    TiltedPadsTouchError,
    UnsettledPadError,
)
from babbitt.kinds.thrust.gap import minimum_gap
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.pad_attitude import PadAttitude, PadTilt
from babbitt.kinds.thrust.state import PadState, condensed

__all__ = ["PowerLaws", "settled", "states_at"]

Array = NDArray[np.float64]

MOST_ROUNDS = 60
SETTLED = 1e-6
"""Change of a height, over it, that ends the search: loads are then known to a few millionths."""
KEPT = 0.3
"""Share of its thinnest film that a pad keeps in a step."""
ROOM = 5e-6
"""Thinnest film, m, that every pad has at the begin of the search."""
GONE = 1e-8
"""Thinnest film, m, below which surfaces touch and the load has no film."""
TOUCHING = 0.1
"""Thinnest film over that at the pivot of a pad which finds no balance any nearer, as its edge touches first."""
BENT = 1e-5
"""Change of the logarithm of a height from which the load itself tells its power."""
IDLE = 1e-9
"""Of all loads: a face that diverges throughout carries nothing, and is taken to carry so much."""
SIMILAR = 2.0
"""Power of the film that the load of similar films falls with."""
POWERS = (0.1, 20.0)
"""Powers of the film that a load falls with, at least and at most."""


@dataclass(frozen=True, eq=False)
class PowerLaws:
    """Loads W_i (h/h_i)^-n_i of pads.

    Attributes
    ----------
    heights, loads, powers : ndarray, shape (z,)
        h_i m, W_i N, n_i.
    """

    heights: Array
    loads: Array
    powers: Array

    def load(self, height: Array) -> Array:
        """N."""
        return np.asarray(self.loads * (height / self.heights) ** -self.powers)

    def slope(self, height: Array) -> Array:
        """N/m."""
        return np.asarray(-self.powers * self.load(height) / height)


def settled(
    films: LoadCurve, standing: PadAttitude, first: Array, place: Callable[[PowerLaws], Array]
) -> tuple[Array, tuple[PadState, ...]]:
    """Heights of pads that lean, and their films.

    Parameters
    ----------
    films : LoadCurve
    standing : PadAttitude
    first : ndarray, shape (z,)
        Heights at the pivots from which the search begins, m, such as those of level pads.
    place : callable
        Gives the heights at which pads of given laws share the thrust.

    Raises
    ------
    TiltedPadsTouchError
        If faces touch the collar before the pads carry the thrust.
    TiltedPadError
        If a pad does not balance, or the heights do not converge.
    """
    touching = nearest = _nearest(films.pad, standing)
    heights = np.maximum(first, nearest + np.maximum(KEPT * first, ROOM))
    laws: PowerLaws | None = None
    states: tuple[PadState, ...] = ()
    for _ in range(MOST_ROUNDS):
        try:
            states = states_at(films, heights, standing, states)
        except TiltedPadError as failure:
            if failure.pad is None:
                raise
            pad = failure.pad - 1
            alike = (standing.leans == standing.leans[pad]).all(axis=1)
            known = heights if laws is None else laws.heights
            above = np.where(known > heights, known, heights + 2.0 * (heights - touching))
            # here an edge touches before the moments balance, so that no film is sought at this height or below
            nearest, heights = (
                np.where(alike, np.maximum(nearest, heights), nearest),
                np.where(alike, 0.5 * (heights + above), heights),
            )
            continue
        laws = _laws(heights, states, laws)
        wanted = place(laws)
        new = np.maximum(wanted, nearest + KEPT * (heights - nearest))
        moved = float(np.abs(new / heights - 1.0).max())
        if moved < SETTLED:
            return heights, states
        if float((new - nearest).min()) < GONE:
            pad = int((new - nearest).argmin())
            if states[pad].minimum_film_thickness > TOUCHING * heights[pad]:
                raise TiltedPadError(1 + pad, float(nearest[pad]))
            raise TiltedPadsTouchError(1 + pad, float(laws.loads.sum()))
        heights = new
    raise TiltedPadError


def states_at(
    films: LoadCurve, heights: Array, standing: PadAttitude, near: tuple[PadState, ...] = ()
) -> tuple[PadState, ...]:
    """Films at the heights; pads that stand and lean alike share one.

    Parameters
    ----------
    films : LoadCurve
    heights : ndarray, shape (z,)
        m.
    standing : PadAttitude
    near : tuple of PadState
        Films of the pads near these heights with the same leans, from which to start; empty for none.

    Raises
    ------
    TiltedPadError
        If a pad that leans does not balance.
    """
    found: dict[tuple[float, PadTilt], PadState] = {}
    states = []
    for place, height in enumerate(heights):
        lean = standing.lean(place)
        key = (float(f"{height:.12e}"), lean)
        if key not in found:
            try:
                found[key] = films.state(float(height), lean, near[place] if near else None)
            except (InputError, ThermalRunawayError, UnsettledPadError):
                # no balance, a place between the samples touches, or a thin film runs too hot
                if not any(lean):
                    raise
                raise TiltedPadError(1 + place) from None
        states.append(found[key])
    return tuple(states)


def _nearest(pad: ThrustPad, standing: PadAttitude) -> Array:
    """Heights at which the faces touch the collar, free tilts at zero, m, shape (z,)."""
    return -minimum_gap(pad, np.column_stack([np.zeros(len(standing.leans)), standing.leans]))


def _laws(heights: Array, states: tuple[PadState, ...], before: PowerLaws | None) -> PowerLaws:
    """Laws about the films.

    The stiffness of a film with its own temperatures is that at frozen ones; there two films tell the power.
    """
    loads = np.array([state.load for state in states])
    idle = loads <= IDLE * loads.sum()
    loads = np.where(idle, IDLE * max(float(loads.sum()), 1e-300), loads)
    stiffness = np.array(
        [0.0 if rests else condensed(state, 0.0).real for state, rests in zip(states, idle, strict=True)]
    )
    powers = np.where(idle, SIMILAR, stiffness * heights / loads)
    if before is not None:
        warm = np.array([state.heat is not None for state in states])
        bent = np.log(heights / before.heights)
        slopes = -np.log(loads / before.loads) / np.where(np.abs(bent) > BENT, bent, 1.0)
        powers = np.where(warm, np.where(np.abs(bent) > BENT, slopes, before.powers), powers)
    return PowerLaws(heights, loads, np.clip(powers, *POWERS))
