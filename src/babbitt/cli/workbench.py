"""The command that opens the workbench in the browser."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from babbitt.cli.app import Tongue, app

__all__ = ["workbench"]


@app.command("app")
def workbench(
    case: Annotated[Path | None, typer.Argument(metavar="[FILE]", help="Case file to begin with.")] = None,
    host: Annotated[
        str, typer.Option(help="Address to listen at; others than 127.0.0.1 ask for a token.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Port; 0 is one that is free.", min=0, max=65535)] = 0,
    token: Annotated[str, typer.Option(help="What visitors must bring; a random one by default.")] = "",
    allow_host: Annotated[
        list[str] | None, typer.Option(help="A further name under which the server may be addressed.")
    ] = None,
    language: Annotated[Tongue, typer.Option(help="Of the page; it can be changed there.")] = Tongue.EN,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the browser.")] = True,
) -> None:
    """See a bearing in the browser while you change it."""
    from importlib.util import find_spec

    from babbitt.core.kind import kinds
    from babbitt.core.notices import InputError
    from babbitt.core.optional_package import how_to_install

    if find_spec("nicegui") is None:
        raise InputError("E007", f"the workbench needs the package nicegui. {how_to_install('nicegui', 'app')}")
    if case is None:
        text = kinds()["journal"].read_template()
    else:
        from babbitt.case.loading import text_of

        text = text_of(case)
    from babbitt.app.server import serve

    serve(text, host, port, token, tuple(allow_host or ()), browser, language)
