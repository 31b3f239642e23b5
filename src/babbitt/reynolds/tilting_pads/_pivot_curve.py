"""Kernel: how far a pivot gives way under a load."""

from __future__ import annotations

import math

from babbitt.reynolds._compiling import compiled, inlined

# columns of a pivot: u = FACTOR P^EXPONENT + P (LINE - LINE_SLOPE ln P) + COMPLIANCE P, and a table
FACTOR, EXPONENT, LINE, LINE_SLOPE, COMPLIANCE = range(5)
CURVE_COLUMNS = 5


@compiled
def pivot_curve(curve, loads, displacements, load):
    """Displacement of a pivot under a load and its slope, by the columns of its law and its table (or none)."""
    if load <= 0.0:
        return 0.0, 0.0
    u = load * curve[COMPLIANCE]
    slope = curve[COMPLIANCE]
    if curve[FACTOR] > 0.0:
        part = curve[FACTOR] * load ** curve[EXPONENT]
        u += part
        slope += curve[EXPONENT] * part / load
    if curve[LINE_SLOPE] > 0.0:
        bent = curve[LINE] - curve[LINE_SLOPE] * math.log(load)
        u += load * bent
        slope += bent - curve[LINE_SLOPE]
    if loads.size > 1:
        s = 1
        while s < loads.size - 1 and loads[s] < load:
            s += 1
        rise = displacements[s] - displacements[s - 1]
        if rise > 0.0:  # zeros stand for no table beside pivots that have one
            part = rise / (loads[s] - loads[s - 1])
            u += displacements[s - 1] + (load - loads[s - 1]) * part
            slope += part
    return u, slope


@inlined
def is_elastic(curve, displacements):
    """Whether a pivot gives way."""
    elastic = curve[FACTOR] > 0.0 or curve[LINE_SLOPE] > 0.0 or curve[COMPLIANCE] > 0.0
    return elastic or (displacements.size > 1 and displacements[1] > 0.0)
