"""A uniform piece of shaft, as every kind with a shaft writes it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.aliases import FormerWords
from babbitt.case.part import Issue, Part, rule
from babbitt.core.units import si, written

__all__ = ["MATERIAL", "UniformPiece", "words_of_material"]

MATERIAL = {"Young's modulus": ("shaft.modulus",), "Density of the shaft": ("shaft.density",)}
"""Inputs that a piece may leave out, by the label of their row: the fields that give them."""


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


def words_of_material(pieces: Sequence[UniformPiece]) -> Iterator[tuple[str, str]]:
    """Tell modulus and density of a shaft, pieces in a row that are alike together.

    Parameters
    ----------
    pieces : sequence of UniformPiece
        In the order of the case.

    Yields
    ------
    (str, str)
        What it is, and in which words the case gives it.
    """
    for label, (path,) in MATERIAL.items():
        name = path.rpartition(".")[2]
        unit = "GPa" if name == "modulus" else "kg/m3"
        start = 1
        for (value, _), alike in groupby(
            pieces, key=lambda one: (getattr(one, name), name in one.model_fields_set)
        ):
            last = start + len(tuple(alike)) - 1
            of = f"piece {start}" if last == start else f"pieces {start} to {last}"
            yield f"{label}, {of}", written(value, unit).replace("kg/m3", "kg/m³")
            start = last + 1
