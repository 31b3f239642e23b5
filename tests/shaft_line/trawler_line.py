"""The geared-diesel trawler line of the published study's reconstruction."""

import math

import numpy as np
from trawler_pads import SPEED, THRUST, bearing

from babbitt.kinds.shaft_line.excitation import RunoutHarmonic, ThrustHarmonic
from babbitt.kinds.shaft_line.line import Rod, ShaftLine
from babbitt.kinds.shaft_line.model import LineOperation
from babbitt.kinds.shaft_line.pads import PrescribedPads

ROD = Rod(30.0, math.pi / 4.0 * 0.36**2, 206e9, 7850.0)
RIPPLE = ThrustHarmonic(4.0, 50e3)
RUNOUT = RunoutHarmonic(1.0, 5e-6)
ANGLES = 2.0 * math.pi * np.arange(8) / 8


def line(damping: float = 8e4, **other) -> ShaftLine:
    return ShaftLine(14e3, damping, (ROD,), 8e3, **other)


def given_pads(
    ring: float = 2e10, pad_mass: float = 18.0, damped: float = 1.0, uneven: float = 0.4
) -> PrescribedPads:
    weight = 1.0 + uneven * np.cos(ANGLES)
    return PrescribedPads(tuple(2.5e9 * weight), tuple(damped * 1.8e8 * weight), ring, pad_mass)


def duty(**bearing_changes) -> LineOperation:
    return LineOperation(line(), bearing(**bearing_changes), THRUST, SPEED, (RIPPLE,), (RUNOUT,))
