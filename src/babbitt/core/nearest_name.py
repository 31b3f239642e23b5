"""What to say of a name that nothing has: the nearest that there are."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable

__all__ = ["ALIKE", "nearest_names", "unknown_name"]

ALIKE = 0.6
"""Likeness from which one name is taken for another (`difflib.SequenceMatcher.ratio`): two letters of three."""


def nearest_names(
    name: str,
    known: Iterable[str],
    *,
    most: int = 1,
    spelled: Callable[[str], str] = str.casefold,
    alike: float = ALIKE,
) -> tuple[str, ...]:
    """The known names that a name may have meant, the likeliest first; empty where none is like it.

    Parameters
    ----------
    name : str
        As it was written.
    known : iterable of str
    most : int
        How many at most.
    spelled : callable
        How names are compared; of two with one spelling the first counts.
    alike : float
        Likeness from which a name counts, from 0 to 1.

    Examples
    --------
    >>> nearest_names("Stifness", ["stiffness", "damping"]), nearest_names("colour", ["stiffness", "damping"])
    (('stiffness',), ())
    """
    by_spelling: dict[str, str] = {}
    for one in known:
        by_spelling.setdefault(spelled(one), one)
    near = difflib.get_close_matches(spelled(name), by_spelling, n=most, cutoff=alike)
    return tuple(by_spelling[one] for one in near)


def unknown_name(name: object, known: Iterable[str], what: str) -> str:
    """A sentence on a name that is not known.

    >>> unknown_name("stifness", ["stiffness", "damping"], "a result")
    "'stifness' is not a result; did you mean 'stiffness'?"
    >>> unknown_name("colour", ["stiffness", "damping"], "a result")
    "'colour' is not a result; there are: stiffness, damping"
    """
    names = list(dict.fromkeys(known))
    if near := nearest_names(str(name), names):
        return f"{name!r} is not {what}; did you mean {near[0]!r}?"
    return f"{name!r} is not {what}; there are: {', '.join(names) or 'none'}"
