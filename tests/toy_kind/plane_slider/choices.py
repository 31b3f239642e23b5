"""The methods of a plane slider and their choices: the mapping `method` of its case."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.method_choices import MethodChoices, MethodInput
from babbitt.case.method_mapping import MethodMapping


class QuadratureChoices(MethodChoices):
    """Choices of the quadrature; a case that inherits them may have them as fields of its own, for sweeps."""

    cells: Annotated[int, Field(ge=2, le=100_000)] = Field(100, description="Cells along the film.")


class ClosedFormInput(MethodInput):
    """The closed form."""

    kind: Literal["closed_form"] = Field(description="The closed form.")


class QuadratureInput(QuadratureChoices, MethodInput):
    """The trapezoidal rule."""

    kind: Literal["quadrature"] = Field(description="The trapezoidal rule.")


METHOD_MAPPING = MethodMapping((ClosedFormInput, QuadratureInput))
