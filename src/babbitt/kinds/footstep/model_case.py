"""One heel of a case file, smooth or grooved, with what is to be said about it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from babbitt.core.notices import Notice
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.states import Method

__all__ = ["FootstepProblem"]

Range = tuple[float, float]


@dataclass(frozen=True)
class FootstepProblem:
    """What is computed for one variant of a footstep.

    Attributes
    ----------
    name : str
        Of the footstep.
    footstep : Footstep
        Of this variant: without groove for the smooth heel.
    method : Method
    other : Footstep or None
        The other variant where the case asks for both.
    gap_range, clearance_range : tuple of float
        Over which figures run, m.
    map_points : int
        Face gaps and clearances of the map of states; 0 for none.
    given : tuple of tuple of str
        How the case file put it, labels and words.
    warnings : tuple of Notice
    assumptions : tuple of str
    kind : str
    """

    name: str
    footstep: Footstep
    method: Method = Method.SUPERPOSITION
    other: Footstep | None = None
    gap_range: Range = (5e-6, 60e-6)
    clearance_range: Range = (10e-6, 40e-6)
    map_points: int = 0
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()
    kind: str = "screw_heel"

    @property
    def is_grooved(self) -> bool:
        """Whether this is the grooved variant."""
        return self.footstep.groove is not None

    @property
    def variant(self) -> str:
        """What sets it apart from the other problem of its case."""
        return "grooved heel" if self.is_grooved else "smooth heel"

    @property
    def smooth(self) -> Footstep:
        """The smooth variant of the same footstep."""
        return replace(self.footstep, groove=None)
