"""Kernels: wet set, forces with stiffness and damping, and supply flows of a surface (see ``_surface``)."""

from __future__ import annotations

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds.lands._forces import TIE, shortening
from babbitt.reynolds.surface._surface import solve_surface
from babbitt.reynolds.surface._surface_film import surface_coefficients, true_pressure


@compiled
def evaluate_surface(surface, film, work, at, rate, smooth, force, stiffness, damping):
    """Fill force (d,), stiffness and damping (d, d); returns how many nodes changed between wet and dry.

    With ``smooth`` the adjoints are solved once more and end at the rupture, as in ``_equilibrium.evaluate``.
    """
    surface_coefficients(surface, at, rate, film)
    for again in range(2 if smooth else 1):
        if again == 1:
            end_adjoints_at_rupture(surface, film, work)
        solve_surface(surface, film, work)
        for i in range(work.pressure.shape[0]):
            for j in range(surface.nodes):
                if again == 0:
                    work.pressure[i, j] = work.solution[0, i, j]
                    work.stiffening[i, j] = 1.0
                    if work.holds[i, j] and surface.piezo.shape[1] > 0:
                        work.stiffening[i, j] = true_pressure(surface, work.pressure[i, j])[1]
                else:
                    work.solution[0, i, j] = work.pressure[i, j]
    work.ending[:] = 0.0
    balance_rows(surface, film, work)
    reduce_surface(surface, film, work, force, stiffness, damping)
    return update_surface(surface, film, work)


@inner
def balance_rows(surface, film, work):
    """Split the solution into pressure and liquid fraction and balance every node; a held node's row is supply."""
    lines, nodes = surface.held.shape[0], surface.nodes
    for i in range(lines):
        for j in range(nodes):
            value = work.solution[0, i, j]
            work.pressure[i, j], work.fill[i, j] = value, surface.held_fill[i, j]
            if not work.holds[i, j]:
                work.pressure[i, j] = 0.0
                if surface.conserving:
                    work.fill[i, j] = 1.0 - value
            work.row[i, j] = film.squeeze[i, j] * work.fill[i, j]
        flow_across(surface, film, work, i)
    for i in range(surface.step.size):
        after = (i + 1) % lines
        for j in range(nodes):
            flux = film.couette[i, j] * work.fill[i, j]
            flux += film.conductance[i, j] * (work.pressure[i, j] - work.pressure[after, j])
            if surface.conserving and surface.held[i, j] and not work.holds[after, j]:
                flux = film.inlet[i, j] * work.fill[i, j]
            work.row[i, j] += flux
            work.row[after, j] -= flux


@inlined
def flow_across(surface, film, work, i):
    """Add what a line sends across the width to the balance of its nodes."""
    nodes = surface.nodes
    for q in range(surface.points):
        gradient = 0.0
        for b in range(nodes):
            gradient += surface.slope[q, b] * work.pressure[i, b]
        if gradient != 0.0:
            gradient *= surface.kappa * surface.share[q] * film.cubed[i, q]
            for b in range(nodes):
                work.row[i, b] += gradient * surface.slope[q, b]


@inner
def update_surface(surface, film, work):
    """Semismooth Newton step on the wet set; returns the number of changes."""
    lines, nodes = surface.held.shape[0], surface.nodes
    changed = 0
    for i in range(lines):
        for j in range(nodes):
            if surface.held[i, j]:
                continue
            value = work.solution[0, i, j] if work.wet[i, j] or surface.conserving else work.row[i, j]
            if value < -TIE:
                work.wet[i, j] = not work.wet[i, j]
                changed += 1
    return changed


@inner
def end_adjoints_at_rupture(surface, film, work):
    """Conductance from the last wet line to the rupture itself, see ``_endings``."""
    lines, nodes = surface.held.shape[0], surface.nodes
    n = surface.step.size
    for i in range(lines):
        for j in range(nodes):
            if surface.held[i, j] or not work.wet[i, j]:
                continue
            after, before = (i + 1) % lines, (i - 1) % lines
            pressure = work.solution[0, i, j]
            if not work.holds[after, j]:
                surplus = film.couette[after % n, j] - film.couette[i, j] + film.squeeze[after, j]
                surplus /= film.conductance[i, j]
                work.ending[i, j] += film.conductance[i, j] * shortening(pressure, surplus)
            if not work.holds[before, j] and not surface.conserving:
                first = film.couette[(before - 1) % n, j]
                surplus = film.couette[before, j] - first + film.squeeze[before, j]
                surplus /= film.conductance[before, j]
                work.ending[i, j] += film.conductance[before, j] * shortening(pressure, surplus)


