"""From a converged ring to a solution in SI: pressures, supply flows, friction."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.reynolds.lands._equilibrium import CONVERGED, NO_FILM
from babbitt.reynolds.model import Field, FilmStart, JournalFilm, Land
from babbitt.reynolds.oil.piezoviscosity import pressure_of
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface._surface_film import Surface, SurfaceFilm, SurfaceWork, liquid
from babbitt.reynolds.surface._surface_forces import carry_streamers, drain_edge
from babbitt.reynolds.surface.closed_pocket_coefficients import closed_coefficients
from babbitt.reynolds.surface.surface_equilibrium import OUT_OF_WORK, SurfaceEquilibrium
from babbitt.reynolds.surface.unwrapped_mesh import UnwrappedMesh, groove_lines

__all__ = ["mirrored", "outcome_of", "ring_solution", "solution_of"]

Array = NDArray[np.float64]


OUTCOMES = {CONVERGED: Outcome.CONVERGED, NO_FILM: Outcome.OVERLOADED, OUT_OF_WORK: Outcome.WORK_BOUND}


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
        field_start=-film.field_start,
    )


def ring_solution(film: JournalFilm, scales: Scales, settled: SurfaceEquilibrium, begun: float) -> FilmSolution:
    """Everything in SI and in the fixed frame, once the streamers of the film are carried to its end."""
    sample, ring = settled.sample, settled.sample.ring
    if not ring.surface.conserving and ring.surface.speed > 0.0:
        carry_streamers(ring.surface, sample.film, sample.work)
    drain_sides(ring, sample.film, sample.work)
    return solution_of(film, scales, settled, friction(settled), begun)


def solution_of(
    film: JournalFilm,
    scales: Scales,
    settled: SurfaceEquilibrium,
    torques: tuple[float, float, float],
    begun: float,
) -> FilmSolution:
    """Everything in SI and in the fixed frame; ``torques`` on journal and bearing, and the part of both by
    streamers, dimensionless."""
    sample, ring = settled.sample, settled.sample.ring
    stiffness, damping = closed_coefficients(settled)
    work, along = sample.work, flux_along(settled)
    flows = flows_of(settled, along)
    free = np.abs(work.row[ring.supply == -1])
    passing = max(np.maximum(flows.supplies, 0.0).sum(), float(np.abs(flows.entering).sum()))
    if ring.surface.cyclic:  # little may pass the seam
        passing = max(passing, float(np.abs(along).sum(axis=1).max()))
    frame = np.diag(scales.sense)
    unit = scales.force / scales.length
    lines = work.pressure.shape[0]
    return FilmSolution(
        film=film,
        outcome=outcome_of(settled),
        position=scales.sense * settled.position * scales.length,
        force=scales.sense * sample.force * scales.force,
        stiffness=frame @ stiffness @ frame * unit,
        damping=frame @ damping @ frame * (unit / scales.rate),
        minimum_film_thickness=settled.gap * scales.length,
        angles=scales.sense[1] * ring.theta[None, :lines],
        axial_positions=ring.mesh.nodes * (0.5 * film.width),
        pressure=true_pressures(ring.surface, work.pressure)[None] * scales.pressure + film.cavitation_pressure,
        void=1.0 - liquid(work.fill)[None],
        supply_flow=flows.supplies[supply_order(film, settled.film)] * scales.flow,
        inflow=flows.entering * scales.flow,
        outflow=flows.leaving * scales.flow,
        side_flow=np.array([flows.sides.sum() * scales.flow]),
        end_flows=flows.sides * scales.flow,
        side_inflow=flows.drawn * scales.flow,
        friction_torque=torques[0] * scales.torque,
        bearing_torque=torques[1] * scales.torque,
        streamer_torque=torques[2] * scales.torque,
        mass_balance_error=float(free.sum() / max(passing, 1e-300)),
        iterations=settled.steps,
        wall_time=time.perf_counter() - begun,
        axial_breaks=ring.mesh.breaks,
    )


def outcome_of(settled: SurfaceEquilibrium) -> Outcome:
    """How the search ended; beyond the law of viscosity and pressure a film counts as overloaded."""
    surface, work = settled.sample.ring.surface, settled.sample.work
    if surface.piezo.size and work.pressure.max() > surface.piezo[0, -1]:
        return Outcome.OVERLOADED
    return OUTCOMES.get(settled.status, Outcome.NOT_CONVERGED)


@dataclass(frozen=True)
class SurfaceFlows:
    """Flows of a ring, dimensionless: from supplies, to both sides and drawn in there, into and out of lands."""

    supplies: Array
    sides: Array
    drawn: float
    entering: Array
    leaving: Array


def flows_of(settled: SurfaceEquilibrium, along: Array) -> SurfaceFlows:
    """Flows from the balances of the nodes that are held, and the flux ``along`` the film (``flux_along``).

    The nodes on the sides of a groove between lands are held by the surroundings; what they send along the film
    comes from the groove nevertheless, and only what crosses the side itself counts as side flow.
    """
    ring, work = settled.sample.ring, settled.sample.work
    edges, count = list(ring.mesh.side_nodes), len(ring.groove_lines) + len(settled.film.pockets)
    supplies = np.bincount(ring.supply.ravel() + 2, work.row.ravel(), minlength=count + 2)[2:].astype(float)
    if len(edges) == 1:  # a hole beyond the mid-plane is seen in its image on this side
        supplies = 0.5 * (supplies + supplies[twins(settled.film, len(ring.groove_lines))])
    outward = -work.row[:, edges]
    entering = np.full(len(settled.film.lands), along[0].sum())  # a closed ring: across the seam
    leaving, order = entering.copy(), settled.film.land_order
    for number, (first, last) in enumerate(ring.groove_lines):
        into, out_of = along[last], along[first - 1]
        leaving[order[number]] = out_of.sum()
        entering[order[(number + 1) % len(order)]] = into.sum()
        from_ends = (into - out_of)[edges]
        supplies[number] += from_ends.sum()
        beside = groove_lines(first, last, outward.shape[0])
        past_groove = outward[beside].sum(axis=0) + from_ends  # what passes along its ends is no side flow
        outward[beside] = 0.0
        outward[last] = past_groove
    sides = outward.sum(axis=0)
    drawn = float(np.maximum(-outward, 0.0).sum())
    return SurfaceFlows(
        supplies, sides if len(edges) == 2 else np.full(2, 0.5 * sides[0]), drawn, entering, leaving
    )


def drain_sides(ring: UnwrappedMesh, film: SurfaceFilm, work: SurfaceWork) -> None:
    """Let sides at cavitation pressure run partly filled where less oil arrives than their gap could carry."""
    fed = fed_lines(ring)
    for edge in drained_edges(ring):
        drain_edge(ring.surface, film, work, edge, fed)


def drained_edges(ring: UnwrappedMesh) -> list[int]:
    """Nodes of the sides that can run partly filled: those at cavitation pressure of a film that moves."""
    if not ring.surface.speed > 0.0:
        return []
    return [edge for edge in ring.mesh.side_nodes if ring.surface.held_pressure[0, edge] <= 0.0]


def fed_lines(ring: UnwrappedMesh) -> NDArray[np.bool_]:
    """Lines on the ends of grooves."""
    fed = np.zeros(ring.surface.held.shape[0], dtype=bool)
    fed[[line for ends in ring.groove_lines for line in ends]] = True
    return fed


def twins(film: JournalFilm, grooves: int) -> list[int]:
    """Number of the image in the mid-plane of every groove and pocket of a film with halves alike."""
    images = [replace(pocket, axial_centre=-pocket.axial_centre) for pocket in film.pockets]
    return [*range(grooves), *(grooves + film.pockets.index(image) for image in images)]


def flux_along(settled: SurfaceEquilibrium) -> Array:
    """Flux from every line to the next, as ``_surface_forces.balance_rows`` has it; shape (n, nodes)."""
    surface, film, work = settled.sample.ring.surface, settled.sample.film, settled.sample.work
    here = np.arange(surface.step.size)
    after = (here + 1) % work.pressure.shape[0]
    fill = work.fill[here]
    flux = film.couette * fill + film.conductance * (work.pressure[here] - work.pressure[after])
    if surface.conserving:
        cramped = surface.held[here] & ~work.holds[after]
        flux = np.where(cramped, film.inlet * fill, flux)
    return np.asarray(flux)


def supply_order(film: JournalFilm, seen: JournalFilm) -> list[int]:
    """Where each supply of a film stands among those of the film that was solved (itself or its mirror image)."""
    grooves = 0 if film.film_start is FilmStart.PERIODIC else len(film.lands)
    pockets = [grooves + number for number in range(len(film.pockets))]
    if seen.angular_speed == film.angular_speed or not grooves:
        return list(range(grooves)) + pockets
    own, mirror = film.land_order, seen.land_order
    before = [mirror.index(own[(place + 1) % grooves]) for place in range(grooves)]  # the mirror's order runs back
    return before + pockets


def friction(settled: SurfaceEquilibrium) -> tuple[float, float, float]:
    """Torques on journal and bearing: Couette shear with the liquid fraction, and -+ (h/2) dp/dtheta; and the part
    of the shear by streamers."""
    surface, work = settled.sample.ring.surface, settled.sample.work
    n = surface.step.size
    after = (np.arange(n) + 1) % work.pressure.shape[0]
    viscosity = surface.viscosity * (0.5 * (work.stiffening[:n] + work.stiffening[after]))[:, surface.node]
    gaps = gauss_gaps(settled)
    shear = couette_shear(settled, viscosity, gaps)
    shear[_in_feed(settled, after)] = 0.0
    couette, hydraulic = float((shear @ surface.share).sum()), slope_torque(settled, gaps)
    return couette + hydraulic, couette - hydraulic, streamer_shear(settled, shear)


def slope_torque(settled: SurfaceEquilibrium, gaps: tuple[Array, Array]) -> float:
    """Half of what the torque on the journal has more than that by shear on the bore: (h/2) dp/dtheta over the
    film, whatever its viscosity across the gap."""
    surface, work = settled.sample.ring.surface, settled.sample.work
    ha, hb = gaps
    n = surface.step.size
    after = (np.arange(n) + 1) % work.pressure.shape[0]
    pressure = true_pressures(surface, work.pressure)
    slope = 0.25 * (ha + hb) * (pressure[after] - pressure[:n])[:, surface.node]
    return float((slope @ surface.share).sum())


def couette_shear(settled: SurfaceEquilibrium, viscosity: Array, gaps: tuple[Array, Array]) -> Array:
    """Torque of every piece of the surface by shear of its oil, shape (n, points), over that of its share of the
    width, at viscosities over the reference.

    Grooves, pockets and holes count as film; they are deep beside it, and the oil in them is not sheared.
    """
    surface, work = settled.sample.ring.surface, settled.sample.work
    ha, hb = gaps
    n = surface.step.size
    thinness, turbulence = 1.0 / ha + 1.0 / hb, settled.film.turbulence
    if turbulence is not None:
        fa, fb = (turbulence.shear_factor(surface.turbulence[0] * gap / surface.viscosity) for gap in (ha, hb))
        thinness = fa / ha + fb / hb
    half = 0.5 * surface.step[:, None]
    return np.asarray(surface.speed * viscosity * half * thinness * liquid(work.fill[:n])[:, surface.node])


def streamer_shear(settled: SurfaceEquilibrium, shear: Array) -> float:
    """What of a shear (`couette_shear`) belongs to the oil that the ruptured film carries."""
    surface, work = settled.sample.ring.surface, settled.sample.work
    n = surface.step.size
    ruptured = (work.fill[:n] < 1.0)[:, surface.node]
    if settled.film.is_starved or settled.film.pockets:  # the oil in flooded grooves is whole
        ruptured &= ~_in_feed(settled, (np.arange(n) + 1) % work.pressure.shape[0])
    return float((np.where(ruptured, shear, 0.0) @ surface.share).sum())


def gauss_gaps(settled: SurfaceEquilibrium) -> tuple[Array, Array]:
    """Gaps at both Gauss points of every interval, shape (n, points)."""
    surface = settled.sample.ring.surface
    lift = settled.position[:, None] * surface.lever
    return surface.gap_a - surface.shape_a.T @ lift, surface.gap_b - surface.shape_b.T @ lift


def true_pressures(surface: Surface, reduced: Array) -> Array:
    """Pressures above cavitation from the reduced ones that the kernels solve for."""
    return pressure_of(surface.piezo, reduced) if surface.piezo.size else reduced


def _in_feed(settled: SurfaceEquilibrium, after: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether a piece of the surface, one interval long and one axial element wide, lies in a feed.

    Elements end at the edges of feeds, so a piece lies in one when every node around it is held by a supply; the
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
