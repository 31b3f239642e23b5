"""Loads that change while the journal turns."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, exactly_one, is_given, rule
from babbitt.core.units import si, written
from babbitt.kinds.journal.film.changing_load import ChangingLoad, RotatingLoad, TabulatedLoad

SLOWEST_RATIO = 0.05
"""Of the speed of the load over that of the journal; a slower load is a steady one."""

Force = Annotated[float, si("N", "-1000 MN", "1000 MN")]

MovingMass = Annotated[float, si("kg", "0 kg", "10000 t")]

MOVING_MASS = "Mass that moves with the journal. Without it the film balances the load at every instant."


class RotatingLoadInput(Part):
    """A load of constant size that rotates, as that of an unbalance."""

    kind: Literal["rotating"] = Field(description="A load of constant size that rotates, as that of an unbalance.")
    magnitude: Annotated[float, si("N", "1 N", "1000 MN")] = Field(description="Its size.")
    speed_ratio: Annotated[float, si("1", "-20", "20")] = Field(
        1.0, description="Its speed over that of the journal: 1 turns with the journal, -1 against it."
    )
    phase: Annotated[float, si("rad", "-360 deg", "360 deg")] = Field(
        0.0, description="Its direction when the cycle begins, counter-clockwise from the x axis."
    )
    moving_mass: MovingMass = Field(0.0, description=MOVING_MASS)

    def changing_load(self) -> ChangingLoad:
        """Give the load of the orbit."""
        return RotatingLoad(self.magnitude, self.speed_ratio, self.phase)

    @rule
    def _it_rotates(self) -> Iterator[Issue]:
        if abs(self.speed_ratio) < SLOWEST_RATIO:
            says = f"a load at {self.speed_ratio:g} of the speed is as good as steady"
            allowed = f"{SLOWEST_RATIO:g} to 20 with the journal, negative against it"
            yield Issue(("speed_ratio",), says, allowed, "give a steady load as load")


class LoadTableInput(Part):
    """A load by table over the angle that the journal turns."""

    kind: Literal["table"] = Field(description="A load by table, linear between its points.")
    cycle: Annotated[float, si("rad", "30 deg", "7200 deg")] = Field(
        2.0 * math.pi,
        description="Angle that the journal turns from one cycle to the next; 720 deg in a four-stroke engine.",
    )
    angle: tuple[Annotated[float, si("rad", "0 deg", "7200 deg")], ...] | None = Field(
        None,
        min_length=2,
        max_length=1440,
        description="Angles that the journal has turned since the cycle began, rising, less than a cycle.",
    )
    fx: tuple[Force, ...] | None = Field(None, description="Load to the right at each angle.")
    fy: tuple[Force, ...] | None = Field(None, description="Load upward at each angle.")
    file: str | None = Field(
        None,
        max_length=1000,
        description="CSV table in place of the three lists, named from the folder of the case; its heading has "
        "the units: angle [deg],fx [kN],fy [kN].",
    )
    moving_mass: MovingMass = Field(0.0, description=MOVING_MASS)

    def changing_load(self) -> ChangingLoad:
        """Give the load of the orbit."""
        angles, fx, fy = self.angle or (), self.fx or (), self.fy or ()
        if len(angles) > 1 and angles[-1] >= self.cycle * (1.0 - 1e-9):  # its end is its beginning
            angles, fx, fy = angles[:-1], fx[:-1], fy[:-1]
        return TabulatedLoad(angles, fx, fy, self.cycle)

    @rule
    def _one_source(self) -> Iterator[Issue]:
        yield from exactly_one(self, "angle", "file")
        for name in ("fx", "fy"):
            if is_given(self, "angle") and not is_given(self, name):
                yield Issue((name,), "is missing", "one force for each angle", code="E003")

    @rule
    def _table_is_whole(self) -> Iterator[Issue]:
        if self.angle is None or self.fx is None or self.fy is None:
            return
        for name, column in (("fx", self.fx), ("fy", self.fy)):
            if len(column) != len(self.angle):
                says = f"{len(column)} forces for {len(self.angle)} angles"
                yield Issue((name,), says, "one force for each angle")
                return
        if any(after <= before for before, after in pairwise(self.angle)):
            yield Issue(("angle",), "the angles do not rise", "rising angles")
        elif self.angle[-1] > self.cycle * (1.0 + 1e-9):
            says = f"the angles reach {written(self.angle[-1], 'deg')}, beyond the cycle"
            yield Issue(("angle",), says, f"up to {written(self.cycle, 'deg')}, or a longer cycle")
        elif self.angle[-1] >= self.cycle * (1.0 - 1e-9):
            ends = math.hypot(self.fx[-1] - self.fx[0], self.fy[-1] - self.fy[0])
            largest = max(math.hypot(x, y) for x, y in zip(self.fx, self.fy, strict=True))
            if ends > 1e-3 * largest:
                apart = ", ".join(
                    f"{name} is {written(column[0], 'kN')} at its begin and {written(column[-1], 'kN')} at its end"
                    for name, column in (("fx", self.fx), ("fy", self.fy))
                    if abs(column[-1] - column[0]) > 1e-3 * largest
                )
                says = f"the table does not close after its cycle: {apart or 'its ends are apart'}"
                yield Issue(("angle",), says, "equal loads at begin and end of the cycle")


DynamicLoadInput = Annotated[RotatingLoadInput | LoadTableInput, Discriminator("kind")]
