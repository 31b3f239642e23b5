"""Bearing metals with their limits; shaft and housing materials."""

from babbitt.properties.materials.bearing_metal import AlloyFamily, BearingMetal, LoadCharacter, LoadLimits
from babbitt.properties.materials.catalogue import (
    bearing_metal,
    bearing_metals,
    structural_material,
    structural_materials,
)
from babbitt.properties.materials.experience import (
    empirical_minimum_film_thickness,
    highest_metal_temperature,
    metal_temperature_limit,
    pressure_fed_temperature_limit,
    published_metal_temperature,
    self_cooled_temperature_limit,
    specific_load_limit,
)
from babbitt.properties.materials.experience_tables import (
    ExperienceLimit,
    ExperienceLimits,
    FilmThicknessTable,
    experience_limits,
    parse_experience_limits,
)
from babbitt.properties.materials.sourced import SourcedText, SourcedValue
from babbitt.properties.materials.structural_material import StructuralMaterial

__all__ = [
    "AlloyFamily",
    "BearingMetal",
    "ExperienceLimit",
    "ExperienceLimits",
    "FilmThicknessTable",
    "LoadCharacter",
    "LoadLimits",
    "SourcedText",
    "SourcedValue",
    "StructuralMaterial",
    "bearing_metal",
    "bearing_metals",
    "empirical_minimum_film_thickness",
    "experience_limits",
    "highest_metal_temperature",
    "metal_temperature_limit",
    "published_metal_temperature",
    "pressure_fed_temperature_limit",
    "parse_experience_limits",
    "self_cooled_temperature_limit",
    "specific_load_limit",
    "structural_material",
    "structural_materials",
]
