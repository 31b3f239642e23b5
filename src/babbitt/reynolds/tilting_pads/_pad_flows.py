"""Kernels: flows and heat of the films of tilting pads, on one ring of the lines of all pads.

The lines of pad k are ``k (n + 1)`` to ``k (n + 1) + n`` of the ring. Its first line stands for the oil that
enters, its last interval, behind the last line, for what leaves. Units as of ``babbitt.reynolds._structs``, flows
over the width of their own pad; heat as of ``babbitt.reynolds.heat._heat_flows``, from which the layers come.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy import float64, int64
from numpy.typing import NDArray

from babbitt.reynolds._compiling import inlined, inner, spliced
from babbitt.reynolds.tilting_pads._tilt import LOADED, pad_coefficients

Array = NDArray[float64]

DISSIPATION, JOURNAL_POWER, BORE_POWER, INFLOW, OUTFLOW, SIDE_FLOW, NARROWEST, PAD_TOTALS = range(8)


class PadRing(NamedTuple):
    """What the kernels of ``babbitt.reynolds.heat`` ask of a film: lines, speed, and how viscosity is kept."""

    step: Array  # of every interval; the first of a pad counts double, the one behind its last line nothing
    speed: float
    conserving: bool
    points: int  # one: it stands for the width
    node: NDArray[int64]  # one zero
    viscosity: Array  # effective, over the unit, (intervals, 1)
    drag: Array  # flow by shear over half the gap, (intervals, 1)


@inlined
def take_viscosity(pads, ring):
    """Effective viscosity and drag of the intervals of every pad from those of the ring."""
    count, n = pads.fluidity.shape
    for k in range(count):
        for i in range(n):
            r = k * (n + 1) + i
            pads.fluidity[k, i] = 1.0 / ring.viscosity[r, 0]
            pads.drag[k, i] = ring.drag[r, 0]


@inner
def pad_flows(axial, pads, grid, film, places, rise, flows, totals):
    """Flows and heat of all pads, ``rise`` the temperature per unit of heat over flow; fills their ``totals``."""
    for array in (flows.shear, flows.pressure, flows.axial, flows.leak, flows.heat, flows.gap, flows.fill):
        array[:] = 0.0
    totals[:] = 0.0
    n = film.conductance.size
    for k in range(pads.kappa.size):
        first = k * (n + 1)
        gaps_of(grid, k, places.radial[k], places.along[k], first, flows, totals[k])
        if places.status[k] == LOADED:
            film_flows(axial, pads, grid, k, film, places, first, flows, totals[k])
        else:
            streamer_flows(grid, k, places.radial[k], first, flows, totals[k])
        finish(flows, first, n, rise, totals[k])


@inlined
def gap_pair(grid, k, i, e, eta):
    """Gaps at both Gauss points of an interval."""
    ha = grid.gap_a[k, i] - e * grid.cos_a[k, i] - eta * grid.sin_a[k, i]
    hb = grid.gap_b[k, i] - e * grid.cos_b[k, i] - eta * grid.sin_b[k, i]
    return ha, hb


@inlined
def gaps_of(grid, k, e, eta, first, flows, totals):
    """Gap of every line, the mean at the Gauss points next to it, and the narrowest."""
    n = grid.step.shape[1]
    before, narrowest = 0.0, np.inf
    for i in range(n):
        ha, hb = gap_pair(grid, k, i, e, eta)
        flows.gap[first + i, 0] = ha if i == 0 else 0.5 * (ha + before)
        narrowest = min(narrowest, min(ha, hb))
        before = hb
    flows.gap[first + n, 0] = before
    totals[NARROWEST] = narrowest


@inlined
def film_flows(axial, pads, grid, k, film, places, first, flows, totals):
    """Flows of a pad that carries, column by column of the width; streamers pass on what left the film.

    The Reynolds condition lets films begin with oil from nowhere: here it is drawn over the sides.
    """
    m, n = len(axial.size), film.conductance.size
    e, eta = places.radial[k], places.along[k]
    pad_coefficients(pads, grid, k, e, eta, film)
    for j in range(m + 1):
        weight = axial.edge_weight if j == m else axial.root_weights[j] ** 2
        flux, liquid = 0.0, 1.0
        for i in range(n):
            r = first + i
            here, behind, p_here, p_behind, push = True, True, 0.0, 0.0, 0.0
            if j < m:
                here, behind = i == 0 or grid.wet[k, i, j], i + 1 == n or grid.wet[k, i + 1, j]
                p_here = grid.value[k, i, j] / axial.root_weights[j] if here else 0.0
                p_behind = grid.value[k, i + 1, j] / axial.root_weights[j] if behind else 0.0
                push = film.conductance[i] * (p_here - p_behind)
                if not here:
                    flux += flow_aside(axial, pads, grid, k, i, j, film) - push
                    liquid = min(max(flux / film.couette[i], 0.0), 1.0)
                    flows.leak[r, 0] += weight * (flux - liquid * film.couette[i])
                else:  # a film that begins behind streamers draws what they lack
                    flows.leak[r, 0] -= weight * (1.0 - liquid) * film.couette[max(i - 1, 0)]
                    liquid = 1.0
            elif i > 0:
                liquid = side_leak(axial, pads, grid, k, i, film, flux, r, flows)
            drawn = film.couette[i] * liquid
            flux = drawn + push
            flows.shear[r, 0] += weight * drawn
            flows.pressure[r, 0] += weight * push
            flows.fill[r, 0] += weight * liquid
            sheared, pulled = shear_heat(
                pads, grid, k, i, e, eta, flux, liquid, p_here, p_behind, flows.shear_viscosity[r, 0]
            )
            pushed = push * (p_here - p_behind)
            flows.heat[r, 0] += 0.5 * weight * (sheared + pushed)
            flows.heat[r + 1, 0] += 0.5 * weight * (sheared + pushed)
            work = weight * (sheared - drawn * (p_here - p_behind))
            totals[JOURNAL_POWER] += work
            totals[BORE_POWER] += work - weight * pulled
        flows.fill[first + n, 0] += weight * liquid
    for i in range(1, n):
        across = 0.0
        for j in range(m):
            if not grid.wet[k, i, j]:
                continue
            for b in range(m):
                if grid.wet[k, i, b]:
                    across += grid.value[k, i, j] * axial.stiffness[j, b] * grid.value[k, i, b]
        flows.heat[first + i, 0] += pads.kappa[k] * film.cubed[i] * across


@inlined
def flow_aside(axial, pads, grid, k, i, j, film):
    """Flow that a dry node receives from the wet ones on its line, over its share of the width."""
    total = 0.0
    for b in range(len(axial.size)):
        if grid.wet[k, i, b]:
            total -= axial.stiffness[j, b] * grid.value[k, i, b]
    return pads.kappa[k] * film.cubed[i] * total / axial.root_weights[j]


@inlined
def side_leak(axial, pads, grid, k, i, film, flux, r, flows):
    """Liquid fraction on the edge of the width at a line, as ``_integrals.edge_column``; its leak is added."""
    m, weight = len(axial.size), axial.edge_weight
    if grid.wet[k, i, m - 1] and i > 1 and not grid.wet[k, i - 1, m - 1]:
        flows.leak[r, 0] -= weight * (film.couette[i - 1] - flux)
        flux = film.couette[i - 1]
    arriving = weight * flux
    for j in range(m):
        if grid.wet[k, i, j]:
            pressure = grid.value[k, i, j] / axial.root_weights[j]
            arriving -= pads.kappa[k] * film.cubed[i] * axial.edge_stiffness[j] * pressure
    room = weight * film.couette[i]
    liquid = min(max(arriving, 0.0) / room, 1.0)
    flows.leak[r, 0] += arriving - liquid * room
    return liquid


@inlined
def shear_heat(pads, grid, k, i, e, eta, flux, liquid, p_here, p_behind, viscosity):
    """Heat by shear in an interval of a column, and int h dp/dtheta, the torque that the bore is spared.

    With j_n = int h^-n, f and g the effective viscosity and the drag: mu j_1 + 3 f g^2 (j_1 - j_2^2/j_3), and at
    constant flux q  h dp/dtheta = 12 f (g/2 - q/h) / h.
    """
    half = 0.5 * grid.step[k, i]
    ha, hb = gap_pair(grid, k, i, e, eta)
    a, b = 1.0 / ha, 1.0 / hb
    j1 = half * (a + b)
    sheared = viscosity * liquid * j1
    if not (p_here > 0.0 or p_behind > 0.0):
        return sheared, 0.0
    if liquid < 1.0:
        return sheared, 0.5 * (ha + hb) * (p_behind - p_here)
    f, g = 1.0 / pads.fluidity[k, i], pads.drag[k, i]
    j2, j3 = half * (a * a + b * b), half * (a * a * a + b * b * b)
    return sheared + 3.0 * f * g * g * (j1 - j2 * j2 / j3), 12.0 * f * (0.5 * g * j1 - flux * j2)


@inlined
def streamer_flows(grid, k, e, first, flows, totals):
    """Flows of an unloaded pad, concentric with its bore: its narrowest place passes what it drags, and the same
    oil fills a part of the gap elsewhere."""
    n = grid.step.shape[1]
    narrowest = totals[NARROWEST]
    for i in range(n + 1):
        flows.fill[first + i, 0] = min(narrowest / flows.gap[first + i, 0], 1.0)
    for i in range(n):
        r, half = first + i, 0.5 * grid.step[k, i]
        ha, hb = gap_pair(grid, k, i, e, 0.0)
        flows.shear[r, 0] = 0.5 * narrowest
        sheared = flows.shear_viscosity[r, 0] * half * narrowest * (1.0 / (ha * ha) + 1.0 / (hb * hb))
        flows.heat[r, 0] += 0.5 * sheared
        flows.heat[r + 1, 0] += 0.5 * sheared
        totals[JOURNAL_POWER] += sheared
        totals[BORE_POWER] += sheared


@spliced
def finish(flows, first, n, rise, totals):
    """What crosses the edges; the half cell at the leading edge gives its heat to the next one."""
    last = first + n
    flows.heat[first + 1, 0] += flows.heat[first, 0]
    flows.heat[first, 0] = 0.0
    for i in range(first, last + 1):
        totals[DISSIPATION] += flows.heat[i, 0]
        totals[SIDE_FLOW] += flows.leak[i, 0]
        flows.heat[i, 0] *= rise
    totals[INFLOW] = flows.shear[first, 0] + flows.pressure[first, 0]
    totals[OUTFLOW] = flows.shear[last - 1, 0] + flows.pressure[last - 1, 0]
    flows.shear[last, 0], flows.pressure[last, 0] = flows.shear[last - 1, 0], flows.pressure[last - 1, 0]
    for k in range(flows.shear_profile.shape[2]):
        flows.shear_profile[last, 0, k] = flows.shear_profile[last - 1, 0, k]
        flows.pressure_profile[last, 0, k] = flows.pressure_profile[last - 1, 0, k]
    flows.stress[last, 0], flows.balance[last, 0] = flows.stress[last - 1, 0], flows.balance[last - 1, 0]
    flows.shear_viscosity[last, 0] = flows.shear_viscosity[last - 1, 0]
