"""Where the answers of a sweep go: checked before anything is computed, written afterwards."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from babbitt.case.variation import CaseVariation
from babbitt.core.files.printing import printable
from babbitt.core.files.spreadsheet import openpyxl_library, rows_text, workbook
from babbitt.core.files.writing import require_distinct, require_writable, write_file
from babbitt.core.nearest_name import nearest_names
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.report.outputs import STANDARD_OUTPUT, inputs_of
from babbitt.report.sheets import sheet_of_rows
from babbitt.report.sweep_table import Units, in_si, sweep_rows
from babbitt.study.case_sweep import CaseSweep, Everywhere

ENDINGS = (".csv", ".xlsx")
"""Of a table of results."""


def require_outputs(
    variation: CaseVariation | Everywhere, table: Path | None, plot: Path | None, chosen: Sequence[str] = ()
) -> None:
    """Find out before any work is done whether a sweep can be written.

    Parameters
    ----------
    variation : CaseVariation or Everywhere
        The case, none of whose files is replaced.
    table : Path or None
        Ends in ``.csv`` or ``.xlsx``, or is ``-``.
    plot : Path or None
    chosen : sequence of str
        Names of quantities.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, an unknown ending, one path for two outputs, an output that would
        replace an input or a file that is no output of Babbitt, or a package that is not installed; E005 for a
        name that no quantity has.
    """
    for name in chosen:
        if name not in QUANTITIES:
            near = nearest_names(name, QUANTITIES)
            hint = f"did you mean '{near[0]}'?" if near else "the names are those of the CSV, without their unit"
            raise InputError("E005", f"--columns: '{name}' is no quantity of results; {hint}")
    outputs = [output for output in (table, plot) if output is not None and str(output) != STANDARD_OUTPUT]
    require_distinct(outputs, inputs_of([variation.file], variation.inputs))
    if table is not None and str(table) != STANDARD_OUTPUT:
        require_ending(table)
    for output in outputs:
        require_writable(output)
    if plot is not None:
        from babbitt.report.drawing import style
        from babbitt.report.sweep_plot import require_plot

        require_plot(plot)
        with style():
            pass


def write_outputs(
    sweep: CaseSweep,
    table: Path | None,
    plot: Path | None,
    units: Units = in_si,
    chosen: Sequence[str] = (),
) -> None:
    """Write a sweep as a table and as a plot, as far as asked for; the last two as in `sweep_rows`.

    Raises
    ------
    InputError
        E007 when a file cannot be written.
    """
    if table is not None:
        rows = sweep_rows(sweep, units, chosen)
        if str(table) == STANDARD_OUTPUT:
            sys.stdout.write(rows_text(rows))
        elif table.suffix.lower() == ".xlsx":
            write_file(table, workbook({"Sweep": sheet_of_rows(rows)}, printable(table)))
        else:
            write_file(table, rows_text(rows).encode())
    if plot is not None:
        from babbitt.report.sweep_plot import write_sweep_plot

        write_sweep_plot(sweep, plot, chosen)


def require_ending(table: Path) -> None:
    """Refuse a table of results with another ending, with E007."""
    ending = table.suffix.lower()
    if ending not in ENDINGS:
        given = f"not {table.suffix}" if table.suffix else "and the name given has no ending"
        raise InputError(
            "E007", f"cannot write {printable(table)}: a table of results ends in {' or '.join(ENDINGS)}, {given}"
        )
    if ending == ".xlsx":
        openpyxl_library(printable(table))
