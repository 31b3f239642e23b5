"""Who may talk to the page."""

import asyncio

import pytest

from babbitt.app.guard import COOKIE, Guard

TOKEN = "a-long-token"


def asked(headers, token="", query="", kind="http"):
    """Status of the answer and its headers; 200 where the request came through."""
    sent = []

    async def page(scope, receive, send):
        await send({"type": "http.response.start", "status": 200, "headers": []})

    async def send(message):
        sent.append(message)

    scope = {
        "type": kind, "path": "/", "query_string": query.encode(),
        "headers": [(name.encode(), value.encode("utf-8")) for name, value in headers.items()],
    }  # fmt: skip
    guard = Guard(page, ("127.0.0.1", "localhost", "::1"), token)
    asyncio.run(guard(scope, None, send))
    first = sent[0]
    status = first.get("status", first.get("code"))
    return status, {name.decode(): value.decode() for name, value in first.get("headers", ())}


@pytest.mark.parametrize("host", ["127.0.0.1:8080", "localhost", "[::1]:99", "LOCALHOST:1"])
def test_known_hosts_come_through(host):
    status, headers = asked({"host": host})
    assert status == 200
    assert headers["x-content-type-options"] == "nosniff"
    assert "frame-ancestors 'none'" in headers["content-security-policy"]


@pytest.mark.parametrize("host", ["evil.example", "127.0.0.1.evil.example:80", "", "localhost.evil", "[::1"])
def test_names_that_are_made_to_point_here_are_refused(host):
    assert asked({"host": host})[0] == 403


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "https://127.0.0.1.evil.example"])
@pytest.mark.parametrize(("kind", "status"), [("http", 403), ("websocket", 1008)])
def test_pages_of_other_sites_are_refused(origin, kind, status):
    assert asked({"host": "127.0.0.1", "origin": origin}, kind=kind)[0] == status


def test_pages_of_its_own_come_through():
    assert asked({"host": "127.0.0.1:8080", "origin": "http://127.0.0.1:8080"}, kind="websocket")[0] == 200


@pytest.mark.parametrize(
    ("query", "cookie", "status"),
    [
        ("", "", 401),
        ("token=wrong", "", 401),
        ("token=", "", 401),
        ("", f"{COOKIE}=wrong", 401),
        (f"token={TOKEN}", "", 200),
        ("", f"other=1; {COOKIE}={TOKEN}", 200),
    ],
)
def test_the_token_is_asked_for(query, cookie, status):
    found, headers = asked({"host": "127.0.0.1"} | ({"cookie": cookie} if cookie else {}), TOKEN, query)
    assert found == status
    if query == f"token={TOKEN}":
        assert headers["set-cookie"] == f"{COOKIE}={TOKEN}; HttpOnly; SameSite=Strict; Path=/"
    else:
        assert "set-cookie" not in headers


@pytest.mark.parametrize("length", ["10000000", "1100001", "-1", "many", "9" * 5000, "\u0661"])
def test_large_uploads_are_refused_unread(length):
    assert asked({"host": "127.0.0.1", "content-length": length})[0] == 413


def test_an_upload_of_unknown_size_is_refused():
    assert asked({"host": "127.0.0.1", "transfer-encoding": "chunked"})[0] == 413


def test_a_case_file_of_full_size_comes_through():
    assert asked({"host": "127.0.0.1", "content-length": "1000500"})[0] == 200


@pytest.mark.parametrize(
    "headers", [{"host": "evil\nhost"}, {"host": "127.0.0.1", "origin": "http://a\nb"}, {"host": "\x1b[31mred"}]
)
def test_a_refusal_is_one_line_of_the_log(headers, caplog):
    """Whoever is refused writes no lines of his own into the log, and no marks that steer a terminal."""
    with caplog.at_level("WARNING", logger="babbitt.app"):
        assert asked(headers)[0] == 403
    (record,) = caplog.records
    assert record.getMessage().startswith("refused http '/'")
    assert record.getMessage().isprintable()


def test_a_websocket_without_token_is_closed():
    assert asked({"host": "127.0.0.1"}, TOKEN, kind="websocket")[0] == 1008
