"""Hydrostatic thrust rings with several recesses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.part import Issue, exactly_one, is_given, rule
from babbitt.core.units import si, written
from babbitt.kinds.hydrostatic.case.hydrostatic_file import HydrostaticFile
from babbitt.kinds.hydrostatic.case.pad_shapes import DIAMETERS
from babbitt.kinds.hydrostatic.case.recess_parts import Gap, Length, RecessRow, Speed
from babbitt.kinds.hydrostatic.case.recess_rules import in_order, lands_between
from babbitt.kinds.hydrostatic.geometry import AnnularPad, ThrustRing
from babbitt.kinds.hydrostatic.model import OperatingConditions


class HydrostaticThrustRingCase(HydrostaticFile):
    """A thrust ring with several recesses."""

    kind: Literal["hydrostatic_thrust_ring"] = Field(description="Thrust ring with several recesses, with tilt.")
    inner_diameter: Length = Field(description="Inner edge of the ring.")
    recess_inner_diameter: Length = Field(description="Inner edge of the recesses.")
    recess_outer_diameter: Length = Field(description="Outer edge of the recesses.")
    outer_diameter: Length = Field(description="Outer edge of the ring.")
    recesses: RecessRow = Field(description="The recesses.")
    moments: tuple[
        Annotated[float, si("N m", "-1e9 N m", "1e9 N m")], Annotated[float, si("N m", "-1e9 N m", "1e9 N m")]
    ] = Field((0.0, 0.0), description="Moments of the load about x and y, that tilt the runner.")
    gap: Gap | None = Field(None, description="Gap on the axis, in place of the load.")
    tilt: tuple[Annotated[float, si("1", "-0.1", "0.1")], Annotated[float, si("1", "-0.1", "0.1")]] = Field(
        (0.0, 0.0), description="Tilt about x and y with a given gap, rad."
    )
    speed: Speed = Field(0.0, description="Rotational speed of the runner; positive counter-clockwise.")

    @rule
    def _load_or_gap(self) -> Iterator[Issue]:
        yield from exactly_one(self, "load", "gap")
        if is_given(self, "tilt") and self.gap is None:
            yield Issue(("tilt",), "a tilt is given without the gap", "gap and tilt, or load and moments")
        if is_given(self, "moments") and self.load is None:
            yield Issue(("moments",), "moments are given without the load", "load and moments, or gap and tilt")

    @rule
    def _tilt_leaves_a_gap(self) -> Iterator[Issue]:
        tilt, edge = math.hypot(*self.tilt), 0.5 * self.outer_diameter
        if self.gap is not None and tilt * edge >= self.gap:
            where = math.degrees(math.atan2(-self.tilt[0], self.tilt[1]))
            says = (
                f"a tilt of {1e3 * tilt:.4g} mm/m closes the gap of {written(self.gap, 'um')} on the outer "
                f"edge at {where:.4g} deg"
            )
            yield Issue(("tilt",), says, f"less than {1e3 * self.gap / edge:.4g} mm/m in all", "or a wider gap")

    @property
    def recess_count(self) -> int:
        """Number of recesses."""
        return self.recesses.number

    def misfits(self) -> Iterator[Issue]:
        """Complain of edges out of order and of recesses without lands between them."""
        yield from in_order(self, *DIAMETERS)
        yield from lands_between("recesses", self.recesses)

    def shape(self) -> ThrustRing:
        """Give the shape of the calculation."""
        radii = AnnularPad(
            0.5 * self.inner_diameter,
            0.5 * self.recess_inner_diameter,
            0.5 * self.recess_outer_diameter,
            0.5 * self.outer_diameter,
        )
        row = self.recesses
        return ThrustRing(radii, row.middles, row.extent, row.drain_groove)

    def duty(self) -> OperatingConditions:
        """Give the duty of the calculation."""
        return OperatingConditions(
            self.load, moments=self.moments, gap=self.gap or 0.0, tilt=self.tilt, angular_speed=self.speed
        )
