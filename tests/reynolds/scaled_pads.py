"""Tilting pads in units in which dimensionless tables can be read off.

With R = 1 m, c_p = 1 m, omega = 1 rad/s and mu L = 1 Pa s m the unit of force mu omega (R/c_p)^2 R L is 1 N, of
length c_p is 1 m, of time 1 s: forces, stiffness and damping in SI are the dimensionless ones. The gap is
of course not small against the radius; no formula of the film knows. A pad with the inertia ``0.05 LEVER**2`` has
J/R_t^2 = 0.05.
"""

import math

import numpy as np

from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import RigidPivot

THICKNESS = 0.1
RIGID = RigidPivot()
LEVER = 2.0 + THICKNESS


def pad(angle, extent, fraction=0.5, preload=0.0, law=RIGID, **more):
    """Pad by its angles in degrees, on a pivot of some law."""
    return TiltingPad(
        math.radians(angle), math.radians(extent), 1.0, 1.0 - preload, THICKNESS, fraction, pivot=law, **more
    )


def bearing(pads, width_ratio, speed=1.0):
    """Bearing of scaled pads; ``width_ratio`` L/D."""
    width = 2.0 * width_ratio
    return TiltingPadBearing(2.0, width, 1.0 / width, speed, tuple(pads))


def directed(load, degrees):
    """Load in a direction."""
    return load * math.cos(math.radians(degrees)), load * math.sin(math.radians(degrees))


def turned(vector, angle):
    """A vector turned by an angle in rad."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]]) @ np.asarray(vector)


def one_pad(width_ratio=0.5, extent=80.0, fraction=0.5, preload=0.0, **more):
    """The single pads of the tables, pivot on +x."""
    return bearing((pad(0.0, extent, fraction, preload, **more),), width_ratio)


def five_pads(**more):
    """Five centred pads of 60 degrees, preload 0.3, L/D 0.5; the load points between the first two."""
    return bearing((pad(angle, 60.0, 0.5, 0.3, **more) for angle in (-126, -54, 18, 90, 162)), 0.5)


def four_pads(**more):
    """Four pads of 75 degrees, pivots at 55 %, preload 0.4, L/D 0.7."""
    return bearing((pad(angle, 75.0, 0.55, 0.4, **more) for angle in (-90, 0, 90, 180)), 0.7)


FIVE_LOAD = directed(2.0, -90.0)
FOUR_LOAD = directed(3.0, -70.0)
