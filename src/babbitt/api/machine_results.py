"""The answers for all bearings of a case, by name, point and clearance."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from babbitt.api.results import BearingResult
from babbitt.core.nearest_name import unknown_name
from babbitt.core.result import Verdict
from babbitt.core.result_name import ResultName

if TYPE_CHECKING:
    import pandas
    import xarray

    from babbitt.solving import MachineResult

__all__ = ["MachineResults"]

SHOWN = 20
"""Bearings that are listed."""

PARTS = ("bearing", "point", "clearance", "state")
"""What the name of a result is made of."""


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

    @property
    def verdict(self) -> Verdict:
        """The gravest verdict of all bearings."""
        gravest = list(Verdict)
        return max((one.verdict for one in self.machine.results), key=gravest.index, default=Verdict.PASS)

    @property
    def totals(self) -> Mapping[str, float]:
        """Sums over the bearings, in SI: oil flow, flow of the pump, friction power, heat to oil and surroundings.

        Empty for a single bearing, for several operating points or clearances, and where a bearing has no
        operating point: such a sum would be that of no machine.
        """
        from babbitt.report.totals import totals

        found = totals(self.machine.results)
        return MappingProxyType({} if found is None else dict(found.values))

    def __iter__(self) -> Iterator[BearingResult]:
        return iter(self.results)

    def __len__(self) -> int:
        return len(self.machine.solutions)

    def __getitem__(self, key: str | int) -> BearingResult:
        """The result of a place, or of a name: that of a whole result, or of a bearing with one result.

        Raises
        ------
        KeyError
            For an unknown name, and for a bearing with several results.
        IndexError
            For a place that there is not.
        """
        if not isinstance(key, str):
            return self.results[key]
        for one in self.results:
            if one.name == key:
                return one
        return self.sel(bearing=key)

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

        return frame_of([{part: _part(one, part) for part in PARTS} for one in self.results], self.results)

    def to_xarray(self) -> xarray.Dataset:
        """Every quantity over the results, with ``units`` and ``long_name``; NaN where a result has none of it.

        Along ``result``, bearing, point, clearance and state are coordinates.

        Raises
        ------
        InputError
            E007 where xarray is not installed.
        """
        from babbitt.api.result_set import ResultSet

        names = {f"{part}_name": [_part(one, part) for one in self.results] for part in PARTS}
        data = ResultSet(names, self.results, (len(self),)).to_xarray()
        return data.rename({"point": "result"}).rename({f"{part}_name": part for part in PARTS})

    def write_report(
        self, path: str | Path, level: str = "standard", units: str = "si", language: str | None = None
    ) -> None:
        """Write the report of the machine, as PDF or HTML by the suffix (`babbitt.report.document.write_report`).

        `units` are those of tables and figures, "si" or "us"; `language` is "en", "de" or "ru", that of the title
        block of the case if not given.

        Raises
        ------
        InputError
            E007 for another suffix, a path that cannot be written, or a package that is not installed.
        """
        from babbitt.report.document import write_report

        write_report(self.machine, Path(path), level, units, language)

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
        from babbitt.core.check_text import comparison
        from babbitt.report.text import plain_text

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
