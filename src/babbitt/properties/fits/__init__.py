"""Clearance from bore and journal: ISO 286 tolerance classes and explicit deviations."""

from babbitt.properties.fits.clearance import (
    LARGEST_RELATIVE_CLEARANCE,
    Clearance,
    RelativeClearance,
    require_hole,
    require_shaft,
)
from babbitt.properties.fits.iso286 import standard_tolerance, tolerance_limits
from babbitt.properties.fits.operating import REFERENCE_TEMPERATURE, operating_relative_clearance
from babbitt.properties.fits.sizes import Deviations, SizeLimits

__all__ = [
    "LARGEST_RELATIVE_CLEARANCE",
    "REFERENCE_TEMPERATURE",
    "Clearance",
    "Deviations",
    "RelativeClearance",
    "SizeLimits",
    "operating_relative_clearance",
    "require_hole",
    "require_shaft",
    "standard_tolerance",
    "tolerance_limits",
]
