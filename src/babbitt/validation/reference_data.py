"""Published numbers that ship with the package."""

from __future__ import annotations

import json
from functools import lru_cache
from importlib.resources import files
from typing import Any


@lru_cache
def reference_data(name: str) -> dict[str, Any]:
    """Read a file of published numbers; treat what comes back as read-only.

    Parameters
    ----------
    name : str
        Without ending, such as ``butenschoen_1976``.

    Returns
    -------
    dict
    """
    text = files("babbitt.validation").joinpath("data", f"{name}.json").read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data
