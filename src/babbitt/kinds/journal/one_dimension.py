"""What both one-dimensional methods know: the bearing, how a search ended, values and warnings of a long film."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias, TypeVar

from babbitt.core.notices import Notice
from babbitt.core.result import Matrix, Outcome
from babbitt.design.conditions import HousingCooling, Limits, OilSupply, Proportions, Surfaces
from babbitt.design.effective import EffectiveFilm
from babbitt.design.heat_balance import NoFilmError
from babbitt.design.screening import recommended_relative_clearance
from babbitt.design.values import duty_values, limit_values, oil_values
from babbitt.properties.lubricants import Lubricant
from babbitt.properties.materials import BearingMetal, LoadCharacter

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
    from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState
    from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
    from babbitt.kinds.journal.infinitely_long_bearing.state import LongFilmState

    Array = NDArray[np.float64]
    Case: TypeAlias = SegmentCase | LongFilmCase
    State: TypeAlias = SegmentFilmState | LongFilmState

StateT = TypeVar("StateT", "SegmentFilmState", "LongFilmState")

__all__ = [
    "LongBearing", "LongFilmProblem", "long_film_values", "positive", "rows_over_angle", "solved",
    "warnings_about_oil_range", "warnings_about_thickness",
]  # fmt: skip

THICK_FROM = 0.005
"""c/R above which the theory of thin films is questioned."""


@dataclass(frozen=True)
class LongBearing(Proportions):
    """The bearing as a long film sees it; the clearance is that of operation.

    `roughness` is the arithmetic mean roughness Ra of bearing and journal in m, where known.
    """

    diameter: float
    width: float
    relative_clearance: float
    surfaces: Surfaces | None = None
    metal: BearingMetal | None = None
    load_character: LoadCharacter = LoadCharacter.CALM
    clearance_tolerance: tuple[float, float] | None = None
    mean_clearance: float | None = None
    roughness: tuple[float, float] | None = None


@dataclass(frozen=True, kw_only=True)
class LongFilmProblem:
    """One bearing at one operating point, to be computed as a long film."""

    name: str
    bearing: LongBearing
    journal_speed: float
    lubricant: Lubricant
    oil_supply: OilSupply
    load_angle: float = -math.pi / 2.0
    limits: Limits = field(default_factory=Limits)
    given: tuple[tuple[str, str], ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[Notice, ...] = ()
    kind: str = "journal"
    cooling: HousingCooling | None = None
    bearing_speed: float = 0.0
    effective_temperature: float | None = None

    @property
    def clearance(self) -> float:
        """Radial, m."""
        return 0.5 * self.bearing.relative_clearance * self.bearing.diameter


def solved(solve: Callable[[], StateT]) -> tuple[Outcome, float | None, StateT | None]:
    """How a search ended, the largest load reached in N if it was too large, and the film."""
    try:
        state = solve()
    except NoFilmError as error:
        return error.outcome, error.capacity, None
    return (Outcome.CONVERGED if state.converged else Outcome.NOT_CONVERGED), None, state


def long_film_values(case: Case, state: State, temperature: float, flow: float) -> dict[str, float]:
    """Named results that every long film has.

    Parameters
    ----------
    case : SegmentCase or LongFilmCase
    state : SegmentFilmState or LongFilmState
    temperature : float
        Mean over the film, K.
    flow : float
        Through the film, m3/s.
    """
    bearing, power = case.bearing, state.friction_power
    effective = EffectiveFilm.of(case, temperature, bearing.relative_clearance, state.load, power, flow)
    duty = duty_values(case, effective)
    number = state.load * bearing.relative_clearance**2 / (
        bearing.width * bearing.diameter * effective.viscosity * abs(case.journal_speed)
    )  # fmt: skip
    return {
        "diameter": bearing.diameter,
        "width": bearing.width,
        "width_ratio": bearing.width_ratio,
        "relative_clearance": bearing.relative_clearance,
        "operating_relative_clearance": bearing.relative_clearance,
        **duty,
        "angular_speed": case.journal_speed,
        **oil_values(case, effective),
        "sommerfeld_number": number,
        "american_sommerfeld_number": 1.0 / (2.0 * math.pi * number),
        "attitude_angle": state.attitude_angle,
        "minimum_film_thickness": float(state.film_thickness.min()),
        "maximum_pressure": float(state.film_pressure.max()),
        "load_along_eccentricity": state.load_along,
        "load_across_eccentricity": state.load_across,
        "friction_coefficient": power / (state.load * duty["surface_speed"]),
        "friction_power": power,
        "supply_temperature": case.oil_supply.temperature,
        "effective_temperature": temperature,
        "recommended_relative_clearance": recommended_relative_clearance(duty["surface_speed"]),
        **limit_values(case),
    }


def rows_over_angle(fields: Mapping[str, Array]) -> dict[str, Matrix]:
    """Fields over the angle from the widest gap, each as one row."""
    return {name: (tuple(float(one) for one in field),) for name, field in fields.items()}


def positive(film: object, *names: str) -> Iterator[str]:
    """Say which sizes of a film are not above zero, each with its value."""
    for name in names:
        value = getattr(film, name)
        if not 0.0 < value < math.inf:
            yield f"{name} must be above 0, given {value!r}"


def warnings_about_thickness(case: Case) -> Iterator[Notice]:
    """Whether the film is too thick for the theory of thin films; c/R is the relative clearance."""
    ratio = case.bearing.relative_clearance
    if ratio > THICK_FROM:
        yield Notice("W151", values={"ratio": ratio, "limit": THICK_FROM})


def warnings_about_oil_range(case: Case, low: float, high: float, known: tuple[float, float]) -> Iterator[Notice]:
    """Whether a film of temperatures from low to high, K, leaves the range in which its oil is known."""
    coldest, hottest = known
    if low < coldest or high > hottest:
        yield Notice("W107", "film", {
            "low": low, "high": high, "lubricant": case.lubricant.name, "coldest": coldest, "hottest": hottest,
        })  # fmt: skip
