"""Where the journal centre stands, in place of a load."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Part
from babbitt.core.units import si

__all__ = ["PositionInput"]


class PositionInput(Part):
    """Where the journal centre stands."""

    example: ClassVar[str] = "{x: 20 um, y: -60 um}"

    x: Annotated[float, si("m", "-5 mm", "5 mm")] = Field(description="To the right of the bearing centre.")
    y: Annotated[float, si("m", "-5 mm", "5 mm")] = Field(description="Above the bearing centre.")
