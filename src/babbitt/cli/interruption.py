"""What an interrupt (Ctrl-C) does: one line on standard error and exit status 130, whatever the program is at.

Hardly anything is imported here, so that interrupts are taken care of before all that takes its time.
"""

from __future__ import annotations

import os
import signal
import sys

TYPE_CHECKING = False  # the module typing itself takes longer than all else here
if TYPE_CHECKING:
    from types import FrameType

INTERRUPTED = 130
"""Exit status; shells give the same to a program that an interrupt has ended."""


class _Interrupts:
    """While inside, interrupts go to a handler; not where they are ignored, as for programs in the background."""

    def __init__(self, handler: object) -> None:
        self._handler = handler
        self._before: object = None

    def __enter__(self) -> None:
        if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
            return
        try:
            self._before = signal.signal(signal.SIGINT, self._handler)  # type: ignore[arg-type]
        except ValueError:  # in another thread than the main one, which alone takes signals
            self._before = None

    def __exit__(self, *_error: object) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)  # type: ignore[arg-type]


def ended_by_interrupts() -> _Interrupts:
    """Let an interrupt end the program at once.

    An exception could be lost in a destructor or inside a compiled function that calls back.
    """
    return _Interrupts(_end)


def raised_interrupts() -> _Interrupts:
    """Let an interrupt raise KeyboardInterrupt, so that what is finished can be kept."""
    return _Interrupts(signal.default_int_handler)


def _end(_number: int, _frame: FrameType | None) -> None:
    writing = sys.modules.get("babbitt.core.files.writing")
    if writing is not None and hasattr(writing, "discard_unfinished"):
        writing.discard_unfinished()
    try:
        restored = b"\r\x1b[2K\x1b[?25h" if os.isatty(2) else b""  # a progress bar hides the cursor
        os.write(2, restored + b"interrupted\n")
    finally:
        os._exit(INTERRUPTED)
