"""Films of tilting pads with their temperatures, in SI and in the fixed frame."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.reynolds.tilting_pads._pad_flows import (
    BORE_POWER,
    DISSIPATION,
    INFLOW,
    JOURNAL_POWER,
    NARROWEST,
    OUTFLOW,
    SIDE_FLOW,
)
from babbitt.reynolds.tilting_pads.pad_films import PadFilms, Placement
from babbitt.reynolds.tilting_pads.solution import PadState, PadStatus, TiltingPadSolution
from babbitt.reynolds.tilting_pads.solve import assembled
from babbitt.reynolds.tilting_pads.thermal_pad_solution import PadTemperatures, ThermalTiltingPadSolution

__all__ = ["Settled", "thermal_solution"]

Array = NDArray[np.float64]

BARELY_LOADED = 1e-3
"""Share of the force of all films below which a pad counts as at its limit: the heat of the oil alone may carry
that much, more or less of it with the layers of the film."""


@dataclass(frozen=True, eq=False)
class Settled:
    """Where passes ended; ``passes`` of all attempts, ``bounces``: a pad went in and out of its limit."""

    films: PadFilms
    placement: Placement
    outcome: Outcome
    passes: int
    bounces: bool = False


def thermal_solution(found: Settled, begun: float) -> ThermalTiltingPadSolution:
    """Everything in SI: positions, forces and pressures as of isothermal films, flows and friction of these."""
    films, placement = found.films, found.placement
    bearing, scales = films.bearing, films.scales
    plain = assembled(
        bearing, scales, films.axial, films.pads, placement.grid, films.places, placement.at, films.total,
        found.outcome, placement.residual, placement.indifferent, placement.steps, begun,
    )  # fmt: skip
    count, whole = len(bearing.pads), math.hypot(*plain.force)
    states = tuple(pad_state(films, plain.pads[k], whole, k) for k in range(count))
    enthalpy, fresh = oil_enthalpy(films)
    open_journal = films.walls.journal_open
    kept = {one.name: getattr(plain, one.name) for one in fields(TiltingPadSolution)}
    return ThermalTiltingPadSolution(
        **kept | {"pads": states, "films": films.solved},
        heat=films.heat,
        temperatures=tuple(pad_temperatures(films, k) for k in range(count)),
        journal_temperature=float(films.walls.journal[0]) if open_journal else math.nan,
        journal_heat=float(films.walls.journal[1]),
        dissipation=float(films.oil.share @ films.totals[:, DISSIPATION]) * scales.torque * scales.rate,
        oil_heat=enthalpy * films.oil.flow_heat,
        supplied_flow=fresh * scales.flow,
        growth_share=films.share,
        passes=found.passes,
    )


def pad_state(films: PadFilms, state: PadState, whole: float, k: int) -> PadState:
    """A pad with the flows, the friction and the narrowest gap of its film."""
    scales, totals, width = films.scales, films.totals[k], films.oil.share[k]
    status = state.status
    if status is PadStatus.LOADED and abs(state.load) < BARELY_LOADED * whole:
        status = PadStatus.AT_LIMIT
    return replace(
        state,
        status=status,
        minimum_film_thickness=float(totals[NARROWEST]) * scales.length,
        inflow=float(totals[INFLOW]) * scales.flow * width,
        outflow=float(totals[OUTFLOW]) * scales.flow * width,
        side_flow=float(totals[SIDE_FLOW]) * scales.flow * width,
        friction_torque=float(totals[JOURNAL_POWER]) * scales.torque * width,
        shear_torque=float(totals[BORE_POWER]) * scales.torque * width,
        eccentricity_ratio=eccentricity_ratio(films, k),
    )


def eccentricity_ratio(films: PadFilms, k: int) -> float:
    """At the pivot, over the machined clearance as it has become."""
    radial, clearance = films.places.radial[k], films.clearances[k] - films.grown[k]
    return float(radial / clearance)


def layer_flows(films: PadFilms) -> Array:
    """Flow of every layer through every interval of the ring, shape (lines, layers)."""
    flows = films.flows
    return np.asarray(
        (flows.shear[:, :, None] * flows.shear_profile + flows.pressure[:, :, None] * flows.pressure_profile)[:, 0]
    )


def oil_enthalpy(films: PadFilms) -> tuple[float, float]:
    """Heat above the supply of the oil that leaves the bearing, and the fresh oil that enters, in units of the
    kernels: over the sides, and of the grooves what is not carried over or is more than the pad takes."""
    count, fresh = films.films.inlet.size, films.oil.fresh
    rows = films.films.temperature.shape[0] // count
    through, above = layer_flows(films), films.films.temperature[:, 0] - fresh
    enthalpy = 0.0
    brought_heat, brought, taken = np.zeros(count), np.zeros(count), np.zeros(count)
    for k in range(count):
        first, last, width = k * rows, k * rows + rows - 1, films.oil.share[k]
        entering, leaving = width * through[first], width * through[last]
        follower = int(np.flatnonzero(films.oil.previous == k)[0])
        brought[follower] += leaving.sum()
        brought_heat[follower] += leaving @ above[last]
        back = np.maximum(-entering, 0.0)
        brought[k] += back.sum()
        brought_heat[k] += back @ above[first + 1]
        leak, lines = films.flows.leak[first + 1 : last + 1, 0], slice(first + 1, last + 1)
        taken[k] = np.maximum(entering, 0.0).sum() + width * np.maximum(-leak, 0.0).sum()
        carried = (films.flows.pressure_profile[lines, 0] * above[lines]).sum(axis=1)
        enthalpy += width * float(np.maximum(leak, 0.0) @ carried)
    kept = films.oil.carry_over * brought
    surplus = np.maximum(kept - taken, 0.0) * (films.films.inlet - fresh)
    enthalpy += float(((1.0 - films.oil.carry_over) * brought_heat + surplus).sum())
    added = float(np.maximum(taken - kept, 0.0).sum())
    return enthalpy, added


def pad_temperatures(films: PadFilms, k: int) -> PadTemperatures:
    """Temperatures of a pad."""
    count, pad = films.films.inlet.size, films.bearing.pads[k]
    rows = films.films.temperature.shape[0] // count
    lines = slice(k * rows, (k + 1) * rows)
    film = films.films.on_lines[lines, 0].copy()
    thickness = films.columns.layer
    through = layer_flows(films)[k * rows + rows - 1]
    leaving = through.sum()
    trailing = float(through @ films.films.temperature[lines, 0][-1] / leaving) if leaving > 0.0 else math.nan
    bore, heat, over_edges, mean = insulated_bore(film, thickness), 0.0, 0.0, math.nan
    if films.conduction:
        bore = films.walls.bore[lines].copy()
        width = np.full(rows, pad.extent / (rows - 1))
        width[[0, -1]] *= 0.5
        across, drives = films.bearing.width * films.oil.share[k], films.drives()[k]
        heat = float(films.walls.flux[lines] @ width) * films.bearing.radius * across
        over_edges = float((films.conduction[k].edges @ drives).sum()) * across
        mean = float(films.conduction[k].mean @ drives)
    return PadTemperatures(
        inlet=float(films.films.inlet[k]),
        trailing=trailing,
        maximum=float(max(film.max(), bore.max())),
        probe=float(np.interp(pad.probe_fraction * (rows - 1), np.arange(rows), bore)),
        bore=bore,
        film=film,
        layers=np.cumsum(thickness) - 0.5 * thickness,
        mean=mean,
        heat=heat,
        edge_heat=over_edges,
        deflection=films.bent[k] * films.scales.length,
        growth=float(films.grown[k]) * films.scales.length,
        is_capped=bool(films.films.capped[k]),
    )


def insulated_bore(film: Array, thickness: Array) -> Array:
    """Temperature of a wall that takes no heat: a parabola, level there, with the means of the two layers next."""
    first, second = thickness[:2]
    lower, upper = first**2 / 3.0, ((first + second) ** 3 - first**3) / (3.0 * second)
    return np.asarray(film[:, 0] - lower * (film[:, 1] - film[:, 0]) / (upper - lower))
