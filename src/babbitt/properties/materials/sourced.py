"""A number or a text with the place it comes from."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.core.notices import InputError


@dataclass(frozen=True)
class SourcedValue:
    """A positive number in SI and where it comes from.

    Raises
    ------
    InputError
        E003 if the value is not a positive finite number or no source is named.
    """

    value: float
    source: str

    def __post_init__(self) -> None:
        if not (math.isfinite(self.value) and self.value > 0.0):
            raise InputError("E003", f"a material value must be a positive number, given {self.value!r}")
        if not self.source.strip():
            raise InputError("E003", f"the material value {self.value!r} names no source")


@dataclass(frozen=True)
class SourcedText:
    """A statement in words and where it comes from."""

    text: str
    source: str
