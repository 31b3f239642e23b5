"""What is assumed of pads with their own temperatures."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.tilting_pad_journal.model import PadCase

__all__ = ["thermal_assumptions"]


def thermal_assumptions(case: PadCase) -> Iterator[str]:
    """Assumptions of the models of film, walls and shape, whatever numbers they are given."""
    heat = case.heat
    yield (
        "Temperatures and viscosities vary along and across the films and are mean values over the width. Films "
        "rupture where pressure and its gradient vanish (Reynolds); pads tilt without friction about their pivots "
        "alone; ambient or groove pressure on all edges of a pad."
    )
    yield (
        f"{case.feed.carry_over:.0%} of the oil that leaves a pad over its trailing edge, with its heat, enters "
        "the next one as far as that takes oil; it is mixed with fresh oil before the edge."
    )
    if heat.journal is None:
        yield "Journal and pads take no heat."
    elif heat.walls is None:
        yield "The journal has one temperature; the pads take no heat."
    else:
        yield "The journal has one temperature; pads conduct heat in the plane of the bearing, to backs and edges."
    if heat.bending is not None:
        yield "Pads bend as beams held at their pivots, under pressure and by the temperature across them."
    else:
        yield "Pads are rigid."
    if heat.growth is not None:
        yield (
            "Growth brings a pad nearer along its whole arc: machined and assembled clearance shrink together; "
            "that the bore of a warm pad opens is left out."
        )
    yield (
        "Where pads unload is told of films of one temperature each, with the viscosity of the pad at its mean "
        "temperature and the clearances as they run."
    )
