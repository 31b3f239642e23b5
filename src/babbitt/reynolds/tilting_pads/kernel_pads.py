"""Pads in SI to the frames and units of the kernels."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds._structs import Bearing
from babbitt.reynolds.lands.profiles import common_profiles
from babbitt.reynolds.tilting_pads._structs import Pads
from babbitt.reynolds.tilting_pads.pivots import Curve

if TYPE_CHECKING:
    from babbitt.reynolds.tilting_pads.model import TiltingPad, TiltingPadBearing

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
    answers : ndarray, shape (10,)
        Of force, stiffness and damping of a film in (xi, eta), each mirrored back.
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
        sense, stiff = bearing.sense, self.force / self.length
        damp = stiff / self.rate
        self.answers = np.array((
            self.force, sense * self.force, stiff, sense * stiff, sense * stiff, stiff,
            damp, sense * damp, sense * damp, damp,
        ))  # fmt: skip


def kernel_pads(bearing: TiltingPadBearing, scales: PadScales) -> Pads:
    """Pads in the frames and units of the kernels; their bores stay as they are."""
    count, sense = len(bearing.pads), bearing.sense
    profiles = common_profiles([pad.profile[:: int(sense)] for pad in bearing.pads]) / scales.length
    laws = [pad.pivot.curve() for pad in bearing.pads]
    points = max(len(law.loads) for law in laws)
    loads, displacements = np.zeros((count, points)), np.zeros((count, points))
    lands, numbers, plain, centred = [], [], [], []  # lists become arrays at once: every array costs a microsecond
    for k, (pad, law) in enumerate(zip(bearing.pads, laws, strict=True)):
        width = bearing.width_of(pad)
        thickness = 1.0 if pad.viscosity is None else pad.viscosity / bearing.viscosity
        groove = bearing.groove_pressure / (scales.pressure * thickness)
        lands.append((
            -pad.pivot_fraction * pad.extent, (1.0 - pad.pivot_fraction) * pad.extent,
            pad.clearance / scales.length, 0.0, 0.0, groove, groove,
        ))  # fmt: skip
        numbers.append((
            (bearing.diameter / width) ** 2 / 12.0,
            thickness * width / bearing.width,
            sense * pad.pivot_angle,
            (pad.clearance - pad.assembled_clearance) / scales.length,
            tangential_spring(bearing, pad) * scales.length / scales.force,
            sense * bearing.lever(pad) * pad.rest_tilt / scales.length,
        ))  # fmt: skip
        plain.append(not pad.profile and bearing.groove_pressure == 0.0)
        centred.append(plain[k] and abs(pad.pivot_fraction - 0.5) < 1e-12)
        if law.loads:
            fill_table(law, scales, loads[k], displacements[k])
    kappa, weight, angle, offset, rotational, neutral = np.array(list(zip(*numbers, strict=True)))
    return Pads(
        Bearing(np.array(lands), profiles, math.nan, 1.0, 0.0, False, True, 1.0), kappa, weight, np.cos(angle),
        np.sin(angle), offset, rotational, neutral,
        np.array([law.columns(scales.force, scales.length) for law in laws]), loads, displacements,
        np.array(centred), np.array(plain), np.zeros((count, 0)), np.zeros((count, 0)),
        turbulence_rows(bearing, scales),
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


def fill_table(curve: Curve, scales: PadScales, loads: Array, displacements: Array) -> None:
    """Table of a pivot in the units of the kernels."""
    given = len(curve.loads)
    loads[:given] = np.asarray(curve.loads) / scales.force
    displacements[:given] = np.asarray(curve.displacements) / scales.length
    slope = (displacements[given - 1] - displacements[given - 2]) / (loads[given - 1] - loads[given - 2])
    for place in range(given, loads.size):  # the last piece goes on
        loads[place] = 2.0 * loads[place - 1]
        displacements[place] = displacements[place - 1] + slope * (loads[place] - loads[place - 1])


def pad_widths(bearing: TiltingPadBearing) -> Array:
    """Width of every pad, m."""
    return np.array([bearing.width_of(pad) for pad in bearing.pads])
