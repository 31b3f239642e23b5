"""The answers for all bearings of a case, by name, point and clearance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt.api.results import BearingResult
from babbitt.core.nearest_name import unknown_name
from babbitt.core.result_name import ResultName

if TYPE_CHECKING:
    import pandas

    from babbitt.solving import MachineResult

__all__ = ["MachineResults"]

SHOWN = 20
"""Bearings that are listed."""


@dataclass(frozen=True, repr=False)
class MachineResults:
    """The results of a solved case, one for each bearing, operating point and clearance or steady state.

    Parameters
    ----------
    machine : MachineResult
        From `babbitt.solving.solve`.
    """

    machine: MachineResult

    @property
    def name(self) -> str:
        """Of the case."""
        return self.machine.name

    @property
    def results(self) -> tuple[BearingResult, ...]:
        """One for each bearing, operating point and clearance."""
        return tuple(
            BearingResult(one, self.machine.case_hash, self.machine.case_text) for one in self.machine.solutions
        )

    @property
    def solved(self) -> bool:
        """Whether every bearing has an operating point."""
        return self.machine.solved

    @property
    def within_limits(self) -> bool:
        """Whether every bearing passes."""
        return self.machine.within_limits

    def __iter__(self) -> Iterator[BearingResult]:
        return iter(self.results)

    def __len__(self) -> int:
        return len(self.machine.solutions)

    def __getitem__(self, name: str) -> BearingResult:
        """The result of a name: that of a whole result, or of a bearing with one result.

        Raises
        ------
        KeyError
            For an unknown name, and for a bearing with several results.
        """
        for one in self.results:
            if one.name == name:
                return one
        return self.sel(bearing=name)

    def sel(
        self, *, bearing: str | None = None, point: str | None = None, clearance: str | None = None,
        state: str | None = None,
    ) -> BearingResult:  # fmt: skip
        """The one result of a bearing, operating point, clearance or steady state.

        Parameters
        ----------
        bearing, point, clearance, state : str, optional
            What the result must be of; left out, there must be one of it.

        Raises
        ------
        KeyError
            Where no result is of all that, with the nearest name, or where several are, with their names.
        """
        asked = {"bearing": bearing, "point": point, "clearance": clearance, "state": state}
        left = list(self.results)
        for part, wanted in asked.items():
            if wanted is None:
                continue
            there = [_part(one, part) for one in left]
            if wanted not in there:
                known = [one for one in there if one]
                raise KeyError(unknown_name(wanted, known, f"a {part} of these results"))
            left = [one for one, own in zip(left, there, strict=True) if own == wanted]
        if len(left) != 1:
            raise KeyError(f"{len(left)} results are meant; name one of: {', '.join(one.name for one in left)}")
        return left[0]

    def to_dict(self) -> dict[str, Any]:
        """Plain dictionaries, lists, strings and finite numbers in SI (`babbitt.report.export.to_json`)."""
        from babbitt.report.export import to_json

        return to_json(self.machine)

    def to_json(self) -> str:
        """The JSON text of `to_dict`, indented."""
        from babbitt.report.export import write_json

        return write_json(self.machine)

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each result: bearing, point, clearance and state, verdict, values, entries of matrices.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        from babbitt.api.tables import frame_of

        parts = ("bearing", "point", "clearance", "state")
        return frame_of([{part: _part(one, part) for part in parts} for one in self.results], self.results)

    def write_report(self, path: str | Path) -> None:
        """Write the report of the machine, as PDF or HTML by the suffix.

        Raises
        ------
        InputError
            E007 for another suffix, a path that cannot be written, or a package that is not installed.
        """
        from babbitt.report.document import write_report

        write_report(self.machine, Path(path))

    def __repr__(self) -> str:
        rows = self._rows()
        widths = [max((len(row[column]) for row in rows), default=0) for column in range(3)]
        lines = [
            "  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
            for row in rows[:SHOWN]
        ]
        left = len(rows) - SHOWN
        return "\n".join(
            [f"{self.name}: {len(rows)} results", *lines, *([f"  and {left} more"] if left > 0 else [])]
        )

    def _repr_html_(self) -> str:
        body = "".join(
            f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in self._rows()[:SHOWN]
        )
        return f"<table><caption>{escape(self.name)}</caption><tbody>{body}</tbody></table>"

    def _rows(self) -> list[tuple[str, str, str]]:
        """Name, verdict, and the governing check or why there is no operating point."""
        from babbitt.report.text import plain_text
        from babbitt.report.verdict import comparison

        def why(one: BearingResult) -> str:
            if not one.solved:
                return one.outcome.value
            return comparison(one.governing_check) if one.governing_check is not None else ""

        return [(plain_text(one.name), one.verdict.value, why(one)) for one in self.results]


def _part(one: BearingResult, part: str) -> str:
    """What the name of a result is made of; a plain name is that of its bearing."""
    if isinstance(one.name, ResultName):
        own: str = getattr(one.name, part)
        return own
    return str(one.name) if part == "bearing" else ""
