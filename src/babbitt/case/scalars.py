"""What an unquoted word of a case file is: a number, true, false, nothing, or text.

The rules of YAML 1.2, since those of YAML 1.1 surprise: there `no` is false, `12:30` is 750, `010` is 8 and
`1e-3` is text. Dates, `yes`, `on` and the like stay text.
"""

from __future__ import annotations

import re

_NUMBER = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?")
_INTEGER = re.compile(r"[-+]?\d+")
_LONGEST_NUMBER = 40
_WORDS: dict[str, bool | float | None] = {
    "": None,
    "~": None,
    "null": None,
    "true": True,
    "false": False,
    ".inf": float("inf"),
    "+.inf": float("inf"),
    "-.inf": float("-inf"),
    ".nan": float("nan"),
}

Scalar = str | int | float | bool | None


def scalar(text: str) -> Scalar:
    """Give the value of an unquoted word.

    >>> [scalar(word) for word in ("1e-3", "no", "12:30", "2024-01-31", "010", "True", "250 mm")]
    [0.001, 'no', '12:30', '2024-01-31', 10, True, '250 mm']
    """
    if len(text) <= _LONGEST_NUMBER:
        if _INTEGER.fullmatch(text):
            return int(text)
        if _NUMBER.fullmatch(text):
            return float(text)
    # YAML knows null, Null and NULL, and no other mixture of small letters and capitals.
    known = text.lower() if text in (text.lower(), text.upper(), text.capitalize()) else text
    return _WORDS.get(known, text)
