"""Every bad file is answered by one clear message at the right place, and by nothing else."""

import tomllib
from pathlib import Path

import pytest

from babbitt.case import CaseError, load_case, load_cases

BAD = Path(__file__).parent / "bad"
MANIFEST = tomllib.loads((BAD / "manifest.toml").read_text(encoding="utf-8"))
JARGON = (
    "pydantic",
    "pint",
    "validation",
    "http",
    "input_value",
    "input should",
    "valid string",
    "dimensionality",
    "union",
    "discriminator",
    "nonetype",
    "traceback",
    "tuple",
    "dict",
    "ge=",
    "le=",
    "none",
)


def without_given_words(message: str) -> str:
    """A message without what our own words and the file contribute to it on purpose."""
    return message.lower().replace("none of", "").replace("both limits or none", "").replace("both or none", "")


def test_the_folder_and_the_manifest_agree():
    assert {path.stem for path in BAD.glob("*.yaml")} == set(MANIFEST)
    assert len(MANIFEST) >= 45


@pytest.mark.parametrize("name", MANIFEST)
def test_bad_file(name):
    expected, path = MANIFEST[name], BAD / f"{name}.yaml"
    with pytest.raises(CaseError) as caught:
        load_case(path)
    assert len(caught.value.problems) == 1, caught.value
    problem = caught.value.problems[0]
    assert (problem.line, problem.field, problem.code) == (expected["line"], expected["field"], expected["code"])
    for words in expected["words"]:
        assert words in problem.message
    text = str(problem)
    assert text.startswith(f"{path}:")
    assert text.isprintable()
    assert len(text) < 500
    assert not [word for word in JARGON if word in without_given_words(problem.message)]
    assert caught.value.code == expected["code"]
    assert str(caught.value) == text


def test_all_files_at_once():
    paths = [BAD / f"{name}.yaml" for name in MANIFEST]
    with pytest.raises(CaseError) as refused:
        load_cases(paths)
    assert [Path(problem.file).stem for problem in refused.value.problems] == list(MANIFEST)
