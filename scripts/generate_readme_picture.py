"""Draw the picture of the README: two pages of the report on the marine reverse gear.

Run from the repository root; needs the extra ``report`` and the program ``pdftoppm`` (poppler)::

    python scripts/generate_readme_picture.py

Writes ``docs/img/report.png``, grey and small.
"""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from PIL import Image

import babbitt

ROOT = Path(__file__).parents[1]
PAGES = (1, 6)
"""The summary of the machine, and the figures of its first bearing."""

RESOLUTION = 72
"""Dots per inch: an A4 page becomes 595 pixels wide."""

GAP, FRAME = 16, 1
"""Pixels between the pages and around each."""


def page_image(report: Path, page: int) -> Image.Image:
    """One page of a PDF in shades of grey."""
    target = report.with_name(f"page-{page}")
    only = ["-f", str(page), "-l", str(page), "-singlefile"]
    subprocess.run(
        ["pdftoppm", "-gray", "-png", "-r", str(RESOLUTION), *only, str(report), str(target)], check=True
    )
    return Image.open(target.with_suffix(".png")).convert("L")


def main() -> None:
    """Solve, write the report, draw."""
    machine = babbitt.solve(babbitt.load_case(ROOT / "examples" / "marine_reverse_gear.yaml"))
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.pdf"
        machine.write_report(report)
        images = [page_image(report, page) for page in PAGES]
    width = sum(image.width for image in images) + GAP * (len(images) - 1)
    picture = Image.new("L", (width, images[0].height), 255)
    left = 0
    for image in images:
        picture.paste(120, (left, 0, left + image.width, image.height))
        inner = (FRAME, FRAME, image.width - FRAME, image.height - FRAME)
        picture.paste(image.crop(inner), (left + FRAME, FRAME))
        left += image.width + GAP
    target = ROOT / "docs" / "img" / "report.png"
    picture.quantize(16).save(target, optimize=True)
    print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
