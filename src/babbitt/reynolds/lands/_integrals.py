"""Kernels: pressure and void on the nodes, flows with their balance, friction with streamers, highest pressure.

Called once for a settled position. The node on the side edge is a column of its own (index m): its pressure is the
side pressure, its row gives the oil that leaves. Where less oil arrives than the gap could carry, the edge runs
partly filled and draws nothing in; a side above the cavitation pressure does, and side flow is then what leaves
less what is drawn in. In every land inflow = outflow + side flow + squeezed volume.
"""

from __future__ import annotations

import numpy as np

from babbitt.reynolds._compiling import compiled, inlined, inner
from babbitt.reynolds.lands._grids import film_coefficients
from babbitt.reynolds.oil._turbulent_oil import stirred, thickened

INFLOW, OUTFLOW, SIDE_FLOW, SIDE_INFLOW, IMBALANCE = range(5)
JOURNAL_TORQUE, BEARING_TORQUE, STREAMER_TORQUE, TOTALS = range(5, 9)
SHEARED, J_1, J_2, MEAN_GAP, SHEAR_COLUMNS = range(5)


@compiled
def integrate(axial, bearing, grid, film, x, y, x_rate, y_rate, pressure, void, totals):
    """Fill pressure and void, (lands, n + 1, m + 1), and totals, (lands, TOTALS), from the solution on ``grid``.

    Flows by omega R c B, torques by mu omega R^3 B / c.
    """
    laminar = np.zeros(0)
    for k in range(bearing.lands.shape[0]):
        film_coefficients(bearing, grid, k, x, y, x_rate, y_rate, film)
        integrate_land(axial, bearing, grid, k, film, x, y, laminar, pressure, void, totals)


@inner
def integrate_land(axial, bearing, grid, k, film, x, y, law, pressure, void, totals):
    """Fill pressure, void and totals of land k (`integrate`) from coefficients of its film that are known, ``law``
    that of their turbulence or empty."""
    m = len(axial.size)
    n = film.conductance.size
    shear = np.empty((n, SHEAR_COLUMNS))
    laminar_shear(grid, k, x, y, shear)
    if law.size > 0:
        turbulent_shear(grid, k, x, y, law, shear)
    totals[k, :] = 0.0
    for i in range(n + 1):
        for j in range(m):
            value = grid.value[k, i, j] / axial.root_weights[j]
            pressure[k, i, j] = value if grid.wet[k, i, j] else 0.0
            void[k, i, j] = value if bearing.conserving and not grid.wet[k, i, j] else 0.0
        pressure[k, i, m] = bearing.side_pressure
        void[k, i, m] = 0.0
    for j in range(m):
        inner_column(axial, bearing, grid, k, j, film, shear, pressure, void, totals)
    edge_column(axial, bearing, grid, k, film, shear, pressure, void, totals)
    stored = 0.0
    for i in range(1, n):
        for j in range(m):
            stored += axial.root_weights[j] ** 2 * (1.0 - void[k, i, j]) * film.squeeze[i]
        stored += axial.edge_weight * (1.0 - void[k, i, m]) * film.squeeze[i]
    totals[k, IMBALANCE] = totals[k, INFLOW] - totals[k, OUTFLOW] - totals[k, SIDE_FLOW] - stored


@inner
def inner_column(axial, bearing, grid, k, j, film, shear, pressure, void, totals):
    """Flux and friction along the column of an inner node; the void behind a Reynolds rupture by continuity.

    Friction: a Couette part with the liquid fraction, that of streamers apart from both torques, too, and
    +- (h/2) dp/dtheta, which the column of the edge does not have.
    """
    n = film.conductance.size
    weight = axial.root_weights[j] ** 2
    flux, sheared, sloped, streamers = 0.0, 0.0, 0.0, 0.0
    for i in range(n):
        here, behind = i == 0 or grid.wet[k, i, j], i + 1 == n or grid.wet[k, i + 1, j]
        if not here and not bearing.conserving:  # streamers carry on what left the film
            void[k, i, j] = min(max(0.0, 1.0 - flux / film.couette[i]), 1.0) if film.couette[i] > 0.0 else 1.0
        if i == 0 and not behind and bearing.conserving:
            flux = film.inlet[0]
        else:
            flux = film.couette[i] * (1.0 - void[k, i, j])
            flux += film.conductance[i] * (pressure[k, i, j] - pressure[k, i + 1, j])
        if i == 0:
            totals[k, INFLOW] += weight * flux
        couette = bearing.speed * shear[i, SHEARED] * (1.0 - void[k, i, j])
        sheared += couette
        if void[k, i, j] > 0.0:
            streamers += couette
        if here and (pressure[k, i, j] > 0.0 or pressure[k, i + 1, j] > 0.0):
            sloped += full_slope(bearing.speed, shear[i, J_1], shear[i, J_2], flux)
        else:
            sloped += 0.5 * shear[i, MEAN_GAP] * (pressure[k, i + 1, j] - pressure[k, i, j])
    totals[k, OUTFLOW] += weight * flux
    totals[k, STREAMER_TORQUE] += weight * streamers
    totals[k, JOURNAL_TORQUE] += weight * (sheared + sloped)
    totals[k, BEARING_TORQUE] += weight * (sheared - sloped)


