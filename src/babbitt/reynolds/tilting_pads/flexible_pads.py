"""Pads that bend with the pressure of their films, at rest and in motion, along one mode each (``bending_mode``).

At rest k_q q = int p psi dA. That is found by solving pads whose bores stay as they are, again and again with
the deflections that their pressures made; a secant for every pad tells what the next deflection changes. In
motion q is one more coordinate of a pad: its film answers in (xi, eta, q).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.reynolds.lands.axial import even_axial_mesh, even_axial_operator
from babbitt.reynolds.lands.profiles import common_profiles
from babbitt.reynolds.surface._surface_film import Surface, new_surface_film, new_surface_work
from babbitt.reynolds.surface._surface_forces import evaluate_surface
from babbitt.reynolds.surface.unwrapped_mesh import gauss_angles
from babbitt.reynolds.tilting_pads.bending_mode import BendingMode
from babbitt.reynolds.tilting_pads.kernel_pads import PadScales, turbulence_rows
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.solution import PadBend, PadState, PadStatus, TiltingPadSolution

__all__ = ["bent_bearing", "with_bending"]

Array = NDArray[np.float64]
Place = tuple[float, float]

MOST_BENDINGS = 40
SAME_BEND = 1e-9
"""Of the machined clearance: what a deflection may differ from the one that its pressure makes."""
STEEPEST, FLATTEST = -1e3, 0.5
"""Bounds of the secant: what the deflection by the pressure changes with the deflection of the bore."""
SAMPLES = 385
"""Of a mode along a pad: straight lines between them err by less than 1e-5 of the deflection."""
MOST_UPDATES = 60
"""Of the wet set of a film that is known."""
MOTIONS = 3


def with_bending(
    bearing: TiltingPadBearing, start: Place, solve: Callable[[TiltingPadBearing, Place], TiltingPadSolution]
) -> TiltingPadSolution:
    """The solution of pads that bend, by one of pads whose bores stay as they are.

    Parameters
    ----------
    bearing : TiltingPadBearing
    start : tuple of float
        Where the journal stands at first, m.
    solve : callable
        Solution of a bearing, with a place from which to search.
    """
    if not any(pad.bends for pad in bearing.pads):
        return solve(bearing, start)
    allowed = SAME_BEND * np.array([pad.clearance for pad in bearing.pads])
    bend, last_bend, last_made, films = np.zeros(len(bearing.pads)), None, None, 0
    for _ in range(MOST_BENDINGS):
        found = solve(bent_bearing(bearing, bend), start)
        films += found.films
        if not found.outcome.solved:
            return replace(found, bearing=bearing, films=films)
        made = np.array([bend_made(bearing, number, state) for number, state in enumerate(found.pads)])
        if np.all(np.abs(made - bend) <= allowed):
            return finished(bearing, found, bend, films)
        slope = np.zeros_like(bend)
        if last_bend is not None:
            moved = bend - last_bend
            np.divide(made - last_made, moved, out=slope, where=moved != 0.0)
            slope = np.clip(slope, STEEPEST, FLATTEST)
        last_bend, last_made, bend = bend, made, bend + (made - bend) / (1.0 - slope)
    return replace(found, bearing=bearing, outcome=Outcome.NOT_CONVERGED, films=films)


def bent_bearing(bearing: TiltingPadBearing, bend: Array) -> TiltingPadBearing:
    """The bearing with bores bent by deflections in m."""
    return replace(bearing, pads=tuple(
        replace(pad, profile=bent_profile(bearing, pad, float(q))) if q != 0.0 else pad
        for pad, q in zip(bearing.pads, bend, strict=True)
    ))  # fmt: skip


def angles_of(pad: TiltingPad, count: int) -> Array:
    """Equally spaced angles from the pivot, from the leading to the trailing edge, rad."""
    return np.linspace(-pad.pivot_fraction * pad.extent, (1.0 - pad.pivot_fraction) * pad.extent, count)


def bent_profile(bearing: TiltingPadBearing, pad: TiltingPad, bend: float) -> tuple[float, ...]:
    """Departure of a bent bore from its circle, m, from its smaller angle to its larger one."""
    moved = bend * BendingMode.of(pad).shape(angles_of(pad, SAMPLES))[:: int(bearing.sense)]
    return tuple(map(float, common_profiles([pad.profile, moved]).sum(axis=0)))


def bend_made(bearing: TiltingPadBearing, number: int, state: PadState) -> float:
    """Deflection that the pressure of a film makes: int p psi dA over k_q, m."""
    pad = bearing.pads[number]
    if not pad.bends or state.status is not PadStatus.LOADED:
        return 0.0
    lines = angles_of(pad, state.angles.size)
    mean = state.pressure @ even_axial_operator(state.axial_positions.size - 1).weights
    first, second = gauss_angles(lines)
    mode, step = BendingMode.of(pad), lines[1] - lines[0]
    near = 0.5 + 0.5 / math.sqrt(3.0)
    far = 1.0 - near
    along = mode.shape(first) * (near * mean[:-1] + far * mean[1:])
    along += mode.shape(second) * (far * mean[:-1] + near * mean[1:])
    width = bearing.width_of(pad)
    return float(0.5 * step * along.sum()) * bearing.radius * width / pad.bending_stiffness


def finished(bearing: TiltingPadBearing, found: TiltingPadSolution, bend: Array, films: int) -> TiltingPadSolution:
    """The solution with what the films of bent pads answer in three motions."""
    states = tuple(
        replace(state, bend=answer_in_bending(found.bearing, number, state, float(bend[number])))
        if bearing.pads[number].bends and state.status is PadStatus.LOADED else state
        for number, state in enumerate(found.pads)
    )  # fmt: skip
    return replace(found, bearing=bearing, pads=states, films=films)


def answer_in_bending(bearing: TiltingPadBearing, number: int, state: PadState, bend: float) -> PadBend:
    """Stiffness and damping of the film of a bent pad in (xi, eta, q).

    Those in xi and eta are known; the engine of films in any motions tells what q does.
    """
    pad, scales = bearing.pads[number], PadScales(bearing)
    viscosity = bearing.viscosity if pad.viscosity is None else pad.viscosity
    width = bearing.width_of(pad)
    weight = viscosity / bearing.viscosity * width / bearing.width
    surface = surface_of(bearing, number, state, scales)
    film, work = new_surface_film(surface), new_surface_work(surface)
    lead = pad.clearance - pad.assembled_clearance + state.radial
    at = np.array([lead, bearing.sense * state.tangential, 0.0]) / scales.length
    force, stiffness, damping = np.zeros(MOTIONS), np.zeros((MOTIONS, MOTIONS)), np.zeros((MOTIONS, MOTIONS))
    still = np.zeros(MOTIONS)
    work.wet[:] = state.pressure > 0.0
    for _ in range(MOST_UPDATES):
        if evaluate_surface(surface, film, work, at, still, False, force, stiffness, damping) == 0:
            break
    evaluate_surface(surface, film, work, at, still, True, force, stiffness, damping)
    side = np.array([1.0, bearing.sense, 1.0])
    unit = weight * scales.force / scales.length * np.outer(side, side)
    stiffness, damping = stiffness * unit, damping * unit / scales.rate
    stiffness[:2, :2], damping[:2, :2] = state.stiffness, state.damping
    return PadBend(bend, stiffness, damping)


def surface_of(bearing: TiltingPadBearing, number: int, state: PadState, scales: PadScales) -> Surface:
    """The film of a bent pad, on the lines and nodes of its solution, in the motions xi, eta and q."""
    pad, mesh = bearing.pads[number], even_axial_mesh(state.axial_positions.size - 1)
    lines = angles_of(pad, state.angles.size)
    mode, places = BendingMode.of(pad), gauss_angles(lines)
    shapes = [np.array([np.cos(at), np.sin(at), -mode.shape(at)]) for at in places]
    gaps = [np.full((at.size, mesh.points.size), pad.clearance / scales.length) for at in places]
    if pad.profile:
        bore = np.array(pad.profile)[:: int(bearing.sense)] / scales.length
        samples = angles_of(pad, bore.size)
        for gap, at in zip(gaps, places, strict=True):
            gap += np.interp(at, samples, bore)[:, None]
    viscosity = bearing.viscosity if pad.viscosity is None else pad.viscosity
    width = bearing.width_of(pad)
    groove = bearing.groove_pressure * bearing.viscosity / (scales.pressure * viscosity)
    held = np.zeros((lines.size, mesh.nodes.size), dtype=bool)
    held[[0, -1]] = held[:, -1] = True
    pressure = np.zeros(held.shape)
    pressure[[0, -1], :-1] = groove
    flat = np.ones_like(gaps[0])
    return Surface(
        nodes=mesh.nodes.size, points=mesh.points.size, motions=MOTIONS,
        step=np.diff(lines), shape_a=shapes[0], shape_b=shapes[1], lever=np.ones((MOTIONS, mesh.points.size)),
        gap_a=gaps[0], gap_b=gaps[1], opening_a=0.0 * flat, opening_b=0.0 * flat, viscosity=flat, drag=flat,
        turbulence=turbulence_rows(bearing, scales)[number], radius=np.ones_like(mesh.share), share=mesh.share,
        along=mesh.share, node=mesh.node_of_point, slope=mesh.slope, held=held, held_pressure=pressure,
        held_fill=np.ones(held.shape), piezo=np.zeros((3, 0)), cyclic=False, reference=0.0,
        kappa=(bearing.diameter / width) ** 2 / 12.0, speed=1.0, conserving=False,
    )  # fmt: skip
