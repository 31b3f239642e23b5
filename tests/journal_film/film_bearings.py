"""Bearings for the tests of the film method."""

from __future__ import annotations

from babbitt.case import case_from_dict
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.solving import MachineResult, solve

GROOVES = [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"}]


def case(**given):
    """A grooved bearing of a turbine size; None removes a field."""
    fields = {
        "kind": "journal",
        "name": "Bearing",
        "method": "film",
        "diameter": "200 mm",
        "width": "120 mm",
        "clearance": {"kind": "relative", "mean": "1.5 permille"},
        "materials": {"bearing": "C10", "journal": "C45"},
        "lubricant": "ISO VG 46",
        "supply": {"temperature": "45 degC", "pressure": "0.15 MPa"},
        "grooves": GROOVES,
        "load": "30 kN",
        "speed": "3000 rpm",
    } | given
    return case_from_dict({name: value for name, value in fields.items() if value is not None})


def film(**given) -> FilmCase:
    (found,) = case(**given).problems()
    assert isinstance(found, FilmCase)
    return found


def answer(**given):
    (result,) = solved(**given).results
    assert result.outcome.solved, result.message
    return result


def solved(**given) -> MachineResult:
    return solve(case(**given))
