"""Nodes, metric and gap of a thrust pad for the kernels (``_surface_film``), and shear on its runner."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.lands.axial import AxialMesh, element_axial_mesh
from babbitt.reynolds.model import END_DAM, Cavitation
from babbitt.reynolds.surface._surface_film import Surface, SurfaceWork, liquid
from babbitt.reynolds.surface.unwrapped_mesh import gauss_angles

if TYPE_CHECKING:
    from babbitt.reynolds.sector.sector import PlaneMotion, SectorPad

Array = NDArray[np.float64]


def sector_mesh(pad: SectorPad, degree: int) -> AxialMesh:
    """Elements across the pad; short ones at its sides where oil under pressure enters at the leading edge."""
    inner = pad.inner_radius / pad.outer_radius
    if pad.leading_pressure <= 0.0:
        return element_axial_mesh((inner, 1.0), (degree,))
    dam = END_DAM * (1.0 - inner)
    return element_axial_mesh((inner, inner + dam, 1.0 - dam, 1.0), (2, degree, 2))


def reference_height(pad: SectorPad, gap: PlaneMotion) -> float:
    """Gap in the middle of the pad, m, in which gaps are measured: that at the axis may be none at all."""
    middle, angle = 0.5 * (pad.inner_radius + pad.outer_radius), 0.5 * pad.extent
    there = gap.height + middle * (gap.slope_x * math.cos(angle) + gap.slope_y * math.sin(angle))
    return there if there > 0.0 else max(abs(there), abs(gap.height))


def sector_surface(pad: SectorPad, theta: Array, mesh: AxialMesh, height: float, unit: float) -> Surface:
    """Nodes and metric of a pad; gaps in ``height``, pressures in ``unit``."""
    a, b = gauss_angles(theta)
    radius = mesh.points
    weights = mesh.share * (1.0 - pad.inner_radius / pad.outer_radius)
    held = np.zeros((theta.size, mesh.nodes.size), dtype=bool)
    held[0], held[-1], held[:, 0], held[:, -1] = True, True, True, True
    pressure = np.zeros(held.shape)
    inner = pad.inner_radius / pad.outer_radius
    aside = np.minimum(mesh.nodes - inner, 1.0 - mesh.nodes) / (1.0 - inner)
    pressure[0] = np.clip(aside / END_DAM, 0.0, 1.0) * pad.leading_pressure / unit
    ones = np.ones((theta.size - 1, radius.size))
    law = np.zeros(0) if pad.turbulence is None else pad.turbulence.kernel_row(unit_reynolds(pad, height))
    return Surface(
        nodes=mesh.nodes.size,
        points=radius.size,
        motions=3,
        step=np.diff(theta),
        shape_a=np.array([np.ones_like(a), np.cos(a), np.sin(a)]),
        shape_b=np.array([np.ones_like(b), np.cos(b), np.sin(b)]),
        lever=np.array([np.ones_like(radius), radius, radius]),
        gap_a=1.0 + form_at(pad, a, radius) / height,
        gap_b=1.0 + form_at(pad, b, radius) / height,
        opening_a=0.0 * ones, opening_b=0.0 * ones,
        viscosity=ones, drag=ones.copy(), turbulence=law, radius=radius, share=weights * radius,
        along=weights / radius, node=mesh.node_of_point, slope=mesh.slope, held=held, held_pressure=pressure,
        held_fill=np.ones(held.shape), piezo=np.zeros((3, 0)), cyclic=False, reference=0.0, kappa=1.0 / 12.0,
        speed=1.0, conserving=pad.cavitation is Cavitation.MASS_CONSERVING,
    )  # fmt: skip


def unit_reynolds(pad: SectorPad, height: float) -> float:
    """Reynolds number of a gap of ``height`` at the outer radius; 0 for a laminar film."""
    if pad.turbulence is None:
        return 0.0
    return pad.turbulence.density * pad.angular_speed * pad.outer_radius * height / pad.viscosity


def form_at(pad: SectorPad, angle: Array, radius: Array) -> Array:
    """Departure from the plane, m, linear between its values, shape (angles, radii)."""
    if not pad.form:
        return np.zeros((angle.size, radius.size))
    inner = pad.inner_radius / pad.outer_radius
    return _between_values(pad.form, (pad.extent, inner), angle.tobytes(), radius.tobytes())


@lru_cache(maxsize=16)
def _between_values(
    form: tuple[tuple[float, ...], ...], sides: tuple[float, float], angles: bytes, radii: bytes
) -> Array:
    """The same by value: a pad has many films at few places. The result is read only."""
    from scipy.interpolate import RegularGridInterpolator

    values = np.asarray(form)
    rows, columns = np.linspace(0.0, sides[0], values.shape[0]), np.linspace(sides[1], 1.0, values.shape[1])
    places = np.meshgrid(np.frombuffer(angles), np.frombuffer(radii), indexing="ij")
    made = np.asarray(RegularGridInterpolator((rows, columns), values)(np.stack(places, axis=-1)))
    made.flags.writeable = False
    return made


def runner_torque(pad: SectorPad, surface: Surface, work: SurfaceWork, at: Array) -> float:
    """Integral of r (r mu/h + h/(2 r) dp/dtheta) r dr dtheta over mu omega R^4 / h_0."""
    pressure, fill = work.pressure, liquid(work.fill)
    lift = at[:, None] * surface.lever
    ha, hb = surface.gap_a - surface.shape_a.T @ lift, surface.gap_b - surface.shape_b.T @ lift
    node, radius = surface.node, surface.radius
    half = 0.5 * surface.step[:, None]
    sheared = 1.0 / ha + 1.0 / hb
    if pad.turbulence is not None:
        reynolds = surface.turbulence[0] * radius
        sheared = pad.turbulence.shear_factor(reynolds * ha) / ha + pad.turbulence.shear_factor(reynolds * hb) / hb
    shear = surface.viscosity * half * sheared * fill[:-1][:, node] * radius**2
    slope = 0.25 * (ha + hb) * np.diff(pressure, axis=0)[:, node]
    return float(((shear + slope) @ surface.share).sum())
