"""A hydrostatic journal that rotation alone carries does not float at rest."""

import pytest

from babbitt.case import case_from_dict
from babbitt.core.result import Outcome, Verdict
from babbitt.solving import solve


def journal(first_diameter, **fields):
    """100 x 100 mm, four recesses on 5 MPa, the lowest behind a capillary of its own."""
    tubes = [f"{first_diameter} mm", *["0.8 mm"] * 3]
    given = {
        "kind": "hydrostatic_journal", "name": "Journal", "method": "film", "diameter": "100 mm",
        "width": "100 mm", "clearance": {"kind": "radial", "mean": "50 um"},
        "recesses": {"number": 4, "extent": "60 deg", "first": "-90 deg"},
        "recess_length": "70 mm", "recess_oil": {"depth": "1 mm"}, "supply": {"pressure": "5 MPa"},
        "oil": {"viscosity": "20 mPa s", "density": "870 kg/m3", "heat_capacity": "2000 J/(kg K)"},
        "load": "10 kN", "load_angle": "-90 deg", "speed": "1500 rpm",
        "limits": {"minimum_film_thickness": "15 um"},
        "restrictors": [{"kind": "capillary", "diameter": one, "length": "100 mm"} for one in tubes],
    }  # fmt: skip
    return solve(case_from_dict(given | fields)).results[0]


@pytest.mark.parametrize(("diameter", "floats"), [(0.1, False), (0.8, True)])
def test_it_is_told_where_the_film_at_rest_does_not_carry(diameter, floats):
    """The bearing at rest, solved by itself, says the same."""
    turning, resting = journal(diameter), journal(diameter, speed="0 rpm")
    assert turning.outcome.solved
    assert resting.outcome is (Outcome.CONVERGED if floats else Outcome.OVERLOADED)
    assert ("W330" in {one.code for one in turning.warnings}) is not floats
    if not floats:
        assert turning.verdict is Verdict.REMARKS
