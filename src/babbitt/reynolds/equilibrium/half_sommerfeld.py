"""Half-Sommerfeld (Gumbel) films: the full film is solved and its suctions count as nothing.

Oil appears from nowhere where the film ends, so flows are left out; and the end of the film moves with the
journal without a condition on its slope, so that the adjoints of the engine do not hold: stiffness and damping are
left out too.
Closed forms of short and long bearings, and tables made from them, rest on this condition.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.numerics.roots import bracketed_root
from babbitt.reynolds.equilibrium.cavitating_film import cavitating_film_at
from babbitt.reynolds.lands.axial import even_axial_operator
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution

__all__ = ["half_sommerfeld_at", "half_sommerfeld_equilibrium"]

Array = NDArray[np.float64]
SUCTION = -1e12  # Pa, never reached: the film stays full
DEEPEST = 0.999  # eccentricity ratio
MISSED = 2e-3  # of the load: what the seam of the grid may turn the force


def half_sommerfeld_at(
    film: JournalFilm, position: tuple[float, float], velocity: tuple[float, float], resolution: Resolution
) -> FilmSolution:
    """Film at a position (m) and velocity (m/s); coefficients and flows are NaN."""
    full = replace(film, cavitation=Cavitation.REYNOLDS, cavitation_pressure=SUCTION)
    found = cavitating_film_at(full, position, velocity, resolution)
    if not found.outcome.solved:
        return replace(found, film=film)
    pressure = np.maximum(found.pressure, 0.0)
    unknown, two = np.full((2, 2), np.nan), np.full(2, np.nan)
    force = pressure_force(film, found, pressure)
    # the torques of journal and bearing lie e x F / 2 to either side of that by shear
    x, y = position
    shear = 0.5 * (found.friction_torque + found.bearing_torque)
    turn = 0.5 * math.copysign(1.0, film.angular_speed) * (x * force[1] - y * force[0])
    return replace(
        found, film=film, pressure=pressure, force=force, stiffness=unknown, damping=unknown.copy(),
        side_flow=np.full_like(found.side_flow, np.nan), end_flows=two, side_inflow=math.nan, inflow=two[:1],
        outflow=two[:1], supply_flow=two[:0], mass_balance_error=math.nan, friction_torque=shear + turn,
        bearing_torque=shear - turn, streamer_torque=math.nan,
    )  # fmt: skip


def pressure_force(film: JournalFilm, found: FilmSolution, pressure: Array) -> Array:
    """Force of a pressure on the journal, N: trapezium along the ring, Lobatto weights across the width."""
    angle = np.append(
        found.angles[0], found.angles[0, 0] + math.copysign(2.0 * math.pi, film.angular_speed or 1.0)
    )
    step = np.abs(np.diff(angle))
    share = 0.5 * (step + np.roll(step, 1))
    across = pressure[0] @ even_axial_operator(pressure.shape[2] - 1).weights
    scale = -0.5 * film.diameter * film.width
    toward = np.array([np.cos(found.angles[0]), np.sin(found.angles[0])])
    return np.asarray(scale * (toward * share) @ across)


def half_sommerfeld_equilibrium(
    film: JournalFilm, load: tuple[float, float], resolution: Resolution
) -> FilmSolution:
    """Where the film carries a load (N): first the depth, for a round ring looks the same from everywhere."""
    size = math.hypot(*load)

    def on_axis(eps: float) -> FilmSolution:
        return half_sommerfeld_at(film, (eps * film.clearance, 0.0), (0.0, 0.0), resolution)

    def surplus(eps: float) -> float:
        return math.log(max(on_axis(eps).load, 1e-300) / size)

    if size == 0.0:
        return on_axis(0.0)
    if surplus(DEEPEST) < 0.0:
        return replace(on_axis(DEEPEST), outcome=Outcome.OVERLOADED)
    eps = bracketed_root(surplus, 1e-9, DEEPEST, 1e-12, 1e-10)
    force = on_axis(eps).force
    turn = math.atan2(-load[1], -load[0]) - math.atan2(force[1], force[0])
    place = (eps * film.clearance * math.cos(turn), eps * film.clearance * math.sin(turn))
    found = half_sommerfeld_at(film, place, (0.0, 0.0), resolution)
    missed = math.hypot(found.force[0] + load[0], found.force[1] + load[1])
    return found if missed < MISSED * size else replace(found, outcome=Outcome.NOT_CONVERGED)
