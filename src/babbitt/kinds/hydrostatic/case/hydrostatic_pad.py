"""Hydrostatic pads with one recess."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, exactly_one, is_given, rule
from babbitt.core.units import si, written
from babbitt.kinds.hydrostatic.case.hydrostatic_file import HydrostaticFile
from babbitt.kinds.hydrostatic.case.pad_shapes import AnnularInput, CircularInput, RectangularInput
from babbitt.kinds.hydrostatic.case.recess_parts import Gap, Speed
from babbitt.kinds.hydrostatic.geometry import PadShape
from babbitt.kinds.hydrostatic.model import OperatingConditions


class HydrostaticPadCase(HydrostaticFile):
    """A pad with one recess."""

    shaped_by: ClassVar[tuple[str, ...]] = ("pad",)

    kind: Literal["hydrostatic_pad"] = Field(description="Pad with one recess: round, annular, rectangular.")
    pad: Annotated[CircularInput | AnnularInput | RectangularInput, Discriminator("kind")] = Field(
        description="Shape of the pad."
    )
    gap: Gap | None = Field(None, description="Gap, in place of the load.")
    speed: Speed = Field(0.0, description="Rotational speed of round and annular pads about their axis.")
    sliding_speed: Annotated[float, si("m/s", "0 m/s", "200 m/s")] = Field(
        0.0, description="Sliding speed of rectangular pads."
    )

    @rule
    def _load_or_gap(self) -> Iterator[Issue]:
        yield from exactly_one(self, "load", "gap")

    @rule
    def _motion_fits(self) -> Iterator[Issue]:
        rectangular = isinstance(self.pad, RectangularInput)
        if rectangular and is_given(self, "speed"):
            yield Issue(("speed",), "a rectangular pad does not turn", "sliding_speed", "write sliding_speed")
        if not rectangular and is_given(self, "sliding_speed"):
            yield Issue(("sliding_speed",), "a round pad does not slide", "speed", "write speed")

    @rule
    def _closed_forms_reach(self) -> Iterator[Issue]:
        pad = self.pad
        if self.method != "quick" or not isinstance(pad, RectangularInput):
            return
        along, aside = 0.5 * (pad.length - pad.recess_length), 0.5 * (pad.width - pad.recess_width)
        shorter = min(pad.recess_length, pad.recess_width)
        if math.isclose(along, aside, rel_tol=1e-6) and shorter < along:
            says = (
                f"the shorter side of the recess, {written(shorter, 'mm')}, is less than its land, "
                f"{written(along, 'mm')}: the corners touch and the closed forms end"
            )
            yield Issue(("method",), says, "method: film, or a larger recess")

    def shape(self) -> PadShape:
        """Give the shape of the calculation."""
        return self.pad.pad()

    def duty(self) -> OperatingConditions:
        """Give the duty of the calculation."""
        return OperatingConditions(
            self.load, gap=self.gap or 0.0, angular_speed=self.speed, sliding_speed=self.sliding_speed
        )
