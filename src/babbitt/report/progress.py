"""A bar on standard error while long work goes on, where somebody looks."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from threading import Timer

from babbitt.core.progress import ProgressCallback

PATIENCE = 1.0
"""Seconds of work after which a bar appears."""


def shown(what: str) -> ProgressCallback:
    """Follow points with a bar named `what`; nothing is shown for short work, or where standard error is a
    file."""

    def watch(points: Sequence[int]) -> Iterable[int]:
        return _followed(points, what) if sys.stderr.isatty() else points

    return watch


def _followed(points: Sequence[int], what: str) -> Iterator[int]:
    from rich.console import Console
    from rich.markup import escape
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(escape(what), total=len(points), visible=False)
        patience = Timer(PATIENCE, progress.update, (task,), {"visible": True})
        patience.daemon = True
        patience.start()
        try:
            for point in points:
                yield point
                progress.update(task, advance=1)
        finally:
            patience.cancel()