@inner
def edge_column(axial, bearing, grid, k, film, shear, pressure, void, totals):
    """Side flow: what the row of the edge node can neither pass on nor store.

    With the liquid fraction phi, w (Q_i + S_i) phi + side flow = w q_i-1 - kappa H_i (K p)_edge. Of what arrives,
    the gap takes up to w (Q_i + S_i); only where it is full (phi = 1) does oil leave at the side.
    """
    m = len(axial.size)
    n = film.conductance.size
    weight = axial.edge_weight
    flux = film.couette[0]
    if bearing.conserving and not grid.wet[k, 1, m - 1]:
        flux = film.inlet[0]
    totals[k, INFLOW] += weight * flux
    leaves, enters, sheared, streamers = 0.0, 0.0, 0.0, 0.0
    for i in range(n):
        if i > 0:
            if not bearing.conserving and grid.wet[k, i, m - 1] and not grid.wet[k, i - 1, m - 1]:
                flux = film.couette[i - 1]  # where a Reynolds film begins, oil comes from nowhere, here as inside
            arriving = weight * flux
            for j in range(m + 1):
                arriving -= bearing.kappa * film.cubed[i] * axial.edge_stiffness[j] * pressure[k, i, j]
            room, liquid = weight * (film.couette[i] + film.squeeze[i]), 1.0
            if bearing.side_pressure <= 0.0 and room > 0.0:
                liquid = min(max(arriving, 0.0) / room, 1.0)
            void[k, i, m] = 1.0 - liquid
            flux = liquid * film.couette[i]
            leaves += arriving - liquid * room
            enters += max(liquid * room - arriving, 0.0)
        couette = bearing.speed * shear[i, SHEARED] * (1.0 - void[k, i, m])
        sheared += couette
        if void[k, i, m] > 0.0:
            streamers += couette
    totals[k, SIDE_FLOW] += leaves
    totals[k, SIDE_INFLOW] += enters
    totals[k, OUTFLOW] += weight * flux
    totals[k, STREAMER_TORQUE] += weight * streamers
    totals[k, JOURNAL_TORQUE] += weight * sheared
    totals[k, BEARING_TORQUE] += weight * sheared


@inlined
def full_slope(speed, j_1, j_2, flux):
    """(h/2) dp/dtheta over a full interval: dp/dtheta = 12 (h/2 - q)/h^3 integrates exactly to 3 J_1 - 6 q J_2."""
    return 3.0 * speed * j_1 - 6.0 * flux * j_2


@inlined
def laminar_shear(grid, k, x, y, shear):
    """Integrals of every interval by its two Gauss points: J_1, J_2, that of the shear, and the mean gap."""
    for i in range(shear.shape[0]):
        half = 0.5 * grid.step[k, i]
        ha = grid.gap_a[k, i] - x * grid.cos_a[k, i] - y * grid.sin_a[k, i]
        hb = grid.gap_b[k, i] - x * grid.cos_b[k, i] - y * grid.sin_b[k, i]
        shear[i, J_1] = shear[i, SHEARED] = half * (1.0 / ha + 1.0 / hb)
        shear[i, J_2] = half * (1.0 / (ha * ha) + 1.0 / (hb * hb))
        shear[i, MEAN_GAP] = 0.5 * (ha + hb)


@inner
def turbulent_shear(grid, k, x, y, law, shear):
    """The same of a turbulent film: J_1 and J_2 with its effective viscosity, the shear with a law of its own."""
    for i in range(shear.shape[0]):
        half = 0.5 * grid.step[k, i]
        ha = grid.gap_a[k, i] - x * grid.cos_a[k, i] - y * grid.sin_a[k, i]
        hb = grid.gap_b[k, i] - x * grid.cos_b[k, i] - y * grid.sin_b[k, i]
        fa, _ = thickened(law, law[0] * ha, 0)
        fb, _ = thickened(law, law[0] * hb, 0)
        shear[i, J_1], shear[i, J_2] = half * (fa / ha + fb / hb), half * (fa / (ha * ha) + fb / (hb * hb))
        shear[i, SHEARED] = half * (stirred(law, law[0] * ha) / ha + stirred(law, law[0] * hb) / hb)
