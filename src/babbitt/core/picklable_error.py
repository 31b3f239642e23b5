"""Exceptions that come whole out of another process."""

from __future__ import annotations

from typing import Any

__all__ = ["PicklableError"]


class PicklableError(Exception):
    """An exception that is pickled with what it holds.

    Python pickles an exception as its class and its message, and makes the copy by calling the one with the other.
    Where the class takes anything else than a message, the copy cannot be made, and a pool of processes waits for
    it for ever.
    """

    def __reduce__(self) -> tuple[Any, ...]:
        return _remade, (type(self), self.args, vars(self))


def _remade(of: type[PicklableError], args: tuple[Any, ...], state: dict[str, Any]) -> PicklableError:
    error = of.__new__(of, *args)
    vars(error).update(state)
    return error
