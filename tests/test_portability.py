"""The package runs where what only POSIX systems have is missing, as on Windows."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import babbitt
from babbitt.case import template

SOURCES = sorted(Path(babbitt.__file__).parent.rglob("*.py"))
POSIX_MODULES = {"fcntl", "grp", "pty", "pwd", "resource", "syslog", "termios", "tty"}
POSIX_NAMES = {
    "os": {"fork", "forkpty", "geteuid", "getuid", "killpg", "mkfifo", "O_NONBLOCK", "setsid", "sysconf", "uname"},
    "signal": {"alarm", "pause", "setitimer", "SIGALRM", "SIGCHLD", "SIGHUP", "SIGKILL", "SIGPIPE", "SIGUSR1"},
}
ASKED_BY_OTHERS = {"getuid", "sysconf", "uname"}
"""Names that the libraries below look up wherever they find themselves on a POSIX system."""
WITHOUT_POSIX = f"""
import os, signal, sys
for module in {sorted(POSIX_MODULES)}:
    sys.modules[module] = None
for name in {sorted(POSIX_NAMES["os"] - ASKED_BY_OTHERS)}:
    vars(os).pop(name, None)
for name in {sorted(POSIX_NAMES["signal"])}:
    vars(signal).pop(name, None)
from babbitt.cli import main
sys.argv = ["babbitt", *sys.argv[1:]]
main()
"""


def posix_only(tree: ast.AST) -> list[str]:
    """What a module takes from POSIX systems, with its line."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            taken = [one.name for one in node.names if one.name in POSIX_MODULES]
        elif isinstance(node, ast.ImportFrom):
            taken = [node.module] if node.module in POSIX_MODULES else []
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            taken = [node.attr] if node.attr in POSIX_NAMES.get(node.value.id, ()) else []
        else:
            continue
        found += [f"line {node.lineno}: {name}" for name in taken]
    return found


def texts_without_encoding(tree: ast.AST) -> list[str]:
    """Texts that are read or written in the encoding of the computer, whatever that is."""
    found = []
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call) or any(one.arg == "encoding" for one in node.keywords):
            continue
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        method = isinstance(node.func, ast.Attribute)
        as_text = (method and name == "read_text" and not node.args) or (
            method and name == "write_text" and len(node.args) == 1
        )
        if name == "open" and not method:
            modes = [one.value for one in node.args[1:2] if isinstance(one, ast.Constant)]
            as_text = not any("b" in str(mode) for mode in modes)
        if as_text:
            found.append(f"line {node.lineno}: {name}")
    return found


@pytest.mark.parametrize("find", [posix_only, texts_without_encoding])
def test_no_module_needs_what_other_systems_lack(find):
    found = {path.name: find(ast.parse(path.read_text(encoding="utf-8"))) for path in SOURCES}
    assert not {name: lines for name, lines in found.items() if lines}


def test_what_other_systems_lack_is_noticed():
    """The searches of this module can fail."""
    taken = "import fcntl\nfrom resource import getrusage\nos.fork()\nsignal.signal(signal.SIGHUP, end)\n"
    assert [one.split(": ")[1] for one in posix_only(ast.parse(taken))] == ["fcntl", "resource", "fork", "SIGHUP"]
    texts = 'open("a")\nopen("a", "rb")\nPath("a").read_text()\nPath("a").write_text(b)\nPath("a").open("rb")\n'
    assert len(texts_without_encoding(ast.parse(texts))) == 3


@pytest.mark.slow
def test_a_case_is_solved_where_posix_is_missing(tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"), encoding="utf-8")
    for _ in range(2):  # the second run replaces the output of the first
        ended = subprocess.run(
            [sys.executable, "-c", WITHOUT_POSIX, "solve", "case.yaml", "--json", "case.json"],
            cwd=tmp_path, capture_output=True, text=True, encoding="utf-8", check=False,
        )  # fmt: skip
        assert ended.returncode == 0, ended.stderr
    assert (tmp_path / "case.json").stat().st_size > 1000
