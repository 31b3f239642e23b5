"""What the bore gives way by under the pressure of the film: liner, ring, half-space, or a given matrix."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, exactly_one, rule
from babbitt.core.units import si, written
from babbitt.reynolds.deformation.compliance import Compliance

Modulus = Annotated[float, si("Pa", "1 MPa", "1000 GPa")]
PoissonRatio = Annotated[float, si("1", "0", "0.499")]
Yielding = Annotated[float, si("m/Pa", "-1 mm/MPa", "1 mm/MPa")]
Angle = Annotated[float, si("rad", "-360 deg", "360 deg")]

MOST_ANGLES = 180


class ColumnInput(Part):
    """A thin liner, of which every spot gives way by itself."""

    kind: Literal["column"] = Field(description="A thin liner on a stiff back; every spot gives way by itself.")
    thickness: Annotated[float, si("m", "1 um", "100 mm")] | None = Field(None, description="Of the liner.")
    elastic_modulus: Modulus | None = Field(None, description="Of the liner.")
    poisson_ratio: PoissonRatio = Field(0.3, description="Of the liner.")
    displacement_per_pressure: Annotated[float, si("m/Pa", "0 um/MPa", "1 mm/MPa")] | None = Field(
        None, description="What it gives way by, in place of thickness and elastic_modulus."
    )

    @rule
    def _one_source(self) -> Iterator[Issue]:
        yield from exactly_one(self, "thickness", "displacement_per_pressure")
        if self.thickness is not None and self.elastic_modulus is None:
            yield Issue(("elastic_modulus",), "is missing", "that of the liner, such as 50 GPa", code="E003")

    def compliance(self, diameter: float) -> Compliance:
        """Give the compliance of the film."""
        from babbitt.reynolds.deformation.compliance import ColumnLiner

        if self.displacement_per_pressure is not None:
            return ColumnLiner(self.displacement_per_pressure)
        if self.thickness is None or self.elastic_modulus is None:
            raise ValueError("a case that was not validated: the liner has no thickness or modulus")
        return ColumnLiner.of_layer(self.thickness, self.elastic_modulus, self.poisson_ratio)


class RingInput(Part):
    """Bush or housing as a thick elastic ring."""

    kind: Literal["ring"] = Field(description="Bush or housing as a thick elastic ring around the bore.")
    outer_diameter: Annotated[float, si("m", "1 mm", "20 m")] = Field(description="Of the ring.")
    elastic_modulus: Modulus = Field(description="Of the ring.")
    poisson_ratio: PoissonRatio = Field(0.3, description="Of the ring.")
    support: Literal["free", "clamped"] = Field(
        "free", description="Whether the outside is free, or bonded to a rigid body."
    )

    def compliance(self, diameter: float) -> Compliance:
        """Give the compliance of the film."""
        from babbitt.reynolds.deformation.elastic_ring import ElasticRing, RingSupport

        return ElasticRing(
            0.5 * diameter,
            0.5 * self.outer_diameter,
            self.elastic_modulus,
            self.poisson_ratio,
            RingSupport[self.support.upper()],
        )


class HalfSpaceInput(Part):
    """A massive housing."""

    kind: Literal["half_space"] = Field(description="A massive housing, as a half-space under the unrolled bore.")
    elastic_modulus: Modulus = Field(description="Of the housing.")
    poisson_ratio: PoissonRatio = Field(0.3, description="Of the housing.")

    def compliance(self, diameter: float) -> Compliance:
        """Give the compliance of the film."""
        from babbitt.reynolds.deformation.half_space import HalfSpace

        return HalfSpace(self.elastic_modulus, self.poisson_ratio)


class MatrixInput(Part):
    """A matrix of compliance that was calculated or measured elsewhere."""

    kind: Literal["file"] = Field(description="A matrix that was calculated or measured elsewhere.")
    angles: tuple[Angle, ...] | None = Field(
        None,
        min_length=3,
        max_length=MOST_ANGLES,
        description="Directions of rows and columns, rising, over less than one turn.",
    )
    values: tuple[tuple[Yielding, ...], ...] | None = Field(
        None, description="Displacement outwards at the angle of the row, by pressure around that of the column."
    )
    file: str | None = Field(
        None,
        max_length=1000,
        description="CSV or NPZ in place of them, named from the folder of the case. CSV: a line for every pair "
        "of angles and a heading with the units, angle [deg],loaded [deg],compliance [um/MPa]. NPZ: the arrays "
        "angles (rad) and compliance (m/Pa).",
    )

    @rule
    def _one_source(self) -> Iterator[Issue]:
        yield from exactly_one(self, "values", "file")

    @rule
    def _matrix_is_whole(self) -> Iterator[Issue]:
        if self.values is None:
            return
        if self.angles is None:
            yield Issue(("angles",), "is missing", "one for every row and column of the values", code="E003")
            return
        count = len(self.angles)
        if len(self.values) != count:
            yield Issue(("values",), f"{len(self.values)} rows for {count} angles", "a row for every angle")
        for number, row in enumerate(self.values):
            if len(row) != count:
                says = f"{len(row)} values for {count} angles"
                yield Issue(("values", number), says, "a value for every angle")
        rising = all(after > before for before, after in pairwise(self.angles))
        if not rising or self.angles[-1] - self.angles[0] >= 2.0 * math.pi * (1.0 - 1e-9):
            yield Issue(("angles",), "the angles do not rise once around", "rising, less than one turn in all")

    def compliance(self, diameter: float) -> Compliance:
        """Give the compliance of the film."""
        from babbitt.reynolds.deformation.compliance_matrix import ComplianceMatrix

        if self.angles is None or self.values is None:
            raise ValueError("a case that was not validated: the compliance has no matrix")
        return ComplianceMatrix(self.angles, self.values)


ComplianceInput = Annotated[ColumnInput | RingInput | HalfSpaceInput | MatrixInput, Discriminator("kind")]


def issues_of_compliance(parts: tuple[ComplianceInput, ...], diameter: float) -> Iterator[Issue]:
    """Complain about rings that end inside the bore."""
    for index, part in enumerate(parts):
        if isinstance(part, RingInput) and part.outer_diameter <= diameter * (1.0 + 1e-6):
            says = f"the ring ends at {written(part.outer_diameter, 'mm')}, inside the bore"
            yield Issue(("compliance", index, "outer_diameter"), says, f"more than {written(diameter, 'mm')}")


__all__ = ["ComplianceInput", "issues_of_compliance"]
