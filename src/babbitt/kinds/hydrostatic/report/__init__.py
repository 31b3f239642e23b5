"""What the report holds of hydrostatic bearings."""
