"""Kernels: who is wet, and what the film does to the journal.

With the adjoints l of the force components and the residual rows R of ``_elimination``,
    dF/da = -l^T dR/da  for every parameter a of the film,
so stiffness and damping cost two back-substitutions and a few dot products. The wet set is held fixed: where the
film ends with p = dp/dn = 0 the first-order pressure vanishes on the unperturbed boundary (Lund, Thomsen 1978).
"""

from __future__ import annotations

from babbitt.film._structs import compiled

TIE = 1e-12  # a pressure or void this far below zero counts as zero
FORCE, STIFFNESS, DAMPING = slice(0, 2), slice(2, 6), slice(6, 10)
RESULT_SIZE = 10


@compiled
def update_wet_set(axial, film, lines, kappa, side_pressure, conserving):
    """Semismooth Newton step on the complementarity: returns how many nodes changed.

    Wet nodes with p < 0 dry up. Dry nodes become wet where the void is negative (mass conserving) or where the row
    of the node, with p = 0, has a surplus of oil (Reynolds condition).
    """
    m = len(axial.size)
    changed = 0
    for i in range(1, film.conductance.size):
        wettable = lines.wet_count[i] < m and not conserving
        for j in range(m):
            if lines.wet[i, j] or conserving:
                if lines.solution[i, 0, j] < -TIE:
                    lines.wet[i, j] = not lines.wet[i, j]
                    changed += 1
                    continue
            if wettable and not lines.wet[i, j]:
                if dry_row(axial, film, lines, kappa, side_pressure, i, j) < -TIE:
                    lines.wet[i, j] = True
                    changed += 1
    return changed


@compiled
def end_at_rupture(axial, film, lines, conserving):
    """Let the adjoints vanish at the rupture instead of the first dry line; returns the first line concerned.

    Near the rupture p'' is constant. In the discrete film the pressure d intervals before the first dry line is then
    g (d^2/2 + e d), with g = (Q_i+1 - Q_i)/T_i the surplus of the dry line, and its slope is that of the
    parabola that ends e intervals behind that line: e = p_i/g - 1/2. The conductance from the last wet line to
    the end of the film is T_i / (1 + e) instead of T_i.
    """
    m = len(axial.size)
    n = film.conductance.size
    first = n
    for i in range(1, n):
        for j in range(m):
            lines.ending[i, j] = 0.0
            if not lines.wet[i, j]:
                continue
            pressure = lines.solution[i, 0, j] / axial.root_weights[j]
            if i < n - 1 and not lines.wet[i + 1, j]:
                surplus = (film.couette[i + 1] - film.couette[i]) / film.conductance[i]
                lines.ending[i, j] += film.conductance[i] * shortening(pressure, surplus)
                first = min(first, i)
            if i > 1 and not lines.wet[i - 1, j] and not conserving:
                surplus = (film.couette[i - 1] - film.couette[i - 2]) / film.conductance[i - 1]
                lines.ending[i, j] += film.conductance[i - 1] * shortening(pressure, surplus)
                first = min(first, i)
    return first


@compiled
def shortening(pressure, surplus):
    """Relative change of the conductance of an interval at the end of the film: 1/(1/2 + p/g) - 1."""
    if surplus <= 0.0:
        return 0.0
    return 1.0 / (0.5 + min(pressure / surplus, 1.0)) - 1.0


@compiled
def dry_row(axial, film, lines, kappa, side_pressure, i, j):
    """Row of a dry node with p = 0: what flows off less what arrives, over sqrt(w_j)."""
    stretch = kappa * film.cubed[i]
    row = axial.root_weights[j] * (film.couette[i] - film.couette[i - 1] + film.squeeze[i])
    row -= film.conductance[i - 1] * lines.solution[i - 1, 0, j]
    row -= film.conductance[i] * lines.solution[i + 1, 0, j]
    row -= stretch * axial.load[j] * side_pressure
    if lines.wet_count[i] > 0:
        for k in range(len(axial.size)):
            row += stretch * axial.stiffness[j, k] * lines.solution[i, 0, k]
    return row


