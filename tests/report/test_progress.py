"""The bar on standard error."""

import sys
import time

import pytest

from babbitt.report import progress


def test_a_file_sees_no_bar(capsys):
    assert list(progress.shown("orbit")(range(3))) == [0, 1, 2]
    assert capsys.readouterr().err == ""


def test_a_terminal_sees_a_bar_while_the_first_point_is_worked_on(monkeypatch, capsys):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(progress, "PATIENCE", 0.01)
    for point in progress.shown("Pump [a]: cycles of the orbit")(range(40)):
        time.sleep(0.4)  # the bar is drawn ten times a second
        assert point == 0
        break  # the orbit closed
    assert "Pump [a]: cycles of the orbit" in capsys.readouterr().err


@pytest.mark.parametrize("number", [0, 4])
def test_every_point_is_handed_on_to_a_terminal(monkeypatch, number):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    assert list(progress.shown("orbit")(range(number))) == list(range(number))
