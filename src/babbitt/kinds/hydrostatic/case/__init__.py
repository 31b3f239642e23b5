"""The case language of hydrostatic bearings."""