@compiled
def add_forces(axial, land, grid, film, lines, kappa, side_pressure, conserving, result):
    """Add force, stiffness and damping of a land to ``result`` (F 2, K 4, C 4; K and C row by row).

    F is counted from the side pressure: F_x = - int (p - p_side) cos(theta) over angle and mean width.
    """
    m = len(axial.size)
    n = film.conductance.size
    fx, fy = 0.0, 0.0
    kxx, kxy, kyx, kyy = 0.0, 0.0, 0.0, 0.0
    cxx, cxy, cyx, cyy = 0.0, 0.0, 0.0, 0.0
    for i in range(n + 1):
        now = lines.solution[i]
        if lines.wet_count[i] == 0 and not conserving and side_pressure == 0.0 and lines.wet_count[min(i+1,n)] == 0:
            continue
        mean = 0.0
        for j in range(m):
            if lines.wet[i, j]:
                mean += axial.root_weights[j] * (now[0, j] - side_pressure * axial.root_weights[j])
            else:
                mean -= side_pressure * axial.root_weights[j] ** 2
        fx -= grid.weight_x[i] * mean
        fy -= grid.weight_y[i] * mean
        if i == n:
            break
        # flux of the interval behind the line
        after = lines.solution[i + 1]
        ax, ay, bx, by = 0.0, 0.0, 0.0, 0.0
        inlet_x, inlet_y = 0.0, 0.0
        for j in range(m):
            q = axial.root_weights[j]
            lx, ly = now[1, j] - after[1, j], now[2, j] - after[2, j]
            up = now[0, j]
            if not lines.wet[i, j]:
                q, up = q - up, 0.0  # sqrt(w) times the liquid fraction
            down = after[0, j] if lines.wet[i + 1, j] else 0.0
            if i == 0 and not lines.wet[1, j]:
                inlet_x += q * lx
                inlet_y += q * ly
                continue
            ax += q * lx
            ay += q * ly
            bx += lx * (up - down)
            by += ly * (up - down)
        kxx += ax * film.couette_x[i] + bx * film.conductance_x[i]
        kxy += ax * film.couette_y[i] + bx * film.conductance_y[i]
        kyx += ay * film.couette_x[i] + by * film.conductance_x[i]
        kyy += ay * film.couette_y[i] + by * film.conductance_y[i]
        if i == 0:
            kxx += inlet_x * film.inlet[1]
            kxy += inlet_x * film.inlet[2]
            kyx += inlet_y * film.inlet[1]
            kyy += inlet_y * film.inlet[2]
            continue
        if lines.wet_count[i] == 0 and not conserving:
            continue
        # axial flow and squeeze of the line
        ex, ey, sx, sy = 0.0, 0.0, 0.0, 0.0
        for j in range(m):
            row = -axial.load[j] * side_pressure
            q = axial.root_weights[j]
            if lines.wet[i, j]:
                sx += q * now[1, j]
                sy += q * now[2, j]
            elif conserving:
                sx += (q - now[0, j]) * now[1, j]
                sy += (q - now[0, j]) * now[2, j]
            for k in range(m):
                if lines.wet[i, k]:
                    row += axial.stiffness[j, k] * now[0, k]
            ex += now[1, j] * row
            ey += now[2, j] * row
        kxx += kappa * ex * film.cubed_x[i]
        kxy += kappa * ex * film.cubed_y[i]
        kyx += kappa * ey * film.cubed_x[i]
        kyy += kappa * ey * film.cubed_y[i]
        cxx -= sx * grid.weight_x[i]
        cxy -= sx * grid.weight_y[i]
        cyx -= sy * grid.weight_x[i]
        cyy -= sy * grid.weight_y[i]
    result[0] += fx
    result[1] += fy
    result[2] += kxx
    result[3] += kxy
    result[4] += kyx
    result[5] += kyy
    result[6] += cxx
    result[7] += cxy
    result[8] += cyx
    result[9] += cyy
