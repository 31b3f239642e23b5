"""Who takes which part: the causes of the dynamic load, and the stages of the published study.

I. N. Sidorika, Eastern-European Journal of Enterprise Technologies 4/7 (70), 2014.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from babbitt.kinds.shaft_line.model import LineOperation, LineState, state_of
from babbitt.kinds.thrust.load_curve import LoadCurve

__all__ = ["Attribution", "Stage", "attribution", "stages"]


@dataclass(frozen=True)
class Attribution:
    """L1 with the bound, of which cause: loss with all, and what is lost without each.

    Attributes
    ----------
    total : float
    runout, ripple : float
        Of each alone.
    tilt : float
        With less without the tilt of the housing and pad heights.
    elasticity : float
        Elastic less rigid shaft.
    """

    total: float
    runout: float
    ripple: float
    tilt: float
    elasticity: float


def attribution(state: LineState) -> Attribution:
    """Attribute the largest dynamic load of a line."""
    duty = state.duty
    level = replace(duty, bearing=replace(duty.bearing, height_errors=())).with_tilt(0.0)
    return Attribution(
        total=state.losses.mean_bound,
        runout=state.loss_of(runout=True),
        ripple=state.loss_of(runout=False),
        tilt=state.losses.mean_bound - state_of(level, state.films).losses.mean_bound,
        elasticity=state.losses.mean_bound - state_of(duty.rigid(), state.films, state.share).losses.mean_bound,
    )


@dataclass(frozen=True)
class Stage:
    """One stage of the study: its name and the state computed."""

    name: str
    state: LineState


def stages(duty: LineOperation, films: LoadCurve) -> tuple[Stage, ...]:
    """1a runout, 1b propeller, 1c both on a point mass; 2 adds tilt, 3 the elastic shaft, 3d propeller damping."""
    undamped = replace(duty, line=replace(duty.line, propeller_damping=0.0))
    level = undamped.with_tilt(0.0).rigid()
    made = {
        "1a": replace(level, thrusts=()),
        "1b": replace(level, runouts=()),
        "1c": level,
        "2": undamped.rigid(),
        "3": undamped,
        "3d": duty,
    }
    return tuple(Stage(name, state_of(of, films)) for name, of in made.items())
