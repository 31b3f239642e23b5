"""Where the results of a run go: decided and checked before anything is computed or written."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from babbitt.core.files.printing import printable, takes_all_letters
from babbitt.core.files.writing import require_distinct, require_folder, require_writable, write_file
from babbitt.core.language import written_in
from babbitt.core.notices import InputError
from babbitt.core.quantities import displayed_in
from babbitt.core.report_level import Level

if TYPE_CHECKING:
    from babbitt.solving import MachineResult

STANDARD_OUTPUT = "-"


@dataclass(frozen=True)
class Target:
    """Where the result of one case goes; None is nowhere, the JSON path "-" is standard output."""

    json: str | None
    report: Path | None
    plots: Path | None
    fields: Path | None = None
    level: Level = Level.STANDARD
    units: str = "si"
    language: str | None = None

    def files(self) -> tuple[Path, ...]:
        """The files that will be written, without the plots."""
        json = Path(self.json) if self.json is not None and self.json != STANDARD_OUTPUT else None
        return tuple(path for path in (json, self.report, self.fields) if path is not None)

    def write(self, machine: MachineResult) -> None:
        """Write what was asked for.

        Raises
        ------
        InputError
            E007 if a path is not writable or an extra is not installed.
        """
        if self.json is not None:
            from babbitt.report.export import escaped, write_json

            if self.json == STANDARD_OUTPUT:
                text = write_json(machine)
                sys.stdout.write(text if takes_all_letters(sys.stdout) else escaped(text))
            else:
                write_file(Path(self.json), write_json(machine).encode())
        if self.report is not None:
            from babbitt.report.document import write_report

            missing = write_report(machine, self.report, self.level, self.units, self.language)
            if missing:
                print(left_in_english(self.report, missing), file=sys.stderr)
        if self.plots is not None:
            from babbitt.report.document import language_of
            from babbitt.report.figures import write_plots

            with displayed_in(self.units), written_in(language_of(machine, self.language)):
                write_plots(machine, self.plots)
        if self.fields is not None:
            from babbitt.report.fields import write_machine_fields

            for name in write_machine_fields(machine, self.fields):
                print(f"{printable(name)}: no operating point, so no fields are saved", file=sys.stderr)


@dataclass(frozen=True)
class Outputs:
    """One target per case file; `silent` when standard output belongs to the JSON."""

    targets: tuple[Target, ...]
    silent: bool


def outputs(
    files: Sequence[Path],
    json: str | None,
    report: Path | None,
    plots: Path | None,
    fields: Path | None = None,
    tables: Sequence[Path] = (),
    level: Level = Level.STANDARD,
    units: str = "si",
    language: str | None = None,
) -> Outputs:
    """Plan the outputs of a run, and make sure that each can be written.

    With several case files, each option names a folder that exists and receives one file per case, named after it.
    `tables` are the files that the cases name.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, an unknown suffix, one file for several outputs, an output that
        would replace an input of the run or a file that is no output of Babbitt, or a format for which an extra
        is not installed.
    """
    alone = len(files) == 1
    targets = [Target(json, report, plots, fields)] if alone else _one_each(files, json, report, plots, fields)
    targets = [replace(target, level=level, units=units, language=language) for target in targets]
    _refuse_collisions(inputs_of(files, tables), targets)
    for target in targets:
        _require_suffix(target.report)
        _require_extras(target)
        if target.fields is not None:
            from babbitt.report.fields import require_netcdf

            require_netcdf(target.fields)
        for path in target.files():
            require_writable(path)
        if target.plots is not None:
            require_folder(target.plots, "--plots")
    return Outputs(tuple(targets), json == STANDARD_OUTPUT)


def _one_each(
    files: Sequence[Path], json: str | None, report: Path | None, plots: Path | None, fields: Path | None
) -> list[Target]:
    """One file per case in the folders that the options name."""
    if json == STANDARD_OUTPUT:
        raise InputError(
            "E007", "standard output takes the JSON of one case; give --json a folder for several files"
        )
    for option, path in (("--json", json), ("--report", report), ("--plots", plots), ("--fields", fields)):
        if path is not None and not Path(path).is_dir():
            raise InputError(
                "E007", f"{option} {printable(path)}: with several case files name a folder that exists"
            )
    return [
        Target(
            str(Path(json) / f"{file.stem}.json") if json else None,
            report / f"{file.stem}.pdf" if report else None,
            plots / file.stem if plots else None,
            fields / f"{file.stem}.nc" if fields else None,
        )
        for file in files
    ]


def left_in_english(path: Path, missing: Sequence[str]) -> str:
    """Say which texts of a report its language lacks."""
    count = f"{len(missing)} texts stand" if len(missing) > 1 else "a text stands"
    return f"{printable(path)}: {count} in English, for which the language has no words; the first: {missing[0]!r}"


def inputs_of(files: Sequence[Path], tables: Sequence[Path]) -> Mapping[Path, str]:
    """What a run reads: its case files, and the files that these name."""
    return dict.fromkeys(tables, "a file that the case reads") | dict.fromkeys(files, "a case file")


def _refuse_collisions(inputs: Mapping[Path, str], targets: Sequence[Target]) -> None:
    require_distinct(
        [path for target in targets for path in (*target.files(), *([target.plots] if target.plots else []))],
        inputs,
    )


def _require_extras(target: Target) -> None:
    """Refuse report and plots whose packages are missing before a case is solved and its JSON written."""
    if target.report is None and target.plots is None:
        return
    from babbitt.report.drawing import require_extra

    if target.report is not None:
        require_extra("typst", "reports")
    require_extra("matplotlib", "plots")


def _require_suffix(report: Path | None) -> None:
    if report is not None and report.suffix.lower() not in (".pdf", ".html"):
        given = report.suffix or "without suffix"
        raise InputError("E007", f"--report {printable(report)}: the report is .pdf or .html, not {given}")
