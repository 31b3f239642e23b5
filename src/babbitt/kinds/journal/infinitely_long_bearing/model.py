"""What the long film with heat exchange needs to know: SI numbers and chosen methods."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING, Any

from babbitt.core.notices import InputError
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad
from babbitt.kinds.journal.one_dimension import LongFilmProblem, positive
from babbitt.properties.lubricants import Lubricant

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
else:
    Array = Any

FEWEST_CELLS, COARSE_BELOW = 24, 90
"""Sectors of the film: the least allowed, and those below which loads are off by more than about 0.5 %."""

THICKEST_FILM = 0.02
"""Largest c/R of a thin film."""

SUPPLY_ANGLES = (math.radians(100.0), math.radians(270.0))
"""Where the oil may enter, rad from the narrowest gap. Further from the widest gap the film would break where it
starts, or begin behind its place of rupture."""

DUCT_COEFFICIENT, DUCT_EXPONENT = 1.55, 1.0 / 3.0
"""Laminar flow in a duct with developing temperature, ``Nu = 1.55 (Pe d/l)^(1/3)``; textbook formula."""


class Discretisation(Enum):
    """How Reynolds' equation and the flow of the heat balance are written.

    CONSISTENT keeps the divergence form, so that one flow passes every section. The other two repeat a published
    calculation that dropped the derivative of viscosity; its local flow varies around the film, and the heat
    balance takes the mean over the full film (PUBLISHED_MEAN) or the local value (PUBLISHED_LITERAL).
    """

    CONSISTENT = "consistent"
    PUBLISHED_MEAN = "published_mean"
    PUBLISHED_LITERAL = "published_literal"

    @property
    def conserves_flow(self) -> bool:
        """Whether the same flow passes every section of the film."""
        return self is Discretisation.CONSISTENT

    @property
    def exchange_zone(self) -> ExchangeZone:
        """The ruptured zone as this discretisation has it unless something else is asked for."""
        return ExchangeZone.LIQUID_FRACTION if self.conserves_flow else ExchangeZone.ALL_AROUND


class ExchangeZone(Enum):
    """How much of the ruptured film rubs and exchanges heat."""

    LIQUID_FRACTION = "liquid_fraction"
    ALL_AROUND = "all_around"
    FILM = "film"


@dataclass(frozen=True)
class NusseltLaw:
    """Heat transfer from film to wall, ``Nu = a (Pe h/D)^n`` with ``Nu = α h/λ`` and ``Pe = u h ρ c_p/λ``.

    An exponent of 0 makes `coefficient` a constant Nusselt number; 3.77 is that of fully developed flow between
    walls of one temperature, formed with the gap.
    """

    coefficient: float = DUCT_COEFFICIENT
    exponent: float = DUCT_EXPONENT

    def __post_init__(self) -> None:
        if not (0.0 <= self.coefficient < math.inf and 0.0 <= self.exponent <= 1.0):
            raise InputError(
                "E003",
                f"Nusselt law: coefficient {self.coefficient:g}, exponent {self.exponent:g}; allowed are a "
                "coefficient from 0 and an exponent from 0 to 1",
            )

    def __call__(self, peclet: Array, gap_ratio: Array) -> Array:
        """Nusselt number of every sector from ``Pe`` and ``h/D``, arrays of one shape."""
        if self.exponent == 0.0:
            return self.coefficient + 0.0 * peclet
        return self.coefficient * (peclet * gap_ratio) ** self.exponent


Nusselt = Callable[[Array, Array], Array]
"""Nusselt number from Péclet number and h/D."""


@dataclass(frozen=True)
class BushRing:
    """The bush as a ring: outer diameter in m, conductivity in W/(m K), coefficient to the ambient in W/(m² K)."""

    outer_diameter: float
    conductivity: float
    ambient_coefficient: float = 0.0


@dataclass(frozen=True)
class HeatExchange:
    """Where heat goes other than into the oil.

    `bush` None is an adiabatic bush. `shaft_conductance` in W/K leads from the journal to the ambient, whose
    temperature in K must be known where anything leads there.
    """

    nusselt: Nusselt = field(default_factory=NusseltLaw)
    bush: BushRing | None = None
    shaft_conductance: float = 0.0
    ambient_temperature: float | None = None

    @property
    def reaches_ambient(self) -> bool:
        """Whether any heat can leave to the surroundings."""
        return self.shaft_conductance > 0.0 or (self.bush is not None and self.bush.ambient_coefficient > 0.0)


@dataclass(frozen=True)
class LongFilm:
    """One long film, whatever it carries; SI.

    Attributes
    ----------
    diameter, width, clearance : float
        Bore, axial length, radial clearance.
    angular_speed : float
        Of the journal, positive.
    lubricant : Lubricant
    inlet_temperature : float
        Of the oil where it enters, K.
    exchange : HeatExchange
    discretisation : Discretisation
    exchange_zone : ExchangeZone or None
        None takes that of the discretisation.
    cells : int
        Sectors around the film.
    supply_angle : float
        φ₁, where the oil enters: rad from the narrowest gap in the direction of rotation; π is the widest gap.
    """

    diameter: float
    width: float
    clearance: float
    angular_speed: float
    lubricant: Lubricant
    inlet_temperature: float
    exchange: HeatExchange = field(default_factory=HeatExchange)
    discretisation: Discretisation = Discretisation.CONSISTENT
    exchange_zone: ExchangeZone | None = None
    cells: int = 180
    supply_angle: float = math.pi

    def __post_init__(self) -> None:
        for said in issues_of(self):
            raise InputError("E003", f"long film: {said}")

    @property
    def radius(self) -> float:
        """R in m."""
        return 0.5 * self.diameter

    @property
    def start(self) -> float:
        """Angle at which the film starts, rad from the widest gap."""
        return self.supply_angle - math.pi

    @property
    def surface_speed(self) -> float:
        """Speed u of the journal surface in m/s."""
        return self.angular_speed * self.radius

    @property
    def zone(self) -> ExchangeZone:
        """The ruptured zone in force."""
        return self.exchange_zone or self.discretisation.exchange_zone


def issues_of(film: LongFilm) -> tuple[str, ...]:
    """Say what of a long film cannot be used, each with its value."""
    found = [*positive(film, "diameter", "width", "clearance", "angular_speed", "inlet_temperature")]
    if not found and film.clearance / film.radius > THICKEST_FILM:
        ratio = film.clearance / film.radius
        found.append(f"clearance over radius is {ratio:.3g}, a thin film has up to {THICKEST_FILM:g}")
    if film.cells < FEWEST_CELLS:
        found.append(f"cells must be at least {FEWEST_CELLS}, given {film.cells}")
    if not SUPPLY_ANGLES[0] <= film.supply_angle <= SUPPLY_ANGLES[1]:
        least, most = (math.degrees(one) for one in SUPPLY_ANGLES)
        given = math.degrees(film.supply_angle)
        found.append(f"supply_angle must lie from {least:g} to {most:g} deg, given {given:.4g} deg")
    exchange, bush = film.exchange, film.exchange.bush
    if not 0.0 <= exchange.shaft_conductance < math.inf:
        found.append(f"shaft_conductance must not be negative, given {exchange.shaft_conductance!r}")
    if bush is not None:
        if not film.diameter < bush.outer_diameter < math.inf:
            found.append(f"outer_diameter of the bush, {bush.outer_diameter!r} m, must exceed the diameter")
        for name in ("conductivity", "ambient_coefficient"):
            if not 0.0 <= getattr(bush, name) < math.inf:
                found.append(f"{name} of the bush must not be negative, given {getattr(bush, name)!r}")
    if exchange.reaches_ambient and exchange.ambient_temperature is None:
        found.append("ambient_temperature is missing: heat leaves to the surroundings")
    return tuple(found)


@dataclass(frozen=True, kw_only=True)
class LongFilmCase(LongFilmProblem):
    """One bearing at one operating point, to be computed as a long film."""

    duty: PrescribedLoad | PrescribedEccentricity
    exchange: HeatExchange = field(default_factory=HeatExchange)
    discretisation: Discretisation = Discretisation.CONSISTENT
    exchange_zone: ExchangeZone | None = None
    cells: int = 180
    supply_angle: float = math.pi

    @property
    def film(self) -> LongFilm:
        """The film of the case."""
        bearing = self.bearing
        return LongFilm(
            bearing.diameter,
            bearing.width,
            self.clearance,
            abs(self.journal_speed),
            self.lubricant,
            self.oil_supply.temperature,
            self.exchange,
            self.discretisation,
            self.exchange_zone,
            self.cells,
            self.supply_angle,
        )
