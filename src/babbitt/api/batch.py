"""Many grooved round bearings from arrays to arrays, without the case language."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.arrays import numbers, positive, require_one_count, require_workers
from babbitt.core.notices import InputError
from babbitt.kinds.journal.film.model import Accuracy
from babbitt.reynolds.lands.batch import BatchSolution
from babbitt.reynolds.lands.batch import solve_batch as solve_lands
from babbitt.reynolds.model import Cavitation, grooved_bore

__all__ = ["BatchSolution", "solve_batch"]

Array = NDArray[np.float64]
Choice = TypeVar("Choice", Cavitation, Accuracy)


def solve_batch(
    *,
    diameter: ArrayLike,
    width: ArrayLike,
    radial_clearance: ArrayLike,
    viscosity: ArrayLike,
    speed: ArrayLike,
    load: ArrayLike,
    load_angle: ArrayLike | None = None,
    groove_angles: Sequence[float] | Array = (0.0, math.pi),
    groove_extent: float = math.radians(20.0),
    cavitation: Cavitation | str = Cavitation.MASS_CONSERVING,
    accuracy: Accuracy | str = Accuracy.ENGINEERING,
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> BatchSolution:
    """Find the equilibria of many round bearings with the same axial grooves, each of one viscosity.

    Parameters
    ----------
    diameter, width, radial_clearance : array_like
        m; scalars or arrays of one axis, as the two that follow. They broadcast to (bearings,).
    viscosity : array_like
        Of the oil in the film, Pa s.
    speed : array_like
        Of the journal, rad/s, positive: counter-clockwise, from x towards y.
    load : array_like
        Force on the journal, N: vectors of shape (2,) or (bearings, 2), x right and y up, so that a weight W is
        ``(0, -W)``; with `load_angle` magnitudes, a scalar or (bearings,).
    load_angle : array_like, optional
        Direction of the load from +x, counter-clockwise, rad.
    groove_angles : sequence of float
        Middles of the grooves from +x, rad, ascending within a turn; full of oil at ambient pressure.
    groove_extent : float
        Angle that each groove takes, rad.
    cavitation : Cavitation or {"mass_conserving", "reynolds"}
    accuracy : Accuracy or {"draft", "engineering", "reference"}
    workers : int, optional
        Threads; by default as many as there are cores. The answer does not depend on it.
    progress : callable, optional
        Called with how many bearings are done, and how many there are.

    Returns
    -------
    BatchSolution
        Its `solved` first: the numbers of an unsolved bearing are NaN. Each column of `supply_flow` is of the
        groove of that place in `groove_angles`.

    Raises
    ------
    InputError
        E101, with the name of the argument, for text and quantities, a load of one component or another shape,
        arrays of several axes, anything that is not finite, sizes and speeds that are not positive, grooves that
        overlap, unknown words, no grooves.

    Examples
    --------
    >>> found = solve_batch(diameter=0.2, width=0.12, radial_clearance=150e-6, viscosity=0.02,
    ...                     speed=[100.0, 300.0], load=(0.0, -10e3))
    >>> found.solved, found.stiffness.shape
    (array([ True,  True]), (2, 2, 2))
    """
    given = {
        "diameter": diameter,
        "width": width,
        "radial_clearance": radial_clearance,
        "viscosity": viscosity,
        "speed": speed,
    }
    arrays = {
        name: positive(name, UNITS[name], values, why=CLOCKWISE * (name == "speed"))
        for name, values in given.items()
    }
    force = _force(load, load_angle)
    require_one_count({**{name: values.shape for name, values in arrays.items()}, "load": force.shape[:-1]})
    angles = numbers("groove_angles", UNITS["groove_angles"], groove_angles)
    extent = numbers("groove_extent", UNITS["groove_extent"], groove_extent)
    if not angles.size:
        raise InputError("E101", "groove_angles is empty; a batch takes bearings with grooves")
    if angles.ndim != 1 or extent.ndim:
        raise InputError("E101", "groove_angles is one axis and groove_extent one number, in rad")
    if not (np.isfinite(angles).all() and np.isfinite(extent)):
        raise InputError("E101", "groove_angles and groove_extent must be finite, in rad")
    require_workers(workers)
    found = solve_lands(
        arrays["diameter"],
        arrays["width"],
        arrays["radial_clearance"],
        arrays["viscosity"],
        arrays["speed"],
        force,
        grooved_bore(tuple(angles.tolist()), float(extent)),
        _member(Cavitation, "cavitation", cavitation),
        _member(Accuracy, "accuracy", accuracy).resolution,
        workers=workers,
        progress=progress,
    )
    for values in (
        found.position, found.eccentricity_ratio, found.minimum_film_thickness, found.stiffness, found.damping
    ):  # fmt: skip
        values[~found.solved] = math.nan
    return found


UNITS = {
    "diameter": "m",
    "width": "m",
    "radial_clearance": "m",
    "viscosity": "Pa s",
    "speed": "rad/s",
    "load": "N",
    "load_angle": "rad",
    "groove_angles": "rad",
    "groove_extent": "rad",
}
"""What the numbers of a batch are in."""

CLOCKWISE = "; a clockwise bearing is the mirror image of one with x and the load turned about"


def _force(load: ArrayLike, load_angle: ArrayLike | None) -> Array:
    """Load vectors of shape (2,) or (bearings, 2)."""
    values = numbers("load", UNITS["load"], load)
    if load_angle is None:
        if values.ndim not in (1, 2) or values.shape[-1] != 2:
            raise InputError(
                "E101", f"load has shape {values.shape}; give both components, (2,) or (bearings, 2), in N, or "
                "magnitudes with load_angle"
            )  # fmt: skip
        force = values
    else:
        angle = numbers("load_angle", UNITS["load_angle"], load_angle)
        if values.ndim > 1 or angle.ndim > 1:
            raise InputError("E101", "with load_angle the load is a magnitude: a scalar or one axis, (bearings,)")
        if (values < 0.0).any():
            raise InputError("E101", "with load_angle the load is a magnitude, in N; it must not be negative")
        require_one_count({"load": values.shape, "load_angle": angle.shape})
        force = np.stack(np.broadcast_arrays(values * np.cos(angle), values * np.sin(angle)), axis=-1)
    if not np.isfinite(force).all():
        raise InputError("E101", "load and load_angle must be finite everywhere, in N and rad")
    return force


def _member(choices: type[Choice], name: str, given: Choice | str) -> Choice:
    if isinstance(given, choices):
        return given
    named = {one.name.lower(): one for one in choices}
    if given not in named:
        raise InputError("E101", f"{name} is {given!r}; allowed: {', '.join(named)}")
    return named[str(given)]
