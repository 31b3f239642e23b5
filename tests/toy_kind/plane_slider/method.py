"""The plane slider of infinite width, in closed form (Cameron, Principles of Lubrication, 1966) and by numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Method, Solution

STEEP = 5.0
"""Ratio of the films above which the load is less than two thirds of the largest."""


@dataclass(frozen=True)
class Slider:
    """A plane slider: lengths in m, speed in m/s, viscosity in Pa s.

    Its warnings and assumptions are those of the case; every `Solution` puts them into its result.
    """

    name: str
    length: float
    width: float
    inlet_film: float
    outlet_film: float
    speed: float
    viscosity: float
    least_film: float | None = None
    warnings: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()
    kind: str = "plane_slider"


def load_number(ratio: float) -> float:
    """Load over ``6 eta U B L^2 / h_out^2`` of a slider with ``ratio`` = h_in / h_out."""
    return (math.log(ratio) - 2.0 * (ratio - 1.0) / (ratio + 1.0)) / (ratio - 1.0) ** 2


def load_number_by_cells(ratio: float, cells: int) -> float:
    """The same by the trapezoidal rule, from ``dp/dx = (h - h_0) / h^3`` over x from 0 to 1."""
    film = np.linspace(ratio, 1.0, cells + 1)
    where_pressure_peaks = np.trapezoid(film**-2) / np.trapezoid(film**-3)
    slope = (film - where_pressure_peaks) / film**3
    pressure = np.concatenate(([0.0], np.cumsum(0.5 * (slope[1:] + slope[:-1])))) / cells
    return float(np.trapezoid(pressure)) / cells


@dataclass(frozen=True)
class ClosedForm(Method):
    """Reynolds equation in one dimension, integrated by hand."""

    name: ClassVar[str] = "closed_form"

    def solve(self, problem: Slider, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the load that the film carries."""
        return (_solution(problem, self.name, load_number(problem.inlet_film / problem.outlet_film)),)


@dataclass(frozen=True)
class Quadrature(Method):
    """Reynolds equation in one dimension, integrated by the trapezoidal rule."""

    cells: int
    name: ClassVar[str] = "quadrature"

    def solve(self, problem: Slider, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the load that the film carries."""
        number = load_number_by_cells(problem.inlet_film / problem.outlet_film, self.cells)
        return (_solution(problem, self.name, number),)


def _solution(problem: Slider, method: str, number: float) -> Solution:
    """The answer, the check of its film, or why there is none, and a warning."""
    thickness, limit = problem.outlet_film, problem.least_film
    ratio = problem.inlet_film / thickness
    scale = 6.0 * problem.viscosity * problem.speed * problem.width * (problem.length / thickness) ** 2
    values = {"film_ratio": ratio, "load": scale * number, "minimum_film_thickness": thickness}
    checks: tuple[Check, ...] = ()
    if limit is not None:
        checks = (Check("X102", "minimum_film_thickness", thickness, limit, Bound.AT_LEAST, "given"),)
    not_checked = () if checks else (Notice("X102", "not_given"),)
    steep = (Notice("X101", values={"film_ratio": ratio}),) if ratio > STEEP else ()
    result = Result(
        problem.name, problem.kind, method, Outcome.CONVERGED, values, checks, warnings=steep,
        not_checked=not_checked,
    )  # fmt: skip
    return Solution(problem, result)
