"""Every kind of case in one type. To import this imports all of them, so that most only name it in annotations."""

from __future__ import annotations

from typing import Annotated

from pydantic import Discriminator

from babbitt.cases.hydrostatic_journal import HydrostaticJournalCase
from babbitt.cases.hydrostatic_pad import HydrostaticPadCase
from babbitt.cases.hydrostatic_thrust_ring import HydrostaticThrustRingCase
from babbitt.cases.jacking import JackingPocketCase
from babbitt.cases.machine import JournalCase, Machine
from babbitt.cases.overhung_coupling import OverhungCouplingCase
from babbitt.cases.screw_heel import ScrewHeelCase
from babbitt.cases.thrust import ThrustCase
from babbitt.cases.thrust_line import ThrustLineCase

HydrostaticBearing = HydrostaticPadCase | HydrostaticThrustRingCase | HydrostaticJournalCase | JackingPocketCase
"""Bearings that oil under pressure carries."""

Case = (
    JournalCase | Machine | OverhungCouplingCase | ScrewHeelCase | HydrostaticBearing | ThrustCase | ThrustLineCase
)
"""What a file can hold."""

AnyCase = Annotated[Case, Discriminator("kind")]
"""The same, discriminated by `kind`."""
