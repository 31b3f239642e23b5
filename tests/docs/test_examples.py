"""Every example of the documentation runs as shown, and says what is shown."""

from __future__ import annotations

import contextlib
import doctest
import io
import runpy
import shlex
import shutil
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from example_blocks import ROOT, Block, Step, blocks, pages, steps

from babbitt.cli import main

FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
RUN_LANGUAGES = {"console", "python", "yaml"}
SHOWN_LANGUAGES = {"text"}
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")

COMPILING = "babbitt: compiling the kernels"
"""What the first run of all says, and no other."""


GALLERY = ROOT / "examples" / "README.md"
"""Every example, each solved by a test of its own."""

LONG = {"reverse_gear_film.yaml", "starved_journal.yaml", "helical_gear_shaft.yaml", "unbalanced_fan.yaml"}
"""Examples whose goldens are thorough, too; pages of the documentation run shorter cases of their kinds."""


def with_examples() -> list[Path]:
    run = (page for page in pages() if any(block.language in RUN_LANGUAGES for block in blocks(page)))
    return [page for page in run if page != GALLERY]


def of_the_gallery() -> list[object]:
    """Commands of the list of examples; `make test-thorough` runs the long ones."""
    (block,) = (block for block in blocks(GALLERY) if block.language in RUN_LANGUAGES)
    marks = {step.command: [pytest.mark.thorough] * bool(LONG & {*step.command.split()}) for step in steps(block)}
    return [pytest.param(step, id=step.command, marks=marks[step.command]) for step in steps(block)]


def relative(page: Path) -> str:
    return str(page.relative_to(ROOT))


@pytest.fixture
def workplace(tmp_path: Path) -> Iterator[Path]:
    """A folder with the examples, both as in the repository and at hand."""
    for file in (ROOT / "examples").iterdir():
        if file.suffix in (".yaml", ".py"):
            shutil.copy(file, tmp_path)
    shutil.copytree(ROOT / "examples", tmp_path / "examples", ignore=shutil.ignore_patterns("__pycache__"))
    with contextlib.chdir(tmp_path), pytest.MonkeyPatch.context() as patch:
        patch.delenv("COLUMNS", raising=False)
        yield tmp_path


@contextlib.contextmanager
def captured() -> Iterator[io.StringIO]:
    output = io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
        yield output


def run(command: str) -> tuple[int, str]:
    """Run `babbitt ...` or `python script.py` in this process; exit status and output, both streams together."""
    words = shlex.split(command)
    saved, status = sys.argv, 0
    with captured() as output:
        try:
            if words[0] == "babbitt":
                sys.argv = words
                main()
            else:
                sys.argv = words[1:]
                runpy.run_path(words[1], run_name="__main__")
        except SystemExit as end:
            status = int(end.code or 0)
        finally:
            sys.argv = saved
    told = [line for line in output.getvalue().splitlines(keepends=True) if not line.startswith(COMPILING)]
    return status, "".join(told)


def is_run(command: str) -> bool:
    words = shlex.split(command)
    return words[0] == "babbitt" or (words[0] == "python" and words[1].endswith(".py"))


def check_not_run(command: str, shown: str, place: str) -> None:
    """What prepares the environment is not run; what it names must exist."""
    words = shlex.split(command)
    assert not shown, f"{place}: {command} is not run, so no output may be shown"
    match words:
        case ["make", *targets]:
            for target in targets:
                assert f"\n{target}:" in MAKEFILE, f"{place}: no target {target!r} in the Makefile"
        case ["pip", "install", what]:
            extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
            assert what.removeprefix(".[").removesuffix("]") in extras, f"{place}: {what}"
        case ["python", "-m", "venv", ".venv"] | [".", ".venv/bin/activate"] | ["git", "clone", *_]:
            pass
        case [".venv/bin/pre-commit", "install"]:
            pass
        case _:
            pytest.fail(f"{place}: {command!r} is neither run by this test nor known to be left out")


def agrees(want: str, got: str) -> bool:
    return doctest.OutputChecker().check_output(want, got, FLAGS)


def run_console(block: Block, place: str) -> None:
    script = steps(block)
    status = 0
    for number, step in enumerate(script):
        where = f"{place}, line {block.line}"
        if step.command == "echo $?":
            assert step.shown.strip() == str(status), f"{where}: exit status is {status}"
            continue
        if not is_run(step.command):
            check_not_run(step.command, step.shown, where)
            continue
        asked = number + 1 < len(script) and script[number + 1].command == "echo $?"
        status = run_step(step, where, asked)


def run_step(step: Step, where: str, asked: bool) -> int:
    """Run one command and compare what it prints; its exit status, which is zero unless it is asked for next."""
    status, output = run(step.command)
    assert asked or status == 0, f"{where}: {step.command} ended with {status}:\n{output}"
    if step.shown:
        assert agrees(step.shown, output), f"{where}: {step.command} printed\n{output}\nshown is\n{step.shown}"
    else:
        assert not output.strip() or status == 0, f"{where}: {step.command} printed\n{output}"
    return status


def run_python(block: Block, place: str, names: dict[str, object]) -> None:
    if ">>>" not in block.text:
        exec(compile(block.text, place, "exec"), names)
        return
    test = doctest.DocTestParser().get_doctest(block.text, names, place, place, block.line)
    report = io.StringIO()
    runner = doctest.DocTestRunner(optionflags=FLAGS)
    runner.run(test, out=report.write, clear_globs=False)
    names.update(test.globs)
    assert runner.failures == 0, report.getvalue()


@pytest.mark.slow
@pytest.mark.parametrize("page", with_examples(), ids=relative)
def test_examples_run_as_shown(page: Path, workplace: Path) -> None:
    names: dict[str, object] = {"__name__": "__main__"}
    place = relative(page)
    for block in blocks(page):
        if block.stands_for:
            (workplace / block.stands_for).write_text(block.text, encoding="utf-8")
        elif block.output_of:
            status, output = run(block.output_of)
            assert status == 0
            assert agrees(block.text + "...\n", output), f"{place}: {block.output_of} printed\n{output}"
        elif block.language == "console":
            run_console(block, place)
        elif block.language == "python":
            run_python(block, place, names)


@pytest.mark.slow
@pytest.mark.parametrize("step", of_the_gallery())
@pytest.mark.usefixtures("workplace")
def test_every_example_runs_as_shown_in_their_list(step: Step) -> None:
    run_step(step, relative(GALLERY), asked=False)


@pytest.mark.parametrize("page", pages(), ids=relative)
def test_every_block_is_run_or_said_to_be_text(page: Path) -> None:
    for block in blocks(page):
        place = f"{relative(page)}, line {block.line}"
        if block.language.startswith("{"):
            continue  # a directive of Sphinx
        assert block.language in RUN_LANGUAGES | SHOWN_LANGUAGES, f"{place}: {block.language!r}"
        if block.language == "yaml":
            assert block.stands_for, f"{place}: say with '<!-- file: NAME -->' which file this is"


def test_every_example_is_listed_and_shown() -> None:
    listed = (ROOT / "examples" / "README.md").read_text(encoding="utf-8")
    for file in (ROOT / "examples").iterdir():
        if file.suffix in (".yaml", ".py"):
            assert f"[{file.name}]({file.name})" in listed
            assert f" {file.name}" in listed.split("```console")[1], f"{file.name} is not run there"


def test_a_wrong_output_is_noticed() -> None:
    """The comparison of this module can fail."""
    assert agrees("a 11.5\n...\n", "a   11.5 \nmore\n")
    assert not agrees("a 11.6\n...\n", "a   11.5 \nmore\n")
