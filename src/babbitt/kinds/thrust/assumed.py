"""What is assumed of the films of a thrust bearing, in sentences."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.thrust.design import Oil

__all__ = ["oil_assumptions"]


def oil_assumptions(oil: Oil) -> Iterator[str]:
    """What is assumed of the temperature of the films."""
    if oil.thermal is None:
        which = "all films" if oil.balance is None else "the film of each pad"
        yield (
            f"One viscosity for {which}, that at the effective temperature; rigid pads; frictionless pivots; "
            "oil at ambient pressure around each pad."
        )
    else:
        across = "and across the pads" if oil.resolved else "means over the width of the pads"
        yield (
            f"Films with their own temperatures along the pads and across the gap, {across}; no heat "
            "goes to "
            "pads and collar; rigid pads; frictionless pivots; oil at ambient pressure around each pad."
        )
        yield "Stiffness and damping at frozen temperatures."
    if oil.supply_temperature is not None:
        yield (
            f"{oil.carry_over:.0%} of the oil that leaves a pad over its trailing edge enters the next; "
            "all heat goes with the oil."
        )
