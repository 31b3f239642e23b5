"""Every benchmark finds what it imports: `make bench` runs too long for a test, and a moved name breaks it."""

import importlib.util
import sys
from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).parents[1] / "benchmarks"
SCRIPTS = sorted(BENCHMARKS.rglob("*.py"))
ELSEWHERE = {"by_ross.py": "ross"}
"""Scripts that an interpreter with another program runs, and that program."""


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: str(script.relative_to(BENCHMARKS)))
def test_a_benchmark_imports(script, monkeypatch):
    """With its own folder first on the path, as Python runs it, and its own neighbours of names like `case`."""
    monkeypatch.syspath_prepend(str(script.parent))
    if script.name in ELSEWHERE:
        pytest.importorskip(ELSEWHERE[script.name])
    known = set(sys.modules)
    spec = importlib.util.spec_from_file_location(f"benchmark_{script.stem}", script)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where its dataclasses look for their names
    try:
        spec.loader.exec_module(module)
    finally:
        for name in set(sys.modules) - known:
            if BENCHMARKS in Path(getattr(sys.modules[name], "__file__", None) or "/").parents:
                del sys.modules[name]


def test_every_benchmark_is_found():
    """The list is not empty, and holds the scripts of the folders."""
    assert {"film_speed.py", "by_babbitt.py", "harness.py"} <= {script.name for script in SCRIPTS}
