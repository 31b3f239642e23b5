"""What the search for a thermal film knows of the last one."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from babbitt.kinds.journal.film.closed_pockets import ClosedPressures

if TYPE_CHECKING:
    from babbitt.reynolds.heat.following_clearance import FollowingClearance
    from babbitt.reynolds.heat.thermal_continuation import ThermalTrail

__all__ = ["ThermalSearch"]

EXACT = 1e-5
"""Change of temperature in a pass, K, at which films converge whose flows are compared with one another."""


@dataclass
class ThermalSearch:
    """What the search for a film knows of the last one.

    Attributes
    ----------
    attitude : float or None
        Attitude angle, rad, near which the next one is sought.
    closer : bool
        Whether films at a given place settle closer: films that still warm would make the clearance wander for
        ever.
    closed : ClosedPressures
        Pressures of closed pockets, from which the next ones are sought.
    exact : bool
        Whether films at a given place settle so closely that the net flow of a pocket tells its pressure.
    climbs : bool
        Whether films are sought from the last one alone, see
        `babbitt.reynolds.heat.thermal_continuation.ThermalTrail.climb`.
    growth : FollowingClearance or None
        What the clearance of a first film follows.
    """

    attitude: float | None = None
    closer: bool = False
    climbs: bool = False
    closed: ClosedPressures = field(default_factory=ClosedPressures)
    exact: bool = False
    growth: FollowingClearance | None = None
    _trail: ThermalTrail | None = None

    @property
    def trail(self) -> ThermalTrail:
        """Of the films under a load so far."""
        if self._trail is None:
            from babbitt.reynolds.heat.thermal_continuation import ThermalTrail

            self._trail = ThermalTrail()
        return self._trail

    @property
    def is_fresh(self) -> bool:
        """Whether nothing was sought yet."""
        return self._trail is None

    def climbing(self) -> ThermalSearch:
        """Another search, which climbs from the last film of this one."""
        return replace(self, climbs=True, _trail=replace(self.trail), closed=replace(self.closed))

    @property
    def settled(self) -> float:
        """Change of temperature in a pass, K, at which a film at a given place has converged."""
        from babbitt.reynolds.heat.thermal_passes import CLOSER, SETTLED

        if self.exact:
            return EXACT
        return CLOSER if self.closer else SETTLED
