"""Bearings in the rows of a table, in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from babbitt.api.case import Case
    from babbitt.api.studies import Study

__all__ = ["SolvesTables"]


class SolvesTables:
    """What a bearing can do with the rows of a table."""

    def solve_table(
        self,
        table: str | FilePath | Mapping[str, Any],
        *,
        outputs: Sequence[str] = (),
        out: str | FilePath | None = None,
        workers: int | Executor | str = 1,
    ) -> Study:
        """Solve the bearings in the rows of a table; this one has what the columns do not.

        Parameters
        ----------
        table : str, Path or Mapping
            A CSV file or workbook, or columns by their headings such as a DataFrame. Headings are paths of fields,
            with a unit such as ``diameter [mm]``; numbers of a program without one are in SI.
        outputs, out, workers
            As of `study`.

        Returns
        -------
        Study
            Its `table` has a line for each row and bearing; a row that is refused says why and stops nothing.

        Raises
        ------
        CaseError, InputError
            For headings that name no field, and numbers that may be misread.
        """
        from babbitt.api.studies import solved_table

        return solved_table(cast("Case", self), table, outputs, out, workers)
