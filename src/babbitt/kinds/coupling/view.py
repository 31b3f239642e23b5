"""How the statics of a shaft are shown."""

from babbitt.kinds.coupling.methods import ShaftProblem
from babbitt.report.view import View

__all__ = ["STATICS"]


def _citations(_: ShaftProblem) -> tuple[str, ...]:
    return (STUDY,)


STUDY = (
    "Marine reverse gear: a study of its bearings, 2023, vol. 15, no. 5, p. 825 ff. of a Russian journal "
    "(`babbitt validate reverse_gear`). Author, title and journal could not be looked up: what rests on it alone "
    "counts as an assumption."
)

STATICS = View(
    title="Statics of the shaft",
    sweep=("reaction_1", "reaction_2", "reaction_angle_1", "reaction_angle_2", "coupling_arm"),
    citations=_citations,
)
