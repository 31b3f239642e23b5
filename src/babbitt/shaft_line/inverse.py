"""What a line can bear: the largest runout, tilt and ripple within a loss, the ring for a wanted film or load."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from babbitt.design.roots import bracketed_root
from babbitt.shaft_line.model import LineDuty, state_of
from babbitt.shaft_line.sweeps import RingPoint, ring_point
from babbitt.thrust.carrying import Carrying
from babbitt.thrust.failures import NoPadFilmError
from babbitt.thrust.sharing import share_of

__all__ = [
    "Admissible",
    "admissible",
    "largest_ripple",
    "largest_runout",
    "largest_tilt",
    "ring_for_film_amplitude",
    "ring_for_loss",
]

WIDEST = 2.0**12
"""Factor up to which a root is sought."""
RELATIVE = 1e-9
BEYOND = 1e6
"""Loss that stands for a bearing without a film."""


@dataclass(frozen=True)
class Admissible:
    """Largest amplitudes that keep a loss, each with the others as they are; None where none does.

    Attributes
    ----------
    runout : float or None
        Of the face at the pivot radius, m.
    tilt : float or None
        Of the housing at the outer radius of the pads, m.
    ripple : float or None
        Of the thrust, N.
    """

    runout: float | None
    tilt: float | None
    ripple: float | None


def admissible(duty: LineDuty, films: Carrying, loss: float) -> Admissible:
    """Largest runout, tilt and ripple that keep L1 (bound) at or below ``loss``."""
    return Admissible(
        largest_runout(duty, films, loss), largest_tilt(duty, films, loss), largest_ripple(duty, films, loss)
    )


def largest_runout(duty: LineDuty, films: Carrying, loss: float) -> float | None:
    """Amplitude of the first runout harmonic, m; None without runout or where even none is too much."""
    if not duty.runout:
        return None
    share = share_of(films, duty.bearing, duty.thrust)
    factor = _largest(lambda f: state_of(duty.with_runout(f), films, share).losses.mean_bound, loss)
    return None if factor is None else factor * duty.runout


def largest_ripple(duty: LineDuty, films: Carrying, loss: float) -> float | None:
    """Amplitude of the first thrust harmonic, N."""
    if not duty.ripple:
        return None
    share = share_of(films, duty.bearing, duty.thrust)
    factor = _largest(lambda f: state_of(duty.with_ripple(f), films, share).losses.mean_bound, loss)
    return None if factor is None else factor * duty.ripple


def largest_tilt(duty: LineDuty, films: Carrying, loss: float) -> float | None:
    """Offset of the housing at the outer radius, m."""
    scale = duty.bearing.tilt.offset or films.height_for(duty.thrust / duty.bearing.number)
    factor = _largest(lambda f: _loss_at(duty.with_tilt(f * scale), films), loss)
    return None if factor is None else factor * scale


def _loss_at(duty: LineDuty, films: Carrying) -> float:
    """L1 (bound); without a film more than any limit, so that what is admissible ends there."""
    try:
        return state_of(duty, films).losses.mean_bound
    except NoPadFilmError:
        return BEYOND


def _largest(of: Callable[[float], float], limit: float) -> float | None:
    """Largest factor from 0 up to which a growing loss keeps its limit."""
    if of(0.0) > limit:
        return None
    high = 1.0
    while of(high) <= limit:
        high *= 2.0
        if high > WIDEST:
            return None
    return bracketed_root(lambda f: of(f) - limit, 0.0, high, relative=RELATIVE)


def ring_for_loss(duty: LineDuty, films: Carrying, loss: float, rings: tuple[float, ...]) -> RingPoint | None:
    """The stiffest ring on which L1 (bound) falls to ``loss``; None where no ring among ``rings`` reaches it.

    Parameters
    ----------
    duty : LineDuty
    films : Carrying
    loss : float
    rings : tuple of float
        Stiffnesses between which it is sought, N/m.
    """
    return _stiffest(duty, films, rings, lambda point: point.bound - loss)


def ring_for_film_amplitude(
    duty: LineDuty, films: Carrying, amplitude: float, rings: tuple[float, ...]
) -> RingPoint | None:
    """The stiffest ring on which the film amplitude from runout falls to ``amplitude`` (m)."""
    return _stiffest(duty, films, rings, lambda point: point.film_amplitude - amplitude)


def _stiffest(
    duty: LineDuty, films: Carrying, rings: tuple[float, ...], excess: Callable[[RingPoint], float]
) -> RingPoint | None:
    stiff: RingPoint | None = None
    for ring in sorted(rings, reverse=True):
        try:
            point = ring_point(duty, films, ring)
        except NoPadFilmError:
            continue
        if excess(point) <= 0.0:
            if stiff is None:
                return point
            root = bracketed_root(
                lambda c: excess(ring_point(duty, films, c)), ring, stiff.stiffness, relative=1e-6
            )
            return ring_point(duty, films, root)
        stiff = point
    return None
