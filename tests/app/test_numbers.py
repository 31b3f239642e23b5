"""Numbers of the page are those of `babbitt solve`, to the last digit, for the template of every kind."""

import json

import pytest

from babbitt.app.answer import answer, json_of
from babbitt.app.document import CaseDocument
from babbitt.app.solver import InUnits, Solver
from babbitt.core.kind import kinds
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import SYSTEMS
from babbitt.report.units_of_matrices import suited_among

pytestmark = pytest.mark.slow
PATIENT = 300.0


@pytest.fixture(scope="module")
def process():
    """One process for all questions, as the page has it: none of them may leave a trace in the next answer."""
    made = Solver(workers=1)
    yield made
    made.close()


def written_anew(template):
    """The case as the page keeps it once a field was touched."""
    document = CaseDocument(template)
    name = document.given["name"]
    for other in ("Touched", name):
        document.change(("name",), other)
    return document.text


def numbers_of(record):
    """Quantities with one value each, by name."""
    return {
        name: value
        for name, value in record["results"].items()
        if name in QUANTITIES and not isinstance(value, list)
    }


@pytest.mark.parametrize("kind", kinds())
def test_the_numbers_of_a_template_are_those_of_the_command(process, run, tmp_path, kind):
    template = kinds()[kind].read_template()
    (tmp_path / "case.yaml").write_text(template, encoding="utf-8")
    text = written_anew(template)

    def asked(system, *question):
        return InUnits(process, lambda: system).start(*question, longest=PATIENT).result(PATIENT)

    def told(system):
        run("solve", "case.yaml", "--json", "out.json", "--units", system)
        return json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))

    assert asked("us", answer, text, True).bearings  # a quick one before, as from a slider
    for system in SYSTEMS:
        found, wanted = json.loads(asked(system, json_of, text)), told(system)
        for record in (*found["bearings"], *wanted["bearings"]):
            record["results"].pop("wall_time", None)
        assert found == wanted
    shown = asked("si", answer, text)
    assert shown.case_hash == wanted["case_hash"]
    for bearing, record in zip(shown.bearings, wanted["bearings"], strict=True):
        numbers = numbers_of(record)
        assert numbers
        assert [(row[1], row[2]) for row in bearing.rows] == [
            (suited_among(name, numbers).symbol, suited_among(name, numbers).format(value))
            for name, value in numbers.items()
        ]
        assert (bearing.name, bearing.verdict_key) == (record["name"], record["verdict"])
