"""What to say of a name that nothing has: the nearest that there is."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

__all__ = ["unknown_name"]


def unknown_name(name: object, known: Iterable[str], what: str) -> str:
    """A sentence on a name that is not known.

    >>> unknown_name("stifness", ["stiffness", "damping"], "a result")
    "'stifness' is not a result; did you mean 'stiffness'?"
    >>> unknown_name("colour", ["stiffness", "damping"], "a result")
    "'colour' is not a result; there are: stiffness, damping"
    """
    names = list(dict.fromkeys(known))
    near = difflib.get_close_matches(str(name), names, 1)
    if near:
        return f"{name!r} is not {what}; did you mean {near[0]!r}?"
    return f"{name!r} is not {what}; there are: {', '.join(names) or 'none'}"
