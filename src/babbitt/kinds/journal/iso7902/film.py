"""The film at one assumed temperature: clearance, load number, position, friction and flows of ISO 7902.

Everything the heat balance needs is a function of the effective temperature; `film_at` is that function.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedEccentricity
from babbitt.design.heat_balance import NoFilmError
from babbitt.design.oil import properties_at
from babbitt.design.values import friction_between, hydrodynamic_speed
from babbitt.kinds.journal.iso7902.characteristics import BearingCurves, ClosedFormCurves, curves
from babbitt.kinds.journal.iso7902.friction import friction_numbers
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
    gap_factor,
    share_at_place,
)
from babbitt.kinds.journal.iso7902.supply_pressure import Feed, feed
from babbitt.numerics.scalar_or_array import larger, smaller
from babbitt.properties.fits import operating_relative_clearance


@dataclass(frozen=True)
class Film:
    """State of the film at one effective temperature, SI; `feed` is None without a supply under pressure."""

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

    def feed_values(self) -> dict[str, float]:
        """Named results of what feeds it."""
        if self.feed is None:
            return {}
        values = {
            "supply_flow_number": self.feed.flow_number,
            "element_pressure": self.feed.element_pressure,
            "tube_loss": self.feed.tube_loss,
            "hole_loss": self.feed.hole_loss,
        }
        return values if self.feed.limit is None else values | {"supply_limit": self.feed.limit}


@dataclass(frozen=True)
class SuppliedFilm(Film):
    """A film with all the oil that it wants, and what its supply can deliver.

    `supply_capacity` is None where nothing tells that. `feed_at_place` is the feed of elements at the ends of an
    arc where they stand, else `feed`.
    """

    supply_capacity: float | None
    feed_at_place: Feed | None

    @property
    def supply_flow_at_place(self) -> float:
        """Flow in m³/s that the supply pressure drives through the elements where they stand."""
        return self.feed_at_place.flow if self.feed_at_place else 0.0

    @property
    def stands_closer(self) -> bool:
        """Whether elements closer to the load than the formula has them give less."""
        return self.supply_flow_at_place < self.supply_flow

    def feed_values(self) -> dict[str, float]:
        """Named results of what feeds it, and of what could."""
        values = Film.feed_values(self)
        if self.stands_closer:
            values["supply_flow_at_place"] = self.supply_flow_at_place
        if self.supply_capacity is not None:
            values["supply_capacity"] = self.supply_capacity
        return values


def curves_of(case: DesignCase) -> BearingCurves:
    """The characteristics the case asks for, of one half bearing where a groove parts it."""
    if case.curves is Curves.CLOSED_FORM:
        return ClosedFormCurves(case.bearing.part_width_ratio)
    return curves(case.bearing.span, case.bearing.part_width_ratio)


def load_scale(case: DesignCase, viscosity: float, relative_clearance: float) -> float:
    """Load at So = 1: ``B D η ω_h/ψ²`` in N, the definition of the Sommerfeld number of ISO 7902.

    Half bearings have the Sommerfeld number of all their width under all the load.
    """
    bearing = case.bearing
    return bearing.loaded_width * bearing.diameter * viscosity * hydrodynamic_speed(case) / relative_clearance**2


def film_at(temperature: float, case: DesignCase, shape: BearingCurves) -> Film:
    """Film at an effective temperature in K, with all the oil that it wants.

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
    return _film(temperature, case, shape, _wanted)


def starved_film_at(temperature: float, case: DesignCase, shape: BearingCurves) -> Film:
    """Film at an effective temperature in K whose flow is limited to what its supply delivers.

    Its position and its friction are those of the full film: starvation hurts by the heat. Parameters and errors
    as of `film_at`.
    """
    return _film(temperature, case, shape, _delivered)


def supplied_film(case: DesignCase, film: Film) -> SuppliedFilm:
    """The film with all the oil that it wants, and what its supply can deliver."""
    at = film.eccentricity_ratio
    attitude = curves_of(case).attitude_angle(at)
    sheared = sheared_flow(case, at, attitude, film.relative_clearance, film.side_flow)
    share = part_of_supply_flow(case, at, attitude)

    def fed_with(flow: float) -> Feed | None:
        return feed(case, at, film.relative_clearance, film.viscosity, flow, share)

    at_place = film.feed if share == 1.0 else fed_with(film.side_flow)
    capacity = _capacity(at_place, sheared, fed_with)
    return SuppliedFilm(**vars(film), supply_capacity=capacity, feed_at_place=at_place)


def sheared_flow(
    case: DesignCase, eccentricity_ratio: float, attitude_angle: float, relative_clearance: float, side_flow: float
) -> float | None:
    """Fresh oil that the journal shears into the loaded film from the supply element, m³/s.

    ``(U/2) (h_s - h_r) b`` with U of ``ω_h``, the gap h_s at the downstream edge of the element and the film h_r
    that comes back to a pocket (`returned_gap`). A hole is too small to stop what comes back: it passes beside it.
    None without an element. A groove around the whole circumference lies along the motion: nothing is sheared out.

    Parameters
    ----------
    case : DesignCase
    eccentricity_ratio, attitude_angle, relative_clearance : float
        Of the film; the angle in rad.
    side_flow : float
        That all the film would lose at its sides, m³/s.
    """
    element, bearing = case.bearing.supply_element, case.bearing
    if case.oil_supply is None or element is None:
        return None
    if isinstance(element, CircumferentialGroove):
        return 0.0
    if not isinstance(element, Holes | Pockets | HalfCircumferentialGroove):
        return None
    clearance = relative_clearance * bearing.diameter / 2.0
    gap = clearance * gap_factor(
        eccentricity_ratio, attitude_angle, element.edge_before_load(math.radians(bearing.span))
    )
    if isinstance(element, Pockets):
        gap -= returned_gap(case, eccentricity_ratio, attitude_angle, relative_clearance, side_flow)
    return half_surface_speed(case) * larger(gap, 0.0) * element.axial_width(bearing.width)


