"""What the report holds of thrust bearings."""
