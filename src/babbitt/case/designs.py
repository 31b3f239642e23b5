"""Every kind of design case in one type. To import this imports all of them."""

from __future__ import annotations

from babbitt.kinds.footstep.model_case import HeelCase
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.design import ThrustDesign

JournalDesign = DesignCase | FilmCase | LongFilmCase | SegmentCase
"""A journal bearing by one method: ISO 7902, the film, the long film, or the segments."""

AnyDesign = JournalDesign | HydrostaticCase | JackingCase | ThrustDesign | LineDesign
"""What a method computes and has one answer."""

EveryDesign = AnyDesign | HeelCase
"""The same, and the heel of a footstep, which may have several steady states."""
