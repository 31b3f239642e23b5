"""Kernel: one pass of Reynolds equation, flows and energy equation, in one call from Python."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import bool_, float64, int64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import compiled, inlined, inner, spliced
from babbitt.reynolds.heat._heat_cells import sweep_energy
from babbitt.reynolds.heat._heat_flows import gather_flows, spread_viscosity
from babbitt.reynolds.heat._heat_walls import MOST_RISE, fill_film, update_wall_temperatures
from babbitt.reynolds.surface._surface_forces import carry_streamers, drain_edge, evaluate_surface

Array = NDArray[float64]


class Drains(NamedTuple):
    """Sides that run partly filled where little oil arrives (``drain_edge``)."""

    edges: NDArray[int64]  # nodes of the sides at cavitation pressure
    fed: NDArray[bool_]  # lines of grooves


class Pace(NamedTuple):
    """How far a pass goes."""

    rounds: int  # in which the wet set may settle, at most
    flickering: bool  # whether a few nodes that still change sides are let be
    sweeps: int  # of the energy equation
    relaxation: float  # share of (the logarithm of) the new viscosity that is taken
    rise: float  # temperature per unit of dissipation over flow, K
    stirred: float  # see ``fill_cells``
    walls: float  # share of the way of the walls to their new temperatures


class Warmth(NamedTuple):
    """Temperatures on their way, (lines, columns, layers) but for the supplies."""

    viscosity: Array  # of the last pass
    temperature: Array  # K
    groove: Array  # mixing temperature of every supply, K
    rises: Array  # change of the temperature in the last pass, K


class Answers(NamedTuple):
    """What the film answers to the journal."""

    force: Array  # (motions,)
    stiffness: Array  # (motions, motions)
    damping: Array


FEW = 0.01  # of the nodes
SMALL_GAIN = 0.05  # of the viscosity, up to which two terms of the power series do


@compiled
def gather_heat(surface, film, work, columns, flows, drains, at, rise):
    """Flows and heat of the Reynolds solution; returns what ``gather_flows`` does."""
    if not surface.conserving:
        carry_streamers(surface, film, work)
    for edge in drains.edges:
        drain_edge(surface, film, work, edge, drains.fed)
    powers = gather_flows(surface, film, work, at, columns, flows)
    for i in range(flows.heat.shape[0]):
        for c in range(flows.heat.shape[1]):
            flows.heat[i, c] *= rise
    return powers


@compiled
def warm_pass(surface, film, work, columns, flows, cells, walls, drains, pace, fresh, warmth, at, answers):
    """One pass at a journal position; ``fresh`` is the viscosity at the temperatures as they are.

    Returns the number of nodes that changed sides, the largest change of temperature (K), how far this change goes
    along with that of the last pass (``rises``, replaced), what ``gather_flows`` does, and whether the walls wait
    for new derivatives before they answer.
    """
    relax_viscosity(columns, fresh, warmth.viscosity, pace.relaxation)
    spread_viscosity(surface, columns, warmth.viscosity, flows)
    changed = settle_wet_set(surface, film, work, pace, at, answers)
    powers = gather_heat(surface, film, work, columns, flows, drains, at, pace.rise)
    before = warmth.temperature.copy()
    stale = fill_film(surface, columns, flows, pace.stirred, warmth.viscosity, cells, walls)
    sweep_energy(surface, columns, flows, cells, walls, warmth.temperature, warmth.groove, pace.sweeps, 1e-9)
    change, along = take_rise(columns, before, flows, warmth)
    if not (walls.insulated or stale):
        change = update_wall_temperatures(
            surface, columns, flows, cells, walls, warmth.temperature, warmth.groove, pace.walls, change
        )
    return changed, change, along, powers, stale


@inlined
def relax_viscosity(columns, fresh, viscosity, part):
    """Take a share of (the logarithm of) the new viscosity."""
    for i in range(fresh.shape[0]):
        for c in range(fresh.shape[1]):
            for k in range(len(columns.layers)):
                gain = fresh[i, c, k] / viscosity[i, c, k] - 1.0
                if abs(gain) < SMALL_GAIN:
                    viscosity[i, c, k] *= 1.0 + part * gain * (1.0 + 0.5 * (part - 1.0) * gain)
                else:
                    viscosity[i, c, k] *= (1.0 + gain) ** part


@inner
def copy_sides(wet, known):
    """Keep which nodes are wet in ``known``. (An assignment of whole arrays takes seconds to compile.)"""
    for i in range(wet.shape[0]):
        for j in range(wet.shape[1]):
            known[i, j] = wet[i, j]


@spliced
def settle_wet_set(surface, film, work, pace, at, answers):
    """Rounds of the wet set at the viscosity as it is; the number of nodes that still change sides."""
    changed, rate, known = 0, np.zeros(at.size), work.wet.copy()
    rough = bool(0)  # the literal False would compile the film anew
    for _ in range(pace.rounds):
        copy_sides(work.wet, known)
        changed = evaluate_surface(
            surface, film, work, at, rate, rough, answers.force, answers.stiffness, answers.damping
        )
        if changed == 0:
            break
    if pace.flickering and changed <= FEW * known.size:
        copy_sides(known, work.wet)
        changed = 0
    return changed


@spliced
def take_rise(columns, before, flows, warmth):
    """Largest change of temperature, and how far it goes along with the last one; ``MOST_RISE`` of it is taken.

    A change counts by the share of the width that oil fills: a few streamers may have any temperature, and nothing
    comes to rest sooner or later for it.
    """
    temperature, rises = warmth.temperature, warmth.rises
    most, change, along = 0.0, 0.0, 0.0
    for i in range(before.shape[0]):
        for c in range(before.shape[1]):
            for k in range(len(columns.layers)):
                rise = temperature[i, c, k] - before[i, c, k]
                most, change = max(most, abs(rise)), max(change, abs(rise) * flows.fill[i, c])
                along += rise * rises[i, c, k]
                rises[i, c, k] = rise
    if most > MOST_RISE:
        for i in range(before.shape[0]):
            for c in range(before.shape[1]):
                for k in range(len(columns.layers)):
                    temperature[i, c, k] = before[i, c, k] + rises[i, c, k] * (MOST_RISE / most)
    return change, along
