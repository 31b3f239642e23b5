"""Tilted pads as lands of the film engine: a bearing of fixed lobes where they stand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.model import Cavitation, JournalFilm, Land
from babbitt.reynolds.tilting_pads.bending_mode import BendingMode
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.solution import PadPosition, TiltingPadSolution

__all__ = ["film_of", "pad_gaps", "pad_positions", "tilted_land"]

Array = NDArray[np.float64]


def tilted_land(bearing: TiltingPadBearing, pad: TiltingPad, position: PadPosition) -> Land:
    """The land that a pad makes: its bore about a centre moved by preload, pivot and tilt.

    Parameters
    ----------
    bearing : TiltingPadBearing
    pad : TiltingPad
    position : PadPosition

    Returns
    -------
    Land
        ``clearance`` c_p and ``centre`` (u - (c_p - c_b)) n + (v - s) tau, so that the gap of a journal at (x,
        y) is c_p - (x - x_c) cos(theta) - (y - y_c) sin(theta).
    """
    outward = position.pivot_displacement - (pad.clearance - pad.assembled_clearance)
    along = position.tangential_displacement - bearing.lever(pad) * position.tilt
    centre = outward * pad.normal() + along * pad.tangent()
    start, end = bearing.edges(pad)
    return Land(
        start, end, pad.clearance, (float(centre[0]), float(centre[1])), bearing.groove_pressure,
        bearing.groove_pressure, pad.profile,
    )  # fmt: skip


def film_of(
    bearing: TiltingPadBearing, positions: tuple[PadPosition, ...], cavitation: Cavitation = Cavitation.REYNOLDS
) -> JournalFilm:
    """The film between a journal and pads that stand where they are (a bearing of fixed lobes).

    Raises
    ------
    InputError
        E101 if pads differ in width or viscosity, which one film has not.
    """
    if any(pad.width not in (None, bearing.width) for pad in bearing.pads):
        raise InputError("E101", "pads of different widths have no common film; give all pads one width.")
    if any(pad.viscosity not in (None, bearing.viscosity) for pad in bearing.pads):
        raise InputError("E101", "pads of different viscosities have no common film; give all pads one viscosity.")
    return JournalFilm(
        bearing.diameter, bearing.width, bearing.assembled_clearance, bearing.viscosity, bearing.angular_speed,
        tuple(tilted_land(bearing, pad, at) for pad, at in zip(bearing.pads, positions, strict=True)), cavitation,
        turbulence=bearing.turbulence,
    )  # fmt: skip


def pad_positions(solution: TiltingPadSolution) -> tuple[PadPosition, ...]:
    """Where the pads of a solution stand; unloaded ones concentric with their bores (eta = 0)."""
    places = []
    for pad, state in zip(solution.bearing.pads, solution.pads, strict=True):
        at = state.position
        if math.isnan(at.tilt):
            along = float(solution.position @ pad.tangent())
            at = replace(at, tilt=-along / solution.bearing.lever(pad))
        places.append(at)
    return tuple(places)


def pad_gaps(solution: TiltingPadSolution) -> Array:
    """Gap of every pad at the lines of its film, m, shape (pads, n + 1)."""
    bearing, gaps = solution.bearing, []
    for pad, state, position in zip(bearing.pads, solution.pads, pad_positions(solution), strict=True):
        land = tilted_land(bearing, pad, position)
        x, y = solution.position - np.asarray(land.centre)
        gap = pad.clearance - x * np.cos(state.angles) - y * np.sin(state.angles)
        if pad.profile:
            place = (state.angles - land.start_angle) / pad.extent
            gap += np.interp(place, np.linspace(0.0, 1.0, len(pad.profile)), pad.profile)
        if state.bend is not None:
            gap += state.bend.deflection * BendingMode.of(pad).shape(
                bearing.sense * (state.angles - pad.pivot_angle)
            )
        gaps.append(gap)
    return np.array(gaps)
