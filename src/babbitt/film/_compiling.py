"""Decorators of the kernels, and where their machine code is kept.

numba keeps machine code beside the source and checks only the file of the kernel itself: after an edit in a kernel
that it calls it would run the old code. Here the folder is named after a digest of all kernel sources and of the
versions that compile them (machine code of another numba crashes Python), in ``NUMBA_CACHE_DIR`` where that is set
and in the user's cache folder otherwise.
"""

from __future__ import annotations

import gc
import hashlib
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numba
from numba import njit
from numba.core import config, event, types
from numba.core.caching import CompileResultCacheImpl, FunctionCache, _CacheLocator
from numba.misc.appdirs import AppDirs

__all__ = ["compiled", "inlined", "inner", "spliced"]

jit: Any = njit  # its published type knows only some of the options
SOURCES = sorted(Path(__file__).parent.glob("_*.py"))
VERSIONS = f"{sys.version} numba {numba.__version__}"


def digest(versions: str) -> str:
    """Digest of the kernel sources and of the versions that compile them."""
    return hashlib.sha256(b"".join(path.read_bytes() for path in SOURCES) + versions.encode()).hexdigest()[:16]


DIGEST = digest(VERSIONS)


KINDS = {
    "Axial": "films of grooved and lobed bores, once: about 15 s",
    "Surface": "films that differ across the width, once: about 15 s, with temperatures a minute",
}


def announce(first: Any) -> None:
    """Say once for each kind of film that its kernels are being compiled; the first argument tells the kind."""
    kind = KINDS.get(first.instance_class.__name__) if isinstance(first, types.NamedTuple) else None
    if kind and first not in _announced:
        _announced.add(first)
        print(f"babbitt: compiling the kernels for {kind}", file=sys.stderr)


_announced: set[object] = set()


class Locator(_CacheLocator):
    """Folder of the machine code of one kernel."""

    def __init__(self, function: Callable[..., Any], source: str) -> None:
        self._file, self._line = Path(source).stem, function.__code__.co_firstlineno
        self._folder = Path(getattr(config, "CACHE_DIR", "") or AppDirs("babbitt", appauthor=False).user_cache_dir)

    def get_cache_path(self) -> str:
        """Folder; another one after every edit of a kernel."""
        return str(self._folder / f"film-{DIGEST}")

    def get_source_stamp(self) -> str:
        """What the machine code was made from."""
        return DIGEST

    def get_disambiguator(self) -> str:
        """Tells kernels of one name apart."""
        return f"{self._file}-{self._line}"

    @classmethod
    def from_function(cls, py_func: Callable[..., Any], py_file: str) -> Locator | None:
        """Locator, or None where the folder cannot be written."""
        locator = cls(py_func, py_file)
        try:
            locator.ensure_cache_path()
        except OSError:
            return None
        return locator


class Store(CompileResultCacheImpl):
    """How numba writes and reads machine code, in our folder."""

    _locator_classes = [Locator]  # noqa: RUF012


class KernelCache(FunctionCache):
    """Cache that speaks up when nothing is in it."""

    _impl_class = Store

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Machine code for argument types, or None."""
        found = super().load_overload(sig, target_context)
        if found is None and sig:
            announce(sig[0])
        return found


class Unswept(event.Listener):
    """Holds the collector of cyclic garbage off while a kernel compiles.

    It would find little among the compiler's hundred thousands of objects, and take a tenth of the time.
    """

    depth = 0
    was_on = False

    def on_start(self, event: Any) -> None:
        """A kernel, or one that it calls, begins to compile."""
        if self.depth == 0:
            self.was_on = gc.isenabled()
            gc.disable()
        self.depth += 1

    def on_end(self, event: Any) -> None:
        """The outermost one gives back what it found."""
        self.depth -= 1
        if self.depth == 0 and self.was_on:
            gc.enable()


event.register("numba:compile", Unswept())


def kernel(**options: Any) -> Callable[[Callable[..., Any]], Any]:
    """Decorator: IEEE division, no lock of the interpreter, cached where a folder can be written."""

    def decorate(function: Callable[..., Any]) -> Any:
        dispatcher = jit(
            error_model="numpy", nogil=True, fastmath={"contract", "reassoc"}, no_cfunc_wrapper=True, **options
        )(function)
        with suppress(RuntimeError):  # no folder: compiled anew in every process
            dispatcher._cache = KernelCache(function)
        return dispatcher

    return decorate


compiled = kernel()
"""Decorator of kernels that Python calls."""

inner = kernel(no_cpython_wrapper=True)
"""Decorator of kernels that only kernels call: a door for Python would double their compile time."""

inlined = kernel(no_cpython_wrapper=True, forceinline=True)
"""Decorator of kernels that run once a line or land: handing over the tuples would cost as much as they do."""

spliced = njit(inline="always")
"""Decorator of kernels called in one place: compiled as part of their caller only."""
