"""The door of the thermal film: where the journal is in equilibrium when the oil heats itself.

Every step is one pass of Reynolds equation, energy equation and walls (``thermal_film_state``), and one Newton
step of the journal on the stiffness at frozen temperatures; on a coarse ring first, then on the fine one. At the
end the film has converged and the energy equation alone is solved until heat closes to round-off.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.heat.following_clearance import FollowingClearance
from babbitt.reynolds.heat.globalisation import accelerated_equilibrium, recovered
from babbitt.reynolds.heat.heat_model import THERMAL_ENGINEERING, FilmHeat
from babbitt.reynolds.heat.thermal_passes import (
    COLD_LOAD,
    COLDLY_CARRIED,
    MOST_PASSES,
    SETTLED,
    SWEEPS,
    ThermalEquilibrium,
    attempt,
    find_on_fine_ring,
    fresh_ring,
)
from babbitt.reynolds.heat.thermal_solution import ThermalFilm, thermal_film
from babbitt.reynolds.lands._equilibrium import (
    CONTACT,
    CONVERGED,
    MODERATE_LOAD,
    NO_FILM,
    THINNEST,
    TOO_MANY_STEPS,
)
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.stability.load_slope import EquilibriumNodes
from babbitt.reynolds.surface.surface_equilibrium import SurfaceEquilibrium, line_density, position_under
from babbitt.reynolds.surface.surface_solution import (
    couette_shear,
    gauss_gaps,
    mirrored,
    slope_torque,
    solution_of,
    streamer_shear,
    supply_order,
)

__all__ = ["solve_thermal_journal", "thermal_film_at"]

Array = NDArray[np.float64]

CLOSING, CLOSED, OPEN = 400, 1e-8, 1e-4
"""Rounds that close the heat balance at most, the change of temperature in K at which they end, and that from
which the film counts as not converged."""
POLISH, POLISHED, NEARLY, MISSED = 8, 1e-9, 1e-5, 1e-4
"""Last steps of the journal at frozen temperatures, at most, the residual force over load that ends them, that
from which one step does, and that with which the film has not converged."""
THICK = 0.3
"""Gap, in clearances, down to which lines may stand as for a journal at the usual place."""
USUAL_PLACE, USUAL_ATTITUDE = 0.6, math.radians(45.0)
"""Of the journal: relative eccentricity, and angle ahead of the load."""
USUAL_ROUNDS = 1
"""Updates of the active set there before the film tells how warm it gets."""


@dataclass(frozen=True, eq=False)
class Posed:
    """A film in the frame of its load and as it is solved, turning forwards, with its dimensionless load."""

    frame: LoadFrame
    seen: JournalFilm
    scales: Scales
    load: Array


def solve_thermal_journal(
    film: JournalFilm, heat: FilmHeat, load: tuple[float, float], resolution: Resolution = THERMAL_ENGINEERING
) -> ThermalFilm:
    """Find where a film with its own temperatures carries a load.

    Parameters
    ----------
    film : JournalFilm
        ``viscosity`` is the unit of the calculation only; take that of the fresh oil.
    heat : FilmHeat
    load : tuple of float
        Force on the journal, N.
    resolution : Resolution

    Returns
    -------
    ThermalFilm
        Always; its film says whether it is an equilibrium.

    Raises
    ------
    InputError
        E101 if the load is zero or not finite, the journal stands still, the film does not conserve oil, or
        viscosity under pressure is asked for.
    """
    begun, asked = time.perf_counter(), posed(film, load)
    found = search(asked.seen, heat, asked.scales, asked.load, resolution)
    return answer(asked.frame, asked.seen, asked.scales, found, begun)


def posed(film: JournalFilm, load: tuple[float, float]) -> Posed:
    """A film under a load, N, as it is solved; raises as `solve_thermal_journal`."""
    if not all(math.isfinite(part) for part in load):
        raise InputError("E101", f"load is {load}; both components must be finite, in N.")
    if not any(load):
        raise InputError("E101", f"load is {load}; without load a film need not hold the journal anywhere, nor "
                         "carry its heat off. Give a load, or a position to thermal_film_at.")  # fmt: skip
    if film.cavitation is not Cavitation.MASS_CONSERVING:
        raise InputError("E101", f"cavitation is {film.cavitation.name.lower()}; oil that comes from nowhere, "
                         "where a film forms anew, has no temperature. Choose mass_conserving.")  # fmt: skip
    check_thermal_film(film)
    frame = LoadFrame.of(film, load)
    seen, scales = turning_forwards(frame.film)
    return Posed(frame, seen, scales, np.asarray(frame.load) * scales.sense / scales.force)


def turning_forwards(film: JournalFilm) -> tuple[JournalFilm, Scales]:
    """A film as it is solved, and its scales."""
    return mirrored(film) if film.angular_speed < 0.0 else film, Scales.of(film, abs(film.angular_speed))


def check_thermal_film(film: JournalFilm) -> None:
    """Raise if a film is not sheared or knows viscosity under pressure."""
    if film.pressure_viscosity is not None:
        raise InputError(
            "E101", "pressure_viscosity is given; a film with its own temperatures does not count it."
        )
    if film.angular_speed == 0.0:
        raise InputError("E101", "angular_speed is zero; a film at rest makes no heat and carries no steady load.")


def thermal_film_at(
    film: JournalFilm,
    heat: FilmHeat,
    position: tuple[float, float],
    resolution: Resolution = THERMAL_ENGINEERING,
    settled: float = SETTLED,
) -> ThermalFilm:
    """Film with its own temperatures at a prescribed position (m) of the journal; see `solve_thermal_journal`.

    ``settled`` is the change of temperature in a pass, K, at which film and temperature have converged.

    Raises
    ------
    InputError
        E101 if the journal stands still or viscosity under pressure is asked for.
    """
    begun = time.perf_counter()
    check_thermal_film(film)
    frame = LoadFrame.of(film, position)
    seen, scales = turning_forwards(frame.film)
    at = np.asarray(frame.load) * scales.sense / scales.length
    thermal = fresh_ring(seen, heat, scales, 2 * resolution.intervals, resolution, None)
    gap = thermal.sample.gap(at)
    if not gap > 0.0:
        return answer(frame, seen, scales, ThermalEquilibrium(thermal, at, NO_FILM, 0, gap), begun)
    status, passes = TOO_MANY_STEPS, 0
    while passes < MOST_PASSES and status != CONVERGED:
        passes += 1
        changed, change = thermal.advance(at, SWEEPS)
        if changed == 0 and change < settled:
            status = CONVERGED
    found = ThermalEquilibrium(thermal, at, status, passes, gap)
    if status != CONVERGED:
        found = accelerated_equilibrium(thermal, None, at, resolution.tolerance, settled)
    return answer(frame, seen, scales, found, begun)


def search(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution
) -> ThermalEquilibrium:
    """On the fine ring at once where the film stays thick, else after a coarse one; then with a growing load."""
    found, share = directly(film, heat, scales, load, resolution), 0.1 * MODERATE_LOAD
    if found.status != CONVERGED:
        share = min(share / max(math.hypot(*load), 1e-300), 1.0)
        found = recovered(film, heat, scales, load, resolution, found, share)
    return replace(found, status=NO_FILM) if found.gap < THINNEST else found


def directly(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution,
    growth: FollowingClearance | None = None,
) -> ThermalEquilibrium:  # fmt: skip
    """Under the whole load, on lines drawn for the clearance given, which may follow on the fine ring."""
    thick = math.hypot(*load) <= COLD_LOAD
    found = on_usual_lines(film, heat, scales, load, resolution, growth) if thick else None
    if found is not None and found.status == CONVERGED and found.gap > THICK:
        return found
    return attempt(film, heat, scales, load, resolution, 1.0, growth)


def on_usual_lines(
    film: JournalFilm, heat: FilmHeat, scales: Scales, load: Array, resolution: Resolution,
    growth: FollowingClearance | None,
) -> ThermalEquilibrium | None:  # fmt: skip
    """Equilibrium on the fine ring at once; None where the film is thin already at the temperature guessed.

    Lines crowd a little where a film of usual thickness would be thin.
    """
    along, across = USUAL_PLACE * load / max(math.hypot(*load), 1e-300), np.array([-1.0, 1.0])
    usual = math.cos(USUAL_ATTITUDE) * along + math.sin(USUAL_ATTITUDE) * across * along[::-1]
    density = line_density(film, usual, 1.0 - USUAL_PLACE)
    thermal = fresh_ring(film, heat, scales, 2 * resolution.intervals, resolution, density)
    for _ in range(USUAL_ROUNDS):
        thermal.sample.evaluate(usual)
    thinner = thermal.guess(usual)
    at, _, _, gap = position_under(thermal.sample, load / thinner, usual, COLDLY_CARRIED, 30, False)
    return find_on_fine_ring(thermal, load, at, resolution, growth) if gap > THICK else None


def polished(found: ThermalEquilibrium) -> ThermalEquilibrium:
    """Let the film carry the load exactly, its temperatures as they are: Newton steps from the last pass.

    The film is left with the coefficients of its answer (``smooth``); a step from ``NEARLY`` there is the last.
    Where the load is missed by more than ``MISSED`` at the end, the film has not converged.
    """
    sample, at, load, smooth = found.thermal.sample, found.position, found.load, False
    whole = 0.0 if load is None else math.hypot(*load)
    for _ in range(POLISH):
        residual = np.zeros(2) if load is None else sample.force + load
        size = math.hypot(*residual)
        if size <= POLISHED * whole + 1e-14:
            break
        at, smooth = at + np.linalg.solve(sample.stiffness, residual), size <= NEARLY * whole
        sample.evaluate(at, smooth=smooth)
    gap = sample.gap(at)
    if not gap > CONTACT:
        at, gap, smooth = found.position, found.gap, False
    if not smooth:
        sample.evaluate(at, smooth=True)
    missed = load is not None and not math.hypot(*(sample.force + load)) <= MISSED * whole + 1e-14
    return replace(found, position=at, gap=gap, status=TOO_MANY_STEPS if missed else found.status)


def answer(
    frame: LoadFrame, seen: JournalFilm, scales: Scales, found: ThermalEquilibrium, begun: float
) -> ThermalFilm:
    """Close the heat balance, solve for the coefficients; everything in SI and in the frame as given."""
    thermal = found.thermal
    if found.status == CONVERGED:
        found = polished(found)
    if found.status == CONVERGED:
        thermal.gather(found.position)
        if not thermal.close(CLOSING, CLOSED) < OPEN:
            found = replace(found, status=TOO_MANY_STEPS)
    settled = SurfaceEquilibrium(seen, thermal.sample, found.position, found.status, found.passes, found.gap)
    surface = thermal.sample.ring.surface
    viscosity = thermal.flows.shear_viscosity[: surface.step.size][:, thermal.columns.column[surface.node]]
    gaps = gauss_gaps(settled)
    streamers = streamer_shear(settled, couette_shear(settled, viscosity, gaps))
    torques = thermal.friction, thermal.friction - 2.0 * slope_torque(settled, gaps), streamers
    solution = solution_of(frame.film, scales, settled, torques, begun)
    solved = thermal_film(solution, scales, thermal, supply_order(frame.film, seen))
    return turned_back(frame, solved, EquilibriumNodes(settled, frame, scales))


def turned_back(frame: LoadFrame, found: ThermalFilm, nodes: EquilibriumNodes) -> ThermalFilm:
    """A thermal film that was solved in the frame of its load, in that in which it was given, and its nodes."""
    order = frame.supplies(found.groove_temperatures.size)
    return replace(
        found,
        film=frame.back(found.film),
        groove_temperatures=found.groove_temperatures[order],
        fresh_flow=found.fresh_flow[order],
        returned_flow=found.returned_flow[order],
        nodes=nodes,
    )
