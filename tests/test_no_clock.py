"""No test depends on the clock: a loaded machine is slow, not wrong."""

import re
from pathlib import Path

from hypothesis import settings

CLOCK = re.compile(r"^\s*(?:import time\b|from time import)|\bdeadline=(?!None)", re.MULTILINE)


def test_hypothesis_knows_no_deadline():
    assert settings().deadline is None


def test_no_test_looks_at_the_clock(request):
    root = request.config.rootpath
    files = [*root.glob("tests/**/*.py"), *root.glob("validation/**/*.py")]
    assert len(files) > 100
    assert [path.name for path in files if path != Path(__file__) and CLOCK.search(path.read_text("utf-8"))] == []
