"""Packages that are used where they are installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from babbitt.core.notices import InputError

__all__ = ["how_to_install", "optional_package"]


def optional_package(package: str, purpose: str, cure: str) -> Any:
    """Import a package that some of the outputs need.

    Raises
    ------
    InputError
        E007 with the cure, where it is not there.
    """
    try:
        return import_module(package)
    except ImportError:
        raise InputError("E007", f"{purpose} need the package {package}, which is not installed. {cure}") from None


def how_to_install(package: str, extra: str) -> str:
    """How to get a package that an extra needs: Babbitt is installed from a clone, no index has it.

    >>> how_to_install("matplotlib", "report")
    "Install it with: pip install '.[report]' in a clone of Babbitt, or pip install matplotlib"
    """
    return f"Install it with: pip install '.[{extra}]' in a clone of Babbitt, or pip install {package}"
