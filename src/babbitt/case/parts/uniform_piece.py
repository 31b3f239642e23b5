"""A uniform piece of shaft, as every kind with a shaft writes it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.aliases import FormerWords
from babbitt.case.part import Issue, Part, rule
from babbitt.core.units import si, written

__all__ = ["UniformPiece"]


class UniformPiece(Part):
    """A uniform piece of shaft."""

    former_words: ClassVar[FormerWords] = {"bore": "inner_diameter"}

    length: Annotated[float, si("m", "1 mm", "500 m")] = Field(description="Length.")
    diameter: Annotated[float, si("m", "1 mm", "5 m")] = Field(description="Outer diameter.")
    inner_diameter: Annotated[float, si("m", "0 mm", "5 m")] = Field(0.0, description="Diameter of the bore.")
    modulus: Annotated[float, si("Pa", "1 GPa", "1000 GPa")] = Field(206e9, description="Young's modulus.")
    density: Annotated[float, si("kg/m3", "100 kg/m3", "30000 kg/m3")] = Field(7850.0, description="Density.")

    @rule
    def _bore_inside(self) -> Iterator[Issue]:
        if self.inner_diameter >= self.diameter:
            yield Issue(
                ("inner_diameter",),
                f"the bore {written(self.inner_diameter, 'mm')} leaves nothing of the shaft",
                f"less than {written(self.diameter, 'mm')}",
            )
