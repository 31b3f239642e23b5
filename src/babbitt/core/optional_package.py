"""Packages that are used where they are installed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from babbitt.core.notices import InputError

__all__ = ["optional_package"]


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
