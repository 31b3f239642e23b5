"""Permissible film thickness, specific load and temperature by experience, in SI."""

from __future__ import annotations

from babbitt.core.notices import InputError
from babbitt.properties.materials.bearing_metal import AlloyFamily, BearingMetal
from babbitt.properties.materials.experience_tables import ExperienceLimit, ExperienceLimits, experience_limits
from babbitt.properties.materials.sourced import SourcedValue


def empirical_minimum_film_thickness(
    diameter: float, surface_speed: float, tables: ExperienceLimits | None = None
) -> float | None:
    """Empirical permissible minimum film thickness h_lim of a steadily loaded bearing.

    Parameters
    ----------
    diameter : float
        Bearing diameter in m.
    surface_speed : float
        Surface speed of the journal in m/s; its sign does not matter.
    tables : ExperienceLimits, optional
        The user's own instead of the shipped ones.

    Returns
    -------
    float or None
        Film thickness in m. None outside the table (diameters up to 24 mm or above 2.5 m): nothing is
        extrapolated.

    Examples
    --------
    >>> round(empirical_minimum_film_thickness(0.250, 45.0) * 1e6)
    14
    >>> empirical_minimum_film_thickness(0.020, 45.0) is None
    True
    """
    return (tables or experience_limits()).film_thickness.at(diameter, surface_speed)


def specific_load_limit(family: AlloyFamily, tables: ExperienceLimits | None = None) -> ExperienceLimit | None:
    """Permissible specific load p_lim of a family of bearing metals, in Pa; None where nothing public is known.

    Parameters
    ----------
    family : AlloyFamily
        Of the bearing metal.
    tables : ExperienceLimits, optional
        The user's own instead of the shipped ones.

    Examples
    --------
    >>> limit = specific_load_limit(AlloyFamily.TIN)
    >>> limit.general / 1e6, limit.exceptional / 1e6
    (5.0, 15.0)
    """
    return (tables or experience_limits()).specific_load.get(family)


def published_metal_temperature(
    metal: BearingMetal | None, tables: ExperienceLimits | None = None
) -> SourcedValue | None:
    """Limiting temperature of a bearing metal, in K: its own, else that of its family; None for neither.

    Parameters
    ----------
    metal : BearingMetal or None
        None where the case names none.
    tables : ExperienceLimits, optional
        The user's own instead of the shipped ones; families that they lack have the shipped values.
    """
    if metal is None:
        return None
    if metal.limiting_temperature is not None:
        return metal.limiting_temperature
    for known in (tables, experience_limits()):
        if known is not None and metal.family in known.metal_temperature:
            of_family = known.metal_temperature[metal.family]
            return SourcedValue(of_family.value, f"{metal.family.value} metals: {of_family.source}")
    return None


def metal_temperature_limit(metal: BearingMetal | None, tables: ExperienceLimits | None = None) -> SourcedValue:
    """Limiting temperature of a bearing metal, in K: its own, else that of its family, else the general one.

    Parameters
    ----------
    metal, tables
        As of `published_metal_temperature`.

    Returns
    -------
    SourcedValue
        The last resort, the general limit of the bearing temperature, says in its source that it is an assumption.

    Examples
    --------
    >>> round(metal_temperature_limit(None).value - 273.15)
    90
    """
    published = published_metal_temperature(metal, tables)
    if published is not None:
        return published
    general = self_cooled_temperature_limit(tables)
    unknown = "no bearing metal is given" if metal is None else f"nothing is known of {metal.name}"
    return SourcedValue(
        general.general, f"assumption, as {unknown}: general limit of the bearing temperature; {general.source}"
    )


def highest_metal_temperature(tables: ExperienceLimits | None = None) -> SourcedValue:
    """The highest limiting temperature of any family of bearing metals, in K.

    Examples
    --------
    >>> round(highest_metal_temperature().value - 273.15)
    125
    """
    known = (tables or experience_limits()).metal_temperature or experience_limits().metal_temperature
    highest = max(known.values(), key=lambda one: one.value)
    return SourcedValue(highest.value, f"highest of any family; {highest.source}")


def self_cooled_temperature_limit(tables: ExperienceLimits | None = None) -> ExperienceLimit:
    """Permissible bearing temperature T_B of a bearing cooled by its surroundings, in K.

    Parameters
    ----------
    tables : ExperienceLimits, optional
        The user's own instead of the shipped ones.
    """
    return (tables or experience_limits()).self_cooled


def pressure_fed_temperature_limit(
    circulation_time: float | None = None, tables: ExperienceLimits | None = None
) -> ExperienceLimit:
    """Permissible oil outlet temperature T_ex of a pressure-fed bearing, in K.

    Parameters
    ----------
    circulation_time : float, optional
        Total oil volume over flow rate, in s. Unknown, the lower limit holds.
    tables : ExperienceLimits, optional
        The user's own instead of the shipped ones.

    Raises
    ------
    InputError
        E003 if the circulation time is not positive.

    Examples
    --------
    >>> round(pressure_fed_temperature_limit(600.0).general - 273.15)
    110
    """
    limits = tables or experience_limits()
    if circulation_time is None:
        return limits.pressure_fed_little_oil
    if not circulation_time > 0.0:
        raise InputError("E003", f"the circulation time is {circulation_time!r} s; it must be positive")
    much = circulation_time > limits.circulation_time
    return limits.pressure_fed_much_oil if much else limits.pressure_fed_little_oil
