"""Who may talk to the page: known hosts, its own pages, and those with the token.

A page of another site can make a browser send requests to this machine. The name of the host must be one that was
allowed, also against names that are made to point here (DNS rebinding); what changes anything must come from a
page of an allowed host; and where others can reach the server, a token is asked for.
"""

from __future__ import annotations

import hmac
import logging
from collections.abc import Awaitable, Callable, Iterable, MutableMapping
from http.cookies import SimpleCookie
from typing import Any
from urllib.parse import parse_qs, urlsplit

from babbitt.case.loading import LARGEST_FILE

__all__ = ["COOKIE", "Guard"]

COOKIE = "babbitt_token"

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]

MOST_BYTES = LARGEST_FILE + 100_000
"""Of a request: the largest case file, and what stands about it in a form."""

LOG = logging.getLogger("babbitt.app")

HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "X-Frame-Options": "DENY",
    "Content-Security-Policy": "default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval'; "
    "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; "
    "connect-src 'self' ws: wss:; frame-ancestors 'none'; base-uri 'self'; form-action 'self'",
}


class Guard:
    """An ASGI application that lets requests through to another one, or refuses them in one line.

    Parameters
    ----------
    app : callable
    hosts : iterable of str
        Names under which the server may be addressed, without port.
    token : str
        Empty where none is asked for.
    """

    def __init__(
        self, app: Callable[[Scope, Receive, Send], Awaitable[None]], hosts: Iterable[str], token: str
    ) -> None:
        self.app, self.hosts, self.token = app, frozenset(host.lower() for host in hosts), token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = {name.decode("latin-1").lower(): value.decode("latin-1") for name, value in scope["headers"]}
        if (why := self._refusal(headers)) is not None:
            await _refuse(scope, send, 403, why)
            return
        if (why := too_large(headers)) is not None:
            await _refuse(scope, send, 413, why)
            return
        offered = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [""])[0]
        if self.token and not self._knows(headers) and not self._matches(offered):
            await _refuse(scope, send, 401, "the token is missing or wrong")
            return
        await self.app(scope, receive, self._with_headers(send, self.token if self._matches(offered) else ""))

    def _refusal(self, headers: dict[str, str]) -> str | None:
        """Why a request is refused whoever sends it."""
        if (host := host_of(f"//{headers.get('host', '')}")) not in self.hosts:
            return f"the host {host!r} is not allowed"
        origin = headers.get("origin")
        if origin is not None and host_of(origin) not in self.hosts:
            return f"a page of {host_of(origin)!r} may not use this one"
        return None

    def _knows(self, headers: dict[str, str]) -> bool:
        cookie = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
        return cookie is not None and self._matches(cookie.value)

    def _matches(self, offered: str) -> bool:
        return bool(self.token) and hmac.compare_digest(offered.encode(), self.token.encode())

    def _with_headers(self, send: Send, token: str) -> Send:
        async def sent(message: MutableMapping[str, Any]) -> None:
            if message["type"] == "http.response.start":
                added = dict(HEADERS)
                if token:
                    added["Set-Cookie"] = f"{COOKIE}={token}; HttpOnly; SameSite=Strict; Path=/"
                own = [(name.lower().encode(), value.encode()) for name, value in added.items()]
                message["headers"] = [*message.get("headers", ()), *own]
            await send(message)

        return sent


def host_of(address: str) -> str:
    """The name of the host in an address, without port; empty where there is none.

    >>> host_of("//127.0.0.1:8080"), host_of("http://[::1]:8080"), host_of("null")
    ('127.0.0.1', '::1', '')
    """
    try:
        return (urlsplit(address).hostname or "").lower()
    except ValueError:
        return ""


def too_large(headers: dict[str, str]) -> str | None:
    """Why what a request brings is refused; None where it is not. What does not say its size is refused, too."""
    if "chunked" in headers.get("transfer-encoding", "").lower():
        return "a request says how much it brings"
    length = headers.get("content-length", "0")
    if not length.isascii() or not length.isdecimal() or int(length[:20]) > MOST_BYTES:
        return f"a request brings at most {MOST_BYTES} bytes"
    return None


async def _refuse(scope: Scope, send: Send, status: int, why: str) -> None:
    LOG.warning("refused %s %s: %s", scope["type"], ascii(scope.get("path", "")), ascii(why))
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008, "reason": ""})
        return
    await send({"type": "http.response.start", "status": status, "headers": [(b"content-type", b"text/plain")]})
    await send({"type": "http.response.body", "body": f"refused: {why}\n".encode()})