@inner
def reduce_surface(surface, film, work, force, stiffness, damping):  # noqa: C901 - one pass over lines and points
    """Forces from the reference pressure; stiffness and damping from the adjoints (``_forces.add_forces``)."""
    lines, nodes = surface.held.shape[0], surface.nodes
    n, points, motions = surface.step.size, surface.points, surface.motions
    adjoint, pressure, fill = work.solution, work.pressure, work.fill
    excess, drop, rise = np.empty((lines, nodes)), np.empty((n, nodes)), np.empty((motions, n, nodes))
    slope = np.empty((1 + motions, lines, points))
    for i in range(lines):
        for j in range(nodes):
            excess[i, j] = pressure[i, j] - surface.reference
            if surface.piezo.shape[1] > 0:
                excess[i, j] = true_pressure(surface, pressure[i, j])[0] - surface.reference
            if not work.counts[i, j]:  # the row of a held node is no balance: its adjoint does not count
                for d in range(motions):
                    adjoint[1 + d, i, j] = 0.0
        for q in range(points):
            for d in range(1 + motions):
                total = 0.0
                for b in range(nodes):
                    total += surface.slope[q, b] * (pressure[i, b] if d == 0 else adjoint[d, i, b])
                slope[d, i, q] = total
            slope[0, i, q] *= surface.kappa * surface.share[q]
    for i in range(n):
        after = i + 1 if i + 1 < lines else 0
        for j in range(nodes):
            drop[i, j] = pressure[i, j] - pressure[after, j]
            for d in range(motions):
                rise[d, i, j] = adjoint[1 + d, i, j] - adjoint[1 + d, after, j]
    for d in range(motions):
        total = 0.0
        for i in range(lines):
            for j in range(nodes):
                total -= film.load[d, i, j] * excess[i, j]
        force[d] = total
        for e in range(motions):
            stiff, damp = 0.0, 0.0
            for i in range(n):
                for j in range(nodes):
                    flux = fill[i, j] * film.couette_d[e, i, j] + drop[i, j] * film.conductance_d[e, i, j]
                    stiff += rise[d, i, j] * flux
            for i in range(lines):
                for j in range(nodes):
                    damp -= adjoint[1 + d, i, j] * fill[i, j] * film.load[e, i, j]
                for q in range(points):
                    stiff += slope[0, i, q] * slope[1 + d, i, q] * film.cubed_d[e, i, q]
            stiffness[d, e], damping[d, e] = stiff, damp
    if surface.conserving:
        burst_behind_held(surface, film, work, drop, rise, stiffness)


@inlined
def burst_behind_held(surface, film, work, drop, rise, stiffness):
    """Where a line ruptures right behind a held node, what enters it takes the place of the flux in the sums."""
    lines = surface.held.shape[0]
    for i in range(surface.step.size):
        after = i + 1 if i + 1 < lines else 0
        for j in range(surface.nodes):
            if surface.held[i, j] and not work.holds[after, j]:
                for e in range(surface.motions):
                    more = work.fill[i, j] * (film.inlet_d[e, i, j] - film.couette_d[e, i, j])
                    more -= drop[i, j] * film.conductance_d[e, i, j]
                    for d in range(surface.motions):
                        stiffness[d, e] += rise[d, i, j] * more


@compiled
def carry_streamers(surface, film, work):
    """Liquid fraction behind a Reynolds rupture by continuity: flows and friction count only the oil there."""
    lines, nodes = surface.held.shape[0], surface.nodes
    n = surface.step.size
    for j in range(nodes):
        flux = -1.0  # unknown until the column has passed a film
        for _ in range(2 if surface.cyclic else 1):
            for i in range(n):
                after = (i + 1) % lines
                old = work.fill[i, j]
                if not work.holds[i, j]:
                    new = old if flux < 0.0 else min(1.0, flux / film.couette[i, j])
                    work.fill[i, j] = new
                    work.row[i, j] += (new - old) * film.couette[i, j]
                    work.row[after, j] -= (new - old) * film.couette[i, j]
                flux = film.couette[i, j] * work.fill[i, j]
                flux += film.conductance[i, j] * (work.pressure[i, j] - work.pressure[after, j])
                flux = max(flux, 0.0)


@compiled
def drain_edge(surface, film, work, edge, fed):
    """Let a side at cavitation pressure run partly filled where less oil arrives than its gap could carry.

    Nodes of a side are held, which would draw in oil from outside (as ``_integrals.edge_column``). ``fed`` marks
    the lines of grooves; a closed ring starts over with what its first round ended with. Twice changes nothing
    more.
    """
    lines, n = surface.held.shape[0], surface.step.size
    full, flux = np.empty(n), np.empty(n)
    for i in range(n):
        full[i] = flux[i] = film.couette[i, edge] * work.fill[i, edge]
    for turn in range(2 if surface.cyclic else 1):
        for i in range(1 if turn == 0 else 0, n):
            if not fed[i]:
                arriving = full[i] - work.row[i, edge] + flux[i - 1] - full[i - 1]
                flux[i] = min(full[i], max(arriving, 0.0))
    for i in range(n):
        if not fed[i] and film.couette[i, edge] > 0.0:
            work.fill[i, edge] = flux[i] / film.couette[i, edge]
        work.row[i, edge] += flux[i] - full[i]
        work.row[(i + 1) % lines, edge] -= flux[i] - full[i]
