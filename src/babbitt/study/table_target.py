"""Which bearing a table is made of and where it goes: decided before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.core.files.printing import printable
from babbitt.core.files.writing import require_distinct, require_writable
from babbitt.core.kind import find_kind
from babbitt.core.notices import InputError
from babbitt.core.result_name import ResultName
from babbitt.core.solution import CoefficientsOverSpeed
from babbitt.export import FORMATS

__all__ = ["chosen_problem", "require_target"]

Film = tuple[Any, CoefficientsOverSpeed]
"""A problem and its method."""


def chosen_problem(case: CaseFile, file: Path, name: str | None) -> Film:
    """Give the problem of a name, or the only one, and its method, which knows coefficients over the speed.

    Operating points that differ in their speed alone are one bearing, by its name without a point.

    Raises
    ------
    InputError
        E004 when no bearing names such a method or several could be meant, E005 for an unknown name.
    """
    films: dict[ResultName, Film] = {
        _result_name(one.problem): (one.problem, one.method)
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
    films = {**films, **_at_any_speed(case, list(films.values()))}
    bearings = {named.bearing for named in films}
    if name is None and len(bearings) == 1 and (whole := ResultName(*bearings)) in films:
        return films[whole]
    if name is None and len(films) > 1:
        said = f"several {_what_differs(list(films))}; choose with --bearing: {', '.join(films)}"
        raise InputError("E004", f"{file}: {said}")
    if name is not None and name not in films:
        raise InputError("E005", f"{file}: no film of '{name}'; there are: {', '.join(films)}")
    return films[ResultName(name)] if name is not None else next(iter(films.values()))


def _result_name(problem: Any) -> ResultName:
    """The name of a problem, which of other packages may be plain text."""
    name: str = problem.name
    return name if isinstance(name, ResultName) else ResultName(name)


def _at_any_speed(case: CaseFile, films: Sequence[Film]) -> dict[ResultName, Film]:
    """Bearings whose operating points differ in their speed alone, of which a table over speed holds for all."""
    found = {}
    for bearing in (case, *vars(case).get("bearings", ())):
        points = vars(bearing).get("operating_points", ())
        name = vars(bearing).get("name")
        own = [film for film in films if _result_name(film[0]).bearing == name]
        conditions = [point.model_dump(exclude={"name", "speed", "surface_speed"}) for point in points]
        senses = {method.is_clockwise(problem) for problem, method in own}
        alike = all(one == conditions[0] for one in conditions) and len(senses) == 1
        if len(own) == len(points) > 1 and alike:
            problem, method = own[0]
            whole = ResultName(_result_name(problem).bearing)
            found[whole] = (replace(problem, name=whole), method)
    return found


def _what_differs(names: Sequence[ResultName]) -> str:
    """What a name is to be chosen by."""
    if len({name.bearing for name in names}) > 1:
        return "bearings"
    return "operating points" if len({name.point for name in names}) > 1 else "clearances"


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
