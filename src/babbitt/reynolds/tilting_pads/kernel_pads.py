"""Pads in SI to the frames and units of the kernels."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds._structs import LAND_COLUMNS, Bearing
from babbitt.reynolds.lands.profiles import common_profiles
from babbitt.reynolds.tilting_pads._pivot_curve import CURVE_COLUMNS
from babbitt.reynolds.tilting_pads._structs import Pads
from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing
from babbitt.reynolds.tilting_pads.pivots import Curve

__all__ = ["PadScales", "kernel_pads", "pad_widths", "turbulence_rows"]

Array = NDArray[np.float64]


class PadScales:
    """Units of the dimensionless bearing: those of its first pad.

    Attributes
    ----------
    length, pressure, force, torque, flow : float
        c_p of the first pad, mu omega (R/c_p)^2, mu omega (R/c_p)^2 R L, mu omega R^3 L/c_p, omega R c_p L.
    rate : float
        rad/s.
    sense : ndarray, shape (2,)
        What mirrors a vector into the counter-clockwise world and back.
    """

    def __init__(self, bearing: TiltingPadBearing) -> None:
        radius, width = bearing.radius, bearing.width
        self.length = bearing.pads[0].clearance
        self.rate = abs(bearing.angular_speed)
        self.pressure = bearing.viscosity * self.rate * (radius / self.length) ** 2
        self.force = self.pressure * radius * width
        self.torque = bearing.viscosity * self.rate * radius**3 * width / self.length
        self.flow = self.rate * radius * self.length * width
        self.sense = np.array([1.0, bearing.sense])


def kernel_pads(bearing: TiltingPadBearing, scales: PadScales) -> Pads:
    """Pads in the frames and units of the kernels; their bores stay as they are."""
    count = len(bearing.pads)
    lands, curves = np.zeros((count, LAND_COLUMNS)), np.zeros((count, CURVE_COLUMNS))
    profiles = common_profiles([pad.profile[:: int(bearing.sense)] for pad in bearing.pads]) / scales.length
    laws = [pad.pivot.curve() for pad in bearing.pads]
    points = max(len(law.loads) for law in laws)
    loads, displacements = np.zeros((count, points)), np.zeros((count, points))
    kappa, weight, angle, offset, rotational, neutral = np.zeros((6, count))
    plain, centred = np.zeros((2, count), dtype=bool)
    for k, pad in enumerate(bearing.pads):
        width = bearing.width if pad.width is None else pad.width
        thickness = 1.0 if pad.viscosity is None else pad.viscosity / bearing.viscosity
        kappa[k] = (bearing.diameter / width) ** 2 / 12.0
        weight[k] = thickness * width / bearing.width
        angle[k] = bearing.sense * pad.pivot_angle
        lands[k, :2] = -pad.pivot_fraction * pad.extent, (1.0 - pad.pivot_fraction) * pad.extent
        lands[k, 2] = pad.clearance / scales.length
        lands[k, 5:] = bearing.groove_pressure / (scales.pressure * thickness)
        offset[k] = (pad.clearance - pad.assembled_clearance) / scales.length
        rotational[k] = tangential_spring(bearing, pad) * scales.length / scales.force
        neutral[k] = bearing.sense * bearing.lever(pad) * pad.rest_tilt / scales.length
        fill_curve(laws[k], scales, curves[k], loads[k], displacements[k])
        plain[k] = not pad.profile and bearing.groove_pressure == 0.0
        centred[k] = plain[k] and abs(pad.pivot_fraction - 0.5) < 1e-12
    return Pads(
        Bearing(lands, profiles, math.nan, 1.0, 0.0, False, True, 1.0), kappa, weight, np.cos(angle),
        np.sin(angle), offset, rotational, neutral, curves, loads, displacements, centred, plain,
        np.ones((count, 0)), np.ones((count, 0)), turbulence_rows(bearing, scales),
    )  # fmt: skip


def turbulence_rows(bearing: TiltingPadBearing, scales: PadScales) -> Array:
    """Law of the turbulence of every pad as the kernels take it, one of no numbers for laminar films."""
    if bearing.turbulence is None:
        return np.zeros((len(bearing.pads), 0))
    thinned = bearing.turbulence.density * scales.rate * bearing.radius * scales.length
    own = (bearing.viscosity if pad.viscosity is None else pad.viscosity for pad in bearing.pads)
    return np.array([bearing.turbulence.kernel_row(thinned / viscosity) for viscosity in own])


def tangential_spring(bearing: TiltingPadBearing, pad: TiltingPad) -> float:
    """Stiffness against eta, N/m: of the flexure at the lever of the pivot, in series with the tangential one."""
    flexure = pad.rotational_stiffness / bearing.lever(pad) ** 2
    return flexure / (1.0 + flexure / pad.tangential_stiffness)


def fill_curve(curve: Curve, scales: PadScales, row: Array, loads: Array, displacements: Array) -> None:
    """Displacement of a pivot in the units of the kernels."""
    row[:] = curve.columns(scales.force, scales.length)
    if curve.loads:
        given = len(curve.loads)
        loads[:given] = np.asarray(curve.loads) / scales.force
        displacements[:given] = np.asarray(curve.displacements) / scales.length
        slope = (displacements[given - 1] - displacements[given - 2]) / (loads[given - 1] - loads[given - 2])
        for place in range(given, loads.size):  # the last piece goes on
            loads[place] = 2.0 * loads[place - 1]
            displacements[place] = displacements[place - 1] + slope * (loads[place] - loads[place - 1])


def pad_widths(bearing: TiltingPadBearing) -> Array:
    """Width of every pad, m."""
    return np.array([bearing.width if pad.width is None else pad.width for pad in bearing.pads])
