"""The criterion of Routh and Hurwitz for a rigid journal, which the product judges by the roots themselves.

Equation of motion of a mass m carried by one film, about equilibrium: m r'' + C r' + K r = 0.
"""

from __future__ import annotations

import numpy as np


def hurwitz_margins(mass, stiffness, damping):
    """Coefficients a3..a0 of the quartic over a4, and the last Hurwitz determinant; all positive means stable."""
    (kxx, kxy), (kyx, kyy) = np.asarray(stiffness) / mass
    (cxx, cxy), (cyx, cyy) = np.asarray(damping) / mass
    a3 = cxx + cyy
    a2 = kxx + kyy + cxx * cyy - cxy * cyx
    a1 = kxx * cyy + kyy * cxx - kxy * cyx - kyx * cxy
    a0 = kxx * kyy - kxy * kyx
    return float(a3), float(a2), float(a1), float(a0), float(a1 * (a3 * a2 - a1) - a3**2 * a0)


def is_stable(mass, stiffness, damping):
    """Whether a rigid journal of this mass returns to its equilibrium (Routh-Hurwitz)."""
    return all(margin > 0.0 for margin in hurwitz_margins(mass, stiffness, damping))
