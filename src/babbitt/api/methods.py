"""Methods for journal bearings with their choices: the mapping `method` of a case file."""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.kinds.journal.case import methods

__all__ = ["Film", "Iso7902", "LongFilm", "Segments"]


class Film(OwnPart, methods.FilmMethod):
    """The film in two dimensions."""


class Iso7902(OwnPart, methods.Iso7902Method):
    """The procedure of ISO 7902."""


class LongFilm(OwnPart, methods.LongFilmMethod):
    """The long film with heat exchange."""


class Segments(OwnPart, methods.SegmentsMethod):
    """The heat balance by segments of a grooved long bearing."""
