"""Say what takes so long when the film kernels are compiled for the first time."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Timer

PATIENCE = 2.0
"""Seconds after which a film that is still not there is being compiled: a compiled one takes milliseconds."""

MESSAGE = (
    "babbitt: compiling the film kernels (pressure, forces, equilibrium) for this machine; "
    "this happens once, up to half a minute, and is kept for later runs ..."
)


@contextmanager
def announced() -> Iterator[None]:
    """Tell standard error once what is going on if the work inside is slow."""
    timer = Timer(PATIENCE, _say)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


_said: list[bool] = []


def _say() -> None:
    if not _said:
        _said.append(True)
        print(MESSAGE, file=sys.stderr, flush=True)
