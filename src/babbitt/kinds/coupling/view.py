"""How the statics of a shaft are shown."""

from babbitt.kinds.coupling.methods import ShaftProblem
from babbitt.report.citations import REVERSE_GEAR
from babbitt.report.view import View

__all__ = ["STATICS"]


def _citations(_: ShaftProblem) -> tuple[str, ...]:
    return (REVERSE_GEAR,)


STATICS = View(
    title="Statics of the shaft",
    sweep=("reaction_1", "reaction_2", "reaction_angle_1", "reaction_angle_2", "coupling_arm"),
    citations=_citations,
)
