"""Where the answers of a sweep go: checked before anything is computed, written afterwards."""

from __future__ import annotations

from pathlib import Path

from babbitt.notices import InputError
from babbitt.report.writing import require_writable, write_whole
from babbitt.studies.case_sweep import CaseSweep


def require_outputs(file: Path, csv: Path | None, plot: Path | None) -> None:
    """Find out before any work is done whether a sweep can be written.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, an unknown suffix, one path for two outputs, an output that would
        replace the case file, or a plot for which matplotlib is not installed.
    """
    taken = [file.resolve()]
    for output in (csv, plot):
        if output is None:
            continue
        if output.resolve() in taken:
            which = "the case file" if output.resolve() == taken[0] else "the target of another output"
            raise InputError("E007", f"cannot write {output}: it is {which}; nothing was written")
        taken.append(output.resolve())
        require_writable(output)
    if plot is not None:
        from babbitt.report.drawing import style
        from babbitt.report.sweep_plot import require_plot

        require_plot(plot)
        with style():
            pass


def write_outputs(sweep: CaseSweep, csv: Path | None, plot: Path | None) -> None:
    """Write a sweep as CSV and as a plot, as far as asked for.

    Raises
    ------
    InputError
        E007 when a file cannot be written.
    """
    if csv is not None:
        from babbitt.report.sweep_table import sweep_csv

        write_whole(csv, sweep_csv(sweep).encode())
    if plot is not None:
        from babbitt.report.sweep_plot import write_sweep_plot

        write_sweep_plot(sweep, plot)
