"""Tables of permissible values by experience, shipped in ``limits.toml`` or the user's own."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from babbitt.core.files.bounded_text import loads_toml
from babbitt.core.notices import InputError
from babbitt.core.units import ZERO_CELSIUS
from babbitt.numerics.lanes import lanes_of
from babbitt.numerics.scalar_or_array import place_among
from babbitt.properties.materials.bearing_metal import AlloyFamily
from babbitt.properties.materials.sourced import SourcedValue


@dataclass(frozen=True)
class ExperienceLimit:
    """A permissible value by experience, in SI.

    Attributes
    ----------
    general : float
        What holds in general.
    exceptional : float
        What has been borne in exceptional cases: specific loads at low sliding speed, temperatures with special
        care in design.
    source : str
        Where the values come from.
    """

    general: float
    exceptional: float
    source: str


@dataclass(frozen=True)
class FilmThicknessTable:
    """Permissible minimum film thickness in steps of diameter and surface speed, in SI.

    Row i holds for diameters up to and including ``diameters[i + 1]``, the first row above ``diameters[0]``.
    Column j holds for speeds up to and including ``surface_speeds[j]``, the last column above the last speed.
    """

    diameters: tuple[float, ...]
    surface_speeds: tuple[float, ...]
    films: tuple[tuple[float, ...], ...]

    def __post_init__(self) -> None:
        for bounds in (self.diameters, self.surface_speeds):
            if not bounds or list(bounds) != sorted(set(bounds)):
                raise InputError("E003", f"the bounds of the film thickness table must increase, given {bounds}")
        rows, columns = len(self.diameters) - 1, len(self.surface_speeds) + 1
        if len(self.films) != rows or any(len(row) != columns for row in self.films):
            raise InputError("E003", f"the film thickness table must have {rows} rows of {columns} values")
        if not all(math.isfinite(film) and film > 0.0 for row in self.films for film in row):
            raise InputError("E003", f"permissible film thicknesses must be positive numbers, given {self.films}")

    def at(self, diameter: float, surface_speed: float) -> float | None:
        """Permissible film thickness in m, or None for a diameter outside the table."""
        diameter = round(diameter, 9)  # arithmetic may leave 0.4 m a hair above its bound
        if not self.diameters[0] < diameter <= self.diameters[-1]:
            return None
        row = place_among(self.diameters, diameter) - 1
        column = place_among(self.surface_speeds, round(abs(surface_speed), 9))
        if isinstance(row, np.ndarray) or isinstance(column, np.ndarray):
            found: float = lanes_of(np.array(self.films)[row, column])
            return found
        return float(self.films[row][column])

    def nearest(self, diameter: float, surface_speed: float) -> float:
        """Permissible film thickness in m at the diameter of the table that is nearest."""
        found = self.at(min(max(diameter, self.diameters[1]), self.diameters[-1]), surface_speed)
        assert found is not None
        return found


@dataclass(frozen=True)
class ExperienceLimits:
    """The three tables of permissible values by experience.

    Attributes
    ----------
    source : str
        Where the values come from.
    film_thickness : FilmThicknessTable
        Empirical permissible minimum film thickness.
    specific_load : Mapping of AlloyFamily to ExperienceLimit
        In Pa; families without a public value are absent.
    self_cooled, pressure_fed_little_oil, pressure_fed_much_oil : ExperienceLimit
        Temperatures in K: of the bearing when self-cooled, of the oil outlet when pressure-fed.
    circulation_time : float
        Total oil volume over flow rate, in s, up to which there is little oil.
    metal_temperature : Mapping of AlloyFamily to SourcedValue
        Limiting temperature of the metals of a family, in K: the lowest of its sources.
    """

    source: str
    film_thickness: FilmThicknessTable
    specific_load: Mapping[AlloyFamily, ExperienceLimit]
    self_cooled: ExperienceLimit
    pressure_fed_little_oil: ExperienceLimit
    pressure_fed_much_oil: ExperienceLimit
    circulation_time: float
    metal_temperature: Mapping[AlloyFamily, SourcedValue] = field(default_factory=dict)


def experience_limits() -> ExperienceLimits:
    """The tables that ship with the package."""
    return _shipped()


def parse_experience_limits(text: str, name: str = "<text>") -> ExperienceLimits:
    """Tables from the text of such a file.

    Parameters
    ----------
    text : str
        TOML.
    name : str
        What to call the text in messages.

    Raises
    ------
    InputError
        E003 if it is not of the form of the shipped ``limits.toml``.
    """
    try:
        return _parse(loads_toml(text))
    except tomllib.TOMLDecodeError as error:
        raise InputError("E003", f"the limits file {name} is not valid TOML: {error}") from None
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise InputError(
            "E003",
            f"the limits file {name} does not have the form of the shipped limits.toml: "
            f"{type(error).__name__} {error}",
        ) from None


@cache
def _shipped() -> ExperienceLimits:
    return _parse(
        tomllib.loads(files("babbitt.properties.materials").joinpath("limits.toml").read_text(encoding="utf-8"))
    )


def _parse(raw: Mapping[str, Any]) -> ExperienceLimits:
    """Convert the engineer's units of the file to SI."""
    source = str(raw["source"])
    film, load, temperature = raw["minimum_film_thickness"], raw["specific_load_MPa"], raw["temperature_degC"]

    def limit(entry: Mapping[str, Any], factor: float, offset: float) -> ExperienceLimit:
        general, exceptional = (float(entry[key]) * factor + offset for key in ("general", "exceptional"))
        if not (0.0 < general <= exceptional and math.isfinite(exceptional)):
            raise ValueError(f"general {entry['general']} must be positive and not above the exceptional value")
        return ExperienceLimit(general, exceptional, str(entry.get("source", source)))

    return ExperienceLimits(
        source=source,
        film_thickness=FilmThicknessTable(
            diameters=tuple(d * 1e-3 for d in (film["diameter_above_mm"], *film["diameter_up_to_mm"])),
            surface_speeds=tuple(float(speed) for speed in film["surface_speed_up_to_m_s"]),
            films=tuple(tuple(value * 1e-6 for value in row) for row in film["film_um"]),
        ),
        specific_load={
            family: limit(entry, 1e6, 0.0) for name, entry in load.items() for family in _families(name)
        },
        self_cooled=limit(temperature["self_cooled"], 1.0, ZERO_CELSIUS),
        pressure_fed_little_oil=limit(temperature["pressure_fed_little_oil"], 1.0, ZERO_CELSIUS),
        pressure_fed_much_oil=limit(temperature["pressure_fed_much_oil"], 1.0, ZERO_CELSIUS),
        circulation_time=float(temperature["little_oil_up_to_minutes"]) * 60.0,
        metal_temperature={
            family: _lowest(entries)
            for name, entries in raw.get("metal_temperature_degC", {}).items()
            for family in _families(name)
        },
    )


def _families(name: str) -> tuple[AlloyFamily, ...]:
    """Families that a table names; tables of before know tin and lead as one."""
    return (AlloyFamily.TIN, AlloyFamily.LEAD) if name == "lead-tin" else (AlloyFamily(name),)


def _lowest(entries: Sequence[Mapping[str, Any]]) -> SourcedValue:
    """The lowest of several temperatures, its source and what the others say, in K."""
    first, *others = sorted(entries, key=lambda entry: float(entry["value"]))
    listed = "; ".join(f"{entry['value']} °C: {entry['source']}" for entry in others)
    source = f"{first['source']} (others: {listed})" if listed else str(first["source"])
    return SourcedValue(float(first["value"]) + ZERO_CELSIUS, source)
