"""The server of the page: on this machine alone, unless asked for otherwise."""

from __future__ import annotations

import secrets
import socket
from importlib.resources import files

from babbitt.core.language import ENGLISH, LANGUAGES

__all__ = ["LOOPBACK", "free_port", "serve"]

LOOPBACK = ("127.0.0.1", "localhost", "::1")


RECONNECT = 60.0
"""Seconds that a page without connection is kept for: a computer that slept, a browser that was busy."""


def free_port(host: str) -> int:
    """A port that nobody listens at."""
    with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET) as found:
        found.bind((host, 0))
        return int(found.getsockname()[1])


def serve(
    text: str,
    host: str,
    port: int,
    token: str,
    allowed_hosts: tuple[str, ...],
    browser: bool,
    language: str = ENGLISH,
) -> None:
    """Serve the page until it is interrupted.

    Parameters
    ----------
    text : str
        The case to begin with.
    host : str
        Address to listen at.
    port : int
        0 for one that is free.
    token : str
        What a visitor must bring; empty for a random one where others can reach the server.
    allowed_hosts : tuple of str
        Further names under which the server may be addressed.
    browser : bool
        Whether to open the browser.
    language : {"en", "de", "ru"}
        Language of pages whose address asks for none.
    """
    from nicegui import app, context, ui

    from babbitt.app.guard import Guard
    from babbitt.app.service import started
    from babbitt.app.words import LANGUAGE, word
    from babbitt.app.workbench import Workbench
    from babbitt.report.picture import STYLE

    open_to_others = host not in LOOPBACK
    token = token or (secrets.token_urlsafe(16) if open_to_others else "")
    port = port or free_port(host)
    service = started()
    app.add_middleware(Guard, hosts=(*LOOPBACK, host, *allowed_hosts), token=token)
    app.on_shutdown(service.close)
    own = files("babbitt.app")
    style = STYLE.read_text(encoding="utf-8") + own.joinpath("page.css").read_text(encoding="utf-8")
    script = own.joinpath("page.js").read_text(encoding="utf-8")

    def page() -> None:
        ui.add_css(style)
        ui.add_head_html(f"<script>{script}</script>")
        asked = context.client.request.query_params.get(LANGUAGE, language)
        Workbench(service, text, asked if asked in LANGUAGES else language).build()

    shown = f"[{host}]" if ":" in host else host
    path = f"/?token={token}" if token else "/"
    print(f"babbitt: http://{shown}:{port}{path} (Ctrl-C ends it)", flush=True)
    ui.run(
        page, host=host, port=port, title=word("title"), reload=False, show=path if browser else False,
        show_welcome_message=False, dark=None, favicon="⚙", reconnect_timeout=RECONNECT,
    )  # fmt: skip
