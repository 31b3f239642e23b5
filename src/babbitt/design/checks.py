"""Verdicts on an operating point that do not depend on the method: each with code, value, limit and source."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.core.units import written
from babbitt.design.bounds import NO_BOUNDS, Bounds, bounds_of, certain, undecided
from babbitt.design.conditions import CheckedProblem, surface_speed
from babbitt.design.warnings import PLAIN_BEARING_UP_TO
from babbitt.properties.materials import (
    BearingMetal,
    ExperienceLimit,
    ExperienceLimits,
    LoadLimits,
    SourcedValue,
    experience_limits,
    metal_temperature_limit,
    pressure_fed_temperature_limit,
    published_metal_temperature,
    self_cooled_temperature_limit,
    specific_load_limit,
)

USER = "limit set in the case"
AT_MOST, AT_LEAST = Bound.AT_MOST, Bound.AT_LEAST


SLOW_UP_TO = 1.0
"""Surface speed in m/s up to which the exceptional specific load is granted (an assumption)."""

FILM_BY_EXPERIENCE = (
    "assumption: experience value for diameter and surface speed, as in textbooks, not the text of a standard"
)

METAL_CHECKS = ("C105", "C106", "C107")
"""Limits of the bearing metal itself: specific load, speed, their product."""


def limit_checks(
    case: CheckedProblem, values: Mapping[str, float], bounds: Bounds = NO_BOUNDS
) -> tuple[Check, ...]:
    """Checks of film thickness, load, temperature and metal that the data of the case allow.

    Parameters
    ----------
    case : CheckedProblem
    values : Mapping[str, float]
        Named results in SI, with the limits among them.
    bounds : Bounds
        Checks whose value flatters the bearing, by the method: only a miss is one (`babbitt.design.bounds`).
    """
    return certain(_every_check(case, values), {**bounds_of(case), **bounds})


def checks_not_made(
    case: CheckedProblem, values: Mapping[str, float], bounds: Bounds = NO_BOUNDS
) -> tuple[Notice, ...]:
    """The checks of the design that lack data or a value to compare, each with what is missing."""
    return (*_not_made(case, values), *undecided(_every_check(case, values), {**bounds_of(case), **bounds}))


def _every_check(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Check]:
    yield from film_checks(case, values)
    yield from load_and_temperature_checks(case, values)
    yield from metal_checks(case, values)
    yield from validity_checks(values)


def _not_made(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Notice]:
    bearing, metal = case.bearing, case.bearing.metal
    if case.limits.minimum_film_thickness is None and "empirical_film_limit" not in values:
        yield Notice("C101", "no_experience", {"diameter": bearing.diameter})
    if bearing.surfaces is None and bearing.edge_loss == 0.0:
        yield Notice("C102", "no_surfaces")
    if case.limits.specific_load is None and (
        metal is None or specific_load_limit(metal.family, case.limits.tables) is None
    ):
        if metal is None:
            yield Notice("C103", "no_metal")
        else:
            yield Notice("C103", "no_experience", {"family": metal.family.value})
    if metal is None:
        for code in METAL_CHECKS:
            yield Notice(code, "no_metal")
    else:
        limits = metal.limits(bearing.load_character)
        sources = (limits.specific_load, limits.sliding_speed, limits.pv)
        for code, limit in zip(METAL_CHECKS, sources, strict=True):
            if limit is None:
                yield Notice(code, "no_public_limit", {"metal": metal.name})
    if limiting_temperature(case, values) is None:
        yield Notice("C108", "oil_alone" if case.limits.temperature is None else "own_limit")
    if "transition_film_thickness" not in values:
        yield Notice("C111", "no_surfaces")


def temperature_limit(case: CheckedProblem) -> ExperienceLimit:
    """Temperature limit in K by experience, by the way the bearing is cooled."""
    if case.oil_supply is None:
        limit, why = self_cooled_temperature_limit(case.limits.tables), "cooled by its surroundings"
        return replace(limit, source=f"{limit.source}; {why}")
    return fed_temperature_limit(case.oil_supply.circulation_time, case.limits.tables)


def fed_temperature_limit(
    circulation_time: float | None, tables: ExperienceLimits | None = None
) -> ExperienceLimit:
    """Temperature limit in K by experience of oil that is fed, with the reason why this one holds."""
    limit = pressure_fed_temperature_limit(circulation_time, tables)
    most = (tables or experience_limits()).circulation_time
    if circulation_time is None:
        why = f"oil volume over flow not given: taken as up to {written(most, 'min')}"
    else:
        sign = ">" if circulation_time > most else "≤"
        why = f"oil volume over flow {written(circulation_time, 'min')} {sign} {written(most, 'min')}"
    return replace(limit, source=f"{limit.source}; {why}")


def limited_temperature(values: Mapping[str, float]) -> str:
    """Name of the hottest temperature known of oil and bearing, for which the limits hold.

    The mean one of the film counts where no outlet is known that would be hotter.
    """
    names = ("outlet_temperature", "bearing_temperature", "supply_temperature")
    known = [name for name in names if name in values]
    if "outlet_temperature" not in known:
        known.append("effective_temperature")
    return max(known, key=lambda name: values[name])


INSULATED_WALL = "maximum_wall_temperature"

HOTTEST_PLACES = (
    "maximum_bush_temperature",
    INSULATED_WALL,
    "maximum_temperature",
    "trailing_temperature",
)
"""Hottest metal, where it is not known the hottest film, and where that is not the oil at the trailing edges of
pads, by the methods that know more than the outlet."""


def hottest_place(values: Mapping[str, float]) -> str:
    """Name of the temperature for which limits of the metal hold: the hottest of bush, wall or film if known.

    A wall that takes no heat is at no place hotter than the film that it touches; the oil at the sides, which
    leaves from where the film is hotter across the gap, may be. The hotter of both counts there.
    """
    name = next((name for name in HOTTEST_PLACES if name in values), limited_temperature(values))
    if name == INSULATED_WALL:
        name = max(name, limited_temperature(values), key=lambda one: values[one])
    return name


def knows_hottest_place(values: Mapping[str, float]) -> bool:
    """Whether a temperature of bush, wall or film is known, not that of the oil that leaves alone."""
    return any(name in values for name in HOTTEST_PLACES)


def limiting_temperature(case: CheckedProblem, values: Mapping[str, float]) -> SourcedValue | None:
    """What the hottest place is held against, in K.

    The limit of the metal, else of its family, else the general one of bearing temperatures. That last one, an
    assumption, is for places in bush or film (the temperature of oil that leaves has limits of its own, C104), and
    gives way to a limit that the case sets, which holds for the hottest place too. None where nothing is left.
    """
    metal, tables = case.bearing.metal, case.limits.tables
    if case.limits.temperature is not None or not knows_hottest_place(values):
        return published_metal_temperature(metal, tables)
    return metal_temperature_limit(metal, tables)


def film_checks(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Check]:
    """Film thickness against experience and against the surfaces."""
    film = values["minimum_film_thickness"]
    name = "minimum_film_thickness"
    general = None
    if "empirical_film_limit" in values:
        own = case.limits.tables
        source = FILM_BY_EXPERIENCE if own is None else own.source
        general = values["empirical_film_limit"], source
    yield from _own_or_general("C101", name, film, case.limits.minimum_film_thickness, AT_LEAST, general)
    if "geometric_film_limit" in values:
        given = case.bearing.surfaces is not None
        source = "roughness, tilt, deflection and waviness of the case" if given else "slope of the shaft alone"
        yield Check("C102", name, film, values["geometric_film_limit"], AT_LEAST, source)


def load_and_temperature_checks(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Check]:
    """Specific load and temperature against experience, or against the limits of the case."""
    pressure, metal = values["specific_load"], case.bearing.metal
    general = None
    if metal is not None and (load_limit := specific_load_limit(metal.family, case.limits.tables)) is not None:
        general = specific_load_at_speed(load_limit, surface_speed(case))
    yield from _own_or_general("C103", "specific_load", pressure, case.limits.specific_load, AT_MOST, general)
    name, by_experience, highest = limited_temperature(values), temperature_limit(case), case.limits.temperature
    source = by_experience.source
    if highest is not None and (place := hottest_place(values)) != name:
        name, source = place, f"{source}; for the oil that leaves"
    yield from _own_or_general("C104", name, values[name], highest, AT_MOST, (by_experience.general, source))


def specific_load_at_speed(limit: ExperienceLimit, speed: float) -> tuple[float, str]:
    """The permissible specific load in Pa at a surface speed in m/s, and its source."""
    slow = speed <= SLOW_UP_TO
    which = f"exceptional value, for speeds up to {SLOW_UP_TO:g} m/s" if slow else "general value"
    return limit.exceptional if slow else limit.general, f"{limit.source}; {which}"


def film_of_nearest_diameter(case: CheckedProblem, values: Mapping[str, float]) -> Check:
    """The film thickness against experience at the nearest diameter, for one of which there is none."""
    tables = case.limits.tables or experience_limits()
    limit = tables.film_thickness.nearest(case.bearing.diameter, surface_speed(case))
    source = f"of the nearest diameter of the table; {FILM_BY_EXPERIENCE}"
    return Check("C101", "minimum_film_thickness", values["minimum_film_thickness"], limit, AT_LEAST, source)


def highest_specific_load(quantity: str, values: Mapping[str, float], tables: ExperienceLimits | None) -> Check:
    """A specific load against the highest limit of any family of bearing metals, for a metal of unknown family."""
    known = (tables or experience_limits()).specific_load or experience_limits().specific_load
    limit, source = max(specific_load_at_speed(one, abs(values["surface_speed"])) for one in known.values())
    return Check("C103", quantity, values[quantity], limit, AT_MOST, f"highest of any family; {source}")


def _own_or_general(
    code: str, name: str, value: float, own: float | None, bound: Bound, general: tuple[float, str] | None
) -> Iterator[Check]:
    """The limit that the case sets, else the general one with its source, where there is one."""
    if own is not None:
        yield Check(code, name, value, own, bound, USER, general=general)
    elif general is not None:
        yield Check(code, name, value, general[0], bound, general[1])


def metal_checks(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Check]:
    """Load, speed and temperature against the bearing metal."""
    metal, hottest = case.bearing.metal, hottest_place(values)

    def check(code: str, name: str, limit: SourcedValue | None, *, advisory: bool = False) -> Iterator[Check]:
        if limit is not None:
            yield Check(code, name, values[name], limit.value, AT_MOST, limit.source, advisory)

    limits = LoadLimits() if metal is None else metal.limits(case.bearing.load_character)
    yield from check("C105", "specific_load", limits.specific_load)
    yield from check("C106", "surface_speed", limits.sliding_speed)
    yield from check("C107", "pressure_speed_product", limits.pv)
    yield from check("C108", hottest, limiting_temperature(case, values))
    if metal is not None:
        yield from check("C109", hottest, recommended_temperature(metal), advisory=True)


def recommended_temperature(metal: BearingMetal) -> SourcedValue | None:
    """What the metal is recommended for, in K, and why that is no limit; None where it is not known.

    The column of GOST 1320-74 stands beside those of load and speed, which are limits, and its standing is not
    published: that C104 and C108 decide is an assumption.
    """
    given = metal.recommended_temperature
    if given is None:
        return None
    why = "a recommendation: of temperatures C104 and C108 are the limits (an assumption of this program)"
    return SourcedValue(given.value, f"{given.source}; {why}")


def validity_checks(values: Mapping[str, float]) -> Iterator[Check]:
    """Laminar film and distance from mixed friction."""
    yield Check(
        "C110",
        "film_reynolds_number",
        values["film_reynolds_number"],
        values["critical_reynolds_number"],
        AT_MOST,
        "41.3/√ψ_eff, end of the laminar film (ISO 7902-1)",
    )
    if "transition_speed" in values:
        source = "speed at which the film thins to the film limit of the surfaces"
        speed = values["hydrodynamic_speed"]
        yield Check("C111", "hydrodynamic_speed", speed, values["transition_speed"], AT_LEAST, source)
    elif "transition_film_thickness" in values and "minimum_film_thickness" in values:
        source = "film limit of the surfaces (no speed of transition is known)"
        film, needed = values["minimum_film_thickness"], values["transition_film_thickness"]
        yield Check("C111", "minimum_film_thickness", film, needed, AT_LEAST, source)


def pressure_check(case: CheckedProblem, values: Mapping[str, float]) -> Iterator[Check]:
    """The largest pressure of the film of a plain bearing against what plain bearings know, without a metal."""
    if case.bearing.metal is None:
        source = "yield strength of the hardest white metals, about (assumption); no bearing metal is given"
        pressure = values["maximum_pressure"]
        yield Check("C116", "maximum_pressure", pressure, PLAIN_BEARING_UP_TO, Bound.AT_MOST, source)


def pressure_not_checked(case: CheckedProblem) -> Iterator[Notice]:
    """Say why the largest pressure of the film was not compared, where a bearing metal is given."""
    if case.bearing.metal is not None:
        yield Notice("C116", values={"metal": case.bearing.metal.name})


def clearance_check(case: CheckedProblem, values: Mapping[str, float]) -> Check:
    """Advice on the mean relative clearance."""
    return Check(
        "C114",
        "relative_clearance",
        case.bearing.mean_relative_clearance,
        values["recommended_relative_clearance"],
        AT_LEAST,
        "0.8 ‰ U^(1/4), U in m/s (Vogelpohl)",
        advisory=True,
    )
