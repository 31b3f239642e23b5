"""Where machine code is kept, and what is said while it is made."""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numba
import pytest
from numba import typeof

import babbitt
from babbitt.reynolds import _compiling
from babbitt.reynolds.lands._lane_equilibrium import find_equilibria
from babbitt.reynolds.lands.operators import kernel_operator

PACKAGE = Path(babbitt.__file__).parent


def run(code: str, source: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """What a fresh Python says that finds the package in a folder."""
    settings = {**os.environ, "PYTHONPATH": str(source), **environment}
    return subprocess.run([sys.executable, "-c", code], env=settings, capture_output=True, text=True, check=True)


def test_folder_follows_every_kernel_source():
    names = {path.name for path in _compiling.SOURCES}
    assert Path(find_equilibria.py_func.__code__.co_filename).name in names
    assert {"_elimination.py", "_surface.py", "_structs.py", "_compiling.py"} <= names


def test_folder_follows_the_versions_that_compile():
    """Machine code of one numba crashes Python under another."""
    assert numba.__version__ in _compiling.VERSIONS
    assert _compiling.digest(_compiling.VERSIONS) == _compiling.DIGEST
    assert _compiling.digest(_compiling.VERSIONS.replace(numba.__version__, "0.0")) != _compiling.DIGEST


CALLER = """from {package}._compiling import compiled
from {package}._callee import shifted

@compiled
def doubled(x):
    return 2.0 * shifted(x)
"""

CALLEE = """from {package}._compiling import inner

@inner
def shifted(x):
    return x + {shift}
"""


def test_an_edit_in_a_callee_of_another_file_is_seen(tmp_path):
    """Plain caches of numba look at the file of the caller alone and would give the old answer."""
    folder = Path(_compiling.__file__).parent
    package = ".".join(["babbitt", *folder.relative_to(PACKAGE).parts])
    source = tmp_path / "source"
    shutil.copytree(PACKAGE, source / "babbitt", ignore=shutil.ignore_patterns("__pycache__"))
    copy = source / Path(*package.split("."))
    (copy / "_caller.py").write_text(CALLER.format(package=package))
    code = f"from {package}._caller import doubled as f; print(f(1.5), sum(f.stats.cache_hits.values()))"
    said = []
    for shift in (1.0, 1.0, 3.0):
        (copy / "_callee.py").write_text(CALLEE.format(package=package, shift=shift))
        # Python tells byte code by whole seconds and size, so two edits within a second would run as one.
        settings = {"NUMBA_CACHE_DIR": str(tmp_path / "cache"), "PYTHONDONTWRITEBYTECODE": "1"}
        said.append(run(code, source, **settings).stdout.split())
    assert said == [["5.0", "0"], ["5.0", "1"], ["9.0", "0"]]
    assert not [*source.rglob("*.nbi")]  # machine code stays out of the sources


def test_kernels_work_where_nothing_can_be_written(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    code = (
        "from babbitt.reynolds._compiling import FOLDER, compiled\n"
        "from babbitt.reynolds.lands.operators import kernel_operator\n"
        "@compiled\n"
        "def double(operator, x):\n"
        "    return 2.0 * x\n"
        "print(FOLDER, double(kernel_operator(4), 1.5))\n"
    )
    ended = run(code, PACKAGE.parent, NUMBA_CACHE_DIR=str(blocked))
    assert ended.stdout.split() == ["None", "3.0"]


def compiling(kernel, *arguments):
    """An event of numba: a kernel begins to compile for some arguments."""
    return SimpleNamespace(data={"dispatcher": kernel, "args": tuple(map(typeof, arguments))})


@pytest.mark.parametrize("folder", [None, Path("cache")])
def test_one_line_tells_what_is_compiled(capsys, folder):
    report = _compiling.Report(folder)
    foreign = SimpleNamespace(py_func=compiling)
    report.on_start(compiling(foreign, kernel_operator(4)))
    report.on_start(compiling(find_equilibria, 1.0))
    assert capsys.readouterr().err == ""
    for _ in range(2):
        report.on_start(compiling(find_equilibria, kernel_operator(4)))
    uncached = [_compiling.UNCACHED] if folder is None else []
    assert capsys.readouterr().err.splitlines() == [
        *uncached,
        "babbitt: compiling the kernels for films of grooved and lobed bores and of pads, "
        "once: about 15 s, with temperatures a minute",
    ]
