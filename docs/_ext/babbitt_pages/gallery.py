"""The gallery: every case file of the examples with what it shows, its verdict and its bearing drawn to scale."""

from __future__ import annotations

import re
from pathlib import Path

from babbitt.case import load_case
from babbitt.report.view import view_of
from babbitt.solving import MachineResult, solve
from babbitt_pages.files import write

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
_ROW = re.compile(r"^\| \[([\w.]+\.yaml)\]\([\w.]+\) \| (.+) \|$", re.MULTILINE)


def examples() -> list[tuple[str, str]]:
    """Name of each case file that the examples list, and what it shows."""
    return _ROW.findall((EXAMPLES / "README.md").read_text(encoding="utf-8"))


def write_drawings(target: Path) -> str:
    """Write a drawing for each example that has one, and give the part of the page that shows them all."""
    page = []
    for file, shows in examples():
        solved = solve(load_case(EXAMPLES / file))
        verdicts = ", ".join(dict.fromkeys(one.result.verdict.value for one in solved.solutions))
        page += [f"## {solved.name}", f"{shows[0].upper()}{shows[1:]}.", f"`babbitt solve {file}`: {verdicts}."]
        drawing = _drawing(solved)
        if drawing:
            name = Path(file).with_suffix(".svg").name
            write(target / name, drawing)
            options = f":alt: {solved.name}\n:class: drawing\n:width: 440px"
            page.append(f"```{{image}} /_generated/gallery/{name}\n{options}\n```")
    return "\n\n".join(page) + "\n"


def _drawing(solved: MachineResult) -> str:
    for one in solved.solutions:
        picture = view_of(one.result).picture(one)
        if picture is not None:
            return picture.printed()
    return ""
