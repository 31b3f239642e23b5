"""What a hostile case does to the page: nothing."""

import pytest

from babbitt.app.answer import answer
from babbitt.app.designs import side_by_side
from babbitt.app.document import CaseDocument
from babbitt.app.python_text import python_of
from babbitt.app.studies import asked_text, block_of, studied
from babbitt.case import CaseError
from babbitt.core.kind import kinds

JOURNAL = kinds()["journal"].read_template()
SCRIPT = "<script>alert(1)</script>"

ALIASES = "\n".join(
    ["kind: journal", "a: &a [x, x, x, x, x, x, x, x, x]"]
    + [f"{new}: &{new} [{', '.join([f'*{old}'] * 9)}]" for old, new in zip("abcdefgh", "bcdefghi", strict=True)]
)
"""Nine lists of nine of each other: 9^9 words."""

BOMBS = {
    "aliases": ALIASES,
    "depth": "kind: journal\nbore: " + "[" * 20_000,
    "braces": "{" * 20_000,
    "merge": "kind: journal\n"
    + "\n".join(f"k{n}: &k{n} {{<<: [{', '.join(f'*k{m}' for m in range(n))}]}}" for n in range(20)),
    "number": "kind: journal\nload: 1" + "0" * 100_000,
    "key": "kind: journal\n? " + "x" * 100_000 + "\n: 1\n",
    "tag": "kind: !!python/object/apply:os.system [touch /tmp/hostile]\n",
    "not text": "kind: journal\x00\n",
    "nothing": "",
}  # fmt: skip


@pytest.mark.parametrize("name", BOMBS)
def test_a_bomb_is_a_fault(name):
    """In the worker, and in the server, which reads the text for the form; unbounded work would take hours."""
    document = CaseDocument(BOMBS[name])
    assert document.items == () or name in ("depth", "number", "key", "aliases", "merge")
    faults = answer(BOMBS[name]).faults
    assert faults
    assert all(len(fault.message) < 2000 for fault in faults)


def test_a_script_in_a_name_stays_text_wherever_a_name_stands(tmp_path):
    """Names become labels and cells, which are text, and drawings, in which they are paths or escaped."""
    document = CaseDocument(JOURNAL)
    document.change(("name",), SCRIPT)
    found = studied(asked_text(document.given, block_of("corners", [])), str(tmp_path / "progress"))
    drawn = [one.picture for one in answer(document.text).bearings] + [one.svg for one in found.figures]
    assert len(drawn) > 1
    assert not any("<script" in svg for svg in drawn)
    assert side_by_side(document.text, document.text)[0] == ()
    assert f"name={SCRIPT!r}" in python_of(document.text)


@pytest.mark.parametrize("name", ["/etc/passwd", "../../secret.csv", "C:\\secret.csv", "file:///etc/passwd"])
@pytest.mark.parametrize(
    ("path", "part"),
    [
        (("bore",), {"kind": "measured"}),
        (("displacement",), {}),
        (("compliance", 0), {"kind": "file"}),
    ],
)
def test_no_field_reads_a_file_of_the_server(path, part, name):
    document = CaseDocument(JOURNAL)
    document.change(("method",), "film")
    document.change(path, {**part, "file": name})
    faults = answer(document.text).faults
    assert any("no files" in fault.message for fault in faults), faults
    with pytest.raises(CaseError):
        python_of(document.text)
