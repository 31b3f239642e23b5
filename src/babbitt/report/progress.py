"""A bar on standard error while long work goes on, where somebody looks."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator, Sequence

from babbitt.studies.film_points import Watch

PATIENCE = 1.0
"""Seconds of work after which a bar appears."""


def shown(what: str) -> Watch:
    """Follow points with a bar named `what`; nothing is shown for short work, or where standard error is a
    file."""

    def watch(points: Sequence[int]) -> Iterable[int]:
        return _followed(points, what) if sys.stderr.isatty() else points

    return watch


def _followed(points: Sequence[int], what: str) -> Iterator[int]:
    from rich.console import Console
    from rich.progress import Progress

    begun = time.perf_counter()
    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(what, total=len(points), visible=False)
        for point in points:
            yield point
            progress.update(task, advance=1, visible=time.perf_counter() - begun > PATIENCE)
