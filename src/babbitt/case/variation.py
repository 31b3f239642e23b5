"""The case of a file with another value in one of its fields."""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from babbitt.case.aliases import in_method_mappings, in_todays_words, part_at, scaled, todays_field
from babbitt.case.case_file import CaseFile, Origin
from babbitt.case.case_hash import case_hash
from babbitt.case.field_types import expanded, field_annotations
from babbitt.case.kinds import KINDS
from babbitt.case.load_components import DIRECTION, LOAD
from babbitt.case.loading import build_case, load_case, read_file
from babbitt.case.method_mapping import METHOD, every_choice
from babbitt.case.named_files import NamedFiles
from babbitt.case.nested import values_at, without_value
from babbitt.case.parts.cooling import Cooling
from babbitt.case.parts.load_and_speed import LOADS, SPEEDS
from babbitt.case.parts.materials import Materials
from babbitt.case.parts.supply import Supply
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach
from babbitt.core.notices import InputError
from babbitt.core.units import SiNumber

__all__ = ["CaseVariation", "case_variation", "variation_of"]

ALTERNATIVES = (LOADS, SPEEDS, ("width", "width_ratio"))
"""Fields of which a value in one takes the place of the others."""


POINT_FIELDS = (LOADS, SPEEDS, ("supply_pressure", "supply_flow"))
"""Fields of operating points of which a value in one takes the place of the others of the bearing."""

SHARED: Mapping[str, tuple[tuple[str, ...], ...]] = {
    "lubricant": (),
    "supply": Supply.alternatives,
    "cooling": Cooling.alternatives,
    "materials": Materials.alternatives,
}
"""Parts that a machine gives to its bearings, and their fields that take the place of each other."""


