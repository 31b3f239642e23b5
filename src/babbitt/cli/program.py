"""The program: all its commands, and how a run of it ends."""

from __future__ import annotations

import atexit
import gc
import sys
import warnings
from functools import cache
from typing import Any, NoReturn, TextIO

from typer.main import get_command

from babbitt.cli import comparing, designing, info, sizing, solve, studying, upgrading, workbench
from babbitt.cli.app import UNUSABLE_INPUT, app
from babbitt.cli.streams import prepare_streams
from babbitt.core.files.printing import printable_lines
from babbitt.core.notices import BabbittError, InputError

__all__ = ["app", "comparing", "designing", "info", "run", "sizing", "solve", "studying", "upgrading", "workbench"]

FIRST = (
    "new", "check", "solve", "compare", "sweep", "size", "design", "study", "export", "app", "list", "explain",
    "cite", "validate", "schema", "upgrade",
)  # fmt: skip
"""Commands in the order of a job, as ``babbitt --help`` lists them."""

UNCOLLECTED = 100_000
"""New objects after which Python looks for garbage; with its own 700 an eighth of a short run is spent on that."""


def run() -> NoReturn:
    """Run the command line; a mistake of the user ends with one clear message and exit status 2."""
    gc.set_threshold(UNCOLLECTED)
    atexit.register(gc.freeze)  # what is left at the end goes with the process: to trace it takes a fifth of a run
    prepare_streams()
    warnings.showwarning = _warned
    status: object = 0
    try:
        try:
            _command()()
        except SystemExit as ended:
            status = ended.code
        sys.stdout.flush()
    except BabbittError as error:
        status = _reported(error)
    except OSError as error:  # standard output cannot take the results, such as a full disk
        status = _reported(InputError("E007", f"cannot write to standard output: {error.strerror or error}"))
    sys.exit(status)  # type: ignore[arg-type]


@cache
def _command() -> Any:
    """All commands with their options, made once: a process that runs several would make them each time."""
    made = get_command(app)
    commands = made.commands  # type: ignore[attr-defined]
    made.commands = {name: commands[name] for name in dict.fromkeys((*FIRST, *commands))}  # type: ignore[attr-defined]
    return made


def _warned(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    """Report a warning in one line, without the place in the program that gave it."""
    print(printable_lines(f"babbitt: {message}"), file=sys.stderr)


def _reported(error: BabbittError) -> int:
    print(printable_lines(error.message), file=sys.stderr)
    print(f"({error.code}: babbitt explain {error.code})", file=sys.stderr)
    return UNUSABLE_INPUT
