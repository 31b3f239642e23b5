"""The film at one assumed temperature: clearance, load number, position, friction and flows of ISO 7902.

Everything the heat balance needs is a function of the effective temperature; `film_at` is that function.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.characteristics import BearingCurves, ClosedFormCurves, curves
from babbitt.fits import operating_relative_clearance
from babbitt.notices import InputError
from babbitt.results import Outcome
from babbitt.standards.iso7902.friction import friction_number
from babbitt.standards.iso7902.model import Curves, DesignCase, GivenEccentricity
from babbitt.standards.iso7902.supply_pressure import Feed, feed


class NoFilmError(Exception):
    """There is no film at this temperature.

    Attributes
    ----------
    outcome : Outcome
        Why: the clearance has closed, the load is too large, or the lubricant's laws do not reach there.
    capacity : float or None
        Largest load in N at the largest eccentricity of the characteristics, if the load is too large.
    """

    def __init__(self, outcome: Outcome, capacity: float | None = None) -> None:
        super().__init__(outcome.value)
        self.outcome = outcome
        self.capacity = capacity


@dataclass(frozen=True)
class Film:
    """State of the film at one effective temperature, SI.

    `feed` is None where no oil is supplied under pressure.
    """

    temperature: float
    relative_clearance: float
    density: float
    viscosity: float
    volumetric_heat_capacity: float
    load: float
    sommerfeld_number: float
    eccentricity_ratio: float
    friction_number: float
    friction_power: float
    side_flow_number: float
    side_flow: float
    feed: Feed | None

    @property
    def supply_flow(self) -> float:
        """Flow in m³/s that the supply pressure drives."""
        return self.feed.flow if self.feed else 0.0

    @property
    def total_flow(self) -> float:
        """Side flow and supply flow together, m³/s."""
        return self.side_flow + self.supply_flow


def curves_of(case: DesignCase) -> BearingCurves:
    """The characteristics the case asks for."""
    if case.curves is Curves.CLOSED_FORM:
        return ClosedFormCurves(case.bearing.width_ratio)
    return curves(case.bearing.span, case.bearing.width_ratio)


def load_scale(case: DesignCase, viscosity: float, relative_clearance: float) -> float:
    """Load at So = 1: ``B D η ω_h/ψ²`` in N, the definition of the Sommerfeld number of ISO 7902."""
    bearing = case.bearing
    return bearing.width * bearing.diameter * viscosity * hydrodynamic_speed(case) / relative_clearance**2


def hydrodynamic_speed(case: DesignCase) -> float:
    """Effective hydrodynamic speed ``ω_h = ω_J + ω_B`` in rad/s, whichever way it turns."""
    return abs(case.journal_speed + case.bearing_speed)


def surface_speed(case: DesignCase) -> float:
    """Surface speed of the journal in m/s."""
    return abs(case.journal_speed) * case.bearing.diameter / 2.0


def film_at(temperature: float, case: DesignCase, shape: BearingCurves) -> Film:
    """Film at an effective temperature in K.

    Parameters
    ----------
    temperature : float
        Effective temperature in K.
    case : DesignCase
    shape : BearingCurves
        Characteristics of the span and width ratio of the case.

    Raises
    ------
    NoFilmError
        When the relative clearance is not positive at this temperature, So exceeds the largest tabulated one, or
        a law of the lubricant has no usable value.
    """
    bearing, oil = case.bearing, case.lubricant
    psi = operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal, temperature
    )
    if psi <= 0.0:
        raise NoFilmError(Outcome.NO_CLEARANCE)
    try:
        density = oil.density(temperature)
        viscosity = oil.kinematic_viscosity(temperature) * density
        heat_capacity = oil.volumetric_heat_capacity(temperature)
    except InputError:
        raise NoFilmError(Outcome.NO_LUBRICANT_DATA) from None
    if min(density, viscosity, heat_capacity) <= 0.0:
        raise NoFilmError(Outcome.NO_LUBRICANT_DATA)
    scale = load_scale(case, viscosity, psi)
    if isinstance(case.duty, GivenEccentricity):
        eccentricity = case.duty.eccentricity_ratio
        so = shape.sommerfeld_number(eccentricity)
        load = so * scale
    else:
        load = case.duty.load
        so = load / scale
        if so > shape.largest_sommerfeld_number:
            raise NoFilmError(Outcome.OVERLOADED, scale * shape.largest_sommerfeld_number)
        eccentricity = shape.eccentricity_ratio(so)
    number = case.friction_factor * friction_number(case.friction, shape, eccentricity, so)
    flow_scale = bearing.diameter**3 * psi * hydrodynamic_speed(case)
    side_flow_number = shape.side_flow_number(eccentricity)
    side_flow = side_flow_number * flow_scale
    return Film(
        temperature=temperature,
        relative_clearance=psi,
        density=density,
        viscosity=viscosity,
        volumetric_heat_capacity=heat_capacity,
        load=load,
        sommerfeld_number=so,
        eccentricity_ratio=eccentricity,
        friction_number=number,
        friction_power=number * psi * load * surface_speed(case),
        side_flow_number=side_flow_number,
        side_flow=side_flow,
        feed=feed(case, eccentricity, psi, viscosity, side_flow),
    )


def minimum_film_thickness(eccentricity_ratio: float, relative_clearance: float, diameter: float) -> float:
    """``h_min = ψ D (1 - ε)/2`` in m."""
    return relative_clearance * diameter * (1.0 - eccentricity_ratio) / 2.0


def film_reynolds_number(film: Film, case: DesignCase) -> float:
    """``Re = ρ U c/η`` with the radial clearance."""
    radial_clearance = film.relative_clearance * case.bearing.diameter / 2.0
    return film.density * surface_speed(case) * radial_clearance / film.viscosity


def critical_reynolds_number(relative_clearance: float) -> float:
    """Reynolds number up to which the film is laminar: ``41.3 sqrt(D/C)`` (Taylor, as in ISO 7902).

    >>> round(critical_reynolds_number(1.4705e-3))
    1077
    """
    return 41.3 / math.sqrt(relative_clearance)
