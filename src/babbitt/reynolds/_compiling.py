"""Decorators of the kernels, and where their machine code is kept.

numba keeps machine code beside the source and checks only the file of the kernel itself: after an edit in a kernel
that it calls it would run the old code. Here the folder is named after a digest of all kernel sources and of the
versions that compile them (machine code of another numba crashes Python), in ``NUMBA_CACHE_DIR`` where that is set
and in the user's cache folder otherwise. Only what numba documents is used: ``config.CACHE_DIR`` while kernels are
decorated, and events of compilation.
"""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
from numba import config, njit, types
from numba.core import event
from platformdirs import user_cache_path

__all__ = ["compiled", "inlined", "inner", "spliced"]

jit: Any = njit  # its published type knows only some of the options
settings: Any = config  # numba's settings have no published types
SOURCES = sorted(Path(__file__).parent.rglob("_*.py"))
VERSIONS = f"{sys.version} numba {numba.__version__}"


def digest(versions: str) -> str:
    """Digest of the kernel sources and of the versions that compile them."""
    return hashlib.sha256(b"".join(path.read_bytes() for path in SOURCES) + versions.encode()).hexdigest()[:16]


def writable_folder(folder: Path) -> Path | None:
    """Make a folder and give it, or None where nothing can be written in it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return None
    return folder


DIGEST = digest(VERSIONS)
CACHE = Path(settings.CACHE_DIR or user_cache_path("babbitt", appauthor=False)) / f"kernels-{DIGEST}"
FOLDER = writable_folder(CACHE)
"""Where machine code is kept; None: every process compiles anew."""

UNCACHED = f"babbitt: {CACHE} cannot be written: kernels are compiled anew in every process; set NUMBA_CACHE_DIR"

KINDS = {
    "Axial": "films of grooved and lobed bores and of pads, once: about 15 s, with temperatures a minute",
    "Surface": "films that differ across the width, once: about 15 s, with temperatures a minute",
}


class Report(event.Listener):
    """Says once for each kind of film that its kernels are being compiled; their first argument tells the kind."""

    def __init__(self, folder: Path | None) -> None:
        self.folder = folder
        self.said: set[str] = set()

    def on_start(self, event: Any) -> None:
        """A kernel begins to compile because no machine code of it was found."""
        function, arguments = event.data["dispatcher"].py_func, event.data["args"]
        if not function.__module__.startswith("babbitt.") or not arguments:
            return
        first = arguments[0]
        kind = KINDS.get(first.instance_class.__name__) if isinstance(first, types.NamedTuple) else None
        if kind and kind not in self.said:
            if self.folder is None and not self.said:
                print(UNCACHED, file=sys.stderr)
            self.said.add(kind)
            print(f"babbitt: compiling the kernels for {kind}", file=sys.stderr)

    def on_end(self, event: Any) -> None:
        """A kernel is compiled."""


event.register("numba:compile", Report(FOLDER))


def kernel(**options: Any) -> Callable[[Callable[..., Any]], Any]:
    """Decorator: IEEE division, no lock of the interpreter, cached where a folder can be written."""

    def decorate(function: Callable[..., Any]) -> Any:
        before, settings.CACHE_DIR = settings.CACHE_DIR, os.fspath(FOLDER or "")
        try:
            return jit(
                error_model="numpy",
                nogil=True,
                fastmath={"contract", "reassoc"},
                no_cfunc_wrapper=True,
                cache=FOLDER is not None,
                **options,
            )(function)
        finally:
            settings.CACHE_DIR = before

    return decorate


compiled = kernel()
"""Decorator of kernels that Python calls."""

inner = kernel(no_cpython_wrapper=True)
"""Decorator of kernels that only kernels call: a door for Python would double their compile time."""

inlined = kernel(no_cpython_wrapper=True, forceinline=True)
"""Decorator of kernels that run once a line or land: handing over the tuples would cost as much as they do."""

spliced = njit(inline="always")
"""Decorator of kernels called in one place: compiled as part of their caller only."""
