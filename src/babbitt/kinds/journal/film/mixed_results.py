"""What asperities add to the answer of a bearing: the Stribeck curve, its numbers and warnings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from babbitt.core.notices import Notice
from babbitt.core.result import Matrix, Outcome
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.mixed_friction import TRANSITION_SHARE, MixedPoint, StribeckCurve, stribeck_curve
from babbitt.kinds.journal.film.model import FilmCase

__all__ = ["MixedResults", "mixed_assumptions", "mixed_results"]


@dataclass(frozen=True)
class MixedResults:
    """Named results in SI, rows of the curve, warnings; all empty where no asperities are given."""

    values: dict[str, float] = field(default_factory=dict)
    arrays: dict[str, Matrix] = field(default_factory=dict)
    warnings: tuple[Notice, ...] = ()


def mixed_results(case: FilmCase, state: FilmState) -> MixedResults:
    """Follow the journal of the operating point into mixed friction, where the case gives asperities."""
    contact = case.asperities
    if contact is None:
        return MixedResults()
    curve = stribeck_curve(state.solution, contact, case.accuracy.resolution, case.friction_factor)
    values = {"composite_roughness": contact.roughness, "contact_modulus": contact.modulus}
    if curve.points:
        values |= _values(curve, contact.roughness)
    return MixedResults(values, {"stribeck": tuple(map(_row, curve.points))}, tuple(_warnings(curve)))


def _values(curve: StribeckCurve, roughness: float) -> dict[str, float]:
    here, least = curve.operating, curve.least
    known = {} if curve.transition_speed is None else {"asperity_transition_speed": curve.transition_speed}
    return known | {
        "asperity_load_share": here.share,
        "film_parameter": here.asperities.least_gap / roughness,
        "mixed_friction_coefficient": here.friction_coefficient,
        "least_friction_coefficient": least.friction_coefficient,
        "least_friction_speed": least.speed,
    }


def _row(point: MixedPoint) -> tuple[float, ...]:
    """Speed, friction coefficient, its part by the film, share of the asperities, least gap; SI."""
    return (
        point.speed, point.friction_coefficient, point.film_friction, point.share, point.asperities.least_gap
    )  # fmt: skip


def _warnings(curve: StribeckCurve) -> Iterator[Notice]:
    here = curve.operating
    if not here.outcome.solved:
        yield Notice("W137", "no_position")
        return
    if here.share >= TRANSITION_SHARE:
        yield Notice("W137", "share", {"share": here.share})
    slowest = curve.points[0]
    if curve.ended is not None:
        variant = "thin" if curve.ended is Outcome.OVERLOADED else "not_found"
        yield Notice("W138", variant, {"speed": slowest.speed, "share": slowest.share})


def mixed_assumptions(case: FilmCase) -> Iterator[str]:
    """What the mixed branch takes for granted."""
    if case.asperities is None:
        return
    one = case.asperities
    yield (
        "Mixed friction: the film of the Stribeck curve keeps viscosity, clearance and supply pressures of the "
        f"operating point. Asperities after Greenwood and Tripp (η_s β_s σ {one.density:g}, σ/β_s "
        f"{one.sharpness:g}, boundary friction {one.friction:g}) share the load with it, both components of it "
        "balanced; bodies are rigid, the film flows as between smooth surfaces, and friction does not move the "
        "journal."
    )
    yield (
        "All other results are those of the film alone, without asperities: hydrodynamic friction, and limits "
        "held against it."
    )
