"""The kernels of films: loaded where they are compiled, else compiled apart from what answers visitors."""

from __future__ import annotations

from typing import Any

from babbitt.app.progress import FileWatch

__all__ = ["ABOUT", "kernels_are_compiled", "kernels_compiled", "kernels_loaded"]

ABOUT = 70
"""Compilations that `kernels_compiled` needs, counted once; a few more or less do no harm."""

THERMAL = ("global", "adiabatic")
"""Films with these temperatures between them need most kernels."""


def kernels_are_compiled() -> bool:
    """Whether this installation has compiled kernels yet."""
    from babbitt.reynolds._compiling import FOLDER

    return FOLDER is not None and next(FOLDER.rglob("*.nbi"), None) is not None


def kernels_loaded() -> None:
    """Load the kernels of films, compiled where they are not."""
    from babbitt.app.answer import answer
    from babbitt.app.document import CaseDocument
    from babbitt.core.kind import kinds

    document = CaseDocument(kinds()["journal"].read_template())
    for thermal in THERMAL:
        document.change(("method",), {"kind": "film", "thermal": thermal})
        answer(document.text)


def kernels_compiled(progress: str) -> None:
    """Compile the kernels, once per installation.

    Parameters
    ----------
    progress : str
        File for `babbitt.app.progress`.
    """
    from numba.core import event

    watch = FileWatch(progress)
    watch.begins(ABOUT)

    class Count(event.Listener):
        """Counts kernels that are compiled."""

        def on_start(self, event: Any) -> None:
            """A kernel begins to compile."""

        def on_end(self, event: Any) -> None:
            """A kernel is compiled."""
            if event.data["dispatcher"].py_func.__module__.startswith("babbitt."):
                watch.advances(1, 0)

    with event.install_listener("numba:compile", Count()):
        kernels_loaded()
