"""The bar on standard error."""

import sys

import pytest

from babbitt.report import progress


class NoPatience:
    """A timer that has run out when it starts."""

    def __init__(self, _patience, show, arguments, options):
        self.show = lambda: show(*arguments, **options)

    def start(self):
        self.show()

    def cancel(self):
        pass


def test_a_file_sees_no_bar(capsys):
    assert list(progress.shown("orbit")(range(3))) == [0, 1, 2]
    assert capsys.readouterr().err == ""


def test_a_terminal_sees_a_bar_while_the_first_point_is_worked_on(monkeypatch, capsys):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(progress, "Timer", NoPatience)
    for point in progress.shown("Pump [a]: cycles of the orbit")(range(40)):
        assert point == 0
        break  # the orbit closed
    assert "Pump [a]: cycles of the orbit" in capsys.readouterr().err


@pytest.mark.parametrize("number", [0, 4])
def test_every_point_is_handed_on_to_a_terminal(monkeypatch, number):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    assert list(progress.shown("orbit")(range(number))) == list(range(number))
