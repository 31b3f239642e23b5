"""Random plausible bearings of every family: no traceback, no silent imbalance, no choice of axes, order or units.

The same families run by the thousand in `benchmarks/robustness/bearings.py`.
"""

import pytest
from bearings import FAMILIES

pytestmark = pytest.mark.solves_anew

NUMBER = {
    "iso7902": 133, "long film": 100, "segments": 5, "film, grooved": 5, "film, pockets": 3, "film, lobed": 2,
    "film, turbulent": 3, "film, thermal": 2, "film, elastic": 1, "pad": 16, "ring": 4, "journal": 5,
    "jacking": 4, "footstep": 16, "thrust": 3, "shaft line": 1,
}  # fmt: skip
"""Cases of the families, 300 without the long ones, most of the cheap ones; of all others `USUAL`."""
USUAL = 10


LONG = {"thrust"}
"""Families whose cases take ten seconds each, left to `make test-thorough`: shaft lines have the same bearings."""


def families() -> list[object]:
    return [pytest.param(name, marks=[pytest.mark.thorough] * (name in LONG)) for name in FAMILIES]


@pytest.mark.parametrize("name", families())
def test_random_bearings(name: str) -> None:
    faults = {}
    for index in range(NUMBER.get(name, USUAL)):
        outcome = FAMILIES[name](f"test {name} {index}")
        if outcome.faults:
            faults[index] = outcome.faults
    assert not faults


DEPENDED = {
    "film, grooved": "1127001 film, grooved 1361",  # the threshold speed on the axes
    "film, pockets": "1127001 film, pockets 1202",  # the flow without supply pressure on the axes
    "film, thermal": "1127001 film, thermal 53",  # two sets of wet nodes on the units of a wall
}


@pytest.mark.parametrize("name", DEPENDED)
def test_what_once_depended_on_axes_or_units(name: str) -> None:
    assert not FAMILIES[name](DEPENDED[name]).faults
