"""Take the picture of the workbench for README and docs: a film of two grooves in a real browser.

Run from the repository root; needs the extra ``app``, playwright and a Chromium of the system::

    python scripts/generate_workbench_picture.py

Writes ``docs/img/workbench.png`` in 256 colours.
"""

from __future__ import annotations

import io
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from urllib.request import urlopen

from PIL import Image
from playwright.sync_api import sync_playwright

from babbitt.app.document import CaseDocument
from babbitt.app.server import free_port
from babbitt.core.kind import kinds

ROOT = Path(__file__).parents[1]
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SIZE = {"width": 1280, "height": 800}
COLOURS = 256
TRIES = 120
"""Times that the server is asked whether it is there, with a second for each."""


def case() -> str:
    """A journal bearing by its film."""
    document = CaseDocument(kinds()["journal"].read_template())
    document.change(("method",), {"kind": "film"})
    document.change(("supply_element",), None)
    document.change(("grooves",), [{"angle": f"{angle} deg", "extent": "20 deg"} for angle in (0, 180)])
    return document.text


def picture(address: str) -> Image.Image:
    """The page with its settled answer."""
    program = next(filter(None, map(shutil.which, BROWSERS)))
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-gpu"])
        page = browser.new_page(viewport=SIZE)
        page.set_default_timeout(120_000)
        page.goto(address)
        page.wait_for_selector(".picture .pressure")
        page.mouse.move(0, 0)
        page.wait_for_timeout(1000)  # fonts and the last movements of the page
        return Image.open(io.BytesIO(page.screenshot()))


def main() -> None:
    """Serve, look, draw."""
    port = free_port("127.0.0.1")
    address = f"http://127.0.0.1:{port}"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.yaml"
        file.write_text(case(), encoding="utf-8")
        command = [sys.executable, "-m", "babbitt", "app", str(file), "--no-browser", "--port", str(port)]
        with subprocess.Popen(command) as server:
            try:
                wait_for(address)
                taken = picture(address)
            finally:
                server.terminate()
    target = ROOT / "docs" / "img" / "workbench.png"
    taken.convert("RGB").quantize(COLOURS).save(target, optimize=True)
    print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1e3:.0f} kB")


def wait_for(address: str) -> None:
    """Until the server answers."""
    for _ in range(TRIES):
        try:
            urlopen(address, timeout=1.0).close()
            return
        except OSError:
            time.sleep(1.0)
    raise SystemExit(f"no answer from {address}")


if __name__ == "__main__":
    main()
