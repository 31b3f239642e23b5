"""Bearings of every kind as a program makes them: the models of the case language, one class each."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from babbitt.api.case import Case
from babbitt.api.machine_bearings import by_itself
from babbitt.api.other_packages import class_of
from babbitt.api.own_bore import Gap, with_own_bore, with_own_bore_in_words, without_own_bore
from babbitt.api.words import of_machine
from babbitt.case.case_file import CaseFile
from babbitt.core.kind import find_kind
from babbitt.core.solution import Calculation
from babbitt.kinds.footstep.case.footstep import FootstepCase
from babbitt.kinds.hydrostatic.case.hydrostatic_journal import HydrostaticJournalCase
from babbitt.kinds.hydrostatic.case.hydrostatic_pad import HydrostaticPadCase
from babbitt.kinds.hydrostatic.case.hydrostatic_thrust_ring import HydrostaticThrustRingCase
from babbitt.kinds.hydrostatic.case.jacking import JackingPocketCase
from babbitt.kinds.journal.case import files
from babbitt.kinds.shaft.case.overhung_coupling import OverhungCouplingCase
from babbitt.kinds.shaft.case.shaft import ShaftCase
from babbitt.kinds.shaft_line.case.shaft_line import ThrustLineCase
from babbitt.kinds.thrust.case.thrust import ThrustCase
from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase

__all__ = [
    "Footstep",
    "HydrostaticJournal",
    "HydrostaticPad",
    "JackingPocket",
    "JournalBearing",
    "Machine",
    "OverhungCoupling",
    "Shaft",
    "ThrustBearing",
    "ThrustLine",
    "ThrustRing",
    "TiltingPadBearing",
    "public_case",
]


class JournalBearing(Case, files.JournalCase):
    """A circular cylindrical journal bearing.

    `method` is a name of the case language or an object with options, such as ``Film(thermal="adiabatic")``;
    `bore` may be a `Gap`, a function of angle and place.

    Examples
    --------
    >>> bearing = JournalBearing(diameter="100 mm", width=0.05, clearance="H7/e8", span="360 deg")
    >>> bearing.missing
    ('load', 'speed', 'lubricant', 'supply', 'materials')
    >>> bearing.replace(load="10 kN").load
    10000.0
    """

    model: ClassVar[type[CaseFile]] = files.JournalCase
    default_name: ClassVar[str] = "Journal bearing"

    @classmethod
    def in_words(cls, given: Mapping[str, Any]) -> dict[str, Any]:
        """What was given, an own bore as a table."""
        return with_own_bore_in_words(given)

    def _in_order(self, changes: Mapping[str, Any]) -> Mapping[str, Any]:
        """An own bore comes last: it is sampled across the new width."""
        return dict(sorted(changes.items(), key=lambda change: isinstance(change[1], Gap)))

    def _given_with(self, given: dict[str, Any], path: str, value: Any) -> dict[str, Any]:
        if path == "bore":
            if isinstance(value, Gap):
                return with_own_bore(given, value)
            given = without_own_bore(given)
        return super()._given_with(given, path, value)


class Machine(Case, files.Machine):
    """Several journal bearings that share lubricant, supply, cooling and materials."""

    model: ClassVar[type[CaseFile]] = files.Machine
    default_name: ClassVar[str] = "Machine"

    def calculations(self) -> tuple[Calculation, ...]:
        """One problem for each bearing, operating point and clearance."""
        return self.in_language().calculations()

    @classmethod
    def in_words(cls, given: Mapping[str, Any]) -> dict[str, Any]:
        """What was given, each bearing with its kind and a name."""
        bearings = given.get("bearings")
        if not isinstance(bearings, list | tuple):
            return dict(given)
        return {**given, "bearings": [of_machine(one, number) for number, one in enumerate(bearings, 1)]}


def _bearings_by_themselves(machine: Machine) -> tuple[JournalBearing, ...]:
    """The bearings, each with what it shares with its machine, so that it can be solved by itself."""
    if "bearings" not in vars(machine):
        raise AttributeError("bearings")
    given = machine.given
    return tuple(JournalBearing.read(machine._origin_of(by_itself(one, given))) for one in given["bearings"])


if not TYPE_CHECKING:  # pydantic takes a property of the class for the default of its field
    Machine.bearings = property(_bearings_by_themselves)


class ThrustBearing(Case, ThrustCase):
    """A thrust bearing of tilting or fixed pads."""

    model: ClassVar[type[CaseFile]] = ThrustCase
    default_name: ClassVar[str] = "Thrust bearing"


class ThrustLine(Case, ThrustLineCase):
    """Axial vibration of a shaft line on its thrust bearing."""

    model: ClassVar[type[CaseFile]] = ThrustLineCase
    default_name: ClassVar[str] = "Shaft line"


class TiltingPadBearing(Case, TiltingPadJournalCase):
    """A journal bearing of tilting pads."""

    model: ClassVar[type[CaseFile]] = TiltingPadJournalCase
    default_name: ClassVar[str] = "Tilting-pad bearing"


class HydrostaticJournal(Case, HydrostaticJournalCase):
    """A recessed journal bearing, at rest or turning."""

    model: ClassVar[type[CaseFile]] = HydrostaticJournalCase
    default_name: ClassVar[str] = "Hydrostatic journal bearing"


class HydrostaticPad(Case, HydrostaticPadCase):
    """A hydrostatic pad with one recess."""

    model: ClassVar[type[CaseFile]] = HydrostaticPadCase
    default_name: ClassVar[str] = "Hydrostatic pad"


class ThrustRing(Case, HydrostaticThrustRingCase):
    """A hydrostatic thrust ring with several recesses."""

    model: ClassVar[type[CaseFile]] = HydrostaticThrustRingCase
    default_name: ClassVar[str] = "Hydrostatic thrust ring"


class JackingPocket(Case, JackingPocketCase):
    """Jacking pockets of a plain journal bearing at rest."""

    model: ClassVar[type[CaseFile]] = JackingPocketCase
    default_name: ClassVar[str] = "Jacking pocket"


class Footstep(Case, FootstepCase):
    """The footstep of a screw with a smooth or grooved heel."""

    model: ClassVar[type[CaseFile]] = FootstepCase
    default_name: ClassVar[str] = "Footstep"


class Shaft(Case, ShaftCase):
    """A shaft with gears, couplings and masses, and the loads, thrust and slopes of its bearings.

    Examples
    --------
    >>> disc = {"name": "Disc", "station": "300 mm", "mass": "100 kg"}
    >>> ends = [{"kind": "radial", "name": name, "station": at} for name, at in (("A", "0 mm"), ("B", "400 mm"))]
    >>> shaft = Shaft(name="Fan", speed="1500 rpm", masses=[disc], bearings=ends)
    >>> [round(load, 1) for load in shaft.solve().result.arrays["support_load"][0]]
    [245.2, 735.5]
    """

    model: ClassVar[type[CaseFile]] = ShaftCase
    default_name: ClassVar[str] = "Shaft"


class OverhungCoupling(Case, OverhungCouplingCase):
    """Load share of two bearings with an overhung coupling."""

    model: ClassVar[type[CaseFile]] = OverhungCouplingCase
    default_name: ClassVar[str] = "Overhung coupling"


PUBLIC: Mapping[type[CaseFile], type[Case]] = {
    one.model: one
    for one in (
        JournalBearing,
        Machine,
        ThrustBearing,
        ThrustLine,
        HydrostaticJournal,
        HydrostaticPad,
        ThrustRing,
        JackingPocket,
        Footstep,
        OverhungCoupling,
        Shaft,
        TiltingPadBearing,
    )
}
"""By its case model, the class of each kind that ships."""


def public_case(case: CaseFile) -> CaseFile:
    """The same case as an object of its class here; as it is where its kind is not registered."""
    public = PUBLIC.get(type(case))
    kind = find_kind(case.kind) if public is None else None
    if kind is not None and kind.load_model() is type(case):
        public = class_of(type(case), kind.name.replace("_", " ").capitalize())
    return case if public is None else public.of(case)
