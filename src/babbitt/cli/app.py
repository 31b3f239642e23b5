"""What the commands share: the program, its exit statuses, how a mistake of the user ends.

Nothing but results goes to standard output; messages go to standard error. Heavy modules are imported by the
command that needs them, so that ``babbitt --help`` answers at once.
"""

from __future__ import annotations

import atexit
import gc
import os
import sys
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from babbitt import __version__
from babbitt.files.reading import Reach
from babbitt.notices import BabbittError, InputError

SOLVED, NOT_PASSED, UNUSABLE_INPUT, NO_SOLUTION = 0, 1, 2, 3
"""Exit statuses."""

UNCOLLECTED = 100_000
"""New objects after which Python looks for garbage; with its own 700 an eighth of a short run is spent on that."""

app = typer.Typer(
    name="babbitt",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Compute and design fluid-film (plain) bearings.",
    epilog="Exit status: 0 solved, 1 fail or no verdict (only with --strict), 2 input not usable, "
    "3 no solution found.",
)

Files = Annotated[list[Path], typer.Argument(metavar="FILE...", help="Case files in YAML or JSON.")]

AllowOutside = Annotated[
    bool, typer.Option("--allow-outside", help="Let a case read files outside its own folder, if you trust it.")
]


def reach(allow_outside: bool) -> Reach:
    """Where the cases of a run may name files."""
    return Reach.ANYWHERE if allow_outside else Reach.FOLDER


def main() -> None:
    """Run the command line; a mistake of the user ends with one clear message and exit status 2."""
    gc.set_threshold(UNCOLLECTED)
    atexit.register(gc.freeze)  # what is left at the end goes with the process: to trace it takes a fifth of a run
    try:
        app()
    except BabbittError as error:
        _fail(error)
    except BrokenPipeError:  # the reader of a pipe has gone; nothing is left to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:  # standard output cannot take the results, such as a full disk
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _fail(InputError("E007", f"cannot write to standard output: {error.strerror or error}"))


def _fail(error: BabbittError) -> NoReturn:
    print(f"{error.message}", file=sys.stderr)
    print(f"({error.code}: babbitt explain {error.code})", file=sys.stderr)
    sys.exit(UNUSABLE_INPUT)


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
