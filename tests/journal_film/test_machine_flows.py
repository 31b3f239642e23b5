"""Oil of a machine of films: what its pump has to deliver, whatever each supply is given."""

import pytest

from babbitt.case import case_from_dict
from babbitt.report.totals import totals
from babbitt.solving import solve

LITRE = 1e-3 / 60.0
BEARING = {
    "kind": "journal", "method": {"kind": "film", "accuracy": "draft"}, "diameter": "100 mm", "width": "50 mm",
    "clearance": {"kind": "relative", "mean": "1.2 permille"}, "load": "6 kN", "speed": "2000 rpm",
    "grooves": [{"angle": "90 deg", "extent": "20 deg"}], "effective_temperature": "60 degC",
}  # fmt: skip
OWN = [{}, {}, {"supply": {"flow": "0.3 L/min"}}, {"supply": {"pressure": "0.2 MPa"}}]


def test_the_pump_of_a_machine_delivers_every_given_flow_and_what_given_pressures_press_into_films():
    bearings = [BEARING | own | {"name": f"B{number}"} for number, own in enumerate(OWN)]
    case = case_from_dict(
        {
            "kind": "machine", "name": "M", "lubricant": "ISO VG 46", "bearings": bearings,
            "materials": {"bearing": "C10", "journal": "C45"},
            "supply": {"temperature": "45 degC", "flow": "2 L/min"},
        }
    )  # fmt: skip
    results = solve(case).results
    assert [one.values.get("given_flow", 0.0) / LITRE for one in results] == pytest.approx([2.0, 2.0, 0.3, 0.0])
    pressed = results[3].side_flow + results[3].supply_flow
    needed = totals(results).values["pump_flow"]
    assert needed == pytest.approx(4.3 * LITRE + pressed, rel=1e-6)
    assert needed > 1.2 * totals(results).values["total_flow"]
