"""Standard output and error that end no run: of any encoding and width, closed, or with a reader that has gone."""

from __future__ import annotations

import errno
import os
import sys
from typing import Any, TextIO, cast

from babbitt.core.files.printing import nearest_letters, nearest_lines

__all__ = ["prepare_streams"]

_READER_GONE = (errno.EPIPE, errno.EINVAL) if os.name == "nt" else (errno.EPIPE,)

NARROWEST = 40
"""Columns below which COLUMNS is not believed; 0 is what programs set that do not know."""


class _Output:
    """A stream whose reader may go: what is not taken any more is dropped, and the run goes on to its end."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        try:
            self._stream.write(nearest_lines(text, self._stream.encoding or "utf-8"))
        except OSError as error:
            self._drop(error)
        return len(text)

    def flush(self) -> None:
        try:
            self._stream.flush()
        except OSError as error:
            self._drop(error)

    def _drop(self, error: OSError) -> None:
        """Lead what still comes nowhere; another error than a reader that has gone stays one."""
        os.dup2(os.open(os.devnull, os.O_WRONLY), self._stream.fileno())
        if error.errno not in _READER_GONE:
            raise error

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def prepare_streams() -> None:
    """Make standard output and error ready for a run."""
    if not _is_wide_enough(os.environ.get("COLUMNS")):
        del os.environ["COLUMNS"]
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:  # closed by whoever started the program
            stream = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115
        if not isinstance(stream, _Output):
            nearest_letters(stream)
            setattr(sys, name, cast(TextIO, _Output(stream)))


def _is_wide_enough(columns: str | None) -> bool:
    return columns is None or (columns.isdecimal() and int(columns) >= NARROWEST)
