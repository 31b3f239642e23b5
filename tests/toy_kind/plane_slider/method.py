"""The closed form of the plane slider of infinite width (Cameron, Principles of Lubrication, 1966)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from babbitt.core.notices import Notice
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Method, Solution

STEEP = 5.0
"""Ratio of the films above which the load is less than two thirds of the largest."""


@dataclass(frozen=True)
class Slider:
    """A plane slider: lengths in m, speed in m/s, viscosity in Pa s."""

    name: str
    length: float
    width: float
    inlet_film: float
    outlet_film: float
    speed: float
    viscosity: float
    least_film: float
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()
    kind: str = "plane_slider"


def load_number(ratio: float) -> float:
    """Load over ``6 eta U B L^2 / h_out^2`` of a slider with ``ratio`` = h_in / h_out."""
    return (math.log(ratio) - 2.0 * (ratio - 1.0) / (ratio + 1.0)) / (ratio - 1.0) ** 2


@dataclass(frozen=True)
class ClosedForm(Method):
    """Reynolds equation in one dimension, integrated by hand."""

    name: ClassVar[str] = "closed_form"

    def solve(self, problem: Slider, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the load that the film carries."""
        ratio = problem.inlet_film / problem.outlet_film
        scale = (
            6.0 * problem.viscosity * problem.speed * problem.width * (problem.length / problem.outlet_film) ** 2
        )
        values = {
            "film_ratio": ratio,
            "load": scale * load_number(ratio),
            "minimum_film_thickness": problem.outlet_film,
        }
        thin = Check(
            "C101", "minimum_film_thickness", problem.outlet_film, problem.least_film, Bound.AT_LEAST, "given"
        )
        steep = (Notice("X101", values={"film_ratio": ratio}),) if ratio > STEEP else ()
        result = Result(problem.name, problem.kind, self.name, Outcome.CONVERGED, values, (thin,), warnings=steep)
        return (Solution(problem, result),)


CLOSED_FORM = ClosedForm()
