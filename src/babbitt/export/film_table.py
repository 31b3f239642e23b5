"""From solved films to a coefficient table over speed."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from babbitt.core.notices import InputError
from babbitt.export.coefficients import CoefficientTable
from babbitt.export.frame import Frame, Rotation, load_direction
from babbitt.reynolds.solution import FilmSolution

STATIC = ("load", "eccentricity_ratio", "attitude_angle", "minimum_film_thickness", "sommerfeld_number")
"""What is carried along of each equilibrium."""


def coefficient_table(name: str, solutions: Iterable[FilmSolution], method: str = "") -> CoefficientTable:
    """Gather equilibria of one bearing at several speeds, in any order.

    Parameters
    ----------
    name : str
        Of the bearing.
    solutions : iterable of FilmSolution
        All of the same rotation sense and load direction; the load may differ.
    method : str
        How they were obtained; by default the cavitation model.

    Returns
    -------
    CoefficientTable
        In the frame of Babbitt, x right and y up.

    Raises
    ------
    InputError
        E003 without a film or with an unsolved one, E004 when rotation sense or load direction differ.
    """
    films = sorted(solutions, key=lambda solution: abs(solution.film.angular_speed))
    if not films:
        raise InputError("E003", f"{name}: no solved film; a table needs one speed or more")
    if unsolved := [film for film in films if not film.outcome.solved]:
        rpm = abs(unsolved[0].film.angular_speed) * 30.0 / math.pi
        raise InputError(
            "E003", f"{name}: no equilibrium at {rpm:.0f} rpm ({unsolved[0].outcome.value}); leave it out"
        )
    senses = {film.film.angular_speed > 0.0 for film in films}
    angles = np.array([math.atan2(-film.force[1], -film.force[0]) for film in films])
    apart = np.abs(np.remainder(angles - angles[0] + math.pi, 2.0 * math.pi) - math.pi).max()
    if len(senses) > 1 or apart > 1e-4:
        raise InputError("E004", f"{name}: rotation sense or load direction differ; make one table for each")
    rotation = Rotation.COUNTER_CLOCKWISE if senses == {True} else Rotation.CLOCKWISE
    return CoefficientTable(
        name=name,
        speeds=np.array([abs(film.film.angular_speed) for film in films]),
        stiffness=np.array([film.stiffness for film in films]),
        damping=np.array([film.damping for film in films]),
        frame=Frame(rotation=rotation, load_angle=load_direction(angles[0])),
        static={quantity: np.array([getattr(film, quantity) for film in films]) for quantity in STATIC},
        method=method or f"Babbitt film, {films[0].film.cavitation.name.lower().replace('_', ' ')} cavitation",
    )
