"""Dimensionless characteristics of circular bearings: load, attitude, flow, friction."""

from babbitt.kinds.journal.iso7902.characteristics.closed_forms import ClosedFormCurves
from babbitt.kinds.journal.iso7902.characteristics.curves import BearingCurves, CharacteristicCurves
from babbitt.kinds.journal.iso7902.characteristics.tables import SPANS_DEGREES, curves, sommerfeld_number, table

__all__ = [
    "BearingCurves",
    "CharacteristicCurves",
    "ClosedFormCurves",
    "SPANS_DEGREES",
    "curves",
    "sommerfeld_number",
    "table",
]
