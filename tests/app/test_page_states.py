"""States of a page that end: the wait for kernels, an answer whose question was ended, numbers without a size."""

import asyncio
import contextlib
from concurrent.futures import Future
from dataclasses import replace
from itertools import count

import pytest

from babbitt.app.answer import Answer
from babbitt.app.coefficients import Speeds, first_speeds
from babbitt.app.document import CaseDocument
from babbitt.app.form import quantities
from babbitt.app.service import Service
from babbitt.app.solver import Ended
from babbitt.app.studies import axes_of, with_value
from babbitt.app.studies_view import StudiesView
from babbitt.app.workbench import Workbench
from babbitt.case.with_units import case_text
from babbitt.core.kind import kinds

JOURNAL = kinds()["journal"].read_template()


class Recorder:
    """Takes any call and keeps its name with what it was given."""

    def __init__(self):
        self.calls = []

    def __getattr__(self, name):
        return lambda *given, **_: self.calls.append((name, *given))


@pytest.fixture
def service(monkeypatch):
    made = Service()
    asked = []
    for solver in (made.solver, made.drafts, made.slow):
        monkeypatch.setattr(solver, "start", lambda *_, **__: asked.append(Future()) or asked[-1])
    made.load_kernels()
    yield made, asked
    made.close()


def test_a_page_waits_for_kernels_until_they_are_compiled(service):
    """Between loading and compiling nothing is compiled yet: a page that looks then goes on looking."""
    made, asked = service
    assert made.compiling is None
    assert not made.is_ready
    asked[0].set_result(False)
    assert made.compiling is not None
    assert not made.is_ready
    asked[1].set_result(None)
    assert made.compiling is None
    assert made.is_ready


def test_a_page_waits_for_no_kernels_that_are_there(service):
    made, asked = service
    asked[0].set_result(True)
    assert made.is_ready
    assert made.compiling is None


def test_processes_load_kernels_one_after_the_other(service):
    """Two at once would share two cores with the server, and the first answer would come behind them."""
    _, asked = service
    assert len(asked) == 1
    asked[0].set_result(True)
    assert len(asked) == 2
    asked[1].set_result(None)
    assert len(asked) == 3


def test_a_server_that_closes_starts_nothing_more(service):
    _, asked = service
    asked[0].set_result(True)
    asked[1].cancel()
    assert len(asked) == 2


@pytest.mark.parametrize(
    "error", [Ended("too_long"), Ended("died"), ValueError("an error of the program")], ids=str
)
def test_a_question_without_an_answer_takes_the_old_one_away(error):
    class Asked:
        async def ask(self, *_):
            raise error

    page = Workbench.__new__(Workbench)
    page._settled, page._questions, page._shown, page._awaited = Asked(), count(1), 0, 0
    page._computing, page._parts = Recorder(), (part := Recorder(),)
    page.document, page.found = CaseDocument(JOURNAL), Answer(case_hash="of an older case")
    page._view, page._drawing, page._results = view, drawing, results = Recorder(), Recorder(), Recorder()
    with contextlib.suppress(ValueError):
        asyncio.run(page._answered(False))
    assert page.found == Answer()
    ((name, why),) = view.calls
    assert name == "fail"
    assert "ended" in why
    assert drawing.calls == results.calls == [("fade",)]
    assert [name for name, *_ in part.calls] == ["classes", "classes"]
    assert page._awaited == 0


@pytest.mark.parametrize("value", ["nan", "inf", "1e400", "-inf"])
def test_a_number_without_a_size_is_no_value_to_vary(value):
    document = CaseDocument(JOURNAL)
    document.change(("load",), f"{value} kN")
    document.change(("speed",), f"{value} rpm")
    assert ("load",) not in [one.path for one in quantities(document.items)]
    assert "load" not in axes_of(document, "sweep")
    assert first_speeds(document) == Speeds("500 rpm", "5000 rpm")


def test_an_axis_follows_its_value_in_the_case_and_keeps_what_was_typed_else():
    """The fit of a tolerance is that of the case; ends of a load that did not change stay as typed."""
    view = StudiesView.__new__(StudiesView)
    view.document, view._kind, view._known = CaseDocument(JOURNAL), "tolerance", {}
    view._system, view._computed, view._case = (lambda: "si"), [], {}
    view._aside = {}
    view._axes = dict.fromkeys(("clearance", "load"))
    view._follow()
    assert view._axes["clearance"].law_of == "H7/d8"
    view._set("load", first="1 kN")
    view.document.change(("clearance", "journal"), "e7")
    view._follow()
    assert view._axes["clearance"].law_of == "H7/e7"
    assert view._axes["load"].first == "1 kN"


def test_a_field_that_is_wrong_for_a_while_keeps_its_place_in_a_study():
    """A typing error in the load made the study one of the diameter."""
    view = StudiesView.__new__(StudiesView)
    view.document, view._kind, view._known = CaseDocument(JOURNAL), "sweep", {}
    view._system, view._computed, view._case, view._aside = (lambda: "si"), [], {}, {}
    view._axes = {"load": None}
    view._follow()
    view._set("load", last="30 kN")
    load = view.document.given["load"]
    for value in ("12x kN", load):
        view.document.change(("load",), value)
        view._follow()
    assert view._axes["load"].last == "30 kN"
    view.document.change(("load",), "much")
    view._follow()
    assert not view._axes
    view.document.change(("load",), "20 kN")
    view._follow()
    assert view._axes["load"].last == "40 kN"  # that of the new value


def test_the_range_of_a_study_stays_when_its_value_is_taken_and_taken_back():
    """A number takes the place of the fit and undo brings it back: both are cases of which the study was asked."""
    view = StudiesView.__new__(StudiesView)
    view.document, view._kind, view._known = CaseDocument(JOURNAL), "size", {}
    view._system, view._computed, view._samples, view._case = (lambda: "si"), [], 0, {}
    view._aside = {}
    view._axes = {"clearance.mean": None}
    view._follow()
    view._set("clearance.mean", last="8 permille")
    view._asked()
    view._set("clearance.mean", last="9 permille")  # typed behind the study
    view._follow()
    assert view._axes["clearance.mean"].last == "9 permille"
    view.document.take(case_text(with_value(view.document.given, "clearance.mean", "4 permille")))
    view._computed.append(replace(view._computed[0], case=view.document.without_study))
    for move in (lambda: None, view.document.undo):
        move()
        view._follow()
        assert view._axes["clearance.mean"].last == "8 permille"
    view.document.change(("clearance",), {"kind": "relative", "mean": "2 permille"})  # another case, and back
    view._follow()
    assert view._axes["clearance.mean"].last == "4 permille"
    view.document.undo()
    view._follow()
    assert view._axes["clearance.mean"].last == "8 permille"
