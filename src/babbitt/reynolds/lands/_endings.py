"""Kernels: where between two lines the film ends, and what that changes in stiffness and damping.

The wet set knows the ends of the film to one interval only. The exact derivative of the discrete force therefore
jumps by a per cent whenever a node changes sides, although the force does not. Here the last wet node of a column
gets a control volume that reaches to the end of the film itself, in the equation of the adjoints and in the
sums, so that a node arrives and leaves with next to nothing. Pressure and force stay as they are.

Rupture (and, with the Reynolds condition, the start of the film as well): p'' is constant near the end. In the
discrete film the pressure d intervals before the first dry line is g (d^2/2 + e d), with g the surplus
(Q_i+1 - Q_i)/T_i of the dry line, and its slope is that of the parabola that ends e intervals behind that line:
e = p_i/g - 1/2. The film reaches r = 1 + e intervals past the last wet line and the adjoint, zero at the end,
falls over r intervals. In the last interval of a land the end of the film is the groove edge or lies before it.

Closing front of the mass-conserving film: behind a dry node with void s the flux q that arrives closes the film
after a part 1 - f of the interval; the pressure rises linearly from there, T_i-1 p_i = f (Q_i-1 - q), while
s Q_i-1 = (1 - f)(Q_i-1 - q). The front moves when the pressure changes: of the interval, 2 f half intervals
feel a change of p_i.
"""

from __future__ import annotations

from babbitt.reynolds._compiling import inlined
from babbitt.reynolds._structs import END_PRESSURE, START_PRESSURE


@inlined
def find_ends(axial, bearing, grid, k, film, lines):
    """Fill ``before``, ``behind``, ``fill`` of all wet nodes; returns the first line where they matter, or n."""
    m = len(axial.size)
    n = film.conductance.size
    couette, conductance, squeeze = film.couette, film.conductance, film.squeeze
    wet, value = grid.wet[k], grid.value[k]
    conserving = bearing.conserving
    starts = bearing.lands[k, START_PRESSURE] <= 0.0 and not conserving
    ends = bearing.lands[k, END_PRESSURE] <= 0.0
    first = n
    for i in range(1, n):
        uniform = lines.wet_count[i - 1] + lines.wet_count[i] + lines.wet_count[i + 1] in (0, 3 * m)
        if uniform and (i > 1 or not starts) and (i < n - 1 or not ends):
            continue
        for j in range(m):
            if not wet[i, j]:
                continue
            pressure = value[i, j] / axial.root_weights[j]
            before, behind, fill = 1.0, 1.0, 0.5
            if i < n - 1 and not wet[i + 1, j]:
                behind = reach(pressure, (couette[i + 1] - couette[i] + squeeze[i + 1]) / conductance[i])
            elif i == n - 1 and ends:
                behind = min(reach(pressure, (couette[i] - couette[i - 1] + squeeze[i]) / conductance[i]), 1.0)
            if i > 1 and not wet[i - 1, j]:
                if conserving:
                    filled = conductance[i - 1] * value[i, j]
                    fill = front(filled, filled + couette[i - 1] * value[i - 1, j])
                else:
                    surplus = couette[i - 1] - couette[i - 2] + squeeze[i - 1]
                    before = reach(pressure, surplus / conductance[i - 1])
            elif i == 1 and starts:
                before = min(reach(pressure, (couette[1] - couette[0] + squeeze[1]) / conductance[0]), 1.0)
            lines.before[i, j], lines.behind[i, j], lines.fill[i, j] = before, behind, fill
            if before != 1.0 or behind != 1.0 or fill != 0.5:
                first = min(first, i)
    return first


@inlined
def reach(pressure, surplus):
    """Intervals from the last wet node to the end of the film."""
    return 0.5 + min(max(pressure / surplus, 0.0), 1.0) if surplus > 0.0 else 1.0


@inlined
def front(filled, whole):
    """Part of an interval behind the front where the film closes."""
    return min(max(filled / whole, 0.0), 1.0) if whole > 0.0 else 0.5


@inlined
def apply_ends(axial, film, lines, i, stretch, conserving, wet):
    """Put the ends of the film into the block and the adjoint right-hand sides of line i."""
    m = len(axial.size)
    for b in range(m):
        before, behind, fill = lines.before[i, b], lines.behind[i, b], lines.fill[i, b]
        if wet[b] and (before != 1.0 or behind != 1.0 or fill != 0.5):
            lines.inverse[i, b, b] += film.conductance[i - 1] * (1.0 / before - 1.0)
            lines.inverse[i, b, b] += film.conductance[i] * (1.0 / behind - 1.0)
            extent = 0.5 * (before + behind) + fill - 0.5  # length of film at the node over its control volume
            lines.swept[i, 1, b] *= extent
            lines.swept[i, 2, b] *= extent
            for a in range(m):
                if conserving or wet[a]:
                    lines.inverse[i, a, b] += (extent - 1.0) * stretch * axial.stiffness[a, b]


@inlined
def add_ends(axial, grid, k, film, lines, first, result):
    """Add to K and C what the ends of the film change in the sums of ``add_forces``; then forget the ends."""
    m = len(axial.size)
    n = film.conductance.size
    for i in range(first, n):
        for j in range(m):
            before, behind, fill = lines.before[i, j], lines.behind[i, j], lines.fill[i, j]
            if not grid.wet[k, i, j] or (before == 1.0 and behind == 1.0 and fill == 0.5):
                continue
            q, u = axial.root_weights[j], grid.value[k, i, j]
            here, other = i, i + 1 if i < n - 1 else i - 1  # two intervals that tell the slope of Q
            along = 0.5 * q * (behind - 1.0) * (other - here)
            thin = u * (1.0 / behind - 1.0)
            flux_x = along * (film.couette_x[other] - film.couette_x[here]) + thin * film.conductance_x[here]
            flux_y = along * (film.couette_y[other] - film.couette_y[here]) + thin * film.conductance_y[here]
            here, other = i - 1, i - 2 if i > 1 else i
            along = 0.5 * q * (before - 1.0) * (here - other)
            thin = u * (1.0 / before - 1.0)
            flux_x += thin * film.conductance_x[here] - along * (film.couette_x[other] - film.couette_x[here])
            flux_y += thin * film.conductance_y[here] - along * (film.couette_y[other] - film.couette_y[here])
            volume = q * (0.5 * (before + behind) - 1.0)
            if fill != 0.5:
                volume -= 0.5 * grid.value[k, i - 1, j]
            lx, ly = lines.solution[i, 1, j], lines.solution[i, 2, j]
            ox, oy = volume * grid.weight_x[k, i], volume * grid.weight_y[k, i]
            result[2] += lx * flux_x
            result[3] += lx * flux_y
            result[4] += ly * flux_x
            result[5] += ly * flux_y
            result[6] -= lx * ox
            result[7] -= lx * oy
            result[8] -= ly * ox
            result[9] -= ly * oy
    lines.before[:] = 1.0
    lines.behind[:] = 1.0
    lines.fill[:] = 0.5
