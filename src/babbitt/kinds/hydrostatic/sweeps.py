"""Sweeps over gap, eccentricity, frequency and power of one hydrostatic bearing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.answer import Answer, answer_at, load_vector
from babbitt.kinds.hydrostatic.impedance import impedance
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.state import SearchOutcome

__all__ = ["FrequencyCurve", "LoadCurve", "PowerMap", "over_frequency", "over_gap", "power_map"]

Array = NDArray[np.float64]
ECCENTRICITIES = np.concatenate((np.linspace(0.0, 0.7, 29), np.linspace(0.71, 0.9, 20)))
GAPS = np.geomspace(0.4, 2.5, 31)


@dataclass(frozen=True)
class LoadCurve:
    """Load and stiffness over the gap of a pad, m, or the eccentricity ratio of a journal.

    ``at`` (n,), ``load`` (n,) N, ``stiffness`` (n,) N/m, ``pressure_ratio`` (n, recesses).
    """

    at: Array
    load: Array
    stiffness: Array
    pressure_ratio: Array


def over_gap(case: HydrostaticCase, found: Answer, method: str) -> LoadCurve:
    """Force at prescribed places by a method: a journal moves from the centre in the direction where it stands.

    Parameters
    ----------
    case : HydrostaticCase
    found : Answer
        Of the case.
    method : {"film", "quick"}

    Returns
    -------
    LoadCurve
    """
    case = replace(case, method=method, accuracy="draft")
    rows = list(states_over_gap(case, found))
    return LoadCurve(*(np.array(column) for column in zip(*rows, strict=True)))


def states_over_gap(case: HydrostaticCase, found: Answer) -> Iterator[tuple[float, float, float, Array]]:
    """Place, force, stiffness and pressure ratios."""
    if case.is_journal:
        size = float(np.hypot(*found.at))
        towards = found.at / size if size > 1e-9 * found.rest_gap else np.array([0.0, -1.0])
        places = [(e, e * found.rest_gap * towards, found.rest_gap) for e in ECCENTRICITIES]
    else:
        own = found.rest_gap + float(found.at[0])
        level = np.zeros(load_vector(case).size)  # of all motions: a quick pad knows but one
        places = [(share * own, level, share * own) for share in GAPS]
    for place, at, gap in places:
        state = answer_at(case, at, gap)
        if state.ending is not SearchOutcome.SOLVED:
            continue
        stiffness = impedance(state.response, state.network, case.compressibility, 0.0)[0]
        force = state.response.force
        load, own_stiffness = float(force[0]), float(stiffness[0, 0])
        if case.is_journal:
            load, own_stiffness = float(np.hypot(*force)), float(towards @ stiffness @ towards)
        yield float(place), load, own_stiffness, state.network.pressures / state.network.supply_pressure


@dataclass(frozen=True)
class FrequencyCurve:
    """Stiffness (n, motions, motions) and damping over frequency (n,) in rad/s."""

    frequency: Array
    stiffness: Array
    damping: Array


def over_frequency(case: HydrostaticCase, found: Answer) -> FrequencyCurve:
    """Stiffness and damping from 1 Hz to 10 kHz."""
    frequency = 2.0 * np.pi * np.geomspace(1.0, 1e4, 81)
    pairs = [impedance(found.response, found.network, case.compressibility, float(nu)) for nu in frequency]
    return FrequencyCurve(frequency, np.array([k for k, _ in pairs]), np.array([c for _, c in pairs]))


@dataclass(frozen=True)
class PowerMap:
    """Powers in W over gap (columns, m) and viscosity (rows, Pa s), restrictors made to suit."""

    gap: Array
    viscosity: Array
    pumping: Array
    friction: Array


def power_map(gap: float, viscosity: float, pumping: float, friction: float) -> PowerMap:
    """Powers about an operating point at the same pressures: h^3/mu and mu/h.

    Parameters
    ----------
    gap, viscosity : float
        m and Pa s.
    pumping, friction : float
        W, there.
    """
    gaps, viscosities = gap * np.geomspace(0.4, 2.5, 61), viscosity * np.geomspace(0.25, 4.0, 61)
    h, mu = np.meshgrid(gaps / gap, viscosities / viscosity)
    return PowerMap(gaps, viscosities, pumping * h**3 / mu, friction * mu / h)
