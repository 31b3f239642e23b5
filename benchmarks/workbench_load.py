"""How fast the workbench answers many visitors at once, and what it does when a worker process is killed.

Run ``python benchmarks/workbench_load.py [SESSIONS] [SECONDS] [METHOD]`` on a quiet machine; METHOD is one of
``iso7902``, ``film``, ``adiabatic`` and ``full``. A server runs in a process of its own; visitors speak to it as a
browser does, over its websocket, and each moves the slider of the load every two seconds, which asks for an answer
on the draft grid. Targets on two cores: of 20 visitors 95 % of answers within 300 ms of the change, of 50 within
1 s, no visitor lost, memory of the server less than 10 % larger at the end than after the first minute, a killed
worker process replaced.
"""

from __future__ import annotations

import asyncio
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import socketio

from babbitt.app.document import CaseDocument
from babbitt.app.server import free_port
from babbitt.core.kind import kinds

PERIOD = 2.0
"""Seconds between two changes of a visitor."""

AT_WORK = 0.012
"""Seconds after a change in which a worker process is at its answer."""

MEGABYTE = 1024.0
"""kB, as Linux counts the memory of a process."""


def case(method: str) -> str:
    """A journal bearing by ISO 7902, by a film of one temperature, or by a thermal model of its film."""
    document = CaseDocument(kinds()["journal"].read_template())
    if method != "iso7902":
        one = method == "film"
        document.change(("method",), {"kind": "film", "thermal": "isothermal" if one else method})
        document.change(("effective_temperature",), "60 degC" if one else None)
        document.change(("supply_element",), None)
        document.change(("grooves",), [{"angle": f"{angle} deg", "extent": "20 deg"} for angle in (0, 180)])
    return document.text


class Visitor:
    """One page, as its browser sees it."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.seconds: list[float] = []
        self.lost = 0
        self.answered = asyncio.Event()
        self.socket = socketio.AsyncClient()

    async def open(self) -> None:
        """Load the page, connect, and wait for its first answer."""
        async with httpx.AsyncClient(timeout=60.0) as http:
            page = (await http.get(self.address)).text
        raw = re.search(r"parseElements\(String\.raw`(.*?)`\)", page, re.DOTALL)
        client = re.search(r"'client_id': '([^']+)'", page)
        assert raw is not None, "the page is one of NiceGUI"
        assert client is not None, "the page is one of NiceGUI"
        self.client = client.group(1)
        self.slider = slider_in(raw.group(1))
        for name, heard in (("update", self._updated), ("run_javascript", self._asked)):
            self.socket.on(name, heard)
        names = "&".join(f"{name}={self.client}" for name in ("client_id", "tab_id", "document_id"))
        asked = f"{names}&next_message_id=0&implicit_handshake=true"
        await self.socket.connect(
            f"{self.address}/?{asked}", socketio_path="/_nicegui_ws/socket.io", transports=["websocket"]
        )
        await asyncio.wait_for(self.answered.wait(), 60.0)

    async def _updated(self, message: dict[str, Any]) -> None:
        slider = slider_of(message)
        self.slider = slider if slider is not None else self.slider
        parts = [one["props"] for one in message.values() if isinstance(one, dict) and "props" in one]
        if any(str(one.get("innerHTML", "")).startswith('<div class="card') for one in parts):
            self.answered.set()
        await self.socket.emit("ack", {"client_id": self.client, "next_message_id": message.get("_id", 0)})

    async def _asked(self, message: dict[str, Any]) -> None:
        if message.get("request_id"):
            reply = {"request_id": message["request_id"], "client_id": self.client}
            await self.socket.emit("javascript_response", {**reply, "result": {"fragment": "", "draft": None}})

    async def change(self, load: float) -> None:
        """Move the slider of the load and wait for the answer."""
        self.answered.clear()
        element, listener = self.slider
        begun = time.perf_counter()
        args = [json.dumps(load)]
        await self.socket.emit(
            "event", {"id": element, "client_id": self.client, "listener_id": listener, "args": args}
        )
        try:
            await asyncio.wait_for(self.answered.wait(), 30.0)
        except TimeoutError:
            self.lost += 1
            return
        self.seconds.append(time.perf_counter() - begun)

    async def stay(self, until: float, first: float) -> None:
        """Change the load every two seconds, beginning at a moment of one's own."""
        await asyncio.sleep(first)
        number = 0
        while time.monotonic() < until:
            begun = time.monotonic()
            number += 1
            await self.change(10.0 + number % 5)
            await asyncio.sleep(max(0.0, PERIOD - (time.monotonic() - begun)))


