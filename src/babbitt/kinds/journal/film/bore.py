"""The form of the bore on each land: round, lobed, tapered, worn, measured."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

from babbitt.reynolds.model import Land, Step

__all__ = [
    "Bore",
    "LobedBore",
    "MeasuredBore",
    "PressureDamBore",
    "RoundBore",
    "TaperedBore",
    "WornBore",
    "steps_of",
]

SAMPLES = 721
"""Points at which the departure of a land from its circle is described."""

TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Arc:
    """A land to be shaped: its edges in rad, its assembled radial clearance in m, its edge pressures in Pa.

    `sense` is 1 where the journal turns counter-clockwise, -1 otherwise.
    """

    start: float
    end: float
    clearance: float
    pressures: tuple[float, float]
    sense: float

    def land(
        self,
        clearance: float | None = None,
        centre: tuple[float, float] = (0.0, 0.0),
        profile: tuple[float, ...] = (),
    ) -> Land:
        """Give the land of the film."""
        return Land(self.start, self.end, clearance or self.clearance, centre, *self.pressures, profile)

    def angles(self) -> tuple[float, ...]:
        """Equally spaced angles from edge to edge, rad."""
        step = (self.end - self.start) / (SAMPLES - 1)
        return tuple(self.start + step * place for place in range(SAMPLES))


class Bore(Protocol):
    """Shapes a land."""

    def shaped(self, arc: Arc) -> Land: ...  # noqa: D102


@dataclass(frozen=True)
class RoundBore:
    """A circle of the assembled clearance."""

    def shaped(self, arc: Arc) -> Land:
        """Leave the land round."""
        return arc.land()


@dataclass(frozen=True)
class LobedBore:
    """Every land is a lobe of a larger circle (lemon, three- and four-lobe bores, offset halves).

    Attributes
    ----------
    preload : float
        m = 1 - c/c_l with c the clearance of the assembled bearing and c_l that of the lobe.
    offset : float
        Where on the lobe the assembled clearance is, from 0 (leading edge) to 1 (trailing edge, offset halves).
    """

    preload: float
    offset: float = 0.5

    def shaped(self, arc: Arc) -> Land:
        """Draw the lobe: its centre stands c_l m beyond the bearing centre, away from the narrowest place."""
        clearance = arc.clearance / (1.0 - self.preload)
        share = self.offset if arc.sense > 0.0 else 1.0 - self.offset
        narrowest = arc.start + share * (arc.end - arc.start)
        away = -self.preload * clearance
        return arc.land(clearance, (away * math.cos(narrowest), away * math.sin(narrowest)))


@dataclass(frozen=True)
class PressureDamBore(RoundBore):
    """A round bore with a recess that ends in a dam, and opposite, or nowhere, a track that relieves the film.

    Attributes
    ----------
    angle : float
        Direction of the dam, rad: the edge at which the recess ends and against which the journal drags the oil.
    extent : float
        Of the recess before the dam, rad.
    width, depth : float
        Of the recess, m.
    relief : Step or None
        Track around the middle of the loaded land.
    """

    angle: float
    extent: float
    width: float
    depth: float
    relief: Step | None = None

    def steps(self, sense: float) -> tuple[Step, ...]:
        """Recess and track in the film of a journal that turns counter-clockwise (1) or clockwise (-1)."""
        recess = Step(self.angle - 0.5 * sense * self.extent, self.extent, self.width, self.depth)
        return (recess,) if self.relief is None else (recess, self.relief)


def steps_of(bore: Bore, sense: float) -> tuple[Step, ...]:
    """Steps that belong to the form of a bore; `sense` is 1 where the journal turns counter-clockwise."""
    return bore.steps(sense) if isinstance(bore, PressureDamBore) else ()


@dataclass(frozen=True)
class TaperedBore:
    """Every land is cut back by `depth` (m) at its leading edge, falling to nothing over a `share` of the land."""

    depth: float
    share: float

    def shaped(self, arc: Arc) -> Land:
        """Cut the taper."""
        last = SAMPLES - 1
        ramp = [self.depth * max(0.0, 1.0 - place / (self.share * last)) for place in range(SAMPLES)]
        return arc.land(profile=tuple(ramp if arc.sense > 0.0 else reversed(ramp)))


@dataclass(frozen=True)
class WornBore:
    """A bore into which the journal has worn itself: an arc of the journal, `depth` (m) deep at `angle` (rad).

    Notes
    -----
    ``δ(φ) = d - c (1 - cos φ)`` where positive, φ from the deepest place. Source: Dufrane, Kannel, McCloskey,
    Wear of steam turbine journal bearings at low operating speeds, J. Lubrication Technology 105 (1983)
    313-317, model of abrasive wear.
    """

    depth: float
    angle: float

    def shaped(self, arc: Arc) -> Land:
        """Wear the land as far as it reaches."""
        worn = (self.depth - arc.clearance * (1.0 - math.cos(angle - self.angle)) for angle in arc.angles())
        return arc.land(profile=tuple(max(0.0, depth) for depth in worn))


@dataclass(frozen=True)
class MeasuredBore:
    """Departures from the circle in m, outward positive, at equal steps once around from `start` (rad)."""

    departures: tuple[float, ...]
    start: float = 0.0

    def shaped(self, arc: Arc) -> Land:
        """Interpolate the departures, which close after a turn."""
        return arc.land(profile=tuple(self.at(angle) for angle in arc.angles()))

    def at(self, angle: float) -> float:
        """Departure at an angle, linear between the points."""
        count = len(self.departures)
        place = ((angle - self.start) % TURN) / TURN * count
        first = int(place) % count
        share = place - int(place)
        return (1.0 - share) * self.departures[first] + share * self.departures[(first + 1) % count]
