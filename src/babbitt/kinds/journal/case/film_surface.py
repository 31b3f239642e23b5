"""Form of the two surfaces beyond the circle: steps, crowning, displacement, and the pressures at the sides."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, exactly_one, rule
from babbitt.case.parts.fields import Name
from babbitt.core.units import si, written
from babbitt.reynolds.model import Field as FilmField
from babbitt.reynolds.model import Step

Angle = Annotated[float, si("rad", "-360 deg", "360 deg")]
Place = Annotated[float, si("m", "-3 m", "3 m")]
Departure = Annotated[float, si("m", "-1 mm", "1 mm")]
Drop = Annotated[float, si("m", "0 um", "1 mm")]
SidePressure = Annotated[float, si("Pa", "-0.1 MPa", "50 MPa")]

TURN = 2.0 * math.pi
CROWN_POINTS = 161
"""Places from side to side at which the crowning is described."""
FIELD_SHAPE = (360, 41)
"""Places around and across to which a displacement is interpolated."""
LARGEST_STEP = math.radians(45.0)


class StepInput(Part):
    """A rectangle of the bore that lies deeper and belongs to the film."""

    angle: Angle = Field(description="Direction of its centre, counter-clockwise from the x axis.")
    extent: Annotated[float, si("rad", "0.1 deg", "360 deg")] = Field(
        description="Angle it takes around the bore."
    )
    width: Annotated[float, si("m", "0.1 mm", "3 m")] = Field(description="Size along the shaft.")
    depth: Annotated[float, si("m", "0.1 um", "5 mm")] = Field(description="How much deeper it lies.")
    axial_position: Place = Field(0.0, description="Axial position of its centre from the mid-plane.")

    def step(self) -> Step:
        """Give the step of the film."""
        return Step(self.angle, self.extent, self.width, self.depth, self.axial_position)


class ParabolicCrowningInput(Part):
    """A journal that is a barrel."""

    kind: Literal["parabolic"] = Field(
        description="The radius falls as a parabola from the mid-plane to the sides."
    )
    drop: Drop = Field(description="What the radius lacks at the sides.")

    def crowning(self, width: float) -> tuple[float, ...]:
        """What the radius lacks at equally spaced places from side to side, m."""
        return tuple(self.drop * place**2 for place in _places())


class EdgeCrowningInput(Part):
    """A journal, or bore, that is relieved near its edges."""

    kind: Literal["edges"] = Field(description="The radius falls as a parabola near the sides only.")
    drop: Drop = Field(description="What the radius lacks at the sides.")
    length: Annotated[float, si("m", "0.1 mm", "1 m")] = Field(description="Axial length of the fall, each side.")

    def crowning(self, width: float) -> tuple[float, ...]:
        """What the radius lacks at equally spaced places from side to side, m."""
        begin = max(0.0, 1.0 - 2.0 * self.length / width)
        return tuple(self.drop * (max(0.0, abs(place) - begin) / (1.0 - begin)) ** 2 for place in _places())


class TableCrowningInput(Part):
    """A journal as it was measured along its axis."""

    kind: Literal["table"] = Field(description="What the radius lacks at given places.")
    drops: tuple[Departure, ...] = Field(
        min_length=2,
        max_length=200,
        description="What the radius lacks at equally spaced places from the side z = -B/2 to the side z = B/2.",
    )

    def crowning(self, width: float) -> tuple[float, ...]:
        """What the radius lacks at equally spaced places from side to side, m."""
        return self.drops


CrowningInput = Annotated[ParabolicCrowningInput | EdgeCrowningInput | TableCrowningInput, Discriminator("kind")]


class DisplacementInput(Part):
    """What the gap gains over the bore, by elastic or thermal displacement of its surfaces."""

    angles: tuple[Angle, ...] | None = Field(
        None,
        min_length=8,
        max_length=720,
        description="Directions of the rows, rising, over one turn at most, counter-clockwise from the x axis.",
    )
    places: tuple[Place, ...] | None = Field(
        None, min_length=1, max_length=200, description="Axial places of the columns from the mid-plane, rising."
    )
    values: tuple[tuple[Departure, ...], ...] | None = Field(
        None, description="What the gap gains, a row for every angle with a value for every place."
    )
    file: str | None = Field(
        None,
        max_length=1000,
        description="CSV table in place of them, named from the folder of the case, a line for every angle and "
        "place; its heading has the units: angle [deg],z [mm],displacement [um].",
    )
    form: Name | None = Field(
        None,
        description="What form of the bore the table is, where it is a bore of one's own rather than a "
        "displacement; reports name it in place of the round bore.",
    )

    @property
    def largest(self) -> float:
        """Largest displacement, m."""
        return max((abs(value) for row in self.values or () for value in row), default=0.0)

    @property
    def start(self) -> float:
        """Angle of the first row, rad."""
        return self.angles[0] if self.angles else 0.0

    def field(self, width: float) -> FilmField:
        """Values at equal steps around from ``start`` on and across, linear between those given, level beyond."""
        import numpy as np

        if self.angles is None or self.places is None or self.values is None:
            raise ValueError("a case that was not validated: the displacement has no table")
        turned, places = (np.arange(FIELD_SHAPE[0]) * TURN / FIELD_SHAPE[0], np.asarray(_places(FIELD_SHAPE[1])))
        rows = np.array([np.interp(0.5 * width * places, self.places, row) for row in self.values])
        at = self.start + turned
        around = np.array([np.interp(at, self.angles, column, period=TURN) for column in rows.T]).T
        return tuple(tuple(float(value) for value in row) for row in around)

    @rule
    def _one_source(self) -> Iterator[Issue]:
        yield from exactly_one(self, "values", "file")

    @rule
    def _table_is_whole(self) -> Iterator[Issue]:
        if self.values is None:
            return
        if self.angles is None or self.places is None:
            missing = "angles" if self.angles is None else "places"
            yield Issue((missing,), "is missing", "one for every row, or column, of the values", code="E003")
            return
        if len(self.values) != len(self.angles):
            says = f"{len(self.values)} rows for {len(self.angles)} angles"
            yield Issue(("values",), says, "a row for every angle")
        for number, row in enumerate(self.values):
            if len(row) != len(self.places):
                says = f"{len(row)} values for {len(self.places)} places"
                yield Issue(("values", number), says, "a value for every place")
        turns = [after - before for before, after in pairwise(self.angles)]
        whole = self.angles[-1] - self.angles[0]
        if min(turns) <= 0.0 or whole >= TURN * (1.0 - 1e-9):
            yield Issue(("angles",), "the angles do not rise once around", "rising, less than one turn in all")
        elif max(*turns, TURN - whole) > LARGEST_STEP:
            yield Issue(("angles",), "the angles leave a gap", "steps of at most 45 deg all around")
        if any(after <= before for before, after in pairwise(self.places)):
            yield Issue(("places",), "the places do not rise", "from z = -B/2 to z = B/2")


__all__ = ["CrowningInput", "DisplacementInput", "SidePressure", "StepInput", "issues_of_steps"]


def issues_of_steps(steps: tuple[StepInput, ...], width: float | None) -> Iterator[Issue]:
    """Complain about steps beyond the sides of the bearing."""
    for index, step in enumerate(steps):
        beyond = abs(step.axial_position) + step.width / 2.0
        if width is not None and beyond > width / 2.0 * (1.0 + 1e-9):
            says = f"it reaches {written(beyond, 'mm')} from the mid-plane, beyond the bearing"
            yield Issue(("steps", index), says, f"up to {written(width / 2.0, 'mm')}")


def _places(count: int = CROWN_POINTS) -> tuple[float, ...]:
    """Equally spaced places from -1 to 1."""
    return tuple(-1.0 + 2.0 * number / (count - 1) for number in range(count))
