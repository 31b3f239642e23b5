"""Names of the fields by which a case gives load and speed; of each group one is given."""

LOADS = ("load", "specific_load", "eccentricity_ratio", "position")
SPEEDS = ("speed", "surface_speed")