class CaseVariation:
    """A case file one field of which takes other values.

    Parameters
    ----------
    file : Path
    given : dict
        What stands in it; kept in the words of today.
    path : str
        Field to vary, its names and numbers between dots: ``load``, ``clearance.mean``,
        ``operating_points.0.load``; former words will do.
    start : tuple of str
        Where in the file the path begins.
    reach : Reach
        Where the case may name other files.
    inputs : tuple of Path
    bearing : str, optional
        Name of the bearing of a machine at which the path starts.

    Attributes
    ----------
    field : str
        The path from the top of the file.
    inputs : tuple of Path
        The other files that the case as it stands names.
    """

    def __init__(
        self,
        file: Path,
        given: dict[str, Any],
        path: str,
        start: tuple[str, ...] = (),
        reach: Reach = Reach.FOLDER,
        inputs: tuple[Path, ...] = (),
        bearing: str | None = None,
    ) -> None:
        self.file, self.path, self.reach, self.inputs = file, path, reach, inputs
        self._bearing = bearing
        self.field = ".".join((*start, path))
        self._model, steps = KINDS[given["kind"]], (*start, *path.split("."))
        self.given: dict[str, Any] = in_todays_words(self._model, given)
        self._steps, self._scale = todays_field(self._model, steps)

    @property
    def present(self) -> Any:
        """What stands in the field now; None where nothing does."""
        try:
            value = self._container(copy.deepcopy(self.given))
            return scaled(value[_key(value, self._steps[-1])], 1.0 / self._scale)
        except (LookupError, TypeError, InputError):
            return None

    @property
    def whole_path(self) -> str:
        """The path of the field from the top of the case, in words of today, a bearing by its name."""
        if self._bearing is None:
            return ".".join(self._steps)
        return ".".join(("bearings", self._bearing, *self._steps[2:]))

    @property
    def unchanged(self) -> CaseFile:
        """The case as it stands in the file, of a machine with the one bearing alone."""
        return build_case(self.given, printable(self.file), NamedFiles(self.file.parent, self.reach))

    def case(self, value: str | SiNumber) -> CaseFile:
        """The case with a value in the field, as a file has it or as a number in SI.

        Raises
        ------
        CaseError
            With every problem, as for a case file that says so.
        InputError
            E005 when the path leads through something that is no mapping or list.
        """
        title = f"{printable(self.file)} with {self.path}: {value}"
        return build_case(self.given_with(value), title, NamedFiles(self.file.parent, self.reach))

    def given_with(self, value: Any) -> dict[str, Any]:
        """What stands in the file, with a value in the field in place of what says the same otherwise.

        A mapping as `method` takes the place of the choices that there were, components as `load` that of its
        direction.

        Raises
        ------
        InputError
            E005 when the path leads through something that is no mapping or list.
        """
        varied = copy.deepcopy(self.given)
        place, name = self._container(varied), self._steps[-1]
        self._refuse_if_overridden()
        self._refuse_if_it_follows()
        for others in ALTERNATIVES:
            if name in others and isinstance(place, dict):
                for other in others:
                    place.pop(other, None)
        if name == METHOD and isinstance(place, dict) and isinstance(value, Mapping):
            self._forget_choices(place)
        if name == LOAD and isinstance(place, dict) and isinstance(value, Mapping):
            place.pop(DIRECTION, None)
        try:
            place[_key(place, name)] = scaled(value, self._scale)
        except LookupError:
            raise InputError("E005", f"{self.file}: there is no '{self.path}'{_known(place)}") from None
        made: dict[str, Any] = in_method_mappings(self._model, varied)
        return made

    def _forget_choices(self, place: dict[str, Any]) -> None:
        """Take the choices of all methods out of a bearing."""
        left = place
        for path in every_choice(part_at(self._model, self._steps[:-1])).values():
            left = without_value(left, path)
        for name in place.keys() - left.keys():
            del place[name]
        place.update(left)

    def _refuse_if_overridden(self) -> None:
        """Refuse a field in whose place all bearings or operating points have their own: nothing would change."""
        first, *rest = self._steps
        bearings = self.given.get("bearings")
        if not isinstance(bearings, list):
            instead = _of_points(self.given, (), first, rest)
        elif first == "bearings" and not rest:
            instead = []
        elif first == "bearings":
            owner = bearings[int(rest[0])]
            instead = _of_points(owner, (first, rest[0]), rest[1], rest[2:]) if len(rest) > 1 else []
        else:
            own = [
                _of_bearing(one, first, rest, f"bearings.{number}") or _of_points(one, path, first, rest)
                for number, one in enumerate(bearings)
                for path in [("bearings", str(number))]
            ]
            instead = [one for found in own for one in found] if all(own) else []
        if instead:
            whose = "bearing or operating point" if isinstance(bearings, list) else "operating point"
            says = f"every {whose} gives its own, so that '{self.path}' changes nothing"
            also = ", ".join(f"'{one}'" for one in instead)
            raise InputError("E005", f"{self.file}: {says}; vary {also}")

    def _refuse_if_it_follows(self) -> None:
        """Refuse a field that follows from two others, which the file gives."""
        for count, step in enumerate(self._steps):
            two_of = part_at(self._model, self._steps[:count]).two_of
            place = next(values_at(self.given, self._steps[:count]), None)
            if step not in two_of or not isinstance(place, dict) or step in place:
                continue
            there = [name for name in two_of if name in place]
            if len(there) > 1:
                way = [".".join((*self._steps[:count], name, *_mean_of(place[name]))) for name in there]
                follows = ".".join(self._steps[: count + 1])
                says = f"the case gives {' and '.join(there)}, from which '{follows}' follows"
                also = " or ".join(f"'{one}'" for one in way)
                also += ", or give it in the file in place of one"
                raise InputError("E005", f"{self.file}: {says}; vary {also}")

    def _expanded(self, count: int, value: Any) -> Any:
        """The mapping for which a word stands in short after so many steps, where it has the next one."""
        short = isinstance(value, str)
        types = field_annotations(self._model, self._steps[:count], self.given) if short else ()
        found = (expanded(one, value) for one in types)
        return next((one for one in found if isinstance(one, dict) and self._steps[count] in one), value)

    def _container(self, given: Any) -> Any:
        place = given
        for count, step in enumerate(self._steps[:-1], 1):
            here = ".".join(self._steps[:count])
            try:
                if isinstance(place, dict) and step not in place:
                    place[step] = {}
                place[_key(place, step)] = self._expanded(count, place[_key(place, step)])
                place = place[_key(place, step)]
            except (LookupError, ValueError):
                raise InputError(
                    "E005", f"{self.file}: there is no '{here}' to look into{_known(place)}"
                ) from None
            if not isinstance(place, dict | list):
                hint = f"write it as a mapping in the file, or vary '{here}' itself"
                raise InputError("E005", f"{self.file}: '{here}' is '{place}', not a mapping; {hint}")
        return place


