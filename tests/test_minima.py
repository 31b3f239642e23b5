"""The lowest versions that are declared are those that the smoke set runs on."""

import re
import tomllib


def test_the_smoke_set_runs_on_the_declared_minima(request):
    root = request.config.rootpath
    project = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]
    declared = [
        *project["dependencies"],
        *(one for extra in project["optional-dependencies"].values() for one in extra),
    ]
    lowest = dict(re.match(r"([\w.-]+)>=([\d.]+)", one).groups() for one in declared)
    pinned = dict(re.findall(r"(?m)^([\w.-]+)==([\d.]+)$", (root / "constraints-minima.txt").read_text("utf-8")))
    assert pinned.keys() == lowest.keys()
    for name, version in lowest.items():
        numbers = version.split(".")
        assert pinned[name].split(".")[: len(numbers)] == numbers
        assert set(pinned[name].split(".")[len(numbers) :]) <= {"0"}
