"""Choices of the calculation: friction, characteristics, limits of the user."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, refused, rule
from babbitt.core.units import si
from babbitt.design.conditions import Limits
from babbitt.properties.materials import ExperienceLimits, parse_experience_limits


class FrictionInput(Part):
    """Where the film rubs."""

    example: ClassVar[str] = "{model: full, factor: 1.1}"

    model: Literal["full", "arc", "curve360"] = Field(
        "full",
        description="Film around the whole circumference, on the loaded arc only, or the friction number of the "
        "full bearing at the same eccentricity.",
    )
    factor: Annotated[float, si("1", "0.2", "5")] = Field(
        1.0, description="Factor on the friction coefficient, where measurements ask for one."
    )


class FilmLimitsInput(Part):
    """Limits in place of those by experience, of bearings of every method."""

    minimum_film_thickness: Annotated[float, si("m", "0.1 um", "1 mm")] | None = Field(
        None, description="Least permissible film thickness."
    )
    specific_load: Annotated[float, si("Pa", "1 kPa", "200 MPa")] | None = Field(
        None, description="Greatest permissible specific load, load over width times diameter."
    )
    temperature: Annotated[float, si("K", "20 degC", "250 degC")] | None = Field(
        None, description="Greatest permissible outlet or bearing temperature."
    )
    transition_film_thickness: Annotated[float, si("m", "0.1 um", "1 mm")] | None = Field(
        None, description="Film thickness at which mixed friction begins."
    )

    def limits(self) -> Limits:
        """Give the limits of the calculation."""
        return Limits(
            self.minimum_film_thickness, self.specific_load, self.temperature, self.transition_film_thickness
        )


class LimitsInput(FilmLimitsInput):
    """Limits in place of those by experience."""

    example: ClassVar[str] = "{minimum_film_thickness: 10 um, temperature: 90 degC}"

    tables: Annotated[str, Field(max_length=100_000)] | None = Field(
        None,
        description="TOML file with your own tables of limits by experience, in the form of the shipped "
        "limits.toml; named from the folder of the case.",
    )

    def limits(self) -> Limits:
        """Give the limits of the calculation."""
        return replace(super().limits(), tables=self.own_tables())

    def own_tables(self) -> ExperienceLimits | None:
        """Give the tables in place of the shipped ones; whoever reads a case puts their text into the field."""
        return None if self.tables is None else parse_experience_limits(self.tables, "of the case")

    @rule
    def _tables_can_be_used(self) -> Iterator[Issue]:
        yield from refused(("tables",), self.own_tables)
