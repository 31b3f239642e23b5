"""Kernels: who is wet, and what the film does to the journal.

With the adjoints l of the force components and the residual rows R of ``_elimination``,
    dF/da = -l^T dR/da  for every parameter a of the film,
so stiffness and damping cost two back-substitutions and a few dot products. The wet set is held fixed: where the
film ends with p = dp/dn = 0 the first-order pressure vanishes on the unperturbed boundary (Lund, Thomsen 1978).
"""

from __future__ import annotations

from babbitt.reynolds._compiling import inlined
from babbitt.reynolds._structs import END_PRESSURE, START_PRESSURE
from babbitt.reynolds.lands._endings import reach

TIE = 1e-12  # a pressure or void this far below zero counts as zero
FORCE, STIFFNESS, DAMPING = slice(0, 2), slice(2, 6), slice(6, 10)
RESULT_SIZE = 10


@inlined
def update_active_set(axial, bearing, grid, k, film, lines):
    """Semismooth Newton step on the complementarity: returns how many nodes changed.

    Wet nodes with p < 0 dry up. Dry nodes become wet where the void is negative (mass conserving) or where the row
    of the node, with p = 0, has a surplus of oil (Reynolds condition).
    """
    m = len(axial.size)
    wet, conserving = grid.wet, bearing.conserving
    changed = 0
    for i in range(1, film.conductance.size):
        if conserving or lines.wet_count[i] == m:
            for j in range(m):
                if lines.solution[i, 0, j] < -TIE:
                    wet[k, i, j] = not wet[k, i, j]
                    changed += 1
            continue
        stretch = bearing.kappa * film.cubed[i]
        surplus = film.couette[i] - film.couette[i - 1] + film.squeeze[i]
        for j in range(m):
            if wet[k, i, j]:
                change = lines.solution[i, 0, j] < -TIE
            else:  # the row with p = 0: what flows off less what arrives
                row = axial.root_weights[j] * surplus - stretch * axial.load[j] * bearing.side_pressure
                row -= film.conductance[i - 1] * lines.solution[i - 1, 0, j]
                row -= film.conductance[i] * lines.solution[i + 1, 0, j]
                if lines.wet_count[i] > 0:
                    for b in range(m):
                        row += stretch * axial.stiffness[j, b] * lines.solution[i, 0, b]
                change = row < -TIE
            if change:
                wet[k, i, j] = not wet[k, i, j]
                changed += 1
    return changed


@inlined
def shortening(pressure, surplus):
    """Relative change of the conductance of an interval in which the film ends."""
    return 1.0 / reach(pressure, surplus) - 1.0


@inlined
def add_forces(axial, bearing, grid, k, film, lines, result):
    """Add force, stiffness and damping of land k to ``result`` (F 2, K 4, C 4; K and C row by row).

    F is counted from the side pressure: F_x = - int (p - p_side) cos(theta) over angle and mean width.
    """
    m = len(axial.size)
    n = film.conductance.size
    solution, wet, conserving, side = lines.solution, grid.wet, bearing.conserving, bearing.side_pressure
    fx, fy = 0.0, 0.0
    kxx, kxy, kyx, kyy = 0.0, 0.0, 0.0, 0.0
    cxx, cxy, cyx, cyy = 0.0, 0.0, 0.0, 0.0
    share = 0.0  # of the nodes inside; the node on the side edge is at the side pressure and carries nothing
    for j in range(m):
        share += axial.root_weights[j] ** 2
    for i in range(n):
        # the flux of the interval behind line i:  (l_i - l_i+1)^T dq_i
        if conserving or lines.wet_count[i] + lines.wet_count[i + 1] > 0:
            ax, ay, bx, by, inlet_x, inlet_y = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
            for j in range(m):
                q = axial.root_weights[j]
                lx = solution[i, 1, j] - solution[i + 1, 1, j]
                ly = solution[i, 2, j] - solution[i + 1, 2, j]
                up, down = solution[i, 0, j], solution[i + 1, 0, j]
                if conserving:
                    if i == 0 and not wet[k, 1, j]:
                        inlet_x += q * lx
                        inlet_y += q * ly
                        continue
                    if not wet[k, i, j]:
                        q, up = q - up, 0.0  # sqrt(w) times the liquid fraction
                    if not wet[k, i + 1, j]:
                        down = 0.0
                ax += q * lx
                ay += q * ly
                bx += lx * (up - down)
                by += ly * (up - down)
            kxx += ax * film.couette_x[i] + bx * film.conductance_x[i]
            kxy += ax * film.couette_y[i] + bx * film.conductance_y[i]
            kyx += ay * film.couette_x[i] + by * film.conductance_x[i]
            kyy += ay * film.couette_y[i] + by * film.conductance_y[i]
            kxx += inlet_x * film.inlet[1]
            kxy += inlet_x * film.inlet[2]
            kyx += inlet_y * film.inlet[1]
            kyy += inlet_y * film.inlet[2]
        if i == 0:
            continue
        # the line itself: pressure, axial flow, squeeze
        ox, oy = grid.weight_x[k, i], grid.weight_y[k, i]
        fx += share * side * ox
        fy += share * side * oy
        if lines.wet_count[i] == 0 and not conserving:
            continue
        mean, ex, ey, sx, sy = 0.0, 0.0, 0.0, 0.0, 0.0
        for j in range(m):
            q, here = axial.root_weights[j], wet[k, i, j]
            if here:
                mean += q * solution[i, 0, j]
            elif conserving:
                q -= solution[i, 0, j]
            sx += q * solution[i, 1, j]
            sy += q * solution[i, 2, j]
            row = -axial.load[j] * side
            for b in range(m):
                if wet[k, i, b]:
                    row += axial.stiffness[j, b] * solution[i, 0, b]
            ex += solution[i, 1, j] * row
            ey += solution[i, 2, j] * row
        fx -= ox * mean
        fy -= oy * mean
        kxx += bearing.kappa * ex * film.cubed_x[i]
        kxy += bearing.kappa * ex * film.cubed_y[i]
        kyx += bearing.kappa * ey * film.cubed_x[i]
        kyy += bearing.kappa * ey * film.cubed_y[i]
        cxx -= sx * ox
        cxy -= sx * oy
        cyx -= sy * ox
        cyy -= sy * oy
    # the groove edges: nodes inside at the groove's pressure
    start = share * (bearing.lands[k, START_PRESSURE] - side)
    end = share * (bearing.lands[k, END_PRESSURE] - side)
    result[0] += fx - start * grid.weight_x[k, 0] - end * grid.weight_x[k, n]
    result[1] += fy - start * grid.weight_y[k, 0] - end * grid.weight_y[k, n]
    result[2] += kxx
    result[3] += kxy
    result[4] += kyx
    result[5] += kyy
    result[6] += cxx
    result[7] += cxy
    result[8] += cyx
    result[9] += cyy
