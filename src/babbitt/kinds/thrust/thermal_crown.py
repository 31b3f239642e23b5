"""The crown that heat gives a plane pad: it is hotter at its face than at its back and bends over it.

A pad of thickness t with the difference dT through it takes the curvature alpha dT/t; over the length B along the
motion its edges stand alpha dT B^2/(8 t) farther from the collar than its middle. Plane pads on a pivot in their
middle carry by that, and by the bending under load, which is left out here: it adds to the crown.

dT is an assumption. The heat that goes through a pad leaves by its back, dT = (T_film - T_oil) (t/k)/(t/k + 1/h),
and what decides is the heat transfer h from the back to the oil of the housing, which no case gives: with 50
W/(m K), 60 mm and 100 to 300 W/(m2 K) a film 30 K above the oil has 3 to 8 K.
"""

from __future__ import annotations

__all__ = ["ASSUMED_DIFFERENCE", "ASSUMED_SLENDERNESS", "EXPANSION", "thermal_crown"]

EXPANSION = 12e-6
"""alpha of steel, 1/K, a textbook value."""
ASSUMED_DIFFERENCE = 5.0
"""dT from face to back of a pad, K: an assumption."""
ASSUMED_SLENDERNESS = 3.0
"""B/t of a pad: an assumption; main thrust bearings of ships have about 3."""


def thermal_crown(length: float, difference: float = ASSUMED_DIFFERENCE) -> float:
    """How much farther the edges of a pad stand from the collar than its middle, m.

    Parameters
    ----------
    length : float
        B: of the pad along the motion at its mean radius, m.
    difference : float
        dT from its face to its back, K.

    >>> f"{1e6 * thermal_crown(0.1775):.2f}"
    '3.99'
    """
    thickness = length / ASSUMED_SLENDERNESS
    return EXPANSION * difference * length**2 / (8.0 * thickness)
