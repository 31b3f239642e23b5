"""What `babbitt check` may answer to a file, whatever stands in it; and the loop over seeds."""

from __future__ import annotations

import argparse
import contextlib
import io
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path

from babbitt import cli

__all__ = ["LONGEST_LINE", "PATIENCE", "answer_of", "run_seeds"]

PATIENCE = 10
"""Seconds that `check` may take."""

LONGEST_LINE = 2000
"""Characters of one message; more is no clear message."""


class HangError(BaseException):
    """The patience is over; no handler of a program catches it."""


def answer_of(path: Path) -> str:
    """Run `babbitt check` on a file, in this process; give what is wrong with its answer, empty where nothing is.

    Parameters
    ----------
    path : Path
    """
    out, err = io.StringIO(), io.StringIO()
    given, sys.argv = sys.argv, ["babbitt", "check", str(path)]
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            cli.main()
    except SystemExit as ended:
        return _fault(ended.code or 0, out.getvalue(), err.getvalue(), path)
    except HangError:
        return f"hangs: more than {PATIENCE} s"
    except BaseException:
        return f"traceback: {traceback.format_exc(limit=-4)}"
    finally:
        sys.argv = given
    return "no exit status"


def _fault(status: object, out: str, err: str, path: Path) -> str:
    """What is wrong with an exit status and what was written; kernels may be compiled at any time."""
    err = "".join(line for line in err.splitlines(keepends=True) if not line.startswith("babbitt: compiling"))
    said = out + err
    lines = said.splitlines()
    if "Traceback" in said:
        return f"traceback: {said[-2000:]}"
    if not all(letter.isprintable() or letter == "\n" for letter in said):
        return f"control characters: {said[:500]!r}"
    if any(len(line) > LONGEST_LINE for line in lines):
        return f"a line of {max(map(len, lines))} characters: {said[:500]}"
    if status == 0:
        return "" if out.startswith(f"{path}: usable") and not err else f"status 0 without 'usable': {said[:500]}"
    if status != 2:
        return f"exit status {status}: {said[:500]}"
    messages = err.splitlines()
    if not messages or not all(line.startswith(str(path)) for line in messages[:-1]) or len(messages) < 2:
        return f"status 2 without a message of the file: {said[:500]}"
    return ""


def run_seeds(what: str, check: Callable[[int, Path], str], number: int) -> int:
    """Run the seeds that the command line asks for, and print those whose answer is wrong; 1 where one is.

    Parameters
    ----------
    what : str
        What a seed makes.
    check : callable
        Seed and folder to what is wrong with the answer.
    number : int
        Of seeds where the command line names none.
    """
    parser = argparse.ArgumentParser(description=f"Check {what}, made by seeds, and print wrong answers.")
    parser.add_argument("number", nargs="?", type=int, default=number, help="of seeds; %(default)s where left out")
    parser.add_argument("first", nargs="?", type=int, default=1, help="seed; %(default)s where left out")
    asked = parser.parse_args()
    number, first = asked.number, asked.first
    wrong, slowest, begun = 0, 0.0, time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + number):
            start = time.perf_counter()
            with _alarm():
                fault = check(seed, Path(folder))
            slowest = max(slowest, time.perf_counter() - start)
            if fault:
                wrong += 1
                print(f"seed {seed}: {fault}", flush=True)
    took = time.perf_counter() - begun
    print(
        f"{number} {what}, seeds {first} to {first + number - 1}: {wrong} wrong answers, {took:.0f} s in all, "
        f"{slowest:.1f} s the slowest"
    )
    return 1 if wrong else 0


@contextlib.contextmanager
def _alarm() -> Iterator[None]:
    """End what hangs."""

    def ring(*_: object) -> None:
        raise HangError

    before = signal.signal(signal.SIGALRM, ring)
    signal.alarm(PATIENCE)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)
