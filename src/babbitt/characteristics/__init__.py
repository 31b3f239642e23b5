"""Dimensionless characteristics of circular bearings: load, attitude, flow, friction."""

from babbitt.characteristics.closed_forms import ClosedFormCurves
from babbitt.characteristics.curves import BearingCurves, CharacteristicCurves
from babbitt.characteristics.tables import SPANS_DEGREES, curves, sommerfeld_number, table

__all__ = [
    "BearingCurves",
    "CharacteristicCurves",
    "ClosedFormCurves",
    "SPANS_DEGREES",
    "curves",
    "sommerfeld_number",
    "table",
]
