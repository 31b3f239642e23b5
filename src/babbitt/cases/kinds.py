"""What a file can hold, by its `kind`; the model of a kind is imported when the first such file is read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from babbitt.cases.every_kind import Case

HOMES = {
    "journal": ("machine", "JournalCase"),
    "machine": ("machine", "Machine"),
    "overhung_coupling": ("overhung_coupling", "OverhungCouplingCase"),
    "screw_heel": ("screw_heel", "ScrewHeelCase"),
    "hydrostatic_pad": ("hydrostatic_pad", "HydrostaticPadCase"),
    "hydrostatic_thrust_ring": ("hydrostatic_thrust_ring", "HydrostaticThrustRingCase"),
    "hydrostatic_journal": ("hydrostatic_journal", "HydrostaticJournalCase"),
    "jacking_pocket": ("jacking", "JackingPocketCase"),
    "thrust": ("thrust", "ThrustCase"),
    "thrust_line": ("thrust_line", "ThrustLineCase"),
}
"""Module of `babbitt.cases` and class of every kind."""


class Kinds(Mapping[str, "type[Case]"]):
    """The model of every kind."""

    def __getitem__(self, kind: str) -> type[Case]:
        module, name = HOMES[kind]
        model: type[Case] = getattr(import_module(f"babbitt.cases.{module}"), name)
        return model

    def __iter__(self) -> Iterator[str]:
        return iter(HOMES)

    def __len__(self) -> int:
        return len(HOMES)


KINDS = Kinds()
