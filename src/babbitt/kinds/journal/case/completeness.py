"""Whether a bearing, together with what its machine shares, has all that the calculation needs."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.case.error_messages import Path
from babbitt.case.part import Issue
from babbitt.case.parts.materials import Materials
from babbitt.case.parts.shared import SharedInputs, merged
from babbitt.case.parts.supply import Supply
from babbitt.core.units import written
from babbitt.kinds.journal.case import mixed_friction, one_dimension
from babbitt.kinds.journal.case.film_heat import OWN_TEMPERATURES
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.properties.lubricants import Lubricant

SUPPLY_OF_A_POINT = ("supply_temperature", "supply_pressure", "supply_flow")

WHERE = "at the bearing or for the whole machine"


def issues_of(bearing: JournalBearing, machine: SharedInputs | None, *path: str | int) -> Iterator[Issue]:
    """Complain about what a bearing lacks, and about temperatures above what its oil and metal stand.

    Parameters
    ----------
    bearing : JournalBearing
    machine : SharedInputs or None
        What its machine shares; None for a bearing on its own.
    *path : str or int
        From the machine to the bearing.
    """
    yield from _missing(bearing, machine, path)
    yield from _clearance_limits(bearing, machine, path)
    yield from _too_hot(bearing, machine, path)
    if bearing.mixed_friction is not None and bearing.method == "film":
        materials = merged(bearing.materials, machine.materials if machine is not None else None)
        yield from mixed_friction.issues_of(bearing.mixed_friction, bearing.surfaces, materials, path)


def _missing(bearing: JournalBearing, machine: SharedInputs | None, path: Path) -> Iterator[Issue]:
    where = f"; {WHERE}" if machine is not None else ""

    def lacks(field: str, part: str, wanted: str) -> Issue:
        shared = machine is not None and getattr(bearing, part) is None
        at = (part, field) if field else (part,)
        return Issue((*(() if shared else path), *at), "is missing", f"{wanted}{where}", code="E003")

    shared = machine or bearing
    if (bearing.lubricant or shared.lubricant) is None:
        yield lacks("", "lubricant", "a name of the catalogue, such as 'ISO VG 46', or own data")
    supply = merged(bearing.supply, shared.supply)
    cooling = merged(bearing.cooling, shared.cooling)
    materials = merged(bearing.materials, shared.materials)
    if bearing.method in one_dimension.METHODS:
        if supply is None:
            yield lacks("", "supply", "oil temperature at the inlet, such as {temperature: 50 degC}")
        elif supply.temperature is None and not _all_give(bearing.operating_points, "supply_temperature"):
            yield lacks("temperature", "supply", "oil temperature at the inlet such as '50 degC'")
        return
    if supply is None and cooling is None and bearing.effective_temperature is None:
        yield lacks(
            "",
            "supply",
            "supply (oil carries the heat away), cooling (the housing does), or effective_temperature",
        )
    if supply is None and bearing.method == "film" and bearing.thermal in OWN_TEMPERATURES:
        yield lacks("", "supply", f"supply: a film with thermal: {bearing.thermal} needs the oil that enters")
    yield from _points_change_a_supply(bearing, supply, path)
    if supply is not None:
        points = bearing.operating_points
        if supply.temperature is None and not _all_give(points, "supply_temperature"):
            yield lacks("temperature", "supply", "oil temperature at the inlet such as '50 degC'")
        if (
            supply.pressure is None
            and supply.flow is None
            and not _all_give(points, "supply_pressure", "supply_flow")
            and not bearing.feeds_itself()
            and getattr(machine, "oil_system", None) is None
        ):
            yield lacks("pressure", "supply", "gauge pressure such as '0.2 MPa', or flow for the film method")
        own = bearing.supply is not None and bearing.supply.flow is not None
        yield from _flow_goes_somewhere(bearing, supply, path if own else ())
    if cooling is not None:
        if cooling.ambient_temperature is None:
            yield lacks("ambient_temperature", "cooling", "temperature of the air such as '20 degC'")
        if cooling.surface is None and cooling.housing is None:
            yield lacks("surface", "cooling", "surface such as '0.3 m2', or housing")
    if bearing.effective_temperature is not None and (
        materials is None or (materials.bearing is None and materials.journal is None)
    ):
        return
    if materials is None:
        yield lacks("", "materials", f"a mapping such as {Materials.example}")
        return
    for part in ("bearing", "journal"):
        if getattr(materials, part) is None:
            yield lacks(part, "materials", "a name of the catalogue, or {thermal_expansion: 11e-6 1/K}")


def _points_change_a_supply(bearing: JournalBearing, supply: Supply | None, path: Path) -> Iterator[Issue]:
    """Complain about operating points that change a supply which there is not."""
    if supply is not None:
        return
    for index, point in enumerate(bearing.operating_points):
        given = [name for name in SUPPLY_OF_A_POINT if getattr(point, name) is not None]
        if given:
            says = "an operating point changes the supply, and there is none: oil is not fed"
            allowed = "supply in addition, `supply: {}` where every operating point gives temperature and pressure"
            yield Issue((*path, "operating_points", index, given[0]), says, allowed)


def _all_give(points: tuple[object, ...], *names: str) -> bool:
    return bool(points) and all(any(getattr(point, name) is not None for name in names) for point in points)


def _flow_goes_somewhere(bearing: JournalBearing, supply: Supply, path: Path) -> Iterator[Issue]:
    """Complain about a supply flow that the method does not know, or that no groove, pocket or hole takes."""
    at: Path = (*path, "supply", "flow")
    given = supply.flow is not None
    for index, point in enumerate(bearing.operating_points):
        if point.supply_flow is not None:
            given, at = True, ("operating_points", index, "supply_flow")
    if not given:
        return
    if bearing.method == "film" and bearing.thermal in OWN_TEMPERATURES:
        says = "a film with its own temperatures is fed by pressure"
        yield Issue(at, says, "supply.pressure, or thermal: global")
    elif bearing.method != "film":
        yield Issue(at, "ISO 7902 takes a supply pressure, not a flow", "method: film, or supply.pressure")
    elif bearing.cavitation != "mass_conserving" or bearing.film_start == "widest_gap":
        says = "a supply flow needs a film that conserves the oil and is fed somewhere"
        yield Issue(at, says, "cavitation: mass_conserving and film_start: groove")
    elif bearing.dynamic_load is not None:
        says = "the orbit under a changing load does not count the oil that a supply of given flow delivers"
        yield Issue(at, says, "supply.pressure")
    elif bearing.mixed_friction is not None:
        yield Issue(at, "the mixed branch knows supplies of given pressure only", "supply.pressure")
    elif bearing.feeds_itself():
        says = "every groove, pocket and hole has a pressure or flow of its own: no one takes this flow"
        yield Issue(at, says, "a groove, pocket or hole without pressure and flow")


def _clearance_limits(bearing: JournalBearing, machine: SharedInputs | None, path: Path) -> Iterator[Issue]:
    cases = bearing.clearance_cases or getattr(machine, "clearance_cases", "mean")
    if cases == "all" and not bearing.clearance.has_limits:
        says = "clearance_cases: all needs the limits of the clearance"
        yield Issue((*path, "clearance"), says, "minimum and maximum in addition to mean", code="E003")


def _too_hot(bearing: JournalBearing, machine: SharedInputs | None, path: Path) -> Iterator[Issue]:
    shared = machine or bearing
    supply = merged(bearing.supply, shared.supply)
    cooling = merged(bearing.cooling, shared.cooling)
    temperatures: list[tuple[Path, str, float | None]] = []
    if supply is not None:
        own = bearing.supply is not None and bearing.supply.temperature is not None
        at: Path = (*(path if own else ()), "supply", "temperature")
        temperatures.append((at, "the supply", supply.temperature))
    if cooling is not None:
        own = bearing.cooling is not None and bearing.cooling.ambient_temperature is not None
        at = (*(path if own else ()), "cooling", "ambient_temperature")
        temperatures.append((at, "the air", cooling.ambient_temperature))
    for index, point in enumerate(bearing.operating_points):
        at = (*path, "operating_points", index, "supply_temperature")
        temperatures.append((at, "the supply", point.supply_temperature))
    limit, of_what = _lowest_limit(bearing, shared)
    for at, what, temperature in temperatures:
        if temperature is not None and temperature >= limit:
            says = (
                f"{what}, {written(temperature, 'degC')}, is not cooler than {of_what}, {written(limit, 'degC')}"
            )
            yield Issue(at, says, f"less than {written(limit, 'degC')}")


def _lowest_limit(bearing: JournalBearing, shared: SharedInputs) -> tuple[float, str]:
    """Give the lowest temperature limit in K that is known, and whose it is."""
    limits: list[tuple[float, str]] = [(float("inf"), "")]
    if bearing.limits.temperature is not None:
        limits.append((bearing.limits.temperature, "limits.temperature"))
    materials = merged(bearing.materials, shared.materials)
    metal = materials.metal() if materials is not None else None
    if metal is not None and metal.limiting_temperature is not None:
        limits.append((metal.limiting_temperature.value, f"the limit of {metal.name}"))
    oil = bearing.lubricant or shared.lubricant
    if oil is not None:
        made: Lubricant = oil.lubricant()
        limits.append((made.temperature_range[1], f"the end of the data of {made.name}"))
    return min(limits)
