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

from babbitt.film._compiling import inlined
from babbitt.film._structs import END_PRESSURE, START_PRESSURE


@inlined
def end_film_between_lines(axial, bearing, grid, k, film, lines):
    """Set the ends of the film in the equation of the adjoints; returns the first line concerned, or n."""
    m = len(axial.size)
    n = film.conductance.size
    first = n
    for i in range(1, n):
        if 1 < i < n - 1 and lines.wet_count[i - 1] + lines.wet_count[i] + lines.wet_count[i + 1] in (0, 3 * m):
            continue
        for j in range(m):
            if inside(bearing, grid, k, i, j, n):
                continue
            before, behind, fill, _ = reach(axial, bearing, grid, k, i, j, film)
            ending = film.conductance[i - 1] * (1.0 / before - 1.0) + film.conductance[i] * (1.0 / behind - 1.0)
            extent = 0.5 * (before + behind) + fill - 0.5
            lines.ending[i, j], lines.extent[i, j] = ending, extent
            if ending != 0.0 or extent != 1.0:
                first = min(first, i)
    return first


@inlined
def add_endings(axial, bearing, grid, k, film, lines, result):
    """Add to K and C what the ends of the film change in the sums of ``add_forces``; undo the settings."""
    m = len(axial.size)
    n = film.conductance.size
    for i in range(1, n):
        if 1 < i < n - 1 and lines.wet_count[i - 1] + lines.wet_count[i] + lines.wet_count[i + 1] in (0, 3 * m):
            continue
        for j in range(m):
            if inside(bearing, grid, k, i, j, n):
                continue
            before, behind, _, void = reach(axial, bearing, grid, k, i, j, film)
            q, u = axial.root_weights[j], grid.value[k, i, j]
            couette_x, couette_y, conductance_x, conductance_y = 0.0, 0.0, 0.0, 0.0
            if behind != 1.0:
                other = i + 1 if i < n - 1 else i - 1  # for the slope of the Couette flux
                change = 0.5 * (behind - 1.0) * (other - i)
                couette_x += change * (film.couette_x[other] - film.couette_x[i])
                couette_y += change * (film.couette_y[other] - film.couette_y[i])
                conductance_x += (1.0 / behind - 1.0) * film.conductance_x[i]
                conductance_y += (1.0 / behind - 1.0) * film.conductance_y[i]
            if before != 1.0:
                other = i - 2 if i > 1 else i
                change = 0.5 * (before - 1.0) * (i - 1 - other)
                couette_x -= change * (film.couette_x[other] - film.couette_x[i - 1])
                couette_y -= change * (film.couette_y[other] - film.couette_y[i - 1])
                conductance_x += (1.0 / before - 1.0) * film.conductance_x[i - 1]
                conductance_y += (1.0 / before - 1.0) * film.conductance_y[i - 1]
            flux_x, flux_y = q * couette_x + u * conductance_x, q * couette_y + u * conductance_y
            volume = q * (0.5 * (before + behind - void) - 1.0)
            for d in range(2):
                adjoint = lines.solution[i, 1 + d, j]
                result[2 + 2 * d] += adjoint * flux_x
                result[3 + 2 * d] += adjoint * flux_y
                result[6 + 2 * d] -= adjoint * volume * grid.weight_x[k, i]
                result[7 + 2 * d] -= adjoint * volume * grid.weight_y[k, i]
    lines.ending[:] = 0.0
    lines.extent[:] = 1.0


@inlined
def inside(bearing, grid, k, i, j, n):
    """Whether the film goes on to both sides of a node, or the node is dry."""
    wet = grid.wet
    if not wet[k, i, j]:
        return True
    if i == n - 1 and bearing.lands[k, END_PRESSURE] <= 0.0:
        return False
    if i == 1 and bearing.lands[k, START_PRESSURE] <= 0.0 and not bearing.conserving:
        return False
    return (i == 1 or wet[k, i - 1, j]) and (i == n - 1 or wet[k, i + 1, j])


@inlined
def reach(axial, bearing, grid, k, i, j, film):
    """How far the film reaches from a wet node, in intervals: before, behind; fill f and void s at a front."""
    n = film.conductance.size
    couette, conductance, wet = film.couette, film.conductance, grid.wet
    pressure = grid.value[k, i, j] / axial.root_weights[j]
    before, behind, fill, void = 1.0, 1.0, 0.5, 0.0
    if i == n - 1:
        if bearing.lands[k, END_PRESSURE] <= 0.0:
            behind = min(1.0, rupture(pressure, (couette[i] - couette[i - 1]) / conductance[i]))
    elif not wet[k, i + 1, j]:
        behind = rupture(pressure, (couette[i + 1] - couette[i]) / conductance[i])
    if i == 1:
        if bearing.lands[k, START_PRESSURE] <= 0.0 and not bearing.conserving:
            before = min(1.0, rupture(pressure, (couette[1] - couette[0]) / conductance[0]))
    elif not wet[k, i - 1, j]:
        if bearing.conserving:
            void = grid.value[k, i - 1, j] / axial.root_weights[j]
            filling, lacking = conductance[i - 1] * pressure, couette[i - 1] * void
            if filling + lacking > 0.0:
                fill = min(max(filling / (filling + lacking), 0.0), 1.0)
        else:
            before = rupture(pressure, (couette[i - 1] - couette[i - 2]) / conductance[i - 1])
    return before, behind, fill, void


@inlined
def rupture(pressure, surplus):
    """Intervals from the last wet node to the end of the film."""
    return 0.5 + min(max(pressure / surplus, 0.0), 1.0) if surplus > 0.0 else 1.0
