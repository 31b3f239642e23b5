"""Kernel: coefficients of the turbulent film of a pad, whose oil is the thicker the wider the gap."""

from __future__ import annotations

from babbitt.reynolds._compiling import inner
from babbitt.reynolds.lands._grids import FAR, NEAR
from babbitt.reynolds.oil._turbulent_oil import thickened


@inner
def turbulent_coefficients(law, grid, k, e, eta, film):
    """Coefficients of the film of pad k at (e, eta), as ``_grids.film_coefficients`` with J_n = int f h^-n.

    f and g are the effective viscosities along and across, known at the Gauss points with their d ln / d ln h.
    """
    for array in (film.cubed, film.cubed_x, film.cubed_y, film.squeeze, film.inlet):
        array[:] = 0.0
    for i in range(film.conductance.size):
        half = 0.5 * grid.step[k, i]
        ca, sa, cb, sb = grid.cos_a[k, i], grid.sin_a[k, i], grid.cos_b[k, i], grid.sin_b[k, i]
        ha = grid.gap_a[k, i] - e * ca - eta * sa
        hb = grid.gap_b[k, i] - e * cb - eta * sb
        fa, fa_h = thickened(law, law[0] * ha, 0)
        fb, fb_h = thickened(law, law[0] * hb, 0)
        ga, ga_h = thickened(law, law[0] * ha, 1)
        gb, gb_h = thickened(law, law[0] * hb, 1)
        va, vb = 1.0 / ha, 1.0 / hb
        a2, b2 = fa * va * va, fb * vb * vb
        a3, b3 = a2 * va, b2 * vb
        per_j3 = 1.0 / (a3 + b3)
        conductance, couette = per_j3 / (12.0 * half), 0.5 * (a2 + b2) * per_j3
        film.conductance[i], film.couette[i] = conductance, couette
        # dh/de = -cos, dh/deta = -sin: d(f h^-n) = (n - f_h) f h^-(n+1) cos
        da3, db3 = (3.0 - fa_h) * a3 * va * per_j3, (3.0 - fb_h) * b3 * vb * per_j3
        da2, db2 = 0.5 * (2.0 - fa_h) * a3 * per_j3, 0.5 * (2.0 - fb_h) * b3 * per_j3
        j3_x, j3_y = ca * da3 + cb * db3, sa * da3 + sb * db3
        film.conductance_x[i], film.conductance_y[i] = -conductance * j3_x, -conductance * j3_y
        film.couette_x[i] = ca * da2 + cb * db2 - couette * j3_x
        film.couette_y[i] = sa * da2 + sb * db2 - couette * j3_y
        ha2, hb2 = half * ha * ha / ga, half * hb * hb / gb
        film.cubed[i] += NEAR * ha2 * ha + FAR * hb2 * hb
        film.cubed[i + 1] += FAR * ha2 * ha + NEAR * hb2 * hb
        ca2, cb2 = (3.0 - ga_h) * ha2, (3.0 - gb_h) * hb2
        film.cubed_x[i] -= NEAR * ca2 * ca + FAR * cb2 * cb
        film.cubed_x[i + 1] -= FAR * ca2 * ca + NEAR * cb2 * cb
        film.cubed_y[i] -= NEAR * ca2 * sa + FAR * cb2 * sb
        film.cubed_y[i + 1] -= FAR * ca2 * sa + NEAR * cb2 * sb
