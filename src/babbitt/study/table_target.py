"""Which bearing a table is made of and where it goes: decided before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.core.files.printing import printable
from babbitt.core.files.writing import require_distinct, require_writable
from babbitt.core.kind import find_kind
from babbitt.core.notices import InputError
from babbitt.core.solution import CoefficientsOverSpeed
from babbitt.export import FORMATS

__all__ = ["chosen_problem", "require_target"]


def chosen_problem(case: CaseFile, file: Path, name: str | None) -> tuple[Any, CoefficientsOverSpeed]:
    """Give the problem of a name, or the only one, and its method, which knows coefficients over the speed.

    Raises
    ------
    InputError
        E004 when no bearing names such a method or several could be meant, E005 for an unknown name.
    """
    films = {
        one.problem.name: (one.problem, one.method)
        for one in case.calculations()
        if isinstance(one.method, CoefficientsOverSpeed)
    }
    kind = find_kind(case.kind)
    if not films and kind is not None and kind.no_coefficients:
        raise InputError("E004", f"{file}: {kind.no_coefficients}")
    if not films:
        raise InputError(
            "E004", f"{file}: no bearing names the film method, which alone has coefficients; write method: film"
        )
    if name is None and len(films) > 1:
        raise InputError("E004", f"{file}: several bearings; choose with --bearing: {', '.join(films)}")
    if name is not None and name not in films:
        raise InputError("E005", f"{file}: no film of '{name}'; there are: {', '.join(films)}")
    return films[name] if name is not None else next(iter(films.values()))


def require_target(
    format_name: str,
    name: str,
    clockwise: bool,
    inputs: Mapping[Path, str],
    output: Path,
    other_end: bool,
    speeds: Sequence[float],
) -> None:
    """Refuse a format that does not exist, cannot hold the rotation sense or needs more speeds, and a file that
    is not of the format, or that is an input of the run.

    Raises
    ------
    InputError
        E005 for an unknown format, E004 for a rotation sense that it has no place for, E003 for too few speeds,
        E007 for the file.
    """
    if format_name not in FORMATS:
        raise InputError("E005", f"no format '{format_name}'; there are: {', '.join(FORMATS)}")
    wanted = FORMATS[format_name]
    if clockwise is not other_end and not wanted.either_rotation:
        turned = "clockwise from the other end" if other_end else "clockwise"
        do = "leave out --other-end" if other_end else "add --other-end, and build the rotor from that end"
        raise InputError(
            "E004",
            f"{name} turns {turned}, but {format_name} takes counter-clockwise rotation for granted and "
            f"would take the cross-coupling with the wrong sign; {do}, or choose csv or json",
        )
    if output.suffix.lower() not in wanted.suffixes:
        raise InputError(
            "E007", f"cannot write {printable(output)}: {format_name} is {' or '.join(wanted.suffixes)}"
        )
    if len(speeds) < wanted.fewest_speeds:
        raise InputError(
            "E003",
            f"--speeds: {format_name} interpolates between at least {wanted.fewest_speeds} speeds, and "
            f"{len(speeds)} {'is' if len(speeds) == 1 else 'are'} given; write more over the range of the rotor "
            "(10 to 20 are better), such as --speeds '500 rpm:5000 rpm:10', or choose csv or json",
        )
    require_distinct([output], inputs)
    require_writable(output)
