"""What a shaft line is held against, and how far one of its states is from the nearest limit."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping

from babbitt.core.result import Bound, Check
from babbitt.kinds.shaft_line.axial import axial_amplitudes
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.model import LineState
from babbitt.kinds.thrust.design import ThrustState, temperatures_of_share
from babbitt.kinds.thrust.pressure_limits import pressure_checks
from babbitt.kinds.thrust.values import share_values

__all__ = ["Excess", "limit_margin", "limits_of", "motion_values"]

Excess = tuple[float, str]
"""By how much the worst check is missed, over its limit (0 or less: all are kept), and its code."""


def motion_values(state: LineState) -> dict[str, float]:
    """The values of the motion that have limits."""
    return {
        "loss_mean_bound": state.losses.mean_bound,
        "dynamic_minimum_film": float(state.film.thinnest_bound.min()),
        "unload_margin_bound": state.losses.margin_bound,
        "axial_amplitude": axial_amplitudes(state).largest,
    }


def limits_of(design: LineDesign, values: Mapping[str, float]) -> Iterator[Check]:
    """All limits of a line but the distance from resonance.

    Parameters
    ----------
    design : LineDesign
    values : Mapping of str to float
        Those of `motion_values` and of `babbitt.kinds.thrust.values.share_values`.
    """
    thrust = design.thrust
    film = min(("dynamic_minimum_film", "nonlinear_minimum_film"), key=lambda name: values.get(name, math.inf))
    for code, name, limit, bound, source in (
        ("C201", "loss_mean_bound", design.loss_limit, Bound.AT_MOST, design.loss_limit_source),
        ("C202", film, thrust.film_limit, Bound.AT_LEAST, thrust.film_limit_source),
        (
            "C203",
            "unload_margin_bound",
            0.0,
            Bound.AT_LEAST,
            "a film cannot pull: below zero the pad leaves the collar",
        ),
    ):
        yield Check(code, name, values[name], limit, bound, source)
    if design.axial_limit is not None:
        name = "axial_amplitude"
        yield Check("C205", name, values[name], design.axial_limit, Bound.AT_MOST, "given in the case")
    yield from thrust.temperatures.checks(values)
    yield from pressure_checks(thrust.temperatures.given_metal, values)


def limit_margin(design: LineDesign) -> Callable[[LineState], Excess]:
    """Give a function that says by how much a state of the line misses its worst check, advice left aside."""

    def excess(state: LineState) -> Excess:
        static = ThrustState(state.films, state.share, temperatures_of_share(state.films, state.share))
        values = share_values(design.thrust, static) | motion_values(state)
        return max((-check.margin, check.code) for check in limits_of(design, values) if not check.advisory)

    return excess
