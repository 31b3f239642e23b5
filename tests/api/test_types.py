"""Type checkers know what the public classes take: text and numbers, no misspelt field."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def script():
    spec = importlib.util.spec_from_file_location("write_stubs", ROOT / "scripts" / "write_stubs.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_stubs_are_those_of_the_models():
    """`python scripts/write_stubs.py` writes them anew."""
    stubs = script()
    for name in stubs.MODULES:
        assert (stubs.FOLDER / f"{name}.pyi").read_text(encoding="utf-8") == stubs.stub(name), name


def checked(files: list[Path], tmp_path: Path) -> str:
    config = tmp_path / "mypy.ini"
    config.write_text("[mypy]\nstrict = true\n[mypy-pint.*,numba.*,scipy.*]\nignore_missing_imports = true\n")
    kept = ROOT / ".mypy_cache" / "session"  # what it has learnt of numpy and the package, from run to run
    command = [sys.executable, "-m", "mypy", "--config-file", str(config), "--cache-dir", str(kept)]
    found = subprocess.run([*command, *map(str, files)], capture_output=True, text=True, check=False, cwd=ROOT)
    return found.stdout + found.stderr


@pytest.mark.slow
def test_a_session_has_no_error_of_types(tmp_path):
    pytest.importorskip("mypy")
    wrong = tmp_path / "wrong.py"
    wrong.write_text(
        "import babbitt as bb\n"
        "bb.JournalBearing(diametr='100 mm')\n"
        "bb.JournalBearing(method='films')\n"
        "bb.Lobes(preload=[0.5])\n"
        "bb.Film(thermal='adiabatc')\n"
    )
    told = checked([Path(__file__).parent / "session_types.py", wrong], tmp_path)
    found = [line for line in told.splitlines() if ": error:" in line]
    assert all("wrong.py:" in line for line in found), told
    assert {int(line) for line in re.findall(r"wrong.py:(\d)", told)} == {2, 3, 4, 5}
    assert "(checked 2 source files)" in told
