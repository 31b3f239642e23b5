"""Terminals, pipes and interrupts: no traceback, the right exit status, and what is finished is kept."""

import csv
import json
import os
import signal
import subprocess
import sys

import pytest

from babbitt.case import template
from babbitt.study import case_sweep

LAUNCH = "import sys; sys.argv[0] = 'babbitt'; from babbitt.cli import main; main()"

COMMANDS = (
    ("list", "materials"),
    ("solve", "case.yaml"),
    ("solve", "case.yaml", "--json", "-"),
    ("explain", "W103"),
    ("schema",),
    ("--help",),
)


def launched(folder, *arguments, program=LAUNCH, shell="", **variables):
    """Run the program as a process of its own; with `shell` what its output is led to."""
    command = [sys.executable, "-c", program, *arguments]
    if shell:
        command = ["bash", "-c", f'set -o pipefail; "$@" {shell}', "bash", *command]
    variables = os.environ | {"COLUMNS": "160"} | variables
    return subprocess.run(command, cwd=folder, env=variables, capture_output=True, timeout=120)


def case_in(folder):
    """The folder, with a case in it."""
    name = "name: Lager Ψ µ ö"
    text = template("journal").replace("name: Example bearing", name)
    assert name in text
    (folder / "case.yaml").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture
def folder(tmp_path):
    return case_in(tmp_path)


@pytest.mark.parametrize("shell", ["| (exec <&-; sleep 0.1)", "| head -1", ">&-", "2>&-", "<&- >&- 2>&-"])
@pytest.mark.parametrize("command", [COMMANDS[0], COMMANDS[2]], ids=" ".join)
def test_nobody_has_to_read_on(folder, command, shell):
    ended = launched(folder, *command, shell=shell)
    assert (ended.returncode, ended.stderr) == (0, b"")


