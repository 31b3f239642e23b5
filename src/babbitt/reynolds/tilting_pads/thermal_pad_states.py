"""Films of tilting pads with their temperatures, in SI and in the fixed frame."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import NamedTuple

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
    through = layer_flows(films)
    enthalpy, fresh = oil_enthalpy(films, through)
    open_journal = films.walls.journal_open
    kept = {one.name: getattr(plain, one.name) for one in fields(TiltingPadSolution)}
    return ThermalTiltingPadSolution(
        **kept | {"pads": states, "films": films.solved},
        heat=films.heat,
        temperatures=pad_temperatures(films, through),
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
    """Flow of every layer through every interval of every pad, shape (pads, n + 1, layers)."""
    flows = films.flows
    through = flows.shear[:, :, None] * flows.shear_profile + flows.pressure[:, :, None] * flows.pressure_profile
    return through.reshape(films.films.inlet.size, -1, through.shape[-1])


def oil_enthalpy(films: PadFilms, through: Array) -> tuple[float, float]:
    """Heat above the supply of the oil that leaves the bearing, and the fresh oil that enters, in units of the
    kernels: over the sides, and of the grooves what is not carried over or is more than the pad takes."""
    oil, width = films.oil, films.oil.share[:, None]
    above = films.films.temperature.reshape(through.shape) - oil.fresh
    entering, leaving = width * through[:, 0], width * through[:, -1]
    back = np.maximum(-entering, 0.0)
    brought = leaving.sum(axis=1)[oil.previous] + back.sum(axis=1)
    brought_heat = (leaving * above[:, -1]).sum(axis=1)[oil.previous] + (back * above[:, 1]).sum(axis=1)
    leak = width * films.flows.leak.reshape(through.shape[:2])[:, 1:]
    taken = np.maximum(entering, 0.0).sum(axis=1) + np.maximum(-leak, 0.0).sum(axis=1)
    profiles = films.flows.pressure_profile.reshape(through.shape)
    carried = np.einsum("kil,kil->ki", profiles[:, 1:], above[:, 1:])
    kept = oil.carry_over * brought
    surplus = np.maximum(kept - taken, 0.0) * (films.films.inlet - oil.fresh)
    over_sides = float((np.maximum(leak, 0.0) * carried).sum())
    over_grooves = float(((1.0 - oil.carry_over) * brought_heat + surplus).sum())
    return over_sides + over_grooves, float(np.maximum(taken - kept, 0.0).sum())


def pad_temperatures(films: PadFilms, through: Array) -> tuple[PadTemperatures, ...]:
    """Temperatures of every pad."""
    rows, thickness = through.shape[1], films.columns.layer
    on_lines, last = (
        films.films.on_lines.reshape(through.shape),
        films.films.temperature.reshape(through.shape)[:, -1],
    )
    leaving, middles = through[:, -1].sum(axis=1).tolist(), np.cumsum(thickness) - 0.5 * thickness
    trailing = (through[:, -1] * last).sum(axis=1).tolist()
    walls, deflections = wall_temperatures(films, on_lines), films.bent * films.scales.length
    places = np.arange(rows)
    return tuple(
        PadTemperatures(
            inlet=float(films.films.inlet[k]),
            trailing=trailing[k] / leaving[k] if leaving[k] > 0.0 else math.nan,
            maximum=float(max(on_lines[k].max(), walls.bore[k].max())),
            probe=float(np.interp(pad.probe_fraction * (rows - 1), places, walls.bore[k])),
            bore=walls.bore[k],
            film=on_lines[k].copy(),
            layers=middles,
            mean=walls.mean[k],
            heat=walls.heat[k],
            edge_heat=walls.over_edges[k],
            deflection=deflections[k],
            growth=float(films.grown[k]) * films.scales.length,
            is_capped=bool(films.films.capped[k]),
        )
        for k, pad in enumerate(films.bearing.pads)
    )


class WallTemperatures(NamedTuple):
    """Of every pad: its bore, K, the heat into it and over its edges, W, and its mean temperature, K."""

    bore: Array
    heat: list[float]
    over_edges: list[float]
    mean: list[float]


def wall_temperatures(films: PadFilms, on_lines: Array) -> WallTemperatures:
    """Pads that conduct, or of those that take no heat the bores alone."""
    count, rows, _ = on_lines.shape
    if not films.conduction:
        none = [0.0] * count
        return WallTemperatures(insulated_bores(on_lines, films.columns.layer), none, none, [math.nan] * count)
    across = films.bearing.width * films.oil.share
    extent = np.array([pad.extent for pad in films.bearing.pads])
    flux = films.walls.flux.reshape(count, rows)
    mean_flux = (flux.sum(axis=1) - 0.5 * (flux[:, 0] + flux[:, -1])) / (rows - 1)
    drives = films.drives()
    return WallTemperatures(
        films.walls.bore.reshape(count, rows).copy(),
        (mean_flux * extent * films.bearing.radius * across).tolist(),
        [float((one.edges @ drives[k]).sum() * across[k]) for k, one in enumerate(films.conduction)],
        [float(one.mean @ drives[k]) for k, one in enumerate(films.conduction)],
    )


def insulated_bores(film: Array, thickness: Array) -> Array:
    """Temperature of walls that take no heat: a parabola, level there, with the means of the two layers next."""
    first, second = thickness[:2]
    lower, upper = first**2 / 3.0, ((first + second) ** 3 - first**3) / (3.0 * second)
    return np.asarray(film[..., 0] - lower * (film[..., 1] - film[..., 0]) / (upper - lower))
