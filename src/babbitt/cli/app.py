"""What the commands share: the program, its exit statuses, common options.

Nothing but results goes to standard output; messages go to standard error. Heavy modules are imported by the
command that needs them, so that ``babbitt --help`` answers at once.
"""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from babbitt import __version__
from babbitt.core.files.reading import Reach

SOLVED, NOT_PASSED, UNUSABLE_INPUT, NO_SOLUTION = 0, 1, 2, 3
"""Exit statuses beside `INTERRUPTED`."""

app = typer.Typer(
    name="babbitt",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Compute and design fluid-film (plain) bearings.",
    epilog="Exit status: 0 solved, 1 fail or no verdict (only with --strict), 2 input not usable, "
    "3 no solution found, 130 interrupted.",
)

Files = Annotated[list[Path], typer.Argument(metavar="FILE...", help="Case files in YAML or JSON.")]

AllowOutside = Annotated[
    bool, typer.Option("--allow-outside", help="Let a case read files outside its own folder, if you trust it.")
]


class System(StrEnum):
    """Units that tables, reports and plots speak."""

    SI = "si"
    US = "us"


Units = Annotated[System, typer.Option("--units", help="Of tables, reports and plots; JSON and NetCDF stay SI.")]


class Tongue(StrEnum):
    """Languages of reports, plots and the workbench."""

    EN = "en"
    DE = "de"
    RU = "ru"


def reach(allow_outside: bool) -> Reach:
    """Where the cases of a run may name files."""
    return Reach.ANYWHERE if allow_outside else Reach.FOLDER


def _version(wanted: bool) -> None:
    if wanted:
        print(f"babbitt {__version__}")
        raise typer.Exit


@app.callback()
def _babbitt(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    pass
