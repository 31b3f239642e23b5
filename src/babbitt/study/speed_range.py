"""Speeds as the command line takes them: a list, or first, last and number."""

from __future__ import annotations

from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, si

SPEED = si("rad/s")

MOST_SPEEDS = 500
"""Speeds of one table."""

ALLOWED = "such as '500 rpm, 1000 rpm, 1500 rpm', or first:last:number such as '500 rpm:5000 rpm:10'"


def speeds_of(text: str) -> tuple[float, ...]:
    """Read speeds in rad/s, ascending and each once.

    Parameters
    ----------
    text : str
        Quantities between commas, or the first, the last and the number of equally spaced speeds between colons,
        each with its unit.

    Raises
    ------
    InputError
        E003 for anything else, for speeds that are not positive, and for more than `MOST_SPEEDS`.

    Examples
    --------
    >>> speeds_of("100 rad/s:300 rad/s:3"), speeds_of("2 rad/s, 1 rad/s")
    ((100.0, 200.0, 300.0), (1.0, 2.0))
    """
    try:
        found = _spaced(text) if ":" in text else [SPEED(part.strip()) for part in text.split(",")]
    except (QuantityError, ValueError) as error:
        raise InputError("E003", f"--speeds '{text}': {error}; allowed: {ALLOWED}") from None
    if min(found) <= 0.0:
        says = "speeds are positive; the sense of rotation is that of the case"
        raise InputError("E003", f"--speeds '{text}': {says}")
    if len(found) > MOST_SPEEDS:
        raise InputError("E003", f"--speeds '{text}': {len(found)} speeds; at most {MOST_SPEEDS} make a table")
    return tuple(sorted(set(found)))


def _spaced(text: str) -> list[float]:
    parts = text.split(":")
    if len(parts) != 3 or not parts[2].strip().isdecimal():
        raise ValueError("three parts are due, the last of them a whole number")
    first, last = (SPEED(part.strip()) for part in parts[:2])
    number = int(parts[2])
    if number < 2 or number > MOST_SPEEDS or last <= first:
        raise ValueError(f"the last speed is above the first, and there are 2 to {MOST_SPEEDS} of them")
    return [first + (last - first) * place / (number - 1) for place in range(number)]
