"""What the search for a thermal film knows of the last one."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.bearings.warm_film import FilmState

__all__ = ["CLOSER", "ThermalSearch"]

CLOSER = 1e-3
"""Change of temperature in a pass, K, at which films on lines that stay have settled."""


@dataclass
class ThermalSearch:
    """What the search for a film knows of the last one.

    Attributes
    ----------
    attitude : float or None
        Attitude angle, rad, near which the next one is sought.
    place : tuple of float or None
        x and y of the journal and least gap in clearances, for which all further films draw their lines.
    """

    attitude: float | None = None
    place: tuple[float, float, float] | None = None

    def hold(self, state: FilmState | None) -> None:
        """Draw lines for this film from now on, and let films settle closer.

        Errors of the grid, and films that still warm, would make the clearance wander for ever.
        """
        if state is not None:
            solution = state.solution
            x, y = solution.position / solution.film.clearance
            self.place = (float(x), float(y), solution.minimum_film_thickness / solution.film.clearance)

    @property
    def settled(self) -> float:
        """Change of temperature in a pass, K, at which a film has settled."""
        from babbitt.film.thermal import SETTLED

        return SETTLED if self.place is None else CLOSER
