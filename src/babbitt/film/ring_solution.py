"""From a settled ring to a solution in SI: pressures, supply flows, friction."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.film._equilibrium import CONVERGED, NO_FILM
from babbitt.film._surface_film import Surface
from babbitt.film._surface_forces import carry_streamers
from babbitt.film.general import SettledRing
from babbitt.film.model import Field, JournalFilm, Land
from babbitt.film.piezoviscosity import pressure_of
from babbitt.film.scales import Scales
from babbitt.film.solution import FilmSolution
from babbitt.results import Outcome

__all__ = ["mirrored", "ring_solution"]

Array = NDArray[np.float64]


def mirrored(film: JournalFilm) -> JournalFilm:
    """The bearing seen in the mirror theta -> -theta: a clockwise journal turns counter-clockwise."""

    def flip(land: Land) -> Land:
        return replace(
            land,
            start_angle=-land.end_angle,
            end_angle=-land.start_angle,
            centre=(land.centre[0], -land.centre[1]),
            start_pressure=land.end_pressure,
            end_pressure=land.start_pressure,
            profile=land.profile[::-1],
        )

    def reverse(field: Field) -> Field:
        return (field[0], *field[:0:-1]) if field else ()

    return replace(
        film,
        angular_speed=-film.angular_speed,
        lands=tuple(flip(land) for land in film.lands),
        pockets=tuple(replace(pocket, centre_angle=-pocket.centre_angle) for pocket in film.pockets),
        steps=tuple(replace(step, centre_angle=-step.centre_angle) for step in film.steps),
        misalignment=(film.misalignment[0], -film.misalignment[1]),
        viscosity_field=reverse(film.viscosity_field),
        displacement=reverse(film.displacement),
    )


def ring_solution(film: JournalFilm, scales: Scales, settled: SettledRing, begun: float) -> FilmSolution:
    """Everything in SI and in the fixed frame.

    Supply flows come one per groove, then one per pocket; each is the sum of the balances of the nodes it holds.
    """
    sample, ring = settled.sample, settled.sample.ring
    work, supply = sample.work, ring.supply
    if not ring.surface.conserving and ring.surface.speed > 0.0:
        carry_streamers(ring.surface, sample.film, work)
    count = int(supply.max()) + 1
    flows = np.array([work.row[supply == number].sum() for number in range(count)])
    side = -work.row[supply == -2].sum()
    free = np.abs(work.row[(supply == -1) & work.counts])
    passing = max(np.maximum(flows, 0.0).sum(), float(sample.film.couette.sum(axis=1).max()))
    torque_journal, torque_bearing = friction(settled)
    frame = np.diag(scales.sense)
    unit = scales.force / scales.length
    outcome = {CONVERGED: Outcome.CONVERGED, NO_FILM: Outcome.OVERLOADED}.get(
        settled.status, Outcome.NOT_CONVERGED
    )
    lines = work.pressure.shape[0]
    return FilmSolution(
        film=film,
        outcome=outcome,
        position=scales.sense * settled.position * scales.length,
        force=scales.sense * sample.force * scales.force,
        stiffness=frame @ sample.stiffness @ frame * unit,
        damping=frame @ sample.damping @ frame * (unit / scales.rate),
        minimum_film_thickness=settled.gap * scales.length,
        angles=scales.sense[1] * ring.theta[None, :lines],
        axial_positions=ring.mesh.nodes * (0.5 * film.width),
        pressure=true_pressures(ring.surface, work.pressure)[None] * scales.pressure + film.cavitation_pressure,
        void=1.0 - work.fill[None],
        supply_flow=flows * scales.flow,
        outflow=np.zeros(count),
        side_flow=np.array([side * scales.flow]),
        friction_torque=torque_journal * scales.torque,
        bearing_torque=torque_bearing * scales.torque,
        mass_balance_error=float(free.sum() / max(passing, 1e-300)),
        iterations=settled.steps,
        wall_time=time.perf_counter() - begun,
    )


def friction(settled: SettledRing) -> tuple[float, float]:
    """Torques on journal and bearing: Couette shear with the liquid fraction, and -+ (h/2) dp/dtheta.

    Grooves, pockets and holes are deep beside the film: the oil in them is not sheared.
    """
    sample, surface = settled.sample, settled.sample.ring.surface
    work, node = sample.work, surface.node
    lift = settled.position[:, None] * surface.lever
    ha, hb = surface.gap_a - surface.shape_a.T @ lift, surface.gap_b - surface.shape_b.T @ lift
    n = surface.step.size
    after = (np.arange(n) + 1) % work.pressure.shape[0]
    half = 0.5 * surface.step[:, None]
    viscosity = surface.viscosity * (0.5 * (work.stiffening[:n] + work.stiffening[after]))[:, node]
    factors = [np.ones_like(ha)] * 2
    turbulence = settled.film.turbulence
    if turbulence is not None:
        factors = [turbulence.shear_factor(surface.turbulence[0] * gap / viscosity) for gap in (ha, hb)]
    shear = surface.speed * viscosity * half * (factors[0] / ha + factors[1] / hb) * work.fill[:n][:, node]
    shear[_in_hollow(settled, after)] = 0.0
    pressure = true_pressures(surface, work.pressure)
    slope = 0.25 * (ha + hb) * (pressure[after] - pressure[:n])[:, node]
    couette, hydraulic = float((shear @ surface.share).sum()), float((slope @ surface.share).sum())
    return couette + hydraulic, couette - hydraulic


def true_pressures(surface: Surface, reduced: Array) -> Array:
    """Pressures above cavitation from the reduced ones that the kernels solve for."""
    return pressure_of(surface.piezo, reduced) if surface.piezo.size else reduced


def _in_hollow(settled: SettledRing, after: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether a piece of the surface, one interval long and one axial element wide, lies in a hollow.

    Elements end at the edges of hollows, so a piece lies in one when every node around it is held by a supply; the
    nodes on the sides of a groove as wide as the bearing are held by the surroundings instead.
    """
    ring = settled.sample.ring
    held, node = ring.supply, ring.surface.node
    lines = np.arange(after.size)
    starts = ring.mesh.element_starts
    fed = (held[lines] >= 0) & (held[after] >= 0)
    closed = fed | ((held[lines] == -2) & (held[after] == -2))
    inside = np.logical_and.reduceat(closed[:, node], starts, axis=1)
    inside &= np.logical_or.reduceat(fed[:, node], starts, axis=1)
    return np.repeat(inside, np.diff(np.append(starts, ring.mesh.points.size)), axis=1)
