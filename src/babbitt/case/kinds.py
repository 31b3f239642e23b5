"""What a file can hold, by its `kind`; the model of a kind is imported when the first such file is read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from babbitt.case.every_kind import Case

HOMES = {
    "journal": ("journal.case.machine", "JournalCase"),
    "machine": ("journal.case.machine", "Machine"),
    "overhung_coupling": ("coupling.case.overhung_coupling", "OverhungCouplingCase"),
    "screw_heel": ("footstep.case.footstep", "ScrewHeelCase"),
    "hydrostatic_pad": ("hydrostatic.case.hydrostatic_pad", "HydrostaticPadCase"),
    "hydrostatic_thrust_ring": ("hydrostatic.case.hydrostatic_thrust_ring", "HydrostaticThrustRingCase"),
    "hydrostatic_journal": ("hydrostatic.case.hydrostatic_journal", "HydrostaticJournalCase"),
    "jacking_pocket": ("hydrostatic.case.jacking", "JackingPocketCase"),
    "thrust": ("thrust.case.thrust", "ThrustCase"),
    "thrust_line": ("shaft_line.case.shaft_line", "ThrustLineCase"),
}
"""Module of `babbitt.kinds` and class of every kind."""


class Kinds(Mapping[str, "type[Case]"]):
    """The model of every kind."""

    def __getitem__(self, kind: str) -> type[Case]:
        module, name = HOMES[kind]
        model: type[Case] = getattr(import_module(f"babbitt.kinds.{module}"), name)
        return model

    def __iter__(self) -> Iterator[str]:
        return iter(HOMES)

    def __len__(self) -> int:
        return len(HOMES)


KINDS = Kinds()
