"""Fields of a film with names and units: an xarray Dataset, saved as NetCDF."""

from __future__ import annotations

import itertools
import math
import tempfile
from collections.abc import Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.core.files.writing import require_writable, write_file
from babbitt.core.notices import InputError
from babbitt.core.notices.unusable import how_to_install
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.journal.film.field import FilmField, field_of, supply_patches
from babbitt.kinds.journal.film.isothermal import under_found_load
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.temperature_field import temperature_over, temperature_through
from babbitt.report.text import plain_text

if TYPE_CHECKING:
    import xarray

    from babbitt.reynolds.heat.thermal_solution import ThermalFilm
    from babbitt.solving import MachineResult

__all__ = ["fields", "require_films", "require_netcdf", "write_fields", "write_machine_fields"]

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
        where ``supply`` is 1. A film with its own temperatures has ``temperature`` (K, mean across the gap) over
        the bore, ``temperature_through`` over ``theta`` and the place across the gap ``eta`` (0 on the bush, 1 on
        the journal) in the middle of the width, and ``bush_temperature`` over ``theta``.

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

    from babbitt.kinds.journal.report.film_state import state_of

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
    coords = {
        "theta": ("theta", field.theta, _named("rad", "angle around the bore, counter-clockwise from +x")),
        "z": ("z", field.z, _named("m", "place along the shaft, from the mid-plane")),
    }
    if state.thermal is not None:
        coords |= temperature_coordinates(state.thermal)
        variables |= temperature_variables(state.thermal, field)
    x, y = (float(part) for part in solution.position)
    variables["journal_x"] = ((), x, _named("m", "journal centre from the bearing centre, x"))
    variables["journal_y"] = ((), y, _named("m", "journal centre from the bearing centre, y"))
    variables["load_angle"] = ((), case.load_angle, _named("rad", "direction of the load, from +x"))
    for name, value in result.values.items():
        if name in QUANTITIES and name not in variables and name != "wall_time":
            variables[name] = ((), float(value), _named(QUANTITIES[name].unit, QUANTITIES[name].meaning))
    return xarray.Dataset(
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
    require_netcdf(path)
    require_writable(path)
    _save(path, {None: fields(case, result)})


def write_machine_fields(machine: MachineResult, path: str | Path) -> tuple[str, ...]:
    """Save the fields of every film of a machine in one NetCDF file.

    Parameters
    ----------
    machine : MachineResult
    path : str or Path
        Ends in ``.nc``. The film of a case that has one stands at the root of the file; several stand in groups
        that are named as the bearings are, but for slashes, which become hyphens, and for names of dots alone; of
        bearings whose groups would have one name, the later ones get a number. The attribute ``title`` of a group
        is the name of its bearing (``xarray.open_datatree`` reads them all, ``xarray.open_dataset(path,
        group=name)`` one).

    Returns
    -------
    tuple of str
        Names of films that are left out, for they have no operating point; nothing is written where all are.

    Raises
    ------
    InputError
        E004 without a film; E007 as `write_fields`.
    """
    path = Path(path)
    require_netcdf(path)
    require_writable(path)
    require_films(machine.name, machine.design_cases)
    pairs = [
        (case, result)
        for case, result in zip(machine.design_cases, machine.results, strict=True)
        if isinstance(case, FilmCase)
    ]
    found = {case.name: fields(case, result) for case, result in pairs if result.outcome.solved}
    if found and len(pairs) == 1:
        _save(path, {None: next(iter(found.values()))})
    elif found:
        import xarray

        root = xarray.Dataset(attrs={"title": machine.name, "source": f"Babbitt {__version__}"})
        _save(path, {None: root, **dict(zip(_groups(tuple(found)), found.values(), strict=True))})
    return tuple(case.name for case, _ in pairs if case.name not in found)


def require_films(name: str, designs: Sequence[object]) -> None:
    """Refuse a case without a film.

    Raises
    ------
    InputError
        E004.
    """
    if not any(isinstance(design, FilmCase) for design in designs):
        raise InputError(
            "E004", f"{name}: no bearing names the film method, which alone has fields; write method: film"
        )


def require_netcdf(path: Path) -> None:
    """Find out before any work is done whether fields can be saved under a name.

    Raises
    ------
    InputError
        E007 for another suffix, or when an extra is not installed.
    """
    if path.suffix.lower() != ".nc":
        raise InputError("E007", f"cannot write {path}: fields are saved as NetCDF, in a file that ends in .nc")
    for package in ("xarray", "h5netcdf", "h5py"):  # the first writes with the second, which rests on the third
        try:
            import_module(package)
        except ImportError:
            raise _missing(package) from None


def _groups(names: Sequence[str]) -> tuple[str, ...]:
    """Names of groups for bearings, all different: NetCDF takes a slash for a path, and dots for places in it.

    >>> _groups(["a/b", "a-b", ".", " left "])
    ('a-b', 'a-b (2)', '. (2)', 'left')
    """
    taken: dict[str, None] = {"": None, ".": None, "..": None}
    reserved = len(taken)
    for name in names:
        plain = plain_text(name).replace("/", "-")
        numbered = (f"{plain} ({count})".strip() for count in itertools.count(2))
        taken[next(one for one in itertools.chain([plain], numbered) if one not in taken)] = None
    return tuple(taken)[reserved:]


def _save(path: Path, datasets: Mapping[str | None, xarray.Dataset]) -> None:
    with tempfile.TemporaryDirectory(prefix="babbitt-") as folder:
        partial = Path(folder) / "fields.nc"
        for group, dataset in datasets.items():
            dataset.to_netcdf(partial, engine="h5netcdf", group=group, mode="w" if group is None else "a")
        write_file(path, partial.read_bytes())


def _named(units: str, meaning: str) -> dict[str, str]:
    return {"units": units, "long_name": meaning}


def _missing(package: str) -> InputError:
    return InputError(
        "E007",
        f"fields need the package {package}, which is not installed. {how_to_install(package, 'files')}",
    )
