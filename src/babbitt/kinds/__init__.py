"""Bearing kinds, one folder each: case language, methods, views. A new kind is one folder and one line here."""

from babbitt.kinds import footstep, hydrostatic, journal, shaft, shaft_line, thrust, tilting_pad_journal

KINDS = (
    *journal.KINDS,
    *shaft.KINDS,
    *footstep.KINDS,
    *hydrostatic.KINDS,
    *thrust.KINDS,
    *shaft_line.KINDS,
    *tilting_pad_journal.KINDS,
)
"""The kinds that ship, in the order in which they are listed."""
