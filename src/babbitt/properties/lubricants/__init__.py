"""Lubricants: viscosity laws, viscosity index, thermal properties and the catalogue.

Temperatures are in K, results in SI; every law takes a float or an array.
"""

from babbitt.properties.lubricants.catalogue import catalogue, lubricant
from babbitt.properties.lubricants.lubricant import Lubricant, PropertySources
from babbitt.properties.lubricants.own_oils import (
    OilProperties,
    lubricant_from_law,
    lubricant_from_points,
    lubricant_from_viscosity_index,
)
from babbitt.properties.lubricants.property_laws import (
    ConstantProperty,
    LinearProperty,
    PropertyLaw,
    ShiftedLaw,
)
from babbitt.properties.lubricants.tabulated_viscosity import TabulatedViscosity
from babbitt.properties.lubricants.viscosity_index import (
    nu40_from_viscosity_index,
    nu100_from_viscosity_index,
    viscosity_index,
)
from babbitt.properties.lubricants.viscosity_laws import (
    ConstantViscosity,
    Exponential,
    PowerLaw,
    ViscosityKind,
    ViscosityLaw,
    Vogel,
)
from babbitt.properties.lubricants.walther import AstmD341, Walther

__all__ = [
    "AstmD341",
    "ConstantProperty",
    "ConstantViscosity",
    "Exponential",
    "LinearProperty",
    "Lubricant",
    "OilProperties",
    "PowerLaw",
    "PropertyLaw",
    "PropertySources",
    "ShiftedLaw",
    "TabulatedViscosity",
    "ViscosityKind",
    "ViscosityLaw",
    "Vogel",
    "Walther",
    "catalogue",
    "lubricant",
    "lubricant_from_law",
    "lubricant_from_points",
    "lubricant_from_viscosity_index",
    "nu100_from_viscosity_index",
    "nu40_from_viscosity_index",
    "viscosity_index",
]
