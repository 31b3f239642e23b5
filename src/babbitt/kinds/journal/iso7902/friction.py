"""Friction number f/ψ of the model that the case chooses, by its causes."""

from __future__ import annotations

import math

from babbitt.kinds.journal.iso7902.characteristics import BearingCurves, curves
from babbitt.kinds.journal.iso7902.characteristics.friction import FULL, of_pressure, of_shear, sheared_angle
from babbitt.kinds.journal.iso7902.model import Friction


def friction_numbers(
    model: Friction, shape: BearingCurves, eccentricity_ratio: float, sommerfeld_number: float
) -> tuple[float, float]:
    """Friction coefficient over relative clearance, by shear of the oil and by the pressure on the journal.

    Parameters
    ----------
    model : Friction
        Where the film rubs; `CURVE360` asks the full bearing of the same B/D at the same eccentricity.
    shape : BearingCurves
        Characteristics of the bearing.
    eccentricity_ratio, sommerfeld_number : float
        Operating point.
    """
    reach: float = FULL
    if model is Friction.CURVE360 and shape.span_degrees != 360:
        shape = curves(360, shape.width_ratio)
        sommerfeld_number = shape.sommerfeld_number(eccentricity_ratio)
    attitude_angle = shape.attitude_angle(eccentricity_ratio)
    if model is Friction.ARC:
        reach = sheared_angle(eccentricity_ratio, attitude_angle, math.radians(shape.span_degrees))
    shear = of_shear(reach, sommerfeld_number, eccentricity_ratio)
    return shear, of_pressure(eccentricity_ratio, attitude_angle)
