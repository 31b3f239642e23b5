"""How the solutions of tilting-pad bearings are shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from babbitt.kinds.tilting_pad_journal.report.columns import COLUMNS
from babbitt.report.citations import REYNOLDS
from babbitt.report.view import View

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.model import PadCase
    from babbitt.properties.lubricants import Lubricant

__all__ = ["FILM"]


def _oil(problem: PadCase) -> Lubricant:
    return problem.lubricant


def _citations(_: PadCase) -> Iterable[str]:
    yield REYNOLDS


FILM = View(title="Tilting pads, films in two dimensions", columns=COLUMNS, citations=_citations, oil=_oil)
