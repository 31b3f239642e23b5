"""How long work is followed from outside, without knowing who looks."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

__all__ = ["ProgressCallback", "no_progress"]

ProgressCallback = Callable[[Sequence[int]], Iterable[int]]
"""Hands on the numbers of the points, or cycles, one by one, and may show how far the work is."""


def no_progress(points: Sequence[int]) -> Iterable[int]:
    """Show nothing."""
    return points
