"""Both sides of a comparison, each in an interpreter of its own."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path
from typing import Any


def record_of(interpreter: str, script: Path, compiled: str | None = None) -> dict[str, Any] | None:
    """What a script records in one thread, or None where its program is not installed.

    ``compiled`` is the folder of machine code, where it is not the usual one.
    """
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}
    if compiled is not None:
        environment["NUMBA_CACHE_DIR"] = compiled
    with tempfile.TemporaryDirectory() as folder:
        record = Path(folder, "record.json")
        command = [interpreter, str(script), str(record)]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        if done.returncode == 0:
            found: dict[str, Any] = json.loads(record.read_text(encoding="utf-8"))
            return found
    if "No module named 'ross'" in done.stderr:
        return None
    raise RuntimeError(f"{script.name} failed:\n{done.stderr[-3000:]}")
