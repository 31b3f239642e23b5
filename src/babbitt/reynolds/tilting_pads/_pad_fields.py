"""Kernels: fields, flows and torques of settled pads."""

from __future__ import annotations

import math

from babbitt.reynolds._compiling import compiled, inlined
from babbitt.reynolds.lands._grids import new_film, new_lines
from babbitt.reynolds.lands._integrals import (
    BEARING_TORQUE,
    INFLOW,
    JOURNAL_TORQUE,
    OUTFLOW,
    integrate_land,
)
from babbitt.reynolds.oil._turbulent_oil import stirred
from babbitt.reynolds.tilting_pads._tilt import LOADED, pad_film, pad_land


@compiled
def finish_pads(axial, pads, grid, places, pressure, void, totals, narrowest):
    """Films of settled pads once more, stiffness and damping freed from the steps of the grid (``_endings``).

    Fills the fields, (pads, n + 1, m + 1), the totals of ``_integrals``, and the narrowest gaps.
    """
    n, m = grid.step.shape[1], len(axial.size)
    film, lines = new_film(n), new_lines(n, m)
    for k in range(pads.kappa.size):
        e, eta = places.radial[k], places.along[k]
        narrowest[k] = narrowest_gap(grid, k, e, eta)
        if places.status[k] == LOADED:
            pad_film(axial, pads, grid, k, film, lines, e, eta, bool(0), pads.bearing.smooth, places)
            integrate_land(
                axial, pad_land(pads, k), grid, k, film, e, eta, pads.turbulence[k], pressure, void, totals
            )  # fmt: skip
        else:
            add_streamers(grid, k, e, max(narrowest[k], 0.0), pads.turbulence[k], void, totals)


@inlined
def narrowest_gap(grid, k, e, eta):
    """Smallest gap of pad k at the Gauss points."""
    smallest = math.inf
    for i in range(grid.step.shape[1]):
        a = grid.gap_a[k, i] - e * grid.cos_a[k, i] - eta * grid.sin_a[k, i]
        b = grid.gap_b[k, i] - e * grid.cos_b[k, i] - eta * grid.sin_b[k, i]
        smallest = min(smallest, min(a, b))
    return smallest


@inlined
def add_streamers(grid, k, e, narrowest, law, void, totals):
    """Void, flow and torques of a pad that does not carry, concentric with its bore (eta = 0).

    Its narrowest place passes its drag flow, half the speed times the gap; elsewhere the same oil fills a part
    of the gap and shears there, as the streamers of a ruptured film do. Where the gap is closed nothing is known.
    """
    n = grid.step.shape[1]
    shear, before = 0.0, 0.0
    for i in range(n + 1):
        behind = grid.gap_a[k, i] - e * grid.cos_a[k, i] if i < n else before
        on_line = 0.5 * (before + behind) if i > 0 else behind
        void[k, i, :] = min(max(1.0 - narrowest / max(on_line, 1e-300), 0.0), 1.0)
        if i < n:
            before = grid.gap_b[k, i] - e * grid.cos_b[k, i]
            sa, sb = 1.0, 1.0
            if law.size > 0:
                sa, sb = stirred(law, law[0] * behind), stirred(law, law[0] * before)
            shear += 0.5 * grid.step[k, i] * (sa / (behind * behind) + sb / (before * before))
    totals[k, INFLOW] = totals[k, OUTFLOW] = 0.5 * narrowest
    totals[k, JOURNAL_TORQUE] = totals[k, BEARING_TORQUE] = narrowest * shear if narrowest > 0.0 else math.nan
