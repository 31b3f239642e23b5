"""Commands that show what is included and what it means: new, schema, validate, list, explain, cite."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from babbitt.cli.app import NOT_PASSED, AllowOutside, app, reach
from babbitt.core.files.printing import printable, takes_all_letters
from babbitt.core.notices import InputError

__all__ = ["cite", "explain", "list_", "new", "schema", "validate"]


@app.command()
def new(
    kind: Annotated[str, typer.Argument(metavar="KIND", help="What to describe: see `babbitt list kinds`.")],
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            help="A file that does not exist yet; - is standard output.",
        ),
    ] = None,
) -> None:
    """Write a commented case file that runs as it stands."""
    from babbitt.case import template
    from babbitt.core.files.writing import create_file

    text = template(kind)
    if output is None or str(output) == "-":
        print(text, end="")
        return
    create_file(output, text.encode())
    named = printable(output)
    print(f"wrote {named}; solve it with: babbitt solve {named}", file=sys.stderr)


@app.command()
def schema() -> None:
    """Print the JSON Schema of case files, with which editors complete and check them."""
    import json

    from babbitt.case import case_schema

    print(json.dumps(case_schema(), indent=2, ensure_ascii=not takes_all_letters(sys.stdout)))


@app.command()
def validate(
    names: Annotated[
        list[str] | None, typer.Argument(metavar="[NAME...]", help="Cases; all when omitted.")
    ] = None,
) -> None:
    """Run the published cases that ship with the package, side by side with the print.

    Cases whose inputs were fitted to the print are reproductions, those held against own values regressions,
    and say so.
    Exit status 1 if a judged value differs by more than its tolerance.
    """
    from babbitt.validation import cases, validation_case
    from babbitt.validation.table import print_count, print_validation

    chosen = [validation_case(name) for name in names] if names else list(cases())
    agreed = [print_validation(case) for case in chosen]
    if len(chosen) > 1:
        print_count(chosen, agreed)
    if not all(agreed):
        raise typer.Exit(NOT_PASSED)


@app.command(name="list")
def list_(
    what: Annotated[str, typer.Argument(metavar="WHAT", help="lubricants, materials, units, kinds or cases.")],
) -> None:
    """Show what is included, with sources."""
    from babbitt.cli import listings

    show: dict[str, Callable[[], None]] = {
        "lubricants": listings.print_lubricants,
        "materials": listings.print_materials,
        "units": listings.print_units,
        "kinds": listings.print_kinds,
        "cases": listings.print_cases,
    }
    asked = what.strip().lower()
    if asked not in show:
        raise InputError("E005", f"nothing is listed under '{printable(what)}'; there are: {', '.join(show)}")
    show[asked]()


@app.command()
def explain(codes: Annotated[list[str], typer.Argument(metavar="CODE...", help="Such as W101 or C104.")]) -> None:
    """Explain codes of errors, warnings or checks, and what to do about them."""
    from babbitt.api.catalogue import explain as explained

    found = {code.strip().upper(): explained(code) for code in codes}
    said = (f"{code}  {one.title}\n\n{one.meaning}\n\nWhat to do: {one.remedy}" for code, one in found.items())
    print("\n\n".join(said))


@app.command()
def cite(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A case file.")],
    allow_outside: AllowOutside = False,
) -> None:
    """Say what to cite for the methods that a case uses."""
    from babbitt.case import load_case
    from babbitt.report.citations import citations_of

    print("\n\n".join(citations_of(load_case(file, reach(allow_outside)))))
