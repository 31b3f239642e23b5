"""A server of the page and a real browser, for the tests of what a designer does."""

import os
import socket
import subprocess
import sys
import threading
from urllib.request import urlopen

import pytest
from browsing import BROWSER, LONG

PAUSE = threading.Event()


@pytest.fixture(scope="session")
def server(tmp_path_factory):
    """Address of a page that serves the template of a journal bearing."""
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port = found.getsockname()[1]
    # The library of the page starts nothing where it believes to be tested itself.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST")}
    address = f"http://127.0.0.1:{port}"
    with (tmp_path_factory.mktemp("server") / "log").open("w+") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", "babbitt", "app", "--no-browser", "--port", str(port)],
            stdout=log, stderr=subprocess.STDOUT, env=environment,
        )  # fmt: skip
        for _ in range(600):
            try:
                urlopen(address, timeout=5).close()
                break
            except OSError:
                log.seek(0)
                assert process.poll() is None, log.read()
                PAUSE.wait(0.1)
        yield address
        process.terminate()
        process.wait(30)


@pytest.fixture(scope="session")
def chromium():
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    options = [
        "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync",
    ]  # fmt: skip
    with playwright.sync_playwright() as driver:
        started = driver.chromium.launch(executable_path=BROWSER, args=options)
        yield started
        started.close()


@pytest.fixture
def page(chromium, server):
    """The page with its first answer, and no request to any other host."""
    opened = chromium.new_page(viewport={"width": 1280, "height": 900})
    opened.set_default_timeout(LONG)
    foreign, errors = [], []
    opened.on(
        "request",
        lambda one: foreign.append(one.url) if not one.url.startswith((server, "data:", "blob:")) else None,
    )
    opened.on("pageerror", lambda one: errors.append(str(one)))
    opened.goto(server)
    opened.wait_for_selector(".verdict")
    yield opened
    assert foreign == []
    assert errors == []
    opened.close()
