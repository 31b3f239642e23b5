"""What a code means."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Explanation:
    """What a code means and what to do about it."""

    title: str
    meaning: str
    remedy: str
