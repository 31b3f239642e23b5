"""Pages that are drawn from the program itself, so that they cannot lag behind it.

At the start of a build every page is written below ``docs/_generated``: ``parts`` is included by hand-written
pages, ``validation`` and ``drawings`` stand for themselves.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt_pages import (
    case_file,
    command_line,
    drawings,
    equations,
    gallery,
    lubricants,
    materials,
    notices,
    quantities,
    units,
    validation,
)
from babbitt_pages.files import write

if TYPE_CHECKING:
    from sphinx.application import Sphinx

PARTS = {
    "case_file": case_file.page,
    "command_line": command_line.page,
    "lubricants": lubricants.page,
    "materials": materials.page,
    "notices": notices.page,
    "quantities": quantities.page,
    "scoreboard": validation.scoreboard,
    "units": units.page,
}
"""What is included: name of the file below ``_generated/parts`` and the function that writes its text."""


def write_pages(app: Sphinx) -> None:
    """Write all generated pages."""
    target = Path(app.srcdir) / "_generated"
    for name, page in PARTS.items():
        write(target / "parts" / f"{name}.md", page())
    for name, drawing in drawings.DRAWINGS.items():
        write(target / "drawings" / f"{name}.svg", drawing())
    validation.write_pages(target / "validation")
    write(target / "parts" / "gallery.md", gallery.write_drawings(target / "gallery"))


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    equations.register(app)
    app.connect("builder-inited", write_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
