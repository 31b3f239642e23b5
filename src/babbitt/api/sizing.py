"""The permitted values of a field of a case, asked in Python."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from babbitt.api.studies import scalar
from babbitt.case.loading import located
from babbitt.core.notices import InputError
from babbitt.study.plan import plan
from babbitt.study.size import Size, size_block, size_of
from babbitt.study.study import run_study

if TYPE_CHECKING:
    from babbitt.api.case import Case

__all__ = ["sized"]


def sized(
    case: Case,
    path: str,
    within: tuple[Any, Any] | None,
    points: int,
    among: Sequence[Any],
    limits: str | Sequence[str],
    over_tolerance: bool,
) -> Size:
    """All permitted values of a field of a complete case, in SI; see `Case.size`.

    Raises
    ------
    CaseError, InputError
        For a field that takes no quantity or has no decade to scan, a range that does not ascend, a code that no
        check has, and where the case refuses every value.
    """
    counted = (limits,) if isinstance(limits, str) else tuple(limits)
    try:
        first, last = (None, None) if within is None else (scalar(case, path, one) for one in within)
        block = size_block(case, path, first, last, points, among, counted, over_tolerance)
        return size_of(run_study(plan(case, block)))
    except InputError as error:
        raise located(error, case, type(case).__name__) from None
