"""Fields of a film with names and units: an xarray Dataset, saved as NetCDF."""

from __future__ import annotations

import math
import tempfile
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.bearings.field import field_of, supply_patches
from babbitt.bearings.model import FilmCase
from babbitt.bearings.warm_film import under_found_load
from babbitt.notices import InputError
from babbitt.quantities import QUANTITIES
from babbitt.report.writing import require_writable, write_whole
from babbitt.results import Result

if TYPE_CHECKING:
    import xarray

__all__ = ["fields", "write_fields"]

TURN = 2.0 * math.pi


def fields(case: FilmCase, result: Result) -> xarray.Dataset:
    """Pressure, liquid fraction and film thickness over the bore, and the values of the result beside them.

    Parameters
    ----------
    case : FilmCase
    result : Result
        Its answer.

    Returns
    -------
    xarray.Dataset
        Dimensions ``theta`` (rad, counter-clockwise from +x, one turn that begins opposite the load) and ``z`` (m,
        from the mid-plane). Every variable has ``units`` and ``long_name``. The values of the result stand as
        variables without dimension under their names. ``film_thickness`` is not a number over grooves and pockets,
        where ``supply`` is 1.

    Raises
    ------
    InputError
        E003 for a result without an operating point, E007 when xarray is not installed.
    """
    try:
        import xarray
    except ImportError:
        raise _missing("xarray") from None
    import numpy as np

    from babbitt.report.film_sweeps import state_of

    if not result.outcome.solved:
        raise InputError("E003", f"{result.name}: no fields without an operating point ({result.outcome.value})")
    state = state_of(case, result)
    solution, case = state.solution, under_found_load(case, state)
    field = field_of(solution, case.load_angle - math.pi)
    supply = np.zeros(field.pressure.shape, dtype=np.int8)
    for patch in supply_patches(solution.film):
        around = np.remainder(field.theta - patch.theta[0] + 1e-9, TURN) <= patch.theta[1] - patch.theta[0] + 2e-9
        supply[np.ix_(around, (field.z >= patch.z[0] - 1e-12) & (field.z <= patch.z[1] + 1e-12))] = 1
    grid = ("theta", "z")
    variables: dict[str, Any] = {
        "pressure": (grid, field.pressure, _named("Pa", "film pressure above ambient")),
        "liquid_fraction": (grid, field.liquid_fraction, _named("1", "share of the gap that is filled with oil")),
        "film_thickness": (grid, field.film_thickness, _named("m", "film thickness")),
        "supply": (grid, supply, _named("1", "1 over grooves, pockets and holes, 0 elsewhere")),
    }
    x, y = (float(part) for part in solution.position)
    variables["journal_x"] = ((), x, _named("m", "journal centre from the bearing centre, x"))
    variables["journal_y"] = ((), y, _named("m", "journal centre from the bearing centre, y"))
    variables["load_angle"] = ((), case.load_angle, _named("rad", "direction of the load, from +x"))
    for name, value in result.values.items():
        if name in QUANTITIES and name not in variables and name != "wall_time":
            variables[name] = ((), float(value), _named(QUANTITIES[name].unit, QUANTITIES[name].meaning))
    return xarray.Dataset(
        variables,
        coords={
            "theta": ("theta", field.theta, _named("rad", "angle around the bore, counter-clockwise from +x")),
            "z": ("z", field.z, _named("m", "place along the shaft, from the mid-plane")),
        },
        attrs={
            "title": result.name,
            "source": f"Babbitt {__version__}",
            "rotation": case.rotation.value,
            "cavitation": case.cavitation.name.lower(),
            "axes": "x right, y up, seen against z; pressures are gauge",
        },
    )


def write_fields(case: FilmCase, result: Result, path: str | Path) -> None:
    """Save the fields of a film as NetCDF 4.

    Parameters
    ----------
    case : FilmCase
    result : Result
    path : str or Path
        Ends in ``.nc``.

    Raises
    ------
    InputError
        E003 for a result without an operating point; E007 when the file cannot be written or an extra is not
        installed. Nothing is left behind then.
    """
    path = Path(path)
    if path.suffix.lower() != ".nc":
        raise InputError("E007", f"cannot write {path}: fields are saved as NetCDF, in a file that ends in .nc")
    require_writable(path)
    dataset = fields(case, result)
    for engine in ("h5netcdf", "h5py"):  # xarray writes with the first, which rests on the second
        try:
            import_module(engine)
        except ImportError:
            raise _missing(engine) from None
    with tempfile.TemporaryDirectory(prefix="babbitt-") as folder:
        partial = Path(folder) / "fields.nc"
        dataset.to_netcdf(partial, engine="h5netcdf")
        write_whole(path, partial.read_bytes())


def _named(units: str, meaning: str) -> dict[str, str]:
    return {"units": units, "long_name": meaning}


def _missing(package: str) -> InputError:
    return InputError(
        "E007",
        f"fields need the package {package}, which is not installed. "
        "Install it with: pip install 'babbitt[files]'",
    )
