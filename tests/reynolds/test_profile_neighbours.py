"""Lands with sampled bores do not depend on how finely their neighbours are sampled."""

import math

import numpy as np
import pytest
from scaled_pads import bearing, pad

from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.lands.profiles import MOST_SAMPLES, common_profiles
from babbitt.reynolds.model import JournalFilm, Land, Resolution
from babbitt.reynolds.tilting_pads.solve import tilting_pads_at

GRID = Resolution(4, 48)
BENT = (0.0, 0.08, 0.0, 0.04, 0.1)


def sampled(number):
    """A straight taper by its samples."""
    return tuple(np.linspace(0.0, 0.05, number)) if number else ()


@pytest.mark.parametrize("number", [0, 2, 4, 7])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_pad_does_not_feel_the_samples_of_its_neighbour(number, sense):
    first, second = pad(0.0, 70.0, 0.55, 0.3, profile=BENT), pad(180.0, 70.0, 0.55, 0.3, profile=sampled(number))
    alone, beside = bearing((first,), 0.5, sense), bearing((first, second), 0.5, sense)
    one, two = (tilting_pads_at(chosen, (0.2, 0.1), GRID).pads[0] for chosen in (alone, beside))
    assert one.load > 0.1
    assert two.load == pytest.approx(one.load, rel=1e-9)
    assert two.tangential == pytest.approx(one.tangential, abs=1e-9)


@pytest.mark.parametrize("number", [0, 1, 2, 4, 7])
def test_a_lobe_does_not_feel_the_samples_of_its_neighbour(number):
    ends = math.radians(100.0), math.radians(260.0), math.radians(280.0), math.radians(440.0)
    one, two = (
        film_at_position(
            JournalFilm(0.1, 0.05, 1e-4, 0.02, 300.0, (
                Land(*ends[:2], profile=tuple(1e-4 * part for part in BENT)),
                Land(*ends[2:], profile=tuple(1e-4 * part for part in taper)),
            )),
            (-5e-5, 0.0), resolution=GRID,
        )
        for taper in ((), sampled(number))
    )  # fmt: skip
    assert two.pressure[0] == pytest.approx(one.pressure[0], rel=1e-9, abs=1.0)
    assert one.pressure[0].max() > 1e5


def test_a_common_grid_holds_every_sample():
    table = common_profiles([BENT, (0.0, 1.0, 0.0, 2.0), ()])
    assert table.shape == (3, 13)
    assert table[0, ::3] == pytest.approx(BENT)
    assert table[1, ::4] == pytest.approx((0.0, 1.0, 0.0, 2.0))
    assert not table[2].any()


def test_a_common_grid_is_bounded():
    table = common_profiles([np.linspace(0.0, 1.0, 1009) ** 2, np.zeros(1013)])
    assert table.shape == (2, MOST_SAMPLES)
    assert table[0] == pytest.approx(np.linspace(0.0, 1.0, MOST_SAMPLES) ** 2, abs=1e-6)
