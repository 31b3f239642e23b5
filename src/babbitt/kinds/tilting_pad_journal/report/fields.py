"""Fields of the pads with names and units, as an xarray Dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.solution import Solution
from babbitt.report.fields import require_package
from babbitt.reynolds.tilting_pads.pad_lands import pad_gaps

if TYPE_CHECKING:
    import xarray

__all__ = ["pad_fields"]


def pad_fields(solution: Solution) -> xarray.Dataset:
    """Pressure, film thickness and void over every pad, and the values of the result beside them.

    Returns
    -------
    xarray.Dataset
        Dimensions ``pad`` (from 1), ``line`` (from the leading to the trailing edge) and ``z`` (m, from the
        mid-plane to the side); ``theta`` (rad, counter-clockwise from +x) over pad and line. Values of the result
        stand as variables without dimension, rows with a number per pad over ``pad``.

    Raises
    ------
    InputError
        E003 for a result without an operating point, E007 when xarray is not installed.
    """
    package = require_package("xarray")
    import numpy as np

    result = solution.result
    if not result.outcome.solved:
        raise InputError("E003", f"{result.name}: no fields without an operating point ({result.outcome.value})")
    films = solution.state.films.solution
    pads = films.pads
    theta = np.array([state.angles for state in pads])
    z = np.array([state.axial_positions for state in pads])
    thermal = solution.state.films.thermal
    over = ("pad", "line", "place")
    variables: dict[str, Any] = {
        "pressure": (over, np.array([state.pressure for state in pads]), _named("Pa", "film pressure, gauge")),
        "void": (over, np.array([state.void for state in pads]), _named("1", "share of the gap without oil")),
        "film_thickness": (("pad", "line"), pad_gaps(films), _named("m", "film thickness")),
        "theta": (("pad", "line"), theta, _named("rad", "angle, counter-clockwise from +x")),
        "z": (("pad", "place"), z, _named("m", "place along the shaft, from the mid-plane to the side")),
    }
    if thermal is not None:
        bores = np.array([heat.bore for heat in thermal.temperatures])
        means = np.array([heat.film_mean for heat in thermal.temperatures])
        variables["bore_temperature"] = (("pad", "line"), bores, _named("K", "temperature of the bore"))
        variables["film_temperature"] = (("pad", "line"), means, _named("K", "mean temperature over the gap"))
    for name, rows in result.arrays.items():
        if len(rows) == 1 and len(rows[0]) == len(pads) and name.startswith(("pad_", "pivot_")):
            variables[name] = ("pad", np.array(rows[0]), _named(QUANTITIES[name].unit, QUANTITIES[name].meaning))
    for name, value in result.values.items():
        if name in QUANTITIES and name not in variables and name != "wall_time":
            variables[name] = ((), float(value), _named(QUANTITIES[name].unit, QUANTITIES[name].meaning))
    made: xarray.Dataset = package.Dataset(
        variables,
        coords={"pad": ("pad", np.arange(1, len(pads) + 1), _named("1", "number of the pad"))},
        attrs={
            "title": str(result.name),
            "source": f"Babbitt {__version__}",
            "thermal": result.settings["thermal"],
            "cavitation": result.settings["cavitation"],
            "axes": "x right, y up, seen against z; pressures are gauge",
        },
    )
    return made


def _named(units: str, meaning: str) -> dict[str, str]:
    return {"units": units, "long_name": meaning}
