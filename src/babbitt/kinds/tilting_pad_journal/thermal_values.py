"""The named values of pads with their own temperatures."""

from __future__ import annotations

import numpy as np

from babbitt.core.result import Matrix
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.values import outlet_values
from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution

__all__ = ["thermal_rows", "thermal_values"]


def thermal_values(case: PadCase, films: PadFilms) -> dict[str, float]:
    """Temperatures and heat of films with their own temperatures; empty of others."""
    found = films.thermal
    if found is None or case.oil_supply is None:
        return {}
    named = {
        "maximum_temperature": found.maximum_temperature,
        "probe_temperature": max(pad.probe for pad in found.temperatures),
        "hottest_trailing_temperature": hottest_trailing(found),
        "groove_temperature": float(found.groove_temperatures.max()),
        "journal_temperature": found.journal_temperature,
        **outlet_values(case.oil_supply, films, found.oil_heat),
        "film_dissipation": found.dissipation,
        "dissipation_error": found.power_error,
        "heat_to_oil": found.oil_heat,
        "heat_to_pads": found.pad_heat,
        "heat_film_to_journal": found.journal_heat,
        "energy_balance_error": found.energy_balance_error,
    }
    if case.heat.growth is not None:
        named |= {
            "growth_share": found.growth_share,
            "running_clearance": min(pad.assembled_clearance for pad in found.bearing.pads),
        }
    return {name: float(value) for name, value in named.items()}


def hottest_trailing(found: ThermalTiltingPadSolution) -> float:
    """Highest of the temperatures of the oil that leaves a pad, K."""
    return float(np.nanmax([pad.trailing for pad in found.temperatures]))


def thermal_rows(case: PadCase, films: PadFilms) -> dict[str, Matrix]:
    """One row with a number per pad; empty where films have one temperature."""
    found = films.thermal
    if found is None:
        return {}
    pads = found.temperatures
    rows: dict[str, list[float]] = {
        "pad_mixed_temperature": [pad.inlet for pad in pads],
        "pad_trailing_temperature": [pad.trailing for pad in pads],
        "pad_maximum_temperature": [pad.maximum for pad in pads],
        "pad_probe_temperature": [pad.probe for pad in pads],
    }
    if case.heat.walls is not None:
        rows |= {"pad_mean_temperature": [pad.mean for pad in pads], "pad_heat": [pad.back_heat for pad in pads]}
        rows["pad_edge_heat"] = [pad.edge_heat for pad in pads]
    if case.heat.growth is not None:
        rows["pad_growth"] = [pad.growth for pad in pads]
    if case.heat.bending is not None:
        rows["pad_bending"] = [float(np.abs(pad.deflection).max()) for pad in pads]
    return {name: (tuple(float(one) for one in row),) for name, row in rows.items()}
