"""A hydrostatic bearing and its operation, in SI: what the calculation gets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError, Notice
from babbitt.kinds.hydrostatic.geometry import (
    AnnularPad,
    CircularPad,
    PadShape,
    RecessedJournal,
    RectangularPad,
    ThrustRing,
    positive,
)
from babbitt.kinds.hydrostatic.impedance import Compressibility
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.properties.lubricants import Lubricant

__all__ = ["OperatingConditions", "HydrostaticCase", "Oil", "Recesses", "Shape", "beyond_data"]

Shape = PadShape | ThrustRing | RecessedJournal
"""All shapes."""


@dataclass(frozen=True)
class Oil:
    """The oil in the film.

    Attributes
    ----------
    viscosity : float
        Pa s.
    density : float
        kg/m3.
    heat_capacity : float
        J/(kg K).
    lubricant : Lubricant or None
        With it the viscosity is sought at the supply temperature and the rise of the film, unless that is given.
    supply_temperature : float or None
        K.
    temperature : float or None
        K, at which the viscosity holds; None where nothing says it.
    film_temperature : float or None
        K, that of the film where the case gives it; None: found by the heat balance.
    """

    viscosity: float
    density: float
    heat_capacity: float
    lubricant: Lubricant | None = None
    supply_temperature: float | None = None
    temperature: float | None = None
    film_temperature: float | None = None

    @property
    def is_warmed(self) -> bool:
        """Whether the heat balance finds its temperature."""
        known = self.lubricant is not None and self.supply_temperature is not None
        return known and self.film_temperature is None

    def __post_init__(self) -> None:
        positive(viscosity=self.viscosity, density=self.density, heat_capacity=self.heat_capacity)

    def at(self, temperature: float) -> Oil:
        """The same oil at a temperature in K."""
        if self.lubricant is None:
            return self
        oil = self.lubricant
        density = float(oil.density(temperature))
        heat = float(oil.volumetric_heat_capacity(temperature)) / density
        return replace(
            self,
            viscosity=float(oil.dynamic_viscosity(temperature)),
            density=density,
            heat_capacity=heat,
            temperature=temperature,
        )


def beyond_data(lubricant: Lubricant, temperature: float, place: str) -> Iterator[Notice]:
    """Warning about a lubricant that is used outside the temperatures for which its numbers are meant.

    Parameters
    ----------
    lubricant : Lubricant
    temperature : float
        K.
    place : str
        What has that temperature: ``film`` or ``supply``.
    """
    if not lubricant.covers(temperature):
        low, high = lubricant.temperature_range
        yield Notice("W326", place, {
            "temperature": temperature, "lubricant": lubricant.name, "low": low, "high": high,
        })  # fmt: skip


@dataclass(frozen=True)
class OperatingConditions:
    """What the bearing carries, or where it stands; SI.

    Attributes
    ----------
    load : float or None
        N. None: the position is given.
    load_angle : float
        Direction of a journal's load, rad from +x.
    moments : tuple of float
        About x and y, on a thrust ring, N m.
    gap : float
        Of a pad or ring under a given position, and where the search begins, m.
    tilt : tuple of float
        About x and y, rad.
    position : tuple of float
        x and y of a journal, m.
    angular_speed : float
        rad/s.
    sliding_speed : float
        Of a rectangular pad, m/s.
    """

    load: float | None = None
    load_angle: float = 0.0
    moments: tuple[float, float] = (0.0, 0.0)
    gap: float = 0.0
    tilt: tuple[float, float] = (0.0, 0.0)
    position: tuple[float, float] = (0.0, 0.0)
    angular_speed: float = 0.0
    sliding_speed: float = 0.0


@dataclass(frozen=True)
class Recesses:
    """Depth of the recesses, m, and how the oil in them rubs.

    ``friction_factor`` is the wall shear over mu U/depth: 1 where the oil turns with the runner, 4 in closed
    recesses with laminar recirculation.
    """

    depth: float
    friction_factor: float = 4.0

    def __post_init__(self) -> None:
        positive(recess_depth=self.depth)
        if not 1.0 <= self.friction_factor <= 8.0:
            raise InputError("E101", f"friction_factor is {self.friction_factor}; it must lie between 1 and 8.")


@dataclass(frozen=True)
class HydrostaticCase:
    """One bearing at one operating point.

    Attributes
    ----------
    name, kind : str
    method : str
        ``quick`` or ``film``.
    shape : Shape
    feeding : Feeding
    oil : Oil
    duty : OperatingConditions
    recesses : Recesses
    compressibility : Compressibility
    frequencies : tuple of float
        At which stiffness and damping are wanted, rad/s.
    pump_efficiency : float
    least_gap : float or None
        The user's limit, m.
    highest_supply_pressure : float or None
        What the pump can hold, Pa.
    cavitation_pressure : float
        Gauge, Pa.
    accuracy : str
        ``draft``, ``engineering`` or ``reference``.
    given, assumptions, warnings : tuple
        For the report.
    rotor_mass, shaft_stiffness : float or None
        Part of the rotor that a journal bearing carries, kg, and its shaft, N/m; None is the mass whose weight is
        the load, and a rigid shaft.
    """

    name: str
    kind: str
    method: str
    shape: Shape
    feeding: Feeding
    oil: Oil
    duty: OperatingConditions
    recesses: Recesses
    compressibility: Compressibility
    frequencies: tuple[float, ...] = ()
    pump_efficiency: float = 0.8
    least_gap: float | None = None
    highest_supply_pressure: float | None = None
    cavitation_pressure: float = 0.0
    accuracy: str = "engineering"
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    rotor_mass: float | None = None
    shaft_stiffness: float | None = None

    @property
    def count(self) -> int:
        """Number of recesses."""
        return len(self.feeding.restrictors)

    @property
    def is_journal(self) -> bool:
        """Whether the bearing carries across the shaft."""
        return isinstance(self.shape, RecessedJournal)

    @property
    def rest_gap(self) -> float:
        """Gap of the centred journal, or where the search of a pad's gap begins, m."""
        return self.shape.clearance if isinstance(self.shape, RecessedJournal) else self.duty.gap or 3e-5

    @property
    def recess_area(self) -> float:
        """Of one recess, m2."""
        return self.shape.recess_area

    @property
    def reach(self) -> float:
        """Radius on which speed and tilt are counted, m."""
        shape = self.shape
        if isinstance(shape, RecessedJournal):
            return shape.radius
        if isinstance(shape, CircularPad | AnnularPad):
            return shape.outer_radius
        if isinstance(shape, RectangularPad):
            return 0.5 * shape.length
        return shape.radii.outer_radius

    @property
    def surface_speed(self) -> float:
        """m/s, the greatest."""
        return (
            abs(self.duty.angular_speed) * self.reach if not self.duty.sliding_speed else self.duty.sliding_speed
        )

    @property
    def recess_speed(self) -> float:
        """m/s, the greatest over a recess: that at the outer edge of recesses in round pads and rings."""
        shape = self.shape
        if isinstance(shape, CircularPad):
            edge = shape.recess_radius
        elif isinstance(shape, AnnularPad):
            edge = shape.recess_outer_radius
        elif isinstance(shape, ThrustRing):
            edge = shape.radii.recess_outer_radius
        else:
            return self.surface_speed
        return self.surface_speed * edge / self.reach
