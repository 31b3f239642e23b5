"""Random hydrostatic bearings, jacking pockets and footsteps: balances, and nothing that depends on the view.

The generators and what is asked of every case ship in `benchmarks/robustness`, where more of them are tried.
"""

import random

import pytest
from pumped_trial import MAKERS, faults

SOLVED = {"pad": 6, "ring": 4, "journal": 5, "jacking": 3, "footstep": 6}


@pytest.mark.parametrize("kind", MAKERS)
def test_random_bearings_are_balanced_and_do_not_depend_on_the_view(kind):
    for seed in range(SOLVED[kind]):
        case = MAKERS[kind](random.Random(f"{kind} {seed}"))
        assert list(faults(case)) == [], f"{kind} {seed}"
