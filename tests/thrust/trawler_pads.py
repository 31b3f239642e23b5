"""The pad and the bearing of the geared-diesel trawler line of the published study's reconstruction."""

import math

from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.state import TiltInertia

SPEED = 125.0 * math.pi / 30.0
VISCOSITY = 0.045
PAD = ThrustPad(0.190, 0.375, math.radians(36.0), 0.290, 0.60)
INERTIA = TiltInertia(0.06, 0.05)
THRUST = 500e3


def bearing(ring: float = 2e10, tilt: float = 30e-6, direction: float = 0.0, **other) -> ThrustBearing:
    return ThrustBearing(PAD, 8, ring, 18.0, INERTIA, HousingTilt(tilt, direction), **other)
