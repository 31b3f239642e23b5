"""What several test files share."""

import sys

import pytest

from babbitt import cli

collect_ignore = ["conftest.py"]
"""It has no doctests, and those of folders have its name."""


@pytest.fixture
def no_images(monkeypatch):
    """Figures are drawn but not written: their letters are most of the work of a report read for its words."""
    monkeypatch.setattr("matplotlib.figure.Figure.savefig", lambda *_, **__: None)


@pytest.fixture
def run(capsys, monkeypatch, tmp_path):
    """Run the command line in an empty folder; give exit status, standard output and standard error."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "160")

    def call(*arguments):
        monkeypatch.setattr(sys, "argv", ["babbitt", *map(str, arguments)])
        with pytest.raises(SystemExit) as ended:
            cli.main()
        out, err = capsys.readouterr()
        return ended.value.code or 0, out, err

    return call
