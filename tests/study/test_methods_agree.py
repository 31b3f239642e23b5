"""What a method does not know is one truth: `compare` leaves a method out where the case language refuses it."""

from __future__ import annotations

from random import Random

import pytest
from journal_cases import JOURNALS
from pumped_trial import MAKERS

from babbitt.case import CaseError, case_from_dict
from babbitt.case.method_mapping import choices_of, every_choice
from babbitt.core.notices import InputError
from babbitt.kinds.hydrostatic.methods import JACKING_METHODS, METHODS
from babbitt.kinds.journal.case.build import bearings_of, unknown_to_iso7902, unknown_to_long_film
from babbitt.kinds.journal.case.journal import JournalBearing

REASONS = {"iso7902": unknown_to_iso7902, "long_film": unknown_to_long_film}
"""Why compare leaves a method out; empty where it does not."""
OF_ONE_METHOD = {
    "walls": "film",
    "pressure_viscosity": "film",
    "heat_exchange": "long_film",
    "segments": "segments",
}
"""Fields beside `method` that one method reads alone."""
TWO_DIMENSIONAL = [name for name in JOURNALS if name not in ("long film", "segments")]


def by(method: str, given: dict) -> dict:
    """The same bearing by another method, without the choices of the former one."""
    choices = every_choice(JournalBearing).keys() - choices_of(JournalBearing, method).keys()
    choices |= {name for name, one in OF_ONE_METHOD.items() if one != method}
    return {name: value for name, value in given.items() if name not in choices} | {"method": method}


def refusal(given: dict) -> str:
    try:
        case_from_dict(given).calculations()
    except (CaseError, InputError) as error:
        return str(error)
    return ""


@pytest.mark.parametrize("family", TWO_DIMENSIONAL)
def test_compare_and_check_agree_on_journal_bearings(family):
    for number in range(25):
        given = JOURNALS[family](Random(f"agree {family} {number}"))
        films = [given] if given.get("method") == "film" else [by("film", given)]
        for seen in [given, *films]:
            if refusal(seen):
                continue
            case = case_from_dict(seen)
            (bearing,) = bearings_of(case)
            for method, why in REASONS.items():
                if method != seen.get("method", "iso7902"):
                    assert bool(why(bearing, case)) == bool(refusal(by(method, seen))), (seen, method)


def test_standard_bearings_are_known_to_every_method_that_is_asked():
    """So that the test above sees both answers."""
    given = JOURNALS["iso7902"](Random("agree iso7902 1"))
    case = case_from_dict(by("film", given))
    assert unknown_to_iso7902(bearings_of(case)[0], case) == ""


@pytest.mark.parametrize("kind", ["pad", "ring", "journal", "jacking"])
def test_what_a_hydrostatic_method_refuses_it_does_not_solve(kind):
    methods = JACKING_METHODS if kind == "jacking" else METHODS
    for number in range(6):
        given = MAKERS[kind](Random(f"agree {kind} {number}")) | {"accuracy": "draft"}
        if refusal(given):
            continue
        problem = case_from_dict(given).calculations()[0].problem
        for name, method in methods.items():
            assert outcome(method.refuse, problem) == outcome(method.solve, problem), (given, name)


def test_closed_forms_refuse_short_recesses_whatever_the_case_asks_for():
    """A problem that asks for the film is asked by `compare` of the closed forms, too."""
    given = {
        "babbitt": 1, "kind": "hydrostatic_pad", "name": "Pad", "method": "film", "accuracy": "draft",
        "load": "2 kN", "recess_oil": {"depth": "1 mm"},
        "pad": {"kind": "rectangular", "length": "100 mm", "width": "100 mm", "recess_length": "20 mm",
                "recess_width": "20 mm"},
        "oil": {"viscosity": "30 mPa s"}, "supply": {"pressure": "3 MPa"},
        "restrictor": {"kind": "capillary", "diameter": "0.8 mm", "length": "60 mm"},
    }  # fmt: skip
    problem = case_from_dict(given).calculations()[0].problem
    quick = METHODS["quick"]
    assert outcome(quick.refuse, problem) == outcome(quick.solve, problem) == "E101"
    assert outcome(METHODS["film"].refuse, problem) == ""


def outcome(attempt, problem) -> str:
    try:
        attempt(problem)
    except InputError as error:
        return error.code
    return ""
