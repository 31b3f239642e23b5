"""Babbitt computes and designs fluid-film (plain) bearings.

>>> import babbitt
>>> case = babbitt.parse_case(babbitt.template("journal"))
>>> result = babbitt.solve(case).results[0]
>>> result.outcome.solved
True
"""

from __future__ import annotations

TYPE_CHECKING = False  # the module typing takes longer than this one
if TYPE_CHECKING:
    from typing import Any

    from babbitt.case import load_case, parse_case, template
    from babbitt.solving import solve

__version__ = "0.1.0"

__all__ = ["__version__", "load_case", "parse_case", "solve", "template"]

_HOMES = {
    "load_case": "babbitt.case",
    "parse_case": "babbitt.case",
    "template": "babbitt.case",
    "solve": "babbitt.solving",
}


def __getattr__(name: str) -> Any:
    """Import the public functions when they are first asked for, so that `import babbitt` stays light."""
    from importlib import import_module

    if name not in _HOMES:
        raise AttributeError(f"module 'babbitt' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
