"""What a part was given, in the words that its model has, and how the file put it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from babbitt.case.nested import values_at

if TYPE_CHECKING:
    from babbitt.case.error_messages import Path

__all__ = ["Reading"]


@dataclass(frozen=True)
class Reading:
    """What a part was given, in the words of its model.

    Attributes
    ----------
    given : Mapping
    written : Mapping
        The same as it stands in the file.
    moved : tuple
        Path in the file and path in the model of every value that stands elsewhere there.
    twice : tuple
        Of every value that stands at its former place and at that of today, the former path and that of today.
    unknown : tuple
        Paths of what no method has.
    scales : Mapping
        By former path, the value of the model over that in the file.
    """

    given: Mapping[str, Any]
    written: Mapping[str, Any]
    moved: tuple[tuple[Path, Path], ...] = ()
    twice: tuple[tuple[Path, Path], ...] = ()
    unknown: tuple[Path, ...] = ()
    scales: Mapping[Path, float] = field(default_factory=dict)

    def remark(self, path: Path) -> str:
        """Tell how a value was read that is not what the file has; empty for any other."""
        for former, today in self.moved:
            if path == today and (scale := self.scales.get(former, 1.0)) != 1.0:
                return f"{former[-1]} is read as {today[-1]}, {scale:g} times as large"
        return ""

    def as_written(self, path: Path) -> Path:
        """Give the path in the words of the file for one in those of the model."""
        for former, today in self.moved:
            if path[: len(today)] == today:
                return (*former, *path[len(today) :])
        for former, today in self.moved:
            if path and path == today[: len(path)] and not any(True for _ in values_at(self.written, path)):
                return former  # the mapping that the move made
        return path
