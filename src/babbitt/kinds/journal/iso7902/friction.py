"""Friction number f/ψ of the model that the case chooses, by its causes."""

from __future__ import annotations

import math

from babbitt.kinds.journal.iso7902.characteristics import BearingCurves, curves
from babbitt.kinds.journal.iso7902.characteristics.friction import (
    film_around,
    film_on_arc,
    of_full_bearing,
    of_pressure,
)
from babbitt.kinds.journal.iso7902.model import Friction


def friction_numbers(
    model: Friction,
    shape: BearingCurves,
    eccentricity_ratio: float,
    sommerfeld_number: float,
    attitude_angle: float,
) -> tuple[float, float]:
    """Friction coefficient over relative clearance, by shear of the oil and by the pressure on the journal.

    Parameters
    ----------
    model : Friction
        Where the film rubs.
    shape : BearingCurves
        Characteristics of the bearing.
    eccentricity_ratio, sommerfeld_number, attitude_angle : float
        Operating point; the angle in rad.
    """
    if model is Friction.CURVE360 and shape.span_degrees != 360:
        full = curves(360, shape.width_ratio)
        both, attitude_angle = of_full_bearing(eccentricity_ratio, full), full.attitude_angle(eccentricity_ratio)
    elif model is Friction.ARC:
        span = math.radians(shape.span_degrees)
        both = film_on_arc(sommerfeld_number, eccentricity_ratio, attitude_angle, span)
    else:
        both = film_around(sommerfeld_number, eccentricity_ratio, attitude_angle)
    pressure = of_pressure(eccentricity_ratio, attitude_angle)
    return both - pressure, pressure
