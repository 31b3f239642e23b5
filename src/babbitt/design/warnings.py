"""Warnings that do not depend on the method: where the result leaves the ground on which it stands."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.conditions import CheckedProblem, OilSupply, surface_speed
from babbitt.design.screening import ROTORDYNAMIC_CHECK_ABOVE
from babbitt.properties.lubricants import Lubricant

RIGID_FILM_UP_TO = 0.95
"""Eccentricity ratio above which the rigid isoviscous film is too simple."""

PLAIN_BEARING_UP_TO = 100e6
"""Film pressure in Pa above which a rigid film of constant viscosity says little of a plain bearing.

Assumption: a white metal of Brinell hardness 30, the hardest in the catalogue, yields at about a third of it
(D. Tabor, The Hardness of Metals, 1951: a hardness is some three times the yield strength)."""


def warnings_about_pressure(pressure: float, where: str = "film") -> Iterator[Notice]:
    """Whether a film pressure in Pa is one that plain bearings know; `where` is the variant of the message."""
    if pressure > PLAIN_BEARING_UP_TO:
        yield Notice("W142", where, {"maximum_pressure": pressure, "limit": PLAIN_BEARING_UP_TO})


LARGEST_RISE = 100.0
"""Heating of the oil in K beyond which no model of a plain bearing holds (an assumption)."""

SETTLED, OPEN_HEAT = 1e-6, 1e-3
"""Share of the heat that is not accounted for: from which journal bearings report it, and from which no kind
of bearing has a verdict."""

BESIDE_THE_END = 0.05
"""K by which a temperature may pass the end of the data: it is shown with one decimal."""

USUAL_CLEARANCES = (0.3e-3, 5e-3)
"""Clearance over diameter of plain bearings (an assumption)."""

PLAIN_CLEARANCES = (0.1e-3, 10e-3)
"""Clearance over diameter outside which nothing is known of plain bearings (an assumption)."""

HOTTEST_OIL = ("maximum_temperature", "outlet_temperature", "effective_temperature", "bearing_temperature")
"""Temperatures of a result in which the oil is not hotter than the hottest of them."""


def warnings_about_heating(hottest: float, supplied: float | None, lubricant: Lubricant) -> Iterator[Notice]:
    """Oil that is heated beyond sense, or above the temperatures of its data.

    Parameters
    ----------
    hottest : float
        The hottest oil known, in K.
    supplied : float or None
        Temperature of the oil that enters, in K; None where none is fed.
    lubricant : Lubricant
    """
    if supplied is not None and hottest - supplied > LARGEST_RISE:
        yield Notice("W127", "oil", {"hottest": hottest, "rise": hottest - supplied, "limit": LARGEST_RISE})
    end = lubricant.temperature_range[1]
    if hottest > end + BESIDE_THE_END:
        yield Notice("W128", values={"hottest": hottest, "end": end, "lubricant": lubricant.name})


def warnings_about_heat_balance(error: float) -> Iterator[Notice]:
    """Whether the heat balance closes, by its error over the friction power."""
    if not abs(error) < OPEN_HEAT:
        yield Notice("W325", values={"energy_balance_error": abs(error)})
    elif abs(error) > SETTLED:
        yield Notice("W146", values={"energy_balance_error": abs(error)})


def _warnings_about_thin_film(case: CheckedProblem, film: float) -> Iterator[Notice]:
    surfaces = case.bearing.surfaces
    if surfaces is not None and film < (rough := surfaces.roughness_bearing + surfaces.roughness_journal):
        yield Notice("W129", "surfaces", {"minimum_film_thickness": film, "roughness": rough})


def _warnings_about_clearance(clearances: tuple[float, ...]) -> Iterator[Notice]:
    least, most = USUAL_CLEARANCES
    outside = [one for one in clearances if not least <= one <= most]
    thin, wide = PLAIN_CLEARANCES
    if beyond := [one for one in outside if not thin <= one <= wide]:
        yield Notice("W193", values={"relative_clearance": beyond[0], "least": thin, "most": wide})
    elif outside:
        yield Notice("W130", values={"relative_clearance": outside[0], "least": least, "most": most})


def warnings_about_film(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Notice]:
    """Laminar film, range of the lubricant data, rigid surfaces."""
    reynolds, critical = values["film_reynolds_number"], values["critical_reynolds_number"]
    if reynolds > critical:
        yield Notice("W101", "mean", {"film_reynolds_number": reynolds, "critical_reynolds_number": critical})
    coldest, hottest = case.lubricant.temperature_range
    temperature = values["effective_temperature"]
    if temperature < coldest:
        yield Notice("W107", "mean", {
            "effective_temperature": temperature, "coldest": coldest, "hottest": hottest,
            "lubricant": case.lubricant.name,
        })  # fmt: skip
    supplied = None if case.oil_supply is None else case.oil_supply.temperature
    reached = max(values[name] for name in HOTTEST_OIL if name in values)
    yield from warnings_about_heating(reached, supplied, case.lubricant)
    yield from _warnings_about_cold_oil(case, values)
    yield from _warnings_about_clearance((values["relative_clearance"], values["operating_relative_clearance"]))
    yield from _warnings_about_thin_film(case, values["minimum_film_thickness"])
    clearance = 0.5 * values["operating_relative_clearance"] * case.bearing.diameter
    depth = 1.0 - values["minimum_film_thickness"] / clearance
    if depth > RIGID_FILM_UP_TO:
        known = "roughness_known" if case.bearing.surfaces is not None else "roughness_unknown"
        yield Notice("W116", known, {"depth": depth, "limit": RIGID_FILM_UP_TO})


def _warnings_about_cold_oil(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Notice]:
    """Oil that leaves colder than it enters, and a film prescribed colder than its oil."""
    if case.oil_supply is None:
        return
    entering, given = case.oil_supply.temperature, case.effective_temperature
    leaving = values.get("outlet_temperature", entering)
    if leaving < entering - 1e-6:
        yield Notice("W118", values={"outlet_temperature": leaving, "colder": entering - leaving})
    if given is not None and given < entering - 1e-6:
        yield Notice("W149", values={"effective_temperature": given, "supply_temperature": entering})


def warnings_about_supply(limit: float | None, wanted: float) -> Iterator[Notice]:
    """Whether tubes and holes pass what the film wants; m³/s, no limit where they do."""
    if limit is not None:
        yield Notice("W111", values={"supply_limit": limit, "wanted": wanted})


SHARE_OF_A_HOLE = 0.1
"""Loss in a supply hole over the supply pressure from which it is reported."""


def warnings_about_hole(supply: OilSupply, diameter: float, flow: float, density: float) -> Iterator[Notice]:
    """Whether a supply hole (m) costs a notable part of the supply pressure that nothing counts; m³/s, kg/m³.

    The loss is 1.5 velocity heads, entrance and exit, as of `supply.holes`.
    """
    if supply.holes or supply.pressure <= 0.0:
        return
    velocity = flow / (math.pi / 4.0 * diameter**2)
    loss = 1.5 * density * velocity**2 / 2.0
    if loss > SHARE_OF_A_HOLE * supply.pressure:
        yield Notice("W187", values={
            "velocity": velocity, "diameter": diameter, "loss": loss, "pressure": supply.pressure,
        })  # fmt: skip


def warnings_about_running(
    case: CheckedProblem, values: Mapping[str, float], checks: tuple[Check, ...]
) -> Iterator[Notice]:
    """Speed, heat that is not accounted for or has no pressure feed, and limits that no experience tells."""
    speed = surface_speed(case)
    if speed > ROTORDYNAMIC_CHECK_ABOVE:
        yield Notice("W109", values={"surface_speed": speed, "limit": ROTORDYNAMIC_CHECK_ABOVE})
    yield from warnings_about_heat_balance(values.get("energy_balance_error", 0.0))
    too_hot = any(check.code == "C104" and not check.ok for check in checks)
    balanced = case.cooling is not None and case.effective_temperature is None
    if case.oil_supply is None and balanced and too_hot:
        yield Notice("W110", values={"bearing_temperature": values["bearing_temperature"]})
    if "transition_film_thickness" in values and "transition_speed" not in values:
        yield Notice("W112", "no_speed")
    if case.limits.minimum_film_thickness is None and "empirical_film_limit" not in values:
        yield Notice("W115", values={"diameter": case.bearing.diameter})