def slider_in(raw: str) -> tuple[int, str]:
    """Number and listener of the slider of the load in a page."""
    text = raw
    for letter, code in (("&", "amp"), ("<", "lt"), (">", "gt"), ("`", "#96"), ("$", "#36")):
        text = text.replace(f"&{code};", letter)
    found = slider_of(json.loads(text))
    assert found is not None, "the page has a slider of the load"
    return found


def slider_of(elements: dict[str, Any]) -> tuple[int, str] | None:
    """Number and listener of the slider of the load among elements; None where it is not."""
    for number, element in elements.items():
        is_slider = isinstance(element, dict) and "slider" in str(element.get("tag", ""))
        if is_slider and element.get("props", {}).get("aria-label") == "load":
            events = [one for one in element["events"] if one["type"] == "update:modelValue"]
            return int(number), events[-1]["listener_id"]  # the first one is the library's own
    return None


def processes_of(server: int) -> list[int]:
    """The server and its worker processes."""
    threads = Path(f"/proc/{server}/task").glob("*/children")  # of whichever thread started them
    return [server, *(int(child) for thread in threads for child in thread.read_text().split())]


def processor_time(process: int) -> float:
    """Seconds of processor time that a process has used."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def memory(process: int) -> float:
    """Resident memory of a process in MB."""
    found = re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{process}/status").read_text())
    return int(found.group(1)) / MEGABYTE if found else 0.0


async def measured(address: str, server: int, sessions: int, seconds: float) -> None:
    """Let visitors come and stay; print what they saw."""
    visitors = [Visitor(address) for _ in range(sessions)]
    for one in visitors:
        await one.open()
    family = processes_of(server)
    used = [processor_time(one) for one in family]
    end = time.monotonic() + seconds
    stays = [asyncio.create_task(one.stay(end, PERIOD * n / sessions)) for n, one in enumerate(visitors)]
    await asyncio.sleep(min(60.0, 0.5 * seconds))
    early = memory(server)
    await asyncio.gather(*stays)
    late = memory(server)
    waited = np.array([second for one in visitors for second in one.seconds])
    lost = sum(one.lost for one in visitors)
    p50, p95 = np.percentile(1e3 * waited, [50, 95])
    print(
        f"{sessions} visitors, {waited.size} answers: median {p50:.0f} ms, 95 % within {p95:.0f} ms; lost {lost}"
    )
    there = processes_of(server)  # without the process that compiled ahead, which ends by itself
    spent = [
        1e3 * (processor_time(one) - before) / waited.size
        for one, before in zip(family, used, strict=True)
        if one in there
    ]
    print(
        f"processor time per answer: server {spent[0]:.0f} ms, workers {sum(spent[1:]):.0f} ms; "
        f"load of the machine {os.getloadavg()[0]:.1f}"
    )
    growth = 100.0 * (late / early - 1.0)
    print(f"memory of the server: {early:.0f} MB early, {late:.0f} MB at the end ({growth:+.1f} %)")
    await killed(server, visitors[0])
    for one in visitors:
        await one.socket.disconnect()


async def killed(server: int, visitor: Visitor) -> None:
    """Kill all worker processes while one answers; the page answers this change and the next one."""
    workers = [one for one in processes_of(server)[1:] if memory(one) > 50.0]
    begun = time.perf_counter()
    before = len(visitor.seconds)
    change = asyncio.create_task(visitor.change(13.0))
    await asyncio.sleep(AT_WORK)
    for one in workers:
        os.kill(one, signal.SIGKILL)
    await change
    await visitor.change(14.0)
    answered = len(visitor.seconds) - before
    seconds = time.perf_counter() - begun
    print(f"{len(workers)} worker processes killed: {answered} of 2 changes answered in {seconds:.1f} s")


def main(sessions: int, seconds: float, method: str) -> int:
    """Start a server, let visitors come, and end it."""
    port = free_port("127.0.0.1")
    address = f"http://127.0.0.1:{port}"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.yaml"
        file.write_text(case(method), encoding="utf-8")
        command = [sys.executable, "-m", "babbitt", "app", str(file), "--no-browser", "--port", str(port)]
        with subprocess.Popen(command) as server:
            try:
                for _ in range(120):
                    try:
                        httpx.get(address, timeout=5.0)
                        break
                    except httpx.HTTPError:
                        time.sleep(0.5)
                asyncio.run(measured(address, server.pid, sessions, seconds))
            finally:
                server.terminate()
    return 0


if __name__ == "__main__":
    given = sys.argv[1:]
    sys.exit(
        main(
            int(given[0]) if given else 20,
            float(given[1]) if len(given) > 1 else 60.0,
            given[2] if len(given) > 2 else "iso7902",
        )
    )
