"""Lubricants and materials of one's own, in the form of the catalogues that ship.

They stand in ``lubricants.toml`` and ``materials.toml`` of a folder, or together in one file: that which
`VARIABLE` names, else in the folder of the user's settings. A faulty entry is named in a warning and left out.
"""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

from babbitt.core.files.bounded_text import loads_toml
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import UnreadableFileError, read_regular
from babbitt.core.nearest_name import nearest_names
from babbitt.core.notices import InputError

__all__ = [
    "LARGEST",
    "VARIABLE",
    "OwnTables",
    "own_entries",
    "own_tables",
    "part_of_entry",
    "refuse_unknown_fields",
    "texts",
]

VARIABLE = "BABBITT_CATALOGUE"
"""Names a folder or a file."""

LARGEST = 1_000_000
"""Bytes of a catalogue; that which ships takes about 10 000."""

LONGEST_NAME = 120

FAULTS = (TypeError, ValueError, AttributeError, LookupError, ArithmeticError)
"""What reading values of another type than expected raises."""


class Named(Protocol):
    """An entry of a catalogue."""

    @property
    def name(self) -> str:
        """As reports print it."""

    @property
    def aliases(self) -> tuple[str, ...]:
        """Other names it is found by."""


EntryT = TypeVar("EntryT", bound=Named)
PartT = TypeVar("PartT")


@dataclass(frozen=True)
class OwnTables:
    """What stands in a catalogue of one's own."""

    file: Path
    tables: Mapping[str, Any]


@cache
def own_tables(name: str) -> OwnTables | None:
    """The tables of one's own catalogue, read once; None where there is none.

    Parameters
    ----------
    name : str
        ``lubricants.toml`` or ``materials.toml``.

    Warns
    -----
    UserWarning
        For a file that cannot be read or is no TOML, and where what `VARIABLE` names is missing.
    """
    chosen = os.environ.get(VARIABLE, "")
    home = Path(chosen).expanduser() if chosen else _settings_folder()
    file = home / name if home.is_dir() else home
    try:
        return OwnTables(file, loads_toml(read_regular(file, LARGEST).decode("utf-8-sig")))
    except UnreadableFileError as error:
        if not error.missing or (chosen and file == home):
            _warn(file, error.says)
    except UnicodeDecodeError:
        _warn(file, "is not a text file in UTF-8")
    except ValueError as error:
        _warn(file, f"is no TOML: {error}")
    return None


def own_entries(
    own: OwnTables | None,
    key: str,
    read: Callable[[Mapping[str, Any], str], EntryT],
    spelled: Callable[[str], str],
    shipped: Iterable[EntryT],
) -> tuple[EntryT, ...]:
    """The entries of one's own that can be used.

    Parameters
    ----------
    own : OwnTables or None
    key : str
        Name of the list of entries.
    read : callable
        Makes an entry of its table and of its origin, or raises `InputError`.
    spelled : callable
        How names are compared.
    shipped : iterable
        Entries whose names are taken.

    Warns
    -----
    UserWarning
        For each entry that cannot be used: the file, the entry, the field.
    """
    if own is None:
        return ()
    listed = own.tables.get(key, [])
    if not isinstance(listed, list):
        _warn(own.file, f"{key} is no list of tables; write [[{key}]] before each entry")
        return ()
    taken = {spelled(name) for one in shipped for name in (one.name, *one.aliases)}
    found: list[EntryT] = []
    for number, table in enumerate(listed, 1):
        try:
            name = _name_of(table)
            _refuse_no_numbers(table)
            entry = read(table, str(own.file))
            if known := [one for one in (entry.name, *entry.aliases) if spelled(one) in taken]:
                raise InputError("E003", f"name: '{known[0]}' is in the catalogue already")
        except (InputError, *FAULTS) as error:
            named = table.get("name") if isinstance(table, Mapping) else None
            label = f"'{named[:LONGEST_NAME]}'" if isinstance(named, str) else f"{number}"
            says = error.message if isinstance(error, InputError) else str(error)
            _warn(own.file, f"entry {label} of {key} is left out: {says}")
            continue
        taken |= {spelled(one) for one in (name, *entry.aliases)}
        found.append(entry)
    return tuple(found)


def part_of_entry(field: str, read: Callable[[], PartT]) -> PartT:
    """Read what a field of an entry says.

    Raises
    ------
    InputError
        E003 that names the field, whatever is wrong with it.
    """
    try:
        return read()
    except InputError as error:
        raise InputError("E003", f"{field}: {error.message}") from None
    except KeyError as error:
        missing = str(error.args[0])
        raise InputError("E003", f"{field}: '{missing}' is missing or not known") from None
    except RecursionError:
        raise InputError("E003", f"{field}: refers to itself") from None
    except TypeError as error:
        raise InputError("E003", f"{field}: has a value of another type ({error})") from None
    except FAULTS as error:
        raise InputError("E003", f"{field}: {error}") from None


def refuse_unknown_fields(table: Mapping[str, Any], known: Iterable[str]) -> None:
    """Refuse an entry with a field that nothing reads.

    Raises
    ------
    InputError
        E003.
    """
    names = list(known)
    for field in table:
        if field not in names:
            near = nearest_names(field, names)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(names)}"
            raise InputError("E003", f"{field}: is no field of an entry; {hint}")


def texts(value: Any) -> tuple[str, ...]:
    """A list of texts.

    Raises
    ------
    TypeError
        For anything else.
    """
    if not isinstance(value, list | tuple) or not all(isinstance(one, str) for one in value):
        raise TypeError("is no list of texts")
    return tuple(value)


def _settings_folder() -> Path:
    from platformdirs import user_config_path

    return user_config_path("babbitt", appauthor=False)


def _name_of(table: Any) -> str:
    if not isinstance(table, Mapping):
        raise InputError("E003", "is no table")
    name = table.get("name")
    if not isinstance(name, str) or not name.strip() or len(name) > LONGEST_NAME or not name.isprintable():
        raise InputError("E003", f"name: must be one line of text of at most {LONGEST_NAME} characters")
    return name


def _refuse_no_numbers(table: Mapping[str, Any]) -> None:
    for path, value in _leaves(table, ()):
        if isinstance(value, float) and not math.isfinite(value):
            raise InputError("E003", f"{'.'.join(path)}: {value} is not a finite number")


def _leaves(value: Any, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
    if isinstance(value, Mapping):
        for name, one in value.items():
            yield from _leaves(one, (*path, str(name)))
    elif isinstance(value, list):
        for one in value:
            yield from _leaves(one, path)
    else:
        yield path, value


def _warn(file: Path, says: str) -> None:
    warnings.warn(f"{printable(file)}: {printable(says)}", stacklevel=4)