def half_surface_speed(case: DesignCase) -> float:
    """Mean speed of the oil between the surfaces, U/2 with U of ``ω_h``, m/s."""
    return hydrodynamic_speed(case) * case.bearing.diameter / 4.0


def start_of_film(span: float, attitude_angle: float) -> float:
    """Angle before the load at which pressure begins in the film of the standard, rad.

    At the edge of its arc, and never before the widest gap, from which the gap narrows.

    >>> round(math.degrees(start_of_film(math.radians(360.0), math.radians(50.0))))
    130
    """
    return smaller(math.pi - attitude_angle, 0.5 * span)


def part_of_supply_flow(case: DesignCase, eccentricity_ratio: float, attitude_angle: float) -> float:
    """Part of Q_p* that elements give where they stand: less than 1 at the ends of a short arc, in a thinner gap.

    The formula of the standard holds for elements at 90 deg to the load. Parameters as of `sheared_flow`.
    """
    element = case.bearing.supply_element
    if not isinstance(element, Holes | Pockets) or element.arrangement is not Arrangement.BOTH_SIDES:
        return 1.0
    places = element.places(math.radians(case.bearing.span))
    return share_at_place(eccentricity_ratio, attitude_angle, *places)


def returned_gap(
    case: DesignCase, eccentricity_ratio: float, attitude_angle: float, relative_clearance: float, side_flow: float
) -> float:
    """Thickness in m of the film that leaves the loaded arc and comes round to the supply, warm.

    ``h_r = h_0 - 2 Q_3/(U B)``: what enters the loaded film at its start, where the gap is h_0, less what it loses
    at its sides. Parameters as of `sheared_flow`.
    """
    bearing = case.bearing
    start = start_of_film(math.radians(bearing.span), attitude_angle)
    entering = relative_clearance * bearing.diameter / 2.0 * gap_factor(eccentricity_ratio, attitude_angle, start)
    return larger(entering - side_flow / (half_surface_speed(case) * bearing.width), 0.0)


Flows = Callable[[DesignCase, BearingCurves, float, float, float, float], tuple[float, Feed | None]]
"""Side flow in m³/s and feed of a film, by case, characteristics, eccentricity, clearance, viscosity and Q₃."""


def _film(temperature: float, case: DesignCase, shape: BearingCurves, flows: Flows) -> Film:
    """Film at a temperature, with the flows that are given it."""
    bearing, oil = case.bearing, case.lubricant
    psi = operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal, temperature
    )
    if psi <= 0.0:
        raise NoFilmError(Outcome.NO_CLEARANCE)
    density, viscosity, heat_capacity = properties_at(oil, temperature)
    scale = load_scale(case, viscosity, psi)
    if isinstance(case.duty, PrescribedEccentricity):
        eccentricity = case.duty.eccentricity_ratio
        so = shape.sommerfeld_number(eccentricity)
        load = so * scale
    else:
        load = case.duty.load
        so = load / scale
        if so > shape.largest_sommerfeld_number:
            raise NoFilmError(Outcome.OVERLOADED, scale * shape.largest_sommerfeld_number)
        eccentricity = shape.eccentricity_ratio(so)
    by_number = psi * load * bearing.diameter / 2.0
    lever = case.friction_factor * by_number
    shear, pressure = friction_numbers(case.friction, shape, eccentricity, so)
    torque, power = friction_between(case, lever * shear, lever * pressure)
    side_flow_number = shape.side_flow_number(eccentricity)
    wanted = bearing.parts * side_flow_number * bearing.diameter**3 * psi * hydrodynamic_speed(case)
    side_flow, fed = flows(case, shape, eccentricity, psi, viscosity, wanted)
    return Film(
        temperature, psi, density, viscosity, heat_capacity, load, so, eccentricity, torque / by_number, power,
        side_flow_number, side_flow, fed,
    )  # fmt: skip


def _wanted(
    case: DesignCase, shape: BearingCurves, eccentricity: float, psi: float, viscosity: float, side_flow: float
) -> tuple[float, Feed | None]:
    """All that the film wants; parameters as of `Flows`."""
    return side_flow, feed(case, eccentricity, psi, viscosity, side_flow)


def _delivered(
    case: DesignCase, shape: BearingCurves, eccentricity: float, psi: float, viscosity: float, side_flow: float
) -> tuple[float, Feed | None]:
    """No more than the supply delivers; parameters as of `Flows`."""
    attitude = shape.attitude_angle(eccentricity)
    sheared = sheared_flow(case, eccentricity, attitude, psi, side_flow)
    if sheared is not None:
        side_flow = smaller(side_flow, sheared)
    fed = feed(case, eccentricity, psi, viscosity, side_flow, part_of_supply_flow(case, eccentricity, attitude))
    if fed is not None and fed.limit is not None:
        return fed.limit, fed  # tubes and holes pass no more; nothing is left to press oil through the element
    return side_flow, fed


def _capacity(fed: Feed | None, sheared: float | None, fed_at: Callable[[float], Feed | None]) -> float | None:
    """What the supply can deliver in m³/s: by pressure and shear, and no more than tubes and holes pass."""
    if fed is None:
        return None
    if fed.limit is None:
        return None if sheared is None else fed.flow + sheared
    less = None if sheared is None else fed_at(sheared)  # with less flow some pressure may be left at the element
    return fed.limit if sheared is None or less is None or less.limit is not None else less.flow + sheared
