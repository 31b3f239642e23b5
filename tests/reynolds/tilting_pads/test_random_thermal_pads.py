"""Random tilting-pad bearings with their own temperatures; many more in `benchmarks/thermal_tilting_pads.py`."""

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
