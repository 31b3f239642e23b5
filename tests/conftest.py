"""What several test files share."""

import pickle
import sys
from collections import OrderedDict
from contextlib import chdir

import pytest

from babbitt import cli
from babbitt.core.progress import no_progress
from babbitt.core.solution import Calculation

collect_ignore = ["conftest.py"]
"""It has no doctests, and those of folders have its name."""

MOST_KEPT = 500
"""Calculations whose solutions are kept for other tests."""


class SharedSolutions:
    """Solutions that tests of what is said of a bearing have in common: equal problems are solved once.

    Attributes
    ----------
    active : bool
        Whether the test that runs may have them: not one that replaces a part of the program, nor one that is
        marked as solving anew.
    """

    def __init__(self):
        self.active, self._solve, self._kept = False, Calculation.solve, OrderedDict()

    def solve(self, calculation, progress=no_progress):
        """As `Calculation.solve`."""
        if not self.active or progress is not no_progress:
            return self._solve(calculation, progress)
        key = pickle.dumps((calculation.problem, calculation.method))
        if (known := self._kept.get(key)) is not None:
            return known
        found = self._kept[key] = self._solve(calculation, progress)
        if len(self._kept) > MOST_KEPT:
            self._kept.popitem(last=False)
        return found


SHARED = SharedSolutions()
Calculation.solve = lambda calculation, progress=no_progress: SHARED.solve(calculation, progress)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    SHARED.active = "monkeypatch" not in item.fixturenames and not item.get_closest_marker("solves_anew")


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown():
    SHARED.active = False


@pytest.fixture
def no_images():
    """Figures are drawn but not written: their letters are most of the work of a report read for its words."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("matplotlib.figure.Figure.savefig", lambda *_, **__: None)
        yield


@pytest.fixture
def run(capsys, tmp_path):
    """Run the command line in an empty folder; give exit status, standard output and standard error."""

    def call(*arguments):
        patch.setattr(sys, "argv", ["babbitt", *map(str, arguments)])
        with pytest.raises(SystemExit) as ended:
            cli.main()
        out, err = capsys.readouterr()
        return ended.value.code or 0, out, err

    with chdir(tmp_path), pytest.MonkeyPatch.context() as patch:
        patch.setenv("COLUMNS", "160")
        yield call
