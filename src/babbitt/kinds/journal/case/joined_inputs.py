"""What a bearing brings to a calculation by any method, joined with what it shares with its machine."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import is_given
from babbitt.case.parts.cooling import Cooling
from babbitt.case.parts.load_and_speed import LOADS, SPEEDS
from babbitt.case.parts.materials import Materials
from babbitt.case.parts.shared import merged
from babbitt.case.parts.supply import Supply
from babbitt.core.notices import Notice
from babbitt.core.result_name import ResultName
from babbitt.design.conditions import (
    HousingCooling,
    LoadSpec,
    OilSupply,
    PrescribedEccentricity,
    PrescribedLoad,
    PrescribedPosition,
)
from babbitt.design.cooling import STILL_AIR_COEFFICIENT, heat_transfer_coefficient
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.machine import SeveralBearings, SingleBearing
from babbitt.kinds.journal.case.mean_clearance import warnings_about_mean_clearance
from babbitt.kinds.journal.case.oil_system import OilSystemInput
from babbitt.kinds.journal.case.operating_point import OperatingPoint, stating
from babbitt.kinds.journal.case.turned_supply import warnings_about_turned_supply
from babbitt.properties.lubricants import Lubricant


@dataclass(frozen=True)
class Inputs:
    """A bearing with what it shares with its machine.

    `turned_supply` questions supply elements that turn with the load from one operating point to another,
    `of_clearance` limits of the clearance at which nothing is solved.
    """

    bearing: JournalBearing
    lubricant: Lubricant
    supply: Supply | None
    cooling: Cooling | None
    materials: Materials
    width: float
    shared_assumptions: tuple[str, ...]
    shared_warnings: tuple[Notice, ...]
    turned_supply: tuple[Notice, ...]
    of_clearance: tuple[Notice, ...]


@dataclass(frozen=True)
class Point:
    """Where a bearing is computed: operating point (None: the bearing as such), clearance case, relative
    clearance.

    `clearance`, `tolerance` and `mean` hold at 20 °C; `clearance_case` is ``minimum``, ``mean`` or ``maximum``.
    """

    name: ResultName
    given: OperatingPoint | None
    clearance_case: str
    clearance: float
    tolerance: tuple[float, float] | None
    mean: float


def inputs(bearing: JournalBearing, shared: SingleBearing | SeveralBearings) -> Inputs:
    """Join a bearing with what it shares."""
    lubricant = bearing.lubricant or shared.lubricant
    width = bearing.actual_width
    if lubricant is None or width is None:
        raise ValueError("a case that was not validated: the bearing has no lubricant or no width")
    supply = merged(bearing.supply, shared.supply)
    if (system := _oil_system(shared)) is not None:
        supply = system.supply_of(bearing.name, supply)
    return Inputs(
        bearing,
        lubricant.lubricant(),
        supply,
        merged(bearing.cooling, shared.cooling),
        merged(bearing.materials, shared.materials) or Materials(),
        width,
        shared.assumptions if isinstance(shared, SeveralBearings) else (),
        tuple(about_grouped_digits(shared.model_copy(update={"bearings": ()})))
        if isinstance(shared, SeveralBearings)
        else (),
        tuple(warnings_about_turned_supply(bearing, width)),
        ()
        if every_clearance(bearing, shared) or system is not None
        else tuple(warnings_about_mean_clearance(bearing, asks_for_clearances(bearing, shared))),
    )


def _oil_system(shared: SingleBearing | SeveralBearings) -> OilSystemInput | None:
    """What feeds the bearing and is balanced at the limits of clearances, too."""
    return shared.oil_system if isinstance(shared, SeveralBearings) else None


def every_clearance(bearing: JournalBearing, shared: SingleBearing | SeveralBearings) -> bool:
    """Whether a bearing is solved at the limits of its clearance, too."""
    return (bearing.clearance_cases or shared.clearance_cases) == "all"


def asks_for_clearances(bearing: JournalBearing, shared: SingleBearing | SeveralBearings) -> bool:
    """Whether the case itself says at which clearances a bearing is solved."""
    return bearing.clearance_cases is not None or is_given(shared, "clearance_cases")


def expansions(inputs: Inputs) -> tuple[float, float]:
    """Thermal expansion of bearing and journal, 1/K; alike where no material is given.

    At a prescribed temperature, where the clearance is then taken as it is.
    """
    bearing, journal = inputs.materials.bearing, inputs.materials.journal
    if bearing is None and journal is None and inputs.bearing.effective_temperature is not None:
        return 0.0, 0.0
    if bearing is None or journal is None:
        raise ValueError("a case that was not validated: the bearing has no materials")
    return bearing.expansion(), journal.expansion()


def duty(inputs: Inputs, point: OperatingPoint | None) -> LoadSpec:
    """What the bearing carries: the load, or the prescribed position."""
    bearing = inputs.bearing
    given = stating(LOADS, bearing, point)
    if given.eccentricity_ratio is not None:
        return PrescribedEccentricity(given.eccentricity_ratio, given.attitude_angle)
    if given.position is not None:
        return PrescribedPosition(given.position.x, given.position.y)
    if given.load is not None:
        return PrescribedLoad(given.load)
    if given.specific_load is None:
        raise ValueError("a case that was not validated: the bearing has no load")
    return PrescribedLoad(given.specific_load * inputs.width * bearing.diameter)


def clearance_limits(inputs: Inputs, at: Point) -> tuple[float, float] | None:
    """Limits of the clearance at which what keeps its limits at the mean is solved, too.

    None where they are cases of the bearing, and where the mean is questioned for them.
    """
    questioned = any(one.code == "W174" for one in inputs.of_clearance)
    return None if at.name.clearance or questioned else at.tolerance


def journal_speed(bearing: JournalBearing, point: OperatingPoint | None) -> float:
    """Speed of the journal in rad/s."""
    given = stating(SPEEDS, bearing, point)
    if given.speed is not None:
        return given.speed
    if given.surface_speed is None:
        raise ValueError("a case that was not validated: the bearing has no speed")
    return 2.0 * given.surface_speed / bearing.diameter


def oil_supply(inputs: Inputs, point: OperatingPoint | None) -> OilSupply | None:
    """Oil supply with what the operating point changes; None where no oil is fed.

    Where every groove, pocket and hole has a pressure or flow of its own, that of the supply counts as zero.
    """
    supply = inputs.supply
    if supply is None:
        return None
    temperature, pressure, flow = supply.temperature, supply.pressure, supply.flow
    if point is not None:
        temperature = point.supply_temperature or temperature
        if point.supply_pressure is not None or point.supply_flow is not None:
            pressure, flow = point.supply_pressure, point.supply_flow
    if temperature is None or (pressure is None and flow is None and not inputs.bearing.feeds_itself()):
        raise ValueError(
            "a case that was not validated: the supply has no temperature, or no pressure and no flow"
        )
    return OilSupply(
        temperature,
        0.0 if pressure is None else pressure,
        tuple(tube.duct() for tube in supply.tubes),
        tuple(hole.duct() for hole in supply.holes),
        supply.circulation_time,
        flow if pressure is None else None,
    )


def housing_cooling(inputs: Inputs) -> HousingCooling | None:
    """Cooling by the surroundings; None where there is none."""
    cooling = inputs.cooling
    if cooling is None:
        return None
    coefficient, surface = cooling.heat_transfer_coefficient, cooling.surface
    if coefficient is None:
        still = cooling.air_speed is None
        coefficient = STILL_AIR_COEFFICIENT if still else heat_transfer_coefficient(cooling.air_speed or 0.0)
    if surface is None and cooling.housing is not None:
        surface = cooling.housing.surface(inputs.bearing.diameter, inputs.width)
    if surface is None or cooling.ambient_temperature is None:
        raise ValueError("a case that was not validated: the cooling has no surface or no ambient temperature")
    return HousingCooling(cooling.ambient_temperature, coefficient, surface)
