"""What the heat of tilting pads needs to know: oil, feed, journal, pads, their bending and growth.

Values that nobody publishes for a bearing are assumptions and named so; all may be given.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.reynolds.heat.heat_model import JournalHeat
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.model import TiltingPadBearing

__all__ = ["THERMAL_PADS", "PadBending", "PadGrowth", "PadHeat", "PadMaterial", "PadWalls"]

Array = NDArray[np.float64]

THERMAL_PADS = Resolution(4, 48)
"""Usual grid: temperatures within 0.2 K of finer ones."""
HEAT_TRANSFER = 100.0
"""W/(m2 K), of back and edges of a pad to the oil around it. Assumption."""
STEEL_CONDUCTIVITY, STEEL_MODULUS, STEEL_EXPANSION = 50.0, 210e9, 1.2e-5
"""W/(m K), Pa, 1/K: usual values of carbon steel."""


FOUND = JournalHeat()
"""A journal with one temperature that takes no heat on the whole."""


@dataclass(frozen=True)
class PadWalls:
    """Pads that conduct heat in r and theta.

    Attributes
    ----------
    conductivity : float
        W/(m K).
    back_coefficient, edge_coefficient : float
        Heat transfer at the back and at both edges, W/(m2 K). 100: an assumption.
    back_temperature : float or None
        K; None: that of the supply. The edges stand in the oil of their grooves.
    """

    conductivity: float = STEEL_CONDUCTIVITY
    back_coefficient: float = HEAT_TRANSFER
    edge_coefficient: float = HEAT_TRANSFER
    back_temperature: float | None = None

    def __post_init__(self) -> None:
        if not self.conductivity > 0.0:
            raise InputError("E101", f"conductivity of the pads is {self.conductivity} W/(m K); it must be "
                             "positive.")  # fmt: skip
        for name in ("back_coefficient", "edge_coefficient"):
            if not getattr(self, name) >= 0.0:
                raise InputError("E101", f"{name} of the pads is {getattr(self, name)} W/(m2 K); it must not be "
                                 "negative.")  # fmt: skip
        if self.back_coefficient + self.edge_coefficient == 0.0:
            raise InputError("E101", "back_coefficient and edge_coefficient of the pads are zero; for pads that "
                             "give off no heat leave walls out.")  # fmt: skip


@dataclass(frozen=True)
class PadBending:
    """Pads that bend as beams held at their pivots, under pressure and by the temperature across them.

    Attributes
    ----------
    elastic_modulus : float
        Pa.
    thermal_expansion : float
        1/K.
    poisson_ratio : float
        0: beams; otherwise plates, with E/(1 - nu^2).
    """

    elastic_modulus: float = STEEL_MODULUS
    thermal_expansion: float = STEEL_EXPANSION
    poisson_ratio: float = 0.0

    @property
    def plate_modulus(self) -> float:
        """E/(1 - nu^2): of beams the elastic modulus, of plates more, Pa."""
        return self.elastic_modulus / (1.0 - self.poisson_ratio**2)

    def __post_init__(self) -> None:
        if not self.elastic_modulus > 0.0:
            raise InputError("E101", f"elastic_modulus of the pads is {self.elastic_modulus} Pa; it must be "
                             "positive.")  # fmt: skip
        if not self.thermal_expansion >= 0.0:
            raise InputError("E101", f"thermal_expansion of the pads is {self.thermal_expansion} 1/K; it must not "
                             "be negative.")  # fmt: skip
        if not 0.0 <= self.poisson_ratio <= 0.5:
            raise InputError("E101", f"poisson_ratio of the pads is {self.poisson_ratio}; it must lie between 0 "
                             "and 0.5.")  # fmt: skip


@dataclass(frozen=True)
class PadGrowth:
    """Pads, journal and housing that grow with their temperatures and change the assembled clearance.

    Attributes
    ----------
    reference_temperature : float
        At which the clearances are those of the bearing, K.
    pad_expansion, journal_expansion, housing_expansion : float
        1/K.
    housing_temperature : float or None
        K; None: that of the supply, an assumption that decides on bearings whose clearance nearly closes.
    housing_radius : float or None
        Radius of the contact of pivot and housing, m; None: that of the pivot.
    """

    reference_temperature: float
    pad_expansion: float = STEEL_EXPANSION
    journal_expansion: float = STEEL_EXPANSION
    housing_expansion: float = STEEL_EXPANSION
    housing_temperature: float | None = None
    housing_radius: float | None = None

    def __post_init__(self) -> None:
        for name in ("pad_expansion", "journal_expansion", "housing_expansion"):
            if not getattr(self, name) >= 0.0:
                raise InputError("E101", f"{name} is {getattr(self, name)} 1/K; it must not be negative.")


@dataclass(frozen=True)
class PadMaterial:
    """What one pad is made of where it differs from the others. None: as all.

    Attributes
    ----------
    conductivity, elastic_modulus, thermal_expansion, poisson_ratio : float or None
        As of `PadWalls`, `PadBending` and `PadGrowth`.
    """

    conductivity: float | None = None
    elastic_modulus: float | None = None
    thermal_expansion: float | None = None
    poisson_ratio: float | None = None


@dataclass(frozen=True)
class PadHeat:
    """Heat of the films of tilting pads.

    Attributes
    ----------
    viscosity : callable
        Pa s at temperatures in K, shape kept.
    volumetric_heat_capacity : float
        rho c of the oil, J/(m3 K).
    conductivity : float
        Of the oil, W/(m K).
    supply_temperature : float
        K.
    journal : JournalHeat or None
        One temperature for the journal, given or from its heat balance. None: it takes no heat.
    walls : PadWalls or None
        None: the pads take no heat.
    bending : PadBending or None
        Of pads with ``walls``.
    growth : PadGrowth or None
        Of pads with ``walls`` and of the journal.
    carry_over : float
        Share of the oil that leaves a pad and enters the next one, as far as that takes oil, 0 to 1.
    layers : int
        Across the gap.
    materials : tuple of PadMaterial
        Of every pad what it has of its own; empty: all are alike.
    """

    viscosity: Callable[[Array], Array]
    volumetric_heat_capacity: float
    conductivity: float
    supply_temperature: float
    journal: JournalHeat | None = FOUND
    walls: PadWalls | None = None
    bending: PadBending | None = None
    growth: PadGrowth | None = None
    carry_over: float = 1.0
    layers: int = 8
    materials: tuple[PadMaterial, ...] = ()

    def __post_init__(self) -> None:
        for name in ("volumetric_heat_capacity", "conductivity", "supply_temperature"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units, K).")
        if not 0.0 <= self.carry_over <= 1.0:
            raise InputError("E101", f"carry_over is {self.carry_over}; it is a share, from 0 to 1.")
        if self.layers < 3:
            raise InputError("E101", f"layers is {self.layers}; a film needs three layers or more.")
        if self.walls is None and (self.bending is not None or self.growth is not None):
            raise InputError("E101", "bending and growth of pads need their temperatures; give walls.")
        if self.growth is not None and self.journal is None:
            raise InputError("E101", "growth of the journal needs its temperature; give journal.")

    def walls_of(self, number: int) -> PadWalls | None:
        """How a pad conducts."""
        own = self._material(number).conductivity
        return self.walls if self.walls is None or own is None else replace(self.walls, conductivity=own)

    def bending_of(self, number: int) -> PadBending | None:
        """How a pad bends."""
        own = self._material(number)
        names = ("elastic_modulus", "thermal_expansion", "poisson_ratio")
        changes = {name: value for name in names if (value := getattr(own, name)) is not None}
        return self.bending if self.bending is None else replace(self.bending, **changes)

    def pad_expansion_of(self, number: int) -> float:
        """Thermal expansion of a pad that grows, 1/K."""
        assert self.growth is not None
        own = self._material(number).thermal_expansion
        return self.growth.pad_expansion if own is None else own

    def narrowing(self, bearing: TiltingPadBearing, number: int, journal: float, pad: float) -> float:
        """How much narrower the gap of a pad is by growth of pad and journal, less that of the housing, m.

        Pads are taken to come closer by as much along their whole arc: machined and assembled clearance shrink
        together. (A pad also opens its bore as it warms; an assumption that leaves it out.)

        Parameters
        ----------
        bearing : TiltingPadBearing
        number : int
            Of the pad, from 0.
        journal, pad : float
            Temperatures of the journal and of the pad at its pivot, K.
        """
        growth, one = self.growth, bearing.pads[number]
        assert growth is not None
        housing = self.supply_temperature if growth.housing_temperature is None else growth.housing_temperature
        radius = bearing.lever(one) if growth.housing_radius is None else growth.housing_radius
        return (
            growth.journal_expansion * bearing.radius * (journal - growth.reference_temperature)
            + self.pad_expansion_of(number) * one.thickness * (pad - growth.reference_temperature)
            - growth.housing_expansion * radius * (housing - growth.reference_temperature)
        )

    def _material(self, number: int) -> PadMaterial:
        return self.materials[number] if self.materials else PadMaterial()
