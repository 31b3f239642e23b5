"""From a file to a case, or to the list of all that is wrong with it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path as FilePath
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from babbitt.case.case_file import CaseFile, Origin
from babbitt.case.document import DocumentError, Node, read_document
from babbitt.case.error_messages import Path, nearest, shown
from babbitt.case.kinds import KINDS
from babbitt.case.named_files import NamedFiles, TableError
from babbitt.case.part import PartT
from babbitt.case.parts.study import StudyBlock
from babbitt.case.parts.title_block import TitleBlock
from babbitt.case.problems import CaseError, Problem
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach
from babbitt.core.notices import InputError
from babbitt.core.units import AS_WRITTEN

LARGEST_FILE = 1_000_000
"""Bytes."""

LONGEST_KEY = 60
"""Characters of a key that a message shows."""

VERSION = 1
"""Version of the case language."""

STUDY = "study"
"""Key of the study that stands beside a case."""

DOCUMENT = "document"
"""Key of the title block of its report."""

BLAMED: dict[str, Path] = {"E202": ("pads", "pivot")}
"""Field to blame for a refusal that a solution shows, by its code."""


def load_case(path: str | FilePath, reach: Reach = Reach.FOLDER) -> CaseFile:
    """Read a case file.

    Parameters
    ----------
    path : str or Path
        A YAML or JSON file in UTF-8 of at most 1 MB.
    reach : Reach
        Where it may name other files.

    Returns
    -------
    CaseFile

    Raises
    ------
    CaseError
        With every problem of the file.
    """
    path = FilePath(path)
    return parsed_in(text_of(path), path, reach)


def parse_case(text: str, name: str = "<text>", reach: Reach = Reach.FOLDER) -> CaseFile:
    """Read a case from text, which stays with it as `text`.

    Parameters
    ----------
    text : str
        YAML or JSON.
    name : str
        What to call the text in messages.
    reach : Reach
        Where it may name other files.

    Raises
    ------
    CaseError
        With every problem of the text.

    Notes
    -----
    Tables that the case names are sought from the working folder; `load_case` seeks them from the folder of the
    file.

    Examples
    --------
    >>> parse_case("kind: jurnal", "a.yaml")
    Traceback (most recent call last):
    babbitt.case.problems.CaseError: a.yaml:1: kind: 'jurnal' is not a kind of case; allowed: journal, machine,
    shaft, overhung_coupling, screw_heel, hydrostatic_pad, hydrostatic_thrust_ring, hydrostatic_journal,
    jacking_pocket, thrust, thrust_line, tilting_pad_journal; did you mean 'journal'? [E003]
    """
    return _parsed(text, name, NamedFiles(FilePath(), reach))


def read_file(path: FilePath) -> dict[str, Any]:
    """What stands in a case file, not yet checked but for being a mapping.

    Raises
    ------
    CaseError
        When it cannot be read, or is no document of the case language.
    """
    given = read_tree(text_of(path), printable(path)).plain()
    if not isinstance(given, dict):
        load_case(path)  # reports what is wrong
    return dict(given)


def build_case(given: Mapping[str, Any], name: str, files: NamedFiles) -> CaseFile:
    """Read a case from a dictionary that may read some files.

    Raises
    ------
    CaseError
        With every problem; lines are 0.
    """
    return _case(dict(given), name, None, files)


def read_tree(text: str, name: str) -> Node:
    """The values of a text with their places; raises CaseError for one that is no document."""
    try:
        return read_document(text)
    except DocumentError as error:
        problem = Problem(name, error.line, "", error.says, allowed=error.allowed, hint=error.hint, code="E002")
        raise CaseError([problem]) from None


def _parsed(text: str, name: str, files: NamedFiles) -> CaseFile:
    root = read_tree(text, name)
    return _case(root.plain(), name, root, files).with_text(text)


def parsed_in(text: str, file: FilePath, reach: Reach = Reach.FOLDER) -> CaseFile:
    """Read a case from text as if it stood in a file.

    Raises
    ------
    CaseError
        With every problem of the text.
    """
    return _parsed(text, printable(file), NamedFiles(file.parent, reach))


def case_from_dict(given: Mapping[str, Any], name: str = "<case>", reach: Reach = Reach.FOLDER) -> CaseFile:
    """Read a case from a dictionary, as it would stand in a file.

    Raises
    ------
    CaseError
        With every problem; lines are 0.
    """
    return _case(dict(given), name, None, NamedFiles(FilePath(), reach))


def located(error: InputError, case: CaseFile, file: str | FilePath) -> CaseError:
    """The refusal of a case that was read, with its file and, where it names one, its field.

    Parameters
    ----------
    error : InputError
    case : CaseFile
    file : str or Path
        What the case was read from.
    """
    if isinstance(error, CaseError):
        return error
    root = read_document(case.text) if case.text else None
    given = (case.origin.given if case.origin is not None else {}) if root is None else root.plain()
    path = BLAMED.get(error.code) or _named_in(error.message, given)
    return CaseError([_problem(str(file), root, given, path, error.message, code=error.code)])


def _named_in(message: str, given: Any) -> Path:
    """Path of the field that a message names by its first word, or by a word with underscores; empty if none.

    Of several places the one nearest to the top is meant, unless two are as near.
    """
    places: dict[str, list[Path]] = {}
    stack: list[tuple[Path, Any]] = [((), given)]
    while stack:
        path, value = stack.pop()
        pairs = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
        for key, below in pairs:
            stack.append(((*path, key), below))
            if isinstance(key, str):
                places.setdefault(key, []).append((*path, key))
    words = re.findall(r"^[a-z_]+|\b[a-z]+_[a-z_]+\b", message)
    for word in words:
        nearest_first = sorted(places.get(word, ()), key=len)
        if nearest_first and len({len(path) for path in nearest_first[:2]}) == len(nearest_first[:2]):
            return nearest_first[0]
    return ()


def load_cases(paths: Iterable[str | FilePath], reach: Reach = Reach.FOLDER) -> tuple[CaseFile, ...]:
    """Read several case files, or report every problem of all of them at once.

    Raises
    ------
    CaseError
        With the problems of all files.
    """
    cases: list[CaseFile] = []
    problems: list[Problem] = []
    for path in paths:
        try:
            cases.append(load_case(path, reach))
        except CaseError as error:
            problems += error.problems
    if problems:
        raise CaseError(problems)
    return tuple(cases)


def _case(given: Any, name: str, root: Node | None, files: NamedFiles) -> CaseFile:
    if not isinstance(given, dict):
        says = f"the file holds {shown(given)}"
        raise CaseError([Problem(name, 1, "", says, allowed="a mapping of fields that begins with kind: ...")])
    version = given.get("babbitt", VERSION)
    if type(version) is not int or version != VERSION:
        says = f"version {shown(version)} of the case language is not known"
        raise CaseError([_problem(name, root, given, ("babbitt",), says, str(VERSION))])
    kind = given.get("kind")
    if not isinstance(kind, str) or kind not in KINDS:
        says = "kind is missing" if "kind" not in given else f"{shown(kind)} is not a kind of case"
        hint = nearest(kind, KINDS) if isinstance(kind, str) else ""
        if "kind" not in given and STUDY in given and "case" in given:
            says, hint = "kind is missing: the file holds a study of another file", "try babbitt study"
        within = given.get(STUDY)
        if "kind" not in given and isinstance(within, Mapping) and "case" in within:
            says, hint = "case stands within the study", "put it beside study, as far to the left"
            raise CaseError([_problem(name, root, given, (STUDY, "case"), says, "", hint)])
        raise CaseError([_problem(name, root, given, ("kind",), says, ", ".join(KINDS), hint)])
    study, found = _beside(StudyBlock, STUDY, given)
    block, wrong = _beside(TitleBlock, DOCUMENT, given)
    found += wrong
    bearing = {key: value for key, value in given.items() if key not in (STUDY, DOCUMENT)}
    try:
        block = block and block.with_picture(files, (DOCUMENT, "logo"))
        model = KINDS[kind]
        read = model.with_named_files(bearing, files)
        case = model.model_validate(read, context=AS_WRITTEN).with_files(tuple(files.taken))
    except TableError as error:
        raise CaseError([table_problem(error, given, name, root)]) from None
    except ValidationError as error:
        found = [*error.errors(include_url=False), *found]
    if found:
        raise CaseError(problems_of(found, given, name, root))
    made = case.with_origin(Origin(bearing, files.folder / FilePath(name).name, files.reach))
    made = made if block is None else made.with_title_block(block)
    return made if study is None else made.with_study(study)


def _beside(part: type[PartT], key: str, given: Mapping[str, Any]) -> tuple[PartT | None, list[ErrorDetails]]:
    """What stands beside a case under a key, and what is wrong with it; None where there is none."""
    if key not in given:
        return None, []
    try:
        return part.model_validate(given[key], context=AS_WRITTEN), []
    except ValidationError as error:
        return None, [{**one, "loc": (key, *one["loc"])} for one in error.errors(include_url=False)]


def problems_of(
    found: Iterable[ErrorDetails], given: Any, name: str, root: Node | None = None
) -> tuple[Problem, ...]:
    """Say what pydantic found in a case, each with its place.

    Parameters
    ----------
    found : iterable of ErrorDetails
        Of a `Part`, which speak plainly already.
    given : object
        What the case was to be read from.
    name : str
        Of the file, or what stands for it.
    root : Node, optional
        The document, for the lines.
    """
    contexts = [(details["loc"], details["ctx"]) for details in found]
    return tuple(
        _problem(name, root, given, path, one["says"], one["allowed"], one["hint"], one["code"])
        for path, one in contexts
    )


def table_problem(error: TableError, given: Any, name: str, root: Node | None = None) -> Problem:
    """Say what is wrong with a file that a case names, with the place where it names it."""
    return _problem(name, root, given, error.path, error.says, error.allowed, error.hint)


def _problem(
    name: str,
    root: Node | None,
    given: Any,
    path: Path,
    says: str,
    allowed: str = "",
    hint: str = "",
    code: str = "E003",
) -> Problem:
    value, steps, what = given, [], ""
    for step in path:
        if not isinstance(value, dict | list | tuple):
            break  # a shorthand: the field that was filled from one word has no key of its own
        container: Any = value
        try:
            value = container[step]
        except (LookupError, TypeError):
            value = None
            steps.append(_step(step, value))
            break
        steps.append(_step(step, value))
        what = "" if isinstance(value, dict | list | tuple) else shown(value)
    line = root.line_of(path) if root is not None else 0
    return Problem(name, line, "".join(steps).removeprefix("."), says, what, allowed, hint, code)


def _step(step: str | int, value: Any) -> str:
    if isinstance(step, str):
        return f".{step}" if len(step) <= LONGEST_KEY else f".{step[: LONGEST_KEY - 3]}..."
    own = value.get("name") if isinstance(value, dict) else None
    return f"[{step} {shown(own)}]" if isinstance(own, str) else f"[{step}]"


def text_of(path: FilePath) -> str:
    """The text of a file; raises CaseError for one that cannot be read."""

    def refuse(says: str, allowed: str = "", hint: str = "", line: int = 0) -> CaseError:
        return CaseError([Problem(printable(path), line, "", says, allowed=allowed, hint=hint, code="E001")])

    try:
        if not path.exists():
            raise refuse("there is no such file", hint="check the path")
        if not path.is_file():
            raise refuse("this is not a file", "a text file")
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
    except OSError as error:
        raise refuse(f"the file cannot be read: {(error.strerror or 'no reason given').lower()}") from None
    if len(content) > LARGEST_FILE:
        raise refuse("the file is too large", f"{LARGEST_FILE // 1_000_000} MB")
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise refuse("the file is in UTF-16", "text in UTF-8", "save it as UTF-8")
    if b"\x00" in content:
        raise refuse("the file is binary", "text in UTF-8")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        says = f"the byte 0x{content[error.start]:02x} is not UTF-8"
        raise refuse(says, "text in UTF-8", "save the file as UTF-8, or write degC for °C", line) from None
