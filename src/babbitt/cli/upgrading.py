"""The command that writes a case file as it is written today, and what the others report of one that is not."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from babbitt.cli.app import AllowOutside, app, reach
from babbitt.core.files.printing import printable

if TYPE_CHECKING:
    from babbitt.case import CaseFile

__all__ = ["report_former_places", "upgrade"]


@app.command()
def upgrade(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file.")],
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="NEW",
            help="A file that does not exist yet; - is standard output, as without this option.",
        ),
    ] = None,
    allow_outside: AllowOutside = False,
) -> None:
    """Write a case file as it is written today; it says the same, and comments and order stay."""
    from babbitt.case.upgrade import upgraded
    from babbitt.core.files.writing import create_file

    made = upgraded(file, reach(allow_outside))
    named = printable(file)
    to_screen = output is None or str(output) == "-"
    if not made.moved:
        print(f"{named}: it is written as files are written today; nothing is changed", file=sys.stderr)
    if output is not None and not to_screen and made.moved:
        create_file(output, made.text.encode())
    for one in made.moved:
        print(f"{named}: {one}", file=sys.stderr)
    if to_screen:
        print(made.text, end="")
    elif made.moved:
        print(f"wrote {printable(output)}", file=sys.stderr)


def report_former_places(file: Path, case: CaseFile) -> None:
    """Say in one line, on standard error, that a file is not written as files are today, if it is not."""
    from babbitt.case.upgrade import former_places

    if found := former_places(case):
        named = printable(file)
        more = f", and {len(found) - 1} more" if len(found) > 1 else ""
        print(
            f"{named}: {found[0]}{more}; `babbitt upgrade {named}` moves what is read as before", file=sys.stderr
        )
