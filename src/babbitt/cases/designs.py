"""Every kind of design case in one type. To import this imports all of them."""

from __future__ import annotations

from babbitt.bearings.model import FilmCase
from babbitt.footstep.case import HeelCase
from babbitt.hydrostatics.jacking_model import JackingCase
from babbitt.hydrostatics.model import HydrostaticCase
from babbitt.longfilm.model import LongFilmCase
from babbitt.segments.model import SegmentCase
from babbitt.shaft_line.design import LineDesign
from babbitt.standards.iso7902.model import DesignCase
from babbitt.thrust.design import ThrustDesign

JournalDesign = DesignCase | FilmCase | LongFilmCase | SegmentCase
"""A journal bearing by one method: ISO 7902, the film, the long film, or the segments."""

AnyDesign = JournalDesign | HydrostaticCase | JackingCase | ThrustDesign | LineDesign
"""What a method computes and has one answer."""

EveryDesign = AnyDesign | HeelCase
"""The same, and the heel of a footstep, which may have several steady states."""
