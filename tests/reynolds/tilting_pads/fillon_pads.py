"""The bearing of Fillon, Bligoud and Frene (1992): four pads, 10 kN between two of them, ISO VG 32 at 40 degC."""

import math

import numpy as np

from babbitt.reynolds.heat.heat_model import JournalHeat
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pad_heat import PadBending, PadGrowth, PadHeat, PadWalls

SUPPLY = 313.15
LOAD = (0.0, -10e3)


def viscosity(temperature):
    """Of the oil, Pa s."""
    return 0.0277 * np.exp(-0.0341 * (np.asarray(temperature) - SUPPLY))


def fillon_bearing(rpm=4000.0, assembled=78.4e-6, angles=(45.0, 135.0, 225.0, 315.0)):
    """The bearing with pads of 20 mm."""
    pads = tuple(TiltingPad(math.radians(angle), math.radians(75.0), 148e-6, assembled, 0.02) for angle in angles)
    return TiltingPadBearing(0.1, 0.07, 0.0277, rpm * math.pi / 30.0, pads)


def fillon_heat(model, **changes):
    """A: all walls insulated. B: a journal with one temperature. C: pads conduct. D: and bend. E: and grow."""
    parts = {
        "viscosity": viscosity,
        "volumetric_heat_capacity": 860.0 * 1951.8,
        "conductivity": 0.149,
        "supply_temperature": SUPPLY,
        "journal": None if model == "A" else JournalHeat(),
        "walls": PadWalls() if model in "CDE" else None,
        "bending": PadBending() if model in "DE" else None,
        "growth": PadGrowth(SUPPLY) if model == "E" else None,
    }
    return PadHeat(**parts | changes)
