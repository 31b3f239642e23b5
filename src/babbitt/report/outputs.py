"""Where the results of a run go: decided and checked before anything is computed or written."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from babbitt.notices import InputError

if TYPE_CHECKING:
    from babbitt.solving import MachineResult

STANDARD_OUTPUT = "-"


@dataclass(frozen=True)
class Target:
    """Where the result of one case goes; None is nowhere, the JSON path "-" is standard output."""

    json: str | None
    report: Path | None
    plots: Path | None

    def write(self, machine: MachineResult) -> None:
        """Write what was asked for.

        Raises
        ------
        InputError
            E007 if a path is not writable or an extra is not installed.
        """
        if self.json is not None:
            from babbitt.report.export import write_json

            if self.json == STANDARD_OUTPUT:
                sys.stdout.write(write_json(machine))
            else:
                _write_text(Path(self.json), write_json(machine))
        if self.report is not None:
            from babbitt.report.document import write_report

            write_report(machine, self.report)
        if self.plots is not None:
            from babbitt.report.figures import write_plots

            write_plots(machine, self.plots)


@dataclass(frozen=True)
class Outputs:
    """One target per case file; `silent` when standard output belongs to the JSON."""

    targets: tuple[Target, ...]
    silent: bool


def outputs(files: Sequence[Path], json: str | None, report: Path | None, plots: Path | None) -> Outputs:
    """Plan the outputs of a run.

    With several case files, each option names a folder that exists and receives one file per case, named after it.

    Raises
    ------
    InputError
        E007 for a folder that does not exist, an unknown suffix, or one file for several cases.
    """
    if len(files) == 1:
        _require_folder_of(json if json != STANDARD_OUTPUT else None)
        _require_folder_of(report)
        _require_suffix(report)
        return Outputs((Target(json, report, plots),), json == STANDARD_OUTPUT)
    if json == STANDARD_OUTPUT:
        raise InputError(
            "E007", "standard output takes the JSON of one case; give --json a folder for several files"
        )
    for option, path in (("--json", json), ("--report", report)):
        if path is not None and not Path(path).is_dir():
            raise InputError("E007", f"{option} {path}: with several case files name a folder that exists")
    targets = (
        Target(
            str(Path(json) / f"{file.stem}.json") if json else None,
            report / f"{file.stem}.pdf" if report else None,
            plots / file.stem if plots else None,
        )
        for file in files
    )
    return Outputs(tuple(targets), False)


def _require_folder_of(path: str | Path | None) -> None:
    if path is None:
        return
    folder = Path(path).parent
    if not folder.is_dir():
        raise InputError("E007", f"cannot write {path}: the folder {folder} does not exist")
    if Path(path).is_dir():
        raise InputError("E007", f"cannot write {path}: it is a folder; name a file")


def _require_suffix(report: Path | None) -> None:
    if report is not None and report.suffix.lower() not in (".pdf", ".html"):
        raise InputError(
            "E007", f"--report {report}: the report is .pdf or .html, not {report.suffix or 'without suffix'}"
        )


def _write_text(path: Path, text: str) -> None:
    partial = path.with_name(path.name + ".part")
    try:
        partial.write_text(text, encoding="utf-8")
        partial.replace(path)
    except OSError as error:
        partial.unlink(missing_ok=True)
        raise InputError("E007", f"cannot write {path}: {error.strerror}") from None
