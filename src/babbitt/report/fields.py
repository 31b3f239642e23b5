"""Fields of films saved as NetCDF."""

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.case.case_file import CaseFile
from babbitt.core.files.writing import require_writable, write_file
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install, optional_package
from babbitt.core.solution import Solution
from babbitt.report.text import plain_text
from babbitt.report.view import find_view, view_of

if TYPE_CHECKING:
    import xarray

    from babbitt.solving import MachineResult

__all__ = ["fields", "require_films", "require_netcdf", "require_package", "write_fields", "write_machine_fields"]


def fields(solution: Solution) -> xarray.Dataset:
    """Fields of a solution as a dataset, each variable with ``units`` and ``long_name``.

    Parameters
    ----------
    solution : Solution
        By a method that knows fields.

    Raises
    ------
    InputError
        E003 for a result without an operating point, E004 for a method without fields, E007 when xarray is not
        installed.
    """
    made = view_of(solution.result).fields
    if made is None:
        raise _no_films(solution.result.name)
    return made(solution)


def write_fields(solution: Solution, path: str | Path) -> None:
    """Save the fields of a film as NetCDF 4.

    Parameters
    ----------
    solution : Solution
        Of a film.
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
    _save(path, {None: fields(solution)})


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
    films = [one for one in machine.solutions if view_of(one.result).fields is not None]
    if not films:
        raise _no_films(machine.name)
    found = {one.result.name: fields(one) for one in films if one.result.outcome.solved}
    if found and len(films) == 1:
        _save(path, {None: next(iter(found.values()))})
    elif found:
        import xarray

        root = xarray.Dataset(attrs={"title": machine.name, "source": f"Babbitt {__version__}"})
        _save(path, {None: root, **dict(zip(_groups(tuple(found)), found.values(), strict=True))})
    return tuple(one.result.name for one in films if one.result.name not in found)


def require_films(name: str, case: CaseFile) -> None:
    """Refuse a case without a film.

    Raises
    ------
    InputError
        E004.
    """
    asked = ((one.problem.kind, one.method.name) for one in case.calculations())
    if all(find_view(kind, method).fields is None for kind, method in asked):
        raise _no_films(name)


def _no_films(name: str) -> InputError:
    return InputError(
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
        require_package(package)


def require_package(package: str) -> Any:
    """Import a package that fields need.

    Raises
    ------
    InputError
        E007 where it is not installed.
    """
    return optional_package(package, "fields", how_to_install(package, "files"))


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
