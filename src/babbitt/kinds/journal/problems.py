"""The problems of a journal bearing, one for each method."""

from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import DesignCase

__all__ = ["JournalDesign"]

JournalDesign = DesignCase | FilmCase | LongFilmCase | SegmentCase
"""A journal bearing by one method: ISO 7902, the film, the infinitely long film, the film with a groove."""
