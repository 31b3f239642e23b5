"""Fields of a film with names and units, as an xarray Dataset."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.solution import Solution
from babbitt.kinds.journal.film.field import FilmField, field_of, supply_patches
from babbitt.kinds.journal.film.isothermal import under_found_load
from babbitt.kinds.journal.film.temperature_field import temperature_over, temperature_through
from babbitt.report.fields import require_package

if TYPE_CHECKING:
    import xarray

    from babbitt.reynolds.heat.thermal_solution import ThermalFilm

__all__ = ["film_fields"]

TURN = 2.0 * math.pi


def film_fields(solution: Solution) -> xarray.Dataset:
    """Pressure, liquid fraction and film thickness over the bore, and the values of the result beside them.

    Parameters
    ----------
    solution : Solution
        Of a film.

    Returns
    -------
    xarray.Dataset
        Dimensions ``theta`` (rad, counter-clockwise from +x, one turn that begins opposite the load) and ``z`` (m,
        from the mid-plane). Every variable has ``units`` and ``long_name``. The values of the result stand as
        variables without dimension under their names. ``film_thickness`` is not a number over grooves and pockets,
        where ``supply`` is 1. A film with its own temperatures has ``temperature`` (K, mean across the gap) over
        the bore, ``temperature_through`` over ``theta`` and the place across the gap ``eta`` (0 on the bush, 1 on
        the journal) in the middle of the width, and ``bush_temperature`` over ``theta``.

    Raises
    ------
    InputError
        E003 for a result without an operating point, E007 when xarray is not installed.
    """
    package = require_package("xarray")
    import numpy as np

    result, state = solution.result, solution.state
    if not result.outcome.solved:
        raise InputError("E003", f"{result.name}: no fields without an operating point ({result.outcome.value})")
    film, case = state.solution, under_found_load(solution.problem, state)
    field = field_of(film, case.load_angle - math.pi)
    supply = np.zeros(field.pressure.shape, dtype=np.int8)
    for patch in supply_patches(film.film):
        around = np.remainder(field.theta - patch.theta[0] + 1e-9, TURN) <= patch.theta[1] - patch.theta[0] + 2e-9
        supply[np.ix_(around, (field.z >= patch.z[0] - 1e-12) & (field.z <= patch.z[1] + 1e-12))] = 1
    grid = ("theta", "z")
    variables: dict[str, Any] = {
        "pressure": (grid, field.pressure, _named("Pa", "film pressure above ambient")),
        "liquid_fraction": (grid, field.liquid_fraction, _named("1", "share of the gap that is filled with oil")),
        "film_thickness": (grid, field.film_thickness, _named("m", "film thickness")),
        "supply": (grid, supply, _named("1", "1 over grooves, pockets and holes, 0 elsewhere")),
    }
    coords = {
        "theta": ("theta", field.theta, _named("rad", "angle around the bore, counter-clockwise from +x")),
        "z": ("z", field.z, _named("m", "place along the shaft, from the mid-plane")),
    }
    if state.thermal is not None:
        coords |= temperature_coordinates(state.thermal)
        variables |= temperature_variables(state.thermal, field)
    x, y = (float(part) for part in film.position)
    variables["journal_x"] = ((), x, _named("m", "journal centre from the bearing centre, x"))
    variables["journal_y"] = ((), y, _named("m", "journal centre from the bearing centre, y"))
    variables["load_angle"] = ((), case.load_angle, _named("rad", "direction of the load, from +x"))
    for name, value in result.values.items():
        if name in QUANTITIES and name not in variables and name != "wall_time":
            variables[name] = ((), float(value), _named(QUANTITIES[name].unit, QUANTITIES[name].meaning))
    made: xarray.Dataset = package.Dataset(
        variables,
        coords=coords,
        attrs={
            "title": str(result.name),  # as plain text: h5py writes no kinds of text of our own
            "source": f"Babbitt {__version__}",
            "rotation": case.rotation.value,
            "thermal": result.settings["thermal"],
            "cavitation": case.cavitation.name.lower(),
            "axes": "x right, y up, seen against z; pressures are gauge",
        },
    )
    return made


def temperature_coordinates(thermal: ThermalFilm) -> dict[str, Any]:
    """Places across the gap."""
    eta = (0.0, *(float(one) for one in thermal.layers), 1.0)
    return {"eta": ("eta", list(eta), _named("1", "place across the gap, 0 on the bush and 1 on the journal"))}


def temperature_variables(thermal: ThermalFilm, field: FilmField) -> dict[str, Any]:
    """Temperatures of a film over the bore, across the gap and on the bore."""
    through = temperature_through(thermal, field.theta)
    return {
        "temperature": (
            ("theta", "z"),
            temperature_over(thermal, field),
            _named("K", "film temperature, mean across the gap"),
        ),
        "temperature_through": (
            ("theta", "eta"),
            through,
            _named("K", "film temperature across the gap in the middle of the width"),
        ),
        "bush_temperature": ("theta", through[:, 0], _named("K", "temperature of the bore")),
    }


def _named(units: str, meaning: str) -> dict[str, str]:
    return {"units": units, "long_name": meaning}
