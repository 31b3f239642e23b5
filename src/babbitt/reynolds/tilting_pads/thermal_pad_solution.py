"""The state of tilting pads with their temperatures, in SI and K; axes as of ``model``."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.heat.heat_model import mean_over_layers
from babbitt.reynolds.tilting_pads.pad_heat import PadHeat
from babbitt.reynolds.tilting_pads.solution import TiltingPadSolution

__all__ = ["PadTemperatures", "ThermalTiltingPadSolution"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PadTemperatures:
    """Temperatures and heat of a pad.

    Attributes
    ----------
    inlet : float
        Of the oil that enters, mixed in its groove, K.
    trailing : float
        Of the oil that leaves over the trailing edge, mean of its flow, K.
    maximum : float
        Highest in the film and at the bore, K.
    probe : float
        Of the bore where the probe of the pad stands, K.
    bore : ndarray, shape (n + 1,)
        At the lines of the film, K.
    film : ndarray, shape (n + 1, layers)
        Mean over the width, in the middle of layers from the bore to the journal, K.
    layers : ndarray, shape (layers,)
        Their places, from 0 at the bore to 1 at the journal.
    mean : float
        Of the pad itself, K; nan where it takes no heat.
    heat : float
        Into the pad, W.
    edge_heat : float
        Of that over both edges into the oil of the grooves, W.
    deflection : ndarray, shape (n + 1,)
        Bending at the lines, m, outward; zero at the pivot.
    growth : float
        By which its clearance is smaller for growth of pad, journal and housing, m.
    is_capped : bool
        Whether it is brought more oil than it takes: none of it is fresh.
    """

    inlet: float
    trailing: float
    maximum: float
    probe: float
    bore: Array
    film: Array
    layers: Array
    mean: float
    heat: float
    edge_heat: float
    deflection: Array
    growth: float
    is_capped: bool

    @property
    def back_heat(self) -> float:
        """What the pad gives off at its back, W."""
        return self.heat - self.edge_heat

    @property
    def film_mean(self) -> Array:
        """Mean over the gap at the lines, K, shape (n + 1,)."""
        return mean_over_layers(self.film, self.layers)


@dataclass(frozen=True, eq=False)
class ThermalTiltingPadSolution(TiltingPadSolution):
    """A journal among pads with their temperatures.

    Attributes
    ----------
    heat : PadHeat
    temperatures : tuple of PadTemperatures
        In the order of the bearing.
    journal_temperature, journal_heat : float
        K, and what the journal takes, W. The temperature is nan where it takes none.
    dissipation : float
        Of all films, W.
    oil_heat : float
        What the oil carries off above the temperature of the supply, W.
    supplied_flow : float
        Fresh oil that enters the pads, m3/s.
    growth_share : float
        Part of the growth that is taken: below 1 the largest found with a film, the outcome is then
        ``NO_CLEARANCE``.
    passes : int
        Of equilibrium, energy, walls and shape, in all attempts.
    """

    heat: PadHeat
    temperatures: tuple[PadTemperatures, ...]
    journal_temperature: float
    journal_heat: float
    dissipation: float
    oil_heat: float
    supplied_flow: float
    growth_share: float
    passes: int

    @property
    def maximum_temperature(self) -> float:
        """Highest in films and bores, K."""
        return max(pad.maximum for pad in self.temperatures)

    @property
    def pad_heat(self) -> float:
        """What the pads give off at their backs, W; over their edges they give it back to the oil."""
        return sum(pad.back_heat for pad in self.temperatures)

    @property
    def groove_temperatures(self) -> Array:
        """Of the oil in front of every pad, K, shape (pads,)."""
        return np.array([pad.inlet for pad in self.temperatures])

    @property
    def energy_balance_error(self) -> float:
        """What oil, pads and journal take, less the dissipation, over the dissipation."""
        return (self.oil_heat + self.pad_heat + self.journal_heat) / self.dissipation - 1.0

    @property
    def power_error(self) -> float:
        """Dissipation over the power of the torque on the journal, less 1."""
        return self.dissipation / self.friction_power - 1.0
