"""What a shaft line is computed from, and its state at one speed."""

from __future__ import annotations

from dataclasses import dataclass, replace

from babbitt.kinds.shaft_line.excitation import RunoutHarmonic, ThrustHarmonic
from babbitt.kinds.shaft_line.forced import Forced, forced
from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.losses import FilmCheck, Losses, film_check, losses_of, moment_amplitude
from babbitt.kinds.shaft_line.pads import FilmPads
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.sharing import Share, share_of

__all__ = ["LineOperation", "LineState", "state_of"]


@dataclass(frozen=True)
class LineOperation:
    """A line, its bearing and what shakes them; the oil stands with the films.

    Attributes
    ----------
    line : ShaftLine
    bearing : ThrustBearing
    thrust : float
        F0, N.
    speed : float
        rad/s, positive.
    thrusts : tuple of ThrustHarmonic
    runouts : tuple of RunoutHarmonic
    """

    line: ShaftLine
    bearing: ThrustBearing
    thrust: float
    speed: float
    thrusts: tuple[ThrustHarmonic, ...] = ()
    runouts: tuple[RunoutHarmonic, ...] = ()

    def with_ring(self, stiffness: float) -> LineOperation:
        """On another backing ring, N/m per pad."""
        return replace(self, bearing=replace(self.bearing, ring_stiffness=stiffness))

    def with_tilt(self, offset: float) -> LineOperation:
        """With another tilt of the housing, m at the outer radius; by itself towards the highest pad."""
        bearing = self.bearing
        tilt = replace(bearing.tilt, offset=offset)
        if bearing.tilt.offset == 0.0 and bearing.tilt.direction == 0.0 and bearing.height_errors:
            highest = bearing.height_errors.index(max(bearing.height_errors))
            tilt = replace(tilt, direction=float(bearing.angles[highest]))
        return replace(self, bearing=replace(bearing, tilt=tilt))

    def with_runout(self, factor: float) -> LineOperation:
        """With all runout amplitudes times a factor."""
        return replace(self, runouts=tuple(part.scaled(factor) for part in self.runouts))

    def with_ripple(self, factor: float) -> LineOperation:
        """With all thrust amplitudes times a factor."""
        return replace(self, thrusts=tuple(part.scaled(factor) for part in self.thrusts))

    def rigid(self) -> LineOperation:
        """With a rigid shaft of the same mass (stages 1 and 2)."""
        return replace(self, line=self.line.rigid())

    def at_speed(self, speed: float) -> LineOperation:
        """At another speed; thrust and ripple grow with its square, as propellers of one pitch have it."""
        factor = (speed / self.speed) ** 2
        return replace(self, speed=speed, thrust=self.thrust * factor).with_ripple(factor)

    @property
    def runout(self) -> float:
        """Amplitude of the first runout harmonic, m; 0 for none."""
        return self.runouts[0].amplitude if self.runouts else 0.0

    @property
    def ripple(self) -> float:
        """Amplitude of the first thrust harmonic, N; 0 for none."""
        return self.thrusts[0].amplitude if self.thrusts else 0.0


@dataclass(frozen=True, eq=False)
class LineState:
    """Static share, forced vibration and losses of a line.

    Attributes
    ----------
    duty : LineOperation
    films : LoadCurve
    share : Share
    pads : FilmPads
    forced : Forced
    losses : Losses
    film : FilmCheck
    """

    duty: LineOperation
    films: LoadCurve
    share: Share
    pads: FilmPads
    forced: Forced
    losses: Losses
    film: FilmCheck

    @property
    def frequencies(self) -> tuple[float, ...]:
        """Of the excitations, rad/s."""
        return tuple(part.response.frequency for part in self.forced.parts)

    @property
    def runout_film_amplitude(self) -> float:
        """Largest amplitude of the film at a pivot from runout alone, m; 0 without runout."""
        gaps = [abs(gap) for part in self.forced.parts if part.is_runout for gap in part.response.gaps]
        return float(max(gaps, default=0.0))

    def loss_of(self, runout: bool) -> float:
        """L1 of runout alone, or of thrust ripple alone."""
        return float(self.forced.bounds_of(runout).max() / self.share.mean_load)

    @property
    def moment_amplitude(self) -> float:
        """Bound of the dynamic moment on the collar square to the shaft, N m: sum over the harmonics."""
        return sum(moment_amplitude(self.share, part) for part in self.forced.parts)

    @property
    def worst_turn_loss(self) -> float:
        """L1 at the angle of the propeller on the shaft at which it is largest."""
        return self.forced.worst_turn()[1] / self.share.mean_load


def state_of(duty: LineOperation, films: LoadCurve, share: Share | None = None) -> LineState:
    """Solve a line at one speed.

    Parameters
    ----------
    duty : LineOperation
    films : LoadCurve
        Of one pad, in the oil and at the speed of the duty.
    share : Share, optional
        Static share where it is known already.

    Raises
    ------
    InputError
        See `share_of` and `forced`.
    """
    share = share if share is not None else share_of(films, duty.bearing, duty.thrust)
    pads = FilmPads(share)
    answer = forced(duty.line, pads, duty.speed, duty.thrusts, duty.runouts)
    if not answer.parts:
        answer = forced(duty.line, pads, duty.speed, (ThrustHarmonic(1.0, 0.0),), ())
    return LineState(duty, films, share, pads, answer, losses_of(share, answer), film_check(share, answer))