def case_variation(
    file: Path, path: str, bearing: str | None = None, reach: Reach = Reach.FOLDER
) -> CaseVariation:
    """Read a case file of which one field is to vary.

    Parameters
    ----------
    file : Path
    path : str
        From the top of the file, or from a bearing.
    bearing : str, optional
        Name of a bearing of a machine: the path begins there, and the other bearings are left out.
    reach : Reach
        Where the case may name other files.

    Raises
    ------
    CaseError
        When the file as it stands is not usable.
    InputError
        E005 for a bearing that the file does not have, or an empty path.
    """
    inputs = load_case(file, reach).files  # reports every problem with its line
    given = read_file(file)
    if not all(path.split(".")):
        raise InputError("E005", f"'{path}' names no field; write it as load, or clearance.mean")
    if bearing is None:
        return CaseVariation(file, given, path, reach=reach, inputs=inputs)
    names = [one["name"] for one in given.get("bearings", ())] or [given.get("name")]
    if bearing not in names:
        raise InputError("E005", f"{file}: no bearing '{bearing}'; there are: {', '.join(map(str, names))}")
    if "bearings" not in given:
        return CaseVariation(file, given, path, reach=reach, inputs=inputs)
    alone = given | {"bearings": [given["bearings"][names.index(bearing)]]}
    return CaseVariation(file, alone, path, ("bearings", "0"), reach, inputs, bearing)


def variation_of(case: CaseFile, path: str) -> CaseVariation:
    """Vary one field of a case that was read.

    Parameters
    ----------
    case : CaseFile
        From a file, a text or a dictionary.
    path : str
        As in `CaseVariation`.

    Raises
    ------
    InputError
        E005 for an empty path, and for a case that was made of its classes or changed after it was read: what it
        derived from other fields is not known.
    """
    origin = case.origin
    if not all(path.split(".")):
        raise InputError("E005", f"'{path}' names no field; write it as load, or clearance.mean")
    if origin is None:
        raise InputError("E005", f"{case.name}: only a case from a file, a text or a dictionary can be varied")
    if case_hash(build_case(origin.given, str(origin.file), _files_of(origin))) != case_hash(case):
        raise InputError("E005", f"{case.name}: the case was changed after it was read")
    return CaseVariation(
        origin.file, copy.deepcopy(dict(origin.given)), path, reach=origin.reach, inputs=case.files
    )


def _of_points(bearing: Any, path: tuple[str, ...], part: str, rest: Sequence[str]) -> list[str]:
    """Fields of the operating points of a bearing in the place of one of its own; empty where a point has none."""
    points = bearing.get("operating_points") if isinstance(bearing, dict) else None
    name = f"supply_{rest[0]}" if part == "supply" and rest else part
    names = next((group for group in POINT_FIELDS if name in group), (name,))
    if not isinstance(points, list):
        return []
    own = [number for number, point in enumerate(points) if isinstance(point, dict) and point.keys() & set(names)]
    found = [".".join((*path, "operating_points", str(number), name)) for number in own]
    return found if len(own) == len(points) else []


def _of_bearing(bearing: Any, part: str, rest: Sequence[str], path: str) -> list[str]:
    """Field of a bearing in the place of one of its machine; empty where it has none."""
    own = bearing.get(part) if isinstance(bearing, dict) else None
    if part not in SHARED or own is None:
        return []
    if part == "lubricant":
        return [f"{path}.lubricant"]
    names = next((group for group in SHARED[part] if rest and rest[0] in group), tuple(rest[:1]))
    given = isinstance(own, dict) and bool(own.keys() & set(names))
    return [f"{path}.{part}.{rest[0]}"] if given else []


def _files_of(origin: Origin) -> NamedFiles:
    return NamedFiles(origin.file.parent, origin.reach)


def _mean_of(given: Any) -> tuple[str, ...]:
    """The way to the number of a clearance that has limits or a kind."""
    return ("mean",) if isinstance(given, Mapping) and "mean" in given else ()


def _known(place: Any) -> str:
    """Which numbers a list knows, counted from 0."""
    if not isinstance(place, list):
        return ""
    return (
        f"; the list has {f'0 to {len(place) - 1}' if len(place) > 1 else '0 only'}" if place else "; it is empty"
    )


def _key(place: Any, step: str) -> str | int:
    if not isinstance(place, list):
        return step
    if not step.isdecimal() or int(step) >= len(place):
        raise LookupError(step)
    return int(step)
