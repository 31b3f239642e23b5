"""Where machine code is kept, and what is said while it is made."""

import gc
from pathlib import Path

import numba
import pytest
from numba import typeof
from numba.core import config

from babbitt.film import _compiling
from babbitt.film._batch import find_equilibria
from babbitt.film.operators import kernel_operator


def test_folder_follows_every_kernel_source():
    names = {path.name for path in _compiling.SOURCES}
    assert Path(find_equilibria.py_func.__code__.co_filename).name in names
    assert {"_elimination.py", "_surface.py", "_structs.py", "_compiling.py"} <= names


def test_folder_follows_the_versions_that_compile():
    """Machine code of one numba crashes Python under another."""
    assert numba.__version__ in _compiling.VERSIONS
    assert _compiling.digest(_compiling.VERSIONS) == _compiling.DIGEST
    assert _compiling.digest(_compiling.VERSIONS.replace(numba.__version__, "0.0")) != _compiling.DIGEST


def test_machine_code_stays_out_of_the_sources(tmp_path, monkeypatch):
    monkeypatch.setattr(config, "CACHE_DIR", str(tmp_path))
    function = find_equilibria.py_func
    locator = _compiling.Locator.from_function(function, function.__code__.co_filename)
    assert locator is not None
    assert Path(locator.get_cache_path()).parent == tmp_path
    assert locator.get_source_stamp() == _compiling.DIGEST


def test_kernels_work_where_nothing_can_be_written(tmp_path, monkeypatch):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setattr(config, "CACHE_DIR", str(blocked))

    @_compiling.compiled
    def double(x):
        return 2.0 * x

    assert double(1.5) == pytest.approx(3.0)


def test_one_line_tells_what_is_compiled(capsys, monkeypatch):
    monkeypatch.setattr(_compiling, "_announced", set())
    axial = typeof(kernel_operator(4))
    _compiling.announce(axial)
    _compiling.announce(axial)
    _compiling.announce(typeof(1.0))
    assert capsys.readouterr().err.splitlines() == [
        "babbitt: compiling the kernels for films of grooved and lobed bores, once: about 15 s"
    ]


def test_collector_of_garbage_is_held_off_while_kernels_compile_and_only_then():
    unswept = _compiling.Unswept()
    for _ in range(2):
        unswept.on_start(None)
        assert not gc.isenabled()
    unswept.on_end(None)
    assert not gc.isenabled()  # the outer kernel still compiles
    unswept.on_end(None)
    assert gc.isenabled()
