"""What the cases of the geared-diesel trawler line share: pad, bearing, line and excitations."""

from __future__ import annotations

import math
from functools import lru_cache

from babbitt.kinds.shaft_line.excitation import RunoutHarmonic, ThrustHarmonic
from babbitt.kinds.shaft_line.line import Rod, ShaftLine
from babbitt.kinds.shaft_line.model import LineOperation
from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.load_curve import LoadCurve, carrying
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.state import TiltInertia

SPEED = 125.0 * math.pi / 30.0
VISCOSITY = 0.045
PAD = ThrustPad(0.190, 0.375, math.radians(36.0), 0.290, 0.60)
ROD = Rod(30.0, 0.25 * math.pi * 0.36**2, 206e9, 7850.0)
RIPPLE = ThrustHarmonic(4.0, 50e3)
RUNOUT = RunoutHarmonic(1.0, 5e-6)


def line() -> ShaftLine:
    """Propeller 14 t, shaft 30 m, collar with gear wheel 8 t."""
    return ShaftLine(14e3, 8e4, (ROD,), 8e3)


def duty() -> LineOperation:
    """Base case: 500 kN, 125 rpm, tilt 30 um, runout 5 um, ripple 10 %."""
    bearing = ThrustBearing(PAD, 8, 2e10, 18.0, TiltInertia(0.06, 0.05), HousingTilt(30e-6))
    return LineOperation(line(), bearing, 500e3, SPEED, (RIPPLE,), (RUNOUT,))


@lru_cache
def films() -> LoadCurve:
    """Films of one pad at 45 mPa s."""
    return carrying(PAD, VISCOSITY, SPEED)
