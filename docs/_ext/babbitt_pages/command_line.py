"""The page of the command line, from the program's own help."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

import typer
from typer.core import TyperArgument, TyperCommand, TyperGroup

from babbitt.cli.program import app
from babbitt_pages.markdown import anchor, code, table, text


def commands() -> dict[str, TyperCommand]:
    """Every command by its name, in the order of the help."""
    group = typer.main.get_command(app)
    assert isinstance(group, TyperGroup)
    return {name: cast(TyperCommand, command) for name, command in group.commands.items()}


def page() -> str:
    """Markdown of all commands: what each does, its usage, arguments and options."""
    group = typer.main.get_command(app)
    closing = text(getattr(group, "epilog", "") or "")
    return "\n".join([*(_section(name, command) for name, command in commands().items()), closing, ""])


def _section(name: str, command: TyperCommand) -> str:
    usage = " ".join(["babbitt", name, *_usage(command)])
    rows = list(_rows(command))
    body = table(["argument or option", "meaning"], rows) if rows else ""
    head = f"{anchor('babbitt-' + name)}## babbitt {name}"
    return f"{head}\n\n{text(command.help or '')}\n\n```text\n{usage}\n```\n\n{body}"


def _usage(command: TyperCommand) -> Iterator[str]:
    if any(not isinstance(parameter, TyperArgument) for parameter in command.params):
        yield "[OPTIONS]"
    for parameter in command.params:
        if isinstance(parameter, TyperArgument):
            yield parameter.metavar or parameter.name.upper()


def _rows(command: TyperCommand) -> Iterator[tuple[str, str]]:
    for parameter in command.params:
        meaning = text(getattr(parameter, "help", None) or "")
        if isinstance(parameter, TyperArgument):
            yield code(parameter.metavar or parameter.name.upper()), meaning
        else:
            names = ", ".join(code(option) for option in parameter.opts)
            value = "" if getattr(parameter, "is_flag", False) else f" {code(parameter.metavar or '')}"
            yield names + value, meaning
