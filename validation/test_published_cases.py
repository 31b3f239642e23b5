"""Every published case, value by value: fails when one leaves the tolerance that its page states."""

import pytest

from babbitt.validation import ValidationCase, cases, summary


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_published_case(case: ValidationCase) -> None:
    rows = case.rows
    assert summary(rows).judged > 0
    outside = [" | ".join((*row.cells(), row.source)) for row in rows if not row.ok]
    assert not outside, "\n".join(outside)
