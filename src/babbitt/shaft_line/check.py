"""Design check of a shaft line: losses, films, frequencies, causes, and what would help."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from time import perf_counter

from babbitt.notices import Notice
from babbitt.results import Bound, Check, Matrix, Outcome, Result
from babbitt.shaft_line.damped import DampedMode, damped_modes
from babbitt.shaft_line.design import LineDesign
from babbitt.shaft_line.inverse import Admissible, admissible, ring_for_loss
from babbitt.shaft_line.losses import LINEAR_UP_TO, separation
from babbitt.shaft_line.model import LineState, state_of
from babbitt.shaft_line.natural import Mode, modes, undamped_frequencies
from babbitt.shaft_line.stages import Attribution, attribution
from babbitt.shaft_line.sweeps import CampbellPoint, RingPoint, barred_ranges, ring_sweep, speed_sweep, usual_rings
from babbitt.shaft_line.transient import Transient, transient
from babbitt.thrust.assumed import oil_assumptions
from babbitt.thrust.check import pad_arrays, share_doubts, share_values, temperature_not_checked
from babbitt.thrust.design import ThrustState, operating_state
from babbitt.thrust.failures import NoPadFilmError

__all__ = ["LineAnswer", "line_answer", "line_check"]

METHOD = "frequency domain"
MODES = 4
RINGS = 40
NEAR = 0.2
"""Relative distance from a natural frequency that is advised, as for other shaft vibration."""
SEPARATION_SOURCE = "usual practice for shaft vibration: 20 % from any excitation"


@dataclass(frozen=True, eq=False)
class LineAnswer:
    """All that is computed of a line.

    Attributes
    ----------
    static : ThrustState
    state : LineState
    modes : tuple of Mode
    damped : tuple of DampedMode
    causes : Attribution
    bearable : Admissible
    rings : tuple of RingPoint
        From soft to stiff.
    half : RingPoint or None
        The stiffest ring that halves the dynamic load.
    campbell : tuple of CampbellPoint
    nonlinear : Transient or None
    """

    static: ThrustState
    state: LineState
    modes: tuple[Mode, ...]
    damped: tuple[DampedMode, ...]
    causes: Attribution
    bearable: Admissible
    rings: tuple[RingPoint, ...]
    half: RingPoint | None
    campbell: tuple[CampbellPoint, ...]
    nonlinear: Transient | None

    @property
    def best(self) -> RingPoint:
        """The ring with the least dynamic load of the sweep."""
        return min(self.rings, key=lambda point: point.bound)

    @property
    def separation(self) -> float:
        """Least relative distance of an excitation from a natural frequency."""
        pairs = ((nu, mode.frequency) for nu in self.state.frequencies for mode in self.modes)
        return min((separation(nu, natural) for nu, natural in pairs), default=math.inf)


@lru_cache(maxsize=4)
def line_answer(design: LineDesign) -> LineAnswer:
    """Solve a line with all that its report says.

    Raises
    ------
    InputError
        E202, E203, E204: see `state_of`.
    NoPadFilmError
    """
    static = operating_state(design.thrust)
    duty, films = design.duty, static.films
    state = state_of(duty, films, static.share)
    highest = max(state.frequencies, default=0.0)
    known = max(
        MODES, len(undamped_frequencies(design.line, state.pads, highest=1.25 * highest)) if highest else 0
    )
    rings = usual_rings(duty, state, RINGS)
    return LineAnswer(
        static=static,
        state=state,
        modes=modes(design.line, state.pads, min(known, 12)),
        damped=damped_modes(design.line, state.pads, MODES),
        causes=attribution(state),
        bearable=admissible(duty, films, design.loss_limit),
        rings=ring_sweep(duty, films, rings),
        half=ring_for_loss(duty, films, 0.5 * state.losses.mean_bound, rings[::3]),
        campbell=speed_sweep(duty, design.films_at, design.speeds),
        nonlinear=transient(state) if design.nonlinear else None,
    )


def line_check(design: LineDesign) -> Result:
    """Check a shaft line.

    Parameters
    ----------
    design : LineDesign

    Returns
    -------
    Result
        With a status in every case.
    """
    start = perf_counter()
    try:
        answer = line_answer(design)
    except NoPadFilmError as failure:
        return Result(design.name, design.kind, METHOD, failure.outcome, {}, message=failure.said)
    values = _values(design, answer)
    values["wall_time"] = perf_counter() - start
    thrust = design.thrust
    return Result(
        design.name,
        design.kind,
        METHOD,
        Outcome.CONVERGED,
        values,
        tuple(_checks(design, answer, values)),
        (*thrust.doubts, *share_doubts(thrust, answer.static), *_doubts(answer), *_beside_the_map(design)),
        (*_not_checked(design), temperature_not_checked(values)),
        (*design.lubricant.assumptions, *thrust.assumptions, *_assumptions(design)),
        settings={
            "lubricant": design.lubricant.name,
            "pivot": thrust.bearing.pad.pivot.value,
            "rods": str(len(design.line.rods)),
        },
        arrays=_arrays(design, answer),
    )


def _values(design: LineDesign, answer: LineAnswer) -> dict[str, float]:
    state, losses = answer.state, answer.state.losses
    values = share_values(design.thrust, answer.static)
    values |= {
        "loss_mean_bound": losses.mean_bound,
        "loss_mean_peak": losses.mean_peak,
        "loss_mean_worst_turn": state.worst_turn_loss,
        "loss_own_bound": losses.own_bound,
        "loss_own_peak": losses.own_peak,
        "unload_margin_bound": losses.margin_bound,
        "unload_margin_peak": losses.margin_peak,
        "dynamic_minimum_film": float(state.film.thinnest_bound.min()),
        "dynamic_minimum_film_peak": float(state.film.thinnest.min()),
        "relative_film_amplitude": float(state.film.relative.max()),
        "collar_moment_amplitude": state.moment_amplitude,
        "runout_share": answer.causes.runout,
        "ripple_share": answer.causes.ripple,
        "tilt_share": answer.causes.tilt,
        "elasticity_share": answer.causes.elasticity,
        **{f"natural_frequency_{n}": mode.frequency for n, mode in enumerate(answer.modes[:MODES], start=1)},
    }
    if answer.damped:
        values["damping_ratio_1"] = answer.damped[0].damping_ratio
    if math.isfinite(answer.separation):
        values["frequency_separation"] = answer.separation
    bearable = {
        "admissible_runout": answer.bearable.runout,
        "admissible_tilt": answer.bearable.tilt,
        "admissible_ripple": answer.bearable.ripple,
    }
    values |= {name: value for name, value in bearable.items() if value is not None}
    if answer.half is not None:
        values["half_load_ring_stiffness"] = answer.half.stiffness
    values |= {"best_ring_stiffness": answer.best.stiffness, "best_ring_loss": answer.best.bound}
    if answer.nonlinear is not None:
        moved = answer.nonlinear
        values |= {
            "nonlinear_load_peak": float(moved.load_peaks.max()),
            "nonlinear_unload_peak": float(moved.unload_peaks.max()),
            "nonlinear_minimum_film": float(moved.thinnest.min()),
            "mean_film_shift": float(moved.film_shift.max()),
        }
    return values


def _checks(design: LineDesign, answer: LineAnswer, values: dict[str, float]) -> Iterator[Check]:
    yield Check(
        "C201",
        "loss_mean_bound",
        values["loss_mean_bound"],
        design.loss_limit,
        Bound.AT_MOST,
        design.loss_limit_source,
    )
    yield Check(
        "C202",
        "dynamic_minimum_film",
        values["dynamic_minimum_film"],
        design.thrust.film_limit,
        Bound.AT_LEAST,
        design.thrust.film_limit_source,
    )
    yield Check(
        "C203",
        "unload_margin_bound",
        values["unload_margin_bound"],
        0.0,
        Bound.AT_LEAST,
        "a film cannot pull: below zero the pad leaves the collar",
    )
    if "frequency_separation" in values:
        yield Check(
            "C204",
            "frequency_separation",
            values["frequency_separation"],
            NEAR,
            Bound.AT_LEAST,
            SEPARATION_SOURCE,
            advisory=True,
        )


def _doubts(answer: LineAnswer) -> Iterator[Notice]:
    state = answer.state
    relative = float(state.film.relative.max())
    if relative > LINEAR_UP_TO:
        yield Notice(
            "W202",
            f"film amplitude {relative:.2f} of the static film at pad "
            f"{1 + int(state.film.relative.argmax())} > {LINEAR_UP_TO:g}",
        )
    for nu in state.frequencies:
        for place, mode in enumerate(answer.modes, start=1):
            away = separation(nu, mode.frequency)
            if away < NEAR:
                yield Notice(
                    "W203",
                    f"excitation {nu / math.tau:.2f} Hz is {away:.0%} away from natural frequency "
                    f"{place}, {mode.frequency / math.tau:.2f} Hz",
                )
    moved = answer.nonlinear
    if moved is not None:
        unloaded, closest = 1 + int(moved.lifted.argmax()), 1 + int(moved.thinnest.argmin())
        for happens, said in (
            (
                moved.lifts_off,
                f"pad {unloaded} carries nothing during {moved.lifted.max():.0%} of the revolution at most; from "
                f"one revolution to the next loads differ by {moved.steady:.1%} of the largest dynamic one",
            ),
            (moved.touches, f"a corner of pad {closest} comes as close as {moved.thinnest.min() * 1e6:.2f} µm"),
            (moved.outside, "tilts leave the tabulated films"),
        ):
            if happens:
                yield Notice("W205", said)


def _beside_the_map(design: LineDesign) -> Iterator[Notice]:
    speeds, speed = design.speeds, design.thrust.speed
    if speeds and not min(speeds) <= speed <= max(speeds):
        low, at, high = (one * 30.0 / math.pi for one in (min(speeds), speed, max(speeds)))
        yield Notice("W206", f"speed {at:.0f} rpm, map from {low:.0f} to {high:.0f} rpm")


def _not_checked(design: LineDesign) -> tuple[Notice, ...]:
    if design.thrusts or design.runouts:
        return ()
    return (Notice("C201", "neither thrust ripple nor runout is given"),)


def _arrays(design: LineDesign, answer: LineAnswer) -> dict[str, Matrix]:
    state = answer.state
    forced = state.forced
    arrays = pad_arrays(state.share, design.thrust.speed)
    rows = {
        "runout_force": forced.bounds_of(runout=True),
        "ripple_force": forced.bounds_of(runout=False),
        "dynamic_peak": forced.peaks(),
        "dynamic_bound": forced.bounds(),
        "pad_dynamic_film": state.film.thinnest_bound,
    }
    arrays |= {name: (tuple(float(one) for one in row),) for name, row in rows.items()}
    arrays["damped_modes"] = tuple((mode.frequency, mode.damping_ratio) for mode in answer.damped)
    arrays["ring_sweep"] = tuple(
        (
            p.stiffness,
            p.runout,
            p.ripple,
            p.bound,
            p.film_amplitude,
            p.thinnest_film,
            p.first_frequency,
            p.largest_over_mean,
        )
        for p in answer.rings
    )
    if answer.campbell:
        arrays["campbell"] = tuple((p.speed, p.state.losses.mean_bound, *p.frequencies) for p in answer.campbell)
        if barred := barred_ranges(answer.campbell):
            arrays["barred_ranges"] = barred
    return arrays


def _assumptions(design: LineDesign) -> Iterator[str]:
    yield "Linear films about the static share, tilts of the pads free and with their inertia; axial motion only."
    yield from oil_assumptions(design.thrust.oil)
    if design.thrust.oil.warm is not None:
        yield "Each pad takes in what a pad under its own load sends off, mixed with fresh oil."
    if design.line.seating is None:
        yield "The seating is rigid: a flexible one lowers the first frequency, typically by a fifth at 2 GN/m."
    if design.speeds:
        yield "Over speed, thrust and ripple grow with its square; runout and tilt stay."
