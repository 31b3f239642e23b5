"""How far a computed value may lie from a published one."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol


class SetBy(StrEnum):
    """Who says that a value may not pass a bound: the source, the specification of the method, or we."""

    SOURCE = "source"
    SPECIFICATION = "specification"
    OWN = "own value"


class Tolerance(Protocol):
    """A measure of agreement."""

    def share(self, published: float, computed: float) -> float:
        """How much of the tolerance is used; 1 is the edge, not a number where nothing was computed."""
        ...

    def describe(self) -> str:
        """The tolerance in a few characters, in the unit of the values."""
        ...


@dataclass(frozen=True)
class Within:
    """Deviation either way: the larger of a relative and an absolute one.

    The absolute one may be half a unit of the last printed digit, where a print with few digits is coarser than
    the relative tolerance.

    Examples
    --------
    >>> Within(relative=0.01).share(200.0, 201.0)
    0.5
    >>> Within(absolute=0.5).describe()
    '± 0.5'
    """

    relative: float = 0.0
    absolute: float = 0.0

    def share(self, published: float, computed: float) -> float:
        """Deviation over the allowed one."""
        return abs(computed - published) / max(self.relative * abs(published), self.absolute)

    def describe(self) -> str:
        """Such as ``± 0.4 % or 0.00005``."""
        parts = [f"{100.0 * self.relative:g} %"] if self.relative else []
        if self.absolute:
            parts.append(f"{self.absolute:.6f}".rstrip("0") if self.absolute >= 1e-6 else f"{self.absolute:g}")
        return "± " + " or ".join(part.removesuffix(".") for part in parts)


@dataclass(frozen=True)
class AtMost:
    """An upper bound of a positive quantity: "not above".

    Examples
    --------
    >>> AtMost(SetBy.OWN).describe()
    'at most (own value)'
    """

    set_by: SetBy

    def share(self, published: float, computed: float) -> float:
        """Computed over published value; a value of the wrong sign keeps no bound."""
        return computed / published if computed >= 0.0 else math.inf

    def describe(self) -> str:
        """The kind of bound."""
        return f"at most ({self.set_by})"


@dataclass(frozen=True)
class AtLeast:
    """A lower bound of a positive quantity: "more than"."""

    set_by: SetBy

    def share(self, published: float, computed: float) -> float:
        """Published over computed value; a value of the wrong sign keeps no bound."""
        return published / computed if computed > 0.0 else math.inf

    def describe(self) -> str:
        """The kind of bound."""
        return f"at least ({self.set_by})"
