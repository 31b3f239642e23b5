"""The workflow of hosted integration asks for what there is: targets, files, Pythons."""

import re
import tomllib

import pytest
import yaml


@pytest.fixture
def root(request):
    return request.config.rootpath


@pytest.fixture
def workflow(root):
    return yaml.safe_load((root / ".github" / "workflows" / "ci.yml").read_text("utf-8"))


@pytest.fixture
def commands(workflow):
    return "\n".join(step["run"] for job in workflow["jobs"].values() for step in job["steps"] if "run" in step)


def test_every_target_and_file_of_the_workflow_is_there(root, commands):
    targets = re.findall(r"^make ([\w -]+)$", commands, re.MULTILINE)
    files = re.findall(r"\b(?:examples|tests)/[\w/.-]+", commands)
    known = re.findall(r"^([\w-]+):", (root / "Makefile").read_text("utf-8"), re.MULTILINE)
    assert {"lint", "test", "docs", "minima"} <= set(targets) <= set(known)
    assert files
    assert [name for name in files if not (root / name).exists()] == []


def test_tests_run_on_the_lowest_python_and_on_windows(root, workflow):
    project = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]
    lowest = project["requires-python"].removeprefix(">=")
    pythons = workflow["jobs"]["test"]["strategy"]["matrix"]["python"]
    assert pythons == ["3.11", "3.12", "3.13"]
    assert pythons[0] == lowest
    assert workflow["jobs"]["windows"]["runs-on"] == "windows-latest"


@pytest.mark.parametrize("name", ["bug_report", "feature_request"])
def test_a_form_asks_for_what_an_answer_needs(root, name):
    form = yaml.safe_load((root / ".github" / "ISSUE_TEMPLATE" / f"{name}.yml").read_text("utf-8"))
    asked = {one["id"] for one in form["body"] if one.get("validations", {}).get("required")}
    assert {"bug_report": {"case", "expected", "version"}, "feature_request": {"task"}}[name] <= asked
