"""The film at one assumed temperature: clearance, load number, position, friction and flows of ISO 7902.

Everything the heat balance needs is a function of the effective temperature; `film_at` is that function.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

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
    """State of the film at one effective temperature, SI.

    `feed` is None where no oil is supplied under pressure, `supply_capacity` where nothing tells what the supply
    can deliver. `feed_at_place` is the feed of elements at the ends of an arc where they stand, else `feed`.
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
    supply_capacity: float | None
    feed_at_place: Feed | None

    @property
    def supply_flow(self) -> float:
        """Flow in m³/s that the supply pressure drives."""
        return self.feed.flow if self.feed else 0.0

    @property
    def total_flow(self) -> float:
        """Side flow and supply flow together, m³/s."""
        return self.side_flow + self.supply_flow

    @property
    def supply_flow_at_place(self) -> float:
        """Flow in m³/s that the supply pressure drives through the elements where they stand."""
        return self.feed_at_place.flow if self.feed_at_place else 0.0

    @property
    def stands_closer(self) -> bool:
        """Whether elements closer to the load than the formula has them give less."""
        return self.supply_flow_at_place < self.supply_flow


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
    return _film(temperature, case, shape)


def starved_film_at(temperature: float, case: DesignCase, shape: BearingCurves) -> Film:
    """Film at an effective temperature in K whose flow is limited to what its supply delivers.

    Its position and its friction are those of the full film: starvation hurts by the heat. Parameters and errors
    as of `film_at`.
    """
    return _film(temperature, case, shape, limited=True)


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


def _film(temperature: float, case: DesignCase, shape: BearingCurves, limited: bool = False) -> Film:
    """Film at a temperature, with all the oil that it wants or limited to what its supply delivers."""
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
    attitude = shape.attitude_angle(eccentricity)
    lever = case.friction_factor * psi * load * bearing.diameter / 2.0
    shear, pressure = friction_numbers(case.friction, shape, eccentricity, so, attitude)
    torque, power = friction_between(case, lever * shear, lever * pressure)
    flow_scale = bearing.diameter**3 * psi * hydrodynamic_speed(case)
    side_flow_number = shape.side_flow_number(eccentricity)
    side_flow = bearing.parts * side_flow_number * flow_scale
    sheared = sheared_flow(case, eccentricity, attitude, psi, side_flow)
    if limited and sheared is not None:
        side_flow = smaller(side_flow, sheared)
    fed_with = partial(feed, case, eccentricity, psi, viscosity)
    share = part_of_supply_flow(case, eccentricity, attitude)
    at_place = fed_with(side_flow, share)
    fed = at_place if limited or share == 1.0 else fed_with(side_flow)
    if limited and fed is not None and fed.limit is not None:
        side_flow = fed.limit  # tubes and holes pass no more; nothing is left to press oil through the element
    return Film(
        temperature=temperature,
        relative_clearance=psi,
        density=density,
        viscosity=viscosity,
        volumetric_heat_capacity=heat_capacity,
        load=load,
        sommerfeld_number=so,
        eccentricity_ratio=eccentricity,
        friction_number=torque / (psi * load * bearing.diameter / 2.0),
        friction_power=power,
        side_flow_number=side_flow_number,
        side_flow=side_flow,
        feed=fed,
        supply_capacity=_capacity(at_place, sheared, lambda flow: fed_with(flow, share)),
        feed_at_place=at_place,
    )


def _capacity(fed: Feed | None, sheared: float | None, fed_at: Callable[[float], Feed | None]) -> float | None:
    """What the supply can deliver in m³/s: by pressure and shear, and no more than tubes and holes pass."""
    if fed is None:
        return None
    if fed.limit is None:
        return None if sheared is None else fed.flow + sheared
    less = None if sheared is None else fed_at(sheared)  # with less flow some pressure may be left at the element
    return fed.limit if sheared is None or less is None or less.limit is not None else less.flow + sheared
