"""Finding an entry by a name that people spell in many ways."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TypeVar

from babbitt.core.nearest_name import nearest_names
from babbitt.core.notices import InputError

Entry = TypeVar("Entry")

_IGNORED = re.compile(r"[\s_-]+")


def spelling(name: str) -> str:
    """Spelling by which names are compared: without case, spaces, hyphens and underscores.

    Examples
    --------
    >>> spelling("EN-GJL 250")
    'engjl250'
    """
    return _IGNORED.sub("", name.casefold())


def find(name: str, entries: Mapping[str, Entry], what: str, names: tuple[str, ...]) -> Entry:
    """Entry of that name.

    Parameters
    ----------
    name : str
        As the user wrote it.
    entries : Mapping
        By `spelling`, aliases included.
    what : str
        What is looked for, for the message.
    names : tuple of str
        Names to suggest.

    Raises
    ------
    InputError
        E005 naming the nearest entries.
    """
    try:
        return entries[spelling(name)]
    except KeyError:
        pass
    near = nearest_names(name, names, most=3, spelled=spelling)
    suggestion = f"nearest: {', '.join(near)}" if near else "no similar name"
    raise InputError(
        "E005",
        f"no {what} named {name[:60]!r} in the catalogue ({suggestion}); `babbitt list materials` shows all "
        "names, and so does the workbench under Oils and metals",
    )
