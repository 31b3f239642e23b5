"""Friction of lands and recesses.

Torque on a journal: integral of mu omega R^3/h over the lands, the pressure part (x F_y - y F_x)/2, and in the
recesses f mu omega R^2 A/depth. Rings likewise with the radius of each place. Ruptured film rubs as if full.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.answer import Answer
from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.reynolds.recess.recess_film import RecessFilm

__all__ = ["friction_power", "friction_torque", "land_friction_power"]

Array = NDArray[np.float64]


def friction_power(case: HydrostaticCase, found: Answer) -> float:
    """W."""
    shape = case.shape
    if isinstance(shape, RectangularPad):
        recess = case.recesses.friction_factor * shape.recess_area / case.recesses.depth
        return land_friction_power(case, found) + case.oil.viscosity * case.duty.sliding_speed**2 * recess
    return abs(friction_torque(case, found) * case.duty.angular_speed)


def land_friction_power(case: HydrostaticCase, found: Answer) -> float:
    """Part of the shear over the lands, W: what falls as the gap grows."""
    shape = case.shape
    if isinstance(shape, RectangularPad):
        gap = found.rest_gap + float(found.at[0])
        return case.oil.viscosity * case.duty.sliding_speed**2 * (shape.area - shape.recess_area) / gap
    return case.oil.viscosity * case.duty.angular_speed**2 * lands(case, found)


def friction_torque(case: HydrostaticCase, found: Answer) -> float:
    """Torque that brakes the runner, N m; positive for counter-clockwise rotation."""
    if case.duty.angular_speed == 0.0 or isinstance(case.shape, RectangularPad):
        return 0.0
    shear = case.oil.viscosity * case.duty.angular_speed
    recesses = case.recesses.friction_factor * recess_inertia(case) / case.recesses.depth
    return shear * (lands(case, found) + recesses) + pressure_torque(case, found)


def lands(case: HydrostaticCase, found: Answer) -> float:
    """Integral of r^2/h over the lands, m3."""
    if found.film is None:
        return quick_lands(case, found)
    return film_lands(found.film.film, found.at, case.reach)


def pressure_torque(case: HydrostaticCase, found: Answer) -> float:
    """Part of the pressure, by parts: exact for any rupture."""
    force, at = found.response.force, found.at
    if case.is_journal:
        return 0.5 * float(at[0] * force[1] - at[1] * force[0])
    if at.size == 3 and force.size == 3:
        return 0.5 * float(at[1] * force[2] - at[2] * force[1])
    return 0.0


def recess_inertia(case: HydrostaticCase) -> float:
    """Integral of r^2 over all recesses, m4."""
    shape = case.shape
    if isinstance(shape, RecessedJournal):
        return shape.count * shape.recess_area * shape.radius**2
    if isinstance(shape, CircularPad):
        return 0.5 * math.pi * shape.recess_radius**4
    if isinstance(shape, AnnularPad):
        return 0.5 * math.pi * (shape.recess_outer_radius**4 - shape.recess_inner_radius**4)
    assert isinstance(shape, ThrustRing)
    r = shape.radii
    whole = r.recess_outer_radius**4 - r.recess_inner_radius**4
    return len(shape.recess_angles) * 0.25 * shape.recess_extent * whole


def quick_lands(case: HydrostaticCase, found: Answer) -> float:
    """Integral of r^2/h over the lands, m3: of a journal as if the lands were all around."""
    shape, gap = case.shape, found.rest_gap
    if isinstance(shape, RecessedJournal):
        whole = 2.0 * math.pi * shape.radius * shape.width - shape.count * shape.recess_area
        depth = min(float(np.hypot(*found.at)) / shape.clearance, 0.999)
        return whole * shape.radius**2 / (shape.clearance * math.sqrt(1.0 - depth**2))
    if isinstance(shape, ThrustRing):
        r = shape.radii
        whole = 0.5 * math.pi * (r.outer_radius**4 - r.inner_radius**4)
        return (whole - recess_inertia(case)) / (gap + float(found.at[0]))
    return lands_of(shape).friction_area / (gap + float(found.at[0]))


def film_lands(film: RecessFilm, at: Array, radius: float) -> float:
    """Integral of r^2/h over the lands of a film at a position, m3; ``radius`` is the unit of the film's own."""
    of = film.of
    surface, scales = of.surface, of.scales
    lift = (at / scales.motion)[:, None] * surface.lever
    ha = surface.gap_a - surface.shape_a.T @ lift
    hb = surface.gap_b - surface.shape_b.T @ lift
    inverse = 0.5 * surface.step[:, None] * (1.0 / ha + 1.0 / hb) * on_land(film)
    whole = float((inverse @ (surface.share * surface.radius**2)).sum())
    return whole * scales.area * radius**2 / scales.gap


def on_land(film: RecessFilm) -> NDArray[np.bool_]:
    """Which points of which intervals lie on a land, shape (n, points)."""
    recess, mesh = film.of.recess, film.of.mesh
    lines = recess.shape[0]
    n = film.of.surface.step.size
    after = (np.arange(n) + 1) % lines
    starts = mesh.element_starts
    ends = np.append(starts[1:], mesh.points.size)
    land = np.ones((n, mesh.points.size), dtype=bool)
    for first, last in zip(starts, ends, strict=True):
        nodes = mesh.node_of_point[first:last]
        own = np.asarray((recess[:, nodes] >= 0).all(axis=1))
        drained = np.asarray((recess[:, nodes] == -2).all(axis=1))
        inside = (own[:n] & own[after] & (recess[:n, nodes[0]] == recess[after, nodes[0]])) | (
            drained[:n] & drained[after]
        )
        land[inside, first:last] = False
    return land
