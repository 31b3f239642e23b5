"""Verdicts on an operating point that do not depend on the method: each with code, value, limit and source."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from babbitt.design.conditions import Designed, surface_speed
from babbitt.materials import (
    ExperienceLimit,
    SourcedValue,
    pressure_fed_temperature_limit,
    self_cooled_temperature_limit,
    specific_load_limit,
)
from babbitt.results import Bound, Check

USER = "limit set in the case"
AT_MOST, AT_LEAST = Bound.AT_MOST, Bound.AT_LEAST


def limit_checks(case: Designed, values: Mapping[str, float]) -> tuple[Check, ...]:
    """Checks of film thickness, load, temperature and metal that the data of the case allow.

    Parameters
    ----------
    case : Designed
    values : Mapping[str, float]
        Named results in SI, with the limits among them.
    """
    return (
        *film_checks(case, values),
        *load_and_temperature_checks(case, values),
        *metal_checks(case, values),
        *validity_checks(values),
    )


def temperature_limit(case: Designed) -> ExperienceLimit:
    """Temperature limit in K by experience, by the way the bearing is cooled."""
    if case.oil_supply is None:
        return self_cooled_temperature_limit()
    return pressure_fed_temperature_limit(case.oil_supply.circulation_time)


def limited_temperature(case: Designed) -> str:
    """Name of the temperature that the limit holds for."""
    if case.oil_supply is not None:
        return "outlet_temperature"
    return "bearing_temperature" if case.cooling is not None else "effective_temperature"


def film_checks(case: Designed, values: Mapping[str, float]) -> Iterator[Check]:
    """Film thickness against experience and against the surfaces."""
    film = values["minimum_film_thickness"]
    name = "minimum_film_thickness"
    if case.limits.minimum_film_thickness is not None:
        yield Check("C101", name, film, case.limits.minimum_film_thickness, AT_LEAST, USER)
    elif "empirical_film_limit" in values:
        source = "experience value for diameter and surface speed"
        yield Check("C101", name, film, values["empirical_film_limit"], AT_LEAST, source)
    if "geometric_film_limit" in values:
        source = "roughness, tilt, deflection and waviness of the case"
        yield Check("C102", name, film, values["geometric_film_limit"], AT_LEAST, source)


def load_and_temperature_checks(case: Designed, values: Mapping[str, float]) -> Iterator[Check]:
    """Specific load and temperature against experience, or against the limits of the case."""
    pressure, metal = values["specific_load"], case.bearing.metal
    if case.limits.specific_load is not None:
        yield Check("C103", "specific_load", pressure, case.limits.specific_load, AT_MOST, USER)
    elif metal is not None and (load_limit := specific_load_limit(metal.family)) is not None:
        slow = surface_speed(case) <= 1.0
        limit = load_limit.exceptional if slow else load_limit.general
        yield Check("C103", "specific_load", pressure, limit, AT_MOST, load_limit.source)
    name = limited_temperature(case)
    if case.limits.temperature is not None:
        yield Check("C104", name, values[name], case.limits.temperature, AT_MOST, USER)
    else:
        by_experience = temperature_limit(case)
        yield Check("C104", name, values[name], by_experience.general, AT_MOST, by_experience.source)


def metal_checks(case: Designed, values: Mapping[str, float]) -> Iterator[Check]:
    """Load, speed and temperature against the bearing metal."""
    metal = case.bearing.metal
    if metal is None:
        return
    limits = metal.limits(case.bearing.load_character)
    hottest = limited_temperature(case)

    def check(code: str, name: str, limit: SourcedValue | None, *, advisory: bool = False) -> Iterator[Check]:
        if limit is not None:
            yield Check(code, name, values[name], limit.value, AT_MOST, limit.source, advisory)

    yield from check("C105", "specific_load", limits.specific_load)
    yield from check("C106", "surface_speed", limits.sliding_speed)
    yield from check("C107", "pressure_speed_product", limits.pv)
    yield from check("C108", hottest, metal.limiting_temperature)
    yield from check("C109", hottest, metal.recommended_temperature, advisory=True)


def validity_checks(values: Mapping[str, float]) -> Iterator[Check]:
    """Laminar film and distance from mixed friction."""
    yield Check(
        "C110",
        "film_reynolds_number",
        values["film_reynolds_number"],
        values["critical_reynolds_number"],
        AT_MOST,
        "41.3 sqrt(D/C), end of the laminar film (ISO 7902-1)",
    )
    if "transition_speed" in values:
        source = "speed at which the film thins to the film limit of the surfaces"
        yield Check("C111", "angular_speed", values["angular_speed"], values["transition_speed"], AT_LEAST, source)


def clearance_check(values: Mapping[str, float]) -> Check:
    """Advice on the mean relative clearance."""
    return Check(
        "C114",
        "relative_clearance",
        values["relative_clearance"],
        values["recommended_relative_clearance"],
        AT_LEAST,
        "0.8e-3 U^(1/4) (Vogelpohl)",
        advisory=True,
    )
