"""What an engineer writes of a plane slider."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.part import Issue, rule
from babbitt.case.parts.fields import Name, Prose
from babbitt.core.solution import Calculation
from babbitt.core.units import si
from plane_slider.choices import METHOD_MAPPING, QuadratureChoices
from plane_slider.method import ClosedForm, Quadrature, Slider


class PlaneSliderCase(QuadratureChoices, CaseFile):
    """A plane slider of infinite width."""

    kind: Literal["plane_slider"] = Field(description="Plane slider bearing of infinite width.")
    name: Name = Field(description="Name of the slider.")
    length: Annotated[float, si("m", "1 mm", "1 m")] = Field(description="Length along the motion.")
    width: Annotated[float, si("m", "1 mm", "5 m")] = Field(description="Width across the motion.")
    inlet_film: Annotated[float, si("m", "1 um", "1 mm")] = Field(description="Film thickness at the inlet.")
    outlet_film: Annotated[float, si("m", "1 um", "1 mm")] = Field(description="Film thickness at the outlet.")
    speed: Annotated[float, si("m/s", "1 mm/s", "100 m/s")] = Field(description="Speed of the runner.")
    viscosity: Annotated[float, si("Pa s", "0.1 mPa s", "10 Pa s")] = Field(description="Dynamic viscosity.")
    least_film: Annotated[float, si("m", "1 um", "1 mm")] | None = Field(
        None, description="Least permissible film thickness; without it there is no verdict."
    )
    method: Annotated[Literal["closed_form", "quadrature"], METHOD_MAPPING] = Field(
        "closed_form", description="How the film is solved."
    )
    assumptions: tuple[Prose, ...] = Field((), description="Assumptions to be shown in the report.")
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    @rule
    def _the_film_narrows(self) -> Iterator[Issue]:
        if self.inlet_film <= self.outlet_film:
            says = "the film does not narrow along the motion, so that it carries nothing"
            yield Issue(("inlet_film",), says, "more than outlet_film", "exchange the two")

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the one calculation of the file."""
        slider = Slider(
            self.name, self.length, self.width, self.inlet_film, self.outlet_film, self.speed, self.viscosity,
            self.least_film, warnings=tuple(about_grouped_digits(self)), assumptions=self.assumptions,
        )  # fmt: skip
        return (Calculation(slider, ClosedForm() if self.method == "closed_form" else Quadrature(self.cells)),)
