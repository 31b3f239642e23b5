"""The words of a calculation: the vocabulary of results, and what only occurs on the way to them."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping

from babbitt.core.kind import Kind, kinds
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.units import ZERO_CELSIUS
from babbitt.report.expression import Node
from babbitt.report.local_quantity import MICRO, MILLI, PER_MINUTE, PRINTED_UNITS, local
from babbitt.report.symbols import symbol_node

__all__ = ["PRINTED_UNITS", "VOCABULARY", "calculated", "symbol"]

COMMON = (
    local("radial_clearance", "c", "m", "Radial clearance", 4, MICRO),
    local("recess_depth", "H", "m", "Depth of the recess", 4, MILLI),
    local("heat_transfer_coefficient", "k_A", "W/(m² K)", "Heat transfer coefficient"),
    local("cooling_surface", "A", "m²", "Surface that gives off heat"),
    local("entering_flow", "Q_le", "m3/s", "Oil over all leading edges", 5, PER_MINUTE),
    local("trailing_flow", "Q_te", "m3/s", "Oil over all trailing edges", 5, PER_MINUTE),
    local("carried_share", "λ_c", "1", "Share that is carried over"),
    local("pad_warming", "ΔT", "K (abs)", "Rise of the oil along a pad", 5),
)
"""What the calculations of several kinds need on the way to their results."""


class Vocabulary(Mapping[str, Quantity]):
    """The vocabulary of results, what is common to calculations, and the words of every kind's own."""

    def __init__(self) -> None:
        self._read: dict[str, dict[str, Quantity]] = {"": {one.name: one for one in COMMON}}

    def _own(self) -> Iterator[dict[str, Quantity]]:
        """Words by kind; those of a kind are imported once."""
        for name, kind in kinds().items():
            if kind.vocabulary and name not in self._read:
                self._read[name] = _own_words(kind)
        yield from self._read.values()

    def __getitem__(self, name: str) -> Quantity:
        if name in QUANTITIES:
            return QUANTITIES[name]
        found = next((words[name] for words in self._own() if name in words), None)
        if found is None:
            raise KeyError(name)
        return found

    def __contains__(self, name: object) -> bool:
        return name in QUANTITIES or any(name in words for words in self._own())

    def __iter__(self) -> Iterator[str]:
        yield from dict.fromkeys((*QUANTITIES, *(name for words in self._own() for name in words)))

    def __len__(self) -> int:
        return len(list(iter(self)))


def _own_words(kind: Kind) -> dict[str, Quantity]:
    """Words of the calculation sheets of a kind; none, with a warning, where they cannot be imported."""
    try:
        return {one.name: one for one in kind.load(kind.vocabulary)}
    except InputError as error:
        warnings.warn(f"left out: {error.message}", stacklevel=2)
        return {}


VOCABULARY: Mapping[str, Quantity] = Vocabulary()
"""The vocabulary of results and what only occurs on the way to them."""


def calculated(quantity: Quantity, value: float) -> float:
    """A value in the units in which the lines calculate: SI, and temperatures in °C."""
    return value - ZERO_CELSIUS if quantity.unit == "K" else value


def symbol(name: str) -> Node:
    """The symbol of a quantity."""
    return symbol_node(VOCABULARY[name].symbol)
