"""Every decision record says why, what and at which cost."""

import re
from pathlib import Path

import pytest
from example_blocks import DOCS

FOLDER = DOCS / "decisions"
RECORDS = sorted(FOLDER.glob("[0-9]*.md"))
PARTS = ["Context", "Decision", "Consequences"]


def parts(text: str) -> dict[str, str]:
    """What stands under each heading of the second level."""
    _, *sections = re.split(r"^## (.+)$", text, flags=re.MULTILINE)
    return dict(zip(sections[::2], sections[1::2], strict=True))


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.stem)
def test_a_record_has_context_decision_and_consequences(record: Path) -> None:
    found = parts(record.read_text(encoding="utf-8"))
    assert list(found) == PARTS
    assert all(len(text.split()) > 20 for text in found.values())


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.stem)
def test_a_record_carries_its_number_and_its_state(record: Path) -> None:
    title, state, *_ = re.split(r"\n\n", record.read_text(encoding="utf-8"))
    assert title.startswith(f"# {int(record.stem[:4])}. ")
    assert re.fullmatch(r"(Accepted|Replaced by \[decision \d+\]\(\d{4}-[\w-]+\.md\))\.", state)


def test_records_are_numbered_without_a_gap() -> None:
    assert [int(record.stem[:4]) for record in RECORDS] == list(range(1, len(RECORDS) + 1))
    assert len(RECORDS) >= 5


def test_a_record_without_consequences_is_noticed() -> None:
    """The reading of this module can fail."""
    assert list(parts("# 6. Title\n\nAccepted.\n\n## Context\n\na\n\n## Decision\n\nb\n")) == PARTS[:2]
