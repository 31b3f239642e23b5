"""Random tilting-pad bearings with their own temperatures; many more in `benchmarks/thermal_tilting_pads.py`."""

from dataclasses import replace

import numpy as np
import pytest
from thermal_pads import random_pads

from babbitt.core.result import Outcome
from babbitt.reynolds.tilting_pads.thermal_pads import find_thermal_tilting_pads


@pytest.mark.parametrize(("model", "seed", "number"), [("A", 11, 8), ("B", 12, 8), ("E", 13, 6)])
def test_every_random_bearing_ends_and_its_heat_closes(model, seed, number):
    rng = np.random.default_rng(seed)
    for _ in range(number):
        drawn = random_pads(rng, model)
        found = find_thermal_tilting_pads(*drawn)
        ends = [Outcome.CONVERGED, Outcome.PAD_AT_LIMIT] + [Outcome.NO_CLEARANCE] * (model == "E")
        assert found.outcome in ends
        assert found.energy_balance_error == pytest.approx(0.0, abs=1e-3)
        assert found.power_error == pytest.approx(0.0, abs=1e-9)
        assert all(pad.inlet > drawn.heat.supply_temperature - 1e-6 for pad in found.temperatures)
        if found.outcome is Outcome.CONVERGED:
            assert found.force + drawn.load == pytest.approx(0.0, abs=1e-3 * np.hypot(*drawn.load))
        assert (found.growth_share < 1.0) == (found.outcome is Outcome.NO_CLEARANCE)


def grown_at(drawn, taken):
    """By how much every pad, journal and housing would grow where the clearance were narrower by ``taken``, m."""
    bearing, growth = drawn.bearing, drawn.heat.growth
    narrower = tuple(
        replace(pad, clearance=pad.clearance - taken, assembled_clearance=pad.assembled_clearance - taken)
        for pad in bearing.pads
    )
    heat = replace(drawn.heat, growth=None)
    found = find_thermal_tilting_pads(replace(bearing, pads=narrower), drawn.load, heat)
    assert found.outcome.solved
    own, supply = growth.reference_temperature, drawn.heat.supply_temperature
    journal = growth.journal_expansion * bearing.radius * (found.journal_temperature - own)
    return [
        growth.pad_expansion * pad.thickness * (heated.mean - own) + journal
        - growth.housing_expansion * bearing.lever(pad) * (supply - own)
        for pad, heated in zip(bearing.pads, found.temperatures, strict=True)
    ]  # fmt: skip


@pytest.mark.slow
def test_a_bearing_closed_by_growth_grows_more_than_any_clearance_that_is_taken():
    """An independent look: no clearance, held by hand, leaves a growth as small as what was taken of it. The share
    with which films are found lies little below the greatest ratio of both."""
    rng = np.random.default_rng(1)
    drawn = [random_pads(rng, "ABE"[number % 3]) for number in range(45)]
    for number in (5, 44):
        found = find_thermal_tilting_pads(*drawn[number])
        assert found.outcome is Outcome.NO_CLEARANCE
        gap = drawn[number].bearing.assembled_clearance
        ratios = []
        for taken in np.linspace(0.05, 0.65, 7) * gap:
            grown = grown_at(drawn[number], taken)
            assert min(grown) > taken
            ratios.append(taken / np.mean(grown))
        assert 0.85 * max(ratios) < found.growth_share < 1.02 * max(ratios)
