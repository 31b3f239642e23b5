"""Bearings that several tests use: their numbers are those of a prototype in finite volumes on graded grids."""

import math

import numpy as np

from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, ThrustRing
from babbitt.kinds.hydrostatic.impedance import Compressibility
from babbitt.kinds.hydrostatic.model import HydrostaticCase, Oil, OperatingConditions, Recesses
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.restrictors import Capillary, Orifice
from babbitt.kinds.hydrostatic.supply import FixedPressure
from babbitt.kinds.hydrostatic.surfaces import FilmOil, journal_surface, ring_surface

SPEED = 1500.0 * math.pi / 30.0
CIRCULAR = CircularPad(0.05, 0.025)
CIRCULAR_CAPILLARY = Capillary(0.6e-3, 0.06, 0.03)
CIRCULAR_ORIFICE = Orifice(0.4e-3, 870.0, 0.62)
ANNULAR = AnnularPad(0.05, 0.065, 0.085, 0.1)
RING = ThrustRing(ANNULAR, tuple(math.radians(45.0 + 90.0 * k) for k in range(4)), math.radians(60.0))
RING_FEEDING = Feeding((Capillary(0.8e-3, 0.06, 0.02),) * 4, FixedPressure(3e6))
CLEARANCE = 50e-6
CAPILLARY = Capillary(0.8e-3, 0.1, 0.02)


def journal(first=-90.0, number=4, land=30.0, groove=0.0):
    angles = tuple(math.radians(first + 360.0 * k / number) for k in range(number))
    return RecessedJournal(
        0.1, 0.1, CLEARANCE, angles, math.radians(360.0 / number - land), 0.07, math.radians(groove)
    )


def feeding(restrictor=CAPILLARY, number=4, supply=None):
    return Feeding((restrictor,) * number, supply or FixedPressure(5e6))


def journal_film(bearing, speed=0.0, viscosity=0.02):
    return lambda grid: journal_surface(bearing, FilmOil(viscosity, speed, 5e6), grid)


def ring_film(ring, gap=50e-6, speed=0.0):
    return lambda grid: ring_surface(ring, gap, FilmOil(0.02, speed, 3e6), grid)


def down(eps):
    return np.array([0.0, -eps * CLEARANCE])


def case(shape=None, duty=None, method="film", kind="hydrostatic_journal", fed=None, oil=None, **changes):
    shape = journal() if shape is None else shape
    given = {
        "name": "Test",
        "kind": kind,
        "method": method,
        "shape": shape,
        "feeding": fed or feeding(),
        "oil": oil or Oil(0.02, 870.0, 2000.0),
        "duty": duty or OperatingConditions(20e3, -0.5 * math.pi, angular_speed=SPEED),
        "recesses": Recesses(1e-3),
        "compressibility": Compressibility(3.6651914e-6, 1e9),
        "accuracy": "draft",
    }
    return HydrostaticCase(**(given | changes))
