"""Studies that are read back from their folder."""

from __future__ import annotations

from pathlib import Path

from babbitt.api.bearings import public_case
from babbitt.api.studies import Study
from babbitt.study import study as engine

__all__ = ["open_study"]


def open_study(path: str | Path) -> Study:
    """Read a study that was stored, finished or not.

    Parameters
    ----------
    path : str or Path
        Its folder, such as ``name.study``.

    Raises
    ------
    InputError
        E007 for a folder that holds no study.
    """
    return Study(engine.open_study(path), public_case)
