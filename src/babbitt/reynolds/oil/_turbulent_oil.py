"""Kernels: by how much turbulence thickens an oil, as `turbulence.FilmTurbulence.kernel_row` has it.

A law holds the Reynolds number of a unit gap at unit viscosity, onset and end, then a and b of a Re^b along the
motion, across it, and of the shear.
"""

from __future__ import annotations

from babbitt.reynolds._compiling import inlined, inner


@inner
def thickened(law, number, direction):
    """Effective over true viscosity at a Reynolds number, along (0) or across (1), and its d ln / d ln Re.

    1 + w a Re^b / 12; the weight w rises from onset to end as 3 t^2 - 2 t^3.
    """
    if number <= law[1]:
        return 1.0, 0.0
    factor, exponent = law[3 + 2 * direction], law[4 + 2 * direction]
    excess = factor * number**exponent / 12.0
    weight, growth = 1.0, 0.0
    if number < law[2]:
        t = (number - law[1]) / (law[2] - law[1])
        weight, growth = t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) * number / (law[2] - law[1])
    total = 1.0 + weight * excess
    return total, excess * (weight * exponent + growth) / total


@inlined
def stirred(law, number):
    """Turbulent over laminar shear at a Reynolds number, as ``turbulence.FilmTurbulence.shear_factor``."""
    t = min(max((number - law[1]) / (law[2] - law[1]), 0.0), 1.0)
    return 1.0 + t * t * (3.0 - 2.0 * t) * law[7] * number ** law[8]
