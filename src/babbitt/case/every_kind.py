"""Every kind of case in one type. To import this imports all of them, so that most only name it in annotations."""

from __future__ import annotations

from typing import Annotated

from pydantic import Discriminator

from babbitt.kinds.coupling.case.overhung_coupling import OverhungCouplingCase
from babbitt.kinds.footstep.case.footstep import ScrewHeelCase
from babbitt.kinds.hydrostatic.case.hydrostatic_journal import HydrostaticJournalCase
from babbitt.kinds.hydrostatic.case.hydrostatic_pad import HydrostaticPadCase
from babbitt.kinds.hydrostatic.case.hydrostatic_thrust_ring import HydrostaticThrustRingCase
from babbitt.kinds.hydrostatic.case.jacking import JackingPocketCase
from babbitt.kinds.journal.case.machine import JournalCase, Machine
from babbitt.kinds.shaft_line.case.shaft_line import ThrustLineCase
from babbitt.kinds.thrust.case.thrust import ThrustCase

HydrostaticBearing = HydrostaticPadCase | HydrostaticThrustRingCase | HydrostaticJournalCase | JackingPocketCase
"""Bearings that oil under pressure carries."""

Case = (
    JournalCase | Machine | OverhungCouplingCase | ScrewHeelCase | HydrostaticBearing | ThrustCase | ThrustLineCase
)
"""What a file can hold."""

AnyCase = Annotated[Case, Discriminator("kind")]
"""The same, discriminated by `kind`."""
