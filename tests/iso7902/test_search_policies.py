"""The sparing search of the film method, judged by films of the standard, which cost little to know better."""

import random
from functools import partial

import pytest

from babbitt.case import case_from_dict
from babbitt.design.heat_balance import COARSE_SEARCH, FINE_SEARCH, find_equilibrium
from babbitt.kinds.journal.iso7902.film import curves_of, film_at


def some_bearing(seed):
    chance = random.Random(seed)
    diameter = 10.0 ** chance.uniform(1.5, 2.7)
    given = {
        "kind": "journal",
        "name": "Some bearing",
        "diameter": f"{diameter} mm",
        "width": f"{diameter * chance.choice([0.3, 0.5, 0.8, 1.0])} mm",
        "clearance": {"kind": "relative", "mean": f"{chance.uniform(0.6, 3.1)} permille"},
        "specific_load": f"{10.0 ** chance.uniform(-1.0, 1.3)} MPa",
        "surface_speed": f"{10.0 ** chance.uniform(-0.5, 1.8)} m/s",
        "span": "360 deg",
        "supply": {
            "temperature": f"{chance.uniform(30, 60)} degC",
            "pressure": f"{chance.uniform(0.02, 0.3)} MPa",
        },
        "supply_element": {"kind": "hole", "diameter": f"{0.05 * diameter} mm", "place": "opposite"},
        "lubricant": "ISO VG 46",
        "materials": {"bearing": chance.choice(["C10", "AlSi10Mg"]), "journal": "C45"},
    }
    (design,) = case_from_dict(given).problems()
    return design


@pytest.mark.parametrize("seed", range(60))
def test_both_searches_end_alike(seed):
    case = some_bearing(seed)
    film = partial(film_at, case=case, shape=curves_of(case))
    thorough, sparing = (find_equilibrium(case, film, policy) for policy in (FINE_SEARCH, COARSE_SEARCH))
    assert sparing.outcome is thorough.outcome
    if thorough.outcome.solved:
        assert sparing.last_temperature == pytest.approx(thorough.last_temperature, abs=1e-6)
    assert sparing.evaluations <= 30
