"""Friction number f/ψ of the model that the case chooses."""

from __future__ import annotations

import math

from babbitt.characteristics import BearingCurves, curves
from babbitt.characteristics.friction import film_around, film_on_arc, of_full_bearing
from babbitt.standards.iso7902.model import Friction


def friction_number(
    model: Friction, shape: BearingCurves, eccentricity_ratio: float, sommerfeld_number: float
) -> float:
    """Friction coefficient over relative clearance.

    Parameters
    ----------
    model : Friction
        Where the film rubs.
    shape : BearingCurves
        Characteristics of the bearing.
    eccentricity_ratio, sommerfeld_number : float
        Operating point.
    """
    if model is Friction.CURVE360:
        full = shape if shape.span_degrees == 360 else curves(360, shape.width_ratio)
        return of_full_bearing(eccentricity_ratio, full)
    attitude = shape.attitude_angle(eccentricity_ratio)
    if model is Friction.ARC:
        return film_on_arc(sommerfeld_number, eccentricity_ratio, attitude, math.radians(shape.span_degrees))
    return film_around(sommerfeld_number, eccentricity_ratio, attitude)
