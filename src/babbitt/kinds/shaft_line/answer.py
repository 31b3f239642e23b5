"""All that is computed of a shaft line."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from babbitt.core.notices import Notice
from babbitt.kinds.shaft_line.admissible_amplitude import limit_margin
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.shaft_line.inverse import Admissible, admissible, ring_for_loss
from babbitt.kinds.shaft_line.model import LineState, state_of
from babbitt.kinds.shaft_line.natural import Mode, modes
from babbitt.kinds.shaft_line.periodic import NoPeriodicMotionError, PeriodicMotion, periodic_motion
from babbitt.kinds.shaft_line.resonance import Resonances, resonances_of
from babbitt.kinds.shaft_line.stages import Attribution, attribution
from babbitt.kinds.shaft_line.sweeps import CampbellPoint, RingPoint, ring_sweep, speed_sweep, usual_rings
from babbitt.kinds.thrust.design import ThrustState, exact_state
from babbitt.kinds.thrust.pad_attitude import attitude_at_rest
from babbitt.kinds.thrust.thermal_films import ThermalLoadCurve
from babbitt.kinds.thrust.work import WorkBoundError

__all__ = ["MODES", "RINGS", "LineAnswer", "line_answer"]

MODES = 4
RINGS, FEWER_RINGS = 40, 14
"""Rings of the sweep; fewer where every pad needs a film solved by itself, for the sake of time."""


@dataclass(frozen=True, eq=False)
class LineAnswer:
    """All that is computed of a line.

    Attributes
    ----------
    static : ThrustState
    state : LineState
    modes : tuple of Mode
    resonances : Resonances
    causes : Attribution
    bearable : Admissible
    wanted_rings : int
        How many rings were tried.
    rings : tuple of RingPoint
        From soft to stiff.
    half : RingPoint or None
        The stiffest ring that halves the dynamic load.
    campbell : tuple of CampbellPoint
    nonlinear : PeriodicMotion or None
    not_repeating : Notice or None
        Why no nonlinear motion was found; None where one was, or none was asked for.
    """

    static: ThrustState
    state: LineState
    modes: tuple[Mode, ...]
    resonances: Resonances
    causes: Attribution
    bearable: Admissible
    wanted_rings: int
    rings: tuple[RingPoint, ...]
    half: RingPoint | None
    campbell: tuple[CampbellPoint, ...]
    nonlinear: PeriodicMotion | None
    not_repeating: Notice | None

    @property
    def best(self) -> RingPoint | None:
        """The ring with the least dynamic load of the sweep; None where the pads find a film on none."""
        return min(self.rings, key=lambda point: point.bound, default=None)

    @property
    def separation(self) -> float:
        """Least relative distance of an excitation from a resonance; infinite where there is none."""
        return min((one.separation for one in self.resonances.encounters), default=math.inf)


@lru_cache(maxsize=4)
def line_answer(design: LineDesign) -> LineAnswer:
    """Solve a line with all that its report says.

    Raises
    ------
    InputError
        E202, E203, E204: see `state_of`.
    NoPadFilmError
    """
    static = exact_state(design.thrust)
    duty, films = design.duty, static.films
    state = state_of(duty, films, static.share)
    natural = modes(design.line, state.pads, MODES)
    similar = duty.bearing.pad.is_plane and not isinstance(films, ThermalLoadCurve)
    wanted = RINGS if similar and not attitude_at_rest(duty.bearing).is_tilted else FEWER_RINGS
    nonlinear, not_repeating = _nonlinear(state) if design.nonlinear else (None, None)
    bearable = admissible(duty, films, limit_margin(design))
    points = ring_sweep(duty, films, usual_rings(duty, state, wanted))
    return LineAnswer(
        static=static,
        state=state,
        modes=natural,
        resonances=resonances_of(state, natural),
        causes=attribution(state),
        bearable=bearable,
        wanted_rings=wanted,
        rings=points,
        half=ring_for_loss(duty, films, 0.5 * state.losses.mean_bound, points),
        campbell=speed_sweep(duty, design.films_at, design.speeds),
        nonlinear=nonlinear,
        not_repeating=not_repeating,
    )


def _nonlinear(state: LineState) -> tuple[PeriodicMotion | None, Notice | None]:
    try:
        return periodic_motion(state), None
    except NoPeriodicMotionError as failure:
        return None, failure.why
    except WorkBoundError:
        return None, Notice("W210", "work")
