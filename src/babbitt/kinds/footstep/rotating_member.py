"""The turning smooth heel, eccentric or tilted in its cup: a journal bearing with pressure at one side."""

from __future__ import annotations

import math

from babbitt.kinds.footstep.model import Footstep

__all__ = ["turning_force"]


def turning_force(footstep: Footstep, rim_pressure: float, viscosity: float) -> tuple[float, float]:
    """Force of the film in the clearance on a smooth heel, by the film in two dimensions.

    Parameters
    ----------
    footstep : Footstep
        Its groove is not seen.
    rim_pressure : float
        p1, Pa absolute.
    viscosity : float
        Of the oil in the clearance, Pa s.

    Returns
    -------
    along, across : float
        N, along the eccentricity (positive outwards) and across it in the sense of rotation. Rupture at ambient
        pressure (Reynolds' condition). NaN where the film has not been solved.
    """
    from babbitt.reynolds.equilibrium.position import film_at_position
    from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land

    part = footstep.geometry
    film = JournalFilm(
        2.0 * part.radius,
        part.length,
        footstep.clearance,
        viscosity,
        footstep.angular_speed,
        (Land(0.0, 2.0 * math.pi),),
        Cavitation.REYNOLDS,
        FilmStart.PERIODIC,
        misalignment=(footstep.tilt, 0.0),
        side_pressures=(0.0, rim_pressure - footstep.ambient_pressure),
    )
    found = film_at_position(film, (footstep.eccentricity_ratio * footstep.clearance, 0.0))
    if not found.outcome.solved:
        return math.nan, math.nan
    return float(found.force[0]), float(found.force[1])