def test_files_are_written_and_the_status_is_right_though_nobody_reads_the_table(folder):
    text = (folder / "case.yaml").read_text(encoding="utf-8")
    (folder / "heavy.yaml").write_text(
        "\n".join("load: 900 MN" if line.startswith("load:") else line for line in text.splitlines()),
        encoding="utf-8",
    )
    for case, status in (("case.yaml", 0), ("heavy.yaml", 3)):
        ended = launched(folder, "solve", case, "--json", f"{case}.json", shell="| (exec <&-; sleep 0.1)")
        assert (ended.returncode, ended.stderr) == (status, b"")
        assert json.loads((folder / f"{case}.json").read_text(encoding="utf-8"))["bearings"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_a_full_disk_is_told(folder):
    ended = launched(folder, "solve", "case.yaml", shell="> /dev/full")
    assert ended.returncode == 2
    assert b"cannot write to standard output" in ended.stderr
    assert b"Traceback" not in ended.stderr


@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_letters_that_an_encoding_lacks_end_nothing(folder, command, encoding):
    ended = launched(folder, *command, PYTHONIOENCODING=encoding)
    assert (ended.returncode, ended.stderr) == (0, b"")
    text = ended.stdout.decode(encoding)
    if "--json" in command:
        assert json.loads(text)["case"] == "Lager Ψ µ ö"
    elif command == ("schema",):
        assert json.loads(text)["title"] == "Babbitt case"
    elif encoding == "ascii" and command[0] == "solve":
        assert "Lager Psi u o" in text
        assert " um" in text, "the prefix of a unit is never lost"
        assert "permille" in text
        assert "?" not in text
        table = [line for line in text.splitlines() if line.count("|") == 3]
        assert len(table) > 20
        heading, *rows = ([place for place, letter in enumerate(line) if letter == "|"] for line in table)
        assert sum(row == heading for row in rows) > 0.8 * len(rows), "columns stay where they are"


@pytest.fixture(scope="module")
def of_usual_width(tmp_path_factory):
    """What a terminal of 140 columns shows of the case."""
    return launched(case_in(tmp_path_factory.mktemp("usual")), "solve", "case.yaml", COLUMNS="140").stdout


@pytest.mark.parametrize("columns", ["0", "1", "-5", "many", ""])
def test_a_width_that_is_none_is_not_believed(folder, columns, of_usual_width):
    for command in (("solve", "case.yaml"), ("--help",)):
        ended = launched(folder, *command, COLUMNS=columns)
        assert (ended.returncode, ended.stderr) == (0, b"")
        assert b"bearing" in ended.stdout
        if command[0] == "solve":
            assert ended.stdout == of_usual_width


AT_IMPORT = """
import os, signal, sys

wanted = sys.argv[1]

class Interrupt:
    def find_spec(self, name, path=None, target=None):
        if name == wanted:
            os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Interrupt())
from babbitt.cli import main
sys.argv = ["babbitt", *sys.argv[2:]]
main()
"""


@pytest.mark.parametrize("module", ["typer", "babbitt.cli.info", "pydantic", "numpy", "rich.table"])
def test_an_interrupt_while_modules_are_loaded_is_one_line(folder, module):
    ended = launched(folder, module, "solve", "case.yaml", "--json", "out.json", program=AT_IMPORT)
    assert (ended.returncode, ended.stderr) == (130, b"interrupted\n")
    assert sorted(path.name for path in folder.iterdir()) == ["case.yaml"]


def test_an_interrupt_while_a_file_is_written_leaves_what_was_there(folder):
    assert launched(folder, "solve", "case.yaml", "--json", "out.json").returncode == 0
    before = (folder / "out.json").read_bytes()
    program = (
        "import os, signal; from babbitt.core.files import writing\n"
        "def umask(): os.kill(os.getpid(), signal.SIGINT)\n"
        "writing._umask = umask\n" + LAUNCH
    )
    ended = launched(folder, "solve", "case.yaml", "--json", "out.json", program=program)
    assert (ended.returncode, ended.stderr) == (130, b"interrupted\n")
    assert (folder / "out.json").read_bytes() == before
    assert sorted(path.name for path in folder.iterdir()) == ["case.yaml", "out.json"]


@pytest.mark.parametrize("finished", [0, 2])
def test_an_interrupted_sweep_keeps_the_rows_that_are_finished(run, tmp_path, monkeypatch, finished):
    (tmp_path / "case.yaml").write_text(template("journal"))
    solve, solved = case_sweep.solve, []

    def interrupted(case):
        if len(solved) == finished:
            os.kill(os.getpid(), signal.SIGINT)
        solved.append(solve(case))
        return solved[-1]

    monkeypatch.setattr(case_sweep, "solve", interrupted)
    status, _, err = run("sweep", "case.yaml", "load", "1 kN:5 kN:5", "--csv", "a.csv", "--plot", "a.svg")
    assert status == 130
    assert len(err.splitlines()) == 1
    assert err.startswith("interrupted")
    assert (tmp_path / "a.csv").exists() == (tmp_path / "a.svg").exists() == bool(finished)
    if finished:
        assert "2 of 5 values" in err
        rows = list(csv.DictReader((tmp_path / "a.csv").read_text().splitlines()))
        assert [row["load [kN]"] for row in rows] == ["1.0", "2.0"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_name_that_moves_the_cursor_is_printed_with_its_escapes(folder):
    ended = launched(folder, "solve", "no\x1b[31m.yaml")
    assert ended.returncode == 2
    assert b"\x1b" not in ended.stderr
    assert rb"no\x1b[31m.yaml" in ended.stderr
    (folder / "odd\x1b[31m.yaml").write_bytes((folder / "case.yaml").read_bytes())
    ended = launched(folder, "check", "odd\x1b[31m.yaml")
    assert ended.returncode == 0
    assert b"\x1b" not in ended.stdout


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (("explain", " w103 "), "W103"),
        (("list", "Kinds"), "journal"),
        (("explain", "W1011"), "W101"),
        (("explain", "?"), "C101, C102"),
        (("new", "Journal"), "did you mean 'journal'?"),
        (("list", "oils"), "lubricants"),
        (("explain", "W\x1b[31m"), "W\\x1b[31m"),
    ],
)
def test_what_is_asked_for_loosely_is_understood_or_hinted_at(run, command, words):
    status, out, err = run(*command)
    assert words in out + err
    assert "\x1b" not in out + err
    assert status == (0 if command[1].lower().strip() in ("w103", "kinds") else 2)
