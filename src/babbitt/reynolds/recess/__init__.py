"""Films between the recesses of hydrostatic bearings."""
