"""Kernels: wet set, forces with stiffness and damping, and supply flows of a surface (see ``_surface``)."""

from __future__ import annotations

import numpy as np

from babbitt.film._forces import TIE, shortening
from babbitt.film._structs import compiled
from babbitt.film._surface import (
    entering_flux,
    holds_pressure,
    row_counts,
    solve_surface,
    surface_coefficients,
)


@compiled
def evaluate_surface(surface, film, work, at, rate, smooth, force, stiffness, damping):
    """Fill force (d,), stiffness and damping (d, d); returns how many nodes changed between wet and dry.

    With ``smooth`` the adjoints are solved once more and end at the rupture, as in ``_equilibrium.evaluate``.
    """
    surface_coefficients(surface, at, rate, film)
    solve_surface(surface, film, work)
    if smooth:
        pressure = work.solution[0].copy()
        end_adjoints_at_rupture(surface, film, work)
        solve_surface(surface, film, work)
        work.solution[0] = pressure
        work.ending[:] = 0.0
    reduce_surface(surface, film, work, force, stiffness, damping)
    return update_surface(surface, film, work)


@compiled
def pressure_of(surface, work, i, j):
    """Pressure of a node."""
    return work.solution[0, i, j] if holds_pressure(surface, work, i, j) else 0.0


@compiled
def fill_of(surface, work, i, j):
    """Liquid fraction at a node of a mass-conserving film."""
    return 1.0 if holds_pressure(surface, work, i, j) or not surface.conserving else 1.0 - work.solution[0, i, j]


@compiled
def balance(surface, film, work, i, j):
    """Row of a node: what flows off it less what arrives. For a held node, the flow of its supply."""
    nodes, n = surface.held.shape[1], surface.step.size
    total = film.squeeze[i, j] * fill_of(surface, work, i, j)
    if surface.cyclic or i < n:
        total += interval_flux(surface, film, work, i, j)
    if surface.cyclic or i > 0:
        total -= interval_flux(surface, film, work, (i - 1) % n, j)
    for q in range(surface.zeta.size):
        if surface.slope[q, j] != 0.0:
            gradient = 0.0
            for b in range(nodes):
                gradient += surface.slope[q, b] * pressure_of(surface, work, i, b)
            total += surface.kappa * surface.share[q] * film.cubed[i, q] * surface.slope[q, j] * gradient
    return total


@compiled
def interval_flux(surface, film, work, i, j):
    """Flux along the column of node j in interval i, weighted with the share of the node."""
    after = (i + 1) % surface.held.shape[0]
    if surface.conserving and surface.held[i, j] and not holds_pressure(surface, work, after, j):
        return entering_flux(surface, film, work, i, j)
    flux = film.couette[i, j] * fill_of(surface, work, i, j)
    return flux + film.conductance[i, j] * (pressure_of(surface, work, i, j) - pressure_of(surface, work, after, j))


@compiled
def update_surface(surface, film, work):
    """Semismooth Newton step on the wet set; returns the number of changes."""
    lines, nodes = surface.held.shape
    change = np.zeros((lines, nodes), np.bool_)
    changed = 0
    for i in range(lines):
        for j in range(nodes):
            if surface.held[i, j]:
                continue
            if work.wet[i, j] or surface.conserving:
                change[i, j] = work.solution[0, i, j] < -TIE
            else:
                change[i, j] = balance(surface, film, work, i, j) < -TIE
            if change[i, j]:
                changed += 1
    for i in range(lines):
        for j in range(nodes):
            if change[i, j]:
                work.wet[i, j] = not work.wet[i, j]
    return changed


@compiled
def end_adjoints_at_rupture(surface, film, work):
    """Conductance from the last wet line to the rupture itself, see ``_forces.end_at_rupture``."""
    lines, nodes = surface.held.shape
    n = surface.step.size
    for i in range(lines):
        for j in range(nodes):
            if surface.held[i, j] or not work.wet[i, j]:
                continue
            after, before = (i + 1) % lines, (i - 1) % lines
            pressure = work.solution[0, i, j]
            if not holds_pressure(surface, work, after, j):
                surplus = (film.couette[after % n, j] - film.couette[i, j]) / film.conductance[i, j]
                work.ending[i, j] += film.conductance[i, j] * shortening(pressure, surplus)
            if not holds_pressure(surface, work, before, j) and not surface.conserving:
                first = film.couette[(before - 1) % n, j]
                surplus = (film.couette[before, j] - first) / film.conductance[before, j]
                work.ending[i, j] += film.conductance[before, j] * shortening(pressure, surplus)


@compiled
def reduce_surface(surface, film, work, force, stiffness, damping):
    """Forces from the reference pressure; stiffness and damping from the adjoints (``_forces.add_forces``)."""
    lines, nodes = surface.held.shape
    motions = surface.motions
    force[:] = 0.0
    stiffness[:] = 0.0
    damping[:] = 0.0
    for i in range(lines):  # the row of a held node is no balance: its adjoint does not count
        for j in range(nodes):
            p = pressure_of(surface, work, i, j) - surface.reference
            fill = fill_of(surface, work, i, j)
            counts = row_counts(surface, work, i, j)
            for d in range(motions):
                force[d] -= film.load[d, i, j] * p
                if not counts:
                    work.solution[1 + d, i, j] = 0.0
                for e in range(motions):
                    damping[d, e] -= work.solution[1 + d, i, j] * fill * film.load[e, i, j]
    for i in range(surface.step.size):
        after = (i + 1) % lines
        for j in range(nodes):
            enters = surface.conserving and surface.held[i, j] and not holds_pressure(surface, work, after, j)
            fill = fill_of(surface, work, i, j)
            drop = pressure_of(surface, work, i, j) - pressure_of(surface, work, after, j)
            for d in range(motions):
                difference = work.solution[1 + d, i, j] - work.solution[1 + d, after, j]
                if difference == 0.0:
                    continue
                for e in range(motions):
                    if enters:
                        flux = film.inlet_d[e, i, j]
                    else:
                        flux = fill * film.couette_d[e, i, j] + drop * film.conductance_d[e, i, j]
                    stiffness[d, e] += difference * flux
    slopes = np.empty(motions)
    for i in range(lines):
        for q in range(surface.zeta.size):
            gradient = 0.0
            slopes[:] = 0.0
            for b in range(nodes):
                part = surface.slope[q, b]
                if part != 0.0:
                    gradient += part * pressure_of(surface, work, i, b)
                    for d in range(motions):
                        slopes[d] += part * work.solution[1 + d, i, b]
            scale = surface.kappa * surface.share[q] * gradient
            for d in range(motions):
                for e in range(motions):
                    stiffness[d, e] += scale * slopes[d] * film.cubed_d[e, i, q]


@compiled
def supply_flows(surface, film, work, flows):
    """Flow out of every held node into the film, (lines, nodes), weighted with the shares; zero elsewhere."""
    lines, nodes = surface.held.shape
    for i in range(lines):
        for j in range(nodes):
            flows[i, j] = balance(surface, film, work, i, j) if surface.held[i, j] else 0.0
